"""Clearances of a pose: distances between the center lines of the legs, and angles of their joints."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from ..io.arguments import instance
from ..io.array_types import Array
from ..motion.motion import Motion, at_rest
from ..robot.robot import LEGS, Robot
from .inverse_kinematics import inverse_kinematics, leg_vectors

PAIRS = tuple(itertools.combinations(range(LEGS), 2))
"""Pairs of leg indices, counted from 0, in the order of ``leg_distances``."""

_ONE, _OTHER = np.array(PAIRS).T
# Fraction of a leg at each end that is part of its joint.
_JOINT = 0.1


def leg_distances(robot: Robot, motion: Motion) -> Array:
    """Compute the smallest distance between the center lines of each pair of legs.

    Legs of diameter d do not collide if the distance exceeds d.

    Parameters
    ----------
    robot : Robot
        Robot geometry without joint offsets.
    motion : Motion
        Poses of the platform with any leading shape; rates are ignored.

    Returns
    -------
    ndarray, shape (..., 15)
        Distances (m) of the pairs 1 and 2, 1 and 3, ..., 5 and 6.

    Raises
    ------
    ValueError
        If the robot has joint offsets.

    See Also
    --------
    joint_angles : Angles of the joints at both ends of the legs.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> rest = [0.0, 0.0, 0.0]
    >>> motion = ss.Motion.from_rpy(t=[0.2, 0.1, 1.0], theta=rest, v=rest, theta_dot=rest)
    >>> round(float(ss.leg_distances(robot, motion).min()), 3)
    0.19
    """
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    return distances_of(robot.b, leg_vectors(robot, motion.R, motion.t)[1])


def distances_of(b: Array, S: Array) -> Array:
    """Return ``leg_distances`` for base points (6, 3) and leg vectors (..., 6, 3)."""
    # One array per component is many times faster than arrays with a last axis of length three.
    legs = np.ascontiguousarray(S.reshape(-1, LEGS * 3).T).reshape(LEGS, 3, -1)
    squares = np.einsum("lkn,lkn->ln", legs, legs)
    found = np.empty((len(PAIRS), legs.shape[-1]))
    for pair, (i, j) in enumerate(PAIRS):
        found[pair] = _distance(b[i] - b[j], legs[i], legs[j], squares[i], squares[j])
    return found.T.reshape(*S.shape[:-2], len(PAIRS))


def _distance(apart: Array, one: Array, other: Array, ii: Array, jj: Array) -> Array:
    """Return the distance between b_i + x S_i and b_j + y S_j for x and y in [0, 1], shape (n,).

    ``apart`` is b_i - b_j, shape (3,). ``one`` and ``other`` are S_i and S_j, shape (3, n), and ``ii`` and
    ``jj`` their squared lengths, shape (n,).
    """
    ij = one[0] * other[0] + one[1] * other[1] + one[2] * other[2]
    i, j = apart @ one, apart @ other
    x, y = _shares(ii, jj, ij, i, j)
    square = apart @ apart + x * (2.0 * i + x * ii) - y * (2.0 * j - y * jj + 2.0 * x * ij)
    return np.asarray(np.sqrt(np.maximum(square, 0.0)))


def meeting_legs(robot: Robot, t: Array, share: float) -> tuple[int, int] | None:
    """Return the legs of the level pose at t (m) whose center lines meet between their joints, or None.

    ``share`` is the largest distance over the mean leg length. Near their joints legs may come as close.
    """
    S, apart = robot.p + t - robot.b, robot.b[_ONE] - robot.b[_OTHER]
    x, y = nearest_shares(apart, S[_ONE], S[_OTHER])
    distance = np.linalg.norm(apart + x[:, None] * S[_ONE] - y[:, None] * S[_OTHER], axis=-1)
    inner = (np.minimum(x, y) > _JOINT) & (np.maximum(x, y) < 1.0 - _JOINT)
    distance = np.where(inner, distance, np.inf)
    found = int(np.argmin(distance))
    return PAIRS[found] if distance[found] < share * np.mean(np.linalg.norm(S, axis=-1)) else None


def nearest_shares(apart: Array, one: Array, other: Array) -> tuple[Array, Array]:
    """Return x and y in [0, 1], shape (...), that minimize the length of apart + x one - y other.

    The vectors have the shape (..., 3).
    """
    i, j = _dot(one, apart), _dot(other, apart)
    return _shares(_dot(one, one), _dot(other, other), _dot(one, other), i, j)


def _shares(ii: Array, jj: Array, ij: Array, i: Array, j: Array) -> tuple[Array, Array]:
    """Compute ``nearest_shares`` from the scalar products of its vectors."""
    # The squared length is a quadratic form in x and y.
    with np.errstate(divide="ignore", invalid="ignore"):
        x = _share(ij * j - i * jj, ii * jj - ij * ij)
        y = _share(ij * x + j, jj)
        return _share(ij * y - i, ii), y


def joined(robot: Robot) -> Array:
    """Return the smaller distance (m) between the joints of each pair of legs at either end, shape (15,)."""
    return np.asarray(
        np.minimum(*(np.linalg.norm(ends[_ONE] - ends[_OTHER], axis=-1) for ends in (robot.b, robot.p)))
    )


def _share(part: Array, whole: Array) -> Array:
    """Return part / whole, limited to [0, 1]; 0 if the whole is 0."""
    return np.asarray(np.where(whole > 0.0, np.minimum(np.maximum(part / whole, 0.0), 1.0), 0.0))


def _dot(x: Array, y: Array) -> Array:
    return np.asarray(np.einsum("...k,...k->...", x, y))


@dataclass(frozen=True, eq=False)
class JointAnglesResult:
    """Angles between legs and the neutral directions of their joints.

    The leading shape ``(...)`` is the shape of the poses.

    Attributes
    ----------
    base : ndarray, shape (..., 6)
        Angles of the base joints (rad), from 0 to pi, between the leg and its neutral direction in the base
        frame. With offsets, the direction of the leg is the axis of its prismatic joint.
    platform : ndarray, shape (..., 6)
        Angles of the platform joints (rad), from 0 to pi, between the leg and its neutral direction in the
        platform frame.
    """

    base: Array
    platform: Array


def joint_angles(robot: Robot, motion: Motion) -> JointAnglesResult:
    """Compute the deflections of the base and platform joints from the home pose.

    The neutral direction of a joint, at both ends of a leg, is the direction of the leg at the home pose.

    Parameters
    ----------
    robot : Robot
        Robot with a home pose.
    motion : Motion
        Poses of the platform with any leading shape; rates are ignored.

    Returns
    -------
    JointAnglesResult
        Angles of the base and platform joints (rad), shape (..., 6) each.

    Raises
    ------
    ValueError
        If the robot has no home pose.

    See Also
    --------
    leg_distances : Distances between the legs.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("unal")
    >>> rest = [0.0, 0.0, 0.0]
    >>> motion = ss.Motion.from_rpy(t=[0.0, 0.0, 0.7], theta=[0.2, 0.0, 0.0], v=rest, theta_dot=rest)
    >>> angles = ss.joint_angles(robot, motion)
    >>> np.degrees(angles.base).round(1).tolist()
    [1.0, 0.8, 1.2, 1.2, 0.8, 1.0]
    >>> np.degrees(angles.platform).round(1).tolist()
    [12.4, 12.3, 12.5, 12.5, 12.3, 12.4]
    """
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    return JointAnglesResult(*angles_from(neutral_directions(robot), _along_legs(robot, motion), motion.R))


def angles_from(neutral: Array, S: Array, R: Array) -> tuple[Array, Array]:
    """Return the angles at base and platform (rad), shape (..., 6), of legs with vectors S, (..., 6, 3).

    ``neutral`` is the result of ``neutral_directions``.
    """
    return angles_between(S, neutral), angles_between(S @ R, neutral)


def neutral_directions(robot: Robot) -> Array:
    """Return the unit vectors of the legs at the home pose, shape (6, 3), equal in both frames.

    Raises ValueError if the robot has no home pose.
    """
    if robot.home_position is None:
        raise ValueError("robot: home_position: joint angles require a home pose, got none")
    S = _along_legs(robot, at_rest(np.eye(3), robot.home_position))
    return np.asarray(S / np.linalg.norm(S, axis=-1, keepdims=True))


def _along_legs(robot: Robot, motion: Motion) -> Array:
    """Return vectors along the legs in the base frame, shape (..., 6, 3).

    With offsets, they are parallel to the prismatic joints.
    """
    if robot.offsets is not None:
        return inverse_kinematics(robot, motion).s
    return leg_vectors(robot, motion.R, motion.t)[1]


def angles_between(S: Array, directions: Array) -> Array:
    """Return the angles between vectors of shape (..., 3) (rad), shape (...), accurate also near 0 and pi."""
    return np.asarray(
        np.arctan2(np.linalg.norm(np.cross(S, directions), axis=-1), np.sum(S * directions, axis=-1))
    )
