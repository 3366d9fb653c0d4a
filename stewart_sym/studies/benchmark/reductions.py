"""The derivation's reduction passes as candidates of ``bench``: the kernel as each pass leaves it."""

import ctypes
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ...backend import kernel, native
from ...backend.c_kernel import address, pointers
from ...io.progress import Progress, silent
from ...robot.robot import Robot
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
    build = _Build(f"bench_pass_{number}", {**source.sources, **forces_loop()}, source.model_numbers)
    one_pose, batch = (
        Candidate(f"{source.name}, {kind}", source.meaning, kind, poses, make, lambda: source.operations[1])
        for kind, poses, make in (("one pose", FEW, build.one_pose), ("batch", MANY, build.batch))
    )
    return Stage(source, (one_pose, batch))


@dataclass(frozen=True)
class _Build:
    """Sources of one pass, and how their functions are called; the layout of the model differs by pass."""

    name: str
    sources: dict[str, str]
    model_numbers: int

    def one_pose(self, poses: Poses, flags: Flags) -> Runner:
        """``stewart_exact_forces`` called from a C loop."""
        return c_loop(self._library(flags), self._model(poses.robot, flags), poses)

    def batch(self, poses: Poses, flags: Flags) -> Runner:
        """``stewart_exact_forces_batch`` on one core, called from Python with given arrays."""
        F, status = np.zeros((len(poses), 6)), np.zeros(len(poses), dtype=np.int32)
        library, model = self._library(flags), self._model(poses.robot, flags)
        function = getattr(library, f"stewart_{NAME}_forces_batch")
        motions, count = pointers(poses.arrays), ctypes.c_size_t(len(poses))
        arguments = (address(model), count, motions, address(F), address(status))
        run = repeated(lambda: function(*arguments))
        return Runner(run, checked(F, status), (model, poses, status), library)

    def _model(self, robot: Robot, flags: Flags) -> NDArray[np.float64]:
        numbers, model = kernel.robot_numbers(robot), np.zeros(self.model_numbers)
        succeed(getattr(self._library(flags), f"stewart_{NAME}_prepare")(address(numbers), address(model)))
        return model

    def _library(self, flags: Flags) -> ctypes.CDLL:
        return native.load(self.name, self.sources, flags)
