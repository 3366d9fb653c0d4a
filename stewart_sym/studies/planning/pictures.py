"""Pictures of the study of plans: rank correlations, peaks, and Path III before and after."""

from typing import Any

import numpy as np

from ..common.drawing import BLUE, DARK, GREY, RED, Figure, legend_below, log_numbers, new_figure
from ..common.report import SMALL, Picture

_COLORS = {"slow": BLUE, "fast": RED, "straight": GREY, "planned": BLUE}
_SHADES = (GREY, BLUE, RED)


def pictures(found: dict[str, Any]) -> dict[str, Picture]:
    """``plan_claim``, ``plan_path_III`` and ``plan_durations``."""
    return {
        "plan_claim": Picture(lambda: claim_figure(found["claim"]), SMALL),
        "plan_path_III": Picture(lambda: path_figure(found["path_III"]), SMALL),
        "plan_durations": Picture(lambda: durations_figure(found["durations"]), SMALL),
    }


def claim_figure(claim: dict[str, Any]) -> Figure:
    """Left: rank correlations along each path. Right: peak force over peak condition number of each path."""
    figure = new_figure(9.0, 4.2)
    left, right = figure.subplots(1, 2)
    bins = np.linspace(-1.0, 1.0, 41)
    for name, values in claim["correlation"].items():
        left.hist(values, bins, histtype="step", color=_COLORS[name], linewidth=1.4, label=f"{name} motion")
        peaks = claim["peak_force_over_weight"][name]
        right.loglog(claim["peak_condition"], peaks, ".", color=_COLORS[name], markersize=2.5)
    left.axvline(0.0, color=DARK, linewidth=0.7)
    label = "rank correlation of condition number\nand largest force along a path"
    left.set(xlim=(-1.0, 1.0), xlabel=label, ylabel=f"paths of {claim['paths']}")
    right.set(xlabel="peak of the scaled condition number", ylabel="peak force over weight")
    for axis in (right.xaxis, right.yaxis):
        log_numbers(axis)
    legend_below(figure)
    return figure


def path_figure(found: dict[str, Any]) -> Figure:
    """Condition number and largest force along Path III, straight and planned."""
    figure = new_figure(9.0, 4.0)
    labels = {"condition": "scaled condition number of H", "force_N": "largest leg force, N"}
    for axes, (what, label) in zip(figure.subplots(1, 2), labels.items(), strict=True):
        for name, values in found[what].items():
            time = np.linspace(0.0, 6.0, len(values))
            axes.semilogy(time, values, color=_COLORS[name], linewidth=1.4, label=name)
        axes.set(xlabel="time, s", ylabel=label, xlim=(0.0, 6.0))
        log_numbers(axes.yaxis)
    legend_below(figure)
    return figure


def durations_figure(found: dict[str, Any]) -> Figure:
    """Rate of the parameter and largest force of three motions of one duration."""
    figure = new_figure(9.0, 4.0)
    left, right = figure.subplots(1, 2)
    for (name, values), color in zip(found["motions"].items(), _SHADES, strict=True):
        label = f"{name}: {values['energy_J']:.4g} J, {max(values['force_N']):.4g} N"
        left.plot(found["time_s"], values["rate_per_s"], color=color, linewidth=1.4, label=label)
        right.plot(found["time_s"], values["force_N"], color=color, linewidth=1.4)
    left.set_ylabel("rate of the path parameter, 1/s")
    right.set_ylabel("largest leg force, N")
    for axes in (left, right):
        axes.set(xlabel="time, s", xlim=(0.0, found["time_s"][-1]))
        axes.set_ylim(bottom=0.0)
    legend_below(figure)
    return figure
