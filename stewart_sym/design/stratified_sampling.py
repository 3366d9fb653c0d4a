"""Stratified sampling of the volume of a set with a membership test: grid cells and random points in them.

A box is halved repeatedly, and cells that certainly contain no member are discarded. Each remaining cell
contains two independent random points. Half the number of points inside the set is an unbiased estimate of
its volume in cells. A quarter of the number of cells with one point inside is an unbiased estimate of the
variance. Both counts are integers, so they do not depend on the order or place of the computation.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..io.array_types import Array, Flags

DEVIATIONS = 3.0
"""Number of standard deviations in the error of the estimate, which contain 99.7 % of the estimates."""

JOB = 32_768
"""Number of cells per job."""

MOST_KEPT = 1 << 19
"""Largest number of cells that are tested individually; for more points, each cell is divided evenly."""

# Largest number of halvings; a set with only few cells after them has a negligible volume.
_MOST_HALVINGS = 120

Places = NDArray[np.int64]


class Cells(NamedTuple):
    """Cells of a grid over a box (d, 2) that may contain members: indices (n, d), and parts per axis."""

    box: Array
    counts: tuple[int, ...]
    places: Places
    splits: tuple[int, ...]

    @property
    def sides(self) -> Array:
        """Side lengths of the cells with two points each, shape (d,)."""
        widths = self.box[:, 1] - self.box[:, 0]
        return np.asarray(widths / (np.array(self.counts, dtype=np.float64) * self.splits))


class Tally(NamedTuple):
    """Counts of the points of some cells: by code, mixed pairs, extent (d, 2), and nearest point outside."""

    codes: NDArray[np.int64]
    mixed: int
    extent: Array
    nearest: float


Job = tuple[Cells, tuple[int, int]]
"""Cells and their random seed."""

Examine = Callable[[Array], tuple[NDArray[np.int8], Array]]
"""Function from coordinates (n, d) to codes (n,) and distances (n,) from the center pose."""


def cells_of(box: Array, points: int, weights: Array, empty: Callable[[Array, Array], Flags]) -> Cells:
    """Divide a box, shape (d, 2), into cells for at most ``points`` points.

    ``weights``, shape (d,), are the lengths per unit of each coordinate; the longest side is halved.
    ``empty`` maps the lower and upper bounds of cells, (n, d) each, to flags of the cells that certainly
    contain no member, (n,).
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
    """Divide the cells into jobs, independent of the scheduler."""
    step = max(1, JOB // math.prod(cells.splits))
    parts = [cells.places[first : first + step] for first in range(0, len(cells.places), step)]
    return [(cells._replace(places=part), (seed, number)) for number, part in enumerate(parts)]


def tally(job: Job, examine: Examine, codes: int) -> Tally:
    """Examine two points in each cell of a job; ``codes`` is the number of codes."""
    cells, seed = job
    within = np.array(list(itertools.product(*map(range, cells.splits))), dtype=np.int64)
    places = (cells.places[:, None] * np.array(cells.splits) + within).reshape(-1, len(cells.box))
    shares = np.random.default_rng(seed).random((2, *places.shape))
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
    """Return the sum of tallies; an empty tally if there are none."""
    none = Tally(
        np.zeros(codes, dtype=np.int64), 0, np.tile([math.inf, -math.inf], (dimensions, 1)), math.inf
    )
    counts, mixed, extents, nearest = zip(none, *tallies, strict=True)
    low, high = np.min(extents, axis=0)[:, 0], np.max(extents, axis=0)[:, 1]
    return Tally(np.sum(counts, axis=0), sum(mixed), np.stack([low, high], axis=-1), min(nearest))


def volume(cells: Cells, found: Tally) -> tuple[float, float]:
    """Return the volume and its error in the unit of the product of the coordinates.

    The error is at least three cells, because a smaller set contains no point with a probability of 0.25 % or
    more, however it is distributed. The error is 0 if no cell may contain a member.
    """
    cell = float(np.prod(cells.sides))
    least = DEVIATIONS if len(cells.places) else 0.0
    error = max(0.5 * DEVIATIONS * math.sqrt(found.mixed), least)
    return 0.5 * cell * int(found.codes[0]), cell * error
