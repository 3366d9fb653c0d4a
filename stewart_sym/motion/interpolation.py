"""Polynomials of degree 5 between the samples of a trajectory, with their poses, rates, and accelerations."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..io.arguments import real_array
from ..io.array_types import Array
from ..io.toml_reader import positive
from . import rotation
from .motion import Motion, at_rest
from .sample_times import apart, elapsed, parts, time_text
from .straight_line import MOST_STEPS
from .trajectory import Trajectory, need_trajectory

Path = Callable[[Array], Motion]
"""Function that returns the motion, shape (n,), at times (n,) (s)."""


def interpolate(trajectory: Trajectory) -> Path:
    """Return a function that interpolates a trajectory between its first and its last sample.

    Between two samples, position and rotation vector are polynomials of degree 5 in time. Loads change
    linearly.

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
    _need_interpolable(trajectory)
    time = trajectory.time
    per_second = parts(time)

    def at(times: ArrayLike) -> Motion:
        when = real_array(times, "times")
        outside = ~((when >= time[0]) & (when <= time[-1]))
        if np.any(outside):
            raise ValueError(
                f"times: expected times in [{time_text(time[0])}, {time_text(time[-1])}] s, "
                f"got {time_text(when[outside][0])}"
            )
        i, share = _steps(time, when)
        h = apart(time[i + 1], time[i], per_second)[..., None]
        if np.all((share == 0.0) | (share == 1.0)):
            return trajectory.at(np.asarray(i + (share[..., 0] == 1.0)))
        # The polynomials of the steps in question alone: those of all would take as much room as the motion.
        start, end = trajectory.at(i), trajectory.at(i + 1)
        R, t, omega, v, alpha, a = _moved(_steps_of(h, start, end), share, h, start.R)
        loads = {
            name: None if load is None or after is None else load + share * (after - load)
            for name, load, after in (("F_ext", start.F_ext, end.F_ext), ("M_ext", start.M_ext, end.M_ext))
        }
        return Motion(R=rotation.orthonormal(R), t=t, omega=omega, v=v, alpha=alpha, a=a, **loads)

    return at


def followed(trajectory: Trajectory) -> Callable[[float], Motion]:
    """Return ``interpolate`` for one time after the other, s since the first sample: at rest after the last.

    The polynomials of all steps are made once, which takes as much room as the motion. Raises as
    ``interpolate``.
    """
    _need_interpolable(trajectory)
    motion, time = trajectory.motion, elapsed(trajectory.time)
    h = np.diff(time)[:, None]
    c = _steps_of(h, motion[:-1], motion[1:])
    loads = {name: getattr(motion, name) for name in ("F_ext", "M_ext")}
    loads = {name: load for name, load in loads.items() if load is not None}
    last = at_rest(motion.R[-1], motion.t[-1], **{name: load[-1] for name, load in loads.items()})

    def at(when: float) -> Motion:
        if when >= time[-1]:
            return last
        i = max(int(np.searchsorted(time, when, side="right")) - 1, 0)
        share = (when - float(time[i])) / float(h[i, 0])
        now = {name: load[i] + share * (load[i + 1] - load[i]) for name, load in loads.items()}
        return Motion._unchecked(*_moved(c[:, i], share, h[i], motion.R[i]), **now)

    return at


