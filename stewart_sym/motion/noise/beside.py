"""What is off in a smooth curve besides noise: jumps that it rounds off, joints of windows."""

import math

import numpy as np

from ...io.array_types import Array
from ..interpolation import DEGREE, along, b_splines, places

PAIRS = ((0, 0), (1, 0), (1, 1), (2, 0), (2, 1), (2, 2))
"""Entries of a covariance: pairs of value, 0, rate, 1, and second rate, 2."""


def beside_noise(coefficients: Array, resolved: Array, apart: Array, step: float) -> Array:
    """Covariance at every half cell, (g, c, 6), that jumps of second rates and joints of windows add.

    Where a second rate that may jump seems to rise, anything between what it is before and after is as
    likely. resolved: cells over which a jump becomes a ramp, (g, c); 0 where none is likely. apart: mean of
    the windows' own values, rates and second rates, (3, g, c), from which the joined curve differs.
    """
    grid = np.arange(len(resolved)) / 2.0
    cell, u = places(grid, 1.0, len(coefficients) - DEGREE)
    joined = np.stack([along(b_splines(u, DEGREE, i), cell, coefficients) / step**i for i in range(3)])
    joints, ramps = joined - apart, np.zeros(apart.shape)
    for i, ramp in enumerate(resolved.T):
        before, after = (np.interp(grid + side * ramp, grid, joined[2, :, i]) for side in (-1.0, 1.0))
        ramps[2, :, i] = (after - before) / math.sqrt(12.0)
    ramps[1] = 0.25 * step * resolved * ramps[2]
    return np.stack([ramps[i] * ramps[j] + joints[i] * joints[j] for i, j in PAIRS], axis=-1)
