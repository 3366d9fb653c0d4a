"""Plausibility checks of a robot's log: units of lengths and angles, and the side of the base."""

import itertools
import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..io.array_types import Array
from ..io.error_policy import warn
from ..motion.log_samples import LogSamples
from ..motion.motion import Motion
from ..motion.rotation import rotation_about_axes
from ..motion.trajectory import Trajectory
from ..motion.trajectory_format import ANGLE_UNITS, LENGTH_UNITS, TrajectoryWarning
from ..robot.robot import Robot
from ..robot.units import Units, vector_text
from .inverse_kinematics import leg_lengths
from .mounting_side import platform_side
from .pose_search import rates_per_twist

# Number of samples that are checked.
_SOME = 64
# Smallest plausible distance from the base, relative to the base size.
_NEAR = 0.2
# Plausible ranges of leg lengths relative to the machine size and to the longest leg, and the usual range,
# which determines the suggested units.
_SHARES_OF_SIZE, _SHARES_OF_LIMITS, _USUAL = (1.0 / 200.0, 20.0), (0.02, 5.0), (0.15, 3.0)
# Typical distances from home, relative to the home position, that contradict it and that agree with it.
_FAR, _CLOSE = 0.5, 0.2
LEAST_TURN = 0.5
"""Smallest range of an angle (rad) that is checked for degrees."""
MOST_TURNS = (math.pi, math.pi, 2.0 * math.pi)
"""Largest ranges of the tilts and of the turn of a platform (rad)."""


def log_doubts(robot: Robot, log: Trajectory) -> list[str]:
    """Return a warning text for each implausible property of a few samples."""
    some = np.linspace(0, len(log.time) - 1, min(len(log.time), _SOME)).astype(np.int64)
    if log.in_joints:
        found = [length_doubt(robot, log.lengths[0, some])]
    else:
        motion = log.at(some)
        found = [length_doubt(robot, leg_lengths(robot, motion.R, motion.t)), side_doubt(robot, motion)]
    return [doubt for doubt in found if doubt is not None]


# Quantiles that bound the range of an angle, so that a few wrong rows have no effect.
_RANGE = (0.05, 0.95)


def need_units(robot: Robot, log: LogSamples) -> None:
    """Raise ValueError with the remedy if numbers fit the robot only in another unit, mode, or column.

    Units, modes, and columns that the options state are used, with a warning.
    """
    some = np.linspace(0, len(log.lines) - 1, min(len(log.lines), _SOME)).astype(np.int64)
    few = replace(log, lines=log.lines[some], vectors={name: x[some] for name, x in log.vectors.items()})
    found = [_angle_error(robot, log, few)] if "theta" in log.vectors else []
    found.append(_home_error(robot, few) or _length_error(robot, few))
    errors = [error for kind, error in filter(None, found) if log.places.get(kind) != "the options"]
    if errors:
        raise ValueError(
            "; ".join([errors[0], *(error.removeprefix(f"{log.source}: ") for error in errors[1:])])
        )
    for _, error in filter(None, found):
        warn(error, TrajectoryWarning)


def _home_error(robot: Robot, few: LogSamples) -> tuple[str, str] | None:
    """Return "columns" or a mode, and an error text, if only another column or mode is near the home pose."""
    home, mode, values = _home_and_values(robot, few)
    relative = getattr(few.file_format, mode) == "relative"
    if home is None or _away(values, home, relative) < _FAR:
        return None
    kind, remedy, unit = "columns", "", few.file_format.length_unit or "m"
    if mode == "pose_mode" and not relative:
        for order in list(itertools.permutations("xyz"))[1:]:
            if _away(values[:, ["xyz".index(axis) for axis in order]], home, relative) < _CLOSE:
                remedy = f"in the order {', '.join(order)}; correct them with columns t_x=HEADER"
        if "theta" in few.vectors:
            numbers = few.vectors["theta"] / ANGLE_UNITS[few.file_format.angle_unit or "rad"]
            if _away(numbers * LENGTH_UNITS[unit], home, relative) < _CLOSE:
                remedy = "by the columns of angles; correct them with columns t_x=HEADER"
    if not remedy and _away(values, home, not relative) < _CLOSE:
        other, present = ("absolute", "relative") if relative else ("relative", "absolute")
        kind, remedy = mode, f"if {other}; state {mode}={other}, or {mode}={present} if it is right"
    if not remedy:
        return None
    got, expected = (vector_text(each) for each in (np.median(values, axis=0), home))
    return kind, f"{few.source}: typical values {got} m fit the home values {expected} m only {remedy}"


