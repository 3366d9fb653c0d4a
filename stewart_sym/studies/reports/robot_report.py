"""Report of ``check``: dimensions, masses, and limits of a robot, and its condition at the home pose."""

import warnings
from typing import Any

import numpy as np

from ...design.axis_travel import axis_travel
from ...drives.limits import MOTOR_LIMITS
from ...dynamics.home_pose import HomePose, home_pose
from ...io.array_types import Array
from ...kinematics.conditioning import characteristic_length
from ...kinematics.mounting_side import DECISIVE, AssemblyModeWarning, radius
from ...results import STATUS_TEXT
from ...robot.robot import Robot
from ...robot.units import Units, vector_text
from ..common.axis_table import axis_data, axis_text
from ..common.report import SMALL, Picture, Report
from .machine_plot import figure


def report(robot: Robot) -> Report:
    """Describe the robot in the units of its file, with its axis travel and a plot."""
    with warnings.catch_warnings():
        # The row "side" lists both sides if they are equally plausible.
        warnings.simplefilter("ignore", AssemblyModeWarning)
        home = home_pose(robot)
        travel = axis_travel(robot)
    unit = Units.of(robot)
    figures = {"machine": Picture(lambda: figure(robot, home), SMALL)}
    text = f"{_description(robot, home, unit)}\n\n{axis_text(travel, unit)}"
    data = _data(robot, home) | {"axis_travel": axis_data(travel)}
    return Report(text, data=data, figures=figures)


def _data(robot: Robot, home: HomePose) -> dict[str, Any]:
    """Return the keys of the robot file in SI units, and the home pose, for the JSON data."""
    return {
        "robot": robot.to_dict(),
        "impossible_inertias": robot.find_invalid_inertias(),
        "home_pose": {
            "rule": home.rule,
            "position_m": home.t,
            "leg_lengths_m": home.L,
            "status": home.status,
            "holding_forces_N": home.F,
            "condition_number": home.condition,
            "scaled_condition_number": home.scaled_condition,
            "above": home.side.direction,
            "characteristic_length_m": characteristic_length(robot),
        },
        "units": {"robot": "keys of a robot file in m, rad, and other SI units"},
    }


def _description(robot: Robot, home: HomePose, unit: Units) -> str:
    """Format the rows of the report without the axis travel."""
    bodies = dict.fromkeys(line.partition(": inertia")[0] for line in robot.find_invalid_inertias())
    sizes = [f"{radius(points) / unit.meters:.4g} {unit.length}" for points in (robot.b, robot.p)]
    tips = "spherical" if robot.offsets is None else robot.offsets.platform_joint
    rows = [
        ("name", robot.name),
        ("joints", f"{robot.base_joint} at the base, {tips} at the platform"),
        *_offsets(robot, unit),
        ("gravity", f"{vector_text(robot.g)} m/s^2"),
        *_masses(robot, unit),
        ("size", f"base points {sizes[0]}, platform points {sizes[1]} (RMS radius)"),
        *_conventions(robot, unit),
        ("friction", _friction(robot)),
        *_drives(robot, unit),
        ("limits", _limits(robot, unit)),
    ]
    if not robot.missing_bodies:
        bad = f"not physically possible: {', '.join(bodies)}"
        rows.append(("inertias", bad if bodies else "physically possible"))
    return "\n".join([*_rows(rows), "", *_home_lines(robot, home, unit)])


def _masses(robot: Robot, unit: Units) -> list[tuple[str, str]]:
    """Return rows about the masses, or the keys that are missing for forces."""
    if robot.missing_bodies:
        return [("masses", f"missing: {', '.join(robot.missing_bodies)}; kinematics only, no forces")]
    masses = robot.m_d + robot.m_u
    return [
        ("platform", f"{robot.M:g} kg, center of mass {unit.lengths(robot.R_0)} {unit.length}"),
        ("legs", f"{_range(masses)} kg each (lower {_range(robot.m_d)}, upper {_range(robot.m_u)})"),
        ("mass ratio", f"platform mass / leg mass {robot.M / np.mean(masses):.3g}"),
    ]


_OFFSETS = {
    "axis_offset": "from the fixed to the moving axis",
    "slide_offset_y": "along the moving axis",
    "slide_offset_z": "across the moving axis",
    "wrist_offset": "in the platform joint",
}


def _offsets(robot: Robot, unit: Units) -> list[tuple[str, str]]:
    """Return rows about offset joints and the crosses of the joints, if any."""
    offsets = robot.offsets
    if offsets is None:
        return []
    lengths = {where: getattr(offsets, name) / unit.meters for name, where in _OFFSETS.items()}
    parts = [f"{_range(each)} {unit.length} {where}" for where, each in lengths.items() if np.any(each)]
    rows = [("offsets", ", ".join(parts) or "all zero; delete them to use every feature")]
    if np.any(offsets.cross_mass) or np.any(offsets.cross_inertia):
        text = f"{_range(offsets.cross_mass)} kg, {_range(offsets.cross_inertia)} kg m^2 about the fixed axis"
        rows.append(("crosses", text))
    return rows


def _conventions(robot: Robot, unit: Units) -> list[tuple[str, str]]:
    """Return a row about the trajectory format of the robot, if it is not the default."""
    parts = []
    if robot.tool.any():
        parts.append(f"poses of the tool at {unit.lengths(robot.tool)} {unit.length} in the platform frame")
    form = robot.trajectory_format
    if form.rotation_order != "zyx":
        parts.append(f"R = {' '.join(f'R{axis}' for axis in form.rotation_order)}")
    for name, mode in (("leg lengths", form.length_mode), ("poses", form.pose_mode)):
        if mode == "relative":
            parts.append(f"{name} relative to the home pose")
    parts += [f"{name} from {header}" for name, header in form.columns.items()]
    return [("trajectories", ", ".join(parts))] if parts else []


