"""Sizing: which force, speed, power, stroke and joint angles motions and their loads need of every leg."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..drives.effort import at_instants, trapezoids
from ..dynamics.inverse import Formulation, inverse_dynamics, need_motion
from ..io.arguments import instance, number_in, real_array, shown
from ..io.array_types import Array
from ..io.frozen import Frozen
from ..io.progress import Progress, silent
from ..kinematics.clearance import angles_between, neutral_directions
from ..kinematics.inverse import inverse_kinematics
from ..motion.motion import Motion
from ..robot.robot import Robot

QUANTILES = (0.5, 0.9, 0.99, 1.0)
"""Shares of the time by default; 1 is the peak."""


@dataclass(frozen=True, eq=False)
class Course(Frozen):
    """What each leg does over time; n instants.

    Attributes
    ----------
    weight : ndarray
        Time that each instant stands for, s, (n,).
    F : ndarray
        Actuator forces, N, (n, 6), positive when they extend the leg.
    L, L_dot : ndarray
        Lengths, m, and their rates, m/s, (n, 6).
    base, platform : ndarray
        Angles of the joints at both ends from their neutral directions, rad, (n, 6).
    torque, motor_speed, motor_power : ndarray, optional
        Of the motors, N m, rad/s and W, (n, 6); None of a robot without drives.
    current : ndarray, optional
        Of the motors, A, (n, 6); NaN of one without a torque_constant, None where none has one.
    """

    weight: Array
    F: Array
    L: Array
    L_dot: Array
    base: Array
    platform: Array
    torque: Array | None = None
    motor_speed: Array | None = None
    motor_power: Array | None = None
    current: Array | None = None

    @property
    def power(self) -> Array:
        """F L_dot, W, (n, 6): positive where the actuator drives the leg."""
        return np.asarray(self.F * self.L_dot)


@dataclass(frozen=True, eq=False)
class Needs(Frozen):
    """What motions need of every leg, without the margin.

    Attributes
    ----------
    margin : float
        Share that a limit should exceed the need by.
    quantiles : ndarray
        Shares of the time, (q,); 1 is the peak.
    force, speed, power : ndarray
        Sizes of F, N, of L_dot, m/s, and of F L_dot, W, that are not exceeded for these shares of the time,
        (q, 6).
    push, pull : ndarray
        Largest forces that extend and that shorten the leg, N, (6,), 0 where there are none.
    rms_force : ndarray
        Root mean square of F, N, (6,).
    driving, braking : ndarray
        Largest power into and out of the leg, W, (6,).
    length : ndarray
        Shortest and longest leg, m, (6, 2).
    base_angle, platform_angle : ndarray
        Largest angles of the joints at both ends, rad, (6,): from the leg's direction at the home pose, or,
        of a robot that states none, from its mean direction.
    torque, motor_speed, motor_power : ndarray, optional
        Sizes of the motors' torque, N m, speed, rad/s, and power at the shaft, W, that are not exceeded for
        the shares of the time, (q, 6); None of a robot without drives.
    current : ndarray, optional
        Sizes of the motors' currents, A, likewise, (q, 6); NaN of a motor without a torque_constant, None
        where none has one.
    rms_torque : ndarray, optional
        Root mean square of the torque, N m, (6,).
    course : Course
        All of it over time.
    """

    margin: float
    quantiles: Array
    force: Array
    speed: Array
    power: Array
    push: Array
    pull: Array
    rms_force: Array
    driving: Array
    braking: Array
    length: Array
    base_angle: Array
    platform_angle: Array
    torque: Array | None
    motor_speed: Array | None
    motor_power: Array | None
    current: Array | None
    rms_torque: Array | None
    course: Course

    @property
    def stroke(self) -> Array:
        """Longest less shortest leg, m, (6,)."""
        return np.asarray(self.length[:, 1] - self.length[:, 0])


def size(
    robot: Robot,
    motions: Sequence[tuple[ArrayLike, Motion]],
    margin: float = 0.25,
    quantiles: Sequence[float] = QUANTILES,
    formulation: Formulation = "exact",
    progress: Progress = silent,
) -> Needs:
    """Return what motions and their loads need of every actuator and joint.

    Parameters
    ----------
    robot : Robot
        The machine.
    motions : sequence of tuple
        (time, motion) each: instants, s, (n,), rising, and the motion there with its load, (n,).
    margin : float, optional
        Share that a limit should exceed the need by.
    quantiles : sequence of float, optional
        Shares of the time, above 0, 1 at most.
    formulation : {"exact", "paper"}, optional
        The corrected equations or those printed.
    progress : callable, optional
        Called with text and the share done.

    Returns
    -------
    Needs
        Shapes and units are documented there.

    Raises
    ------
    ValueError
        Naming the argument; for no motion, and for unsolvable poses.
    """
    instance(robot, Robot, "robot")
    margin = number_in(margin, "margin", "a finite share >= 0", closed=True)
    shares = checked_quantiles(quantiles)
    given = _checked(robot, motions)
    courses = []
    for number, (time, motion) in enumerate(given):
        progress("computing forces", number / len(given))
        courses.append(_course(robot, time, motion, formulation))
    return _needs(robot, courses, margin, shares)


def checked_quantiles(quantiles: Sequence[float], where: str = "quantiles") -> Array:
    """Shares of the time in rising order, (q,); ValueError for others."""
    shares = real_array(quantiles, where, "shares > 0 and <= 1")
    if shares.ndim != 1 or not shares.size or not np.all((shares > 0.0) & (shares <= 1.0)):
        raise ValueError(f"{where}: expected shares > 0 and <= 1, got {shown(quantiles)}")
    return np.unique(shares)


def _checked(robot: Robot, motions: object) -> list[tuple[Array, Motion]]:
    if not isinstance(motions, Iterable) or isinstance(motions, Motion):
        raise ValueError(f"motions: expected pairs (time, motion), got {type(motions).__name__}")
    found = []
    for i, pair in enumerate(motions):
        if not isinstance(pair, tuple | list) or len(pair) != 2:
            raise ValueError(f"motions[{i}]: expected a pair (time, motion), got {type(pair).__name__}")
        time, motion = real_array(pair[0], f"motions[{i}]: time"), pair[1]
        instance(motion, Motion, f"motions[{i}]")
        need_motion(robot, motion)
        if motion.shape != time.shape or time.ndim != 1 or not time.size:
            raise ValueError(
                f"motions[{i}]: expected a motion of the shape of its time, (n,) with n >= 1, got "
                f"{motion.shape} and {time.shape}"
            )
        if not np.isfinite(time).all() or np.any(np.diff(time) <= 0.0):
            raise ValueError(f"motions[{i}]: time: expected finite, rising instants")
        found.append((time, motion))
    if not found:
        raise ValueError("motions: expected one at least, got none")
    return found


def _course(robot: Robot, time: Array, motion: Motion, formulation: Formulation) -> dict[str, Array]:
    legs = inverse_kinematics(robot, motion)
    F = inverse_dynamics(robot, motion, formulation).F
    motors = {}
    if robot.drive is not None:
        effort = at_instants(robot, robot.drive, motion, F, legs.L_dot)
        motors = {"torque": effort.torque, "motor_speed": effort.speed, "motor_power": effort.power}
        if effort.current is not None:
            motors["current"] = effort.current
    return {
        **motors,
        "weight": trapezoids(time) if len(time) > 1 else np.ones(1),
        "F": F,
        "L": legs.L,
        "L_dot": legs.L_dot,
        "base": legs.s,
        "platform": legs.s @ motion.R,
    }


def _needs(robot: Robot, courses: Sequence[dict[str, Array]], margin: float, shares: Array) -> Needs:
    every = {name: np.concatenate([course[name] for course in courses]) for name in courses[0]}
    for end in ("base", "platform"):
        s = every[end]
        mean = np.average(s, axis=0, weights=every["weight"])
        neutral = mean if robot.home is None else neutral_directions(robot)
        every[end] = angles_between(s, neutral)
    course = Course(**every)
    F, power = course.F, course.power

    def over_time(values: Array | None) -> Any:
        return None if values is None else weighted_quantiles(np.abs(values), course.weight, shares)

    def rms(values: Array | None) -> Any:
        return None if values is None else np.sqrt(np.average(values**2, axis=0, weights=course.weight))

    return Needs(
        margin=margin,
        quantiles=shares,
        force=over_time(F),
        speed=over_time(course.L_dot),
        power=over_time(power),
        push=F.max(axis=0).clip(min=0.0),
        pull=(-F.min(axis=0)).clip(min=0.0),
        rms_force=rms(F),
        driving=power.max(axis=0).clip(min=0.0),
        braking=(-power.min(axis=0)).clip(min=0.0),
        length=np.stack([course.L.min(axis=0), course.L.max(axis=0)], axis=-1),
        base_angle=course.base.max(axis=0),
        platform_angle=course.platform.max(axis=0),
        torque=over_time(course.torque),
        motor_speed=over_time(course.motor_speed),
        motor_power=over_time(course.motor_power),
        current=over_time(course.current),
        rms_torque=rms(course.torque),
        course=course,
    )


def weighted_quantiles(values: Array, weight: Array, shares: Array) -> Array:
    """Least values, (q, m), that values (n, m) do not exceed for shares (q,) of their weight, (n,)."""
    order = np.argsort(values, axis=0)
    ranked = np.take_along_axis(values, order, axis=0)
    reached = np.cumsum(weight[order], axis=0)
    # Against the rounding of the sum: the whole of it is reached at the last value.
    wanted = shares[:, None, None] * reached[-1] * (1.0 - 4.0 * len(values) * np.finfo(np.float64).eps)
    first = np.argmax(reached >= wanted, axis=1)
    first[shares == 1.0] = len(values) - 1
    return np.take_along_axis(ranked, first, axis=0)


def exceeded(robot: Robot, needs: Needs) -> list[str]:
    """One line for each limit of the robot that a need exceeds, legs numbered from 1."""
    lines = [
        f"{name} of leg {i + 1}: {limit[i] * scale:.4g} {unit}, needed {need[i] * scale:.4g} {unit}"
        for name, unit, scale, need, limit in _limited(robot, needs)
        for i in np.flatnonzero(need > limit).tolist()
    ]
    low, high = robot.length_limits.T
    for i in np.flatnonzero((needs.length[:, 0] < low) | (needs.length[:, 1] > high)).tolist():
        least, most = needs.length[i]
        lines.append(
            f"length_limits of leg {i + 1}: {low[i]:.4g} to {high[i]:.4g} m, needed {least:.4g} to "
            f"{most:.4g} m"
        )
    return lines


def margin_missing(robot: Robot, needs: Needs) -> list[str]:
    """One line for each limit of the robot that suffices, but not with the margin, legs numbered from 1."""
    more = 1.0 + needs.margin
    return [
        f"{name} of leg {i + 1}: {limit[i] * scale:.4g} {unit}, needed {need[i] * scale:.4g} {unit}, with "
        f"the margin {need[i] * more * scale:.4g} {unit}"
        for name, unit, scale, need, limit in _limited(robot, needs)
        for i in np.flatnonzero((need <= limit) & (need * more > limit)).tolist()
    ]


def _limited(robot: Robot, needs: Needs) -> Iterator[tuple[str, str, float, Array, Array]]:
    """Name, unit, factor from SI to it, need and limit, (6,) each, of what a robot may limit."""
    angles, course = robot.joint_angle_limit.T, needs.course
    low, high = robot.length_limits.T
    yield "force_limit", "N", 1.0, np.maximum(needs.push, needs.pull), robot.force_limit
    yield "speed_limit", "m/s", 1.0, _peak(course.L_dot), robot.speed_limit
    yield "stroke", "m", 1.0, needs.stroke, high - low
    yield "joint_angle_limit at the base", "degrees", _DEGREES, needs.base_angle, angles[0]
    yield "joint_angle_limit at the platform", "degrees", _DEGREES, needs.platform_angle, angles[1]
    drive = robot.drive
    if drive is not None and course.torque is not None and needs.rms_torque is not None:
        yield "drive.torque_limit", "N m", 1.0, _peak(course.torque), np.asarray(drive.torque_limit)
        yield "drive.rated_torque", "N m", 1.0, needs.rms_torque, np.asarray(drive.rated_torque)
        yield "drive.speed_limit", "rad/s", 1.0, _peak(course.motor_speed), np.asarray(drive.speed_limit)
        yield "drive.current_limit", "A", 1.0, _peak(course.current), np.asarray(drive.current_limit)
        yield "drive.power_limit", "W", 1.0, _peak(course.motor_power), np.asarray(drive.power_limit)


def _peak(values: Array | None) -> Array:
    return np.zeros(6) if values is None else np.abs(values).max(axis=0)


_DEGREES = 180.0 / np.pi
