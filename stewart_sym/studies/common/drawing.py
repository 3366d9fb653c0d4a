"""What pictures share: empty figures, colors, legends, names of points, numbers of logarithmic axes.

Matplotlib, of the extra ``plot``, is imported when something is drawn: modules that draw import without it.
"""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ...io.extras import needed_for
from ...robot.robot import Robot

if TYPE_CHECKING:
    from matplotlib.axes import Axes as Axes
    from matplotlib.axis import Axis as Axis
    from matplotlib.figure import Figure as Figure
else:
    Axes = Axis = Figure = Any

BLUE, RED, DARK, GREY = "#1f4e9c", "#c1440e", "#3a3a3a", "#8a8a8a"
LEG_COLORS = (BLUE, RED, "#2e7d4f", "#8e5ea2", "#b8860b", DARK)

Place = tuple[float, float]
"""Data coordinates (x, y)."""

Z_DOWN = (2, True)
"""What ``vertical`` returns of a machine whose z axis points down."""

_DECADES = 2.0
"""An axis over fewer decades also has ticks between the powers of ten, and all are plain numbers."""
_MARGIN = 0.02
"""Share of the figure's width that stays free beside a legend."""
_ALONG_Z = 0.5
"""Gravity acts along z if at least this share of it does."""


def new_figure(width: float, height: float) -> Figure:
    """An empty figure, inches; MissingExtraError without Matplotlib."""
    with needed_for("drawing"):
        from matplotlib import figure
    return figure.Figure(figsize=(width, height), layout="constrained")


def legend_line(label: str, **style: Any) -> Any:
    """A line for legends, in the style of ``Line2D``."""
    from matplotlib.lines import Line2D

    return Line2D([], [], label=label, **style)


def as_written(name: str) -> str:
    """A name that others chose, such as a robot's, for Matplotlib: no dollar sign in it begins a formula."""
    return name.replace("$", r"\$")


def legend_below(figure: Figure, handles: list[Any] | None = None, **style: Any) -> None:
    """A legend of the handles, or of the labeled curves of all axes once each, in as many columns as fit."""
    if handles is None:
        found = [axes.get_legend_handles_labels() for axes in figure.axes]
        named = {label: one for ones, labels in found for one, label in zip(ones, labels, strict=True)}
    else:
        named = {one.get_label(): one for one in handles}
    for columns in range(len(named), 0, -1):
        legend = figure.legend(
            list(named.values()),
            list(named),
            loc="outside lower center",
            ncols=columns,
            frameon=False,
            **style,
        )
        if legend.get_window_extent().width <= (1.0 - _MARGIN) * figure.bbox.width:
            return
        if columns > 1:
            legend.remove()


def name_points(
    axes: Axes,
    names: Sequence[tuple[str, Place, str]],
    markers: Sequence[Place],
    bars: Sequence[tuple[Place, Place]] = (),
    size: float = 7.5,
) -> None:
    """Write names, each with its point and color, beside the points, with thin lines to them.

    markers: everything that is drawn as a point; names keep off them. bars: ends of drawn lines, from which
    they keep off as well. size: of the font. The layout of the figure is fixed from here on. Raises
    ValueError if there is no room.
    """
    with needed_for("drawing"):
        import textalloc
    figure: Any = axes.get_figure()
    figure.draw_without_rendering()
    figure.set_layout_engine("none")
    # Its type hints do not say what may be None.
    allocate: Any = textalloc.allocate
    texts, at, colors = zip(*names, strict=True)
    # The order in which names choose their places matters: the given one first, then others.
    for clear, order in [(True, None), *((clear, order) for clear in (True, False) for order in range(4))]:
        *_, written, lines = allocate(
            axes,
            *zip(*at, strict=True),
            texts,
            x_scatter=[x for x, _ in markers],
            y_scatter=[y for _, y in markers],
            x_lines=[[start[0], end[0]] for start, end in bars],
            y_lines=[[start[1], end[1]] for start, end in bars],
            avoid_label_lines_overlap=clear,
            priority_strategy=order,
            draw_all=False,
            textsize=size,
            textcolor=colors,
            linecolor=colors,
            linewidth=0.6,
            margin=0.006,
            max_distance=0.4,
            nbr_candidates=400,
        )
        if None not in written:
            return
        for drawn in (*written, *lines):
            if drawn is not None:
                drawn.remove()
    raise ValueError("names of points: expected room for all of them in the picture")


def log_numbers(axis: Axis) -> None:
    """Number a logarithmic axis, once its limits are final: powers of ten, or plain numbers over few decades.

    Below one decade it becomes linear: ticks of equal distance are read as those of a linear axis.
    """
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

    low, high = sorted(axis.get_view_interval())
    decades = math.log10(high / low)
    if decades < 1.0:
        name = "x" if axis is axis.axes.xaxis else "y"
        axis.axes.set(**{f"{name}scale": "linear", f"{name}lim": (low, high)})
        return
    axis.set_minor_formatter(NullFormatter())
    if decades < _DECADES:
        axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.10g}"))


def vertical(robot: Robot) -> tuple[int, bool]:
    """Axis of the base frame that is drawn upright, and whether it points down, as gravity says."""
    along = np.abs(robot.g)
    steep = along[2] >= _ALONG_Z * np.linalg.norm(robot.g)
    axis = 2 if steep else int(np.argmax(along))
    return axis, bool(robot.g[axis] > 0.0)
