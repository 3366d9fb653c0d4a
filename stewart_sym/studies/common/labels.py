"""Labels beside points of a picture that overlap neither each other nor any point.

Used by the pictures that name their points. Needs the extra ``plot``. The same picture gets the same places
on every run.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...io.extras import needed_for

with needed_for("drawing"):
    from matplotlib.axes import Axes
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

Array = NDArray[np.float64]
Bools = NDArray[np.bool_]
Place = tuple[float, float]

MARKER, ROOM, SIDES = 3.0, 4.0, 12.0
"""Points (1/72 inch) from the middle of a marker to its edge; around markers and labels that stay free; and
that stay free at both sides of a label."""

_NEAREST, _FARTHER, _DISTANCES, _DIRECTIONS = 11.0, 1.15, 32, 24
"""Distance between point and label, points, the ratio from one to the next, how many, and directions."""

_CROSSING = 80.0
"""Points farther away that a label rather stands than that its line crosses something."""

_TURNS = 6
"""How often at most every label may look for a better place, given those of the others."""


@dataclass(frozen=True)
class Label:
    """A text for a point of the axes, at data coordinates (x, y)."""

    text: str
    x: float
    y: float
    color: str


@dataclass(frozen=True)
class _Choice:
    """Where a label stands, in pixels: its middle, its line, from point to box, (4,), and what is bad."""

    middle: Array
    box: Array
    line: Array
    cost: float


def place(
    axes: Axes,
    labels: Sequence[Label],
    markers: Sequence[Place],
    bars: Sequence[tuple[Place, Place]] = (),
    size: float = 7.5,
) -> list[Any]:
    """Write every label near its point, with a thin line to it; returns the annotations.

    markers: data coordinates of everything that is drawn as a point; labels keep off them. bars: ends of
    drawn lines, from which they keep off if they can. size: of the font. The layout of the figure is fixed
    from here on. Raises ValueError if there is no room.
    """
    figure = axes.get_figure()
    assert isinstance(figure, Figure)
    renderer = FigureCanvasAgg(figure).get_renderer()  # type: ignore[no-untyped-call]
    figure.draw_without_rendering()
    figure.set_layout_engine("none")
    unit = figure.dpi / 72.0
    room = axes.get_window_extent(renderer)
    points = axes.transData.transform(np.reshape(markers, (-1, 2)))
    placing = _Placing(
        at=axes.transData.transform([(label.x, label.y) for label in labels]),
        sizes=np.array([_size(axes, label, size, renderer) for label in labels]),
        frame=_grown(np.array([room.x0, room.y0, room.x1, room.y1]), -SIDES * unit),
        taken=_grown(np.hstack([points, points]), (MARKER + ROOM) * unit),
        bars=axes.transData.transform(np.reshape(bars, (-1, 2))).reshape(-1, 4),
        unit=unit,
    )
    settled = [placing.settled(order) for order in placing.orders()]
    best = min(settled, key=lambda found: sum(choice.cost for choice in found.values()))
    return [_annotated(axes, label, placing.at[i], best[i], unit, size) for i, label in enumerate(labels)]


def _size(axes: Axes, label: Label, size: float, renderer: Any) -> Place:
    text = axes.text(label.x, label.y, label.text, fontsize=size)
    extent = text.get_window_extent(renderer)
    text.remove()
    return extent.width, extent.height


@dataclass(frozen=True, eq=False)
class _Placing:
    """Labels to place, in pixels: their points and sizes, (n, 2), and what is drawn already.

    frame (4,), taken (m, 4): boxes as left, low, right, high; bars (k, 4): lines as both ends. unit: pixels
    of a point.
    """

    at: Array
    sizes: Array
    frame: Array
    taken: Array
    bars: Array
    unit: float

    def orders(self) -> list[list[int]]:
        """Who chooses first: those with near neighbours, which have the least choice, or from one side on."""
        apart = np.linalg.norm(self.at[:, None] - self.at, axis=-1)
        crowd = np.sum(1.0 / (20.0 * self.unit + apart), axis=-1).round(6)
        x, y = self.at.T
        return [np.lexsort((y, x, key)).tolist() for key in (-crowd, x, -x, y, -y)]

    def settled(self, order: Sequence[int]) -> dict[int, _Choice]:
        """Everybody's best place given those of the others, chosen by turns until nobody moves."""
        found: dict[int, _Choice] = {}
        for _ in range(_TURNS):
            before = {i: choice.middle.tolist() for i, choice in found.items()}
            for i in order:
                found[i] = self._best(i, {j: choice for j, choice in found.items() if j != i})
            if before == {i: choice.middle.tolist() for i, choice in found.items()}:
                break
        return found

    def _best(self, i: int, others: Mapping[int, _Choice]) -> _Choice:
        at, size = self.at[i], self.sizes[i]
        distance, offsets = _around(size, self.unit)
        written = np.array([choice.box for choice in others.values()]).reshape(-1, 4)
        taken = np.vstack([self.taken, written + self.unit * np.array([-SIDES, 0.0, SIDES, 0.0])])
        # Markers at its own place are where its line starts.
        foreign = np.vstack([self.taken[~_within(np.hstack([at, at]), self.taken)], written])
        lines = np.vstack([self.bars, *(choice.line for choice in others.values())])
        best: _Choice | None = None
        for nearest in range(0, len(distance), _DIRECTIONS):
            # No place costs less than its distance.
            if best is not None and distance[nearest] >= best.cost:
                break
            ring = slice(nearest, nearest + _DIRECTIONS)
            middle = at + offsets[ring]
            boxes = np.hstack([middle - size / 2, middle + size / 2])
            free = _grown(boxes, ROOM * self.unit)
            fits = _within(boxes, self.frame) & ~_overlap(free, taken).any(axis=-1)
            if not fits.any():
                continue
            middle, boxes, free = middle[fits], boxes[fits], free[fits]
            own = np.hstack([np.broadcast_to(at, middle.shape), np.clip(at, boxes[:, :2], boxes[:, 2:])])
            crossings = _crossed(own[:, None], foreign).sum(axis=-1)
            crossings += (_crossed(lines, free[:, None]) | _cross(own[:, None], lines)).sum(axis=-1)
            cost = distance[ring][fits] + _CROSSING * self.unit * crossings
            first = int(np.argmin(cost))
            if best is None or cost[first] < best.cost:
                best = _Choice(middle[first], boxes[first], own[first], float(cost[first]))
        if best is None:
            raise ValueError("labels: expected room for all of them in the picture")
        return best


