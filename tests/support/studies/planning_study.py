"""Condition numbers and forces along random paths, paths planned and straight, and Path III planned anew.

``python tests/support/studies/planning_study.py RUN`` writes ``plan.json``, ``plan_claim.png``,
``plan_path_III.png`` and ``plan_durations.png``.
"""

import functools
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from markdown_text import paragraph, table
from scipy.stats import spearmanr

from stewart_sym.dynamics.inverse_dynamics import inverse_dynamics
from stewart_sym.io.array_types import Array
from stewart_sym.io.output import json_text, write_file
from stewart_sym.kinematics.conditioning import characteristic_length, scaled_condition_number
from stewart_sym.kinematics.inverse_kinematics import inverse_kinematics, wrench_matrix
from stewart_sym.motion.motion import at_rest
from stewart_sym.motion.rotation import rotation_from_vector, vector_from_rotation
from stewart_sym.motion.straight_line import PAPER_PATHS
from stewart_sym.planning.path_parameterization import MINIMIZE, parameterize_path
from stewart_sym.planning.plan_path import PlannedPath, conditions_along, plan_path
from stewart_sym.planning.pose_path import Family, PosePath, ViaPose
from stewart_sym.planning.timing.path_terms import PathLimits, traveled
from stewart_sym.robot.robot import Robot
from stewart_sym.robots import dasgupta1998
from stewart_sym.singularities.path_singularities import singularity_crossings
from stewart_sym.studies.common.drawing import (
    BLUE,
    DARK,
    GRAY,
    RED,
    Figure,
    legend_below,
    log_numbers,
    new_figure,
)
from stewart_sym.studies.common.report import SMALL, Picture, draw
from stewart_sym.studies.common.text_tables import Figures
from stewart_sym.studies.robustness.machines import GRAVITY, random_machine

PATH_COUNT, MACHINE_COUNT, VIA_COUNT = 1000, 50, 6
YAW = 0.3
"""The end of Path III may be turned by up to this angle about the platform's own axis, rad."""
DURATION = 6.0
"""Duration of Path III, s."""
FORCE_OVER_REST, LONGER = 1.5, 1.5
"""The limit of force is so many times the largest at rest, the duration so many times the least time."""

_SAMPLES, _INSTANTS = 201, 10_001
_MOST_CONDITION = 40.0
# Durations of random paths, in units of the time in which the machine falls its own size.
_DURATIONS = {"slow": 20.0, "fast": 3.0}
_COLORS = {"slow": BLUE, "fast": RED, "straight": GRAY, "planned": BLUE}
_SHADES = (GRAY, BLUE, RED)


def along(robot: Robot, path: PosePath, duration: float) -> tuple[Array, Array]:
    """Condition numbers, (n,), and the largest force of any leg, N, (n,), from rest to rest along a path.

    s = 10 x^3 - 15 x^4 + 6 x^5 with x the share of the time.
    """
    x = np.linspace(0.0, 1.0, _SAMPLES)
    s = x**3 * (10.0 - 15.0 * x + 6.0 * x**2)
    rate = 30.0 * x**2 * (1.0 - x) ** 2 / duration
    second = 60.0 * x * (1.0 - x) * (1.0 - 2.0 * x) / duration**2
    motion = traveled(path(s), rate, second)
    forces = inverse_dynamics(robot, motion).F
    condition = scaled_condition_number(wrench_matrix(robot, motion), characteristic_length(robot))
    return condition, np.abs(forces).max(axis=-1)


def via_poses(rng: np.random.Generator, robot: Robot, count: int) -> tuple[ViaPose, ...]:
    """Poses about the home pose, well conditioned and on one side of singular poses."""
    size = float(np.linalg.norm(robot.b, axis=-1).mean())
    home = robot.b.mean(axis=0) + np.array([0.0, 0.0, 1.1 * size])
    side = 0.0
    found: list[ViaPose] = []
    while len(found) < count:
        R, t = rotation_from_vector(0.35 * rng.normal(size=3)), home + 0.2 * size * rng.normal(size=3)
        H = wrench_matrix(robot, at_rest(R, t))
        sign = float(np.sign(np.linalg.det(H)))
        good = float(scaled_condition_number(H, characteristic_length(robot))) < _MOST_CONDITION
        if good and side in (0.0, sign):
            side = sign
            found.append(ViaPose(R, t))
    return tuple(found)


