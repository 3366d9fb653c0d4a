"""Machine as a tree of joints for rigid-body engines, and conversion of joint results to the platform.

Each of the six legs is revolute about k, revolute about y, and prismatic along s. For forward dynamics the
platform is connected to the last leg by a spherical joint, and five points are closed by constraints. For
inverse dynamics the platform is free, and the loops are closed afterwards. Joint coordinates, rates,
accelerations, friction, generalized forces, and Jacobians of the closed loops are prepared before the timing.
Engines share no equation with the generated kernels.
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
"""Index of the leg that carries the platform."""

_SOLVED = 1024
"""Number of systems in one call of the solve, so that the overhead of the call is negligible."""


def base_frames(robot: Robot) -> Array:
    """Return frames of the first joints, (6, 3, 3), with the x axis along k; columns are axes in the base
    frame.
    """
    k = robot.k
    across = np.cross(k, np.eye(3)[np.argmin(np.abs(k), axis=-1)])
    across /= np.linalg.norm(across, axis=-1, keepdims=True)
    return np.stack([k, across, np.cross(k, across)], axis=-1)


@dataclass(frozen=True, eq=False)
class Tree:
    """Poses (n,) in joint coordinates.

    Attributes
    ----------
    legs : Legs
        Angles and lengths of the legs.
    relative : ndarray, shape (n, 3, 3)
        Orientation of the platform relative to the upper part that carries it.
    rates : ndarray, shape (n, 21)
        Three joint rates of each leg, then the angular velocity of the platform relative to its leg, platform
        frame.
    forces : ndarray, shape (n, 21)
        Generalized forces of actuators, joint friction, and load.
    """

    legs: "Legs"
    relative: Array
    rates: Array
    forces: Array
    _motion: Motion

    def accelerations(self, joints: Array) -> Array:
        """Return [a; alpha] of the platform, (n, 6), for the accelerations of the joints, (n, 21)."""
        tips, turns = self.legs.accelerations(joints[:, :-3].reshape(-1, 6, 3))
        omega, q, W = self._motion.omega, self.legs.q[:, CARRIER], self.legs.W[:, CARRIER]
        alpha = turns[:, CARRIER] + turned(self._motion.R, joints[:, -3:]) + np.cross(W, omega)
        a = tips[:, CARRIER] - np.cross(alpha, q) - np.cross(omega, np.cross(omega, q))
        return np.concatenate([a, alpha], axis=-1)

    def gaps(self, joints: Array) -> Array:
        """Return the accelerations of the other leg tips relative to the platform points, (n, 5, 3), base
        frame.
        """
        tips, _ = self.legs.accelerations(joints[:, :-3].reshape(-1, 6, 3))
        platform = self.accelerations(joints)[:, None]
        a, alpha, omega = platform[..., :3], platform[..., 3:], self._motion.omega[:, None]
        points = a + np.cross(alpha, self.legs.q) + np.cross(omega, np.cross(omega, self.legs.q))
        return (tips - points)[:, :CARRIER]

    def moved(self, tips: Array) -> Array:
        """Return ``legs.coordinates`` after small displacements of the other leg tips, (n, 5, 3), base
        frame.
        """
        found = self.legs.coordinates.copy()
        found[:, :CARRIER] += np.linalg.solve(self.legs.jacobian[:, :CARRIER], tips[..., None])[..., 0]
        return found


@dataclass(frozen=True, eq=False)
class Legs:
    """Kinematics of the legs at poses (n,), base frame, shape (n, 6, ...).

    Attributes
    ----------
    q : ndarray
        Platform points relative to the reference point.
    S : ndarray
        Leg vectors.
    coordinates : ndarray
        Two angles and the length; s = frame Rx(q1) Ry(q2) e_x.
    upper : ndarray
        Orientation of both parts.
    jacobian : ndarray
        Jacobian of the tip by the joint coordinates.
    axes : ndarray
        Axes of both revolute joints, in columns.
    rates : ndarray
        Joint rates.
    W : ndarray
        Angular velocity.
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
        """Return accelerations of the tips and angular accelerations of the legs, both (n, 6, 3)."""
        k, y = self.axes[..., 0], self.axes[..., 1]
        along = self.jacobian[..., 2]
        moving = np.cross(self.rates[..., :1] * k, self.rates[..., 1:2] * y)
        turn = turned(self.axes, joints[..., :2]) + moving
        spin = np.cross(self.W, np.cross(self.W, self.S)) + np.cross(moving, self.S)
        tip = turned(self.jacobian, joints) + spin + 2 * self.rates[..., 2:] * np.cross(self.W, along)
        return tip, turn


