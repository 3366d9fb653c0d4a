"""Identification from beginning to end: of measured forces, or simulated with the truth beside the estimates.

Prints nothing, writes no file.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...identification.base_parameters import BaseParameters, base_parameters
from ...identification.estimates import Estimate
from ...identification.estimation import Experiment, identify, simulated_experiment
from ...identification.excitation import choose_excitation
from ...identification.parameters import inertial_parameters
from ...io.progress import Progress, silent
from ...motion.rotation import rpy_from_rotation
from ...motion.smooth_motion import PoseNoise, estimated_noise, smoothed
from ...motion.trajectory import Trajectory
from ...robot.robot import Robot
from ..common.output import csv_text
from ..common.report import Report
from ..common.table import aligned

Array = NDArray[np.float64]

# Share of a normal distribution within one, two and three standard deviations.
NORMAL = (0.6827, 0.9545, 0.9973)
# Times that differ by less than this share of the last one are the same.
_SAME_TIME = 1e-6
# Of a parameter of the robot file from the identified one, in deviations, and of all: do not agree.
_FAR, _FAR_LEVEL = 4.0, 1e-3
_COORDINATES = (("t", "theta"), ("v", "theta_dot"), ("a", "theta_ddot"))


def identification(
    robot: Robot,
    sigma: float,
    seed: int,
    period: float | None,
    harmonics: int,
    samples: int,
    candidates: int,
    noise_position: float = 0.0,
    noise_angle: float = 0.0,
    progress: Progress = silent,
) -> Experiment:
    """Choose the motion, measure along it and identify.

    Arguments as for ``choose_excitation`` and ``simulated_experiment``; seed: of both.
    """
    excited = choose_excitation(robot, period, harmonics, samples, candidates, seed, progress)
    progress("identifying")
    return simulated_experiment(robot, excited, sigma, seed, noise_position, noise_angle)


def from_measurement(
    robot: Robot,
    trajectory: Trajectory,
    time: Array,
    F: Array,
    sigma: float,
    source: str,
    noise: PoseNoise | None = None,
    friction: bool = True,
    physical: bool = False,
) -> Estimate:
    """Identify what the motion of a trajectory excites from forces measured at the same times.

    time, F: instants, s, (n,), and forces, N, (n, 6), as read from ``source``. noise, physical: as for
    ``identify``. friction: as for ``base_parameters``. Raises ValueError naming the source for other times
    than those of the trajectory.
    """
    if len(time) != len(trajectory.time):
        raise ValueError(
            f"{source}: expected {len(trajectory.time)} rows, as many as {trajectory.source}, got {len(time)}"
        )
    off = np.abs(time - trajectory.time) > _SAME_TIME * np.max(np.abs(trajectory.time))
    if np.any(off):
        i = int(np.argmax(off))
        expected = f"the time {trajectory.time[i]:g} of {trajectory.source}"
        raise ValueError(f"{source}: instant {i + 1}: expected {expected}, got {time[i]:g}")
    motion = trajectory.motion
    base = base_parameters(robot, motion if noise is None else smoothed(motion, noise), friction)
    found = identify(robot, motion, F, sigma, base, noise, physical)
    if noise is None and found.verdict in ("misfit", "rejected"):
        found = replace(found, doubts=(*found.doubts, *_scatter(trajectory)))
    return found


def _scatter(trajectory: Trajectory) -> tuple[str, ...]:
    """What the noise of the poses seems to be."""
    try:
        seen = estimated_noise(trajectory.time, trajectory.motion)
    except (ValueError, ImportError):
        return ()
    return (
        f"motion: its poses scatter by {seen.position:.2g} m and {seen.angle:.2g} rad about a smooth motion: "
        f"--noise-position {seen.position:.2g} --noise-angle {seen.angle:.2g} takes that into account",
    )


def doubts(found: Estimate) -> list[str]:
    """One line for each doubt about an estimate: the verdict's reasons, and impossible results if any."""
    if not found.impossible:
        return list(found.doubts)
    many = len(found.impossible)
    remedy = "--physical keeps to bodies that can exist"
    return [
        *found.doubts,
        f"results that no machine can have: {many}; farthest off: {found.impossible[0]}; {remedy}",
    ]


