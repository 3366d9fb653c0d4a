"""Pictures of the study of plans: rank correlations, peaks, and Path III before and after."""

from typing import Any

import numpy as np

from ...io.extras import needed_for
from ..common.drawing import legend_below, log_numbers
from ..common.report import SMALL, Picture

with needed_for("drawing"):
    from matplotlib.figure import Figure

_COLORS = {"slow": "#1f4e9c", "fast": "#c1440e", "straight": "#8a8a8a", "planned": "#1f4e9c"}
_SHADES = ("#8a8a8a", "#1f4e9c", "#c1440e")


def pictures(found: dict[str, Any]) -> dict[str, Picture]:
    """``plan_claim``, ``plan_path_III`` and ``plan_durations``."""
    return {
        "plan_claim": Picture(lambda: claim_figure(found["claim"]), SMALL),
        "plan_path_III": Picture(lambda: path_figure(found["path_III"]), SMALL),
        "plan_durations": Picture(lambda: durations_figure(found["durations"]), SMALL),
    }


def claim_figure(claim: dict[str, Any]) -> Figure:
    """Left: rank correlations along each path. Right: peak force over peak condition number of each path."""
    figure = Figure(figsize=(9.0, 4.2), layout="constrained")
    left, right = figure.subplots(1, 2)
    bins = np.linspace(-1.0, 1.0, 41)
    for name, values in claim["correlation"].items():
        left.hist(values, bins, histtype="step", color=_COLORS[name], linewidth=1.4, label=f"{name} motion")
        peaks = claim["peak_force_over_weight"][name]
        right.loglog(claim["peak_condition"], peaks, ".", color=_COLORS[name], markersize=2.5)
    left.axvline(0.0, color="#3a3a3a", linewidth=0.7)
    left.set_xlim(-1.0, 1.0)
    left.set_xlabel("rank correlation of condition number\nand largest force along a path")
    left.set_ylabel(f"paths of {claim['paths']}")
    right.set_xlabel("peak of the scaled condition number")
    right.set_ylabel("peak force over weight")
    for axis in (right.xaxis, right.yaxis):
        log_numbers(axis)
    legend_below(figure)
    return figure


def path_figure(found: dict[str, Any]) -> Figure:
    """Condition number and largest force along Path III, straight and planned."""
    figure = Figure(figsize=(9.0, 4.0), layout="constrained")
    for axes, what, label in zip(
        figure.subplots(1, 2),
        ("condition", "force_N"),
        ("scaled condition number of H", "largest leg force, N"),
        strict=True,
    ):
        for name, values in found[what].items():
            time = np.linspace(0.0, 6.0, len(values))
            axes.semilogy(time, values, color=_COLORS[name], linewidth=1.4, label=name)
        axes.set_xlabel("time, s")
        axes.set_ylabel(label)
        axes.set_xlim(0.0, 6.0)
        log_numbers(axes.yaxis)
    legend_below(figure)
    return figure


def durations_figure(found: dict[str, Any]) -> Figure:
    """Rate of the parameter and largest force of three motions of one duration."""
    figure = Figure(figsize=(9.0, 4.0), layout="constrained")
    left, right = figure.subplots(1, 2)
    for (name, values), color in zip(found["motions"].items(), _SHADES, strict=True):
        label = f"{name}: {values['energy_J']:.4g} J, {max(values['force_N']):.4g} N"
        left.plot(found["time_s"], values["rate_per_s"], color=color, linewidth=1.4, label=label)
        right.plot(found["time_s"], values["force_N"], color=color, linewidth=1.4)
    left.set_ylabel("rate of the path parameter, 1/s")
    right.set_ylabel("largest leg force, N")
    for axes in (left, right):
        axes.set_xlabel("time, s")
        axes.set_xlim(0.0, found["time_s"][-1])
        axes.set_ylim(bottom=0.0)
    legend_below(figure)
    return figure
