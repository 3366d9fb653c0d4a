"""What a candidate of ``bench`` is, and those that are not ours: a reference, CasADi, the processor."""

import ctypes
import functools
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...backend import kernel, native
from ...backend.c_kernel import address
from ...dynamics.arrays import array_kernel
from ...dynamics.inverse import Formulation
from ...motion.motion import Motion
from ...reference import newton_euler
from ...robot.robot import Robot
from ..common import timing
from ..common.loops import loop_source, own_source

if TYPE_CHECKING:
    from .baselines_casadi import Program

Array = NDArray[np.float64]

NAME: Formulation = "exact"
"""The kernel that is measured."""

FEW, SLOW, MANY = 64, 1_000, 10_000
"""Poses of a loop over one-pose calls (their numbers stay in the first cache), of NumPy's, of a C batch."""

LARGE = 200_000
"""Poses of the batches that cores are compared on: enough that waking the threads doesn't count."""

AGREEMENT = 1e-10
"""Largest difference of forces between candidates in double precision, share of a pose's largest."""


@dataclass(frozen=True, eq=False)
class Poses:
    """Motions of one robot: ``arrays`` in the order of ``struct stewart_motions``, (n, ...), contiguous."""

    robot: Robot
    arrays: tuple[Array, ...]

    def __len__(self) -> int:
        """Return the number of poses."""
        return len(self.arrays[0])

    def resized(self, count: int) -> "Poses":
        """Return the first ``count`` without a copy, or all of them over and over."""
        if count <= len(self):
            return Poses(self.robot, tuple(array[:count] for array in self.arrays))
        return Poses(self.robot, tuple(np.resize(array, (count, *array.shape[1:])) for array in self.arrays))

    @functools.cached_property
    def motion(self) -> Motion:
        """The same as a Motion."""
        return Motion(*self.arrays)

    @functools.cached_property
    def rows(self) -> Array:
        """Each pose as one ``struct stewart_motion``, (n, 30)."""
        return np.concatenate([array.reshape(len(self), -1) for array in self.arrays], axis=1)


@dataclass(frozen=True, eq=False)
class Runner:
    """A candidate ready to run: ``run(n)`` computes all of its poses n times; ``F()`` tells what it found.

    ``kept`` holds on to arrays of which C code has the addresses only.
    """

    run: Callable[[int], object]
    F: Callable[[], Array]
    kept: object = None


@dataclass(frozen=True)
class Candidate:
    """One way to compute the forces.

    kind: "one pose" (a C loop calls a function for one pose), "batch" (one call for ``poses`` of them) or
    "call" (one call from Python for one pose). operations: of a pose, where they are counted. sweep: measured
    over batch sizes too. tolerance: as AGREEMENT. package: an optional one that it needs, as it is imported.
    """

    name: str
    what: str
    kind: str
    poses: int
    make: Callable[[Poses], Runner]
    operations: Callable[[], int] | None = None
    sweep: bool = False
    tolerance: float = AGREEMENT
    package: str | None = None


def repeated(call: Callable[[], object], F: Callable[[], Array], kept: object = None) -> Runner:
    """Return a runner of one call for all poses."""
    return Runner(timing.repeated(call), F, kept)


def c_loop(library: ctypes.CDLL, machine: NDArray[Any], poses: Poses) -> Runner:
    """Return a runner of a library's ``drive``, a C loop that calls a one-pose function over all poses.

    Its arguments: the machine's numbers, count of poses, repeats, motions (count, 30) and F (count, 6); it
    returns a status.
    """
    rows, F = poses.rows, np.zeros((len(poses), 6))
    numbers, count, motions, out = address(machine), ctypes.c_size_t(len(poses)), address(rows), address(F)

    def run(repeats: int) -> None:
        succeed(library.drive(numbers, count, ctypes.c_size_t(repeats), motions, out))

    return Runner(run, lambda: F, (machine, rows))


