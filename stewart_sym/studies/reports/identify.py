"""Identification from measured forces, or from simulated forces with known true parameters."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from math import inf, isnan, nan
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
from ..common.text_tables import Columns, aligned, of_legs, records

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
    """Identify the parameters that a trajectory excites from forces F (N), (n, 6), of the file ``source``.

    Unused rows of the trajectory are left out. ``lines`` are the line numbers of the forces, from 2 by
    default. ``units`` are the units that the forces may have, the assumed one first, with their factors.
    Raises ValueError if another unit fits the robot.
    """
    poses, forces = _pairs(trajectory, time, source, lines)
    warnings = []
    for name, each, used in ((trajectory.source, trajectory.time, poses), (source, time, forces)):
        if len(alone := np.delete(each, used)):
            count = f"{len(alone)} sample{'s' * (len(alone) > 1)}, the first at {time_text(alone[0])} s"
            warnings.append(f"{name}: {count}, left out of the fit: no sample of the other file at the time")
    bad = at_replaced(trajectory, trajectory.time[poses])
    if bad.any():
        text = f"{np.count_nonzero(bad)} of {len(bad)} samples at wrong rows are left out of the fit"
        warnings.append(f"motion: {text}; check these rows")
    poses, forces = poses[~bad], forces[~bad]
    motion, noise = trajectory.motion[poses], None if noise is None else noise.at(poses)
    smooth = motion if noise is None else smoothed(motion, noise)[0]
    unlike = _unlike_forces(robot, smooth, F[forces], source, units)
    base = base_parameters(robot, smooth, friction, identical_legs)
    found = identify(robot, motion, F[forces], sigma, base, noise, physical, drive_terms=drive)
    if found.verdict in ("misfit", "rejected"):
        sample, leg, size = found.largest_residual
        row = forces[sample]
        place = f"leg {leg + 1} at {time_text(time[row])} s, line {row + 2 if lines is None else lines[row]}"
        warnings.append(f"{source}: largest residual: {place}: {size:.3g} standard deviations; check it")
        of_file = 0.0 if robot.drive is None else terms_of(robot, [f"coulomb{i}" for i in range(1, 7)]).max()
        if of_file > 0.0 and "coulomb" not in (drive or ()):
            text = (
                f"drives: dry friction of up to {of_file:.4g} N in the robot file: forces of motors have it"
            )
            warnings.append(f"{text}, --drive-terms coulomb seeks it")
    if np.all(np.abs(found.values) < _TOLD * found.std) and np.isfinite(found.std).all():
        text = f"parameters: none is determined, all are within {_TOLD} standard deviations of zero"
        warnings.append(f"{text}; use a faster motion, more samples, or more accurate forces")
    return replace(found, warnings=(*found.warnings, *warnings, *unlike))


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


def _unlike_forces(
    robot: Robot, motion: Motion, F: Array, source: str, units: Mapping[str, float]
) -> list[str]:
    """Return a warning about forces of another magnitude or sign; reject forces that fit in another unit."""
    model = inverse_dynamics(robot, motion).F
    got, expected = (np.sqrt(np.mean(each**2)) for each in (F, model))
    finding = f"forces: RMS of {got:.3g} N, but {expected:.3g} N by the robot file along this motion"
    for unit, factor in units.items():
        if factor != 1.0 and expected / _MOST_OFF < factor * got < expected * _MOST_OFF:
            remedy = f"state the unit in the header: [{unit}], or [{next(iter(units))}] if it is right"
            raise ValueError(f"{source}: {finding}; {remedy}")
    if np.mean(F * model) < -_OPPOSITE * got * expected:
        return ["forces: opposite to the forces by the robot file; change their sign: positive extends a leg"]
    if expected / _MOST_TIMES < got < expected * _MOST_TIMES:
        return []
    return [f"{finding}; check that their unit is N"]


def doubts(found: IdentificationResult) -> list[str]:
    """Return one line for each warning of the result, and one line about nonphysical results, if any."""
    lines = list(found.warnings)
    if found.nonphysical:
        text = f"results that no machine can have: {len(found.nonphysical)}; farthest off: "
        remedy = "--enforce-physical keeps to bodies that can exist"
        lines.append(f"{text}{found.nonphysical[0]}; {remedy}")
    return lines


def _head(
    robot: Robot, found: IdentificationResult, sigma: ArrayLike, noise: PoseNoise | None, *motion: str
) -> list[str]:
    """Return lines about the parameters, the motion, the noise, and the residual with its verdict."""
    base, sizes = found.base, np.unique([np.min(sigma), np.max(sigma)])
    poses = "poses exact" if noise is None else f"{noise.position:g} m and {noise.angle:g} rad on each pose"
    text = {
        "consistent": "consistent with the model and the stated noise",
        "misfit": f"misfit; standard deviations inflated {found.inflation_factor:.3g} times",
        "rejected": "rejected; the standard deviations are unknown",
        "untested": "untested, no more forces than unknowns",
    }[found.verdict]
    return [
        f"{robot.name}: {base.rank} base parameters of {base.matrix.shape[1]}, gap {base.rank_gap:.2g}"
        + ("; all legs have the same" if base.identical_legs else ""),
        *motion,
        f"noise: {' to '.join(f'{size:.4g}' for size in sizes)} N on each force, {poses}",
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
    lines = [*_head(robot, found, sigma, noise), f"robot file: {agreement}{named}"]
    data = {**_data(robot, found, sigma, noise), "robot_file": {"agreement": agrees, "probability": p}}
    if seen is not robot:
        lines.append("C_p of the robot file: with the viscous friction of its drives")
    if drive is not None:
        of_file = terms_of(robot, drive.names)
        numbers = {"estimated": drive.values, "std": drive.std, "robot_file": of_file}
        terms = {"name": drive.names, "unit": drive.units, **numbers, "identifiable": drive.identifiable}
        data["drive"] = records(terms)
        lines += _drive_lines(data["drive"], drive)
    tables: dict[str, Columns] = {}
    if (bodies := found.parameters) is not None:
        parts = {"name": bodies.names, "unit": bodies.units, "value": bodies.values}
        tables["bodies"] = {name: np.array(values) for name, values in parts.items()}
    file = base.matrix @ inertial_parameters(seen).values
    numbers = {"estimated": found.values, "std": found.std, "robot_file": file, "departure": departure}
    return _report(lines, base, numbers, tables, data)


def _drive_lines(terms: list[dict[str, Any]], found: DriveIdentificationResult) -> list[str]:
    """Format a table of the drive terms, and list the terms that are not identifiable."""
    rows = [row for row in terms if row["identifiable"]]
    unsure = [row["name"] for row in rows if abs(row["estimated"]) < _TOLD * row["std"] < inf]
    text = f"not distinguishable from zero within {_TOLD} sigma: {', '.join(unsure)}"
    table = _table("drives", rows, ("estimated", "std", "robot_file"))
    return ["", table, *([text] if unsure else []), *found.unidentifiable]


def _report(
    lines: list[str],
    base: BaseParametersResult,
    numbers: Mapping[str, Array],
    tables: Mapping[str, Columns],
    data: Mapping[str, Any],
) -> Report:
    """Create a report of text lines and a table of the base parameters with columns (n,) by name."""
    texts = {"name": base.names, "formula": base.formulas, "unit": base.units}
    columns = {name: np.array(values) for name, values in texts.items()} | dict(numbers)
    rows = records(columns)
    merged = [row["formula"] for row in rows if row["formula"] != row["name"]]
    table = _table("parameter", rows, numbers)
    return Report(
        "\n".join([*lines, "", table, "", "Parameters stand for these combinations:", *merged]),
        {"parameters": columns, **tables},
        {**data, "parameters": rows},
    )


def _table(title: str, rows: Sequence[Mapping[str, Any]], names: Iterable[str]) -> str:
    """Format name, unit, and the named numbers of rows; NaN is a dash."""
    shown = {name: _SHOWN.get(name, (name, ".6g")) for name in names}
    cells = []
    for row in rows:
        texts = (f"{row[name]:{form}}" for name, (_, form) in shown.items())
        cells.append([row["name"], row["unit"], *("-" if "nan" in text else text for text in texts)])
    return aligned([title, "unit", *(heading for heading, _ in shown.values())], cells, left=2)


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


def simulated_report(robot: Robot, found: Experiment) -> Report:
    """Create the report of a simulated measurement: parameters with true values, motion, and forces."""
    excited, estimate = found.excitation, found.estimate
    noise, size = (found.force_std, found.pose_noise), np.abs(found.z_scores)
    harmonics, period, samples = len(excited.path.sine), excited.path.period, len(excited.time)
    text = f"motion: {harmonics} harmonics, period {period:.4g} s, {samples} samples; "
    lines = _head(robot, estimate, *noise, f"{text}condition number {excited.condition:.4g}")
    if estimate.verdict != "rejected":
        fractions = ", ".join(
            f"{100 * np.mean(size <= width):.0f} % ({100 * normal:.1f} %) within {width}"
            for width, normal in enumerate(NORMAL, 1)
        )
        text = "errors in standard deviations (of a normal distribution)"
        lines.append(f"{text}: {fractions}; largest {np.max(size):.2f}")
    numbers = {"true": found.true_values, "estimated": estimate.values, "std": estimate.std}
    tables = {
        "trajectory": trajectory_columns(robot, excited.time, found.measured_motion),
        "forces": {"time": excited.time} | of_legs("F", found.F),
    }
    data = _data(robot, estimate, *noise) | {"period_s": period, "harmonics": harmonics}
    data |= {"samples": samples, "condition_number": excited.condition}
    return _report(lines, estimate.base, numbers | {"z_score": found.z_scores}, tables, data)
