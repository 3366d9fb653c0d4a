"""Condition number of H as a measure of the distance from singular poses, section 4.2."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import instance, number_in, shaped_array
from ..io.array_types import Array
from ..robot.robot import Robot


def condition_number(H: ArrayLike) -> Array:
    """Compute the condition number of H, the ratio of its largest to its smallest singular value.

    Parameters
    ----------
    H : array_like, shape (..., 6, 6)
        Matrix that maps axial leg forces to the wrench.

    Returns
    -------
    ndarray, shape (...)
        Condition numbers (dimensionless). Infinite if H is singular to rounding (smallest singular value at
        most 6 eps times the largest), NaN if H is not finite.

    Raises
    ------
    ValueError
        If H does not have the shape (..., 6, 6).

    See Also
    --------
    scaled_condition_number : Condition number that does not depend on the unit of length.
    wrench_matrix : Compute H.

    Notes
    -----
    This is the number of the paper, section 4.2. It combines dimensionless rows with rows in meters, so it
    depends on the unit of length.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> rest = [0.0, 0.0, 0.0]
    >>> motion = ss.Motion.from_rpy(t=[0.2, 0.1, 1.0], theta=rest, v=rest, theta_dot=rest)
    >>> round(float(ss.condition_number(ss.wrench_matrix(robot, motion))), 1)
    67.4
    """
    H = shaped_array(H, (6, 6), "H")
    finite = np.all(np.isfinite(H), axis=(-2, -1))
    values = np.linalg.svd(np.where(finite[..., None, None], H, 0.0), compute_uv=False)
    largest, smallest = values[..., 0], values[..., -1]
    singular = smallest <= 6.0 * np.finfo(np.float64).eps * largest
    ratio = largest / np.where(singular, 1.0, smallest)
    return np.asarray(np.where(finite, np.where(singular, math.inf, ratio), math.nan))


def scaled_condition_number(H: ArrayLike, length: float) -> Array:
    """Compute the dimensionless condition number of H with its moment rows divided by a length.

    Parameters
    ----------
    H : array_like, shape (..., 6, 6)
        Matrix that maps axial leg forces to the wrench: forces in rows 0-2, moments in rows 3-5.
    length : float
        Positive reference length (m), for example the ``characteristic_length``.

    Returns
    -------
    ndarray, shape (...)
        Condition numbers (dimensionless); infinite or NaN as for ``condition_number``.

    Raises
    ------
    ValueError
        If H does not have the shape (..., 6, 6), or if the length is not finite and positive.

    See Also
    --------
    condition_number : Condition number without scaling.
    characteristic_length : Reference length of a robot.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> rest = [0.0, 0.0, 0.0]
    >>> motion = ss.Motion.from_rpy(t=[0.2, 0.1, 1.0], theta=rest, v=rest, theta_dot=rest)
    >>> H = ss.wrench_matrix(robot, motion)
    >>> round(float(ss.scaled_condition_number(H, ss.characteristic_length(robot))), 1)
    30.0
    """
    return condition_number(moments_over(H, length))


def moments_over(H: ArrayLike, length: float) -> Array:
    """Return H, shape (..., 6, 6), with its moment rows divided by a length (m), so that it is dimensionless.

    Raises ValueError if an argument is invalid.
    """
    scale = number_in(length, "length", "a finite length > 0 m")
    return np.asarray(shaped_array(H, (6, 6), "H") / np.array([1.0, 1.0, 1.0, scale, scale, scale])[:, None])


def characteristic_length(robot: Robot) -> float:
    """Compute the root mean square distance of the platform points from the reference point.

    Parameters
    ----------
    robot : Robot
        Robot geometry.

    Returns
    -------
    float
        Characteristic length (m).

    Raises
    ------
    ValueError
        If the squares of the platform points overflow.

    See Also
    --------
    scaled_condition_number : Condition number that uses this length.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> round(ss.characteristic_length(ss.robots.load("dasgupta1998")), 3)
    0.287
    """
    instance(robot, Robot, "robot")
    length = float(np.sqrt(np.mean(np.sum(robot.p**2, axis=-1))))
    if not np.isfinite(length):
        raise ValueError("robot: expected platform points whose squares are finite")
    return length