def forces_loop() -> dict[str, str]:
    """The same for the kernel of the forces alone; ``machine`` is its prepared model."""
    return loop_source(f"stewart_{NAME}_forces.h", f"return stewart_{NAME}_forces(machine, motion, F);")


def succeed(status: int) -> None:
    """Raise ValueError for a status other than 0."""
    if status:
        raise ValueError(f"a baseline failed with status {status}")


# --- the reference and CasADi -----------------------------------------------------------------


def _reference(poses: Poses) -> Runner:
    robot, motion = poses.robot, poses.motion
    return repeated(
        lambda: newton_euler.inverse_dynamics(robot, motion),
        lambda: newton_euler.inverse_dynamics(robot, motion).F,
    )


def _casadi(name: str, what: str, equations: str) -> Candidate:
    """One of the legs' equations that ``baselines_casadi`` writes out; CasADi is imported when it runs."""

    @functools.cache
    def program() -> "Program":
        from . import baselines_casadi

        return baselines_casadi.program(getattr(baselines_casadi, equations))

    def make(poses: Poses) -> Runner:
        library = native.load("bench_casadi", program().sources)
        return c_loop(library, kernel.robot_numbers(poses.robot), poses)

    return Candidate(
        name,
        what,
        "one pose",
        FEW,
        make,
        operations=lambda: program().operations,
        package="casadi",
    )


CASADI = _casadi("CasADi", "C, base frame", "base_frame")
"""What every other figure is divided by, where CasADi is installed."""


def _jax(poses: Poses) -> Runner:
    """The kernel on arrays, one pose of it, mapped over all of them and compiled; in double."""
    import jax
    import jax.numpy as jnp

    jax.config.update("jax_enable_x64", True)  # type: ignore[no-untyped-call]
    kernel = array_kernel(poses.robot, jnp, formulation=NAME)
    given = tuple(jnp.asarray(array) for array in poses.arrays)
    mapped = jax.jit(jax.vmap(lambda pose: kernel.forces(*pose).F))
    compiled = mapped.lower(given).compile(compiler_options=_UNFUSED)
    return repeated(lambda: compiled(given).block_until_ready(), lambda: np.asarray(compiled(given)))


_UNFUSED: dict[str, str | bool] = {
    "xla_disable_hlo_passes": "fusion,cpu-instruction-fusion,instruction-fusion,cpu_instruction_fusion"
}
"""Fused, XLA computes shared terms again for each use: seven times as long to compile, twice to run."""

JAX = Candidate("JAX, jit and vmap", "XLA, F alone", "batch", 100_000, _jax, package="jax")
"""The same kernel by JAX on this processor; apart from the others, as it is slow to compile."""

PEERS = (
    CASADI,
    _casadi("CasADi, closed form", "C, leg frame", "leg_frame"),
    Candidate("vector reference", "NumPy, base frame", "batch", SLOW, _reference),
)


# --- the processor ----------------------------------------------------------------------------


@dataclass(frozen=True)
class MultiplyAdd:
    """Independent fused multiply-adds at full width on one core; ``run(n)`` does ``count`` n times."""

    run: Callable[[int], object]
    count: int
    lanes: int


def multiply_add() -> MultiplyAdd:
    """Compile the loop; without the instruction it is a product and a sum. Raises CompilerError."""
    sources = {"multiply_add.c": own_source("multiply_add.c")}
    library = native.load("bench_multiply_add", sources, flags=("-ffp-contract=fast",))
    library.multiply_add.restype = ctypes.c_double
    steps, lanes = 1_000, int(library.multiply_add_lanes())
    by, plus = ctypes.c_double(0.999), ctypes.c_double(1e-3)

    def run(repeats: int) -> None:
        library.multiply_add(ctypes.c_size_t(repeats * steps), by, plus)

    return MultiplyAdd(run, steps * lanes * int(library.multiply_add_chains()), lanes)
