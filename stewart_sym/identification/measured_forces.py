"""Identification from logs: samples at equal times, unit and sign of the forces."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from ..drives.noise import at_replaced
from ..dynamics.inverse_dynamics import inverse_dynamics
from ..io.array_types import Array, Indices
from ..motion.bad_rows import LIMIT
from ..motion.csv_table import Lines
from ..motion.log_samples import line_ranges
from ..motion.motion import Motion
from ..motion.sample_times import time_text
from ..motion.trajectory import Trajectory
from ..robot.robot import Robot
from .base_parameters import base_parameters
from .drive_terms import terms_of
from .estimates import IdentificationResult
from .estimation import identify
from .measured_files import Measurement
from .motion_basis import smoothed

# Largest difference of equal times, relative to the total time, in addition to their rounding.
_SAME_TIME = 1e-6
# Smallest fraction of samples at equal times in files with different numbers of rows.
_PAIRED = 0.9
# Largest ratio of the measured forces to the forces of the robot file, or its inverse, in equal units.
_MOST_TIMES = 100.0
# Largest ratio of the RMS of forces in another unit to the RMS by the robot file, or its inverse.
_MOST_OFF = 3.0
# Correlation with the negative forces of the robot file from which the measured forces have the other sign.
_OPPOSITE = 0.5
# Fraction of the samples that determines the magnitude of the forces.
_USUAL = 0.99
# Number of standard deviations below which the distance of a parameter from zero is insignificant.
_TOLD = 2


def from_measurement(
    robot: Robot,
    measured: Measurement,
    friction: bool = True,
    physical: bool = False,
    identical_legs: bool = False,
    drive: Sequence[str] | None = None,
) -> IdentificationResult:
    """Identify the parameters that a measured trajectory excites from measured forces.

    Unused rows of the trajectory are left out. Raises ValueError if the forces fit the robot only in another
    unit.
    """
    trajectory, time, F, sigma, source, lines, noise, units, _ = measured
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
    if (excluded := forces[found.excluded_samples]).size:
        finding = f"outliers ({line_ranges(lines[excluded])}): more than {LIMIT:g} robust standard "
        text = f"{finding}deviations from the model; they are left out of the fit; check these lines"
        warnings.append(f"{source}: {text}")
    if found.verdict in ("misfit", "rejected"):
        sample, leg, size = found.largest_residual
        row = forces[sample]
        place = f"leg {leg + 1} at {time_text(time[row])} s, line {lines[row]}"
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


def _pairs(trajectory: Trajectory, time: Array, source: str, lines: Lines) -> tuple[Indices, Indices]:
    """Return the indices of poses and of forces at equal times; reject forces at other times."""
    largest, span = float(np.abs(trajectory.time).max()), float(np.ptp(trajectory.time))
    tolerance = _SAME_TIME * span + 2.0 * np.spacing(largest)
    count = len(trajectory.time)
    nearest = np.minimum(np.searchsorted(trajectory.time, time - tolerance), count - 1)
    same = np.abs(time - trajectory.time[nearest]) <= tolerance
    if same.all() if len(time) == count else same.sum() >= _PAIRED * max(len(time), count):
        return nearest[same], np.flatnonzero(same)
    if len(time) != count:
        pairs = f"{same.sum()} of {len(time)} samples and {same.sum()} of {count} in {trajectory.source}"
        remedy = "log both files at the same times, or check the units of time"
        raise ValueError(f"{source}: {pairs} have equal times, expected {100.0 * _PAIRED:g} %; {remedy}")
    i = int(np.argmin(same))
    expected = f"the time {time_text(trajectory.time[i])} of {trajectory.source}"
    remedy = "check the units of both files, a row below the header or --time-unit"
    place = f"{source}: line {lines[i]}: time"
    raise ValueError(f"{place}: expected {expected}, got {time_text(time[i])}; {remedy}")


def _unlike_forces(
    robot: Robot, motion: Motion, F: Array, source: str, units: Mapping[str, float]
) -> list[str]:
    """Return a warning about forces of another magnitude or sign; reject forces that fit in another unit."""
    largest = np.abs(F).max(axis=-1)
    # Outliers do not count.
    usual = largest <= np.quantile(largest, _USUAL)
    F, model = F[usual], inverse_dynamics(robot, motion[usual]).F
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
