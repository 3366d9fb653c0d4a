"""Sizing: which force, speed, power, stroke and joint angles motions and their loads need of every leg."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..drives.effort import trapezoids
from ..drives.limit_status import SURE
from ..drives.motor_states import motor_states
from ..drives.noise import all_deviations, at_replaced
from ..dynamics.inverse_dynamics import Formulation, inverse_dynamics, need_motion
from ..io.arguments import instance, number_in, real_array, shown
from ..io.array_types import Array, Flags
from ..io.error_policy import SingularPoseWarning, warn
from ..io.frozen import Frozen, read_only
from ..io.progress import Progress, silent
from ..kinematics.clearance import angles_between, neutral_directions
from ..kinematics.inverse_kinematics import inverse_kinematics
from ..motion.motion import Motion
from ..motion.trajectory import PoseLog, Trajectory
from ..robot.robot import Robot
from ..singularities.path_warnings import crossing_warning, row_warning

QUANTILES = (0.5, 0.9, 0.99, 1.0)
"""Shares of the time by default; 1 is the peak."""


@dataclass(frozen=True, eq=False)
class ActuatorHistory(Frozen):
    """What each leg does over time; n instants.

    Attributes
    ----------
    time_weight : ndarray
        Time that each instant stands for, s, (n,).
    F : ndarray
        Actuator forces, N, (n, 6), positive when they extend the leg.
    L, L_dot : ndarray
        Lengths, m, and their rates, m/s, (n, 6).
    base_angle, platform_angle : ndarray
        Angles of the joints at both ends from their neutral directions, rad, (n, 6).
    torque, motor_speed, motor_power : ndarray, optional
        Of the motors, N m, rad/s and W, (n, 6); None of a robot without drives.
    current : ndarray, optional
        Of the motors, A, (n, 6); NaN of one without a torque_constant, None where none has one.
    std : dict, optional
        Standard deviations of the fields above and of power by noise of logs, arrays by their names; with
        _rise and _fall those of the sizes of torque and current upward and downward. None without noise.
    replaced : ndarray of bool, optional
        Instants, (n,), whose deviations are those of replaced rows of a log; None without noise.
    """

    time_weight: Array
    F: Array
    L: Array
    L_dot: Array
    base_angle: Array
    platform_angle: Array
    torque: Array | None = None
    motor_speed: Array | None = None
    motor_power: Array | None = None
    current: Array | None = None
    std: Mapping[str, Array] | None = None
    replaced: Flags | None = None

    @property
    def power(self) -> Array:
        """F L_dot, W, (n, 6): positive where the actuator drives the leg."""
        return np.asarray(self.F * self.L_dot)


@dataclass(frozen=True, eq=False)
class ActuatorRequirementsResult(Frozen):
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
    max_push_force, max_pull_force : ndarray
        Largest forces that extend and that shorten the leg, N, (6,), 0 where there are none.
    rms_force : ndarray
        Root mean square of F, N, (6,).
    max_driving_power, max_braking_power : ndarray
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
    history : ActuatorHistory
        All of it over time.
    std : dict, optional
        Standard deviations of the fields above and of stroke by noise of logs, arrays by their names: the
        largest that errors at single instants can make, however these go together. None without noise.
    crossings : tuple of str
        A line about each motion that crosses a singular pose, where no force suffices.
    """

    margin: float
    quantiles: Array
    force: Array
    speed: Array
    power: Array
    max_push_force: Array
    max_pull_force: Array
    rms_force: Array
    max_driving_power: Array
    max_braking_power: Array
    length: Array
    base_angle: Array
    platform_angle: Array
    torque: Array | None
    motor_speed: Array | None
    motor_power: Array | None
    current: Array | None
    rms_torque: Array | None
    history: ActuatorHistory
    std: Mapping[str, Array] | None = None
    crossings: tuple[str, ...] = ()

    @property
    def stroke(self) -> Array:
        """Longest less shortest leg, m, (6,)."""
        return np.asarray(self.length[:, 1] - self.length[:, 0])


