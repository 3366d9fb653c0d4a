"""Machine as a tree of joints for rigid-body engines: coordinates, rates, accelerations, and joint forces.

Each of the six legs is revolute about k, revolute about y, and prismatic along s. A spherical joint connects
the platform to the last leg, and five points close the loops. Engines share no equation with the kernels.
"""

from dataclasses import dataclass

import numpy as np

from ...backend.numpy_kernel import loaded
from ...io.array_types import Array
from ...motion.motion import Motion
from ...motion.rotation import cross_matrix, quaternion_from_rotation
from ...robot.robot import Robot

CARRIER = 5
"""Index of the leg that carries the platform."""

SLIDES = slice(2, 18, 3)
"""Indices of the actuated coordinates among the 21 joint rates."""


@dataclass(frozen=True, eq=False)
class JointTree:
    """Motions (n,) in joint coordinates.

    ``coordinates``, (n, 18), are two angles and the length of each leg, and ``quaternion``, (n, 4), is the
    orientation of the platform relative to the upper part that carries it, scalar first. ``rates``, (n, 21),
    are the joint rates of the legs, then the angular velocity of the platform relative to its leg in the
    platform frame, and ``accelerations`` their derivatives. ``resistance``, (n, 21), are the generalized
    forces of joint friction and external load. ``per_twist``, (n, 21, 6), are joint rates per twist [v;
    omega] of the platform, and ``jacobian``, (n, 6, 3, 3), velocities of the leg tips per joint rates.
    """

    coordinates: Array
    quaternion: Array
    rates: Array
    accelerations: Array
    resistance: Array
    per_twist: Array
    jacobian: Array
    _acceleration: Array

    def platform_acceleration(self, joints: Array) -> Array:
        """Return [a; alpha], (n, 6), for joint accelerations, (n, 21), of the leg with the platform."""
        change = (joints - self.accelerations)[:, 3 * CARRIER :, None]
        return self._acceleration + np.linalg.solve(self.per_twist[:, 3 * CARRIER :], change)[..., 0]

    def gaps(self, joints: Array) -> Array:
        """Return accelerations of the other leg tips relative to their platform points, (n, 5, 3)."""
        change = self.platform_acceleration(joints) - self._acceleration
        off = joints - self.accelerations - _product(self.per_twist, change)
        return _product(self.jacobian, off[:, :-3].reshape(-1, 6, 3))[:, :CARRIER]


def base_frames(robot: Robot) -> Array:
    """Return frames of the first joints, (6, 3, 3), with the x axis along k; columns are their axes."""
    k = robot.k
    across = np.cross(k, np.eye(3)[np.argmin(np.abs(k), axis=-1)])
    across /= np.linalg.norm(across, axis=-1, keepdims=True)
    return np.stack([k, across, np.cross(k, across)], axis=-1)


