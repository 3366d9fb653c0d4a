"""Pictures of a plan: condition numbers along the path, forces over their limits, the phase plane."""

from typing import Any

import numpy as np

from ...io.array_types import Array
from ...io.extras import needed_for
from ...planning.timing.path_terms import force_limits
from ..common.drawing import legend_below, log_numbers
from ..common.report import Picture
from .plan import Plan, along, path_conditions

with needed_for("drawing"):
    from matplotlib.figure import Figure

_BLUE, _RED, _GREY = "#1f4e9c", "#c1440e", "#8a8a8a"
_INSTANTS = 4001
_LEGS = ("#1f4e9c", "#c1440e", "#2e7d4f", "#8e5ea2", "#b8860b", "#3a3a3a")


def pictures(plan: Plan) -> dict[str, Picture]:
    """``condition``, ``forces`` and ``phase_plane``."""
    return {
        "condition": Picture(lambda: condition_figure(plan)),
        "forces": Picture(lambda: forces_figure(plan)),
        "phase_plane": Picture(lambda: phase_figure(plan)),
    }


def condition_figure(plan: Plan) -> Figure:
    """Condition numbers of the planned and of the straight path, by their parameter."""
    figure = Figure(figsize=(8.0, 4.4), layout="constrained")
    axes = figure.subplots()
    planned = plan.planned
    for path, name, color in ((planned.straight, "straight spline", _GREY), (planned.path, "planned", _BLUE)):
        axes.semilogy(*path_conditions(plan.robot, path), color=color, linewidth=1.4, label=name)
    for s in planned.path.via:
        axes.axvline(s, color=_GREY, linewidth=0.7, linestyle=(0, (4, 3)))
    axes.set_xlim(0.0, 1.0)
    axes.set_xlabel("path parameter s; via poses dashed")
    axes.set_ylabel("scaled condition number of H")
    log_numbers(axes.yaxis)
    legend_below(figure)
    return figure


def forces_figure(plan: Plan) -> Figure:
    """Forces of the legs over their limits, or in N where one has none."""
    figure = Figure(figsize=(8.0, 4.6), layout="constrained")
    axes = figure.subplots()
    limits = force_limits(plan.robot, plan.timed.limits)
    bounded = bool(np.isfinite(limits).all())
    columns = along(plan, np.linspace(0.0, plan.timed.duration, _INSTANTS))
    for leg in range(6):
        values = columns[f"F{leg + 1}"] / (limits[leg] if bounded else 1.0)
        axes.plot(columns["time"], values, color=_LEGS[leg], linewidth=1.2, label=f"leg {leg + 1}")
    for bound in (-1.0, 1.0) if bounded else ():
        axes.axhline(bound, color=_RED, linewidth=0.9, linestyle=(0, (4, 2)))
    axes.set_xlim(0.0, plan.timed.duration)
    axes.set_xlabel("time, s")
    axes.set_ylabel("force over its limit" if bounded else "force, N")
    legend_below(figure)
    return figure


def phase_figure(plan: Plan) -> Figure:
    """s' over s: the motion, where no acceleration is possible, from where it can stop."""
    figure = Figure(figsize=(8.0, 4.6), layout="constrained")
    axes = figure.subplots()
    phase, nodes = plan.timed.profile.phase, plan.timed.profile.nodes
    top = 1.6 * float(nodes.rate.max())
    curves: list[tuple[Array, str, str, Any]] = [(nodes.rate, "motion", _BLUE, "solid")]
    if plan.timed.profile.ease is None:
        most, stops = np.sqrt(phase.most), np.sqrt(phase.stops)
        curves.insert(0, (stops, "rest at the end is out of reach above", _RED, (0, (1, 1))))
        curves.insert(0, (most, "no acceleration keeps the limits above", _GREY, (0, (4, 2))))
    for rates, name, color, style in curves:
        values = np.minimum(rates, 2.0 * top)
        axes.plot(nodes.s, values, color=color, linewidth=1.3, linestyle=style, label=name)
    for s in plan.planned.path.via:
        axes.axvline(s, color=_GREY, linewidth=0.6, linestyle=(0, (4, 3)))
    axes.set_xlim(nodes.s[0], nodes.s[-1])
    axes.set_ylim(0.0, top)
    axes.set_xlabel("path parameter s; via poses dashed")
    axes.set_ylabel("its rate, 1/s")
    legend_below(figure)
    return figure