def actuator_requirements(
    robot: Robot,
    motions: Sequence[tuple[ArrayLike, Motion] | Trajectory | PoseLog],
    margin: float = 0.25,
    quantiles: Sequence[float] = QUANTILES,
    formulation: Formulation = "exact",
    progress: Progress = silent,
) -> ActuatorRequirementsResult:
    """Return what motions and their loads need of every actuator and joint.

    Warns of motions that cross singular poses: logs between their rows too, others by the signs of det H.

    Parameters
    ----------
    robot : Robot
        The machine.
    motions : sequence of tuple
        (time, motion) each: instants, s, (n,), rising, and the motion there with its load, (n,); or
        trajectories, whose noise makes deviations.
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
    ActuatorRequirementsResult
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
    for number, each in enumerate(given):
        progress("computing forces", number / len(given))
        courses.append(_course(robot, each.time, each.motion, formulation))
    found = _needs(_joined(robot, courses, given, formulation), margin, shares)
    lines = [_crossing(robot, each, number) for number, each in enumerate(given)]
    crossed = tuple(line for line in lines if line is not None)
    for line in crossed:
        warn(line, SingularPoseWarning)
    return replace(found, crossings=crossed)


def _crossing(robot: Robot, given: _Given, number: int) -> str | None:
    """One line about a singular pose that a motion crosses; rates of arrays may be those of other poses."""
    if given.log is not None:
        return crossing_warning(robot, given.log)
    rows = range(len(given.time))
    return row_warning(robot, Trajectory(given.time, given.motion, f"motions[{number}]", rows), "instants")


def checked_quantiles(quantiles: Sequence[float], where: str = "quantiles") -> Array:
    """Shares of the time in rising order, (q,); ValueError for others."""
    shares = real_array(quantiles, where, "shares > 0 and <= 1")
    if shares.ndim != 1 or not shares.size or not np.all((shares > 0.0) & (shares <= 1.0)):
        raise ValueError(f"{where}: expected shares > 0 and <= 1, got {shown(quantiles)}")
    return np.unique(shares)


class _Given(NamedTuple):
    time: Array
    motion: Motion
    log: Trajectory | PoseLog | None = None


def _checked(robot: Robot, motions: object) -> list[_Given]:
    if not isinstance(motions, Iterable) or isinstance(motions, Motion):
        raise ValueError(f"motions: expected pairs (time, motion), got {type(motions).__name__}")
    found = []
    for i, pair in enumerate(motions):
        log = None
        if isinstance(pair, Trajectory | PoseLog):
            log, pair = pair, (pair.time, pair.motion)
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
        found.append(_Given(time, motion, log))
    if not found:
        raise ValueError("motions: expected one at least, got none")
    return found


def _course(robot: Robot, time: Array, motion: Motion, formulation: Formulation) -> dict[str, Array]:
    legs = inverse_kinematics(robot, motion)
    F = inverse_dynamics(robot, motion, formulation).F
    motors = {}
    if robot.drive is not None:
        effort = motor_states(robot, robot.drive, motion, F, legs.L_dot)
        motors = {"torque": effort.torque, "motor_speed": effort.speed, "motor_power": effort.power}
        if effort.current is not None:
            motors["current"] = effort.current
    return {
        **motors,
        "time_weight": trapezoids(time) if len(time) > 1 else np.ones(1),
        "F": F,
        "L": legs.L,
        "L_dot": legs.L_dot,
        "base_angle": legs.s,
        "platform_angle": legs.s @ motion.R,
    }


def _joined(
    robot: Robot, courses: Sequence[dict[str, Array]], given: Sequence[_Given], formulation: Formulation
) -> ActuatorHistory:
    """All motions as one, with their deviations if any has them."""
    every: dict[str, Any] = {
        name: np.concatenate([course[name] for course in courses]) for name in courses[0]
    }
    neutral = []
    for end in ("base_angle", "platform_angle"):
        s = every[end]
        mean = np.average(s, axis=0, weights=every["time_weight"])
        neutral.append(mean if robot.home_position is None else neutral_directions(robot))
        every[end] = angles_between(s, neutral[-1])
    if all(each.log is None or each.log.noise is None for each in given):
        return ActuatorHistory(**every)
    parts = [
        _noise(robot, each, course, formulation, np.array(neutral))
        for each, course in zip(given, courses, strict=True)
    ]
    sd = {name: read_only(np.concatenate([part[name] for part, _ in parts])) for name in parts[0][0]}
    return ActuatorHistory(**every, std=sd, replaced=np.concatenate([flags for _, flags in parts]))


def _noise(
    robot: Robot, given: _Given, course: dict[str, Array], formulation: Formulation, neutral: Array
) -> tuple[dict[str, Array], Flags]:
    """Deviations of a motion's course by its names, and which are those of replaced rows."""
    trajectory = Trajectory(given.time, given.motion, "", ()) if given.log is None else given.log
    found = all_deviations(robot, trajectory, formulation, neutral=neutral)
    ends = {"base": "base_angle", "platform": "platform_angle"}
    named = {ends.get(name, name): values for name, values in found._asdict().items()}
    sd = {name: values for name, values in named.items() if name in (*course, "power")}
    if found.motors is not None and robot.drive is not None:
        motors = found.motors
        sd |= {"torque": motors.torque, "motor_speed": motors.speed, "motor_power": motors.power}
        sd |= {"torque_rise": motors.torque_rise, "torque_fall": motors.torque_fall}
        if motors.current is not None:
            constant = np.where(robot.drive.torque_constant > 0.0, robot.drive.torque_constant, np.nan)
            sd |= {"current": motors.current}
            sd |= {f"current_{side}": sd[f"torque_{side}"] / constant for side in ("rise", "fall")}
    return sd, at_replaced(trajectory, given.time)


