"""What a plan keeps to between its samples: extremes of the legs, limits, the nearest singular pose."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..dynamics.inverse_dynamics import inverse_dynamics
from ..io.arguments import instance
from ..io.array_types import Array
from ..kinematics.clearance import joint_angles
from ..kinematics.inverse_kinematics import inverse_kinematics
from ..singularities.path_singularities import LegExtreme, SingularityCrossing, extremes, path_singularities
from .path_parameterization import TimedPath
from .places import BLOCK, Places, places_along, places_at
from .timing.path_rates import need_rates
from .timing.path_terms import force_limits, leg_accelerations, limited_speeds

ROUNDING = 1e-6
"""Share of a limit by which it may be exceeded."""

# Places at which the path's rates are held against its poses.
_MOST_PLACES = 200_000
_ACTIVE = 1e-3
_INSTANTS = 20_001


class Approached(NamedTuple):
    """Where along a plan H is nearest to singular: time, s, and smallest singular value of the scaled H."""

    time: float
    smallest: float


@dataclass(frozen=True, eq=False)
class PlanCertificate:
    """What was found of a plan on a grid 100 times finer than its own, and by a search for singular poses.

    Attributes
    ----------
    samples : int
        Number of places on the finer grid, both sides of nodes and turning points included.
    shortest, longest : LegExtreme
        Least and greatest length of each leg, m, and when.
    speed : LegExtreme
        Greatest speed of each leg, m/s, and when.
    force : LegExtreme
        Greatest force of each leg, N, without its sign, and when, also at rest before and after the motion.
    max_utilization : float
        Largest share of any limit of force, speed, acceleration, jerk or of the motors.
    lengths_ok : bool
        Whether all legs stay within their lengths.
    base_angle, platform_angle : LegExtreme, optional
        Greatest angle of each joint at both ends, rad, and when, found between the instants as lengths are;
        None of a robot that states no home pose, from which they are.
    angles_ok : bool
        Whether all of these are within the robot's ``joint_angle_limit``.
    active_fraction : float
        Share of the duration in which a limit is used to more than 99.9 %.
    crossings : tuple
        Singular poses that the path crosses.
    nearest : Approached
        The nearest approach to one.
    """

    samples: int
    shortest: LegExtreme
    longest: LegExtreme
    speed: LegExtreme
    force: LegExtreme
    max_utilization: float
    lengths_ok: bool
    base_angle: LegExtreme | None
    platform_angle: LegExtreme | None
    angles_ok: bool
    active_fraction: float
    crossings: tuple[SingularityCrossing, ...]
    nearest: Approached

    @property
    def is_valid(self) -> bool:
        """Whether every limit is kept, to 1e-6 of it, and no singular pose is crossed."""
        kept = self.max_utilization <= 1.0 + ROUNDING and self.lengths_ok and self.angles_ok
        return kept and not self.crossings


def certify_plan(plan: TimedPath) -> PlanCertificate:
    """Check a plan between its nodes, by inverse dynamics and not by the terms it was made from.

    Parameters
    ----------
    plan : TimedPath
        Path and parameter over time.

    Returns
    -------
    PlanCertificate
        Extremes, and whether all limits hold.

    Raises
    ------
    ValueError
        For a path whose rates contradict its poses, or jump, as ``parameterize_path`` does, on the finer
        grid.
    """
    instance(plan, TimedPath, "plan")
    robot, profile = plan.robot, plan.profile
    nodes = profile.nodes
    along = path_singularities(robot, plan.path, nodes.s)
    places = places_along(plan)
    different = np.unique(places.s)
    need_rates(robot, plan.path, different[:: 1 + len(different) // _MOST_PLACES])
    legs, forces, used = zip(*(_part(plan, part) for part in places.blocks()), strict=True)
    speed, force, most = np.abs(np.concatenate(legs)), np.abs(np.concatenate(forces)), np.concatenate(used)
    times, count = places.time, len(places.time)

    def when(s: Array) -> Array:
        return np.asarray(np.interp(s, nodes.s, profile.times))

    angles = [LegExtreme(when(found.time), found.value) for found in _angles(plan)]
    (low, high), most_angles = robot.length_limits.T, robot.joint_angle_limit.T * (1.0 + ROUNDING)
    return PlanCertificate(
        samples=count,
        shortest=LegExtreme(when(along.min_length.time), along.min_length.value),
        longest=LegExtreme(when(along.max_length.time), along.max_length.value),
        speed=_extreme(times, speed),
        force=_extreme(times, force),
        max_utilization=max(float(most.max()), float(_jerk(plan, count).max())),
        lengths_ok=bool((along.min_length.value >= low).all() and (along.max_length.value <= high).all()),
        base_angle=angles[0] if angles else None,
        platform_angle=angles[1] if angles else None,
        angles_ok=all((a.value <= most).all() for a, most in zip(angles, most_angles, strict=False)),
        active_fraction=_active(plan),
        crossings=along.crossings,
        nearest=Approached(
            float(when(np.array(along.nearest.time))),
            float(along.nearest.singularity.smallest_singular_value),
        ),
    )


def _angles(plan: TimedPath) -> list[LegExtreme]:
    """Greatest angles of the joints at base and platform along s; none without a home pose."""
    if plan.robot.home_position is None:
        return []

    def sought(s: Array) -> Array:
        found = joint_angles(plan.robot, plan.path(s))
        return -np.concatenate([found.base, found.platform], axis=-1)

    s, least = extremes(sought, plan.profile.nodes.s)
    return [LegExtreme(s[end], -least[end]) for end in (slice(0, 6), slice(6, 12))]


def _active(plan: TimedPath) -> float:
    """Share of the time in which a limit is active."""
    time = np.linspace(0.0, plan.duration, _INSTANTS)
    used = np.maximum(_part(plan, places_at(plan, time))[2], _jerk(plan, _INSTANTS))
    return float(np.mean(used > 1.0 - _ACTIVE))


def _jerk(plan: TimedPath, count: int) -> Array:
    """Shares of the limits of jerk that are used up to each of count instants, by differences, (count,)."""
    found = np.zeros(count)
    if plan.limits.jerk is None:
        return found
    times = np.linspace(0.0, plan.duration, count)
    parts = [slice(i, i + BLOCK) for i in range(0, count, BLOCK)]
    seconds = np.concatenate([leg_accelerations(plan.robot, plan.sample(times[part])) for part in parts])
    rates = np.abs(np.diff(seconds, axis=0)) / np.diff(times)[:, None]
    found[1:] = (rates / np.array(plan.limits.jerk)).max(axis=-1)
    return found


def _part(plan: TimedPath, places: Places) -> tuple[Array, Array, Array]:
    """Leg speeds, forces and the largest share of a limit at some places of the path."""
    motion = places.motion(plan)
    F = inverse_dynamics(plan.robot, motion, plan.formulation).F
    legs = inverse_kinematics(plan.robot, motion)
    speeds, allowed = limited_speeds(plan.robot, motion, legs.L_dot, plan.limits)
    used = [np.abs(F) / force_limits(plan.robot, plan.limits), speeds / allowed]
    drive = plan.robot.drive
    if drive is not None:
        motors = places.motors(plan, motion, F, legs.L_dot)
        used += [np.abs(motors.torque) / drive.torque_limit, np.abs(motors.power) / drive.power_limit]
        if motors.current is not None:
            used.append(np.nan_to_num(np.abs(motors.current) / drive.current_limit))
    if plan.limits.acceleration is not None:
        assert legs.L_ddot is not None
        used.append(np.abs(legs.L_ddot) / np.array(plan.limits.acceleration))
    return legs.L_dot, F, np.concatenate(used, axis=-1).max(axis=-1)


def _extreme(times: Array, values: Array) -> LegExtreme:
    at = np.argmax(values, axis=0)
    return LegExtreme(times[at], values.max(axis=0))
