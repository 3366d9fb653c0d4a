"""Machines that are singular at every pose: families of points with integer coordinates.

Coordinates are integers below 2^24 times a power of two, which are exact in double and float. Thus det H is
exactly 0 for the stored numbers and every matrix R. Every family is closed under affine maps of base and
platform: each machine receives a random map of each, and similar hexagons receive the same map for both.
"""

import dataclasses
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from ...io.array_types import Array
from ...robot.robot import Robot
from .machines import LEGS, random_machine

Whole = NDArray[np.int64]
Points = tuple[Whole, Whole]

_GRID = 64
"""Half the width of the grid of the points."""
_FINE = 10
"""Number of bits by which the grid is finer for nearly equal legs."""
_CIRCLE = np.array(
    sorted(
        ((x, y, 0) for x in range(-65, 66) for y in range(-65, 66) if x * x + y * y == 65 * 65),
        key=lambda point: np.arctan2(point[1], point[0]),
    )
)
"""The 36 grid points on the circle of radius 65, in order."""


def singular_machine(
    rng: np.random.Generator, family: str, size: float = 1.0, mass: float = 10.0, legs: str = LEGS[0]
) -> Robot:
    """Generate a random machine of a family of ``FAMILIES``; other arguments as in ``random_machine``."""
    base, platform = FAMILIES[family](rng)
    fine, order = 2**_FINE if family in NEARLY else 1, rng.permutation(6)
    map_b = _map(rng)
    map_p = map_b if family in ("similar hexagons", "equal hexagons") else _map(rng)
    b, p = base[order] @ map_b + fine * rng.integers(-_GRID, _GRID, 3), platform[order] @ map_p
    grain = float(2.0 ** np.round(np.log2(size / (32 * _GRID)))) / fine
    # The reference point is nearby. The platform is smaller than the base except for equal hexagons.
    b, p = (b, p) if family == "equal hexagons" else (2 * b, p + fine * rng.integers(-_GRID, _GRID, 3))
    machine = random_machine(rng, size, mass, legs)
    points: list[Array] = [grain * each.astype(np.float64) for each in (b, p)]
    if family in NEARLY:
        # Some legs are longer; legs with a common base point have the same factor.
        alike = np.unique(b, axis=0, return_inverse=True)[1].ravel()
        points[0] *= 2.0 ** (rng.integers(14) * rng.integers(2, size=6)[alike, None])
    return dataclasses.replace(machine, b=points[0], p=points[1], name=family)


def _map(rng: np.random.Generator) -> Whole:
    """Generate a regular integer linear map, 16 times an approximate rotation."""
    while True:
        frame = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        A = np.round(16 * frame + 2 * rng.normal(size=(3, 3))).astype(np.int64)
        if abs(np.linalg.det(A)) > 16**2:
            return np.asarray(A)


def _any(rng: np.random.Generator) -> Whole:
    """Generate six different points near a ring."""
    turn = 2 * np.pi * (np.arange(6) + rng.uniform(-0.3, 0.3, 6)) / 6
    ring = np.column_stack([np.cos(turn), np.sin(turn), 0.25 * rng.normal(size=6)])
    return np.asarray(np.round(_GRID * ring), dtype=np.int64)


def _with(rng: np.random.Generator, *first: Whole) -> Whole:
    """Combine given points with further points near a ring."""
    given = np.concatenate(first)
    return np.concatenate([given, _any(rng)[len(given) :]])


def _point(rng: np.random.Generator, count: int) -> Whole:
    """Repeat one point ``count`` times."""
    return np.repeat(_any(rng)[:1], count, axis=0)


def _line(rng: np.random.Generator, count: int) -> Whole:
    """Generate ``count`` points of one line."""
    along = rng.choice(np.arange(-12, 13), count, replace=False)
    return np.asarray(along[:, None] * np.array([5, 0, 0]) + rng.integers(-32, 32, 3), dtype=np.int64)


def _conic(rng: np.random.Generator) -> Whole:
    """Generate six points of a parabola."""
    x = rng.choice(np.arange(-8, 9), 6, replace=False)
    return np.column_stack([8 * x, x * x - 32, np.zeros(6, dtype=np.int64)])


