"""Trajectories read from CSV files, with rates from a smooth curve if the file has none."""

from dataclasses import replace
from typing import Any

import numpy as np

from ..io.array_types import Array
from ..io.progress import Progress, silent
from .log_samples import LENGTH_RATES, LOADS, RATES, LogSamples, warn_of
from .rotation import rotation_about_axes
from .trajectory import SmoothingOptions, Trajectory
from .trajectory_format import TIME_UNITS

AS_SHOWN = SmoothingOptions()
# Range of the largest acceleration (m/s^2) of a moving machine, and of accelerations that are possible.
_ORDINARY, _POSSIBLE = (1e-3, 100.0), (3e-5, 1e5)
# Range of the steps of loggers (s).
_STEPS = (2e-4, 1.0)
# Fraction of the speeds that are no outliers.
_ALMOST_ALL = 0.98
# Speed (m/s) below which accelerations may be too small because of the unit of time.
_SLOW = 2e-3


def trajectory_of(
    samples: LogSamples, smoothing: SmoothingOptions = AS_SHOWN, progress: Progress = silent
) -> Trajectory:
    """Compute the trajectory of samples, with missing rates.

    Coordinates are as in the file: poses of the tool, or leg lengths. Raises ValueError if the samples are
    invalid; the message has one line with file, line, problem, and remedy. Warns of an implausible unit,
    noise, rows without use, gaps, and rates that contradict positions.
    """
    # SciPy is imported only for logs.
    from .log_rates import as_given, rate_error, rates_of

    progress(f"differentiating {len(samples.lines)} rows")
    in_joints = "L" in samples.vectors
    values, steps, order = _coordinates(samples)
    _check_time_unit(samples, values)
    names = LENGTH_RATES if in_joints else RATES
    if samples.time is None:
        found, noise = np.stack([values, *np.zeros((2, *values.shape))]), None
    elif names[0] in samples.vectors:
        rates = np.concatenate([samples.vectors[name] for name in names], axis=-1)
        found = np.stack([values, *np.hsplit(rates, 2)])
        rounding = [samples.steps[name] for name in names]
        noise = as_given(samples, smoothing, [steps, *np.reshape(rounding, (2, 6))])
        error, unit = rate_error(samples.time, found)
        if unit is not None and "time_unit" not in samples.places:
            raise ValueError(f"{samples.source}: {error}; state time_unit={unit}")
        if error:
            warn_of(samples, f"{error}; forces are wrong; correct the rates, or remove their columns")
    else:
        found, noise = rates_of(samples, smoothing, values, steps)
    time = np.arange(float(len(values))) if samples.time is None else samples.time
    loads: dict[str, Any] = {name: samples.vectors[name] for name in LOADS if name in samples.vectors}
    lines = samples.lines.tolist()
    log = Trajectory(time, None, samples.source, lines, noise, found, has_lengths=in_joints, order=order)
    return replace(log, **loads)


def poses_of(samples: LogSamples) -> tuple[Array, Array]:
    """Return the poses of samples without rates: R, shape (n, 3, 3), and t (m), shape (n, 3)."""
    if "L" in samples.vectors:
        raise ValueError(f"{samples.source}: contains leg lengths; use a file of poses, t_* and theta_*")
    values, _, order = _coordinates(samples)
    return rotation_about_axes(values[:, 3:], order), values[:, :3]


def _coordinates(samples: LogSamples) -> tuple[Array, Array, str]:
    """Return lengths or poses, (n, 6), their steps of rounding, and the order of the rotations."""
    vectors = samples.vectors
    if "L" in vectors:
        return vectors["L"], samples.steps["L"], "zyx"
    theta, step, order = samples.angles()
    return np.hstack([vectors["t"], theta]), np.concatenate([samples.steps["t"], step]), order


def _check_time_unit(samples: LogSamples, values: Array) -> None:
    """Raise ValueError, or warn, if coordinates, (n, 6), have possible accelerations only in another unit."""
    time, lengths = samples.time, values[:, : 6 if "L" in samples.vectors else 3]
    # In millimeters, lengths and accelerations are a thousand times as large: their ratio depends on time.
    size = max(1.0, float(np.median(np.linalg.norm(lengths, axis=-1))))
    span = float(np.ptp(lengths, axis=0).max())
    if time is None or span <= 1e-9 * size:
        return
    speeds = np.linalg.norm(np.diff(lengths, axis=0), axis=-1) / np.diff(time)
    speed = float(np.quantile(speeds, _ALMOST_ALL))
    largest, (low, high) = speed**2 / span, _POSSIBLE
    slow = largest < low * size and speed < _SLOW * size
    if not slow and largest <= high * size:
        return
    unit = samples.file_format.time_unit or "s"
    step, present = float(np.median(np.diff(time))), TIME_UNITS[unit]
    fits = [
        name
        for name, each in TIME_UNITS.items()
        if _ORDINARY[0] * size <= largest * (present / each) ** 2 <= _ORDINARY[1] * size
        and _STEPS[0] <= step * each / present <= _STEPS[1]
    ]
    finding = f"accelerations of about {largest:.2g} m/s^2 at steps of {step:.3g} s"
    if not fits:
        if not slow:
            warn_of(samples, f"{finding}; forces are implausible; check time_unit and length_unit")
        return
    remedy = f"state time_unit={' or '.join(fits)}"
    if slow and samples.places.get("time_unit") == "the options":
        warn_of(samples, f"{finding}; only forces at rest are computed; {remedy}")
        return
    remedy += f", or time_unit={unit} if it is right" if slow else ""
    raise ValueError(f"{samples.source}: {finding}; {remedy}")
