"""What ``chart`` finds: cost and accuracy, and the pictures with their rows."""

import functools
import warnings
from collections.abc import Callable, Iterator
from typing import Any

from ...backend.native import CompilerError
from ...io.progress import Progress, silent
from ...robot.robot import Robot
from ..common import host
from ..common.output import Figures
from ..common.report import SMALL, Picture, Report
from . import bound_plot, cost_plot, scales
from .advice import table

Chart = tuple[str, str, Picture]
"""A picture's name, its rows as CSV, and what draws it."""

_KINDS = ("png", "svg")


def full_report(found: Figures, robot: Robot, progress: Progress = silent) -> Report:
    """The table of ``found``, and every chart's rows with its picture."""
    every = list(charts(found, robot, progress))
    return Report(
        table(found),
        {name: rows for name, rows, _ in every},
        {**found, "machine": host.machine(), "software": host.software()},
        {name: picture for name, _, picture in every},
    )


def charts(found: Figures, robot: Robot, progress: Progress = silent) -> Iterator[Chart]:
    """Speed against accuracy, rounding over the machine's size, and rounding with its bound.

    The last two are left out, with a warning, for machines and compilers that they can't be had with.
    """
    drawn = Picture(lambda: cost_plot.figure(found), SMALL, _KINDS)
    yield "chart", cost_plot.csv_rows(found), drawn
    studies: dict[str, tuple[Any, Callable[..., Any]]] = {
        "scales": (scales, scales.scales_study),
        "bounds": (bound_plot, bound_plot.bounds_study),
    }
    for name, (module, study) in studies.items():
        try:
            made = study(progress, robot=robot)
        except (ValueError, CompilerError) as error:
            warnings.warn(f"{name}: left out: {error}", stacklevel=2)
        else:
            yield name, module.csv_rows(made), Picture(functools.partial(module.figure, made), kinds=_KINDS)
