"""The pictures that ``chart`` writes, each with its rows: what they are called and how they come about.

One entry for each picture; the studies know how to measure and draw. Knows no files.
"""

import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ...backend.native import CompilerError
from ...robot.robot import Robot
from ..common.timing import Progress
from . import bound_plot, cost_plot, scales
from .cost import CostAccuracy

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Chart:
    """A picture's name, its data as CSV, and what draws it."""

    name: str
    rows: str
    draw: Callable[[], "Figure"]


def charts(found: CostAccuracy, robot: Robot, progress: Progress = lambda _: None) -> Iterator[Chart]:
    """Speed against accuracy, rounding over the machine's size, and rounding with its bound.

    The last two are left out, with a warning, for machines and compilers that they can't be had with.
    """
    yield Chart("chart", cost_plot.csv_rows(found), lambda: cost_plot.figure(found))
    for name, made in (("scales", _scales), ("bounds", _bounds)):
        try:
            yield made(name, robot, progress)
        except (ValueError, CompilerError) as error:
            warnings.warn(f"{name}: left out: {error}", stacklevel=2)


def _scales(name: str, robot: Robot, progress: Progress) -> Chart:
    found = scales.scales_study(progress, robot)
    return Chart(name, scales.csv_rows(found), lambda: scales.figure(found))


def _bounds(name: str, robot: Robot, progress: Progress) -> Chart:
    found = bound_plot.bounds_study(progress, robot=robot)
    return Chart(name, bound_plot.csv_rows(found), lambda: bound_plot.figure(found))