def _home_and_values(robot: Robot, few: LogSamples) -> tuple[Array | None, str, Array]:
    """Return the coordinates at home (m), the name of the mode, and the samples (m), (n, 3) or (n, 6).

    The coordinates are None if the home position is unknown or near the origin of the base.
    """
    home = robot.home_position
    if "L" in few.vectors:
        at_home = None if home is None else leg_lengths(robot, np.eye(3), home)
        return at_home, "length_mode", few.vectors["L"]
    near = home is None or np.linalg.norm(home + robot.tool) < _NEAR * np.ptp(robot.b, axis=0).max()
    return None if home is None or near else home + robot.tool, "pose_mode", few.vectors["t"]


def _away(values: Array, home: Array, relative: bool) -> float:
    """Return the typical distance of samples, (n, k), from home, relative to the size of its coordinates."""
    distance = np.linalg.norm(values if relative else values - home, axis=-1)
    return float(np.median(distance) / np.linalg.norm(home))


def _length_error(robot: Robot, few: LogSamples) -> tuple[str, str] | None:
    """Return "length_unit" and an error text if lengths fit the robot only in another unit."""
    unit = few.file_format.length_unit or "m"
    times = {name: each / LENGTH_UNITS[unit] for name, each in LENGTH_UNITS.items()}
    fits = [name for name in LENGTH_UNITS if _fits(robot, few, times[name])]
    if unit in fits:
        return None
    text = _beside_size(robot, _lengths(robot, few, 1.0))[3]
    home, mode, values = _home_and_values(robot, few)
    if home is not None:
        relative = getattr(few.file_format, mode) == "relative"
        near = [name for name in fits if _away(times[name] * values, home, relative) < _FAR]
        other = [name for name in LENGTH_UNITS if _away(times[name] * values, home, not relative) < _CLOSE]
        with_mode = [f"{name} with {mode}={'absolute' if relative else 'relative'}" for name in other]
        fits = near or with_mode or fits
    return ("length_unit", _other_unit(few, "length_unit", text, fits)) if fits else None


def _lengths(robot: Robot, few: LogSamples, times: float) -> Array:
    """Return leg lengths (m) for coordinates in another unit."""
    if "L" in few.vectors:
        home = np.zeros(6)
        if few.file_format.length_mode == "relative" and robot.home_position is not None:
            home = leg_lengths(robot, np.eye(3), robot.home_position)
        return times * few.vectors["L"] + home
    t, R = _poses(robot, few, times)
    return leg_lengths(robot, R, t)


def _poses(robot: Robot, few: LogSamples, times: float) -> tuple[Array, Array]:
    """Return t (m) and R of the reference point for positions in another unit."""
    theta, _, order = few.angles()
    R = rotation_about_axes(theta, order)
    t = times * few.vectors["t"] - R @ robot.tool
    if few.file_format.pose_mode == "relative" and robot.home_position is not None:
        t = t + robot.home_position + robot.tool
    return t, R


def _fits(robot: Robot, few: LogSamples, times: float) -> bool:
    """Return True if the machine can have the leg lengths of coordinates in another unit."""
    lengths = _lengths(robot, few, times)
    typical, size, _, _ = _beside_size(robot, lengths)
    low, high = _USUAL
    if not low * size <= typical <= high * size:
        return False
    if "L" in few.vectors:
        return True
    t, R = _poses(robot, few, times)
    return bool(np.linalg.norm(t, axis=-1).max() >= _NEAR * np.ptp(robot.b, axis=0).max()) or (
        impossible(robot, t, R) is None
    )


