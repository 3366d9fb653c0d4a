"""What pictures share: legends that fit the figure, numbers of logarithmic axes. Needs the extra ``plot``."""

import math
from typing import Any

from ...io.extras import needed_for

with needed_for("drawing"):
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

_DECADES = 2.0
"""Below which ticks of a logarithmic axis stand between powers of ten too, as plain numbers."""
_MARGIN = 0.02
"""Of the figure's width, that a legend leaves free in all."""


def legend_below(figure: Figure, handles: list[Any] | None = None, **style: Any) -> None:
    """A legend of the handles, or of the labelled curves of all axes once each, in as many columns as fit."""
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
        figure.draw_without_rendering()
        if legend.get_window_extent().width <= (1.0 - _MARGIN) * figure.bbox.width:
            return
        if columns > 1:
            legend.remove()


def log_numbers(axis: Axis) -> None:
    """Number a logarithmic axis, once its limits are final: powers of ten, or plain numbers over few."""
    low, high = sorted(axis.get_view_interval())
    decades = math.log10(high / low)
    axis.set_minor_formatter(NullFormatter())
    if decades < _DECADES:
        axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0) if decades > 1.0 else range(1, 10)))
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.10g}"))
