"""Plots of Figs. 4-10 of the paper with both formulations, `paper` and `exact`, as PNG and SVG."""

import functools
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...io.array_types import Array
from ..common.drawing import BLUE, DARK, RED, Axes, Figure, legend_below, legend_line, log_numbers, new_figure
from ..common.report import SMALL, Picture
from .reproduce import PathRun, Reproduction

_PAPER_LINE: dict[str, Any] = {"linewidth": 1.3, "zorder": 3}
_EXACT_LINE: dict[str, Any] = {"linewidth": 3.6, "alpha": 0.35, "zorder": 2, "solid_capstyle": "butt"}


@dataclass(frozen=True)
class _Curve:
    """Curve with the letter of the paper, its meaning, values, color, and dash pattern."""

    letter: str
    meaning: str
    values: Callable[[PathRun], Array]
    color: str
    dash: Any


_CURVES = (
    _Curve("T", "total force $F$", lambda run: run.F, BLUE, "-"),
    _Curve("S", "massless legs, $F_0$", lambda run: run.F0, DARK, (0, (5, 1.5))),
    _Curve("D", "difference $F_d = F - F_0$", lambda run: run.Fd, RED, (0, (1.2, 1.2))),
)


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
        for curve in _CURVES:
            if curve.letter != "S":
                axes.plot(exact.time, curve.values(exact)[:, leg], color=curve.color, **_EXACT_LINE)
            values = curve.values(paper)[:, leg]
            axes.plot(paper.time, values, color=curve.color, linestyle=curve.dash, **_PAPER_LINE)
        _letters(axes, [(c.letter, float(c.values(paper)[-1, leg]), c.color) for c in _CURVES])
    marks = [(f"{c.letter}: {c.meaning}", {"color": c.color, "linestyle": c.dash}) for c in _CURVES]
    handles = [legend_line(label, **style, **_PAPER_LINE) for label, style in marks]
    legend_below(figure, [*handles, *_formulation_handles("same for S")])
    return figure


def fraction_figure(number: int, paper: PathRun, exact: PathRun) -> Figure:
    """Draw six panels of F_d / F over time, clipped to -1 to 1, because it is unbounded at a zero of F."""
    figure, panels = _six_panels(number, f"Path {paper.path}: fraction of dynamic forces", "$F_d / F$")
    color = _CURVES[0].color
    for leg, axes in enumerate(panels):
        low, high = _fraction_limits((paper, exact), leg)
        for run, line in ((exact, _EXACT_LINE), (paper, _PAPER_LINE)):
            axes.plot(*_broken(run, leg, _LEAP * (high - low)), color=color, **line)
        axes.set_ylim(low, high)
        axes.axhline(0.0, color="black", linewidth=0.6, zorder=1)
    legend_below(figure, _formulation_handles("gaps where $F$ crosses zero; cut off at ±1"))
    return figure


def condition_figure(number: int, paper: PathRun, exact: PathRun) -> Figure:
    """Draw the condition number of H over time, as in the paper and dimensionless; logarithmic above 1000."""
    figure = new_figure(7.0, 4.2)
    axes = figure.subplots()
    figure.suptitle(f"Fig. {number}  Path {paper.path}: condition number of H")
    color, scaled = _CURVES[0].color, _CURVES[2].color
    axes.plot(paper.time, paper.condition, color=color, label="thin: paper, moments in N m", **_PAPER_LINE)
    axes.plot(exact.time, exact.condition, color=color, label="band: exact, the same H", **_EXACT_LINE)
    label = "moments divided by a length: no unit"
    axes.plot(paper.time, paper.scaled_condition, "--", color=scaled, label=label, **_PAPER_LINE)
    axes.set(xlabel="time, s", ylabel="condition number", xlim=(paper.time[0], paper.time[-1]))
    if paper.condition.max() > 1e3:
        axes.set_yscale("log")
        log_numbers(axes.yaxis)
    else:
        axes.set_ylim(bottom=0)
    legend_below(figure)
    return figure


_FIGURES: tuple[tuple[int, str, str, Callable[[int, PathRun, PathRun], Figure]], ...] = (
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
        if leg >= 3:
            axes.set_xlabel("time, s")
        if leg % 3 == 0:
            axes.set_ylabel(label)
        axes.ticklabel_format(axis="y", scilimits=(-2, 5), useMathText=True)
    return figure, panels


def _letters(axes: Axes, ends: list[tuple[str, float, str]]) -> None:
    """Write the letters of the curves at the right edge at their last values, without overlap."""
    low, high = axes.get_ylim()
    heights = {letter: (value - low) / (high - low) for letter, value, _ in ends}
    for letter, height in _spread(heights, gap=0.075).items():
        color = next(color for name, _, color in ends if name == letter)
        axes.text(1.015, height, letter, color=color, transform=axes.transAxes, va="center", weight="bold")


def _spread(heights: dict[str, float], gap: float) -> dict[str, float]:
    """Move heights apart to at least ``gap`` without a change of their order."""
    names = sorted(heights, key=lambda name: heights[name])
    placed = np.array([heights[name] for name in names])
    for _ in range(20):
        for i in range(1, len(placed)):
            lack = gap - (placed[i] - placed[i - 1])
            if lack > 0:
                placed[i - 1 : i + 1] += (-lack / 2, lack / 2)
    return dict(zip(names, placed.tolist(), strict=True))


# Only next to a zero of F, a fraction changes by more than this fraction of the panel height in a step.
_LEAP = 0.5


def _broken(run: PathRun, leg: int, leap: float) -> tuple[Array, Array]:
    """Return time and fraction with a gap at each sign change of F and large change of the fraction."""
    changes = np.diff(np.sign(run.F[:, leg])) != 0
    after = np.flatnonzero(changes | (np.abs(np.diff(run.fraction[:, leg])) > leap)) + 1
    return np.insert(run.time, after, np.nan), np.insert(run.fraction[:, leg], after, np.nan)


def _fraction_limits(runs: tuple[PathRun, ...], leg: int) -> tuple[float, float]:
    """Return limits that include both curves and zero, at most -1 to 1."""
    values = np.concatenate([run.fraction[:, leg] for run in runs])
    low, high = max(float(values.min()), -1.0), min(float(values.max()), 1.0)
    low, high = min(low, 0.0), max(high, 0.0)
    margin = 0.08 * (high - low)
    return low - margin, high + margin


def _formulation_handles(note: str) -> list[Any]:
    gray = "#555555"
    return [
        legend_line("thin: paper, as printed", color=gray, **_PAPER_LINE),
        legend_line(f"band: exact ({note})", color=gray, **_EXACT_LINE),
    ]
