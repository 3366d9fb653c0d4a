"""Plot of force over time and motor torque over motor speed, one panel per leg, with the limits."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...robot.robot import LEGS, Robot
from ...robot.units import Units
from ..common.drawing import (
    BLUE,
    DARK,
    LIMIT,
    Axes,
    Figure,
    as_written,
    draw_limit,
    legend_below,
    legend_line,
    new_figure,
)

_CURVE: dict[str, Any] = {"color": BLUE, "linewidth": 1.0}
_MOST = 4000
"""Number of samples above which a curve is a bitmap also in SVG files."""
_RATED: dict[str, Any] = {"color": DARK, "linewidth": 1.1, "linestyle": (0, (1, 1.5))}


def leg_figure(
    robot: Robot, time: NDArray[Any], F: NDArray[Any], motors: tuple[NDArray[Any], NDArray[Any]] | None = None
) -> Figure:
    """Plot the forces F (N), (n, 6), over times (s), and with drives torque (N m) over speed (rad/s), (n, 6).

    ``motors`` contains torque and speed.
    """
    columns = 2 if motors is None else 4
    figure = new_figure(4.0 * columns, 8.0)
    panels = figure.subplots(3, columns, squeeze=False)
    _forces(panels[:, :2].ravel(), robot, time, F)
    handles = [legend_line("samples", color=BLUE, linewidth=1.3)]
    if motors is not None or np.isfinite(robot.force_limit).any():
        handles.append(legend_line("limit", **LIMIT))
    if motors is not None:
        _motors(panels[:, 2:].ravel(), robot, *motors)
        if robot.drive is not None and np.isfinite(robot.drive.rated_torque).any():
            handles.append(legend_line("rated torque (limit of the root mean square)", **_RATED))
    legend_below(figure, handles)
    figure.suptitle(as_written(robot.name), fontsize=11.0)
    return figure


def _forces(panels: NDArray[Any], robot: Robot, time: NDArray[Any], F: NDArray[Any]) -> None:
    """Draw a panel of each leg with its force over time."""
    for leg, axes in enumerate(panels):
        _share_scales(axes, panels[0])
        axes.plot(time, F[:, leg], rasterized=len(time) > _MOST, **_CURVE)
        limit = float(robot.force_limit[leg])
        draw_limit(axes.axhline, limit, F, LIMIT)
        axes.set_title(f"leg {leg + 1}{_named('limit', limit, 'N')}", fontsize=9.0)
        axes.margins(x=0.0)
        axes.locator_params("x", nbins=5)
        axes.set(xlabel="time, s" if leg >= LEGS - 2 else "", ylabel="" if leg % 2 else "actuator force, N")


def _motors(panels: NDArray[Any], robot: Robot, torque: NDArray[Any], speed: NDArray[Any]) -> None:
    """Draw a panel of each motor with its torque over its speed."""
    drive, units = robot.drive, Units.of(robot)
    assert drive is not None
    rates = speed / units.radians
    for leg, axes in enumerate(panels):
        _share_scales(axes, panels[0])
        axes.plot(rates[:, leg], torque[:, leg], rasterized=len(rates) > _MOST, **_CURVE)
        rated, peak = float(drive.rated_torque[leg]), float(drive.torque_limit[leg])
        fastest = float(drive.speed_limit[leg]) / units.radians
        draw_limit(axes.axhline, rated, torque, _RATED)
        draw_limit(axes.axhline, peak, torque, LIMIT)
        draw_limit(axes.axvline, fastest, rates, LIMIT)
        axes.locator_params("x", nbins=5)
        limits = _named("rated", rated, "N m") + _named("peak", peak, "N m")
        limits += _named("speed", fastest, f"{units.angle}/s")
        axes.set_title(f"motor {leg + 1}{limits}", fontsize=7.5)
        axes.set(xlabel=f"motor speed, {units.angle}/s" if leg >= LEGS - 2 else "")
        axes.set(ylabel="" if leg % 2 else "motor torque, N m")


def _share_scales(axes: Axes, first: Axes) -> None:
    """Give a panel the scales of the first panel."""
    if axes is not first:
        axes.sharex(first)
        axes.sharey(first)


def _named(name: str, limit: float, unit: str) -> str:
    """Return the text of a limit for a title; nothing without a limit."""
    return f", {name} {limit:.6g} {unit}" if np.isfinite(limit) else ""
