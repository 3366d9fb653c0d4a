"""Candidates of ``benchmark``, and the baselines: the reference, CasADi, JAX, and the reduction passes."""

import ctypes
import functools
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...backend import kernel, native
from ...backend.c_kernel import address, pointers
from ...dynamics.arrays import ArrayKernel
from ...io.array_types import Array, Codes
from ...io.progress import Progress, silent
from ...reference import newton_euler
from ..common.loops import loop_source
from ..common.output import Figures
from ..common.timing import over, repeated
from .figures import CLOSED, NAME, PLAIN, Raw, Timed, figure
from .poses import Poses
from .processor import Flags

if TYPE_CHECKING:
    from ...derive.passes import Pass
    from .baselines_casadi import Program


FEW, SLOW, MANY = 64, 1_000, 10_000
"""Number of poses of a loop of one-pose calls (within the first cache), of a NumPy batch, and of a C
batch.
"""

LARGE = 200_000
"""Number of poses of the batches that compare cores, so that the start of the threads is negligible."""

AGREEMENT = 1e-10
"""Largest relative difference of forces between double-precision candidates, relative to the largest force of
a pose.
"""


@dataclass(frozen=True, eq=False)
class Runner:
    """Candidate ready to run: ``run(n)`` computes all of its poses n times, and ``F()`` returns the forces.

    ``library`` contains the code of a candidate in C.
    """

    run: Callable[[int], object]
    F: Callable[[], Array]
    library: ctypes.CDLL | None = None


@dataclass(frozen=True)
class Candidate:
    """Method to compute the forces.

    Attributes
    ----------
    kind : str
        "one pose" (a C loop calls a function for one pose), "batch" (one call for ``poses`` poses), or "call"
        (one call from Python for one pose).
    operations : callable or None
        Function that returns the operations per pose, if they are counted.
    sweep : bool
        True also measures a range of batch sizes.
    tolerance : float
        Largest relative difference, as for AGREEMENT.
    package : str or None
        Import name of the required optional package.
    function : str or None
        Called C function, if the code is also compiled for other instructions.
    flags : tuple of str
        Compiler flags after the common ones.
    """

    name: str
    what: str
    kind: str
    poses: int
    make: Callable[[Poses, Flags], Runner]
    operations: Callable[[], int] | None = None
    sweep: bool = False
    tolerance: float = AGREEMENT
    package: str | None = None
    function: str | None = None
    flags: Flags = ()

    @property
    def label(self) -> str:
        """Unique name with the compiler flags."""
        return ", ".join((self.name, *self.flags))

    def runner(self, poses: Poses) -> Runner:
        """Build the candidate for these poses."""
        return self.make(poses, self.flags)


@dataclass(frozen=True, eq=False)
class Called:
    """Baseline that Python calls pose by pose; ``found()`` returns its forces or accelerations, shape (n, 6).

    The time per pose is the sum of its parts minus the last part, which is an empty call.

    Attributes
    ----------
    tolerance : float
        Largest relative difference, as for AGREEMENT.
    opened : float or None
        Gap of the kinematic loops (m); None for rigid constraints.
    """

    name: str
    what: str
    parts: tuple[Timed, ...]
    found: Callable[[], Array]
    tolerance: float = AGREEMENT
    opened: float | None = None

    def figures(self, raw: Raw) -> tuple[Figures, list[Figures]]:
        """Return the time per pose, computed from the parts in each round, and the parts."""
        times = [sum(added) - none for *added, none in zip(*(raw[part] for part in self.parts), strict=True)]
        parts = [part.figure(raw) for part in self.parts]
        return figure(self.name, self.what, "call", 1, times), parts


def difference(name: str, found: Array, parts: Sequence[Array], tolerance: float, of: str) -> float:
    """Return the largest difference from the parts, shape (n, ...) each, relative to the largest value of a
    pose.

    Raises ValueError if the difference is too large; ``of`` names the compared quantity.
    """
    ends = np.cumsum([part[0].size for part in parts])
    worst = 0.0
    for numbers, part in zip(np.split(found, ends[:-1], axis=-1), parts, strict=True):
        truth = part.reshape(len(part), -1)
        error, largest = np.abs(numbers - truth).max(axis=-1), np.abs(truth).max(axis=-1)
        worst = max(worst, float(np.max(error / np.where(largest > 0, largest, 1.0))))
    if not worst <= tolerance:
        raise ValueError(f"{name}: {of} differ from the reference's by {worst:.1e}, expected {tolerance:g}")
    return worst


