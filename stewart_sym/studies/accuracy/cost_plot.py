"""Plot and table of speed and accuracy: time per pose over the total error and over the rounding error."""

import itertools
import math
from collections.abc import Callable, Mapping, Sequence, Set
from dataclasses import dataclass
from typing import Any

from ...motion.straight_line import PAPER_PATHS
from ..common import drawing, host
from ..common.drawing import BLUE, RED, Axes, Figure, as_written, legend_line, name_points
from ..common.report import SMALL, Picture, Report
from ..common.text_tables import Figures, csv_text
from .advice import table
from .cost import candidate_of

_EXACT, _PAPER, _FLOAT, _OTHER, _FRONT = BLUE, RED, "#2e7d32", "#5a5a5a", "#9a9a9a"
_MARKERS = "os^vDPX*"
_FILLED: Any = {"markersize": 4.5, "markeredgewidth": 0.0}
_HOLLOW: Any = {"markersize": 4.2, "markeredgewidth": 0.8, "markerfacecolor": "white"}

_LEAST = 1e-17
"""Smallest error that is drawn."""

TOTAL, ROUNDING = "total", "rounding"
Height = Callable[[float], float]


@dataclass(frozen=True)
class Point:
    """Implementation with time (ns) and errors by motion; drawn hollow if it is ``beside`` another point."""

    panel: str
    name: str
    ns: float
    errors: Mapping[str, float]
    color: str
    beside: str = ""

    @property
    def worst(self) -> float:
        """Largest error of all motions."""
        return max(self.errors.values())


def full_report(found: Figures) -> Report:
    """Create the report of ``chart``: the table of all candidates, their data, and the plot."""
    data = {**found, "machine": host.machine(), "software": host.software()}
    picture = Picture(lambda: figure(found), SMALL, ("png", "svg"))
    return Report(table(found), {"chart": csv_rows(found)}, data, {"chart": picture})


def points(found: Figures) -> list[Point]:
    """Return total errors of all levels and precisions, and rounding errors of all implementations."""
    ways = found["implementations"]
    others = [Point(ROUNDING, each["name"], each["ns"], each["rounding"], _OTHER) for each in ways]
    kernels = []
    for entry in (each for each in found["candidates"] if candidate_of(each)[:2] == ("exact", "general")):
        rounding = {name: errors["rounding"] for name, errors in entry["errors"].items()}
        color = _EXACT if entry["precision"] == "double" else _FLOAT
        for kind, ns in (("one pose", entry["one_pose_ns"]), ("batch", entry["batch_ns"])):
            kernels.append(Point(ROUNDING, f"{kind}, {entry['precision']}", ns, rounding, color))
    return [*map(_of_fidelity, found["candidates"]), *kernels, *others]


def _of_fidelity(entry: Figures) -> Point:
    in_double, exact = entry["precision"] == "double", entry["formulation"] == "exact"
    name = entry["fidelity"] if exact else "paper"
    return Point(
        TOTAL,
        name if in_double else f"{name}, {entry['precision']}",
        entry["one_pose_ns"],
        {motion: errors["model"] + errors["rounding"] for motion, errors in entry["errors"].items()},
        (_EXACT if exact else _PAPER) if in_double else _FLOAT,
        "" if in_double else name,
    )


def front(given: Sequence[Point]) -> list[Point]:
    """Return the Pareto front, the fastest point first: no other point is as fast and more accurate."""
    best: list[Point] = []
    for point in sorted(given, key=lambda point: (point.ns, point.worst)):
        if not best or point.worst < best[-1].worst:
            best.append(point)
    return best


def csv_rows(found: Figures) -> str:
    """Format every point and motion of the plot as CSV with all digits."""
    every = points(found)
    best = [point for panel in (TOTAL, ROUNDING) for point in front(_of(every, panel))]
    rows = [
        (point.panel, point.name, point.ns, motion, error, int(point in best))
        for point in every
        for motion, error in point.errors.items()
    ]
    return csv_text([("error", "name", "ns", "motion", "largest", "pareto"), *rows])


def _of(every: Sequence[Point], panel: str) -> list[Point]:
    return [point for point in every if point.panel == panel]


