"""The machine as a tree of joints for engines of rigid bodies, and from their joints back to the platform.

Six legs, each revolute about k, revolute about y, prismatic along s. For forward dynamics the platform hangs
on the last leg by a spherical joint, and five points remain to be closed; for inverse dynamics it is free,
and the loops are closed after it. Joint coordinates, rates, accelerations, friction, generalized forces and
Jacobians of the closed loops are prepared beforehand and not timed. Engines share no equation with the
generated kernels.
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
from ..baselines import Called
from ..figures import Timed

Run = Callable[[int], object]

CARRIER = 5
"""The leg that carries the platform."""

_SOLVED = 1024
"""Systems in one call of the solve, so that the call itself costs nothing a system."""


def base_frames(robot: Robot) -> Array:
    """Frames of the first joints, (6, 3, 3): x axis along k; columns are the axes in the base frame."""
    k = robot.k
    across = np.cross(k, np.eye(3)[np.argmin(np.abs(k), axis=-1)])
    across /= np.linalg.norm(across, axis=-1, keepdims=True)
    return np.stack([k, across, np.cross(k, across)], axis=-1)


@dataclass(frozen=True, eq=False)
class Tree:
    """Poses (n,) in joint coordinates.

    legs: their angles and lengths. relative: (n, 3, 3), the platform's orientation against the upper
    part that carries it. rates: (n, 21), three of each leg, in order, then the platform's angular velocity
    against its leg, platform frame. forces: (n, 21), actuators, friction of all joints and load.
    """

    legs: "Legs"
    relative: Array
    rates: Array
    forces: Array
    _motion: Motion

    def accelerations(self, joints: Array) -> Array:
        """[a; alpha] of the platform, (n, 6), that the accelerations of the joints, (n, 21), mean."""
        tips, turns = self.legs.accelerations(joints[:, :-3].reshape(-1, 6, 3))
        omega, q, W = self._motion.omega, self.legs.q[:, CARRIER], self.legs.W[:, CARRIER]
        alpha = turns[:, CARRIER] + turned(self._motion.R, joints[:, -3:]) + np.cross(W, omega)
        a = tips[:, CARRIER] - np.cross(alpha, q) - np.cross(omega, np.cross(omega, q))
        return np.concatenate([a, alpha], axis=-1)

    def gaps(self, joints: Array) -> Array:
        """Accelerations, (n, 5, 3), of the tips of the other legs from the platform's points, base frame."""
        tips, _ = self.legs.accelerations(joints[:, :-3].reshape(-1, 6, 3))
        platform = self.accelerations(joints)[:, None]
        a, alpha, omega = platform[..., :3], platform[..., 3:], self._motion.omega[:, None]
        points = a + np.cross(alpha, self.legs.q) + np.cross(omega, np.cross(omega, self.legs.q))
        return (tips - points)[:, :CARRIER]

    def moved(self, tips: Array) -> Array:
        """``legs.coordinates`` after small moves of the tips of the other legs, (n, 5, 3), base frame."""
        found = self.legs.coordinates.copy()
        found[:, :CARRIER] += np.linalg.solve(self.legs.jacobian[:, :CARRIER], tips[..., None])[..., 0]
        return found


@dataclass(frozen=True, eq=False)
class Legs:
    """Kinematics of the legs at poses (n,), base frame, (n, 6, ...).

    q, S: platform points from the reference point, legs. coordinates: two angles and the length,
    s = frame Rx(q1) Ry(q2) e_x. upper: orientation of both parts. jacobian: of the tip by the joints. axes:
    of both revolute joints, in columns. rates: of the joints. W: angular velocity.
    """

    q: Array
    S: Array
    coordinates: Array
    upper: Array
    jacobian: Array
    axes: Array
    rates: Array
    W: Array

    def accelerations(self, joints: Array) -> tuple[Array, Array]:
        """Accelerations of the tips and of the legs' rotation, both (n, 6, 3)."""
        k, y = self.axes[..., 0], self.axes[..., 1]
        along = self.jacobian[..., 2]
        moving = np.cross(self.rates[..., :1] * k, self.rates[..., 1:2] * y)
        turn = turned(self.axes, joints[..., :2]) + moving
        spin = np.cross(self.W, np.cross(self.W, self.S)) + np.cross(moving, self.S)
        tip = turned(self.jacobian, joints) + spin + 2 * self.rates[..., 2:] * np.cross(self.W, along)
        return tip, turn


