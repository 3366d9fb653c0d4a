"""Report of ``singularities``: singular poses that a path crosses, and the degrees of freedom lost there."""

import functools
from typing import Any

import numpy as np

from ...dynamics.inverse_dynamics import Formulation, inverse_dynamics
from ...io.array_types import Array
from ...kinematics.conditioning import characteristic_length, moments_over
from ...kinematics.inverse_kinematics import ROUNDING, leg_vectors
from ...kinematics.pose_search import rates_per_twist
from ...motion.interpolation import Path
from ...motion.motion import Motion
from ...motion.sample_times import time_text
from ...robot.robot import LEGS, Robot
from ...robot.units import Units
from ...singularities.path_singularities import path_singularities, singular_force_residue
from ...singularities.path_warnings import sign_text, triple_text, twist_text
from ...singularities.singular_poses import SingularityResult
from ..common.drawing import BLUE, DARK, RED, Figure, as_written, log_numbers, new_figure
from ..common.report import SMALL, Picture, Report
from ..common.text_tables import Columns, by_leg, leg_table, of_legs
from .machine_plot import twist_figure

# Numbers of samples over the path and near each mark, and largest numbers of marks and of drawn crossings.
_EVEN, _NEAR, _MARKS, _MOST_DRAWN = 401, 150, 50, 6


class Examination:
    """Singular poses of a path, and the residue A (N s) of each: F = A / (t - t_0), NaN without masses."""

    def __init__(
        self, robot: Robot, name: str, path: Path, times: Array, formulation: Formulation = "exact"
    ) -> None:
        """Find the singular poses; ``path`` and ``times`` as in ``singularity_crossings``."""
        self.robot, self.name, self.path, self.formulation = robot, name, path, formulation
        self.along = path_singularities(robot, path, times)
        self.residues = np.full((len(self.along.crossings), LEGS), np.nan)
        for A, crossing in zip(self.residues, self.along.crossings, strict=True):
            if not robot.missing_bodies:
                A[:] = singular_force_residue(robot, self.pose(crossing.time), formulation)[0]

    def pose(self, time: float) -> Motion:
        """Return the motion at a time (s), shape (1,)."""
        return self.path(np.array([time]))


def _text(found: Examination) -> str:
    """Format all results as text in the units of the robot file."""
    along = found.along
    lines = [
        f"verdict    {_verdict(found)}",
        f"robot      {found.robot.name}",
        f"path       {found.name}, {time_text(along.start)} s to {time_text(along.end)} s",
        f"nearest    {_near(along.nearest.time, along.nearest.singularity)}",
    ]
    if found.robot.tool.any():
        lines.append("point      reference point for twists and wrenches, not the tool of the robot file")
    lines += [f"singular   from {start:.9f} s to {end:.9f} s at every time" for start, end in along.spans]
    for number in range(len(along.crossings)):
        lines += ["", *_crossing_lines(found, number)]
    if not along.crossings:
        lines += ["", f"Nearest approach at {along.nearest.time:.9f} s"]
        lines += _pose_lines(along.nearest.singularity, Units.of(found.robot))
    others = [approach for approach in along.approaches if approach is not along.nearest]
    if others:
        lines += ["", "Other minima of the smallest singular value"]
        lines += [f"  {_near(approach.time, approach.singularity)}" for approach in others]
    return "\n".join([*lines, "", _legs_table(found)])


def _verdict(found: Examination) -> str:
    """Return the number of crossings, and whether a segment of the path is singular."""
    count = len(found.along.crossings)
    text = f"{count} crossing{'' if count == 1 else 's'} of a singular pose"
    return f"{text}, and a segment of singular poses" if found.along.spans else text


def full_report(found: Examination) -> Report:
    """Create the report with text, curves over time, their plot, and drawings of crossings."""
    columns = _curves(found)
    figures = {"path": Picture(lambda: _path_figure(found, columns))}
    crossings = enumerate(found.along.crossings[:_MOST_DRAWN], 1)
    drawn: dict[str, Any] = {f"crossing_{number}": crossing for number, crossing in crossings}
    for name, each in (drawn or {"nearest": found.along.nearest}).items():
        title = f"{found.robot.name}, path {found.name}, at {each.time:.9f} s"
        draw = functools.partial(twist_figure, found.robot, found.pose(each.time)[0], each.singularity, title)
        figures[name] = Picture(draw, SMALL)
    return Report(_text(found), {"path": columns}, _data(found), figures)


