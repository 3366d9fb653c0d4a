"""Clearances of a pose: distances between the legs as straight lines, angles of the joints at their ends."""

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
"""Pairs of legs, counted from 0, in the order of ``leg_distances``."""

_ONE, _OTHER = np.array(PAIRS).T


def leg_distances(robot: Robot, motion: Motion) -> Array:
    """Return the least distance between the center lines of each two legs, m, (..., 15).

    Legs of diameter d are clear of each other where it is more than d.

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        Poses of the platform, any leading shape; rates don't count.

    Returns
    -------
    ndarray
        Distances, m, of legs 1 and 2, 1 and 3, ..., 5 and 6.
    """
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    return distances_of(robot.b, leg_vectors(robot, motion.R, motion.t)[1])


def distances_of(b: Array, S: Array) -> Array:
    """``leg_distances`` of base points (6, 3) and leg vectors (..., 6, 3)."""
    # Component by component: many times as fast as on arrays whose last axis has three numbers.
    legs = np.ascontiguousarray(S.reshape(-1, LEGS * 3).T).reshape(LEGS, 3, -1)
    squares = np.einsum("lkn,lkn->ln", legs, legs)
    found = np.empty((len(PAIRS), legs.shape[-1]))
    for pair, (i, j) in enumerate(PAIRS):
        found[pair] = _distance(b[i] - b[j], legs[i], legs[j], squares[i], squares[j])
    return found.T.reshape(*S.shape[:-2], len(PAIRS))


def _distance(apart: Array, one: Array, other: Array, ii: Array, jj: Array) -> Array:
    """Between b_i + x S_i and b_j + y S_j, x and y within 0 and 1, (n,).

    apart: b_i - b_j, (3,). one, other: S_i and S_j, (3, n). ii, jj: their squared lengths, (n,).
    """
    ij = one[0] * other[0] + one[1] * other[1] + one[2] * other[2]
    i, j = apart @ one, apart @ other
    x, y = _shares(ii, jj, ij, i, j)
    square = apart @ apart + x * (2.0 * i + x * ii) - y * (2.0 * j - y * jj + 2.0 * x * ij)
    return np.asarray(np.sqrt(np.maximum(square, 0.0)))


def nearest_shares(apart: Array, one: Array, other: Array) -> tuple[Array, Array]:
    """Shares x and y of [0, 1], (...), at which apart + x one - y other, (..., 3), is shortest."""
    i, j = _dot(one, apart), _dot(other, apart)
    return _shares(_dot(one, one), _dot(other, other), _dot(one, other), i, j)


def _shares(ii: Array, jj: Array, ij: Array, i: Array, j: Array) -> tuple[Array, Array]:
    """``nearest_shares`` from the scalar products of its vectors."""
    # The squared length is a quadratic form in x and y.
    with np.errstate(divide="ignore", invalid="ignore"):
        x = _share(ij * j - i * jj, ii * jj - ij * ij)
        y = _share(ij * x + j, jj)
        return _share(ij * y - i, ii), y


def joined(robot: Robot) -> Array:
    """Least distance of the joints of each two legs at the base or at the platform, m, (15,)."""
    return np.asarray(
        np.minimum(*(np.linalg.norm(ends[_ONE] - ends[_OTHER], axis=-1) for ends in (robot.b, robot.p)))
    )


def _share(part: Array, whole: Array) -> Array:
    """part / whole within 0 and 1; 0 where the whole is 0."""
    return np.asarray(np.where(whole > 0.0, np.minimum(np.maximum(part / whole, 0.0), 1.0), 0.0))


def _dot(x: Array, y: Array) -> Array:
    return np.asarray(np.einsum("...k,...k->...", x, y))


@dataclass(frozen=True, eq=False)
class JointAnglesResult:
    """Angles between legs and their neutral directions, rad, 0 to pi; ``(...)`` is the poses' shape.

    Attributes
    ----------
    base : ndarray
        Of the joints at the base, (..., 6): between the leg, with offsets its line of sliding, and its
        neutral direction in the base frame.
    platform : ndarray
        Of the joints at the platform, (..., 6): between the leg and its neutral direction in the platform
        frame.
    """

    base: Array
    platform: Array


def joint_angles(robot: Robot, motion: Motion) -> JointAnglesResult:
    """Return how far the joints of each leg are from where the home pose has them.

    A joint is mounted so that its neutral direction is that of the leg at the home pose, at both ends.

    Parameters
    ----------
    robot : Robot
        The machine, with a home pose.
    motion : Motion
        Poses of the platform, any leading shape; rates don't count.

    Returns
    -------
    JointAnglesResult
        Angles, rad.

    Raises
    ------
    ValueError
        For a robot that states no home pose.
    """
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    return JointAnglesResult(*angles_from(neutral_directions(robot), _along_legs(robot, motion), motion.R))


def angles_from(neutral: Array, S: Array, R: Array) -> tuple[Array, Array]:
    """Angles at base and platform, (..., 6), of legs along S, (..., 6, 3), from ``neutral_directions``."""
    return angles_between(S, neutral), angles_between(S @ R, neutral)


def neutral_directions(robot: Robot) -> Array:
    """Unit vectors of the legs at the home pose, (6, 3), in both frames; ValueError where none is stated."""
    if robot.home_position is None:
        raise ValueError("robot: home_position: missing; joint angles refer to the home pose")
    S = _along_legs(robot, at_rest(np.eye(3), robot.home_position))
    return np.asarray(S / np.linalg.norm(S, axis=-1, keepdims=True))


def _along_legs(robot: Robot, motion: Motion) -> Array:
    """Vectors along the legs, base frame, (..., 6, 3); with offsets along their lines of sliding."""
    if robot.offsets is not None:
        return inverse_kinematics(robot, motion).s
    return leg_vectors(robot, motion.R, motion.t)[1]


def angles_between(S: Array, directions: Array) -> Array:
    """Angles, rad, (...), between vectors (..., 3), exact near 0 and pi too."""
    return np.asarray(
        np.arctan2(np.linalg.norm(np.cross(S, directions), axis=-1), np.sum(S * directions, axis=-1))
    )
