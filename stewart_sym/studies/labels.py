"""Labels beside points of a picture that overlap neither each other nor any point.

Used by the pictures that name their points; knows axes and texts, nothing of what they say. Needs the extra
``plot``. The same picture gets the same places on every run.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

Place = tuple[float, float]

ROOM = 2.0
"""Points that stay free around a marker, and above and below a label; there are more at its sides."""

_SIDES = 10.0

_NEAREST, _STEP, _DIRECTIONS = 11.0, 6.0, 24
_TURNS = 8
"""How often at most every label may look for a better place, given those of the others."""

_CROSSING = 80.0
"""Points farther away that a label rather stands than that its line crosses something."""

_FROM_EAST = tuple(2 * math.pi * i / _DIRECTIONS for i in range(_DIRECTIONS))


@dataclass(frozen=True)
class Label:
    """A text for a point of the axes, at data coordinates (x, y)."""

    text: str
    x: float
    y: float
    color: str


@dataclass(frozen=True)
class _Box:
    left: float
    low: float
    right: float
    high: float

    def overlaps(self, other: "_Box") -> bool:
        return (
            self.left < other.right
            and other.left < self.right
            and self.low < other.high
            and other.low < self.high
        )

    def grown(self, by: float) -> "_Box":
        return _Box(self.left - by, self.low - by, self.right + by, self.high + by)

    def grown_to(self, size: Place) -> "_Box":
        across, up = size[0] / 2, size[1] / 2
        return _Box(self.left - across, self.low - up, self.right + across, self.high + up)

    def holds(self, at: Place) -> bool:
        return self.left <= at[0] <= self.right and self.low <= at[1] <= self.high

    def within(self, other: "_Box") -> bool:
        return (
            other.left <= self.left
            and self.right <= other.right
            and other.low <= self.low
            and self.high <= other.high
        )

    def crossed(self, start: Place, end: Place) -> bool:
        """Whether a line runs through it, by clipping the line at its sides."""
        first, last = 0.0, 1.0
        for at, to, low, high in (
            (start[0], end[0], self.left, self.right),
            (start[1], end[1], self.low, self.high),
        ):
            way = to - at
            if way == 0.0:
                if not low < at < high:
                    return False
                continue
            one, other = sorted(((low - at) / way, (high - at) / way))
            first, last = max(first, one), min(last, other)
        return first < last


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
    renderer = FigureCanvasAgg(figure).get_renderer()
    figure.draw_without_rendering()  # type: ignore[no-untyped-call]
    figure.set_layout_engine("none")
    unit = figure.dpi / 72.0
    room = axes.get_window_extent(renderer)
    frame = _Box(room.x0, room.y0, room.x1, room.y1).grown(-ROOM * unit)

    def placed(at: Place) -> Place:
        x, y = axes.transData.transform(at)
        return float(x), float(y)

    points = [placed(marker) for marker in markers]
    taken = tuple(_Box(x, y, x, y).grown((3.0 + ROOM) * unit) for x, y in points)
    drawn = [(placed(start), placed(end)) for start, end in bars]
    at = {label: placed((label.x, label.y)) for label in labels}
    sizes = {label: _size(axes, label, size, renderer) for label in labels}
    placing = _Placing(at, sizes, frame, taken, drawn, unit)
    found = min((placing.settled(order) for order in _orders(at)), key=lambda each: _cost(each.values()))
    return [_annotated(axes, label, at[label], found[label], unit, size) for label in labels]


def _size(axes: Axes, label: Label, size: float, renderer: Any) -> Place:
    text = axes.text(label.x, label.y, label.text, fontsize=size)
    extent = text.get_window_extent(renderer)
    text.remove()
    return extent.width, extent.height


def _orders(at: Mapping[Label, Place]) -> list[list[Label]]:
    """Who chooses first: those with near neighbours, which have the least choice, or from one side on."""

    def crowd(label: Label) -> float:
        return sum(1.0 / (20.0 + math.dist(at[label], place)) for place in at.values())

    keys: tuple[Callable[[Label], float], ...] = (
        lambda label: -round(crowd(label), 6),
        lambda label: at[label][0],
        lambda label: -at[label][0],
        lambda label: at[label][1],
        lambda label: -at[label][1],
    )
    return [sorted(at, key=lambda label: (key(label), label.y, label.x, label.text)) for key in keys]


@dataclass(frozen=True)
class _Choice:
    """Where a label stands: offset of its middle from its point, its box, and what is bad about it."""

    offset: Place
    box: _Box
    cost: float


def _cost(choices: Iterable[_Choice]) -> float:
    return sum(choice.cost for choice in choices)


@dataclass(frozen=True, eq=False)
class _Placing:
    """Labels to place, in pixels: their points, sizes, what is drawn already; ``unit``: pixels a point."""

    at: Mapping[Label, Place]
    sizes: Mapping[Label, Place]
    frame: _Box
    taken: Sequence[_Box]
    drawn: Sequence[tuple[Place, Place]]
    unit: float

    def settled(self, order: Sequence[Label]) -> dict[Label, _Choice]:
        """Everybody's best place given those of the others, chosen by turns until nobody moves."""
        found: dict[Label, _Choice] = {}
        for _ in range(_TURNS):
            before = dict(found)
            for label in order:
                others = {other: choice.box for other, choice in found.items() if other != label}
                found[label] = self._best(label, others)
            if found == before:
                break
        return found

    def _best(self, label: Label, others: Mapping[Label, _Box]) -> _Choice:
        at, size, frame = self.at[label], self.sizes[label], self.frame
        written = [box.grown_to((_SIDES * self.unit, 0.0)) for box in others.values()]
        lines = [
            *self.drawn,
            *((self.at[other], _nearest(box, self.at[other])) for other, box in others.items()),
        ]
        farthest = math.dist((frame.left, frame.low), (frame.right, frame.high))
        best: _Choice | None = None
        for distance, offset in _offsets(size, self.unit, farthest):
            if best is not None and distance >= best.cost:
                break
            middle = at[0] + offset[0], at[1] + offset[1]
            box = _Box(*middle, *middle).grown_to(size)
            free = box.grown(ROOM * self.unit)
            if not box.within(frame) or any(free.overlaps(other) for other in (*self.taken, *written)):
                continue
            crossings = self._crossings(at, _nearest(box, at), free, written, lines)
            cost = distance + _CROSSING * self.unit * crossings
            if best is None or cost < best.cost:
                best = _Choice(offset, box, cost)
        if best is None:
            raise ValueError("labels: expected room for all of them in the picture")
        return best

    def _crossings(
        self,
        at: Place,
        end: Place,
        free: _Box,
        written: Sequence[_Box],
        lines: Sequence[tuple[Place, Place]],
    ) -> int:
        """How often a label's line, from its point to the end, and its box cross what is drawn already."""
        # Markers at its own place are where the line starts.
        others = [box for box in self.taken if not box.holds(at)]
        through = sum(box.crossed(at, end) for box in (*others, *written))
        return through + sum(free.crossed(*line) or _cross(line, (at, end)) for line in lines)