def c_loop(
    library: ctypes.CDLL, machine: NDArray[Any], poses: Poses, numbers: int = 6, F: Any = None, of: str = ""
) -> Runner:
    """Return a runner of ``drive`` in a library, a C loop that calls a one-pose function for all poses.

    ``numbers`` is the number of results of each pose, ``F`` are input forces, shape (count, 6), and ``of`` is
    the suffix of the function name.
    """
    rows, found = poses.rows, np.zeros((len(poses), numbers))
    drive, counts = getattr(library, f"drive{of}"), (ctypes.c_size_t(len(poses)), ctypes.c_size_t(numbers))

    def run(repeats: int) -> None:
        arrays = map(address, (rows, F, found))
        succeed(drive(address(machine), *counts, ctypes.c_size_t(repeats), *arrays))

    return Runner(run, lambda: found, library)


def c_batch(function: Any, machine: NDArray[Any], poses: Poses, out: Any, before: Any = ()) -> Runner:
    """Return a runner of a C function for all poses in one call.

    ``out`` is the result array, shape (count, ...), or the arrays of a result struct. ``before`` are arrays
    that precede it.
    """
    status, count = np.zeros(len(poses), dtype=np.int32), ctypes.c_size_t(len(poses))

    def call() -> None:
        given = (address(machine), count, pointers(poses.arrays), *map(address, before))
        to = address(out) if isinstance(out, np.ndarray) else pointers(out)
        succeed(function(*given, to, address(status)))

    return Runner(repeated(call), lambda: out if isinstance(out, np.ndarray) else np.hstack(out))


def forces_loop() -> dict[str, str]:
    """Generate the loop for the kernel of the forces; ``machine`` is its prepared model."""
    return loop_source(f"stewart_{NAME}_forces.h", f"return stewart_{NAME}_forces(machine, motion, F);")


def checked(F: Array, status: Codes) -> Callable[[], Array]:
    """Return a function that returns the forces of C code if all statuses are 0."""

    def found() -> Array:
        succeed(int(status.max()))
        return F

    return found


def succeed(status: int) -> None:
    """Raise ValueError for a status other than 0."""
    if status:
        raise ValueError(f"a baseline failed with status {status}")


# --- the reference and CasADi -----------------------------------------------------------------


def _reference(poses: Poses, _: Flags) -> Runner:
    robot, motion = poses.robot, poses.motion
    run = repeated(lambda: newton_euler.inverse_dynamics(robot, motion))
    return Runner(run, lambda: newton_euler.inverse_dynamics(robot, motion).F)


def _casadi(name: str, what: str, equations: str) -> Candidate:
    """Return a candidate for leg equations of ``baselines_casadi``; CasADi is imported at the first run."""

    @functools.cache
    def program() -> "Program":
        from . import baselines_casadi

        return baselines_casadi.program(getattr(baselines_casadi, equations))

    def make(poses: Poses, flags: Flags) -> Runner:
        library = native.load("bench_casadi", program().sources, flags)
        return c_loop(library, kernel.robot_numbers(poses.robot), poses)

    counted: Any = {"operations": lambda: program().operations}
    return Candidate(name, what, "one pose", FEW, make, **counted, package="casadi", function="drive")


CASADI = _casadi(PLAIN, "C, base frame", "base_frame")
CASADI_CLOSED = _casadi(CLOSED, "C, leg frame", "leg_frame")
"""Reference candidates: if CasADi is installed, other times are divided by the faster build of each."""

PEERS = (CASADI_CLOSED, CASADI, Candidate("vector reference", "NumPy, base frame", "batch", SLOW, _reference))

# --- JAX --------------------------------------------------------------------------------------

