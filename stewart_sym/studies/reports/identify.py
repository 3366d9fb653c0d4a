"""Identification from measured forces, or from simulated forces with known true parameters."""

from collections.abc import Iterable, Mapping, Sequence
from math import inf, isnan, nan
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...identification.base_parameters import BaseParametersResult
from ...identification.drive_terms import DriveIdentificationResult, seen_by_motors, terms_of
from ...identification.estimates import IdentificationResult
from ...identification.estimation import Experiment
from ...identification.motion_basis import PoseNoise
from ...identification.parameters import inertial_parameters
from ...io.array_types import Array
from ...kinematics.trajectory_writer import trajectory_columns
from ...robot.robot import Robot
from ..common.report import Report
from ..common.text_tables import Columns, aligned, of_legs, records

# Fraction of a normal distribution within one, two, and three standard deviations.
NORMAL = (0.6827, 0.9545, 0.9973)
# The robot file disagrees if a parameter differs by this many standard deviations from the identified one, or
# if the joint probability of all differences is below this level.
_FAR, _FAR_LEVEL = 4.0, 1e-3
# Number of standard deviations from zero below which a drive term is insignificant.
_TOLD = 2
# Number of standard deviations from zero beyond which a parameter counts as determined.
_SURE = 3
# Title and number format of columns of the text table.
_SHOWN = {
    "std": ("std", ".2g"),
    "robot_file": ("robot file", ".6g"),
    "departure": ("off/std", "+.2f"),
    "z_score": ("error/std", "+.2f"),
}


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
    """Return lines about the verdict, the parameters, the motion, the noise, and the residual."""
    base, sizes = found.base, np.unique([np.min(sigma), np.max(sigma)])
    poses = "poses exact" if noise is None else f"{noise.position:g} m and {noise.angle:g} rad on each pose"
    text = {
        "consistent": "consistent with the model and the stated noise",
        "misfit": f"misfit; standard deviations inflated {found.inflation_factor:.3g} times",
        "rejected": "rejected; the standard deviations are unknown",
        "untested": "untested, no more forces than unknowns",
    }[found.verdict]
    return [
        f"verdict: {text}; {_determined(found)}",
        f"{robot.name}: {base.rank} base parameters of {base.matrix.shape[1]}, gap {base.rank_gap:.2g}"
        + ("; all legs have the same" if base.identical_legs else ""),
        *motion,
        f"samples: {found.motion.shape[0]}, of which {len(found.excluded_samples)} are excluded as outliers",
        f"noise: {' to '.join(f'{size:.4g}' for size in sizes)} N on each force, {poses}",
        f"residual: {found.normalized_residual:.3f} of its expectation; probability of so large a one "
        f"{found.p_noise:.2g}, of so smooth a one {found.p_model:.2g}",
        *found.warnings,
        *(f"impossible: {line}" for line in found.nonphysical),
        *found.near_zero,
    ]


def _determined(found: IdentificationResult) -> str:
    """State the number of parameters that differ from zero, and the remedy if many do not."""
    count, rank = _count_determined(found), found.base.rank
    text = f"{count} of {rank} parameters are determined, farther than {_SURE} standard deviations from zero"
    remedy = "; if all legs are alike, --identical-legs determines more"
    return text if found.base.identical_legs or 2 * count > rank else text + remedy


def _count_determined(found: IdentificationResult) -> int:
    """Count the parameters that differ from zero by more than their uncertainty."""
    return int(np.sum(np.abs(found.values) > _SURE * found.std))


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
        "determined_parameters": _count_determined(found),
        "rank_gap": found.base.rank_gap,
        "identical_legs": found.base.identical_legs,
        "force_noise_N": np.asarray(sigma).tolist(),
        "position_noise_m": 0.0 if noise is None else noise.position,
        "angle_noise_rad": 0.0 if noise is None else noise.angle,
        "samples": found.motion.shape[0],
        "excluded_samples": len(found.excluded_samples),
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
    data |= {"condition_number": excited.condition}
    return _report(lines, estimate.base, numbers | {"z_score": found.z_scores}, tables, data)
