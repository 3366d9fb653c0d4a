"""Actuator requirements: force, speed, power, stroke, and joint angles of every leg for given motions."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..drives.limit_status import SURE, sides
from ..drives.limits import times_of, trapezoids
from ..drives.motor_states import motor_states
from ..drives.noise import all_deviations, at_replaced
from ..dynamics.inverse_dynamics import Formulation, inverse_dynamics, need_motion
from ..io.arguments import instance, number_in, real_array, shown
from ..io.array_types import Array, Flags, Frozen, read_only
from ..io.error_policy import warn
from ..io.progress import Progress, silent
from ..kinematics.clearance import angles_between, neutral_directions
from ..kinematics.inverse_kinematics import inverse_kinematics
from ..motion.motion import Motion
from ..motion.trajectory import Trajectory
from ..results import SingularPoseWarning
from ..robot.robot import Robot
from ..singularities.path_warnings import crossing_warning, row_warning

QUANTILES = (0.5, 0.9, 0.99, 1.0)
"""Default fractions of the time; 1 is the peak."""


@dataclass(frozen=True, eq=False)
class ActuatorHistory(Frozen):
    """Quantities of each leg at n samples.

    Attributes
    ----------
    time_weight : ndarray, shape (n,)
        Time that each sample represents (s).
    F : ndarray, shape (n, 6)
        Actuator forces (N), positive when they extend the leg.
    L : ndarray, shape (n, 6)
        Leg lengths (m).
    L_dot : ndarray, shape (n, 6)
        Leg rates (m/s).
    base_angle, platform_angle : ndarray, shape (n, 6)
        Angles of the joints at both ends from their neutral directions (rad).
    torque, motor_speed, motor_power : ndarray, shape (n, 6), optional
        Motor torques (N m), speeds (rad/s), and shaft powers (W). None for a robot without drives.
    current : ndarray, shape (n, 6), optional
        Motor currents (A). NaN for a motor without a torque constant, None if no motor has one.
    std : dict of ndarray, optional
        Standard deviations of the fields above and of ``power`` due to the noise of logs, by field name. The
        suffixes _rise and _fall mark the upward and downward deviations of the magnitudes of torque and
        current. None without noise.
    replaced : ndarray of bool, shape (n,), optional
        True for samples with standard deviations of replaced log rows. None without noise.
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
        """Mechanical power F L_dot (W), shape (n, 6), positive when the actuator drives the leg."""
        return np.asarray(self.F * self.L_dot)


