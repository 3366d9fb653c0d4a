"""Volume of a set given by a test of membership: cells that may hold members, and random points in them.

A box is halved again and again and what surely holds no member is left out. In each cell that is left lie
two independent random points: half the sum of both is an unbiased estimate of the cell's share, and the
number of cells where one point is inside and the other is not, over four, one of the variance. Both are whole
numbers, the same whoever counts them and in whatever order.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..io.array_types import Array, Flags

DEVIATIONS = 3.0
"""Standard deviations of the estimate that its error is given as: 99.7 % of estimates are nearer."""

JOB = 32_768
"""Cells that are examined in one job."""

MOST_KEPT = 1 << 19
"""Cells that are looked at one by one; where more points are wanted, each is divided evenly."""

# A set so thin that so many halvings leave few cells of it has no volume to speak of.
_MOST_HALVINGS = 120

Places = NDArray[np.int64]


class Cells(NamedTuple):
    """Cells of a grid that may hold members.

    box: low and high, (d, 2). counts: into how many cells each side is divided, (d,). places: which cells,
    counted along each axis, (n, d). splits: into how many each of these is divided once more, (d,).
    """

    box: Array
    counts: tuple[int, ...]
    places: Places
    splits: tuple[int, ...]

    @property
    def sides(self) -> Array:
        """Sides of the cells with two points each, (d,)."""
        widths = self.box[:, 1] - self.box[:, 0]
        return np.asarray(widths / (np.array(self.counts, dtype=np.float64) * self.splits))


class Job(NamedTuple):
    """Some cells, and the numbers that random points are drawn from."""

    cells: Cells
    seed: tuple[int, int]


@dataclass(frozen=True, eq=False)
class Tally:
    """What was found at the points of some cells.

    codes: how often each code was found, (m,); 0 is inside. mixed: cells with one point inside. extent: least
    and greatest coordinates of points inside, (d, 2), inf and -inf where there are none. nearest: least
    distance of a point that is not inside.
    """

    codes: NDArray[np.int64]
    mixed: int
    extent: Array
    nearest: float

    def plus(self, other: Tally) -> Tally:
        """Both together."""
        (low, high), (other_low, other_high) = self.extent.T, other.extent.T
        extent = np.stack([np.minimum(low, other_low), np.maximum(high, other_high)], axis=-1)
        codes = self.codes + other.codes
        return Tally(codes, self.mixed + other.mixed, extent, min(self.nearest, other.nearest))


Examine = Callable[[Array], tuple[NDArray[np.int8], Array]]
"""From coordinates (n, d) to codes (n,) and distances (n,) from the pose that ``nearest`` is about."""


def cells_of(box: Array, points: int, weights: Array, empty: Callable[[Array, Array], Flags]) -> Cells:
    """Cells of a box (d, 2) for so many points at most.

    weights: lengths that a unit of each coordinate is worth, (d,): the side that is worth most is halved.
    empty: from least and greatest coordinates of cells, (n, d) each, to which surely hold no member, (n,).
    """
    most = max(1, min(points // 2, MOST_KEPT))
    counts, places = [1] * len(box), np.zeros((1, len(box)), dtype=np.int64)
    widths = (box[:, 1] - box[:, 0]) * weights
    for _ in range(_MOST_HALVINGS):
        if not 0 < 2 * len(places) <= most:
            break
        axis = int(np.argmax(widths / counts))
        counts[axis] *= 2
        places[:, axis] *= 2
        other = places.copy()
        other[:, axis] += 1
        places = np.concatenate([places, other])
        corners = box[:, 0] + np.stack([places, places + 1]) * (box[:, 1] - box[:, 0]) / counts
        places = places[~empty(*corners)]
    splits = [1] * len(box)
    while 4 * math.prod(splits) * len(places) <= points and len(places):
        splits[int(np.argmax(widths / (np.array(counts) * splits)))] *= 2
    return Cells(box, tuple(counts), places, tuple(splits))


def jobs_of(cells: Cells, seed: int) -> list[Job]:
    """Parts of the cells, the same whoever examines them."""
    step = max(1, JOB // math.prod(cells.splits))
    parts = [cells.places[first : first + step] for first in range(0, len(cells.places), step)]
    return [Job(cells._replace(places=part), (seed, number)) for number, part in enumerate(parts)]


def tally(job: Job, examine: Examine, codes: int) -> Tally:
    """Examine two points in each of the job's cells; ``status_codes``: how many there are."""
    cells = job.cells
    within = np.array(list(itertools.product(*map(range, cells.splits))), dtype=np.int64)
    places = (cells.places[:, None] * np.array(cells.splits) + within).reshape(-1, len(cells.box))
    shares = np.random.default_rng(job.seed).random((2, *places.shape))
    points = (cells.box[:, 0] + (places + shares) * cells.sides).reshape(-1, len(cells.box))
    found, distances = examine(points)
    inside = found == 0
    one, other = inside.reshape(2, -1)
    low = np.min(points[inside], axis=0, initial=math.inf)
    high = np.max(points[inside], axis=0, initial=-math.inf)
    return Tally(
        np.bincount(found, minlength=codes),
        int(np.count_nonzero(one != other)),
        np.stack([low, high], axis=-1),
        float(np.min(distances[~inside], initial=math.inf)),
    )


def total(tallies: Sequence[Tally], dimensions: int, codes: int) -> Tally:
    """All together; nothing was found where there is none."""
    none = np.tile([math.inf, -math.inf], (dimensions, 1))
    start = Tally(np.zeros(codes, dtype=np.int64), 0, none, math.inf)
    return functools.reduce(Tally.plus, tallies, start)


def volume(cells: Cells, found: Tally) -> tuple[float, float]:
    """Volume and its error, in the unit of the coordinates' product.

    What is smaller than three cells holds no point with a chance of 0.25 % or more, however it is spread: the
    error is that at least, unless no cell may hold a member.
    """
    cell = float(np.prod(cells.sides))
    least = DEVIATIONS if len(cells.places) else 0.0
    error = max(0.5 * DEVIATIONS * math.sqrt(found.mixed), least)
    return 0.5 * cell * int(found.codes[0]), cell * error