def _angle_error(robot: Robot, log: LogSamples, few: LogSamples) -> tuple[str, str] | None:
    """Return "angle_unit" and an error text if angles fit the robot only in degrees."""
    theta = np.unwrap(log.vectors["theta"], axis=0)
    spans = np.ptp(np.quantile(theta, _RANGE, axis=0), axis=0)
    if log.file_format.angle_unit != "rad":
        return None
    in_degrees = replace(few, vectors=few.vectors | {"theta": np.radians(few.vectors["theta"])})
    t, R = _poses(robot, few, 1.0)
    lengths, (low, high) = leg_lengths(robot, R, t), robot.length_limits.T
    # Leg lengths exceed their limits by more than a stroke.
    wrong = bool(np.any(np.maximum(low - lengths, lengths - high) > high - low))
    wrong = wrong or (spans.max() > LEAST_TURN and impossible(robot, t, R) is not None)
    wrong = wrong and impossible(robot, *_poses(robot, in_degrees, 1.0)) is None
    if not wrong and np.all(spans <= MOST_TURNS):
        return None
    axis = int(np.argmax(spans))
    finding = f"{_angle_range(theta, axis)}, which the legs allow only in degrees"
    return "angle_unit", _other_unit(few, "angle_unit", finding, ["deg"])


def _other_unit(log: LogSamples, kind: str, finding: str, units: Sequence[str]) -> str:
    """Return the error text for numbers that fit other units."""
    unit = getattr(log.file_format, kind)
    remedies = " or ".join(f"{kind}={each}" for each in units)
    place = log.places.get(kind)
    stated = f" ({unit} in {place})" if place else ""
    return f"{log.source}: {finding}{stated}; state {remedies}, or {kind}={unit} if it is right"


def length_doubt(robot: Robot, lengths: Array) -> str | None:
    """Return a warning text if leg lengths (m) do not fit the robot's size, else None."""
    typical, size, (near, far), text = _beside_size(robot, lengths)
    if near * size <= typical <= far * size:
        return None
    return f"{text}; forces are implausible; check length_unit and the unit of the robot file"


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
    typical, units = float(np.median(lengths)), Units.of(robot)
    own, other = (f"{number / units.meters:.4g} {units.length}" for number in (typical, size))
    return typical, size, shares, f"lengths of {own} compared with {of} {other}"


def impossible(robot: Robot, t: Array, R: Array) -> str | None:
    """Return the reason for which poses are unreachable, length limits or a singular pose; else None."""
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
        sign = np.sign(np.linalg.det(rates_per_twist(robot, motion.R, motion.t, screws=True)))
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
    if robot.home_position is None:
        where = "below the base, in the direction of gravity,"
        unless = " (forces are correct for a suspended machine)"
    return (
        f"the platform is {where} in every sample: does z of the log point the other way than in the robot "
        f"file? Then state scales = {{ t_z = -1 }} in its table [trajectory]{unless}"
    )


def turn_doubt(theta: Array) -> str | None:
    """Return the range of angles (n, 3), rad, that no platform has, as a text; None for a plausible range."""
    spans = np.ptp(theta, axis=0)
    axis = int(np.argmax(spans / MOST_TURNS))
    return _angle_range(theta, axis) if spans[axis] > MOST_TURNS[axis] * (1.0 + 1e-9) else None


def _angle_range(theta: Array, axis: int) -> str:
    """Format the range of one of the angles (n, 3), rad, such as ``theta_x from -4 to 5 rad``."""
    low, high = theta[:, axis].min(), theta[:, axis].max()
    return f"theta_{'xyz'[axis]} from {low:.4g} to {high:.4g} rad"
