"""Condition number of H: how near the platform is to a singular pose, section 4.2."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import instance, number_in, shaped_array
from ..io.array_types import Array
from ..robot.robot import Robot


def condition_number(H: ArrayLike) -> Array:
    """Return the ratio of the largest to the smallest singular value, (...), of H, (..., 6, 6).

    This is the paper's number; it mixes unitless rows with rows in meters, so it changes with the unit of
    length. inf where H is singular to rounding (smallest <= 6 eps largest), nan where H is not finite.

    Parameters
    ----------
    H : array_like
        From axial forces to the wrench, (..., 6, 6).

    Returns
    -------
    ndarray
        Condition numbers, (...).
    """
    H = shaped_array(H, (6, 6), "H")
    finite = np.all(np.isfinite(H), axis=(-2, -1))
    values = np.linalg.svd(np.where(finite[..., None, None], H, 0.0), compute_uv=False)
    largest, smallest = values[..., 0], values[..., -1]
    singular = smallest <= 6.0 * np.finfo(np.float64).eps * largest
    ratio = largest / np.where(singular, 1.0, smallest)
    return np.asarray(np.where(finite, np.where(singular, math.inf, ratio), math.nan))


def scaled_condition_number(H: ArrayLike, length: float) -> Array:
    """Return the condition number, (...), of H with its moment rows divided by a length, m.

    It has no units.

    Parameters
    ----------
    H : array_like
        (..., 6, 6), forces in rows 0-2 and moments in rows 3-5.
    length : float
        See ``characteristic_length``; must be > 0.

    Returns
    -------
    ndarray
        Condition numbers, (...).
    """
    return condition_number(moments_over(H, length))


def moments_over(H: ArrayLike, length: float) -> Array:
    """Return H, (..., 6, 6), with its moment rows divided by a length, m; all of it without units then.

    Raises ValueError naming the argument.
    """
    scale = number_in(length, "length", "a finite length > 0 m")
    return np.asarray(shaped_array(H, (6, 6), "H") / np.array([1.0, 1.0, 1.0, scale, scale, scale])[:, None])


def characteristic_length(robot: Robot) -> float:
    """Return the root mean square distance of the platform points from the reference point, m.

    Parameters
    ----------
    robot : Robot
        The machine.

    Returns
    -------
    float
        Length, m.

    Raises
    ------
    ValueError
        For platform points whose squares overflow.
    """
    instance(robot, Robot, "robot")
    length = float(np.sqrt(np.mean(np.sum(robot.p**2, axis=-1))))
    if not np.isfinite(length):
        raise ValueError("robot: expected platform points whose squares are finite")
    return length
