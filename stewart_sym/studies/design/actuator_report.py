"""Report of ``size-actuators``: requirements of every actuator and joint, compared with the limits of the
robot.

The plot contains force over speed, exceedance of force over time, strokes, and joint angles.
"""

import functools
from collections.abc import Callable, Iterator, Sequence
from types import SimpleNamespace
from typing import Any

import numpy as np

from ...design.actuator_requirements import ActuatorRequirementsResult
from ...design.limit_margins import LimitMargins, compared, states_limits
from ...drives.limit_status import shows, spread_text, unknown_forces
from ...io.array_types import Array
from ...motion.trajectory import PoseLog, Trajectory
from ...robot.robot import LEGS, Robot
from ...viewer.motion_history import of_trajectory
from ...viewer.view import Viewer
from ..common.drawing import DARK, LEG_COLORS, Axes, Figure, as_written, legend_below, new_figure
from ..common.output import aligned, csv_text
from ..common.report import SMALL, Picture, Report

_UNITS = (
    {
        "force": "N",
        "speed": "m/s",
        "power": "W",
        "max_push_force": "N",
        "max_pull_force": "N",
        "rms_force": "N",
        "max_driving_power": "W",
    }
    | {"max_braking_power": "W", "length": "m", "stroke": "m", "base_angle": "rad", "platform_angle": "rad"}
    | {"torque": "N m", "motor_speed": "rad/s", "current": "A", "motor_power": "W", "rms_torque": "N m"}
)
"""Units of the values in the JSON data."""

_LIMIT: dict[str, Any] = {"color": "#9c1f1f", "linestyle": (0, (4, 2)), "linewidth": 1.1}
_DIGITS = 4
"""Number of digits in the table."""
_MOST = 4000
"""Largest number of drawn points per leg."""


def report(robot: Robot, sources: Sequence[str], needs: ActuatorRequirementsResult) -> Report:
    """Create the report: text, data, a table of the requirements, and a plot."""
    text, tables = _text(robot, sources, needs), {"needs": _table(needs)}
    figures = {"size": Picture(lambda: figure(robot, needs), SMALL)}
    return Report(text, tables, _data(robot, sources, needs), figures)


def views(
    robot: Robot, sources: Sequence[str], read: Sequence[Trajectory | PoseLog]
) -> dict[str, Callable[[], Viewer]]:
    """Return functions that create the view of each motion; files of the same name are numbered."""
    made: dict[str, Callable[[], Viewer]] = {}
    for number, (source, trajectory) in enumerate(zip(sources, read, strict=True), 1):
        name = f"{source}, motion {number}" if sources.count(source) > 1 else source
        made[name] = functools.partial(lambda each: Viewer(robot, of_trajectory(robot, each)), trajectory)
    return made


def doubt(needs: ActuatorRequirementsResult) -> str | None:
    """Return a warning about forces that cannot be determined at the noise of the logs, or None."""
    course = needs.history
    if course.std is None or course.replaced is None:
        return None
    return unknown_forces(course.F, np.where(course.replaced[:, None], 0.0, course.std["F"]))


def rows(needs: ActuatorRequirementsResult | SimpleNamespace) -> Iterator[tuple[str, str, Array]]:
    """Yield name, unit, and value for each leg, shape (6,), of every requirement, without the margin.

    The argument may also contain the standard deviations of the requirements.
    """
    for name in ("force", "speed", "power", "torque", "motor_speed", "current", "motor_power"):
        unit, values = _UNITS[name], getattr(needs, name)
        for share, at in zip(needs.quantiles, () if values is None else values, strict=values is not None):
            words = "peak" if share == 1.0 else f"{100.0 * float(share):g} % of time"
            yield f"{name.replace('_', ' ')}, {words}", unit, at
        if name == "force":
            yield "force, rms", unit, needs.rms_force
            yield "max_push_force", unit, needs.max_push_force
            yield "max_pull_force", unit, needs.max_pull_force
        if name == "power":
            yield "power into the leg", unit, needs.max_driving_power
            yield "power out of the leg", unit, needs.max_braking_power
        if name == "torque" and needs.rms_torque is not None:
            yield "torque, rms", unit, needs.rms_torque
    yield "stroke", "m", needs.stroke
    yield "shortest leg", "m", needs.length[:, 0]
    yield "longest leg", "m", needs.length[:, 1]
    yield "base joint", "degrees", np.degrees(needs.base_angle)
    yield "platform joint", "degrees", np.degrees(needs.platform_angle)


