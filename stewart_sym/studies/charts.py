"""The pictures that ``chart`` writes, each with its rows: what they are called and how they come about.

One entry for each picture; the studies know how to measure and draw. Knows no files.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from . import economy_plot
from .economy import Economy

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Chart:
    """A picture's name, its data as CSV, and what draws it."""

    name: str
    rows: str
    draw: Callable[[], "Figure"]


def charts(found: Economy) -> list[Chart]:
    """All pictures of a machine."""
    return [
        Chart("chart", economy_plot.csv_rows(found), lambda: economy_plot.figure(found)),
    ]
