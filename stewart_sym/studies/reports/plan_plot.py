"""Pictures of a plan: condition numbers along the path, forces over their limits, the phase plane."""

from typing import Any

import numpy as np

from ...io.array_types import Array
from ...planning.timing.path_terms import force_limits
from ..common.drawing import BLUE, GREY, LEG_COLORS, RED, Figure, legend_below, log_numbers, new_figure
from ..common.report import Picture
from .plan import Plan, along, path_conditions

_INSTANTS = 4001


def pictures(plan: Plan) -> dict[str, Picture]:
    """``condition``, ``forces`` and ``phase_plane``."""
    return {
        "condition": Picture(lambda: condition_figure(plan)),
        "forces": Picture(lambda: forces_figure(plan)),
        "phase_plane": Picture(lambda: phase_figure(plan)),
    }


def condition_figure(plan: Plan) -> Figure:
    """Condition numbers of the planned and of the straight path, by their parameter."""
    figure = new_figure(8.0, 4.4)
    axes = figure.subplots()
    planned = plan.planned
    for path, name, color in ((planned.straight, "straight spline", GREY), (planned.path, "planned", BLUE)):
        axes.semilogy(*path_conditions(plan.robot, path), color=color, linewidth=1.4, label=name)
    for s in planned.path.via:
        axes.axvline(s, color=GREY, linewidth=0.7, linestyle=(0, (4, 3)))
    label = "path parameter s; via poses dashed"
    axes.set(xlim=(0.0, 1.0), xlabel=label, ylabel="scaled condition number of H")
    log_numbers(axes.yaxis)
    legend_below(figure)
    return figure


def forces_figure(plan: Plan) -> Figure:
    """Forces of the legs over their limits, or in N where one has none."""
    figure = new_figure(8.0, 4.6)
    axes = figure.subplots()
    limits = force_limits(plan.robot, plan.timed.limits)
    bounded = bool(np.isfinite(limits).all())
    columns = along(plan, np.linspace(0.0, plan.timed.duration, _INSTANTS))
    for leg, color in enumerate(LEG_COLORS):
        values = columns[f"F{leg + 1}"] / (limits[leg] if bounded else 1.0)
        axes.plot(columns["time"], values, color=color, linewidth=1.2, label=f"leg {leg + 1}")
    for bound in (-1.0, 1.0) if bounded else ():
        axes.axhline(bound, color=RED, linewidth=0.9, linestyle=(0, (4, 2)))
    label = "force over its limit" if bounded else "force, N"
    axes.set(xlim=(0.0, plan.timed.duration), xlabel="time, s", ylabel=label)
    legend_below(figure)
    return figure


def phase_figure(plan: Plan) -> Figure:
    """s' over s: the motion, where no acceleration is possible, from where it can stop."""
    figure = new_figure(8.0, 4.6)
    axes = figure.subplots()
    phase, nodes = plan.timed.profile.phase, plan.timed.profile.nodes
    top = 1.6 * float(nodes.rate.max())
    curves: list[tuple[Array, str, str, Any]] = [(nodes.rate, "motion", BLUE, "solid")]
    if plan.timed.profile.ease is None:
        most, stops = np.sqrt(phase.most), np.sqrt(phase.stops)
        curves.insert(0, (stops, "rest at the end is out of reach above", RED, (0, (1, 1))))
        curves.insert(0, (most, "no acceleration keeps the limits above", GREY, (0, (4, 2))))
    for rates, name, color, style in curves:
        values = np.minimum(rates, 2.0 * top)
        axes.plot(nodes.s, values, color=color, linewidth=1.3, linestyle=style, label=name)
    for s in plan.planned.path.via:
        axes.axvline(s, color=GREY, linewidth=0.6, linestyle=(0, (4, 3)))
    axes.set(xlim=(nodes.s[0], nodes.s[-1]), ylim=(0.0, top))
    axes.set(xlabel="path parameter s; via poses dashed", ylabel="its rate, 1/s")
    legend_below(figure)
    return figure
