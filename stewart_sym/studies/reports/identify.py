"""Identification from measured forces, or from simulated forces with known true parameters."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import isnan, nan
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...drives.noise import at_replaced
from ...dynamics.inverse_dynamics import inverse_dynamics
from ...identification.base_parameters import BaseParametersResult, base_parameters
from ...identification.drive_terms import DriveIdentificationResult, seen_by_motors, terms_of
from ...identification.estimates import IdentificationResult
from ...identification.estimation import Experiment, identify
from ...identification.motion_basis import PoseNoise, smoothed
from ...identification.parameters import inertial_parameters
from ...io.array_types import Array, Indices
from ...kinematics.trajectory_writer import trajectory_columns
from ...motion.motion import Motion
from ...motion.sample_times import time_text
from ...motion.trajectory import Trajectory
from ...robot.robot import Robot
from ..common.report import Report
from ..common.text_tables import Columns, aligned, columns_of, of_legs

# Fraction of a normal distribution within one, two, and three standard deviations.
NORMAL = (0.6827, 0.9545, 0.9973)
# Largest difference of equal times, relative to the total time, in addition to their rounding.
_SAME_TIME = 1e-6
# The robot file disagrees if a parameter differs by this many standard deviations from the identified one, or
# if the joint probability of all differences is below this level.
_FAR, _FAR_LEVEL = 4.0, 1e-3
# Number of standard deviations from zero below which a drive term is insignificant.
_TOLD = 2
# Title and number format of columns of the text table.
_SHOWN = {
    "std": ("std", ".2g"),
    "robot_file": ("robot file", ".6g"),
    "departure": ("off/std", "+.2f"),
    "z_score": ("error/std", "+.2f"),
}
# Smallest fraction of samples at equal times in files with different numbers of rows.
_PAIRED = 0.9
# Largest ratio of the measured forces to the forces of the robot file, or its inverse, in equal units.
_MOST_TIMES = 100.0
# Largest ratio of the RMS of forces in another unit to the RMS by the robot file, or its inverse.
_MOST_OFF = 3.0
# Correlation with the negative forces of the robot file from which the measured forces have the other sign.
_OPPOSITE = 0.5


def from_measurement(
    robot: Robot,
    trajectory: Trajectory,
    time: Array,
    F: Array,
    sigma: ArrayLike,
    source: str,
    noise: PoseNoise | None = None,
    friction: bool = True,
    physical: bool = False,
    identical_legs: bool = False,
    drive: Sequence[str] | None = None,
    lines: Sequence[int] | None = None,
    units: Mapping[str, float] = MappingProxyType({}),
) -> IdentificationResult:
    """Identify the parameters that a trajectory excites from forces F (N), (n, 6), at times (s), (n,).

    Samples at rows that the reader of the trajectory did not use are left out. ``source`` and ``lines`` are
    the file of the forces and their line numbers, from 2 by default. ``units`` are the units that the forces
    may have, the assumed one first, with their factors. Raises ValueError if another unit fits the robot.
    """
    poses, forces = _pairs(trajectory, time, source, lines)
    warnings = []
    if unpaired := len(trajectory.time) + len(time) - 2 * len(poses):
        text = f"{unpaired} samples of one file have no sample of the other at their time"
        warnings.append(f"{text}; they are left out of the fit")
    bad = at_replaced(trajectory, trajectory.time[poses])
    if bad.any():
        text = f"{np.count_nonzero(bad)} of {len(bad)} samples at wrong rows are left out of the fit"
        warnings.append(f"motion: {text}; check these rows")
    motion, F = trajectory.motion[poses[~bad]], F[forces[~bad]]
    noise = None if noise is None else noise.at(poses[~bad])
    smooth = motion if noise is None else smoothed(motion, noise)[0]
    _need_unit(robot, smooth, F, source, units)
    base = base_parameters(robot, smooth, friction, identical_legs)
    found = identify(robot, motion, F, sigma, base, noise, physical, drive_terms=drive)
    of_file = 0.0 if robot.drive is None else terms_of(robot, [f"coulomb{leg}" for leg in range(1, 7)]).max()
    if found.verdict in ("misfit", "rejected") and of_file > 0.0 and "coulomb" not in (drive or ()):
        text = f"drives: dry friction of up to {of_file:.4g} N in the robot file: forces of motors have it"
        warnings.append(f"{text}, --drive-terms coulomb seeks it")
    return replace(found, warnings=(*found.warnings, *warnings, *_unlike_forces(robot, found, F)))


def _pairs(
    trajectory: Trajectory, time: Array, source: str, lines: Sequence[int] | None
) -> tuple[Indices, Indices]:
    """Return the indices of poses and of forces at equal times; reject forces at other times."""
    largest, span = float(np.abs(trajectory.time).max()), float(np.ptp(trajectory.time))
    tolerance = _SAME_TIME * span + 2.0 * np.spacing(largest)
    count = len(trajectory.time)
    nearest = np.minimum(np.searchsorted(trajectory.time, time - tolerance), count - 1)
    same = np.abs(time - trajectory.time[nearest]) <= tolerance
    if same.all() if len(time) == count else same.sum() >= _PAIRED * max(len(time), count):
        return nearest[same], np.flatnonzero(same)
    if len(time) != count:
        raise ValueError(f"{source}: expected {count} rows, as many as {trajectory.source}, got {len(time)}")
    i = int(np.argmin(same))
    expected = f"the time {time_text(trajectory.time[i])} of {trajectory.source}"
    line = i + 2 if lines is None else lines[i]
    remedy = "check the units of both files, a row below the header or --time-unit"
    raise ValueError(f"{source}: line {line}: time: expected {expected}, got {time_text(time[i])}; {remedy}")


def _need_unit(robot: Robot, motion: Motion, F: Array, source: str, units: Mapping[str, float]) -> None:
    """Raise ValueError if forces fit the robot file in another unit only."""
    got, expected = (np.sqrt(np.mean(each**2)) for each in (F, inverse_dynamics(robot, motion).F))
    for unit, factor in units.items():
        if factor != 1.0 and expected / _MOST_OFF < factor * got < expected * _MOST_OFF:
            finding = f"RMS of {got:.3g} N, but {expected:.3g} N by the robot file along this motion"
            remedy = f"state the unit in the header: [{unit}], or [{next(iter(units))}] if it is right"
            raise ValueError(f"{source}: forces: {finding}; {remedy}")


def _unlike_forces(robot: Robot, found: IdentificationResult, F: Array) -> list[str]:
    """Return a warning about forces of another magnitude or sign."""
    model = inverse_dynamics(robot, found.motion).F
    got, expected = (np.sqrt(np.mean(each**2)) for each in (F, model))
    if np.mean(F * model) < -_OPPOSITE * got * expected:
        return ["forces: opposite to the forces by the robot file; change their sign: positive extends a leg"]
    if expected / _MOST_TIMES < got < expected * _MOST_TIMES:
        return []
    finding = f"RMS of {got:.3g} N, but {expected:.3g} N by the robot file along this motion"
    return [f"forces: {finding}; check that their unit is N"]


def doubts(found: IdentificationResult) -> list[str]:
    """Return one line for each warning of the result, and one line about nonphysical results, if any."""
    lines = list(found.warnings)
    if found.nonphysical:
        text = f"results that no machine can have: {len(found.nonphysical)}; farthest off: "
        remedy = "--enforce-physical keeps to bodies that can exist"
        lines.append(f"{text}{found.nonphysical[0]}; {remedy}")
    return lines


def verdict(found: IdentificationResult) -> list[str]:
    """Return lines about the residual: its size, the verdict, and the warnings."""
    text = {
        "consistent": "consistent with the model and the stated noise",
        "misfit": f"misfit; standard deviations inflated {found.inflation_factor:.3g} times",
        "rejected": "rejected; the standard deviations are unknown",
        "untested": "untested, no more forces than unknowns",
    }[found.verdict]
    return [
        f"residual: {found.normalized_residual:.3f} of its expectation; probability of so large a one "
        f"{found.p_noise:.2g}, of so smooth a one {found.p_model:.2g}",
        f"verdict: {text}",
        *found.warnings,
        *(f"impossible: {line}" for line in found.nonphysical),
        *found.near_zero,
    ]


def measured_report(
    robot: Robot,
    found: IdentificationResult,
    sigma: ArrayLike,
    noise: PoseNoise | None,
    currents: bool = False,
) -> Report:
    """Create the report of measured forces, which are motor forces with ``currents`` or drive terms."""
    base, drive = found.base, found.drive
    seen = seen_by_motors(robot) if currents or drive is not None else robot
    departure, p = found.compare_with(seen)
    far = [name for name, each in zip(base.names, departure, strict=True) if abs(each) > _FAR]
    if drive is not None:
        # Viscous terms may include friction of the joints.
        of_joints = np.array([name.startswith("viscous") for name in drive.names])
        off, p_terms = drive.compare_with(np.where(of_joints, np.nan, terms_of(robot, drive.names)))
        far += [name for name, each in zip(drive.names, off, strict=True) if abs(each) > _FAR]
        # The smaller of two probabilities is doubled (Bonferroni).
        p = p if isnan(p_terms) else min(1.0, 2.0 * min(p, p_terms))
    agrees = "agrees" if p >= _FAR_LEVEL and not far else "does not agree"
    agreement = f"{agrees} with the forces, probability of such a departure {p:.2g}"
    if found.verdict == "rejected":
        agrees, p, departure, far = "not compared", nan, np.full_like(departure, np.nan), []
        agreement = f"{agrees}, for the fit is rejected"
    named = f"; farther off than {_FAR:g} sigma: {', '.join(far)}" if far else ""
    lines = [_count(robot, base), _noise(sigma, noise), *verdict(found), f"robot file: {agreement}{named}"]
    data = {**_data(robot, found, sigma, noise), "robot_file": {"agreement": agrees, "probability": p}}
    if seen is not robot:
        lines.append("C_p of the robot file: with the viscous friction of its drives")
    if drive is not None:
        data["drive"] = _drive_rows(robot, drive)
        lines += drive_lines(robot, drive)
    tables: dict[str, Columns] = {}
    if (bodies := found.parameters) is not None:
        rows = zip(bodies.names, bodies.units, bodies.values.tolist(), strict=True)
        tables["bodies"] = columns_of([("name", "unit", "value"), *rows])
    file = base.matrix @ inertial_parameters(seen).values
    numbers = {"estimated": found.values, "std": found.std, "robot_file": file, "departure": departure}
    return _report(lines, base, numbers, tables, data)


def drive_lines(robot: Robot, found: DriveIdentificationResult) -> list[str]:
    """Format a table of the drive terms, and list the terms that are not identifiable."""
    rows = [
        [name, unit, *map(_text, numbers, (".6g", ".2g", ".6g"))]
        for name, unit, *numbers, identifiable in map(dict.values, _drive_rows(robot, found))
        if identifiable
    ]
    unsure = found.identifiable & (np.abs(found.values) < _TOLD * found.std) & np.isfinite(found.std)
    names = ", ".join(name for name, each in zip(found.names, unsure, strict=True) if each)
    said = [f"within {_TOLD} sigma of zero, so that the motion does not tell them: {names}"] if names else []
    table = aligned(("drives", "unit", "estimated", "std", "robot file"), rows, left=2)
    return ["", table, *said, *found.unidentifiable]


def _drive_rows(robot: Robot, found: DriveIdentificationResult) -> list[dict[str, Any]]:
    """Return the drive terms for the JSON data."""
    of_file = terms_of(robot, found.names)
    columns = (each.tolist() for each in (found.values, found.std, of_file, found.identifiable))
    head = ("name", "unit", "estimated", "std", "robot_file", "identifiable")
    return [dict(zip(head, row, strict=True)) for row in zip(found.names, found.units, *columns, strict=True)]


def _report(
    lines: list[str],
    base: BaseParametersResult,
    numbers: Mapping[str, Array],
    tables: Mapping[str, Columns],
    data: Mapping[str, Any],
) -> Report:
    """Create a report of text lines and a table of the base parameters with columns (n,) by name."""
    columns = (values.tolist() for values in numbers.values())
    head = ("name", "formula", "unit", *numbers)
    rows = list(zip(base.names, base.formulas, base.units, *columns, strict=True))
    shown = [_SHOWN.get(name, (name, ".6g")) for name in numbers]
    forms = [form for _, form in shown]
    cells = [[name, unit, *map(_text, values, forms)] for name, _, unit, *values in rows]
    table = aligned(["parameter", "unit", *(title for title, _ in shown)], cells, left=2)
    merged = [text for name, text in zip(base.names, base.formulas, strict=True) if text != name]
    return Report(
        "\n".join([*lines, "", table, "", "Parameters stand for these combinations:", *merged]),
        {"parameters": columns_of([head, *rows]), **tables},
        {**data, "parameters": [dict(zip(head, row, strict=True)) for row in rows]},
    )


def _text(value: float, form: str) -> str:
    return "-" if isnan(value) else f"{value:{form}}"


def _data(
    robot: Robot, found: IdentificationResult, sigma: ArrayLike, noise: PoseNoise | None
) -> dict[str, Any]:
    """Return the numbers of the text above the table for the JSON data."""
    attributes = ("normalized_residual", "inflation_factor", "warnings", "nonphysical", "near_zero")
    lag = found.force_lag
    return {
        "robot": robot.name,
        "base_parameters": found.base.rank,
        "of_parameters": found.base.matrix.shape[1],
        "rank_gap": found.base.rank_gap,
        "identical_legs": found.base.identical_legs,
        "force_noise_N": np.asarray(sigma).tolist(),
        "position_noise_m": 0.0 if noise is None else noise.position,
        "angle_noise_rad": 0.0 if noise is None else noise.angle,
        "verdict": found.verdict,
        **{name: getattr(found, name) for name in attributes},
        "residual_probability": found.p_noise,
        "smooth_residual_probability": found.p_model,
        **({} if lag is None else {"force_lag_s": lag[0], "force_lag_std_s": lag[1]}),
        "units": {
            "normalized_residual": "of its expectation",
            "inflation_factor": "of the standard deviations",
            "departure": "standard deviations",
            "z_score": "standard deviations",
        },
    }


def _noise(sigma: ArrayLike, noise: PoseNoise | None) -> str:
    poses = "poses exact" if noise is None else f"{noise.position:g} m and {noise.angle:g} rad on each pose"
    each = " to ".join(f"{value:.4g}" for value in np.unique([np.min(sigma), np.max(sigma)]))
    return f"noise: {each} N on each force, {poses}"


def simulated_report(robot: Robot, found: Experiment) -> Report:
    """Create the report of a simulated measurement: parameters with true values, motion, and forces."""
    excited, estimate = found.excitation, found.estimate
    size = np.abs(found.z_scores)
    shares = ", ".join(
        f"{100 * np.mean(size <= width):.0f} % ({100 * normal:.1f} %) within {width}"
        for width, normal in zip((1, 2, 3), NORMAL, strict=True)
    )
    harmonics, period = len(excited.path.sine), excited.path.period
    lines = [
        _count(robot, estimate.base),
        f"motion: {harmonics} harmonics, period {period:.4g} s, {len(excited.time)} samples; "
        f"condition number {excited.condition:.4g}",
        _noise(found.force_std, found.pose_noise),
        *verdict(estimate),
    ]
    if estimate.verdict != "rejected":
        text = "errors in standard deviations (of a normal distribution)"
        lines.append(f"{text}: {shares}; largest {np.max(size):.2f}")
    numbers = {"true": found.true_values, "estimated": estimate.values, "std": estimate.std}
    tables = {
        "trajectory": trajectory_columns(robot, excited.time, found.measured_motion),
        "forces": {"time": excited.time} | of_legs("F", found.F),
    }
    data = _data(robot, estimate, found.force_std, found.pose_noise) | {
        "period_s": period,
        "harmonics": harmonics,
        "samples": len(excited.time),
        "condition_number": excited.condition,
    }
    return _report(lines, estimate.base, numbers | {"z_score": found.z_scores}, tables, data)


def _count(robot: Robot, base: BaseParametersResult) -> str:
    text = f"{robot.name}: {base.rank} base parameters of {base.matrix.shape[1]}, gap {base.rank_gap:.2g}"
    return text if not base.identical_legs else f"{text}; all legs have the same"
