"""Plausibility checks of a robot's log: units of lengths and angles, and the side of the base."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..io.array_types import Array
from ..motion.motion import Motion
from ..motion.rotation import rotation_about_axes
from ..motion.text.unit_row import LENGTH_UNITS
from ..motion.trajectory import MOST_TURNS, JointTrajectory, Log, PoseLog, angle_range
from ..robot.offset_chains import columns_of_H, joint_motion
from ..robot.robot import Robot
from .mounting import platform_side
from .offset_legs import leg_lengths
from .pose_search import rates_per_twist

# Number of samples that are checked.
_SOME = 64
# Factors of a mistaken unit: meters read as millimeters, meters as centimeters, centimeters as millimeters.
# The second value is the smallest plausible distance from the base, relative to the base size.
_TIMES, _NEAR = (1000, 100, 10), 0.2
# Plausible ranges of leg lengths relative to the machine size and to the longest leg, and the usual range,
# which determines the suggested units.
_SHARES_OF_SIZE, _SHARES_OF_LIMITS, _USUAL = (1.0 / 200.0, 20.0), (0.02, 5.0), (0.15, 3.0)
LEAST_TURN = 0.5
"""Smallest range of an angle (rad) that is checked for degrees."""


def log_doubts(robot: Robot, log: PoseLog | JointTrajectory, unit: str = "m") -> list[str]:
    """Return a warning text for each implausible property of a few samples, read in length unit ``unit``."""
    some = np.linspace(0, len(log.time) - 1, min(len(log.time), _SOME)).astype(np.int64)
    if isinstance(log, JointTrajectory):
        found = [length_doubt(robot, log.L[some], unit)]
    else:
        motion = log.at(some)
        found = [length_doubt(robot, leg_lengths(robot, motion.R, motion.t), unit), side_doubt(robot, motion)]
        if found[0] is None:
            found.append(unit_doubt(robot, log, some) or angle_doubt(robot, log, some))
    return [doubt for doubt in found if doubt is not None]


# Quantiles that bound the range of an angle, so that a few wrong rows have no effect.
_RANGE = (0.05, 0.95)


def need_units(robot: Robot, log: Log) -> None:
    """Raise ValueError with the remedy if lengths or angles fit the robot only in another unit.

    A row of units has no priority over the numbers. If an option gives the unit, ``log_doubts`` issues a
    warning instead.
    """
    some = np.linspace(0, len(log.time) - 1, min(len(log.time), _SOME)).astype(np.int64)
    written = {name: [x[some] for x in vector] for name, vector in log.written.items()}
    few = replace(log, time=log.time[some], rows=[log.rows[i] for i in some], written=written)
    if "length_unit" not in log.given_units:
        _need_length_unit(robot, log, few)
    if "angle_unit" not in log.given_units and "theta" in log.written:
        _need_angle_unit(robot, log, few)


def _need_length_unit(robot: Robot, log: Log, few: Log) -> None:
    low, high = _USUAL
    if "L" in few.written:
        lengths = few.vector("L")
        if log.form.length_mode == "relative":
            lengths, low = np.abs(lengths), 0.0
    else:
        lengths = leg_lengths(robot, *_reference_poses(robot, few))
    typical, size, (near, far), text = _beside_size(robot, lengths)
    written = typical / log.form.meters_per_unit
    units = [name for name, each in LENGTH_UNITS.items() if low * size <= each * written <= high * size]
    if units and not (near * size if low else 0.0) <= typical <= far * size:
        raise log.other_unit("length_unit", text, units)
    if "L" not in few.written and log.unit_line is not None and log.form.length_unit != "m":
        _need_larger_unit(robot, log, few)


def _need_larger_unit(robot: Robot, log: Log, few: Log) -> None:
    """Raise ValueError if the legs allow the positions only in a larger unit than in the row of units."""
    theta, _, order = few.angles()
    t, R = few.vector("t"), rotation_about_axes(theta, order)
    far = float(np.linalg.norm(t, axis=-1).max())
    how = impossible(robot, t, R, robot.tool) if far < _NEAR * np.ptp(robot.b, axis=0).max() else None
    if how is None:
        return
    units = [
        name
        for name, factor in LENGTH_UNITS.items()
        if factor > log.form.meters_per_unit
        and impossible(robot, t * factor / log.form.meters_per_unit, R, robot.tool) is None
    ]
    if units:
        raise log.other_unit("length_unit", f"t of up to {far:.3g} m, which leads {how}", units)


def _need_angle_unit(robot: Robot, log: Log, few: Log) -> None:
    theta = np.unwrap(log.vector("theta"), axis=0)
    spans = np.ptp(np.quantile(theta, _RANGE, axis=0), axis=0)
    if spans.max() <= LEAST_TURN:
        return
    t, order = few.vector("t"), log.form.rotation_order
    some = few.vector("theta")
    if log.form.radians_per_unit != 1.0:
        return
    R, in_degrees = (rotation_about_axes(angles, order) for angles in (some, np.radians(some)))
    wrong = np.any(spans > MOST_TURNS) or impossible(robot, t, R, robot.tool) is not None
    if wrong and impossible(robot, t, in_degrees, robot.tool) is None:
        axis = int(np.argmax(spans))
        finding = f"{angle_range(theta, axis)}, which the legs allow only in degrees"
        raise log.other_unit("angle_unit", finding, ["deg"])


def _reference_poses(robot: Robot, log: Log) -> tuple[Array, Array]:
    """Return R, shape (n, 3, 3), and t of the reference point (m), shape (n, 3), from a log of tool poses."""
    theta, _, order = log.angles()
    R = rotation_about_axes(theta, order)
    return R, log.vector("t") - R @ robot.tool


def length_doubt(robot: Robot, lengths: Array, unit: str = "m") -> str | None:
    """Return a warning text if leg lengths (m) do not fit the robot's size, else None.

    ``unit`` is the key of ``LENGTH_UNITS`` with which the log was read.
    """
    typical, size, (near, far), text = _beside_size(robot, lengths)
    if near * size <= typical <= far * size:
        return None
    low, high = _USUAL
    written = typical / LENGTH_UNITS[unit]
    units = [name for name, factor in LENGTH_UNITS.items() if low * size <= factor * written <= high * size]
    hints = [f"length_unit={name}" for name in units]
    cause = (
        f"are they in another unit ({' or '.join(hints)})"
        if units
        else f"is length_unit={unit} right, and are the robot file's lengths in meters"
        if typical < size
        else "is it the log of another machine, or are the robot file's lengths not in meters"
    )
    return f"{text}: {cause}?"


def meters_doubt(robot: Robot, lengths: Array) -> str | None:
    """Return a warning text if leg lengths (m) are far too large for the robot's size, else None."""
    typical, size, (_, far), text = _beside_size(robot, lengths)
    return None if typical <= far * size else f"{text}: in millimeters, expected meters?"


