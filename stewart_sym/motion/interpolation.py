"""Polynomials of degree 5 between the samples of a trajectory, with their poses, rates, and accelerations."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.polynomial import polynomial
from numpy.typing import ArrayLike

from ..io.arguments import instance, real_array
from ..io.array_types import Array, Indices
from ..io.toml_reader import positive
from . import rotation
from .motion import Motion
from .sample_times import elapsed, time_text
from .straight_line import MOST_STEPS
from .trajectory import Trajectory

Path = Callable[[Array], Motion]
"""Function that returns the motion at times (s), of the shape of the times."""


def interpolate(trajectory: Trajectory) -> Path:
    """Return a function that interpolates a trajectory between its first and its last sample.

    Between two samples, position and quaternion are polynomials of degree 5 in time, and loads change
    linearly. The rotation between two samples must be less than half a turn.

    Parameters
    ----------
    trajectory : Trajectory
        Times and poses.

    Returns
    -------
    callable
        Function of times (...) (s) that returns a motion of the same shape. It raises ValueError for times
        outside the trajectory.

    Raises
    ------
    ValueError
        If there are fewer than two samples, times do not increase, or the motion has no accelerations.
    """
    time = _increasing(trajectory)
    motion = trajectory.motion
    if motion.alpha is None or motion.a is None:
        raise ValueError(f"{trajectory.source}: expected a motion with accelerations, got none")
    e = rotation.quaternion_from_rotation(motion.R)
    # A rotation has two quaternions; the one near the previous quaternion is used.
    e[1:] *= np.cumprod(np.where(np.sum(e[1:] * e[:-1], axis=-1) < 0.0, -1.0, 1.0))[:, None]
    rates = zip((motion.v, motion.a), rotation.quaternion_rates(e, motion.omega, motion.alpha), strict=True)
    poses = np.stack([np.hstack(pair) for pair in ((motion.t, e), *rates)])
    h = np.diff(elapsed(time))[:, None]
    c = _quintics(h, poses[:, :-1], poses[:, 1:])
    loads = {name: load for name in ("F_ext", "M_ext") if (load := getattr(motion, name)) is not None}

    def at(times: ArrayLike) -> Motion:
        when = real_array(times, "times")
        outside = ~((when >= time[0]) & (when <= time[-1]))
        if np.any(outside):
            raise ValueError(
                f"times: expected times in [{time_text(time[0])}, {time_text(time[-1])}] s, "
                f"got {time_text(when[outside][0])}"
            )
        i, share = _steps(time, when)
        pose, rate, second = _values(c[:, i], share, h[i])
        R, omega, alpha = rotation.motion_of_quaternion(pose[..., 3:], rate[..., 3:], second[..., 3:])
        now = {name: load[i] + share * (load[i + 1] - load[i]) for name, load in loads.items()}
        return Motion._unchecked(R, pose[..., :3], omega, rate[..., :3], alpha, second[..., :3], **now)

    return at


def followed(trajectory: Trajectory) -> Callable[[ArrayLike], Motion]:
    """Return ``interpolate`` for times (s) after the first sample; at rest after the last sample."""
    instance(trajectory, Trajectory, "trajectory")
    since = elapsed(trajectory.time)
    return with_rest(interpolate(replace(trajectory, time=since)), float(since[-1]))


def with_rest(path: Callable[[Array], Motion], end: float) -> Callable[[ArrayLike], Motion]:
    """Extend a motion over times from 0 to ``end`` (s): at rest in its last pose after its end."""

    def at(times: ArrayLike) -> Motion:
        when = np.asarray(times, dtype=np.float64)
        motion = path(np.clip(when, 0.0, end))
        if np.all(when < end):
            return motion
        moving, names = np.expand_dims(when < end, -1), ("omega", "v", "alpha", "a")
        rates = {name: rate for name in names if (rate := getattr(motion, name)) is not None}
        stopped = {name: np.where(moving, rate, 0.0) for name, rate in rates.items()}
        return Motion._unchecked(**(vars(motion) | stopped))

    return at


def resample(trajectory: Trajectory, rate: float) -> Trajectory:
    """Resample a trajectory at equal time steps from its first sample.

    Each new sample has the line number of the previous sample.

    Parameters
    ----------
    trajectory : Trajectory
        Times and poses.
    rate : float
        Sampling rate (Hz).

    Returns
    -------
    Trajectory
        Trajectory at equal time steps.

    Raises
    ------
    ValueError
        If the rate is not > 0, if there are more than ten million samples, or as in ``interpolate``.
    """
    time, rate = _increasing(trajectory), positive(rate, "rate")
    since = elapsed(time)
    count = float(since[-1]) * rate * (1.0 + 1e-12)
    if not count < MOST_STEPS:
        raise ValueError(f"rate: expected > 0 Hz and at most {MOST_STEPS:,} samples, got {rate:g}")
    when = np.minimum(time[0] + np.arange(int(count) + 1) / rate, time[-1])
    (i, share), coordinates = _steps(time, when), trajectory.coordinates
    if coordinates is not None:
        h = np.diff(since)[:, None]
        c = _quintics(h, coordinates[:, :-1], coordinates[:, 1:])
        coordinates = np.stack(_values(c[:, i], share, h[i]))
    rows = np.asarray(trajectory.rows)[i].tolist() if len(trajectory.rows) else ()
    changed = {"time": when, "rows": rows, "coordinates": coordinates, "F_ext": None, "M_ext": None}
    return replace(trajectory, given_motion=interpolate(trajectory)(when), **changed)


def _increasing(trajectory: Trajectory) -> Array:
    """Return the times of a trajectory; raise ValueError unless there are two or more that increase."""
    instance(trajectory, Trajectory, "trajectory")
    time = np.asarray(trajectory.time)
    if len(time) < 2:
        raise ValueError(f"{trajectory.source}: expected at least 2 samples, got {len(time)}")
    if not (time[1:] > time[:-1]).all():
        raise ValueError(f"{trajectory.source}: expected increasing times")
    return time


def _steps(time: Array, when: Array) -> tuple[Indices, Array]:
    """Return the step that contains each time, and its fraction before the time, shape (..., 1)."""
    i = np.minimum(np.searchsorted(time, when, side="right") - 1, len(time) - 2)
    return i, ((when - time[i]) / (time[i + 1] - time[i]))[..., None]


def _quintics(h: Array, first: Array, last: Array) -> Array:
    """Return coefficients, (6, n, k), of powers of the fraction of steps h (s), (n, 1).

    Values, rates, and second rates are given at both ends.
    """
    c_0, c_1, c_2 = first[0], h * first[1], 0.5 * h**2 * first[2]
    d, e, f = last[0] - c_0 - c_1 - c_2, h * last[1] - c_1 - 2.0 * c_2, h**2 * last[2] - 2.0 * c_2
    c_3, c_4, c_5 = 10.0 * d - 4.0 * e + 0.5 * f, -15.0 * d + 7.0 * e - f, 6.0 * d - 3.0 * e + 0.5 * f
    return np.stack([c_0, c_1, c_2, c_3, c_4, c_5])


def _values(c: Array, share: Array, h: Array) -> list[Array]:
    """Return values, rates, and second rates at fractions of steps h (s) with coefficients (6, ..., k)."""
    powers = (polynomial.polyval(share, polynomial.polyder(c, k), tensor=False) for k in range(3))
    return [np.asarray(values / h**k, dtype=np.float64) for k, values in enumerate(powers)]