def straight(robot: Robot, poses: tuple[ViaPose, ...]) -> PosePath:
    """The spline of least bending through via poses."""
    family = Family.of(poses, characteristic_length(robot))
    w = np.zeros((family.rest.shape[1], 7))
    return family.path(family.coefficients(np.zeros(0), w), robot.tool, np.zeros(6))


def claim(count: int = PATH_COUNT) -> dict[str, Any]:
    """Whether forces are higher where the condition number is: rank correlations along straight paths."""
    found: dict[str, list[float]] = {name: [] for name in _DURATIONS}
    peaks: list[list[float]] = []
    seed = 0
    while len(peaks) < count:
        rng = np.random.default_rng(seed)
        seed += 1
        robot = random_machine(rng)
        path = straight(robot, via_poses(rng, robot, 2))
        if not np.isfinite(conditions_along(robot, path, _SAMPLES).peak):
            continue
        own = np.sqrt(1.0 / GRAVITY)
        weight = GRAVITY * (robot.M + robot.m_d.sum() + robot.m_u.sum())
        forces = []
        for name, times in _DURATIONS.items():
            condition, force = along(robot, path, times * own)
            found[name].append(float(spearmanr(condition, force).statistic))
            forces.append(force.max() / weight)
        peaks.append([condition.max(), *forces])
    columns = np.array(peaks).T
    return {
        "paths": count,
        "durations": _DURATIONS,
        "correlation": found,
        "peak_condition": columns[0],
        "peak_force_over_weight": dict(zip(_DURATIONS, columns[1:], strict=True)),
        "correlation_of_peaks": {
            name: float(spearmanr(columns[0], column).statistic)
            for name, column in zip(_DURATIONS, columns[1:], strict=True)
        },
    }


def gains(count: int = MACHINE_COUNT) -> dict[str, Any]:
    """Planned over straight paths through six via poses: condition numbers, peak force, length."""
    rows = []
    for seed in range(count):
        rng = np.random.default_rng(10_000 + seed)
        robot = random_machine(rng)
        poses = via_poses(rng, robot, VIA_COUNT)
        found = plan_path(robot, poses)
        before, after = found.initial_condition_numbers, found.condition_numbers
        duration = 2.0 * VIA_COUNT * np.sqrt(1.0 / GRAVITY)
        forces = [float(along(robot, path, duration)[1].max()) for path in (found.initial_path, found.path)]
        ratios = [after.mean / before.mean, after.peak / before.peak, forces[1] / forces[0]]
        rows.append([*ratios, after.length / before.length])
    return dict(zip(("mean", "peak", "peak_force", "length"), np.array(rows).T, strict=True)) | {
        "machines": count
    }


def path_III() -> dict[str, Any]:
    """Path III between its own ends, and where its end may be yawed; forces of both in 6 s."""
    robot, planned = dasgupta1998(), planned_path_III()
    motion = PAPER_PATHS["III"].path.sample(np.array([0.0, DURATION]))
    paths = {"straight": planned.initial_path, "planned": planned.path}
    on = {name: along(robot, path, DURATION) for name, path in paths.items()}
    s = np.linspace(0.0, 1.0, 1001)
    return {
        "signs_of_det_H": np.sign(np.linalg.det(wrench_matrix(robot, motion))),
        "yaw_rad": float(
            vector_from_rotation(planned.requested_poses[1].R.T @ planned.reached_poses[1].R)[2]
        ),
        "crossings": {name: len(singularity_crossings(robot, path, s)) for name, path in paths.items()},
        "conditions": {
            "straight": vars(planned.initial_condition_numbers),
            "planned": vars(planned.condition_numbers),
        },
        "force_N": {name: force for name, (_, force) in on.items()},
        "condition": {name: condition for name, (condition, _) in on.items()},
    }