_OVER_TIME = {"force": "F", "speed": "L_dot", "power": "power", "torque": "torque"} | {
    name: name for name in ("motor_speed", "motor_power", "current")
}
"""Needs for shares of the time, with what they are sizes of."""
_LARGEST = {
    "max_push_force": ("F", 1),
    "max_pull_force": ("F", -1),
    "max_driving_power": ("power", 1),
    "max_braking_power": ("power", -1),
}
"""Needs that are the largest of something, 0 at least, with its sign."""


def _needs(course: ActuatorHistory, margin: float, shares: Array) -> ActuatorRequirementsResult:
    over_time: dict[str, Any] = dict.fromkeys(_OVER_TIME)
    for need, name in _OVER_TIME.items():
        values = getattr(course, name)
        if values is not None:
            over_time[need] = weighted_quantiles(np.abs(values), course.time_weight, shares)
    largest: dict[str, Any] = {
        need: _largest(sign * getattr(course, name)) for need, (name, sign) in _LARGEST.items()
    }
    return ActuatorRequirementsResult(
        margin=margin,
        quantiles=shares,
        **over_time,
        **largest,
        rms_force=_rms(course.F, course.time_weight),
        length=np.stack([course.L.min(axis=0), course.L.max(axis=0)], axis=-1),
        base_angle=course.base_angle.max(axis=0),
        platform_angle=course.platform_angle.max(axis=0),
        rms_torque=None if course.torque is None else _rms(course.torque, course.time_weight),
        history=course,
        std=None if course.std is None else _deviations(course, course.std, shares),
    )


def _largest(values: Array) -> Array:
    return np.asarray(values.max(axis=0).clip(min=0.0))


def _rms(values: Array, weight: Array) -> Array:
    return np.asarray(np.sqrt(np.average(values**2, axis=0, weights=weight)))


def sides(sd: Mapping[str, Array], name: str) -> tuple[Array, Array]:
    """Deviations, (n, 6), of the sizes of a course's field upward and downward."""
    return sd.get(f"{name}_rise", sd[name]), sd.get(f"{name}_fall", sd[name])


def _deviations(course: ActuatorHistory, sd: Mapping[str, Array], shares: Array) -> dict[str, Array]:
    """Of needs, by their names: what errors of one deviation at every instant change at most.

    Those of ``SURE`` deviations count as well, over ``SURE``: friction that steps leaves gaps between values.
    """

    def change(of: Callable[[Array], Array], values: Array, name: str) -> Array:
        at, found = of(values), np.zeros(())
        rise, fall = sides(sd, name)
        for times in (1.0, SURE):
            up, down = of(values + times * rise), of(values - times * fall)
            found = np.maximum(found, np.maximum(up - at, at - down) / times)
        return np.asarray(found)

    def over_time(sizes: Array) -> Array:
        return weighted_quantiles(sizes.clip(min=0.0), course.time_weight, shares)

    found = {
        need: change(over_time, np.abs(getattr(course, name)), name)
        for need, name in _OVER_TIME.items()
        if name in sd
    }
    for need, (name, sign) in _LARGEST.items():
        found[need] = change(_largest, sign * getattr(course, name), name)
    ends = [change(lambda x: x.max(axis=0), sign * course.L, "L") for sign in (-1, 1)]
    found |= {
        "length": np.stack(ends, axis=-1),
        "stroke": ends[0] + ends[1],
        "rms_force": _rms(sd["F"], course.time_weight),
    }
    found |= {end: change(_largest, getattr(course, end), end) for end in ("base_angle", "platform_angle")}
    found |= {"rms_torque": _rms(sd["torque"], course.time_weight)} if "torque" in sd else {}
    return {name: read_only(values) for name, values in found.items()}


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
