"""What a candidate of ``benchmark`` is, and those that are not ours: a reference, CasADi, JAX, passes."""

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
"""Poses of a loop over one-pose calls (their numbers stay in the first cache), of NumPy's, of a C batch."""

LARGE = 200_000
"""Poses of the batches that cores are compared on: enough that waking the threads doesn't count."""

AGREEMENT = 1e-10
"""Largest difference of forces between candidates in double precision, share of a pose's largest."""


@dataclass(frozen=True, eq=False)
class Runner:
    """A candidate ready to run: ``run(n)`` computes all of its poses n times; ``F()`` tells what it found.

    library: where the code is, if in C.
    """

    run: Callable[[int], object]
    F: Callable[[], Array]
    library: ctypes.CDLL | None = None


@dataclass(frozen=True)
class Candidate:
    """One way to compute the forces.

    kind: "one pose" (a C loop calls a function for one pose), "batch" (one call for ``poses`` of them) or
    "call" (one call from Python for one pose). operations: of a pose, where they are counted. sweep: measured
    over batch sizes too. tolerance: as AGREEMENT. package: an optional one that it needs, as it is imported.
    function: what is called of its C, for code that is compiled for other instructions too; flags: of the
    compiler, after those of every library.
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
        """The name, with the flags: no other candidate has it."""
        return ", ".join((self.name, *self.flags))

    def runner(self, poses: Poses) -> Runner:
        """Build it for these poses."""
        return self.make(poses, self.flags)


@dataclass(frozen=True, eq=False)
class Called:
    """A baseline that Python calls pose by pose: ``found()`` are its forces, or accelerations, (n, 6).

    Its time per pose is the sum of its parts less the last of them, a call over nothing. tolerance: as
    AGREEMENT. opened: by how much its loops are open, m; None where constraints are rigid.
    """

    name: str
    what: str
    parts: tuple[Timed, ...]
    found: Callable[[], Array]
    tolerance: float = AGREEMENT
    opened: float | None = None

    def figures(self, raw: Raw) -> tuple[Figures, list[Figures]]:
        """Time per pose, made of the parts round by round, and the parts."""
        times = [sum(added) - none for *added, none in zip(*(raw[part] for part in self.parts), strict=True)]
        parts = [part.figure(raw) for part in self.parts]
        return figure(self.name, self.what, "call", 1, times), parts


def difference(name: str, found: Array, parts: Sequence[Array], tolerance: float, of: str) -> float:
    """Largest difference from the parts, (n, ...) each, as a share of a pose's largest.

    Raises ValueError, which says of what, if it is too large.
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
    """Return a runner of a library's ``drive``, a C loop that calls a one-pose function over all poses.

    numbers: how many come out of each. F: forces, (count, 6), that it is given. of: ending of its name.
    """
    rows, found = poses.rows, np.zeros((len(poses), numbers))
    drive, counts = getattr(library, f"drive{of}"), (ctypes.c_size_t(len(poses)), ctypes.c_size_t(numbers))

    def run(repeats: int) -> None:
        arrays = map(address, (rows, F, found))
        succeed(drive(address(machine), *counts, ctypes.c_size_t(repeats), *arrays))

    return Runner(run, lambda: found, library)


def c_batch(function: Any, machine: NDArray[Any], poses: Poses, out: Any, before: Any = ()) -> Runner:
    """Return a runner of a C function for all poses in one call.

    out: the array that it fills, (count, ...), or those of a struct. before: arrays that it takes first.
    """
    status, count = np.zeros(len(poses), dtype=np.int32), ctypes.c_size_t(len(poses))

    def call() -> None:
        given = (address(machine), count, pointers(poses.arrays), *map(address, before))
        to = address(out) if isinstance(out, np.ndarray) else pointers(out)
        succeed(function(*given, to, address(status)))

    return Runner(repeated(call), lambda: out if isinstance(out, np.ndarray) else np.hstack(out))


def forces_loop() -> dict[str, str]:
    """The same for the kernel of the forces alone; ``machine`` is its prepared model."""
    return loop_source(f"stewart_{NAME}_forces.h", f"return stewart_{NAME}_forces(machine, motion, F);")


def checked(F: Array, status: Codes) -> Callable[[], Array]:
    """What tells forces that C code writes, once their statuses are all 0."""

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
    """One of the legs' equations that ``baselines_casadi`` writes out; CasADi is imported when it runs."""

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
"""Where CasADi is installed, other times are divided by these, each by the faster of its builds."""

PEERS = (CASADI_CLOSED, CASADI, Candidate("vector reference", "NumPy, base frame", "batch", SLOW, _reference))

# --- JAX --------------------------------------------------------------------------------------

_UNFUSED: dict[str, str | bool] = {
    "xla_disable_hlo_passes": "fusion,cpu-instruction-fusion,instruction-fusion,cpu_instruction_fusion"
}
"""Options for a batch. With fusion XLA computes shared terms once for each use, twice as slowly.

One pose alone takes half the time with fusion, and is compiled with it.
"""


def _jax_forces(poses: Poses) -> Callable[[Any], Any]:
    """The kernel on arrays, one pose of it, in double."""
    import jax
    import jax.numpy as jnp

    jax.config.update("jax_enable_x64", True)  # type: ignore[no-untyped-call]
    prepared = ArrayKernel(poses.robot, jnp, formulation=NAME)
    return lambda pose: prepared.forces(*pose).F


def _jax_batch(poses: Poses, _: Flags) -> Runner:
    """The kernel mapped over all poses and compiled."""
    import jax
    import jax.numpy as jnp

    forces = _jax_forces(poses)
    given = tuple(jnp.asarray(array) for array in poses.arrays)
    compiled = jax.jit(jax.vmap(forces)).lower(given).compile(compiler_options=_UNFUSED)
    run = repeated(lambda: compiled(given).block_until_ready())
    return Runner(run, lambda: np.asarray(compiled(given)))


JAX = Candidate("JAX, jit and vmap", "XLA, F alone", "batch", 100_000, _jax_batch, package="jax")
"""The same kernel by JAX on this processor; apart from the others, as it is slow to compile."""


def jax_one_pose(poses: Poses) -> Called:
    """The kernel compiled for one pose, called for each, less a call of a function that returns zeros."""
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
        function = getattr(library, f"stewart_{NAME}_forces_batch")
        return c_batch(function, model, poses, np.zeros((len(poses), 6)))

    alone, many = (
        Candidate(f"{source.name}, {kind}", source.meaning, kind, poses, make, lambda: source.operations[1])
        for kind, poses, make in (("one pose", FEW, one_pose), ("batch", MANY, batch))
    )
    return Stage(source, (alone, many))