_UNFUSED: dict[str, str | bool] = {
    "xla_disable_hlo_passes": "fusion,cpu-instruction-fusion,instruction-fusion,cpu_instruction_fusion"
}
"""Compiler options of a batch: with fusion, XLA computes shared terms once for each use, which takes twice as
long.

A single pose takes half the time with fusion and is compiled with it.
"""


def _jax_forces(poses: Poses) -> Callable[[Any], Any]:
    """Return the array kernel for one pose in double precision."""
    import jax
    import jax.numpy as jnp

    jax.config.update("jax_enable_x64", True)  # type: ignore[no-untyped-call]
    prepared = ArrayKernel(poses.robot, jnp, formulation=NAME)
    return lambda pose: prepared.forces(*pose).F


def _jax_batch(poses: Poses, _: Flags) -> Runner:
    """Build the kernel mapped over all poses and compiled."""
    import jax
    import jax.numpy as jnp

    forces = _jax_forces(poses)
    given = tuple(jnp.asarray(array) for array in poses.arrays)
    compiled = jax.jit(jax.vmap(forces)).lower(given).compile(compiler_options=_UNFUSED)
    run = repeated(lambda: compiled(given).block_until_ready())
    return Runner(run, lambda: np.asarray(compiled(given)))


JAX = Candidate("JAX, jit and vmap", "XLA, F alone", "batch", 100_000, _jax_batch, package="jax")
"""The same kernel in JAX on this processor, separate from the others because of its long compilation."""


def jax_one_pose(poses: Poses) -> Called:
    """Measure the kernel compiled for one pose, minus the call of a function that returns zeros."""
    import jax
    import jax.numpy as jnp

    forces = _jax_forces(poses)
    given = [tuple(jnp.asarray(array[i]) for array in poses.arrays) for i in range(len(poses))]
    compiled, nothing = (
        jax.jit(function).lower(given[0]).compile() for function in (forces, lambda pose: jnp.zeros(6))
    )

    def loop(function: Any) -> Callable[[int], None]:
        return over(lambda pose: function(pose).block_until_ready(), [(pose,) for pose in given])

    parts = (
        Timed(loop(compiled), len(given), "kernel", "the compiled kernel"),
        Timed(loop(nothing), len(given), "empty call", "a compiled function that returns zeros"),
    )
    found = np.array([compiled(pose) for pose in given])
    return Called("JAX, jit", "XLA, F alone - call", parts, lambda: found)


# --- the derivation's reduction passes --------------------------------------------------------


@dataclass(frozen=True)
class Stage:
    """Kernel after one pass, for one pose and for a batch."""

    source: "Pass"
    candidates: tuple[Candidate, Candidate]


def stages(progress: Progress = silent) -> tuple[Stage, ...]:
    """Derive the kernel after every pass, in the order of the passes."""
    from ...derive.passes import passes

    progress("deriving the passes")
    return tuple(_stage(number, each) for number, each in enumerate(passes(), 1))


def _stage(number: int, source: "Pass") -> Stage:
    """Build the candidates of a pass, which has its own layout of the prepared model."""
    sources = {**source.sources, **forces_loop()}

    def built(poses: Poses, flags: Flags) -> tuple[ctypes.CDLL, NDArray[np.float64]]:
        library = native.load(f"bench_pass_{number}", sources, flags)
        numbers, model = kernel.robot_numbers(poses.robot), np.zeros(source.model_numbers)
        succeed(getattr(library, f"stewart_{NAME}_prepare")(address(numbers), address(model)))
        return library, model

    def one_pose(poses: Poses, flags: Flags) -> Runner:
        """Build ``stewart_exact_forces`` called from a C loop."""
        return c_loop(*built(poses, flags), poses)

    def batch(poses: Poses, flags: Flags) -> Runner:
        """Build ``stewart_exact_forces_batch`` on one core, called from Python with given arrays."""
        library, model = built(poses, flags)
        function = getattr(library, f"stewart_{NAME}_forces_batch")
        return c_batch(function, model, poses, np.zeros((len(poses), 6)))

    alone, many = (
        Candidate(f"{source.name}, {kind}", source.meaning, kind, poses, make, lambda: source.operations[1])
        for kind, poses, make in (("one pose", FEW, one_pose), ("batch", MANY, batch))
    )
    return Stage(source, (alone, many))
