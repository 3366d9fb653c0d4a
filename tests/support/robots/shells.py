"""Exact volume of the common part of six spherical shells above a plane: the oracle of workspace volumes.

At constant orientation leg i keeps its length limits where the reference point lies in a shell about
b_i - R p_i. A plane cuts the shells in rings; the area common to the rings follows from the arcs of their
boundary by Green's theorem, and its integral over the planes from adaptive quadrature.
"""

import itertools

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import quad

Array = NDArray[np.float64]


def shell_volume(centers: Array, radii: Array, floor: float) -> float:
    """Volume, m^3, above z = ``floor`` common to shells about centers (n, 3), radii (n, 2)."""
    low = max(floor, float(np.max(centers[:, 2] - radii[:, 1])))
    high = float(np.min(centers[:, 2] + radii[:, 1]))
    if high <= low:
        return 0.0
    ends = (centers[:, 2:] + np.concatenate([radii, -radii], axis=-1)).ravel()
    breaks = np.unique(np.concatenate([[low, high], ends[(ends > low) & (ends < high)]]))
    parts = [
        quad(lambda z: common_area(centers, radii, z), a, b, epsabs=0.0, epsrel=1e-4, limit=200)[0]
        for a, b in itertools.pairwise(breaks)
    ]
    return float(sum(parts))


def common_area(centers: Array, radii: Array, z: float) -> float:
    """Area common to the rings that the plane at z cuts from the shells, m^2."""
    squares = radii**2 - (z - centers[:, 2:]) ** 2
    circles = [(*c[:2], np.sqrt(outer), 1.0) for c, outer in zip(centers, squares[:, 1], strict=True)]
    circles += [
        (*c[:2], np.sqrt(inner), -1.0) for c, inner in zip(centers, squares[:, 0], strict=True) if inner > 0.0
    ]
    if np.any(squares[:, 1] <= 0.0):
        return 0.0
    x, y, r, side = np.array(circles).T
    return sum(_under(i, x, y, r, side) for i in range(len(x)))


def _under(i: int, x: Array, y: Array, r: Array, side: Array) -> float:
    """Part of circle i in the line integral of (x dy - y dx) / 2 along the boundary."""
    others = np.arange(len(x)) != i
    dx, dy = x[others] - x[i], y[others] - y[i]
    d = np.hypot(dx, dy)
    with np.errstate(all="ignore"):
        cosine = (d**2 + r[i] ** 2 - r[others] ** 2) / (2.0 * d * r[i])
    met = np.abs(cosine) < 1.0
    middle, half = np.arctan2(dy, dx)[met], np.arccos(cosine[met])
    ends = np.sort(np.concatenate([middle - half, middle + half]) % (2.0 * np.pi))
    ends = np.append(ends, ends[0] + 2.0 * np.pi) if ends.size else np.array([0.0, 2.0 * np.pi])
    center = 0.5 * (ends[:-1] + ends[1:])
    distance = np.hypot(
        x[i] + r[i] * np.cos(center)[:, None] - x[others], y[i] + r[i] * np.sin(center)[:, None] - y[others]
    )
    inside = np.all(side[others] * (r[others] - distance) >= 0.0, axis=-1)
    a, b = ends[:-1][inside], ends[1:][inside]
    turn = r[i] ** 2 * (b - a)
    shift = r[i] * (x[i] * (np.sin(b) - np.sin(a)) - y[i] * (np.cos(b) - np.cos(a)))
    return float(side[i] * 0.5 * np.sum(turn + shift))
