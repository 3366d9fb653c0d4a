"""Distances between the legs, as straight lines from base point to platform point."""

from __future__ import annotations

import itertools

import numpy as np

from ..io.arguments import instance
from ..io.array_types import Array
from ..motion.motion import Motion
from ..robot.robot import LEGS, Robot
from .inverse import leg_vectors

PAIRS = tuple(itertools.combinations(range(LEGS), 2))
"""Pairs of legs, counted from 0, in the order of ``leg_distances``."""

_ONE, _OTHER = np.array(PAIRS).T


def leg_distances(robot: Robot, motion: Motion) -> Array:
    """Return the least distance between the centre lines of each two legs, m, (..., 15).

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
    """The same, (..., 15), of base points (6, 3) and leg vectors (..., 6, 3)."""
    apart = b[_ONE] - b[_OTHER]
    one, other = S[..., _ONE, :], S[..., _OTHER, :]
    x, y = nearest_shares(apart, one, other)
    return np.asarray(np.linalg.norm(apart + x[..., None] * one - y[..., None] * other, axis=-1))


def nearest_shares(apart: Array, one: Array, other: Array) -> tuple[Array, Array]:
    """Shares x and y of [0, 1], (...), at which apart + x one - y other, (..., 3), is shortest."""
    # Its square is a quadratic form in x and y.
    ii, jj, ij = _dot(one, one), _dot(other, other), _dot(one, other)
    i, j = _dot(one, apart), _dot(other, apart)
    with np.errstate(divide="ignore", invalid="ignore"):
        x = np.clip(np.nan_to_num((ij * j - i * jj) / (ii * jj - ij**2)), 0.0, 1.0)
        y = np.clip(np.nan_to_num((ij * x + j) / jj), 0.0, 1.0)
        return np.clip(np.nan_to_num((ij * y - i) / ii), 0.0, 1.0), y


def joined(robot: Robot) -> Array:
    """Least distance of the joints of each two legs at the base or at the platform, m, (15,)."""
    return np.asarray(
        np.minimum(*(np.linalg.norm(ends[_ONE] - ends[_OTHER], axis=-1) for ends in (robot.b, robot.p)))
    )


def _dot(x: Array, y: Array) -> Array:
    return np.asarray(np.einsum("...k,...k->...", x, y))