def joint_tree(robot: Robot, motion: Motion) -> JointTree:
    """Compute the joint motion at poses (n,); base joints must be universal."""
    given = loaded(motion)
    R, omega = given.R, given.omega[:, None]
    q = np.einsum("nij,kj->nki", R, robot.p)
    S = given.t[:, None] + q - robot.b
    coordinates, axes, upper = _legs(robot, S)
    sideways = np.swapaxes(np.cross(np.swapaxes(axes, -1, -2), S[..., None, :]), -1, -2)
    jacobian = np.concatenate([sideways, upper[..., :1]], axis=-1)
    # Joint rates of the legs and of the joint below the platform are linear in the twist.
    arms = np.concatenate([np.broadcast_to(np.eye(3), (*q.shape, 3)), -cross_matrix(q)], axis=-1)
    of_legs = np.linalg.inv(jacobian) @ arms
    turn = np.zeros((len(R), 3, 6))
    turn[..., 3:] = np.eye(3)
    below = np.swapaxes(R, -1, -2) @ (turn - axes[:, CARRIER] @ of_legs[:, CARRIER, :2])
    per_twist = np.concatenate([of_legs.reshape(len(R), -1, 6), below], axis=1)
    rates = _product(per_twist, np.concatenate([given.v, given.omega], axis=-1))
    legs = rates[:, :-3].reshape(-1, 6, 3)
    W = _product(axes, legs[..., :2])
    moving = np.cross(legs[..., :1] * axes[..., 0], legs[..., 1:2] * axes[..., 1])
    tips = given.a[:, None] + np.cross(given.alpha[:, None], q) + np.cross(omega, np.cross(omega, q))
    drift = np.cross(W, np.cross(W, S)) + np.cross(moving, S)
    drift += 2 * legs[..., 2:] * np.cross(W, upper[..., 0])
    accelerations = np.linalg.solve(jacobian, (tips - drift)[..., None])[..., 0]
    turned = _product(axes[:, CARRIER], accelerations[:, CARRIER, :2]) + moving[:, CARRIER]
    spin = _product(np.swapaxes(R, -1, -2), given.alpha - turned - np.cross(W[:, CARRIER], given.omega))
    relative = np.swapaxes(upper[:, CARRIER], -1, -2) @ R
    return JointTree(
        coordinates.reshape(len(R), -1),
        quaternion_from_rotation(relative),
        rates,
        np.concatenate([accelerations.reshape(len(R), -1), spin], axis=-1),
        _resistance(robot, motion, q, W, legs, axes, jacobian),
        per_twist,
        jacobian,
        np.concatenate([given.a, given.alpha], axis=-1),
    )


def _legs(robot: Robot, S: Array) -> tuple[Array, Array, Array]:
    """Return angles and lengths, revolute axes in columns, and frames of the parts for S, (n, 6, 3)."""
    frames, L = base_frames(robot), np.linalg.norm(S, axis=-1)
    along, second, third = np.moveaxis(np.einsum("kji,nkj->nki", frames, S) / L[..., None], -1, 0)
    coordinates = np.stack([np.arctan2(second, -third), np.arccos(along), L], axis=-1)
    (sin_1, sin_2), (cos_1, cos_2) = (np.moveaxis(f(coordinates[..., :2]), -1, 0) for f in (np.sin, np.cos))
    x = np.stack([cos_2, sin_1 * sin_2, -cos_1 * sin_2], axis=-1)
    y = np.stack([np.zeros_like(sin_1), cos_1, sin_1], axis=-1)
    upper = frames @ np.stack([x, y, np.cross(x, y)], axis=-1)
    return coordinates, np.stack([np.broadcast_to(frames[..., 0], S.shape), upper[..., 1]], axis=-1), upper


def _resistance(
    robot: Robot, motion: Motion, q: Array, W: Array, rates: Array, axes: Array, jacobian: Array
) -> Array:
    """Compute the generalized forces of friction and load, (n, 21)."""
    given = loaded(motion)
    friction = robot.C_s[:, None] * (W - given.omega[:, None])
    joints = np.concatenate([-robot.C_u[:, None] * rates[..., :2], -robot.C_p[:, None] * rates[..., 2:]], -1)
    joints[..., :2] -= np.einsum("nkij,nki->nkj", axes, friction)
    # The load acts at the reference point and is moved to the point that the last leg carries.
    force = _product(given.R, given.F_ext)
    moment = _product(given.R, given.M_ext) + friction.sum(axis=1) - np.cross(q[:, CARRIER], force)
    joints[:, CARRIER] += np.einsum("nij,ni->nj", jacobian[:, CARRIER], force)
    joints[:, CARRIER, :2] += np.einsum("nij,ni->nj", axes[:, CARRIER], moment)
    in_platform = _product(np.swapaxes(given.R, -1, -2), moment)
    return np.concatenate([joints.reshape(len(force), -1), in_platform], axis=-1)


def _product(matrix: Array, vector: Array) -> Array:
    return np.asarray(np.einsum("...ij,...j->...i", matrix, vector))
