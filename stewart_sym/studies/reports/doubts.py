"""Doubts about a log or a scene: another unit of lengths, angles or speeds, a platform beyond the base."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...io.array_types import Array
from ...kinematics.mounting import platform_side
from ...kinematics.offset_legs import leg_lengths
from ...kinematics.pose_search import jacobian
from ...motion.motion import Motion
from ...motion.rotation import rotation_about_axes, rotation_from_rpy
from ...motion.text.unit_row import LENGTH_UNITS
from ...motion.trajectory import MOST_TURNS, PoseLog, angle_range
from ...robot.fields import DEFAULT_GRAVITY, vector_text
from ...robot.robot import Robot
from ...simulation.scene import Scene


def length_doubt(robot: Robot, lengths: Array, unit: str = "m") -> str | None:
    """One line about leg lengths, m, that are no machine's of the robot's size; None for plausible ones.

    unit: of ``LENGTH_UNITS``, in which the log was read.
    """
    size, (near, far), of = _size(robot)
    typical = float(np.median(lengths))
    if near * size <= typical <= far * size:
        return None
    low, high = _USUAL
    written = typical / LENGTH_UNITS[unit]
    units = [name for name, factor in LENGTH_UNITS.items() if low * size <= factor * written <= high * size]
    cause = (
        f"are they in another unit (--length-unit {' or '.join(units)})"
        if units
        else "is --length-unit right, and are those of the robot file in metres"
        if typical < size
        else "is it the log of another machine, or are those of the robot file not in metres"
    )
    return f"lengths of {typical:.4g} m beside {of} {size:.4g} m: {cause}?"


def metres_doubt(robot: Robot, lengths: Array) -> str | None:
    """One line about leg lengths, m, far above those of the robot's size; None for others."""
    size, (_, far), of = _size(robot)
    typical = float(np.median(lengths))
    if typical <= far * size:
        return None
    return f"lengths of {typical:.4g} m beside {of} {size:.4g} m: in millimetres, expected metres?"


def _size(robot: Robot) -> tuple[float, tuple[float, float], str]:
    """Size, m, that lengths are compared with, the least and most share of it, and words for it."""
    limits = robot.length_limits[np.isfinite(robot.length_limits[:, 1]), 1]
    if limits.size:
        return float(limits.max()), _SHARES_OF_LIMITS, "legs of up to"
    size = max(float(np.ptp(robot.b, axis=0).max()), float(np.ptp(robot.p, axis=0).max()))
    return size, _SHARES_OF_SIZE, "a machine of"


def angle_doubt(robot: Robot, log: PoseLog, some: NDArray[np.int64]) -> str | None:
    """One line about angles that the legs allow in degrees alone, at some instants; None else."""
    theta, t = log.coordinates[0, :, 3:], log.coordinates[0, some, :3]
    tool = np.zeros(3) if log.tool is None else log.tool
    spans = np.ptp(theta, axis=0)
    axis = int(np.argmax(spans))
    if not log.in_radians or not _LEAST_TURN < spans[axis] or np.any(spans > MOST_TURNS):
        return None
    R, in_degrees = (rotation_about_axes(each, log.order) for each in (theta[some], np.radians(theta[some])))
    how = _impossible(robot, t, R, tool)
    if how is None or _impossible(robot, t, in_degrees, tool) is not None:
        return None
    return (
        f"{angle_range(theta, axis)} leads {how}, in degrees it does not: "
        "are angles in degrees (--angle-unit deg)?"
    )


def unit_doubt(robot: Robot, log: PoseLog, some: NDArray[np.int64]) -> str | None:
    """One line about poses that the legs allow many times as far from the base alone; None else."""
    t, R = log.coordinates[0, some, :3], rotation_about_axes(log.coordinates[0, some, 3:], log.order)
    tool = np.zeros(3) if log.tool is None else log.tool
    far = float(np.linalg.norm(t, axis=-1).max())
    how = _impossible(robot, t, R, tool) if far < _NEAR * np.ptp(robot.b, axis=0).max() else None
    for times in _TIMES if how is not None else ():
        if _impossible(robot, times * t, R, tool) is None:
            cause = f"t of up to {far:.3g} m leads {how}, {times} times as much does not"
            return f"{cause}: is --length-unit right?"
    return None


