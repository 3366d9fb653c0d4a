"""Fields of a motion."""

import numpy as np
from numpy.typing import NDArray

from stewart_sym.motion.motion import Motion

FIELDS = ("R", "t", "omega", "v", "alpha", "a", "F_ext", "M_ext")


def acceleration(motion: Motion) -> NDArray[np.float64]:
    """[a; alpha], (..., 6)."""
    assert motion.a is not None
    assert motion.alpha is not None
    return np.concatenate([motion.a, motion.alpha], axis=-1)