def legs_of(robot: Robot, motion: Motion) -> Legs:
    """The legs at poses (n,); base joints must be universal."""
    frames = base_frames(robot)
    q = np.einsum("nij,kj->nki", motion.R, robot.p)
    S = motion.t[:, None] + q - robot.b
    L = np.linalg.norm(S, axis=-1)
    along, second, third = np.moveaxis(np.einsum("kji,nkj->nki", frames, S) / L[..., None], -1, 0)
    coordinates = np.stack([np.arctan2(second, -third), np.arccos(along), L], axis=-1)
    (sin_1, sin_2), (cos_1, cos_2) = (np.moveaxis(f(coordinates[..., :2]), -1, 0) for f in (np.sin, np.cos))
    x = np.stack([cos_2, sin_1 * sin_2, -cos_1 * sin_2], axis=-1)
    y = np.stack([np.zeros_like(sin_1), cos_1, sin_1], axis=-1)
    upper = frames @ np.stack([x, y, np.cross(x, y)], axis=-1)
    axes = np.stack([np.broadcast_to(frames[..., 0], S.shape), upper[..., 1]], axis=-1)
    sideways = np.cross(np.swapaxes(axes, -1, -2), S[..., None, :])
    jacobian = np.concatenate([np.swapaxes(sideways, -1, -2), upper[..., :1]], axis=-1)
    Sdot = motion.v[:, None] + np.cross(motion.omega[:, None], q)
    rates = np.linalg.solve(jacobian, Sdot[..., None])[..., 0]
    return Legs(q, S, coordinates, upper, jacobian, axes, rates, turned(axes, rates[..., :2]))


def tree(robot: Robot, motion: Motion, F: Array) -> Tree:
    """Joint coordinates of poses (n,) under actuator forces F, N, (n, 6); base joints must be universal."""
    legs = legs_of(robot, motion)
    relative = np.swapaxes(legs.upper[:, CARRIER], -1, -2) @ motion.R
    turning = turned_back(motion.R, motion.omega - legs.W[:, CARRIER])
    rates = np.concatenate([legs.rates.reshape(len(F), -1), turning], axis=-1)
    return Tree(legs, relative, rates, _forces(robot, motion, F, legs), motion)


def _forces(robot: Robot, motion: Motion, F: Array, legs: Legs) -> Array:
    """Generalized forces of the joints, (n, 21)."""
    R, omega = motion.R, motion.omega
    friction = robot.C_s[:, None] * (legs.W - omega[:, None])
    joints = np.concatenate([-robot.C_u[:, None] * legs.rates[..., :2], np.zeros_like(F)[..., None]], axis=-1)
    joints[..., 2] = F - robot.C_p * legs.rates[..., 2]
    joints[..., :2] -= np.einsum("nkij,nki->nkj", legs.axes, friction)
    # The load acts at the reference point; here it is moved to the point that the last leg carries.
    given = loaded(motion)
    force = turned(R, given.F_ext)
    moment = turned(R, given.M_ext) + friction.sum(axis=1) - np.cross(legs.q[:, CARRIER], force)
    joints[:, CARRIER] += np.einsum("nij,ni->nj", legs.jacobian[:, CARRIER], force)
    joints[:, CARRIER, :2] += np.einsum("nij,ni->nj", legs.axes[:, CARRIER], moment)
    return np.concatenate([joints.reshape(len(F), -1), turned_back(R, moment)], axis=-1)


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
    run: Run,
    empty: Run,
) -> Called:
    """A baseline made of a call of an engine's inverse dynamics and a solve.

    tau: generalized forces that the engine found, (n, 24), those of the legs first; rates: of the platform's
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
        Timed(run, len(tau), call, f"{call}, 24 joint coordinates"),
        Timed(solve, _SOLVED, "solve", "numpy.linalg.solve, 6x6"),
        Timed(empty, len(tau), "empty call", f"{call} over a model without joints"),
    )
    return Called(name, "dynamics + solve - call", parts, F)


def forward_dynamics(
    name: str, call: str, tree: Tree, run: Run, empty: Run, joints: Callable[[], Array], tolerance: float
) -> Called:
    """A baseline made of a call of an engine's forward dynamics with constraints that close the loops.

    joints: the accelerations that it found, (n, 21); run, empty: its call over all poses, and over nothing.
    """
    count = len(tree.rates)
    parts = (
        Timed(run, count, name, call),
        Timed(empty, count, name, "call over a model without bodies"),
    )
    return Called(name, f"{call} - call", parts, lambda: tree.accelerations(joints()), tolerance)


def turned(matrix: Array, vector: Array) -> Array:
    """Products of matrices and vectors."""
    return np.asarray(np.einsum("...ij,...j->...i", matrix, vector))


def turned_back(R: Array, vector: Array) -> Array:
    """Vectors of the base frame in the frames of bodies."""
    return turned(np.swapaxes(R, -1, -2), vector)
