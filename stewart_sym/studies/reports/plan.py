"""Report of ``plan``: trajectory, summary, JSON data, and plots."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from ...drives.limits import LimitTracker, trapezoids
from ...dynamics.inverse_dynamics import inverse_dynamics
from ...io.array_types import Array
from ...kinematics.conditioning import characteristic_length, scaled_condition_number
from ...kinematics.inverse_kinematics import inverse_kinematics, wrench_matrix
from ...kinematics.trajectory_writer import trajectory_columns
from ...motion.motion import Motion
from ...motion.rotation import angles_from_rotation, vector_from_rotation
from ...motion.straight_line import MOST_STEPS
from ...planning.path_parameterization import TimedPath
from ...planning.places import places_along
from ...planning.plan_certificate import PlanCertificate
from ...planning.plan_file import RATE
from ...planning.plan_path import Conditions, PlannedPath
from ...planning.timing.path_terms import force_limits
from ...robot.robot import LEGS, Robot
from ...robot.units import Units
from ...viewer.motion_history import of_motion
from ...viewer.view import Viewer
from ..common.drawing import BLUE, GRAY, RED, Axes, Figure, legend_below, log_numbers, new_figure
from ..common.report import SMALL, Picture, Report
from ..common.text_tables import Columns, by_leg, of_legs
from .leg_plot import leg_figure
from .leg_tables import motor_data, motor_table

# Number of samples of the work, because accelerations jump between them if another limit becomes active.
_INSTANTS = 10_001
# Number of drawn samples of the forces, and of poses for the condition numbers of a path.
_DRAWN, _POSES = 4000, 801
_CERTIFIED = ("is_valid", "samples", "max_utilization", "lengths_ok", "angles_ok", "active_fraction")


@dataclass(eq=False)
class Plan:
    """Path with its time parameterization and results, sampled at ``rate`` (Hz)."""

    robot: Robot
    planned: PlannedPath
    timed: TimedPath
    certificate: PlanCertificate
    rate: float
    # Torque (N m) and speed (rad/s) of the motors, (n, 6), which are set together with ``motors``.
    torque: Array = field(init=False)
    speed: Array = field(init=False)

    @cached_property
    def motors(self) -> LimitTracker | None:
        """Motor requirements at the samples of the certificate; None without a drive."""
        if self.robot.drive is None:
            return None
        places, first = places_along(self.timed), 0
        found = LimitTracker(self.robot, places.time)
        self.torque, self.speed = np.zeros((2, len(places.time), LEGS))
        for part in places.blocks():
            motion, where = part.motion(self.timed), slice(first, first + len(part.time))
            F = inverse_dynamics(self.robot, motion, self.timed.formulation).F
            L_dot = inverse_kinematics(self.robot, motion).L_dot
            motors = part.motors(self.timed, motion, F, L_dot)
            found.add(where, motors._asdict())
            self.torque[where], self.speed[where] = motors.torque, motors.speed
            first = where.stop
        return found

    @cached_property
    def energy(self) -> float:
        """Electrical energy of the plan (J), or work of the leg forces without a drive."""
        if self.motors is not None:
            return float(self.motors.energy.sum())
        times = self.timed.time_grid(_INSTANTS)
        motion = self.timed.sample(times)
        F = inverse_dynamics(self.robot, motion, self.timed.formulation).F
        return float(trapezoids(times) @ np.sum(F * inverse_kinematics(self.robot, motion).L_dot, axis=-1))

    @property
    def times(self) -> Array:
        """Sample times of the trajectory (s); the last one is its end."""
        end = self.timed.duration
        return np.append(np.arange(0.0, end * (1.0 - 1e-9), 1.0 / self.rate), end)


def need_samples(end: float, rate: float) -> None:
    """Reject a trajectory whose duration (s) and rate (Hz) give too many samples."""
    if not end * rate < MOST_STEPS:
        name = "rate" if end * RATE < MOST_STEPS else "duration"
        raise ValueError(
            f"{name}: expected at most {MOST_STEPS:,} samples, got {end:.6g} s at a rate of {rate:g} Hz"
        )


def _along(plan: Plan, times: Array, motion: Motion) -> Columns:
    """Return columns over time: path parameter, its rates, condition number, lengths, speeds, and forces."""
    place = plan.timed.profile.at(times)
    legs = inverse_kinematics(plan.robot, motion)
    forces = inverse_dynamics(plan.robot, motion, plan.timed.formulation).F
    columns: Columns = {"time": times, "s": place.s, "s_dot": place.rate, "s_ddot": place.second}
    columns["scaled_condition"] = _conditions(plan.robot, motion)
    return columns | of_legs("L", legs.L) | of_legs("L_dot", legs.L_dot) | of_legs("F", forces)


def _conditions(robot: Robot, motion: Motion) -> Array:
    """Compute condition numbers of H with moments divided by the characteristic length, shape (n,)."""
    return scaled_condition_number(wrench_matrix(robot, motion), characteristic_length(robot) or 1.0)


def report(plan: Plan) -> Report:
    """Create the report of a plan with its plots."""
    times, robot = plan.times, plan.robot
    motion = plan.timed.sample(times)
    tables = {"trajectory": trajectory_columns(robot, times, motion), "path": _along(plan, times, motion)}
    text = _summary(plan) if plan.motors is None else f"{_summary(plan)}\n\n{motor_table(plan.motors)}"
    figures = {
        "condition": Picture(lambda: _condition_figure(plan)),
        "forces": Picture(lambda: _forces_figure(plan), SMALL),
        "phase_plane": Picture(lambda: _phase_figure(plan)),
    }
    view = {"motion": lambda: Viewer(robot, of_motion(robot, motion, times, "planned motion"))}
    return Report(text, tables, _data(plan), figures, view)


def _summary(plan: Plan) -> str:
    """Format verdict, duration, condition numbers, extremes, and distance to singular poses."""
    found, planned, units = plan.certificate, plan.planned, Units.of(plan.robot)
    over = {"leg lengths": not found.lengths_ok, "joint angles": not found.angles_ok}
    beyond = " and ".join(name for name, exceeded in over.items() if exceeded)
    verdict = "valid" if found.is_valid else f"not valid{beyond and f': {beyond} beyond their limits'}"
    longer = planned.condition_numbers.length / planned.initial_condition_numbers.length
    shortest, longest = found.shortest.value.min(), found.longest.value.max()
    lines = [
        f"certificate  {verdict}",
        f"duration     {plan.timed.duration:.6g} s, from rest to rest",
        f"path         {longer:.4g} times as long as the straight one",
        f"condition    scaled number of H: {_condition_text(planned.condition_numbers)}",
        f"             of the straight path: {_condition_text(planned.initial_condition_numbers)}",
        f"energy       {plan.energy:.6g} J{'' if plan.motors is not None else ', work of the leg forces'}",
        f"length       {shortest / units.meters:.6g} to {longest / units.meters:.6g} {units.length}",
    ]
    for text, peaks, si_unit in (
        ("force        up to", found.force, "N"),
        ("speed        up to", found.speed, "m/s"),
        ("angle        at the base up to", found.base_angle, "rad"),
        ("angle        at the platform up to", found.platform_angle, "rad"),
    ):
        if peaks is not None:
            leg, (scale, unit) = int(np.argmax(peaks.value)), units.of_unit(si_unit)
            peak = f"{scale * peaks.value[leg]:.6g} {unit}, leg {leg + 1} at {peaks.time[leg]:.6g} s"
            lines.append(f"{text} {peak}")
    lines += [
        f"limits       used to {100.0 * found.max_utilization:.5f} % at {found.samples:,} samples, "
        f"one is active in {100.0 * found.active_fraction:.4g} % of the time",
        f"crossings    {len(found.crossings)}; nearest to a singular pose at {found.nearest.time:.6g} s, "
        f"smallest singular value {found.nearest.smallest:.4g}",
    ]
    return "\n".join([*lines, *_moved(planned, units)])


def _condition_text(found: Conditions) -> str:
    peak = "infinite, it crosses a singular pose" if np.isinf(found.peak) else f"{found.peak:.5g}"
    return f"mean {found.mean:.5g}, peak {peak}"


def _moved(planned: PlannedPath, units: Units) -> Iterator[str]:
    """Yield the displacement of the path from each via pose with a tolerance."""
    pairs = zip(planned.requested_poses, planned.reached_poses, strict=True)
    for number, (given, passed) in enumerate(pairs, start=1):
        if given.has_tolerance:
            moves = np.concatenate([passed.t - given.t, vector_from_rotation(given.R.T @ passed.R)])
            # Small rotations are rounding errors.
            moves[3:][np.abs(moves[3:]) <= 1e-12] = 0.0
            moves /= np.repeat([units.meters, units.radians], 3)
            named = zip(("x", "y", "z", "roll", "pitch", "yaw"), moves, strict=True)
            parts = ", ".join(f"{name} {value:+.4g}" for name, value in named if value)
            yield f"via pose {number}  moved by {parts or 'nothing'} ({units.length}, {units.angle})"


def _data(plan: Plan) -> dict[str, Any]:
    """Return the numbers of the summary for the JSON data."""
    found, planned = plan.certificate, plan.planned
    legs: dict[str, Any] = {
        "min_length_m": found.shortest.value,
        "max_length_m": found.longest.value,
        "peak_speed_m_per_s": found.speed.value,
        "peak_force_N": found.force.value,
        "peak_force_time_s": found.force.time,
        "force_limit_N": force_limits(plan.robot, plan.timed.limits),
    }
    # A robot without a home pose has no joint angles.
    if found.base_angle is not None and found.platform_angle is not None:
        ends = {"base": found.base_angle, "platform": found.platform_angle}
        legs |= {f"peak_{end}_angle_rad": angle.value for end, angle in ends.items()}
        limits = zip(ends, plan.robot.joint_angle_limit.T, strict=True)
        legs |= {f"{end}_angle_limit_rad": limit for end, limit in limits}
    order = plan.robot.trajectory_format.rotation_order
    return {
        "duration_s": plan.timed.duration,
        "energy_J": plan.energy,
        "rate_Hz": plan.rate,
        "condition_numbers": vars(planned.condition_numbers),
        "initial_condition_numbers": vars(planned.initial_condition_numbers),
        "via_poses": [
            {"t_m": pose.t, "theta_rad": angles_from_rotation(pose.R, order) + 0.0}
            for pose in planned.reached_poses
        ],
        "legs": by_leg(legs | ({} if plan.motors is None else motor_data(plan.motors))),
        "certificate": {
            **{name: getattr(found, name) for name in _CERTIFIED},
            "crossings_s": [crossing.time for crossing in found.crossings],
            "nearest_singular_pose_time_s": found.nearest.time,
            "smallest_singular_value": found.nearest.smallest,
        },
        "units": {
            "condition_numbers": "of H with moments over the characteristic length; path length over it",
            "max_utilization": "fraction of a limit",
            "active_fraction": "fraction of the duration",
        },
    }


def _path_axes(plan: Plan, height: float, label: str) -> tuple[Figure, Axes]:
    """Create a plot over the path parameter with dashed lines at the via poses."""
    figure = new_figure(8.0, height)
    axes = figure.subplots()
    for via in plan.planned.path.via:
        axes.axvline(via, color=GRAY, linewidth=0.7, linestyle=(0, (4, 3)))
    axes.set(xlim=(0.0, 1.0), xlabel="path parameter s; via poses dashed", ylabel=label)
    return figure, axes


def _condition_figure(plan: Plan) -> Figure:
    """Plot the condition numbers of the planned and of the straight path over their parameter."""
    figure, axes = _path_axes(plan, 4.4, "scaled condition number of H")
    planned, s = plan.planned, np.linspace(0.0, 1.0, _POSES)
    drawn = ((planned.initial_path, "straight spline", GRAY), (planned.path, "planned", BLUE))
    for path, name, color in drawn:
        axes.semilogy(s, _conditions(plan.robot, path(s)), color=color, linewidth=1.4, label=name)
    log_numbers(axes.yaxis)
    legend_below(figure)
    return figure


def _forces_figure(plan: Plan) -> Figure:
    """Plot the forces, and with drives the motor torques, with their limits."""
    times = np.linspace(0.0, plan.timed.duration, _DRAWN)
    limits = force_limits(plan.robot, plan.timed.limits)
    forces = inverse_dynamics(plan.robot, plan.timed.sample(times), plan.timed.formulation).F
    motors = None if plan.motors is None else (plan.torque, plan.speed)
    return leg_figure(replace(plan.robot, force_limit=limits), times, forces, motors)


def _phase_figure(plan: Plan) -> Figure:
    """Plot s' over s: the motion, and its limits for feasible accelerations and for stopping at the end."""
    figure, axes = _path_axes(plan, 4.6, "its rate, 1/s")
    profile = plan.timed.profile
    s, rate = profile.nodes.s, profile.nodes.rate
    top = 1.6 * float(rate.max())
    if profile.ease is None:
        for square, color, name in (
            (profile.phase.most, GRAY, "no acceleration keeps the limits above"),
            (profile.phase.stops, RED, "rest at the end is out of reach above"),
        ):
            axes.plot(s, np.minimum(np.sqrt(square), 2.0 * top), color=color, linestyle="--", label=name)
    axes.plot(s, rate, color=BLUE, label="motion")
    axes.set(ylim=(0.0, top))
    legend_below(figure)
    return figure