def _beside_size(robot: Robot, lengths: Array) -> tuple[float, float, tuple[float, float], str]:
    """Return the typical length and the reference size (m), the bounds of their ratio, and a text."""
    limits = robot.length_limits[np.isfinite(robot.length_limits[:, 1]), 1]
    size, shares, of = float(limits.max(initial=0.0)), _SHARES_OF_LIMITS, "legs of up to"
    if not limits.size:
        size, shares, of = float(np.ptp([robot.b, robot.p], axis=1).max()), _SHARES_OF_SIZE, "a machine of"
    typical = float(np.median(lengths))
    return typical, size, shares, f"lengths of {typical:.4g} m compared with {of} {size:.4g} m"


def angle_doubt(robot: Robot, log: PoseLog, some: NDArray[np.int64]) -> str | None:
    """Return a warning text if the legs allow the angles of some samples only in degrees, else None."""
    theta, t = log.coordinates[0, :, 3:], log.coordinates[0, some, :3]
    tool = np.zeros(3) if log.tool is None else log.tool
    spans = np.ptp(theta, axis=0)
    axis = int(np.argmax(spans))
    if not log.in_radians or not LEAST_TURN < spans[axis] or np.any(spans > MOST_TURNS):
        return None
    R, in_degrees = (rotation_about_axes(each, log.order) for each in (theta[some], np.radians(theta[some])))
    how = impossible(robot, t, R, tool)
    if how is None or impossible(robot, t, in_degrees, tool) is not None:
        return None
    return (
        f"{angle_range(theta, axis)} leads {how}, in degrees it does not: "
        "are angles in degrees (angle_unit=deg)?"
    )


def unit_doubt(robot: Robot, log: PoseLog, some: NDArray[np.int64]) -> str | None:
    """Return a warning text if the legs allow the poses only many times farther from the base, else None."""
    t, R = log.coordinates[0, some, :3], rotation_about_axes(log.coordinates[0, some, 3:], log.order)
    tool = np.zeros(3) if log.tool is None else log.tool
    far = float(np.linalg.norm(t, axis=-1).max())
    how = impossible(robot, t, R, tool) if far < _NEAR * np.ptp(robot.b, axis=0).max() else None
    for times in _TIMES if how is not None else ():
        if impossible(robot, times * t, R, tool) is None:
            cause = f"t of up to {far:.3g} m leads {how}, {times} times as much does not"
            return f"{cause}: is the unit of lengths right?"
    return None


def impossible(robot: Robot, t: Array, R: Array, tool: Array) -> str | None:
    """Return the reason for which tool poses are unreachable: length limits or a singular pose; else None."""
    t = t - R @ tool
    L = leg_lengths(robot, R, t)
    if np.any((robot.length_limits[:, 0] > L) | (robot.length_limits[:, 1] < L)):
        return "legs beyond length_limits"
    turned = np.linalg.det(rates_per_twist(robot, R, t))
    return "through a singular pose" if np.ptp(np.sign(turned)) > 0.0 else None


def side_change(robot: Robot, motion: Motion) -> int | None:
    """Return the index of the first of n poses after which det H changes its sign, else None.

    A singular pose exists between this pose and the next one.
    """
    with np.errstate(invalid="ignore"):
        if robot.offsets is None:
            H = rates_per_twist(robot, motion.R, motion.t)
        else:
            H = columns_of_H(robot, joint_motion(robot, motion).G)
        sign = np.sign(np.linalg.det(H))
    changes = np.flatnonzero(sign[1:] * sign[:-1] < 0.0)
    return int(changes[0]) if changes.size else None


def side_doubt(robot: Robot, motion: Motion) -> str | None:
    """Return a warning text if all poses (n,) are on the wrong side of the base, else None.

    The home pose or gravity determines the right side.
    """
    side = platform_side(robot)
    center = motion.t + motion.R @ robot.p.mean(axis=0) - robot.b.mean(axis=0)
    if not side.certain or np.any(center @ side.direction >= 0.0):
        return None
    where, unless = ("on the other side of the base than at home", "")
    if side.by_gravity:
        where = "below the base, in the direction of gravity,"
        unless = " (forces are correct for a suspended machine)"
    return (
        f"the platform is {where} in every sample: does z of the log point the other way than in the robot "
        f"file?{unless}"
    )