def _home_lines(robot: Robot, home: HomePose, unit: Units) -> list[str]:
    """Format the home pose: side, position, leg lengths, condition, and leg forces."""
    shortest, longest = robot.length_limits.T
    legs = ", ".join(str(i + 1) for i in np.flatnonzero((home.L < shortest) | (home.L > longest)))
    outside = f"; outside the limits: leg {legs}" if legs else ""
    rows = [
        ("side", _side(robot, home)),
        ("position", f"{unit.lengths(home.t)} {unit.length}, level, at rest"),
        ("leg lengths", f"{unit.lengths(home.L)} {unit.length}{outside}"),
    ]
    if robot.tool.any():
        rows.insert(2, ("tool", f"{unit.lengths(home.t + robot.tool)} {unit.length} in the base frame"))
    if np.isfinite(longest).all() and not legs:
        back, forth = np.min(home.L - shortest), np.min(longest - home.L)
        span = f"{-back / unit.meters:.4g} to {forth / unit.meters:+.4g} {unit.length}"
        rows.append(("stroke", f"{span} from here"))
    if home.status:
        rows.append(("condition", f"unsolvable: {STATUS_TEXT[home.status]}"))
    else:
        by = f"{characteristic_length(robot) / unit.meters:.4g} {unit.length}"
        scaled = f"{home.scaled_condition:.4g} with moments divided by {by}"
        rows.append(("condition", f"condition number of H {home.condition:.4g}; {scaled}"))
    if not home.status and not robot.missing_bodies:
        rows.append(("leg forces", f"({', '.join(f'{force:.6g}' for force in home.F.tolist())}) N"))
    place = "platform centered above the base; " if robot.home_position is None else ""
    return [f"home pose: {place}{home.rule}", *_rows(rows)]


def _side(robot: Robot, home: HomePose) -> str:
    """Describe the side of the base at home, and the sign of the leg load if gravity determines it."""
    direction, rule, _ = home.side
    text, pull = f"{vector_text(direction)} of the base, {rule}", float(direction @ robot.g)
    if abs(pull) <= DECISIVE * np.linalg.norm(robot.g):
        return text
    return f"{text}; the platform {'stands on its legs' if pull < 0.0 else 'hangs below its base'}"


def _rows(rows: list[tuple[str, str]]) -> list[str]:
    return [f"{name:<12} {text}" for name, text in rows]


def _friction(robot: Robot) -> str:
    if not np.any([robot.C_u, robot.C_p, robot.C_s]):
        return "off"
    base, slide, tip = map(_range, (robot.C_u, robot.C_p, robot.C_s))
    return f"on: base joint {base} N m s, prismatic {slide} N s/m, spherical {tip} N m s"


_DRIVE_FRICTION = {
    "screw_coulomb": ("Coulomb friction along the leg", "N"),
    "stribeck_force": ("Stribeck force", "N"),
    "motor_coulomb": ("Coulomb friction of the motor", "N m"),
}
"""Text and unit of the friction of a drive."""


def _drives(robot: Robot, unit: Units) -> list[tuple[str, str]]:
    """Return rows about the drives and, if any are given, the limits of their motors."""
    drive = robot.drive
    if drive is None:
        return []
    parts = [
        f"{_range(drive.lead / drive.gear_ratio / unit.meters)} {unit.length} per motor revolution",
        f"reflected mass {_range(drive.reflected_mass, 4)} kg",
        f"efficiency {_range(drive.efficiency)} driving, {_range(drive.backdrive_efficiency, 4)} backdriving",
    ]
    for name, (words, per) in _DRIVE_FRICTION.items():
        if np.any(getattr(drive, name)):
            parts.append(f"{words} {_range(getattr(drive, name))} {per}")
    most = []
    for name, limit in MOTOR_LIMITS.items():
        bound, (scale, per) = limit.bound(robot), unit.of_unit(limit.unit)
        if np.isfinite(bound).any():
            most.append(f"{name.replace('_', ' ')} up to {_range(scale * bound, 4)} {per}")
    return [("drives", ", ".join(parts)), *([("motors", ", ".join(most))] if most else [])]


def _limits(robot: Robot, unit: Units) -> str:
    """Format the limits of the legs, each with the number of legs that have it."""
    parts = []
    for name, limits, si_unit in (
        ("length", robot.length_limits.T, "m"),
        ("force", robot.force_limit[None], "N"),
        ("speed", robot.speed_limit[None], "m/s"),
        ("joint angles from home, base and platform joint,", robot.joint_angle_limit.T, "rad"),
    ):
        given, (scale, per) = np.isfinite(limits[-1]), unit.of_unit(si_unit)
        if given.any():
            some = "" if given.all() else f" ({np.count_nonzero(given)} of 6 legs)"
            between, digits = (" and ", 4) if si_unit == "rad" else (" to ", 6)
            span = between.join(_range(scale * end[given], digits) for end in limits)
            parts.append(f"{name} {span} {per}{some}")
        elif si_unit != "rad":
            parts.append(f"{name} none")
    return "; ".join(parts)


def _range(values: Array, digits: int = 6) -> str:
    low, high = (f"{value:.{digits}g}" for value in (np.min(values), np.max(values)))
    between = " to " if low.startswith("-") else "-"
    return low if low == high else f"{low}{between}{high}"
