"""The tree of ``tree`` with its platform free: states for inverse dynamics, and the loops closed after it.

Joint angles, rates, accelerations, friction and the Jacobians of the closed loops are prepared beforehand
and not timed. Shares no dynamics with the other candidates.
"""

from collections.abc import Callable
from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np

from ....backend.numpy_kernel import loaded
from ....io.array_types import Array
from ....motion.motion import Motion
from ....motion.rotation import cross_matrix
from ....robot.robot import Robot
from ..baselines import Called, Part
from .tree import Legs, legs_of, turned

_SOLVED = 1024
"""Systems in one call of the solve, so that the call itself costs nothing a system."""


@dataclass(frozen=True, eq=False)
class States:
    """Poses (n,): motion, its load never None, legs, and accelerations of the legs' joints, (n, 6, 3).

    lower, upper, platform: friction's moments on the bodies, N m, base frame, (n, 6, 3) and (n, 3).
    """

    motion: SimpleNamespace
    legs: Legs
    accelerations: Array
    lower: Array
    upper: Array
    platform: Array


def states(robot: Robot, motion: Motion) -> States:
    """The states at poses (n,); base joints must be universal."""
    legs, given = legs_of(robot, motion), loaded(motion)
    omega, alpha = motion.omega[:, None], given.alpha[:, None]
    Sddot = given.a[:, None] + np.cross(alpha, legs.q) + np.cross(omega, np.cross(omega, legs.q))
    drift, _ = legs.accelerations(np.zeros_like(legs.S))
    accelerations = np.linalg.solve(legs.jacobian, (Sddot - drift)[..., None])[..., 0]
    f = robot.C_s[:, None] * (legs.W - omega)
    return States(given, legs, accelerations, -robot.C_u[:, None] * legs.W, -f, f.sum(axis=1))


def newton_euler(
    name: str,
    call: str,
    robot: Robot,
    states: States,
    tau: Array,
    rates: Array,
    run: Callable[[int], object],
    empty: Callable[[int], object],
) -> Called:
    """A baseline made of a call of an engine's inverse dynamics and a solve.

    tau: generalised forces that the engine found, (n, 24), those of the legs first; rates: of the platform's
    joint by its twist [v; omega], (n, 6, 6); run, empty: the engine's call over all poses, and over nothing.
    """
    legs = states.legs
    # F Ldot equals the power of all joints; both Ldot and the joints' rates are linear in the twist.
    arms = np.concatenate([np.broadcast_to(np.eye(3), (*legs.q.shape, 3)), -cross_matrix(legs.q)], axis=-1)
    joints = np.linalg.inv(legs.jacobian) @ arms
    every = np.concatenate([joints.reshape(len(tau), -1, 6), rates], axis=1)
    several = np.resize(np.arange(len(tau)), _SOLVED)
    matrices = np.swapaxes(joints[:, :, 2], -1, -2)[several]
    right = np.einsum("nji,nj->ni", every, tau)[several, :, None]

    def solve(repeats: int) -> None:
        for _ in range(repeats):
            np.linalg.solve(matrices, right)

    def F() -> Array:
        found = np.linalg.solve(matrices, right)[: len(tau), :, 0]
        return np.array(found + robot.C_p * legs.rates[..., 2])

    parts = (
        Part(call, f"{call}, 24 joint coordinates", run, len(tau)),
        Part("solve", "numpy.linalg.solve, 6x6", solve, _SOLVED),
    )
    nothing = Part("empty call", f"{call} over a model without joints", empty, len(tau))
    return Called(name, "dynamics + solve - call", parts, nothing, F)


def turned_back(R: Array, vector: Array) -> Array:
    """Vectors of the base frame in the frames of bodies."""
    return turned(np.swapaxes(R, -1, -2), vector)
