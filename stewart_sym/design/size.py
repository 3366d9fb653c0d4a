"""Sizing: which force, speed, power, stroke and joint angles motions and their loads need of every leg."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..dynamics.inverse import Formulation, inverse_dynamics, need_motion
from ..io.arguments import instance, number_in, real_array
from ..io.array_types import Array
from ..io.frozen import Frozen
from ..io.progress import Progress, silent
from ..kinematics.inverse import inverse_kinematics
from ..kinematics.joint_angles import angles_between, neutral_directions
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
    """

    weight: Array
    F: Array
    L: Array
    L_dot: Array
    base: Array
    platform: Array

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
        Sizes |F|, N, |L_dot|, m/s, and |F L_dot|, W, that are not exceeded for these shares of the time,
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


def checked_quantiles(quantiles: Sequence[float]) -> Array:
    """Shares of the time in rising order, (q,); ValueError for others."""
    shares = real_array(quantiles, "quantiles", "shares > 0 and <= 1")
    if shares.ndim != 1 or not shares.size or not np.all((shares > 0.0) & (shares <= 1.0)):
        raise ValueError(f"quantiles: expected shares > 0 and <= 1, got {np.array2string(shares)}")
    return np.unique(shares)


def _checked(robot: Robot, motions: object) -> list[tuple[Array, Motion]]:
    if not isinstance(motions, Iterable):
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
                f"motions[{i}]: expected a motion of the shape of its time, (n,), got {motion.shape} and "
                f"{time.shape}"
            )
        if not np.isfinite(time).all() or np.any(np.diff(time) <= 0.0):
            raise ValueError(f"motions[{i}]: time: expected finite, rising instants")
        found.append((time, motion))
    if not found:
        raise ValueError("motions: expected one at least, got none")
    return found


def _course(robot: Robot, time: Array, motion: Motion, formulation: Formulation) -> dict[str, Array]:
    legs = inverse_kinematics(robot, motion)
    # An instant stands for half the time to its neighbours; one alone for what no other can outweigh.
    steps = np.diff(time)
    weight = 0.5 * (np.append(steps, 0.0) + np.append(0.0, steps)) if steps.size else np.ones(1)
    return {
        "weight": weight,
        "F": inverse_dynamics(robot, motion, formulation).F,
        "L": legs.L,
        "L_dot": legs.L_dot,
        "base": legs.s,
        "platform": legs.s @ motion.R,
    }


def _needs(robot: Robot, courses: Sequence[dict[str, Array]], margin: float, shares: Array) -> Needs:
    every = {name: np.concatenate([course[name] for course in courses]) for name in courses[0]}
    for end in ("base", "platform"):
        s = every[end]
        neutral = s.mean(axis=0) if robot.home is None else neutral_directions(robot)
        every[end] = angles_between(s, neutral)
    course = Course(**every)
    F, power = course.F, course.power

    def over_time(values: Array) -> Array:
        return weighted_quantiles(np.abs(values), course.weight, shares)

    return Needs(
        margin=margin,
        quantiles=shares,
        force=over_time(F),
        speed=over_time(course.L_dot),
        power=over_time(power),
        push=F.max(axis=0).clip(min=0.0),
        pull=(-F.min(axis=0)).clip(min=0.0),
        rms_force=np.sqrt(np.average(F**2, axis=0, weights=course.weight)),
        driving=power.max(axis=0).clip(min=0.0),
        braking=(-power.min(axis=0)).clip(min=0.0),
        length=np.stack([course.L.min(axis=0), course.L.max(axis=0)], axis=-1),
        base_angle=course.base.max(axis=0),
        platform_angle=course.platform.max(axis=0),
        course=course,
    )


def weighted_quantiles(values: Array, weight: Array, shares: Array) -> Array:
    """Least values, (q, m), that values (n, m) do not exceed for these shares, (q,), of their weight, (n,)."""
    order = np.argsort(values, axis=0)
    ranked = np.take_along_axis(values, order, axis=0)
    reached = np.cumsum(weight[order], axis=0)
    # Against the rounding of the sum: the whole of it is reached at the last value.
    wanted = shares[:, None, None] * reached[-1] * (1.0 - 4.0 * len(values) * np.finfo(np.float64).eps)
    first = np.argmax(reached >= wanted, axis=1)
    first[shares == 1.0] = len(values) - 1
    return np.take_along_axis(ranked, first, axis=0)


def exceeded(robot: Robot, needs: Needs) -> list[str]:
    """One line for each limit of the robot that a need with its margin exceeds, legs numbered from 1."""
    lines = []
    more = 1.0 + needs.margin
    low, high = robot.length_limits.T
    peak = (
        ("force_limit", "N", np.maximum(needs.push, needs.pull), robot.force_limit, 1.0),
        ("speed_limit", "m/s", np.abs(needs.course.L_dot).max(axis=0), robot.speed_limit, 1.0),
        ("joint_angle_limit at the base", "deg", needs.base_angle, robot.joint_angle_limit[:, 0], _DEGREES),
        (
            *("joint_angle_limit at the platform", "deg"),
            *(needs.platform_angle, robot.joint_angle_limit[:, 1], _DEGREES),
        ),
        ("stroke", "m", needs.stroke, high - low, 1.0),
    )
    for name, unit, need, limit, scale in peak:
        for i in np.flatnonzero(need * more > limit).tolist():
            lines.append(
                f"{name} of leg {i + 1}: {limit[i] * scale:.4g} {unit}, needed {need[i] * scale:.4g} {unit}, "
                f"with the margin {need[i] * more * scale:.4g} {unit}"
            )
    for i in np.flatnonzero((needs.length[:, 0] < low) | (needs.length[:, 1] > high)).tolist():
        least, most = needs.length[i]
        lines.append(
            f"length_limits of leg {i + 1}: {low[i]:.4g} to {high[i]:.4g} m, needed {least:.4g} to {most:.4g} m"
        )
    return lines


_DEGREES = 180.0 / np.pi