def figure(found: Figures) -> Figure:
    """Draw two panels of the time per pose over the total error and over the rounding error."""
    every = points(found)
    marks = dict(zip(found["motions"], itertools.cycle(_MARKERS), strict=False))
    picture = drawing.new_figure(12.4, 7.8)
    left, right = picture.subplots(1, 2, width_ratios=(1.8, 1.0))
    picture.suptitle(f"Speed against accuracy: {as_written(found['robot'])}")
    left.set_title("error of model and rounding: one pose in C, every fidelity", fontsize="medium")
    right.set_title("error of rounding: exact, general", fontsize="medium")
    left.set_ylabel("largest error, share of the motion's peak force")
    panels = [(axes, _of(every, panel)) for axes, panel in ((left, TOTAL), (right, ROUNDING))]
    for axes, given in panels:
        _draw(axes, given, marks, _heights(given))
    _legend(picture, marks, {point.color for point in every})
    for axes, given in panels:
        height = _heights(given)
        names = [(p.name, (p.ns, height(p.worst)), p.color) for p in given if not p.beside]
        markers = [[(point.ns, height(error)) for error in point.errors.values()] for point in given]
        bars = [(min(of_point), max(of_point)) for of_point in markers]
        name_points(axes, names, [*itertools.chain(*markers)], bars)
    return picture


def _draw(axes: Axes, given: Sequence[Point], marks: Mapping[str, str], height: Height) -> None:
    """Draw the errors of each point, connected by a line across the motions, and the Pareto front."""
    axes.set(xscale="log", yscale="log")
    for point in given:
        heights = {motion: height(error) for motion, error in point.errors.items()}
        ends = min(heights.values()), max(heights.values())
        axes.plot([point.ns, point.ns], ends, color=point.color, linewidth=0.9, alpha=0.45)
        look = _HOLLOW if point.beside else _FILLED
        for motion, y in heights.items():
            axes.plot(point.ns, y, marks[motion], color=point.color, **look)
    named = {point.name: point for point in given}
    for point, other in ((point, named[point.beside]) for point in given if point.beside in named):
        both = [height(point.worst), height(other.worst)]
        axes.plot([point.ns, other.ns], both, ":", color=point.color, linewidth=0.9, alpha=0.7, zorder=1.5)
    corners = [(point.ns, height(point.worst)) for point in front(given)]
    wide: Any = {"color": _FRONT, "linewidth": 4.0, "alpha": 0.35, "solid_joinstyle": "round", "zorder": 1.0}
    axes.step(*zip(*corners, strict=True), where="post", **wide)
    _limits(axes, given, height)
    axes.set_xlabel("time per pose, ns, median")


def _heights(given: Sequence[Point]) -> Height:
    """Return the vertical position of an error; infinite errors are above all others."""
    finite = [error for point in given for error in point.errors.values() if error < math.inf]
    beyond = 10.0 ** (math.ceil(math.log10(max([_LEAST, *finite]))) + 1)
    return lambda error: min(max(error, _LEAST), beyond)


def _limits(axes: Axes, given: Sequence[Point], height: Height) -> None:
    """Set limits with room for the labels, and ticks at decades."""
    from matplotlib.ticker import NullLocator

    times = [point.ns for point in given]
    room = max((max(times) / min(times)) ** 0.2, 1.2)
    axes.set_xlim(min(times) / room, max(times) * room**1.5)
    errors = [error for point in given for error in point.errors.values()]
    heights = [height(error) for error in errors]
    low, high = math.floor(math.log10(min(heights))), math.ceil(math.log10(max(heights)))
    labels = [f"$10^{{{power}}}$" for power in range(low, high + 1)]
    if math.inf in errors:
        labels[-1] = "unsolvable"
    axes.set_yticks([10.0**power for power in range(low, high + 1)], labels)
    axes.yaxis.set_minor_locator(NullLocator())
    axes.set_ylim(10.0 ** (low - 0.7), 10.0 ** (high + 2.3))
    drawing.log_numbers(axes.xaxis)


def _legend(picture: Figure, marks: Mapping[str, str], drawn: Set[str]) -> None:
    dots: Any = {"color": _OTHER, "linestyle": "", "markersize": 5.0}
    colors = {"exact, double": _EXACT, "paper, double": _PAPER, "float": _FLOAT, "other code": _OTHER}
    titles = {name: f"Path {name}" if name in PAPER_PATHS else name for name in marks}
    handles = [
        *(legend_line(titles[name], marker=mark, **dots) for name, mark in marks.items()),
        *(legend_line(name, color=color, linewidth=3.0) for name, color in colors.items() if color in drawn),
        legend_line("the same in float", color=_FLOAT, linestyle=":", marker="o", **_HOLLOW),
        legend_line("Pareto front, worst motion", color=_FRONT, linewidth=4.0, alpha=0.35),
    ]
    drawing.legend_below(picture, handles)