def verdict(found: Estimate) -> list[str]:
    """Lines on the residual: its size, the verdict and the doubts."""
    text = {
        "consistent": "consistent with the model and the stated noise",
        "misfit": f"misfit; deviations inflated {found.inflation:.3g} times",
        "rejected": "rejected; no deviations can be given",
        "untested": "untested, no more forces than unknowns",
    }[found.verdict]
    return [
        f"residual: {found.misfit:.3f} of its expectation; probability of so large a one "
        f"{found.p_noise:.2g}, of so smooth a one {found.p_model:.2g}",
        f"verdict: {text}",
        *found.doubts,
        *(f"impossible: {line}" for line in found.impossible),
        *found.near_zero,
    ]


def measured_report(robot: Robot, found: Estimate, sigma: float, noise: PoseNoise | None) -> Report:
    """What measured forces tell: parameters, and bodies if the fit kept to possible ones."""
    base = found.base
    departure, p = found.departure(robot)
    file = base.matrix @ inertial_parameters(robot).values
    head = ("name", "formula", "unit", "estimated", "sigma", "robot_file", "departure")
    numbers = (x.tolist() for x in (found.values, found.sigma, file, departure))
    rows = list(zip(base.names, base.formulas, base.units, *numbers, strict=True))
    cells = [
        [name, unit, f"{value:.6g}", f"{width:.2g}", f"{given:.6g}", f"{off:+.2f}"]
        for name, _, unit, value, width, given, off in rows
    ]
    table = aligned(["parameter", "unit", "estimated", "sigma", "robot file", "off/sigma"], cells, left=2)
    far = [name for name, off in zip(base.names, departure, strict=True) if abs(off) > _FAR]
    agrees = "agrees" if p >= _FAR_LEVEL and not far else "does not agree"
    agreement = f"{agrees} with the forces, probability of such a departure {p:.2g}"
    if found.verdict == "rejected":
        agreement = "not compared, for the fit is rejected"
    named = f"; farther off than {_FAR:g} sigma: {', '.join(far)}" if far else ""
    lines = [
        _count(robot, base),
        _noise(sigma, noise),
        *verdict(found),
        f"robot file: {agreement}{named}",
    ]
    tables = {"parameters": csv_text([head, *rows])}
    if found.parameters is not None:
        bodies = found.parameters
        full = zip(bodies.names, bodies.units, bodies.values.tolist(), strict=True)
        tables["bodies"] = csv_text([("name", "unit", "value"), *full])
    data = {
        **_data(robot, found, sigma, noise),
        "robot_file": {"agreement": agrees, "probability": p, "compared": found.verdict != "rejected"},
        "parameters": [dict(zip(head, row, strict=True)) for row in rows],
    }
    return Report("\n".join([*lines, "", table, "", *_merged(base)]), tables, data)


def _data(robot: Robot, found: Estimate, sigma: float, noise: PoseNoise | None) -> dict[str, Any]:
    """What the lines above the table say, for programs."""
    return {
        "robot": robot.name,
        "base_parameters": found.base.rank,
        "of_parameters": found.base.matrix.shape[1],
        "gap": found.base.gap,
        "force_noise_N": sigma,
        "position_noise_m": 0.0 if noise is None else noise.position,
        "angle_noise_rad": 0.0 if noise is None else noise.angle,
        "verdict": found.verdict,
        "residual": found.misfit,
        "residual_probability": found.p_noise,
        "smooth_residual_probability": found.p_model,
        "inflation": found.inflation,
        "doubts": found.doubts,
        "impossible": found.impossible,
        "near_zero": found.near_zero,
        "units": {
            "residual": "of its expectation",
            "inflation": "of the standard deviations",
            "departure": "standard deviations",
            "deviation": "standard deviations",
        },
    }


def _noise(sigma: float, noise: PoseNoise | None) -> str:
    poses = "poses exact" if noise is None else f"{noise.position:g} m and {noise.angle:g} rad on each pose"
    return f"noise: {sigma:g} N on each force, {poses}"