def _deviations(needs: ActuatorRequirementsResult) -> Iterator[Array | None]:
    """Yield the standard deviations of ``rows``, shape (6,), or None without noise."""
    if needs.std is None:
        yield from (None for _ in rows(needs))
        return
    optional = dict.fromkeys(("torque", "motor_speed", "motor_power", "current", "rms_torque"))
    sd = SimpleNamespace(quantiles=needs.quantiles, **(optional | dict(needs.std)))
    yield from (values for _, _, values in rows(sd))


def _text(robot: Robot, sources: Sequence[str], needs: ActuatorRequirementsResult) -> str:
    no_margin = ("shortest leg", "longest leg")
    more = 1.0 + needs.margin
    cells, noisy = [], False
    for (name, unit, values), sd in zip(rows(needs), _deviations(needs), strict=True):
        last = "" if name in no_margin else f"{more * np.nanmax(values):.{_DIGITS}g}"
        cells.append((f"{name}, {unit}", *(f"{value:.{_DIGITS}g}" for value in values), last))
        seen = np.zeros(LEGS, dtype=bool) if sd is None else shows(values, sd, _DIGITS)
        if sd is not None and seen.any():
            noisy = True
            cells.append(
                ("  +-", *(spread_text(off) if each else "" for off, each in zip(sd, seen, strict=True)), "")
            )
    legs = [f"leg {leg + 1}" for leg in range(LEGS)]
    neutral = "the home pose" if robot.home_position is not None else "the mean direction of each leg"
    lines = [
        f"robot   {robot.name}",
        f"motions {', '.join(sources)}: {needs.history.time_weight.sum():.6g} s",
        f"margin  {100.0 * needs.margin:g} %: the last column is the largest value of the row with it",
        "",
        aligned(("need", *legs, "with margin"), cells),
        "",
        f"Joint angles are from {neutral}.",
    ]
    unknown = doubt(needs)
    if noisy:
        lines.append("+-: standard deviations that the noise of the logs leaves, at most.")
    if unknown is not None:
        lines.append(f"{unknown[0].upper()}{unknown[1:]}.")
    found = compared(robot, needs)
    told = [*needs.crossings, *(f"Exceeded: {line}" for line in found.exceeded)]
    told += [f"{line[0].upper()}{line[1:]}" for line in found.inconclusive]
    told += [f"Margin missing: {line}" for line in found.margin_missing]
    told += [f"{line[0].upper()}{line[1:]}" for line in found.margin_inconclusive]
    if not told:
        stated = states_limits(robot, needs)
        told = ["Every limit of the robot file suffices." if stated else "The robot file states no limit."]
    return "\n".join([*lines, *told])


def _data(robot: Robot, sources: Sequence[str], needs: ActuatorRequirementsResult) -> dict[str, Any]:
    found = compared(robot, needs)
    kept = {name: getattr(needs, name) for name in _UNITS if getattr(needs, name) is not None}
    return {
        "robot": robot.name,
        "motions": list(sources),
        "margin": needs.margin,
        "quantiles": needs.quantiles,
        **kept,
        "exceeded": found.exceeded,
        "margin_missing": found.margin_missing,
        "crossings": list(needs.crossings),
        **_data_of_noise(found, needs),
        "units": {name: _UNITS[name] for name in kept},
    }


def _data_of_noise(found: LimitMargins, needs: ActuatorRequirementsResult) -> dict[str, Any]:
    """Return standard deviations and undecided limits for the JSON data; nothing without noise."""
    if needs.std is None:
        return {}
    unknown = doubt(needs)
    return {
        "std": dict(needs.std),
        "inconclusive": found.inconclusive,
        "margin_inconclusive": found.margin_inconclusive,
        "warnings": [] if unknown is None else [unknown],
    }