def _data(found: Examination) -> dict[str, Any]:
    """Return all results for the JSON data."""
    along, legs = found.along, dict[str, Any]()
    for name, unit in (("min_joint_sine", ""), ("min_length", "_m"), ("max_length", "_m")):
        extreme = getattr(along, name)
        legs |= {f"{name}{unit}": extreme.value, f"{name}_time_s": extreme.time}
    return {
        "robot": found.robot.name,
        "path": found.name,
        "twist_point_m": np.zeros(3),
        "start_s": along.start,
        "end_s": along.end,
        "crossings": [
            {
                "time_s": crossing.time,
                "time_error_s": crossing.time_error,
                "sign_before": crossing.sign_before,
                "sign_after": crossing.sign_after,
                "residue_N_s": A,
                **_pose_data(crossing.singularity),
            }
            for crossing, A in zip(along.crossings, found.residues, strict=True)
        ],
        "nearest": {"time_s": along.nearest.time, **_pose_data(along.nearest.singularity)},
        "minima": [{"time_s": each.time, **_pose_data(each.singularity)} for each in along.approaches],
        "singular_throughout_s": along.spans,
        "legs": by_leg(legs),
    }


def _pose_data(at: SingularityResult) -> dict[str, Any]:
    """Return the singularity measures of a pose for the JSON data."""
    return {
        "scaled_condition_number": at.condition_number,
        "characteristic_length_m": at.characteristic_length,
        "smallest_singular_value": at.smallest_singular_value,
        "lost_dof": at.lost_dof,
        "twist_v_m_per_s": at.twist[:3],
        "twist_omega_rad_per_s": at.twist[3:],
        "screw_pitch_m_per_rad": at.screw_pitch,
        "screw_axis": at.screw_axis,
        "screw_point_m": at.screw_point,
        "lost_force_N": at.wrench[:3],
        "lost_moment_N_m": at.wrench[3:],
        "leg_forces_N": at.leg_forces,
    }


