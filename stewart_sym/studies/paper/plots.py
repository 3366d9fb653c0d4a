"""Plots of Figs. 4-10 of the paper with both formulations, `paper` and `exact`, as PNG and SVG."""

import functools
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from ..common.drawing import BLUE, DARK, RED, Axes, Figure, legend_below, legend_line, log_numbers, new_figure
from ..common.report import SMALL, Picture
from .reproduce import PathRun, Reproduction

_PAPER_LINE: dict[str, Any] = {"linewidth": 1.3, "zorder": 3}
_EXACT_LINE: dict[str, Any] = {"linewidth": 3.6, "alpha": 0.35, "zorder": 2, "solid_capstyle": "butt"}

_CURVES: tuple[tuple[str, str, str, str, Any], ...] = (
    ("T", "F", "total force $F$", BLUE, "-"),
    ("S", "F0", "massless legs, $F_0$", DARK, (0, (5, 1.5))),
    ("D", "Fd", "difference $F_d = F - F_0$", RED, (0, (1.2, 1.2))),
)
"""Letter of the paper, attribute of a run, meaning, color, and dash pattern of each curve."""

_LEAP = 0.5
"""Change of a fraction in a step, relative to the height of a panel, that occurs only next to a zero of F."""


def pictures(found: Reproduction) -> dict[str, Picture]:
    """Return every plot by name, as PNG and SVG."""
    return {
        f"fig{number:02d}_path_{path}_{kind}": Picture(
            functools.partial(make, number, found.runs[path, "paper"], found.runs[path, "exact"]),
            SMALL,
            ("png", "svg"),
        )
        for number, path, kind, make in _FIGURES
    }


def forces_figure(number: int, paper: PathRun, exact: PathRun) -> Figure:
    """Draw six panels of T, S, and D over time; `paper` as thin lines, `exact` as pale bands behind."""
    figure, panels = _six_panels(number, f"Path {paper.path}: leg forces", "force, N")
    for leg, axes in enumerate(panels):
        for letter, name, _, color, dash in _CURVES:
            if letter != "S":
                axes.plot(exact.time, getattr(exact, name)[:, leg], color=color, **_EXACT_LINE)
            axes.plot(paper.time, getattr(paper, name)[:, leg], color=color, linestyle=dash, **_PAPER_LINE)
    handles = [
        legend_line(f"{letter}: {meaning}", color=color, linestyle=dash, **_PAPER_LINE)
        for letter, _, meaning, color, dash in _CURVES
    ]
    legend_below(figure, [*handles, *_formulation_handles("same for S")])
    return figure


def fraction_figure(number: int, paper: PathRun, exact: PathRun) -> Figure:
    """Draw six panels of F_d / F over time, clipped to -1 to 1, because it is unbounded at a zero of F."""
    figure, panels = _six_panels(number, f"Path {paper.path}: fraction of dynamic forces", "$F_d / F$")
    for leg, axes in enumerate(panels):
        both = np.concatenate([paper.fraction[:, leg], exact.fraction[:, leg], [0.0]]).clip(-1.0, 1.0)
        margin = 0.08 * np.ptp(both)
        low, high = both.min() - margin, both.max() + margin
        for run, line in ((exact, _EXACT_LINE), (paper, _PAPER_LINE)):
            fraction = run.fraction[:, leg]
            # The curve has a gap at each sign change of F and large change of the fraction.
            gaps = np.diff(np.sign(run.F[:, leg])) != 0
            gaps |= np.abs(np.diff(fraction)) > _LEAP * (high - low)
            after = np.flatnonzero(gaps) + 1
            drawn = np.insert(run.time, after, np.nan), np.insert(fraction, after, np.nan)
            axes.plot(*drawn, color=BLUE, **line)
        axes.set_ylim(low, high)
        axes.axhline(0.0, color="black", linewidth=0.6, zorder=1)
    legend_below(figure, _formulation_handles("gaps where $F$ crosses zero; cut off at ±1"))
    return figure


def condition_figure(number: int, paper: PathRun, exact: PathRun) -> Figure:
    """Draw the condition number of H over time, as in the paper and dimensionless; logarithmic above 1000."""
    figure = new_figure(7.0, 4.2)
    axes = figure.subplots()
    figure.suptitle(f"Fig. {number}  Path {paper.path}: condition number of H")
    axes.plot(paper.time, paper.condition, color=BLUE, label="moments in N m, as in the paper", **_PAPER_LINE)
    label = "moments divided by a length: no unit"
    axes.plot(paper.time, paper.scaled_condition, "--", color=RED, label=label, **_PAPER_LINE)
    axes.set(xlabel="time, s", ylabel="condition number", xlim=(paper.time[0], paper.time[-1]))
    if paper.condition.max() > 1e3:
        axes.set_yscale("log")
        log_numbers(axes.yaxis)
    else:
        axes.set_ylim(bottom=0)
    legend_below(figure)
    return figure


_FIGURES: Sequence[tuple[int, str, str, Callable[[int, PathRun, PathRun], Figure]]] = (
    (4, "I", "forces", forces_figure),
    (5, "I", "condition", condition_figure),
    (6, "I", "fraction", fraction_figure),
    (7, "II", "forces", forces_figure),
    (8, "II", "fraction", fraction_figure),
    (9, "III", "forces", forces_figure),
    (10, "III", "condition", condition_figure),
)


def _six_panels(number: int, title: str, label: str) -> tuple[Figure, list[Axes]]:
    figure = new_figure(10.0, 6.2)
    figure.suptitle(f"Fig. {number}  {title}")
    panels = list(figure.subplots(2, 3, sharex=True).flat)
    for leg, axes in enumerate(panels):
        axes.set_title(f"leg {leg + 1}", fontsize=9.0)
        axes.margins(x=0.0)
        axes.set(xlabel="time, s" if leg >= 3 else "", ylabel=label if leg % 3 == 0 else "")
        axes.ticklabel_format(axis="y", scilimits=(-2, 5), useMathText=True)
    return figure, panels


def _formulation_handles(note: str) -> list[Any]:
    texts = (("thin: paper, as printed", _PAPER_LINE), (f"band: exact ({note})", _EXACT_LINE))
    return [legend_line(text, color="#555555", **line) for text, line in texts]