def _table(needs: ActuatorRequirementsResult) -> str:
    legs = [f"leg{leg + 1}" for leg in range(LEGS)]
    header = ("need", "unit", *legs, *(f"{leg}_std" for leg in legs if needs.std is not None))
    found = [
        (name, unit, *values.tolist(), *([] if sd is None else sd.tolist()))
        for (name, unit, values), sd in zip(rows(needs), _deviations(needs), strict=True)
    ]
    return csv_text([header, *found])


def figure(robot: Robot, needs: ActuatorRequirementsResult) -> Figure:
    """Draw four panels, or six for a robot with drives."""
    driven = needs.history.torque is not None
    drawn = new_figure(15.5 if driven else 11.0, 8.2)
    panels = drawn.subplots(2, 3 if driven else 2)
    course = needs.history
    _plane(panels[0, 0], course.L_dot, course.F, robot.speed_limit, robot.force_limit)
    panels[0, 0].set(xlabel="rate of length, m/s", ylabel="actuator force, N")
    _shares(panels[0, 1], np.abs(course.F), course.time_weight, robot.force_limit)
    panels[0, 1].set(xlabel="share of the time, %", ylabel="size of the force exceeded, N")
    _strokes(panels[1, 0], robot, needs)
    _angles(panels[1, 1], robot, needs)
    if course.torque is not None and course.motor_speed is not None and robot.drive is not None:
        drive = robot.drive
        speed, torque = (np.asarray(limit) for limit in (drive.speed_limit, drive.torque_limit))
        _plane(panels[0, 2], course.motor_speed, course.torque, speed, torque)
        panels[0, 2].set(xlabel="motor speed, rad/s", ylabel="motor torque, N m")
        _shares(panels[1, 2], np.abs(course.torque), course.time_weight, torque)
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
    """Draw the effort of each leg over its rate, and the limits near the range of the curves."""
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
    """Draw the fraction of the time in which the effort of each leg, shape (n, 6), exceeds a value."""
    for leg, color in enumerate(LEG_COLORS):
        order = np.argsort(-sizes[:, leg])
        above = np.cumsum(weight[order]) / weight.sum()
        axes.plot(100.0 * above, sizes[order, leg], color=color, linewidth=1.1)
    for value in np.unique(limit[np.isfinite(limit)]):
        if value < 3.0 * sizes.max():
            axes.axhline(value, **_LIMIT)
    axes.set_xlim(0.0, 100.0)
    axes.set_ylim(bottom=0.0)


def _strokes(axes: Axes, robot: Robot, needs: ActuatorRequirementsResult) -> None:
    """Draw the lengths and the stroke of each leg with the margin, and the limits of the lengths."""
    strokes = (1.0 + needs.margin) * needs.stroke
    for leg, (color, stroke) in enumerate(zip(LEG_COLORS, strokes, strict=True)):
        low, high = needs.length[leg]
        least, most = robot.length_limits[leg]
        # Half of the margin is at each end, unless a limit shifts it to the other end.
        bottom = min(max(0.5 * (low + high - stroke), least), most - stroke)
        bottom = min(max(bottom, high - stroke), low)
        axes.bar(leg + 1, stroke, bottom=bottom, color=color, alpha=0.3, width=0.6)
        axes.bar(leg + 1, high - low, bottom=low, color=color, width=0.6)
        for limit in (least, most):
            if np.isfinite(limit) and limit > 0.0:
                axes.hlines(limit, leg + 0.6, leg + 1.4, **_LIMIT)
    axes.use_sticky_edges = False
    axes.set(xlabel="leg", ylabel="length, m", xticks=range(1, LEGS + 1))
    axes.margins(y=0.08)


def _angles(axes: Axes, robot: Robot, needs: ActuatorRequirementsResult) -> None:
    """Draw the largest angles of the joints at the base, left, and at the platform, right and hatched."""
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
