"""Report of ``size-actuators``: requirements of every actuator and joint, and the limits of the robot."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ...design.actuator_requirements import ActuatorRequirementsResult
from ...design.limit_margins import compared, states_limits
from ...drives.limit_status import unknown_forces
from ...io.array_types import Array
from ...robot.robot import LEGS, Robot
from ...robot.units import Units
from ..common import drawing
from ..common.drawing import LIMIT, Axes, Figure, as_written, draw_limits, legend_below, new_figure
from ..common.report import SMALL, Picture, Report
from ..common.text_tables import aligned, amounts

_ROWS = (
    ("force", "force", "N"),
    ("force, rms", "rms_force", "N"),
    ("push force, peak", "max_push_force", "N"),
    ("pull force, peak", "max_pull_force", "N"),
    ("speed", "speed", "m/s"),
    ("power", "power", "W"),
    ("power into the leg", "max_driving_power", "W"),
    ("power out of the leg", "max_braking_power", "W"),
    ("torque", "torque", "N m"),
    ("torque, rms", "rms_torque", "N m"),
    ("motor speed", "motor_speed", "rad/s"),
    ("current", "current", "A"),
    ("motor power", "motor_power", "W"),
    ("stroke", "stroke", "m"),
    ("leg length", "length", "m"),
    ("base joint", "base_angle", "rad"),
    ("platform joint", "platform_angle", "rad"),
)
"""Name, attribute, and SI unit of the requirements; attributes of shape (q, 6) have a row per quantile."""
_ENDS = ("shortest leg", "longest leg")
"""Names of the rows of ``length``, which have no margin."""
_RATED: dict[str, Any] = {"color": drawing.DARK, "linewidth": 1.0, "linestyle": (0, (1, 1.5))}
_DIGITS = 4
"""Number of digits in the table."""
_LEGS = np.arange(1, LEGS + 1)
_MOST = 4000
"""Largest number of drawn points per leg."""


def report(robot: Robot, sources: Sequence[str], needs: ActuatorRequirementsResult) -> Report:
    """Create the report: text, data, a table of the requirements, and a plot."""
    legs = [f"leg{leg + 1}" for leg in range(LEGS)]
    header = ("need", "unit", *legs, *(f"{leg}_std" for leg in legs if needs.std is not None))
    found = [(*row, *values, *(() if sd is None else sd)) for *row, values, sd in rows(needs)]
    columns = map(np.array, zip(*found, strict=True))
    figures = {"size": Picture(lambda: figure(robot, needs), SMALL)}
    tables = {"needs": dict(zip(header, columns, strict=True))}
    return Report(_text(robot, sources, needs), tables, _data(robot, sources, needs), figures)


def doubts(robot: Robot, needs: ActuatorRequirementsResult, source: Path) -> list[str]:
    """Return warnings about undetermined forces and about the limits of the robot in the file ``source``."""
    limits = compared(robot, needs)
    lines = [line for part in limits for line in part]
    return [*_unknown(needs), *([f"{source}: {_verdict(robot, needs)}; {lines[0]}"] if lines else [])]


def _verdict(robot: Robot, needs: ActuatorRequirementsResult) -> str:
    """Return the result of the comparison with the limits in one line."""
    limits = compared(robot, needs)
    if needs.crossings:
        return "no force is sufficient: a motion crosses a singular pose"
    if not any(limits) and _unknown(needs):
        return "inconclusive: forces cannot be determined at this noise level"
    if not any(limits):
        margin = f"with the margin of {100.0 * needs.margin:g} %"
        return f"no limit is exceeded, {margin}" if states_limits(robot) else "the robot file states no limit"
    exceeded, missing = len(limits.exceeded), len(limits.margin_missing)
    possible = len(limits.inconclusive) + len(limits.margin_inconclusive)
    text = f"limits exceeded: {exceeded}, limits without the margin: {missing}"
    return f"{text}, inconclusive: {possible}" if possible else text


def _unknown(needs: ActuatorRequirementsResult) -> list[str]:
    """Return a warning about forces that cannot be determined at the noise of the logs, if there are any."""
    course = needs.history
    if course.std is None or course.replaced is None:
        return []
    text = unknown_forces(course.F, np.where(course.replaced[:, None], 0.0, course.std["F"]))
    return [] if text is None else [text]


def rows(needs: ActuatorRequirementsResult) -> Iterator[tuple[str, str, Array, Array | None]]:
    """Yield name, unit, values, and standard deviations, if any, shape (6,), of every requirement."""
    quantiles = [f"{100.0 * share:g} % of time" if share < 1.0 else "peak" for share in needs.quantiles]
    for name, attribute, unit in _ROWS:
        values, sd = getattr(needs, attribute), (needs.std or {}).get(attribute)
        if values is not None and values.ndim == 1:
            yield name, unit, values, sd
        elif values is not None:
            is_length = attribute == "length"
            for k, title in enumerate(_ENDS if is_length else [f"{name}, {text}" for text in quantiles]):
                part = np.s_[:, k] if is_length else k
                yield title, unit, values[part], None if sd is None else sd[part]


def _text(robot: Robot, sources: Sequence[str], needs: ActuatorRequirementsResult) -> str:
    """Format the requirements in the units of the robot file, and the comparison with its limits."""
    cells = []
    for name, si_unit, values, sd in rows(needs):
        scale, unit = Units.of(robot).of_unit(si_unit)
        texts = amounts(scale * values, None if sd is None else scale * sd, _DIGITS)
        largest = scale * (1.0 + needs.margin) * np.nanmax(values)
        cells.append((f"{name}, {unit}", *texts, "" if name in _ENDS else f"{largest:.{_DIGITS}g}"))
    neutral = "the home pose" if robot.home_position is not None else "the mean direction of each leg"
    found = compared(robot, needs)
    lines = [
        f"verdict {_verdict(robot, needs)}",
        f"robot   {robot.name}",
        f"motions {', '.join(sources)}: {needs.history.time_weight.sum():.6g} s",
        f"margin  {100.0 * needs.margin:g} %, added to the largest value of each row in the last column",
        "",
        aligned(("need", *(f"leg {leg}" for leg in _LEGS), "with margin"), cells),
        "",
        f"Joint angles are from {neutral}.",
    ]
    if needs.std is not None:
        lines.append("+-: standard deviations that the noise of the logs leaves, at most.")
    told = [f"{text}." for text in _unknown(needs)]
    told += [*(f"exceeded: {line}" for line in found.exceeded), *found.inconclusive]
    told += [*(f"margin missing: {line}" for line in found.margin_missing), *found.margin_inconclusive]
    return "\n".join([*lines, *needs.crossings, *(line[:1].upper() + line[1:] for line in told)])


def _data(robot: Robot, sources: Sequence[str], needs: ActuatorRequirementsResult) -> dict[str, Any]:
    """Return the requirements in SI units, and the comparison with the limits, for the JSON data."""
    units = {name: unit for _, name, unit in _ROWS if getattr(needs, name) is not None}
    return {
        "robot": robot.name,
        "motions": list(sources),
        "margin": needs.margin,
        "quantiles": needs.quantiles,
        **{name: getattr(needs, name) for name in units},
        "std": dict(needs.std or {}),
        **compared(robot, needs)._asdict(),
        "warnings": _unknown(needs),
        "crossings": list(needs.crossings),
        "units": units,
    }


def figure(robot: Robot, needs: ActuatorRequirementsResult) -> Figure:
    """Draw force over speed, strokes, joint angles, and with drives the motor torque over the motor speed."""
    course, drive, units = needs.history, robot.drive, Units.of(robot)
    drawn = new_figure(15.0, 4.8) if drive is None else new_figure(11.0, 8.6)
    panels = drawn.subplots(1, 3) if drive is None else drawn.subplots(2, 2).ravel()
    rates, most = course.L_dot / units.meters, robot.speed_limit / units.meters
    _plane(panels[0], rates, course.F, most, robot.force_limit)
    panels[0].set(xlabel=f"rate of length, {units.length}/s", ylabel="actuator force, N")
    _strokes(panels[1], robot, needs)
    _angles(panels[2], robot, needs)
    if course.torque is not None and course.motor_speed is not None and drive is not None:
        rates, most = course.motor_speed / units.radians, drive.speed_limit / units.radians
        _plane(panels[3], rates, course.torque, most, drive.torque_limit)
        draw_limits(panels[3].axhline, drive.rated_torque, course.torque, _RATED)
        if np.isfinite(drive.rated_torque).any():
            panels[3].set_title("dotted: rated torque, limit of the root mean square", fontsize=8.0)
        panels[3].set(xlabel=f"motor speed, {units.angle}/s", ylabel="motor torque, N m")
    margin = f"margin {100.0 * needs.margin:g} %: pale" if needs.margin else "no margin"
    title = f"{as_written(robot.name)}: requirements of the motions; limits dashed; {margin}"
    drawn.suptitle(title, fontsize=10.0)
    legend_below(drawn)
    return drawn


def _strokes(axes: Axes, robot: Robot, needs: ActuatorRequirementsResult) -> None:
    """Draw the lengths of each leg, its stroke with the margin, and the limits of the lengths."""
    units = Units.of(robot)
    (low, high), limits = needs.length.T / units.meters, robot.length_limits.T / units.meters
    stroke = (1.0 + needs.margin) * needs.stroke / units.meters
    # Half of the margin is at each end, unless a limit shifts it to the other end.
    bottom = np.minimum(np.maximum(0.5 * (low + high - stroke), limits[0]), limits[1] - stroke)
    bottom = np.minimum(np.maximum(bottom, high - stroke), low)
    _bars(axes, _LEGS, bottom, stroke, alpha=0.3, width=0.6)
    _bars(axes, _LEGS, low, high - low, *limits, width=0.6)
    axes.use_sticky_edges = False
    axes.set(xlabel="leg", ylabel=f"length, {units.length}", xticks=_LEGS)


def _angles(axes: Axes, robot: Robot, needs: ActuatorRequirementsResult) -> None:
    """Draw the largest angles of the joints at the base, left, and at the platform, right and hatched."""
    size, unit = Units.of(robot).of_unit("rad")
    for angles, limits, place, hatch in (
        (size * needs.base_angle, size * robot.joint_angle_limit[:, 0], _LEGS - 0.2, ""),
        (size * needs.platform_angle, size * robot.joint_angle_limit[:, 1], _LEGS + 0.2, "///"),
    ):
        _bars(axes, place, 0.0, (1.0 + needs.margin) * angles, alpha=0.3, width=0.36)
        _bars(axes, place, 0.0, angles, limits, hatch=hatch, edgecolor="white", width=0.36)
    axes.set(xlabel="leg; base joint left, platform joint right, hatched", ylabel=f"joint angle, {unit}")
    axes.set_xticks(_LEGS)


def _bars(axes: Axes, x: Any, bottom: Array | float, height: Array, *limits: Array, **style: Any) -> None:
    """Draw a bar of each leg, and its limits across it, shape (6,) each, as far as they are given."""
    half = 0.6 * style["width"]
    axes.bar(x, height, bottom=bottom, color=drawing.LEG_COLORS, **style)
    for limit in limits:
        given = np.isfinite(limit) & (limit > 0.0)
        axes.hlines(limit[given], x[given] - half, x[given] + half, **LIMIT)


def _plane(axes: Axes, rate: Array, effort: Array, most_rate: Array, most_effort: Array) -> None:
    """Draw the effort of each leg over its rate, and the limits near the range of the curves."""
    step = max(1, len(rate) // _MOST)
    for line in (axes.axhline, axes.axvline):
        line(0.0, color=drawing.DARK, linewidth=0.7)
    for leg, color in enumerate(drawing.LEG_COLORS):
        style: Any = {"color": color, "label": f"leg {leg + 1}", "linewidth": 0.8, "alpha": 0.8}
        axes.plot(rate[::step, leg], effort[::step, leg], **style)
    for limits, values, line in ((most_rate, rate, axes.axvline), (most_effort, effort, axes.axhline)):
        draw_limits(line, limits, values, LIMIT)