def planned_path_III() -> PlannedPath:
    """Path III planned anew, with its end free to be yawed."""
    motion = PAPER_PATHS["III"].path.sample(np.array([0.0, DURATION]))
    free = np.array([0.0, 0.0, 0.0, 0.0, 0.0, YAW])
    ends = (ViaPose(motion.R[0], motion.t[0]), ViaPose(motion.R[1], motion.t[1], -free, free))
    return plan_path(dasgupta1998(), ends)


def durations() -> dict[str, Any]:
    """Path III planned anew, in one and a half times its least time: slowed, and with least of something."""
    robot, path = dasgupta1998(), planned_path_III().path
    poses = path(np.linspace(0.0, 1.0, _SAMPLES))
    weight = np.abs(inverse_dynamics(robot, at_rest(poses.R, poses.t)).F).max()
    limits = PathLimits(force=FORCE_OVER_REST * float(weight))
    quick = parameterize_path(robot, path, limits=limits)
    duration = LONGER * quick.duration
    slow = replace(quick, profile=quick.profile.slowed(1.0 / LONGER))
    plans = {"least time, slowed": slow} | {
        f"least {least.replace('-', ' ')}": parameterize_path(
            robot, path, limits=limits, minimize=least, duration=duration
        )
        for least in MINIMIZE[1:]
    }
    time = np.linspace(0.0, duration, _SAMPLES)
    found: dict[str, Any] = {"least_time_s": quick.duration, "time_s": time, "motions": {}}
    for name, plan in plans.items():
        instants = plan.time_grid(_INSTANTS)
        motion = plan.sample(instants)
        F = inverse_dynamics(robot, motion).F
        power = np.sum(F * inverse_kinematics(robot, motion).L_dot, axis=-1)
        found["motions"][name] = {
            "rate_per_s": plan.profile.at(time).rate,
            "force_N": np.abs(inverse_dynamics(robot, plan.sample(time)).F).max(axis=-1),
            "peak_force_N": float(np.abs(F).max()),
            "energy_J": float(np.trapezoid(power, instants)),
        }
    return found


def claim_figure(claim: dict[str, Any]) -> Figure:
    """Left: rank correlations along each path. Right: peak force over peak condition number of each path."""
    figure = new_figure(9.0, 4.2)
    left, right = figure.subplots(1, 2)
    bins = np.linspace(-1.0, 1.0, 41)
    for name, values in claim["correlation"].items():
        left.hist(values, bins, histtype="step", color=_COLORS[name], linewidth=1.4, label=f"{name} motion")
        peaks = claim["peak_force_over_weight"][name]
        right.loglog(claim["peak_condition"], peaks, ".", color=_COLORS[name], markersize=2.5)
    left.axvline(0.0, color=DARK, linewidth=0.7)
    label = "rank correlation of condition number\nand largest force along a path"
    left.set(xlim=(-1.0, 1.0), xlabel=label, ylabel=f"paths of {claim['paths']}")
    right.set(xlabel="peak of the scaled condition number", ylabel="peak force over weight")
    for axis in (right.xaxis, right.yaxis):
        log_numbers(axis)
    legend_below(figure)
    return figure


def path_figure(found: dict[str, Any]) -> Figure:
    """Condition number and largest force along Path III, straight and planned."""
    figure = new_figure(9.0, 4.0)
    labels = {"condition": "scaled condition number of H", "force_N": "largest leg force, N"}
    for axes, (what, label) in zip(figure.subplots(1, 2), labels.items(), strict=True):
        for name, values in found[what].items():
            time = np.linspace(0.0, 6.0, len(values))
            axes.semilogy(time, values, color=_COLORS[name], linewidth=1.4, label=name)
        axes.set(xlabel="time, s", ylabel=label, xlim=(0.0, 6.0))
        log_numbers(axes.yaxis)
    legend_below(figure)
    return figure