def _need_interpolable(trajectory: Trajectory) -> None:
    """Reject, by ValueError, fewer than two samples, times that don't increase, and no accelerations."""
    need_trajectory(trajectory)
    time = trajectory.time
    if len(time) < 2:
        raise ValueError(f"{trajectory.source}: expected at least 2 samples, got {len(time)}")
    if not (time[1:] > time[:-1]).all():
        raise ValueError(f"{trajectory.source}: expected increasing times")
    if trajectory.given_motion is not None and trajectory.given_motion.a is None:
        raise ValueError(f"{trajectory.source}: expected a motion with accelerations, got none")


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
    _need_interpolable(trajectory)
    rate = positive(rate, "rate")
    time = trajectory.time
    since = elapsed(time)
    count = float(since[-1]) * rate * (1.0 + 1e-12)
    if not count < MOST_STEPS:
        raise ValueError(f"rate: expected > 0 Hz and at most {MOST_STEPS:,} samples, got {rate:g}")
    path = interpolate(trajectory)
    when = np.minimum(time[0] + np.arange(int(count) + 1) / rate, time[-1])
    i, share = _steps(time, when)
    rows = tuple(trajectory.rows[int(k)] for k in i)
    noise = trajectory.noise
    if noise is not None:
        start, end = noise.coordinates[:, :-1], noise.coordinates[:, 1:]
        h = np.diff(since)[:, None]
        c = quintic(h, tuple(start), tuple(end))
        noise = replace(noise, coordinates=np.stack(values(c[:, i], share, h[i])))
    return Trajectory(when, path(when), trajectory.source, rows, noise)


def _steps(time: Array, when: Array) -> tuple[NDArray[np.int64], Array]:
    """Step in which each time lies, and the share of it that has passed, (..., 1)."""
    i = np.minimum(np.searchsorted(time, when, side="right") - 1, len(time) - 2)
    return i, ((when - time[i]) / (time[i + 1] - time[i]))[..., None]


Ends = tuple[Array, Array, Array]


def _steps_of(h: Array, start: Motion, end: Motion) -> Array:
    """Coefficients as of ``quintic`` of positions and of rotation vectors from the start of each step."""
    assert start.alpha is not None
    assert end.alpha is not None
    turn = rotation.vector_from_rotation(end.R @ np.swapaxes(start.R, -1, -2))
    rates = rotation.vector_rate(turn, end.omega), rotation.vector_second_rate(turn, end.omega, end.alpha)
    turning = quintic(h, (np.zeros_like(turn), start.omega, start.alpha), (turn, *rates))
    places = quintic(h, *((each.t, each.v, np.asarray(each.a)) for each in (start, end)))
    return np.concatenate([places, turning], axis=-1)


def _moved(c: Array, share: Array | float, h: Array, R: Array) -> tuple[Array, ...]:
    """R, t, omega, v, alpha and a at shares of steps h, s, of coefficients (6, ..., 6) that begin with R."""
    pose, rate, second = values(c, share, h)
    omega, alpha = rotation.angular_motion_from_vector(pose[..., 3:], rate[..., 3:], second[..., 3:])
    R = rotation.rotation_from_vector(pose[..., 3:]) @ R
    return R, pose[..., :3], omega, rate[..., :3], alpha, second[..., :3]


def quintic(h: Array, first: Ends, last: Ends) -> Array:
    """Coefficients, (6, ..., 3), of powers of the share of a step h, from values, rates and second rates."""
    c_0, c_1, c_2 = first[0], h * first[1], 0.5 * h**2 * first[2]
    d, e, f = last[0] - c_0 - c_1 - c_2, h * last[1] - c_1 - 2.0 * c_2, h**2 * last[2] - 2.0 * c_2
    c_3, c_4, c_5 = 10.0 * d - 4.0 * e + 0.5 * f, -15.0 * d + 7.0 * e - f, 6.0 * d - 3.0 * e + 0.5 * f
    return np.stack([c_0, c_1, c_2, c_3, c_4, c_5])


def values(c: Array, share: Array | float, h: Array) -> Ends:
    """Value, rate and second rate at shares of steps h, s, of coefficients (6, ..., 3)."""
    x = c[0] + share * (c[1] + share * (c[2] + share * (c[3] + share * (c[4] + share * c[5]))))
    rate = c[1] + share * (2.0 * c[2] + share * (3.0 * c[3] + share * (4.0 * c[4] + share * 5.0 * c[5])))
    second = 2.0 * c[2] + share * (6.0 * c[3] + share * (12.0 * c[4] + share * 20.0 * c[5]))
    return x, rate / h, second / h**2