def simulated_report(robot: Robot, found: Experiment) -> Report:
    """What a simulated measurement tells: parameters beside the true ones, the motion and its forces."""
    excited, (head, *rows) = found.excitation, _parameter_rows(found)
    tables: dict[str, str | Mapping[str, Array]] = {
        "parameters": csv_text([head, *rows]),
        "trajectory": trajectory_columns(found),
        "forces": force_columns(found),
    }
    data = {
        **_data(robot, found.estimate, found.sigma, found.noise),
        "period_s": excited.path.period,
        "harmonics": len(excited.path.sine),
        "instants": len(excited.time),
        "condition_number": excited.condition,
        "parameters": [dict(zip(head, row, strict=True)) for row in rows],
    }
    return Report(report(robot, found), tables, data)


def report(robot: Robot, found: Experiment) -> str:
    """What was done and the table: true, estimated, sigma, deviation in sigmas."""
    excited, estimate = found.excitation, found.estimate
    base = estimate.base
    size = np.abs(found.deviation)
    shares = ", ".join(
        f"{100 * np.mean(size <= width):.0f} % ({100 * normal:.1f} %) within {width}"
        for width, normal in zip((1, 2, 3), NORMAL, strict=True)
    )
    harmonics = len(excited.path.sine)
    lines = [
        _count(robot, base),
        f"motion: {harmonics} harmonics, period {excited.path.period:.4g} s, {len(excited.time)} instants; "
        f"condition number {excited.condition:.4g}",
        _noise(found.sigma, found.noise),
        *verdict(estimate),
        f"errors in standard deviations (of a normal distribution): {shares}; largest {np.max(size):.2f}",
    ]
    rows = [
        [name, unit, *(f"{value:.6g}" for value in numbers[:2]), f"{numbers[2]:.2g}", f"{numbers[3]:+.2f}"]
        for name, unit, *numbers in _rows(found)
    ]
    head = ["parameter", "unit", "true", "estimated", "sigma", "error/sigma"]
    return "\n".join([*lines, "", aligned(head, rows, left=2), "", *_merged(base)])


def _count(robot: Robot, base: BaseParameters) -> str:
    return f"{robot.name}: {base.rank} base parameters of {base.matrix.shape[1]}, gap {base.gap:.2g}"


def _merged(base: BaseParameters) -> list[str]:
    found = [text for name, text in zip(base.names, base.formulas, strict=True) if text != name]
    return ["Parameters stand for these combinations:", *found]


def _parameter_rows(found: Experiment) -> list[tuple[Any, ...]]:
    """A header and name, formula, unit, true, estimated, sigma, deviation of each base parameter."""
    head = ("name", "formula", "unit", "true", "estimated", "sigma", "deviation")
    rows = zip(_rows(found), found.estimate.base.formulas, strict=True)
    return [head, *((row[0], formula, *row[1:]) for row, formula in rows)]


def trajectory_columns(found: Experiment) -> dict[str, Array]:
    """The motion as the command ``forces`` reads it; poses alone where they are measured with noise."""
    columns = {"time": found.excitation.time}
    coordinates: tuple[Array, ...] = found.excitation.path.coordinates(columns["time"])
    if found.noise is not None:
        coordinates = (np.hstack([found.measured.t, rpy_from_rotation(found.measured.R)]),)
    for names, x in zip(_COORDINATES, coordinates, strict=False):
        for j, name in enumerate(f"{name}_{axis}" for name in names for axis in "xyz"):
            columns[name] = x[:, j]
    return columns


def force_columns(found: Experiment) -> dict[str, Array]:
    """Time and the noisy forces."""
    return {"time": found.excitation.time} | {f"F{leg + 1}": found.F[:, leg] for leg in range(6)}


def _rows(found: Experiment) -> Iterator[tuple[str, str, float, float, float, float]]:
    estimate = found.estimate
    numbers = zip(
        found.truth.tolist(),
        estimate.values.tolist(),
        estimate.sigma.tolist(),
        found.deviation.tolist(),
        strict=True,
    )
    for name, unit, four in zip(estimate.base.names, estimate.base.units, numbers, strict=True):
        yield (name, unit, *four)