def _impossible(robot: Robot, t: Array, R: Array, tool: Array) -> str | None:
    """Where poses of the tool lead that a machine does not reach: beyond limits, through singular poses."""
    t = t - R @ tool
    L = leg_lengths(robot, R, t)
    if np.any((robot.length_limits[:, 0] > L) | (robot.length_limits[:, 1] < L)):
        return "legs beyond length_limits"
    turned = np.linalg.det(jacobian(robot, R, t))
    return "through a singular pose" if np.ptp(np.sign(turned)) > 0.0 else None


def side_doubt(robot: Robot, motion: Motion) -> str | None:
    """One line about poses (n,) all on the other side of the base than gravity or home says; None else."""
    side = platform_side(robot)
    centre = motion.t + motion.R @ robot.p.mean(axis=0) - robot.b.mean(axis=0)
    if not side.certain or np.any(centre @ side.direction >= 0.0):
        return None
    where, unless = ("on the other side of the base than at home", "")
    if side.by_gravity:
        where = "below the base, where gravity pulls,"
        unless = " (forces are right as they are for a machine that hangs)"
    return (
        f"the platform is {where} at every instant: does z of the log point the other way than in the robot "
        f"file?{unless}"
    )


def start_doubts(scene: Scene) -> list[str]:
    """Lines, each with its key, about a scene's start and springs that are no machine's like the robot."""
    robot, state, stated = scene.robot, scene.state, scene.stated
    start = "state.t" if "state.t" in stated else "legs.path"
    lengths = {start: leg_lengths(robot, state.R, state.t)}
    lengths |= {key: stated[key] for key in ("legs.rest_length",) if key in stated}
    found = {key: doubt for key, L in lengths.items() if (doubt := metres_doubt(robot, L))}
    lines = [f"{key}: {doubt}" for key, doubt in found.items()]
    side = platform_side(robot)
    centre = state.t + state.R @ robot.p.mean(axis=0) - robot.b.mean(axis=0)
    if start not in found and side.certain and centre @ side.direction < 0.0:
        lines.append(
            f"{start}: the platform starts on the other side of the base than "
            f"{vector_text(side.direction + 0.0)}, {side.rule}: does z point the other way than in the "
            "robot file?"
        )
    theta = stated.get("state.theta", np.zeros(3))
    if start not in found and np.abs(theta).max() > _LEAST_TURN:
        t, tool = np.stack([state.t, state.t]), np.zeros(3)
        how, degrees = (
            _impossible(robot, t, rotation_from_rpy(np.stack([np.zeros(3), turned])), tool)
            for turned in (theta, np.radians(theta))
        )
        if np.any(np.abs(theta) > MOST_TURNS) or (how is not None and degrees is None):
            axis = int(np.argmax(np.abs(theta)))
            lines.append(
                f"state.theta: {theta[axis]:.4g} rad about {'xyz'[axis]}: in degrees, expected radians?"
            )
    return lines + _speed_doubts(stated, float(np.median(lengths[start])))


def _speed_doubts(stated: Mapping[str, Any], length: float) -> list[str]:
    """Lines about speeds of a start far above those of a fall through a leg's length, m."""
    fall = float(np.sqrt(2.0 * abs(DEFAULT_GRAVITY[2]) * length))
    units = {"v": ("m/s", "in mm/s", fall), "omega": ("rad/s", "in degrees/s", fall / length)}
    return [
        f"state.{name}: {speed:.4g} {unit}, {speed / usual:.2g} times what a fall through the length of a "
        f"leg gives: {other}, expected {unit}?"
        for name, (unit, other, usual) in units.items()
        if (speed := float(np.linalg.norm(stated.get(f"state.{name}", 0.0)))) > _MOST_FALLS * usual
    ]


# Factors of a mistaken unit: metres read as millimetres, metres as centimetres, centimetres as millimetres. A
# platform nearer to the base than this share of the base's size is doubtful.
_TIMES, _NEAR = (1000, 100, 10), 0.2
# Speeds at a start above this multiple of a fall's are doubtful.
_MOST_FALLS = 5.0
# Leg lengths outside these ranges, shares of the machine's size or of its longest leg, are doubtful; usual
# ones, by which another unit is suggested; and the least range of an angle, rad, that may be in degrees.
_SHARES_OF_SIZE, _SHARES_OF_LIMITS, _USUAL, _LEAST_TURN = (1.0 / 200.0, 20.0), (0.02, 5.0), (0.15, 3.0), 0.5