def _around(size: Array, unit: float) -> tuple[Array, Array]:
    """Distances of a label's box from its point, (n,), rising, and offsets of its middle, (n, 2)."""
    distances = _NEAREST * unit * _FARTHER ** np.arange(_DISTANCES)
    angles = 2 * np.pi * np.arange(_DIRECTIONS) / _DIRECTIONS
    gap = np.repeat(distances, _DIRECTIONS)[:, None]
    direction = np.tile(np.stack([np.cos(angles), np.sin(angles)], axis=-1), (_DISTANCES, 1))
    return gap[:, 0], direction * (gap + size / 2)


# --- boxes, (..., 4): left, low, right, high; lines, (..., 4): both ends ----------------------


def _grown(boxes: Array, by: float) -> Array:
    return boxes + by * np.array([-1.0, -1.0, 1.0, 1.0])


def _within(boxes: Array, frame: Array) -> Bools:
    inside: Bools = np.all((boxes[..., :2] >= frame[..., :2]) & (boxes[..., 2:] <= frame[..., 2:]), axis=-1)
    return inside


def _overlap(boxes: Array, others: Array) -> Bools:
    """Whether each of the boxes, (n, 4), overlaps each of the others, (m, 4): (n, m)."""
    one, other = boxes[:, None], others
    overlap: Bools = np.all((one[..., :2] < other[..., 2:]) & (other[..., :2] < one[..., 2:]), axis=-1)
    return overlap


def _crossed(lines: Array, boxes: Array) -> Bools:
    """Whether lines run through boxes, by clipping them at the boxes' sides."""
    start, way = lines[..., :2], lines[..., 2:] - lines[..., :2]
    # A line along a side is turned by as little as doesn't show.
    way = np.where(way == 0.0, 1e-9, way)
    one, other = (boxes[..., :2] - start) / way, (boxes[..., 2:] - start) / way
    enters = np.max(np.minimum(one, other), axis=-1)
    leaves = np.min(np.maximum(one, other), axis=-1)
    crossed: Bools = np.maximum(enters, 0.0) < np.minimum(leaves, 1.0)
    return crossed


def _cross(lines: Array, others: Array) -> Bools:
    """Whether lines cross, ends not counted."""

    def sides(line: Array, ends: Array) -> Array:
        way = line[..., 2:] - line[..., :2]
        first, last = (ends[..., k : k + 2] - line[..., :2] for k in (0, 2))
        turn = [way[..., 0] * to[..., 1] - way[..., 1] * to[..., 0] for to in (first, last)]
        return np.asarray(turn[0] * turn[1])

    crossing: Bools = (sides(lines, others) < 0.0) & (sides(others, lines) < 0.0)
    return crossing


def _annotated(axes: Axes, label: Label, at: Array, choice: _Choice, unit: float, size: float) -> Any:
    box = choice.box
    line = {
        "arrowstyle": "-",
        "color": label.color,
        "linewidth": 0.6,
        "alpha": 0.7,
        "relpos": tuple((choice.line[2:] - box[:2]) / (box[2:] - box[:2])),
        "shrinkA": 0.0,
        "shrinkB": 2.0,
    }
    return axes.annotate(
        label.text,
        (label.x, label.y),
        tuple((choice.middle - at) / unit),
        textcoords="offset points",
        ha="center",
        va="center",
        fontsize=size,
        color=label.color,
        arrowprops=line,
    )