def _circle(rng: np.random.Generator) -> Whole:
    """Select a hexagon on a circle with one point in each sixth."""
    return np.asarray(_CIRCLE[6 * np.arange(6) + rng.integers(0, 6, 6)])


def _point_and_line(rng: np.random.Generator) -> Points:
    pair = _with(rng, _point(rng, 3)), _with(rng, _line(rng, 3))
    return pair if rng.random() < 0.5 else pair[::-1]


def _regulus(rng: np.random.Generator) -> Points:
    line = _line(rng, 4)
    return _with(rng, line), _with(rng, line)


def _nearly_alike(rng: np.random.Generator, points: Points, groups: tuple[tuple[int, ...], ...]) -> Points:
    """Move points to the finer grid, and the legs of each group near its first leg."""
    base, platform = (2**_FINE * each for each in points)
    for first, *others in groups:
        shared = rng.uniform(0, _FINE)
        for leg in others:
            # The legs of a group have a common distance, or each leg has its own.
            degree = shared if rng.random() < 0.5 else rng.uniform(0, _FINE)
            reach = int(_GRID * 2 ** (_FINE - degree))
            for end in (base, platform):
                end[leg] = end[first] + rng.integers(-reach, reach + 1, 3) // 2
    return base, platform


def _also_nearly(*groups: tuple[int, ...]) -> Callable[[np.random.Generator], Points]:
    """Return a generator of machines whose legs 0 and 1 are equal, with groups of nearly equal legs."""

    def points(rng: np.random.Generator) -> Points:
        base, platform = _nearly_alike(rng, (_any(rng), _any(rng)), groups)
        base[1], platform[1] = base[0], platform[0]
        return base, platform

    return points


NEARLY: dict[str, Callable[[np.random.Generator], Points]] = {
    "two legs alike, two nearly": _also_nearly((2, 3)),
    "two legs alike, two pairs nearly": _also_nearly((2, 3), (4, 5)),
    "two legs alike, four nearly": _also_nearly((2, 3, 4, 5)),
    "two legs alike, one beside them": _also_nearly((0, 2)),
    "two legs alike, three beside them": _also_nearly((0, 2, 3, 4)),
    "four legs from one base point, two nearly alike": lambda rng: _nearly_alike(
        rng, (_with(rng, _point(rng, 4)), _any(rng)), ((4, 5),)
    ),
}
"""Families that are singular for one reason and nearly singular for others, to any degree within 24 bits."""

FAMILIES: dict[str, Callable[[np.random.Generator], Points]] = {
    # All legs meet this line.
    "base points on one line": lambda rng: (_line(rng, 6), _any(rng)),
    "platform points on one line": lambda rng: (_any(rng), _line(rng, 6)),
    # Lines through one point have rank 3.
    "four legs from one base point": lambda rng: (_with(rng, _point(rng, 4)), _any(rng)),
    "four legs to one platform point": lambda rng: (_any(rng), _with(rng, _point(rng, 4))),
    # All legs meet the line through both points.
    "three legs from one point, three to one": lambda rng: (
        _with(rng, _point(rng, 3)),
        _with(rng, _point(rng, 3))[::-1],
    ),
    # A plane pencil has rank 2.
    "three legs between a point and a line": _point_and_line,
    # Lines that join corresponding points of two lines have rank 3, lines that meet two lines rank 4.
    "four legs of a regulus": _regulus,
    "five legs between two lines": lambda rng: (_with(rng, _line(rng, 5)), _with(rng, _line(rng, 5))),
    "two legs alike": lambda rng: (_with(rng, _point(rng, 2)), _with(rng, _point(rng, 2))),
    # Lines that join corresponding points of affine planes are linear in (1, x, y, x^2, x y, y^2), which six
    # points of a conic make dependent (Husty and Karger, 2000).
    "a conic and its affine image": lambda rng: (_conic(rng),) * 2,
    "similar hexagons": lambda rng: (_circle(rng),) * 2,
    # Without rotation all legs are parallel.
    "equal hexagons": lambda rng: (_circle(rng),) * 2,
    **NEARLY,
}
"""Base and platform points by family, before the affine maps; comments give the reasons."""