def _offsets(size: Place, unit: float, farthest: float) -> Iterator[tuple[float, Place]]:
    """Distances between point and text, growing, and offsets of the text's middle."""
    width, height = size
    gap = _NEAREST * unit
    while gap < farthest:
        for angle in _FROM_EAST:
            across, up = math.cos(angle), math.sin(angle)
            yield gap, (across * (gap + width / 2), up * (gap + height / 2))
        gap += _STEP * unit


def _nearest(box: _Box, at: Place) -> Place:
    """The point of a box that is nearest to another."""
    return min(max(at[0], box.left), box.right), min(max(at[1], box.low), box.high)


def _cross(one: tuple[Place, Place], other: tuple[Place, Place]) -> bool:
    """Whether two lines cross, ends not counted."""

    def side(line: tuple[Place, Place], at: Place) -> float:
        (x0, y0), (x1, y1) = line
        return (x1 - x0) * (at[1] - y0) - (y1 - y0) * (at[0] - x0)

    return side(one, other[0]) * side(one, other[1]) < 0.0 and side(other, one[0]) * side(other, one[1]) < 0.0


def _annotated(axes: Axes, label: Label, at: Place, choice: _Choice, unit: float, size: float) -> Any:
    box = choice.box
    end = _nearest(box, at)
    line = {
        "arrowstyle": "-",
        "color": label.color,
        "linewidth": 0.6,
        "alpha": 0.7,
        "relpos": ((end[0] - box.left) / (box.right - box.left), (end[1] - box.low) / (box.high - box.low)),
        "shrinkA": 0.0,
        "shrinkB": 2.0,
    }
    return axes.annotate(
        label.text,
        (label.x, label.y),
        (choice.offset[0] / unit, choice.offset[1] / unit),
        textcoords="offset points",
        ha="center",
        va="center",
        fontsize=size,
        color=label.color,
        arrowprops=line,
    )