def _curves(found: Examination) -> Columns:
    """Return columns (n,) over time, denser near each crossing and minimum; nan at unsolvable poses."""
    robot, along = found.robot, found.along
    duration = along.end - along.start
    marks = [crossing.time for crossing in along.crossings]
    marks += [approach.time for approach in (*along.approaches, along.nearest)]
    near = np.geomspace(1e-7, 0.1, _NEAR) * duration
    dense = [np.concatenate([mark - near, mark + near]) for mark in marks[:_MARKS]]
    times = np.unique(np.concatenate([np.linspace(along.start, along.end, _EVEN), *dense]))
    times = times[(times >= along.start) & (times <= along.end)]
    motion = found.path(times)
    length = characteristic_length(robot) or 1.0
    H = moments_over(np.swapaxes(rates_per_twist(robot, motion.R, motion.t), -1, -2), length)
    s = np.linalg.svd(H, compute_uv=False)
    F = np.full((len(times), LEGS), np.nan)
    if not robot.missing_bodies:
        F = inverse_dynamics(robot, motion, found.formulation, on_singular="nan").F
    _, S, L = leg_vectors(robot, motion.R, motion.t)
    # Rounding errors are set to zero, because the curve would be noise along singular poses.
    smallest = np.where(s[:, -1] > ROUNDING * s[:, 0], s[:, -1], 0.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        condition = s[:, 0] / smallest
        sine = np.linalg.norm(np.cross(robot.k, S), axis=-1) / L
    # The sign of det H changes at a crossing.
    columns = {"time": times, "smallest_singular_value": np.sign(np.linalg.det(H)) * smallest}
    columns |= {"scaled_condition": condition} | of_legs("F", F)
    columns |= {} if robot.base_joint == "spherical" else of_legs("joint_sine", sine)
    return columns | of_legs("L", L)


def _crossing_lines(found: Examination, number: int) -> list[str]:
    """Format one crossing: time, signs of det H, the pose, and the residue of the forces."""
    crossing, A = found.along.crossings[number], found.residues[number]
    before, after = sign_text(crossing.sign_before), sign_text(crossing.sign_after)
    error = f"rounding error up to {crossing.time_error:.1e} s"
    lines = [
        f"Crossing {number + 1} at {crossing.time:.12f} s ({error})",
        f"  det H                {before} before, {after} after",
        *_pose_lines(crossing.singularity, Units.of(found.robot)),
    ]
    if found.robot.missing_bodies:
        return [*lines, f"  force residue        unknown: {found.robot.missing_bodies[0]} is missing"]
    if not np.isfinite(A).all():
        return [*lines, "  force residue        none: the path is at rest there, or follows singular poses"]
    leg = int(np.argmax(np.abs(A)))
    ends = ["-inf", "+inf"] if A[leg] > 0.0 else ["+inf", "-inf"]
    values = ", ".join(f"{value:.6g}" for value in A)
    residue = f"  force residue        F = A / (t - t_0), A = ({values}) N s"
    return [*lines, residue, f"  most affected        leg {leg + 1}: {ends[0]} before, {ends[1]} after"]


def _pose_lines(at: SingularityResult, units: Units) -> list[str]:
    pitch, axis = float(at.screw_pitch), triple_text(at.screw_axis)
    motion, wrench, idle = "least-rate twist", "largest-force wrench", "least-wrench forces"
    if at.lost_dof:
        motion, wrench, idle = "unconstrained twist", "unbalanced wrench", "null-space forces"
    screw = f"translation along {axis}"
    if np.isfinite(pitch):
        pitch = round(pitch, 9) + 0.0
        point, pitch = at.screw_point / units.meters, pitch * units.radians / units.meters
        screw = f"rotation about {axis} through {triple_text(point)} {units.length}, "
        screw += f"pitch {pitch:.6g} {units.length}/{units.angle}"
    lines = [
        f"  condition number     {float(at.condition_number):.6g} "
        f"with moments divided by {at.characteristic_length / units.meters:.6g} {units.length}; smallest "
        f"singular value {float(at.smallest_singular_value):.3g}",
        f"  {motion:<20} {twist_text(at, units)}",
        f"  as a screw           {screw}",
        f"  {wrench:<20} force {triple_text(at.wrench[:3])} N, moment {triple_text(at.wrench[3:])} N m",
        f"  {idle:<20} {triple_text(at.leg_forces)} N",
    ]
    if int(at.lost_dof) > 1:
        lines.append(f"  lost freedoms        {int(at.lost_dof)}; the twist is one of several")
    return lines


def _legs_table(found: Examination) -> str:
    """Format the extreme values of the legs with their times."""
    along, units = found.along, Units.of(found.robot)
    columns = {}
    for title, scale, extreme in (
        ("min |k x s|", 1.0, along.min_joint_sine),
        (f"min length, {units.length}", 1.0 / units.meters, along.min_length),
        (f"max length, {units.length}", 1.0 / units.meters, along.max_length),
    ):
        pairs = zip(scale * extreme.value, extreme.time, strict=True)
        columns[title] = [f"{value:.6f} at {time:.6f} s" for value, time in pairs]
    title = "Smallest sine of the angle between leg and universal axis, and extreme lengths"
    return f"{title}\n{leg_table('leg', columns)}"


def _near(time: float, at: SingularityResult) -> str:
    text = f"{time:.9f} s: smallest singular value {float(at.smallest_singular_value):.6g}"
    return f"{text}, scaled condition number {float(at.condition_number):.6g}"


def _path_figure(found: Examination, columns: Columns) -> Figure:
    """Plot condition number, signed smallest singular value, and the largest force over the whole path."""
    figure, time, crossings = new_figure(9.0, 7.2), columns["time"], found.along.crossings
    panels = figure.subplots(3, 1, sharex=True)
    largest = np.max(np.abs([columns[f"F_{leg}"] for leg in range(1, LEGS + 1)]), axis=0)
    panels[1].axhline(0.0, color=DARK, linewidth=0.7)
    curves = {
        "scaled condition\nnumber of H": columns["scaled_condition"],
        "smallest singular value,\nsign of det H": columns["smallest_singular_value"],
        "largest actuator\nforce, N": largest,
    }
    for axes, (label, values) in zip(panels, curves.items(), strict=True):
        axes.plot(time, values, color=BLUE, linewidth=1.2)
        axes.set_ylabel(label)
        if axes is not panels[1] and np.isfinite(values).any():
            axes.set_yscale("log")
            log_numbers(axes.yaxis)
        for crossing in crossings:
            axes.axvline(crossing.time, color=RED, linewidth=0.9, linestyle=(0, (4, 2)))
    panels[2].set(xlabel="time, s", xlim=(time[0], time[-1]))
    figure.suptitle(as_written(f"{found.robot.name}, path {found.name}: {_verdict(found)}"), fontsize=11.0)
    return figure
