"""Picture of what motions need: force over speed, shares of the time, strokes, joint angles, limits."""

from typing import Any

import numpy as np

from ...design.size import Needs
from ...io.array_types import Array
from ...robot.robot import LEGS, Robot
from ..common.drawing import DARK, LEG_COLORS, Axes, Figure, as_written, legend_below, new_figure
from ..common.report import SMALL, Picture

_LIMIT: dict[str, Any] = {"color": "#9c1f1f", "linestyle": (0, (4, 2)), "linewidth": 1.1}
_MOST = 4000
"""Points of a leg that are drawn."""


def pictures(robot: Robot, needs: Needs) -> dict[str, Picture]:
    """``size``."""
    return {"size": Picture(lambda: figure(robot, needs), SMALL)}


def figure(robot: Robot, needs: Needs) -> Figure:
    """Four panels; of a robot with drives six."""
    driven = needs.course.torque is not None
    drawn = new_figure(15.5 if driven else 11.0, 8.2)
    panels = drawn.subplots(2, 3 if driven else 2)
    course = needs.course
    _plane(panels[0, 0], course.L_dot, course.F, robot.speed_limit, robot.force_limit)
    panels[0, 0].set(xlabel="rate of length, m/s", ylabel="actuator force, N")
    _shares(panels[0, 1], np.abs(course.F), course.weight, robot.force_limit)
    panels[0, 1].set(xlabel="share of the time, %", ylabel="size of the force exceeded, N")
    _strokes(panels[1, 0], robot, needs)
    _angles(panels[1, 1], robot, needs)
    if course.torque is not None and course.motor_speed is not None and robot.drive is not None:
        drive = robot.drive
        speed, torque = (np.asarray(limit) for limit in (drive.speed_limit, drive.torque_limit))
        _plane(panels[0, 2], course.motor_speed, course.torque, speed, torque)
        panels[0, 2].set(xlabel="motor speed, rad/s", ylabel="motor torque, N m")
        _shares(panels[1, 2], np.abs(course.torque), course.weight, torque)
        panels[1, 2].set(xlabel="share of the time, %", ylabel="size of the torque exceeded, N m")
    margin = f"margin {100.0 * needs.margin:g} %: pale" if needs.margin else "no margin"
    drawn.suptitle(f"{as_written(robot.name)}: what the motions need; limits dashed; {margin}", fontsize=10.0)
    handles = [
        panels[0, 0].plot([], [], marker="o", linestyle="", color=color, label=f"leg {leg + 1}")[0]
        for leg, color in enumerate(LEG_COLORS)
    ]
    legend_below(drawn, handles)
    return drawn


def _plane(axes: Axes, rate: Array, effort: Array, most_rate: Array, most_effort: Array) -> None:
    """Each leg's effort over its rate, and the limits that are near enough to be in the picture."""
    step = max(1, len(rate) // _MOST)
    for leg, color in enumerate(LEG_COLORS):
        axes.plot(rate[::step, leg], effort[::step, leg], color=color, linewidth=0.8, alpha=0.8)
    across, along = 1.1 * np.abs(rate).max() or 1.0, 1.1 * np.abs(effort).max() or 1.0
    axes.axhline(0.0, color=DARK, linewidth=0.7)
    axes.axvline(0.0, color=DARK, linewidth=0.7)
    for limit, size, draw in ((most_rate, across, axes.axvline), (most_effort, along, axes.axhline)):
        for value in np.unique(limit[np.isfinite(limit)]):
            for side in (-value, value) if value < 3.0 * size else ():
                draw(side, **_LIMIT)


def _shares(axes: Axes, sizes: Array, weight: Array, limit: Array) -> None:
    """For which share of the time each leg's effort, (n, 6), is above a size."""
    for leg, color in enumerate(LEG_COLORS):
        order = np.argsort(-sizes[:, leg])
        above = np.cumsum(weight[order]) / weight.sum()
        axes.plot(100.0 * above, sizes[order, leg], color=color, linewidth=1.1)
    for value in np.unique(limit[np.isfinite(limit)]):
        if value < 3.0 * sizes.max():
            axes.axhline(value, **_LIMIT)
    axes.set_xlim(0.0, 100.0)
    axes.set_ylim(bottom=0.0)


def _strokes(axes: Axes, robot: Robot, needs: Needs) -> None:
    """Lengths that each leg takes, with the margin, and its limits."""
    more = 0.5 * needs.margin * needs.stroke
    for leg, color in enumerate(LEG_COLORS):
        low, high = needs.length[leg]
        axes.bar(
            leg + 1, high - low + 2.0 * more[leg], bottom=low - more[leg], color=color, alpha=0.3, width=0.6
        )
        axes.bar(leg + 1, high - low, bottom=low, color=color, width=0.6)
        for limit in robot.length_limits[leg]:
            if np.isfinite(limit) and limit > 0.0:
                axes.hlines(limit, leg + 0.6, leg + 1.4, **_LIMIT)
    axes.set(xlabel="leg", ylabel="length, m", xticks=range(1, LEGS + 1))
    axes.margins(y=0.08)


def _angles(axes: Axes, robot: Robot, needs: Needs) -> None:
    """Largest angles of the joints at the base, left, and at the platform, right and hatched."""
    ends = ((needs.base_angle, -0.2, ""), (needs.platform_angle, 0.2, "///"))
    for end, (angles, shift, hatch) in enumerate(ends):
        for leg, color in enumerate(LEG_COLORS):
            place, angle = leg + 1 + shift, np.degrees(angles[leg])
            axes.bar(place, angle * (1.0 + needs.margin), color=color, alpha=0.3, width=0.36)
            axes.bar(place, angle, color=color, width=0.36, hatch=hatch, edgecolor="white")
            limit = robot.joint_angle_limit[leg, end]
            if limit < np.pi:
                axes.hlines(np.degrees(limit), place - 0.2, place + 0.2, **_LIMIT)
    axes.set(
        xlabel="leg; base joint left, platform joint right, hatched",
        ylabel="joint angle, degrees",
        xticks=range(1, LEGS + 1),
    )
