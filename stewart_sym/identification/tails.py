"""Tails of the distributions by which fits are tested."""

import math

import numpy as np

from ..io.array_types import Array


def tail(ratio: float, freedom: float, other: float = math.inf) -> float:
    """Probability of an F ratio above this one; chi-square over its freedom if ``other`` is infinite.

    Paulson's normal approximation of its cube root, right to some per cent of the probability from 10 degrees
    of freedom on, to a sixth from 4 on.
    """
    a, b = 2.0 / (9.0 * freedom), 2.0 / (9.0 * other)
    root = math.cbrt(ratio)
    return 0.5 * math.erfc(((1.0 - b) * root - (1.0 - a)) / math.sqrt(2.0 * (b * root**2 + a)))


def departure(off: Array, covariance: Array) -> tuple[Array, float]:
    """Differences (n,) of a covariance in their deviations, and the probability of ones so far from 0."""
    sigma = np.sqrt(np.diagonal(covariance))
    scaled = off / sigma
    squares = float(scaled @ np.linalg.solve(covariance / np.outer(sigma, sigma), scaled))
    return scaled, tail(squares / len(off), len(off))
