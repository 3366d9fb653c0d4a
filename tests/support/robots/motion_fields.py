"""Fields of a motion, and the vector of a matrix."""

import numpy as np
from numpy.typing import NDArray

from stewart_sym.motion.motion import Motion

FIELDS = ("R", "t", "omega", "v", "alpha", "a", "F_ext", "M_ext")


def skew_part(matrix: NDArray[np.float64]) -> NDArray[np.float64]:
    """The vector whose matrix is the skew part of a matrix, (..., 3)."""
    off = matrix - np.swapaxes(matrix, -1, -2)
    return 0.5 * np.stack([off[..., 2, 1], off[..., 0, 2], off[..., 1, 0]], axis=-1)


def acceleration(motion: Motion) -> NDArray[np.float64]:
    """[a; alpha], (..., 6)."""
    assert motion.a is not None
    assert motion.alpha is not None
    return np.concatenate([motion.a, motion.alpha], axis=-1)
