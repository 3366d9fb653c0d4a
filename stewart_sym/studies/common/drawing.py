"""Common functions of plots. Matplotlib, from the extra ``plot``, is imported at the first plot."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...io.error_policy import need
from ...robot.robot import Robot

if TYPE_CHECKING:
    from matplotlib.axes import Axes as Axes
    from matplotlib.axis import Axis as Axis
    from matplotlib.figure import Figure as Figure
else:
    Axes = Axis = Figure = Any

BLUE, RED, DARK, GRAY = "#1f4e9c", "#c1440e", "#3a3a3a", "#8a8a8a"
LEG_COLORS = (BLUE, RED, "#2e7d4f", "#8e5ea2", "#b8860b", DARK)
LIMIT: dict[str, Any] = {"color": RED, "linewidth": 1.1, "linestyle": (0, (4, 2))}
"""Style of the line of a limit."""

Place = tuple[float, float]
"""Data coordinates (x, y)."""

Z_DOWN = (2, True)
"""Result of ``vertical`` for a machine whose z axis points down."""

_DECADES = 2.0
"""Number of decades below which an axis has further ticks between powers of ten, and plain numbers."""
_MARGIN = 0.02
"""Free fraction of the figure width next to a legend."""
_ALONG_Z = 0.5
"""Smallest fraction of gravity along z for which the vertical is the z axis."""
_FAR = 5.0
"""Ratio of a limit to the largest value of all legs above which the limit is not drawn."""


def new_figure(width: float, height: float) -> Figure:
    """Create an empty figure (inches); raise ImportError without Matplotlib."""
    need("matplotlib", "drawing")
    from matplotlib import figure

    return figure.Figure(figsize=(width, height), layout="constrained")


def legend_line(label: str, **style: Any) -> Any:
    """Create a line for a legend in the style of ``Line2D``."""
    from matplotlib.lines import Line2D

    return Line2D([], [], label=label, **style)


def curves(axes: Axes, x: NDArray[Any], values: NDArray[Any], names: Sequence[str], label: str) -> None:
    """Plot named columns of values, shape (n, k), over x, shape (n,), and label the vertical axis."""
    axes.plot(x, values, linewidth=1.1, label=[*names])
    axes.set_ylabel(label)
    axes.margins(x=0.0)


def draw_limits(line: Any, limits: NDArray[Any], values: NDArray[Any], style: dict[str, Any]) -> None:
    """Draw limits on each side of zero on which values are, unless they are too far from them."""
    for side in (-1.0, 1.0):
        largest = float(np.nanmax(side * values, initial=0.0))
        for limit in np.unique(limits[limits <= _FAR * largest]) if largest > 0.0 else ():
            line(side * limit, **style)


def as_written(name: str) -> str:
    """Replace dollar signs in a name, such as the name of a robot, so that they do not start a formula."""
    return name.replace("$", r"\$")


def _labeled(panels: Sequence[Axes]) -> dict[str, Any]:
    """Return one curve for each label."""
    found = [axes.get_legend_handles_labels() for axes in panels]
    return {label: one for ones, labels in found for one, label in zip(ones, labels, strict=True)}


def legend_beside(figure: Figure) -> None:
    """Add a legend to the right of each panel, because curves could cover it inside."""
    for axes in figure.axes:
        named = _labeled([axes])
        place: Any = {"loc": "center left", "bbox_to_anchor": (1.0, 0.5), "fontsize": 8.0}
        axes.legend(list(named.values()), list(named), **place)


def legend_below(figure: Figure, handles: list[Any] | None = None, **style: Any) -> None:
    """Add a legend of the handles, or of all labeled curves, below the figure, in as many columns as fit."""
    named = _labeled(figure.axes) if handles is None else {one.get_label(): one for one in handles}
    for columns in range(len(named), 0, -1):
        where: Any = {"loc": "outside lower center", "ncols": columns, "frameon": False}
        legend = figure.legend(list(named.values()), list(named), **where, **style)
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
    """Write ``names`` (text, point, and color) near their points, clear of ``markers`` and ends of ``bars``.

    The layout of the figure is fixed from this call on. Raises ValueError if there is no room for all labels.
    """
    need("textalloc", "drawing")
    import textalloc

    figure: Any = axes.get_figure()
    figure.draw_without_rendering()
    figure.set_layout_engine("none")
    # The type hints of the function omit that some results may be None.
    allocate: Any = textalloc.allocate
    texts, at, colors = zip(*names, strict=True)
    obstacles: Any = dict(zip(("x_scatter", "y_scatter"), zip(*markers, strict=True), strict=True))
    obstacles |= {"x_lines": [[start[0], end[0]] for start, end in bars]}
    obstacles |= {"y_lines": [[start[1], end[1]] for start, end in bars]}
    style: Any = {"textsize": size, "textcolor": colors, "linecolor": colors, "linewidth": 0.6}
    search: Any = {"margin": 0.006, "max_distance": 0.4, "nbr_candidates": 400, "draw_all": False}
    # The order of placement matters. The given order is tried first, then other orders.
    for clear, order in [(True, None), *((clear, order) for clear in (True, False) for order in range(4))]:
        how: Any = {"avoid_label_lines_overlap": clear, "priority_strategy": order}
        place = zip(*at, strict=True)
        *_, written, lines = allocate(axes, *place, texts, **obstacles, **style, **search, **how)
        if None not in written:
            return
        for drawn in (*written, *lines):
            if drawn is not None:
                drawn.remove()
    raise ValueError("point labels: not enough room in the plot; draw fewer points")


def log_numbers(axis: Axis) -> None:
    """Set powers of ten, or plain numbers over few decades, as tick labels of a logarithmic axis."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

    low, high = sorted(axis.get_view_interval())
    decades = math.log10(high / low)
    if decades < 1.0:
        # Equally spaced ticks are read as a linear scale.
        name = "x" if axis is axis.axes.xaxis else "y"
        axis.axes.set(**{f"{name}scale": "linear", f"{name}lim": (low, high)})
        return
    axis.set_minor_formatter(NullFormatter())
    if decades < _DECADES:
        axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.10g}"))


def vertical(robot: Robot) -> tuple[int, bool]:
    """Return the axis of the base frame that gravity makes vertical, and True if it points down."""
    along = np.abs(robot.g)
    steep = along[2] >= _ALONG_Z * np.linalg.norm(robot.g)
    axis = 2 if steep else int(np.argmax(along))
    return axis, bool(robot.g[axis] > 0.0)