@dataclass(frozen=True, eq=False)
class ActuatorRequirementsResult(Frozen):
    """Actuator requirements of motions for every leg, without the margin.

    Attributes
    ----------
    margin : float
        Fraction by which a limit should exceed the requirement.
    quantiles : ndarray, shape (q,)
        Fractions of the time; 1 is the peak.
    force : ndarray, shape (q, 6)
        Magnitude of the actuator force F (N) that is not exceeded for these fractions of the time.
    speed : ndarray, shape (q, 6)
        Magnitude of the leg rate L_dot (m/s), likewise.
    power : ndarray, shape (q, 6)
        Magnitude of the mechanical power F L_dot (W), likewise.
    max_push_force, max_pull_force : ndarray, shape (6,)
        Largest force that extends, and that shortens, the leg (N); 0 if there is none.
    rms_force : ndarray, shape (6,)
        Root mean square of F (N).
    max_driving_power, max_braking_power : ndarray, shape (6,)
        Largest power into, and out of, the leg (W).
    length : ndarray, shape (6, 2)
        Minimum and maximum length of each leg (m).
    base_angle, platform_angle : ndarray, shape (6,)
        Largest angles of the joints at both ends (rad), measured from the leg direction at the home pose, or
        from the mean direction if the robot has no home pose.
    torque, motor_speed, motor_power : ndarray, shape (q, 6), optional
        Magnitudes of motor torque (N m), motor speed (rad/s), and shaft power (W) that are not exceeded for
        the fractions of the time. None for a robot without drives.
    current : ndarray, shape (q, 6), optional
        Magnitude of the motor current (A), likewise. NaN for a motor without a torque constant, None if no
        motor has one.
    rms_torque : ndarray, shape (6,), optional
        Root mean square of the motor torque (N m).
    history : ActuatorHistory
        Quantities of each leg over time.
    std : dict of ndarray, optional
        Standard deviations of the fields above and of ``stroke`` due to the noise of logs, by field name.
        They are upper bounds, because the correlation of the errors is unknown. None without noise.
    crossings : tuple of str
        One line for each motion that crosses a singular pose, at which no force is sufficient.
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
        """Difference of the maximum and minimum length of each leg (m), shape (6,)."""
        return np.asarray(self.length[:, 1] - self.length[:, 0])


def actuator_requirements(
    robot: Robot,
    motions: Sequence[tuple[ArrayLike, Motion] | Trajectory],
    margin: float = 0.25,
    quantiles: Sequence[float] = QUANTILES,
    formulation: Formulation = "exact",
    progress: Progress = silent,
) -> ActuatorRequirementsResult:
    """Compute the force, speed, power, stroke, and joint angles that motions require of every leg.

    Singular poses that motions cross are reported: for logs also between rows, for other motions from the
    sign of det H at the samples.

    Parameters
    ----------
    robot : Robot
        Robot geometry and inertia, with or without drives.
    motions : sequence of tuple or Trajectory
        Pairs (time, motion) of increasing times (s), shape (n,), and a Motion with its load, shape (n,); or
        trajectories, whose noise adds standard deviations.
    margin : float, optional
        Fraction by which a limit should exceed the requirement.
    quantiles : sequence of float, optional
        Fractions of the time, greater than 0 and at most 1.
    formulation : {"exact", "paper"}, optional
        Corrected equations, or the equations as printed.
    progress : callable, optional
        Called with a text and the completed fraction.

    Returns
    -------
    ActuatorRequirementsResult
        Requirements of every leg and their history.

    Raises
    ------
    ValueError
        If an argument is invalid, no motion is given, or a pose is unsolvable.

    Warns
    -----
    SingularPoseWarning
        If a motion crosses a singular pose.

    See Also
    --------
    drive_effort : Compute motor torques, speeds, currents, and powers along a motion.
    inverse_dynamics : Compute actuator forces.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> path, step = ss.PAPER_PATHS["I"]
    >>> time = path.time_grid(step)
    >>> needs = ss.actuator_requirements(robot, [(time, path.sample(time))], quantiles=[0.9, 1.0])
    >>> needs.force[-1].round(1).tolist()
    [569.7, 1146.7, 1434.1, 616.9, 151.1, 383.0]
    >>> needs.stroke.round(3).tolist()
    [0.114, 0.141, 0.187, 0.124, 0.098, 0.108]
    """
    instance(robot, Robot, "robot")
    margin = number_in(margin, "margin", "a finite fraction >= 0", closed=True)
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
    """Return a warning text about a singular pose that a motion crosses.

    Arrays are checked only at the samples, because their rates may not be the derivatives of their poses.
    """
    if given.log is not None:
        return crossing_warning(robot, given.log)
    rows = range(len(given.time))
    return row_warning(robot, Trajectory(given.time, given.motion, f"motions[{number}]", rows), "samples")


def checked_quantiles(quantiles: Sequence[float], where: str = "quantiles") -> Array:
    """Return fractions of the time in increasing order, shape (q,); raise ValueError if they are invalid."""
    shares = real_array(quantiles, where, "fractions > 0 and <= 1")
    if shares.ndim != 1 or not shares.size or not np.all((shares > 0.0) & (shares <= 1.0)):
        raise ValueError(f"{where}: expected fractions > 0 and <= 1, got {shown(quantiles)}")
    return np.unique(shares)


class _Given(NamedTuple):
    time: Array
    motion: Motion
    log: Trajectory | None = None


def _checked(robot: Robot, motions: object) -> list[_Given]:
    if not isinstance(motions, Iterable) or isinstance(motions, Motion):
        raise ValueError(f"motions: expected pairs (time, motion), got {type(motions).__name__}")
    found = []
    for i, pair in enumerate(motions):
        log = None
        if isinstance(pair, Trajectory):
            log, pair = pair, (pair.time, pair.motion)
        if not isinstance(pair, tuple | list) or len(pair) != 2:
            raise ValueError(f"motions[{i}]: expected a pair (time, motion), got {type(pair).__name__}")
        time, motion = pair
        instance(motion, Motion, f"motions[{i}]")
        need_motion(robot, motion)
        found.append(_Given(times_of(motion, time, f"motions[{i}]: time"), motion, log))
    if not found:
        raise ValueError("motions: expected at least one, got none")
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
    """Join all motions, with standard deviations if any motion has noise."""
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
    parts = [_noise(robot, each, formulation, np.array(neutral)) for each in given]
    sd = {name: read_only(np.concatenate([part[name] for part, _ in parts])) for name in parts[0][0]}
    return ActuatorHistory(**every, std=sd, replaced=np.concatenate([flags for _, flags in parts]))


def _noise(
    robot: Robot, given: _Given, formulation: Formulation, neutral: Array
) -> tuple[dict[str, Array], Flags]:
    """Return the standard deviations of a motion by name, and a flag for samples of replaced rows."""
    trajectory = Trajectory(given.time, given.motion, "", ()) if given.log is None else given.log
    found = all_deviations(robot, trajectory, formulation, neutral=neutral)
    sd = {NAMES.get(name, name): values for name, values in found.items() if name != "electrical_power"}
    return sd, at_replaced(trajectory, given.time)


NAMES = {"base": "base_angle", "platform": "platform_angle", "leg_power": "power"}
NAMES |= {"speed": "motor_speed", "power": "motor_power"}
"""Names of standard deviations that differ from the names of ``ActuatorHistory``."""

_OVER_TIME = {"force": "F", "speed": "L_dot", "power": "power", "torque": "torque"} | {
    name: name for name in ("motor_speed", "motor_power", "current")
}
"""Requirements for fractions of the time, and the quantity whose magnitude each one contains."""
_LARGEST = {
    "max_push_force": ("F", 1),
    "max_pull_force": ("F", -1),
    "max_driving_power": ("power", 1),
    "max_braking_power": ("power", -1),
}
"""Requirements that are the largest value (at least 0) of a quantity with a sign."""


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


def _deviations(course: ActuatorHistory, sd: Mapping[str, Array], shares: Array) -> dict[str, Array]:
    """Return the largest change of each requirement for errors of one standard deviation at every sample.

    Errors of ``SURE`` standard deviations, divided by ``SURE``, are also tried, because discontinuous
    friction causes gaps. Keys are the names of the requirements.
    """

    def change(of: Callable[[Array], Array], values: Array, name: str) -> Array:
        at, found = of(values), np.zeros(())
        both = sides(sd, name)
        assert both is not None
        rise, fall = both
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
    """Return values, (q, m), that values (n, m) do not exceed for fractions (q,) of their weight (n,)."""
    order = np.argsort(values, axis=0)
    ranked = np.take_along_axis(values, order, axis=0)
    reached = np.cumsum(weight[order], axis=0)
    # The tolerance compensates for rounding, so that the last value reaches the whole sum.
    wanted = shares[:, None, None] * reached[-1] * (1.0 - 4.0 * len(values) * np.finfo(np.float64).eps)
    first = np.argmax(reached >= wanted, axis=1)
    first[shares == 1.0] = len(values) - 1
    return np.take_along_axis(ranked, first, axis=0)