def durations_figure(found: dict[str, Any]) -> Figure:
    """Rate of the parameter and largest force of three motions of one duration."""
    figure = new_figure(9.0, 4.0)
    left, right = figure.subplots(1, 2)
    for (name, values), color in zip(found["motions"].items(), _SHADES, strict=True):
        label = f"{name}: {values['energy_J']:.3f} J, {values['peak_force_N'] / 1e3:.1f} kN"
        left.plot(found["time_s"], values["rate_per_s"], color=color, linewidth=1.4, label=label)
        right.plot(found["time_s"], values["force_N"], color=color, linewidth=1.4)
    left.set_ylabel("rate of the path parameter, 1/s")
    right.set_ylabel("largest leg force, N")
    for axes in (left, right):
        axes.set(xlabel="time, s", xlim=(0.0, found["time_s"][-1]))
        axes.set_ylim(bottom=0.0)
    legend_below(figure)
    return figure


def tables(found: Figures) -> dict[str, str]:
    """Tables of the documentation from ``plan.json``: name -> Markdown."""
    return {
        "plan_gains": _gains_table(found["gains"]),
        "plan_claim": _claim_table(found["claim"]),
        "plan_path_III": _path_III_table(found["path_III"]),
    }


def _gains_table(found: Figures) -> str:
    names = {
        "mean": "mean condition number",
        "peak": "peak condition number",
        "peak_force": "peak force in the same time",
        "length": "length",
    }
    rows = [
        (name, *(f"{value:.3f}" for value in np.quantile(found[key], [0.0, 0.25, 0.5, 0.75, 1.0])))
        for key, name in names.items()
    ]
    text = f"Planned over straight paths through six via poses, {found['machines']} random machines:"
    return paragraph(text) + table(("ratio", "least", "quarter", "median", "three quarters", "largest"), rows)


def _claim_table(found: Figures) -> str:
    header = ("motion", "median", "quarter", "three quarters", "above 0", "above 0.5", "peaks")
    rows = []
    for name, values in found["correlation"].items():
        low, middle, high = np.quantile(values, [0.25, 0.5, 0.75])
        shares = (f"{100.0 * np.mean(np.array(values) > bound):.0f} %" for bound in (0.0, 0.5))
        peaks = found["correlation_of_peaks"][name]
        rows.append((name, *(f"{value:.2f}" for value in (middle, low, high)), *shares, f"{peaks:.2f}"))
    text = (
        "Rank correlation between the condition number of H and the largest leg force along each of "
        f"{found['paths']} straight paths of random machines. The column peaks is the rank correlation "
        "between the peak values of all paths."
    )
    return paragraph(text) + table(header, rows)


def _path_III_table(found: Figures) -> str:
    rows = []
    for name in ("straight", "planned"):
        peak = found["conditions"][name]["peak"]
        force = max(found["force_N"][name])
        rows.append(
            (
                name,
                str(found["crossings"][name]),
                "infinite" if peak is None else f"{peak:.0f}",
                f"{found['conditions'][name]['mean']:.0f}",
                "unbounded" if peak is None else f"{force:.0f}",
            )
        )
    text = (
        "The signs of det H at the ends of Path III are {:+.0f} and {:+.0f}: every path between them crosses "
        "a singular pose. If the end is turned by {:.1f} degrees about the axis of the platform, a path "
        "without a singular pose exists:"
    ).format(*found["signs_of_det_H"], np.degrees(found["yaw_rad"]))
    header = ("path", "crossings", "peak condition number", "mean", "peak force in 6 s, N")
    return paragraph(text) + table(header, rows)


def main(arguments: list[str]) -> int:
    """Write figures and pictures to a folder; returns the exit code."""
    folder = Path(arguments[0])
    folder.mkdir(parents=True, exist_ok=True)
    found = {"claim": claim(), "gains": gains(), "path_III": path_III(), "durations": durations()}
    write_file(folder / "plan.json", json_text(found))
    for name, figure in (("claim", claim_figure), ("path_III", path_figure), ("durations", durations_figure)):
        draw(Picture(functools.partial(figure, found[name]), SMALL), folder / f"plan_{name}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
