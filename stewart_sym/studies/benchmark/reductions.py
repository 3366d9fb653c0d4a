"""The derivation's reduction passes as candidates of ``bench``: the kernel as each pass leaves it."""

import ctypes
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ...backend import kernel, native
from ...backend.c_kernel import address, pointers
from ...io.progress import Progress, silent
from ..common.timing import repeated
from .baselines import FEW, MANY, Candidate, Runner, c_loop, checked, forces_loop, succeed
from .figures import NAME
from .poses import Poses
from .processor import Flags

if TYPE_CHECKING:
    from ...derive.passes import Pass


@dataclass(frozen=True)
class Stage:
    """The kernel after one pass, alone and in a batch."""

    source: "Pass"
    candidates: tuple[Candidate, Candidate]


def stages(progress: Progress = silent) -> tuple[Stage, ...]:
    """Derive the kernel after every pass, in their order."""
    from ...derive.passes import passes

    progress("deriving the passes")
    return tuple(_stage(number, each) for number, each in enumerate(passes(), 1))


def _stage(number: int, source: "Pass") -> Stage:
    """The layout of the prepared model differs from pass to pass."""
    sources = {**source.sources, **forces_loop()}

    def built(poses: Poses, flags: Flags) -> tuple[ctypes.CDLL, NDArray[np.float64]]:
        """The library, and the model of the poses' robot."""
        library = native.load(f"bench_pass_{number}", sources, flags)
        numbers, model = kernel.robot_numbers(poses.robot), np.zeros(source.model_numbers)
        succeed(getattr(library, f"stewart_{NAME}_prepare")(address(numbers), address(model)))
        return library, model

    def one_pose(poses: Poses, flags: Flags) -> Runner:
        """``stewart_exact_forces`` called from a C loop."""
        return c_loop(*built(poses, flags), poses)

    def batch(poses: Poses, flags: Flags) -> Runner:
        """``stewart_exact_forces_batch`` on one core, called from Python with given arrays."""
        library, model = built(poses, flags)
        F, status = np.zeros((len(poses), 6)), np.zeros(len(poses), dtype=np.int32)
        function, count = getattr(library, f"stewart_{NAME}_forces_batch"), ctypes.c_size_t(len(poses))
        run = repeated(
            lambda: function(address(model), count, pointers(poses.arrays), address(F), address(status))
        )
        return Runner(run, checked(F, status), library)

    alone, many = (
        Candidate(f"{source.name}, {kind}", source.meaning, kind, poses, make, lambda: source.operations[1])
        for kind, poses, make in (("one pose", FEW, one_pose), ("batch", MANY, batch))
    )
    return Stage(source, (alone, many))