def legs_of(robot: Robot, motion: Motion) -> Legs:
    """Compute the kinematics of the legs at poses (n,); base joints must be universal."""
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
    """Compute joint coordinates at poses (n,) under actuator forces F (N), (n, 6); base joints must be
    universal.
    """
    legs = legs_of(robot, motion)
    relative = np.swapaxes(legs.upper[:, CARRIER], -1, -2) @ motion.R
    turning = turned_back(motion.R, motion.omega - legs.W[:, CARRIER])
    rates = np.concatenate([legs.rates.reshape(len(F), -1), turning], axis=-1)
    return Tree(legs, relative, rates, _forces(robot, motion, F, legs), motion)


def _forces(robot: Robot, motion: Motion, F: Array, legs: Legs) -> Array:
    """Compute the generalized forces of the joints, (n, 21)."""
    R, omega = motion.R, motion.omega
    friction = robot.C_s[:, None] * (legs.W - omega[:, None])
    joints = np.concatenate([-robot.C_u[:, None] * legs.rates[..., :2], np.zeros_like(F)[..., None]], axis=-1)
    joints[..., 2] = F - robot.C_p * legs.rates[..., 2]
    joints[..., :2] -= np.einsum("nkij,nki->nkj", legs.axes, friction)
    # The load acts at the reference point and is moved to the point that the last leg carries.
    given = loaded(motion)
    force = turned(R, given.F_ext)
    moment = turned(R, given.M_ext) + friction.sum(axis=1) - np.cross(legs.q[:, CARRIER], force)
    joints[:, CARRIER] += np.einsum("nij,ni->nj", legs.jacobian[:, CARRIER], force)
    joints[:, CARRIER, :2] += np.einsum("nij,ni->nj", legs.axes[:, CARRIER], moment)
    return np.concatenate([joints.reshape(len(F), -1), turned_back(R, moment)], axis=-1)


@dataclass(frozen=True, eq=False)
class States:
    """States at poses (n,).

    Attributes
    ----------
    motion : SimpleNamespace
        Motion with a load, which is never None.
    legs : Legs
        Kinematics of the legs.
    accelerations : ndarray, shape (n, 6, 3)
        Joint accelerations of the legs.
    lower, upper, platform : ndarray, shape (n, 6, 3) and (n, 3)
        Friction moments on the bodies (N m), base frame.
    """

    motion: SimpleNamespace
    legs: Legs
    accelerations: Array
    lower: Array
    upper: Array
    platform: Array


def states(robot: Robot, motion: Motion) -> States:
    """Compute the states at poses (n,); base joints must be universal."""
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
    """Return a baseline that consists of an engine's inverse dynamics and a solve.

    ``tau`` are the generalized forces of the engine, (n, 24), first of the legs. ``rates`` maps the twist [v;
    omega] to the joint rates of the platform, (n, 6, 6). ``run`` and ``empty`` are the calls for all poses
    and for an empty model.
    """
    legs = states.legs
    # F Ldot equals the power of all joints; Ldot and the joint rates are linear in the twist.
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
    """Return a baseline that consists of an engine's forward dynamics with loop constraints.

    ``joints`` returns the computed joint accelerations, (n, 21). ``run`` and ``empty`` are the calls for all
    poses and for an empty model.
    """
    count = len(tree.rates)
    parts = (
        Timed(run, count, name, call),
        Timed(empty, count, name, "call over a model without bodies"),
    )
    return Called(name, f"{call} - call", parts, lambda: tree.accelerations(joints()), tolerance)


def turned(matrix: Array, vector: Array) -> Array:
    """Compute products of matrices and vectors."""
    return np.asarray(np.einsum("...ij,...j->...i", matrix, vector))


def turned_back(R: Array, vector: Array) -> Array:
    """Rotate vectors from the base frame to the frames of bodies."""
    return turned(np.swapaxes(R, -1, -2), vector)
