"""Fields of a motion, motions by coordinates and of several, and the vector of a matrix."""

from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stewart_sym.motion.motion import Motion

FIELDS = ("R", "t", "omega", "v", "alpha", "a", "F_ext", "M_ext")
UNLOADED = FIELDS[:6]


def waves(
    time: NDArray[np.float64], middle: ArrayLike, size: ArrayLike, rate: ArrayLike, phase: ArrayLike
) -> NDArray[np.float64]:
    """Coordinates middle + size sin(rate t + phase) with two derivatives, (3, n, 6)."""
    w, angle = np.asarray(rate), np.multiply.outer(time, rate) + phase
    return np.array([middle + size * np.sin(angle), size * w * np.cos(angle), -size * w**2 * np.sin(angle)])


def motion_of(values: NDArray[np.float64], **loads: ArrayLike) -> Motion:
    """The motion of coordinates with two derivatives, (3, ..., 6)."""
    (t, theta), (v, theta_dot), (a, theta_ddot) = ((x[..., :3], x[..., 3:]) for x in values)
    return Motion.from_rpy(t, theta, v, theta_dot, a, theta_ddot, **loads)


def stacked(motions: Iterable[Motion], names: tuple[str, ...] = FIELDS) -> Motion:
    """Motions of one instant as a batch."""
    every = list(motions)
    return Motion(*(np.stack([getattr(motion, name) for motion in every]) for name in names))


def skew_part(matrix: NDArray[np.float64]) -> NDArray[np.float64]:
    """The vector whose matrix is the skew part of a matrix, (..., 3)."""
    off = matrix - np.swapaxes(matrix, -1, -2)
    return 0.5 * np.stack([off[..., 2, 1], off[..., 0, 2], off[..., 1, 0]], axis=-1)


def acceleration(motion: Motion) -> NDArray[np.float64]:
    """[a; alpha], (..., 6)."""
    assert motion.a is not None
    assert motion.alpha is not None
    return np.concatenate([motion.a, motion.alpha], axis=-1)
