"""Verification of a plan between its samples: extremes of the legs, limits, and the nearest singular pose."""

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
"""Relative excess up to which a limit counts as satisfied."""

# Largest number of samples in the comparison of the rates of the path with its poses.
_MOST_PLACES = 200_000
_ACTIVE = 1e-3
_INSTANTS = 20_001


class Approached(NamedTuple):
    """Closest approach to a singularity: time (s), and smallest singular value of the scaled H."""

    time: float
    smallest: float


@dataclass(frozen=True, eq=False)
class PlanCertificate:
    """Result of the verification of a plan on a fine grid, with a search for singular poses.

    The grid is 100 times finer than the grid of the plan.

    Attributes
    ----------
    samples : int
        Number of samples of the finer grid, including both sides of nodes and turning points.
    shortest, longest : LegExtreme
        Smallest and largest length of each leg (m), with times (s).
    speed : LegExtreme
        Largest speed of each leg (m/s), with times (s).
    force : LegExtreme
        Largest magnitude of the force of each leg (N), with times (s), including rest before and after the
        motion.
    max_utilization : float
        Largest utilization of any limit of force, speed, acceleration, jerk, or of the motors; 1 is the
        limit.
    lengths_ok : bool
        True if all leg lengths are within their limits.
    base_angle, platform_angle : LegExtreme, optional
        Largest angle of each joint at the base and at the platform (rad), with times (s), located between
        samples like the lengths. None if the robot has no home position, from which the angles are measured.
    angles_ok : bool
        True if all joint angles are within ``joint_angle_limit``.
    active_fraction : float
        Fraction of the duration in which a limit is utilized by more than 99.9 %.
    crossings : tuple of SingularityCrossing
        Singular poses on the path.
    nearest : Approached
        Closest approach to a singularity.
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
        """True if every limit is satisfied to a relative tolerance of 1e-6 and no singularity is crossed."""
        kept = self.max_utilization <= 1.0 + ROUNDING and self.lengths_ok and self.angles_ok
        return kept and not self.crossings


def certify_plan(plan: TimedPath) -> PlanCertificate:
    """Verify a plan between its nodes.

    The verification uses inverse dynamics and is independent of the terms from which the plan was computed.

    Parameters
    ----------
    plan : TimedPath
        Path and parameter over time, for example the result of ``parameterize_path``.

    Returns
    -------
    PlanCertificate
        Extremes, utilization of the limits, and singularities.

    Raises
    ------
    ValueError
        If the rates of the path contradict its poses, or are discontinuous, on the finer grid.

    See Also
    --------
    parameterize_path : Fastest motion along a path within limits.
    path_singularities : Singularities along any path.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> def path(s):
    ...     zero = np.zeros((len(s), 3))
    ...     t = np.array([0.1, 0.0, 0.4]) + np.outer(s, [0.2, 0.0, 0.2])
    ...     R = np.broadcast_to(np.eye(3), (len(s), 3, 3))
    ...     return ss.Motion(R=R, t=t, omega=zero, v=zero + [0.2, 0.0, 0.2], alpha=zero, a=zero)
    >>> limits = ss.PathLimits(force=3000.0, speed=0.5)
    >>> plan = ss.parameterize_path(robot, path, limits=limits, grid_size=20)
    >>> certificate = ss.certify_plan(plan)
    >>> certificate.is_valid, round(certificate.max_utilization, 3)
    (True, 1.0)
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
    """Return the largest joint angles at base and platform along s; [] without a home position."""
    if plan.robot.home_position is None:
        return []

    def sought(s: Array) -> Array:
        found = joint_angles(plan.robot, plan.path(s))
        return -np.concatenate([found.base, found.platform], axis=-1)

    s, least = extremes(sought, plan.profile.nodes.s)
    return [LegExtreme(s[end], -least[end]) for end in (slice(0, 6), slice(6, 12))]


def _active(plan: TimedPath) -> float:
    """Return the fraction of the time in which a limit is active."""
    time = np.linspace(0.0, plan.duration, _INSTANTS)
    used = np.maximum(_part(plan, places_at(plan, time))[2], _jerk(plan, _INSTANTS))
    return float(np.mean(used > 1.0 - _ACTIVE))


def _jerk(plan: TimedPath, count: int) -> Array:
    """Compute the utilization of the jerk limits at ``count`` times by finite differences, (count,)."""
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
    """Compute leg rates, forces, and the largest utilization of a limit at samples of the path."""
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
    """Return the largest values of each leg, with times."""
    at = np.argmax(values, axis=0)
    return LegExtreme(times[at], values.max(axis=0))
