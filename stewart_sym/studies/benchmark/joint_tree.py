"""Machine as a tree of joints for rigid-body engines: coordinates, rates, accelerations, and joint forces.

Each of the six legs is revolute about k, revolute about y, and prismatic along s. A spherical joint connects
the platform to the last leg, and five points close the loops. Engines share no equation with the kernels;
rotations of the legs are from the vector reference.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ...backend.numpy_kernel import loaded
from ...io.array_types import Array
from ...motion.motion import Motion
from ...motion.rotation import cross_matrix, quaternion_from_rotation
from ...reference import newton_euler
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
    given, leg, k = loaded(motion), newton_euler.legs(robot, motion), np.broadcast_to(robot.k, (6, 3))
    R, to_platform = given.R, np.swapaxes(given.R, -1, -2)
    _, second, third = np.moveaxis(np.einsum("kji,nkj->nki", base_frames(robot), leg.y), -1, 0)
    tilt = np.arccos(np.einsum("ki,nki->nk", k, leg.s))
    coordinates = np.stack([np.arctan2(third, second), tilt, leg.L[..., 0]], axis=-1)
    axes = np.stack([np.broadcast_to(k, leg.y.shape), leg.y], axis=-1)
    jacobian = np.stack([np.cross(k, leg.S), np.cross(leg.y, leg.S), leg.s], axis=-1)
    # Joint rates of the legs and of the joint below the platform are linear in the twist.
    arms = np.concatenate([np.broadcast_to(np.eye(3), (*leg.q.shape, 3)), -cross_matrix(leg.q)], axis=-1)
    of_legs = np.linalg.inv(jacobian) @ arms
    turn = np.zeros((len(R), 3, 6))
    turn[..., 3:] = np.eye(3)
    below = to_platform @ (turn - axes[:, CARRIER] @ of_legs[:, CARRIER, :2])
    per_twist = np.concatenate([of_legs.reshape(len(R), -1, 6), below], axis=1)
    rates = _product(per_twist, np.concatenate([given.v, given.omega], axis=-1))
    accelerations = np.concatenate([_product(np.swapaxes(axes, -1, -2), leg.A), leg.Lddot], axis=-1)
    W, A = leg.W[:, CARRIER], leg.A[:, CARRIER]
    spin = _product(to_platform, given.alpha - A - np.cross(W, given.omega))
    return JointTree(
        coordinates.reshape(len(R), -1),
        quaternion_from_rotation(np.swapaxes(leg.T[:, CARRIER], -1, -2) @ R),
        rates,
        np.concatenate([accelerations.reshape(len(R), -1), spin], axis=-1),
        _resistance(robot, given, leg, rates[:, :-3].reshape(-1, 6, 3), axes, jacobian),
        per_twist,
        jacobian,
        np.concatenate([given.a, given.alpha], axis=-1),
    )


def _resistance(
    robot: Robot, given: Any, leg: newton_euler.Legs, rates: Array, axes: Array, jacobian: Array
) -> Array:
    """Compute the generalized forces of friction and load, (n, 21)."""
    joints = np.concatenate([-robot.C_u[:, None] * rates[..., :2], -robot.C_p[:, None] * rates[..., 2:]], -1)
    joints[..., :2] -= np.einsum("nkij,nki->nkj", axes, leg.f)
    # The load acts at the reference point and is moved to the point that the last leg carries.
    force = _product(given.R, given.F_ext)
    moment = _product(given.R, given.M_ext) + leg.f.sum(axis=1) - np.cross(leg.q[:, CARRIER], force)
    joints[:, CARRIER] += np.einsum("nij,ni->nj", jacobian[:, CARRIER], force)
    joints[:, CARRIER, :2] += np.einsum("nij,ni->nj", axes[:, CARRIER], moment)
    in_platform = _product(np.swapaxes(given.R, -1, -2), moment)
    return np.concatenate([joints.reshape(len(force), -1), in_platform], axis=-1)


def _product(matrix: Array, vector: Array) -> Array:
    return np.asarray(np.einsum("...ij,...j->...i", matrix, vector))
