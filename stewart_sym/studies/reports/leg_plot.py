"""Plot of force over time and motor torque over motor speed, one panel per leg, with the limits."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...robot.robot import LEGS, Robot
from ...robot.units import Units
from ..common import drawing
from ..common.drawing import LIMIT, Figure, as_written, draw_limits, legend_below, legend_line, new_figure

_CURVE: dict[str, Any] = {"color": drawing.BLUE, "linewidth": 1.0}
_MOST = 4000
"""Number of samples above which a curve is a bitmap also in SVG files."""
_RATED: dict[str, Any] = {"color": drawing.DARK, "linewidth": 1.1, "linestyle": (0, (1, 1.5))}


def leg_figure(
    robot: Robot, time: NDArray[Any], F: NDArray[Any], motors: tuple[NDArray[Any], NDArray[Any]] | None = None
) -> Figure:
    """Plot forces F (N), (n, 6), over times (s), and torque (N m) over speed (rad/s) of any ``motors``."""
    drive, units, columns = robot.drive, Units.of(robot), 2 if motors is None else 4
    figure = new_figure(4.0 * columns, 8.0)
    panels = figure.subplots(3, columns, squeeze=False)
    time = np.broadcast_to(time[:, None], F.shape)
    force = ("limit", "N", robot.force_limit, False, LIMIT)
    _panels(panels[:, :2].ravel(), "leg", time, F, ("time, s", "actuator force, N"), [force])
    for axes in panels[:, :2].ravel():
        axes.margins(x=0.0)
    handles = [legend_line("samples", color=drawing.BLUE, linewidth=1.3)]
    if motors is not None or np.isfinite(robot.force_limit).any():
        handles.append(legend_line("limit", **LIMIT))
    if motors is not None and drive is not None:
        limits = [
            ("rated", "N m", drive.rated_torque, False, _RATED),
            ("peak", "N m", drive.torque_limit, False, LIMIT),
            ("speed", f"{units.angle}/s", drive.speed_limit / units.radians, True, LIMIT),
        ]
        labels = f"motor speed, {units.angle}/s", "motor torque, N m"
        _panels(panels[:, 2:].ravel(), "motor", motors[1] / units.radians, motors[0], labels, limits)
        if np.isfinite(drive.rated_torque).any():
            handles.append(legend_line("rated torque (limit of the root mean square)", **_RATED))
    legend_below(figure, handles)
    figure.suptitle(as_written(robot.name), fontsize=11.0)
    return figure


def _panels(
    panels: NDArray[Any],
    name: str,
    x: NDArray[Any],
    y: NDArray[Any],
    labels: tuple[str, str],
    limits: list[tuple[str, str, NDArray[Any], bool, dict[str, Any]]],
) -> None:
    """Draw a panel of each leg with limits: name, unit, values (6,), True for a limit of x, and style."""
    for leg, axes in enumerate(panels):
        if leg > 0:
            axes.sharex(panels[0])
            axes.sharey(panels[0])
        axes.plot(x[:, leg], y[:, leg], rasterized=len(x) > _MOST, **_CURVE)
        title = f"{name} {leg + 1}"
        for text, unit, values, is_of_x, style in limits:
            limit, line = values[leg : leg + 1], axes.axvline if is_of_x else axes.axhline
            draw_limits(line, limit, x if is_of_x else y, style)
            title += f", {text} {limit[0]:.6g} {unit}" if np.isfinite(limit[0]) else ""
        axes.set_title(title, fontsize=9.0 if len(limits) == 1 else 7.5)
        axes.locator_params("x", nbins=5)
        axes.set(xlabel=labels[0] if leg >= LEGS - 2 else "", ylabel="" if leg % 2 else labels[1])
