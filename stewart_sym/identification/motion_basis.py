"""Models of measured motions that are linear in their coefficients: Fourier series, and smoothing splines.

The coordinates are position and roll-pitch-yaw angles, q(t) = f(t) c with functions f of time. Derivatives of
f in place of the measured poses keep the noise out of the accelerations.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import instance, number_in, real_array, shown, whole_number
from ..io.array_types import Array, Indices
from ..io.extras import needed_for
from ..motion.motion import Motion
from ..motion.rotation import cross_matrix, rpy_from_rotation, vector_from_rotation
from ..motion.sample_times import elapsed

if TYPE_CHECKING:
    from ..motion.spline import SmoothCurves, Smoothness

WITHOUT_PERIOD = "a smooth motion without a period"
"""Task that requires SciPy."""

# Largest pitch angle (rad); beyond it, roll and yaw are too poorly determined.
_STEEPEST = 1.4
# Smallest number of poses whose noise is estimated.
_FEWEST = 8
# Ratio of scatter to stated noise of the poses below which the stated noise determines the smoothness.
_TOO_SMALL = 0.5


@dataclass(frozen=True, eq=False)
class PoseNoise:
    """Noise of measured poses.

    Attributes
    ----------
    time : ndarray, shape (n,)
        Increasing times (s).
    position, angle : float
        Standard deviations of each coordinate of the position (m) and of the rotation about each axis (rad).
        Samples are independent.
    period : float, optional
        Period (s). A periodic motion is modeled by a Fourier series, other motions by a spline of degree 5.
    harmonics : int, optional
        Number of harmonics of the series. None: chosen from the measurement.

    Raises
    ------
    ValueError
        If an argument is invalid. The message names it.
    """

    time: Array
    position: float
    angle: float
    period: float | None = None
    harmonics: int | None = None

    def __post_init__(self) -> None:
        time = real_array(self.time, "time", "increasing times, s, (n,)")
        if time.ndim != 1 or not np.isfinite(time).all() or not np.all(np.diff(time) > 0.0):
            raise ValueError(f"time: expected increasing times, s, (n,), got {shown(self.time)}")
        time.setflags(write=False)
        object.__setattr__(self, "time", time)
        for name, unit in (("position", "m"), ("angle", "rad")):
            number_in(getattr(self, name), name, f"a standard deviation > 0 {unit}")
        if self.period is not None:
            number_in(self.period, "period", "a duration > 0 s or None")
        if self.harmonics is None:
            return
        if self.period is None:
            raise ValueError("harmonics: expected None for a motion without a period")
        most = (len(time) - 1) // 2
        expected = f"a whole number from 1 to {most} for {len(time)} samples, or None"
        whole_number(self.harmonics, "harmonics", 1, expected, most)

    @property
    def weights(self) -> Array:
        """Reciprocal standard deviation of each coordinate (1/m, 1/rad), shape (6,)."""
        return 1.0 / np.repeat([self.position, self.angle], 3)


class Basis(NamedTuple):
    """Functions of time at n samples, and the prior distribution of their coefficients c, shape (size, 6).

    Attributes
    ----------
    size : int
        Number of functions.
    start : ndarray of int, shape (n,)
        First of the functions that are not zero at each sample.
    local : ndarray, shape (3, n, width)
        Values, rates, and second rates of these functions.
    prior : ndarray, shape (rows, 6 width)
        Linear combinations of coefficients with a standard normal distribution; no rows for Fourier series.
    prior_start : ndarray of int, shape (rows,)
        First coefficient of each row in the order of ``c.ravel()``.
    """

    size: int
    start: Indices
    local: Array
    prior: Array
    prior_start: Indices

    def coordinates(self, c: Array) -> Array:
        """Return the coordinates and their first two derivatives, shape (3, n, 6)."""
        near = c[self.start[:, None] + np.arange(self.local.shape[2])]
        return np.asarray(np.moveaxis(np.moveaxis(self.local, 0, 1) @ near, 1, 0))

    def motion(self, c: Array, load: Motion) -> Motion:
        """Return the motion of the coefficients under the load of another motion, (n,)."""
        return _motion(self.coordinates(c), load)

    def prior_values(self, c: Array) -> Array:
        """Return the combinations of ``prior``, shape (rows,)."""
        near = c.ravel()[self.prior_start[:, None] + np.arange(self.prior.shape[1])]
        return np.asarray(np.einsum("rc,rc->r", self.prior, near))


def _motion(coordinates: Array, load: Motion) -> Motion:
    t, v, a = coordinates[..., :3]
    theta, theta_dot, theta_ddot = coordinates[..., 3:]
    return Motion.from_rpy(t, theta, v, theta_dot, a, theta_ddot, load.F_ext, load.M_ext)


def estimate_pose_noise(
    time: ArrayLike, motion: Motion, period: float | None = None, harmonics: int | None = None
) -> PoseNoise:
    """Estimate the noise of measured poses from their scatter about a smoothing spline. Requires SciPy.

    Parameters
    ----------
    time : array_like, shape (n,)
        Increasing times (s), at least 8.
    motion : Motion
        Measured poses, shape (n,); rates are ignored.
    period, harmonics : float and int, optional
        Attributes of the result.

    Returns
    -------
    PoseNoise
        Times, standard deviations, and period.

    Raises
    ------
    ValueError
        If an argument is invalid, or if the poses do not scatter.
    """
    noise = PoseNoise(time, 1.0, 1.0, period, harmonics)  # type: ignore[arg-type]
    q = coordinates(motion, noise)
    if len(q) < _FEWEST:
        raise ValueError(f"motion: expected at least {_FEWEST} poses, got {len(q)}")
    with needed_for(WITHOUT_PERIOD):
        from ..motion.spline import smooth_columns
    std = smooth_columns(elapsed(noise.time), q).noise_std.reshape(2, 3)
    position, angle = (float(each) for each in np.sqrt(np.mean(std**2, axis=1)))
    if not min(position, angle) > 1e-12 * (1.0 + np.max(np.abs(q))):
        raise ValueError("motion: expected measured poses that scatter about a smooth motion, got exact ones")
    return PoseNoise(noise.time, position, angle, period, harmonics)


def coordinates(motion: Motion, noise: PoseNoise) -> Array:
    """Return position and unwrapped angles of the measured poses, (n, 6).

    Raises ValueError for another number of samples, and for pitch angles near a right angle.
    """
    instance(motion, Motion, "motion")
    if motion.shape != noise.time.shape:
        raise ValueError(f"motion: expected {len(noise.time)} samples as in time, got shape {motion.shape}")
    theta = rpy_from_rotation(motion.R)
    steepest = float(np.max(np.abs(theta[:, 1]), initial=0.0))
    if steepest > _STEEPEST:
        raise ValueError(f"motion: expected theta_y within {_STEEPEST:g} rad of 0, got {steepest:.3g}")
    return np.concatenate([motion.t, np.unwrap(theta, axis=0)], axis=1)


def smoothed(motion: Motion, noise: PoseNoise) -> tuple[Motion, Array]:
    """Fit a smooth motion to the measured poses alone, under the load of the measured motion.

    Returns also the standard deviations of the rates of position and angles (m/s, rad/s), (n, 6).
    """
    q = coordinates(motion, noise)
    if noise.period is None:
        since = elapsed(noise.time)
        curves, _ = _curves(noise, q)
        return _motion(curves.evaluate(since), motion), np.sqrt(curves.covariance(since)[..., 2])
    basis, c = next(_fourier_series(noise, q, noise.period))
    rates = np.linalg.norm(basis.local[1] @ np.linalg.pinv(basis.local[0]), axis=1)
    return basis.motion(c, motion), rates[:, None] / noise.weights


def bases(noise: PoseNoise, q: Array) -> Iterator[tuple[Basis, Array]]:
    """Yield bases for measured coordinates (n, 6), and their coefficients for the poses alone.

    Series have a rising number of harmonics, beginning with the best one for the poses (Akaike's criterion).
    """
    if noise.period is None:
        yield _spline(noise, q)
    else:
        yield from _fourier_series(noise, q, noise.period)


def _fourier_series(noise: PoseNoise, q: Array, period: float) -> Iterator[tuple[Basis, Array]]:
    counts = [noise.harmonics] if noise.harmonics else _harmonics(noise.time, period)
    found, costs = [], []
    for basis in (_fourier(noise.time, period, count) for count in counts):
        c = np.linalg.lstsq(basis.local[0], q, rcond=None)[0]
        squares = float(np.sum(((q - basis.local[0] @ c) * noise.weights) ** 2))
        found.append((basis, c))
        costs.append(akaike(squares, q.size, 6 * basis.size))
    yield from found[int(np.argmin(costs)) :]


def akaike(squares: float, count: int, unknowns: int) -> float:
    """Return Akaike's criterion of a fit to ``count`` samples with noise of unknown size."""
    return count * math.log(max(squares, 1e-300)) + 2.0 * unknowns


def _harmonics(time: Array, period: float) -> list[int]:
    """Return increasing numbers of harmonics, with at most three quarters as many functions as samples.

    Samples of several periods at the same phase count once.
    """
    count = len(np.unique(np.rint(elapsed(time) / period % 1.0 * len(time))))
    found, most = [1], max(3 * count // 4, 7)
    while (following := max(found[-1] + 1, int(1.2 * found[-1]))) <= (most - 1) // 2:
        found.append(following)
    return found


def _fourier(time: Array, period: float, harmonics: int) -> Basis:
    rate = 2.0 * math.pi / period * np.arange(1, harmonics + 1)
    angle = rate * elapsed(time)[:, None]
    sin, cos = np.sin(angle), np.cos(angle)
    one, zero = np.ones((len(time), 1)), np.zeros((len(time), 1))
    local = [
        np.hstack([one, sin, cos]),
        np.hstack([zero, rate * cos, -rate * sin]),
        np.hstack([zero, -(rate**2) * sin, -(rate**2) * cos]),
    ]
    size = 2 * harmonics + 1
    start = np.zeros(len(time), dtype=np.intp)
    return Basis(size, start, np.array(local), np.zeros((0, 6 * size)), start[:0])


def _curves(noise: PoseNoise, q: Array) -> tuple[SmoothCurves, list[Smoothness]]:
    """Smooth the poses alone; the noise is estimated unless the estimate is much below the stated noise."""
    with needed_for(WITHOUT_PERIOD):
        from ..motion.spline import likeliest, smooth_columns
    since, std = elapsed(noise.time), 1.0 / noise.weights
    smoothness = likeliest(since, q)
    curves = smooth_columns(since, q, smoothness=smoothness)
    interpolated = curves.noise_std < _TOO_SMALL * std
    if interpolated.any():
        known = np.where(interpolated, std, np.nan)
        smoothness = likeliest(since, q, known)
        curves = smooth_columns(since, q, known, smoothness=smoothness)
    return curves, smoothness


def _spline(noise: PoseNoise, q: Array) -> tuple[Basis, Array]:
    """Return the finest B-splines of the curves through the poses, with the priors of their penalties."""
    curves, smoothness = _curves(noise, q)
    from scipy.interpolate import BSpline, make_interp_spline

    from ..motion.spline import DEGREE

    since, step = elapsed(noise.time), min(each.step for each in smoothness)
    cells = max(1, math.ceil(float(since[-1]) / step * (1.0 - 1e-9)))
    size, width = cells + DEGREE, max(DEGREE, *(each.order for each in smoothness)) + 1
    cell = np.minimum((since / step).astype(np.intp), cells - 1)
    start = np.minimum(cell, size - width)
    near = BSpline(np.arange(-DEGREE, DEGREE + 2.0), np.eye(DEGREE + 1), DEGREE)
    local, place = np.zeros((3, len(since), width)), (cell - start)[:, None] + np.arange(DEGREE + 1)
    for order in range(3):
        np.put_along_axis(local[order], place, near(since / step - cell, order) / step**order, axis=1)
    priors = [
        _prior(size, width, j, each.order, _prior_weight(each, step) / std)
        for j, (each, std) in enumerate(zip(smoothness, curves.noise_std, strict=True))
    ]
    rows, starts = (np.concatenate(parts) for parts in zip(*priors, strict=True))
    ends = np.array([1.0, 2.0]) / 3.0
    sites = step * np.sort(np.concatenate([np.arange(cells + 1), ends, cells - ends]))
    knots = step * np.arange(-DEGREE, size + 1)
    c = make_interp_spline(sites, curves.evaluate(sites)[0], DEGREE, knots).c
    return Basis(size, start, local, rows, starts), c


def _prior_weight(smoothness: Smoothness, step: float) -> float:
    """Return the square root of the weight of a penalty on knots at another distance (s)."""
    finer = (2 * smoothness.order - 1) * math.log(smoothness.step / step)
    return math.exp(0.5 * (smoothness.log_weight + finer))


def _prior(size: int, width: int, coordinate: int, order: int, weight: float) -> tuple[Array, Indices]:
    """Return weighted differences of the coefficients of one coordinate, as ``prior`` and ``prior_start``."""
    first = np.minimum(np.arange(size - order), size - width)
    place = (np.arange(size - order) - first)[:, None] + np.arange(order + 1)
    rows = np.zeros((size - order, width, 6))
    signs = [(-1.0) ** k * math.comb(order, k) for k in range(order + 1)]
    rows[np.arange(size - order)[:, None], place, coordinate] = weight * np.array(signs)
    return rows.reshape(-1, 6 * width), 6 * first


def residual(basis: Basis, c: Array, motion: Motion, noise: PoseNoise) -> Array:
    """Return the differences from measured to smooth poses divided by their standard deviations, (n, 6)."""
    smooth = basis.motion(c, motion)
    turn = vector_from_rotation(motion.R @ np.swapaxes(smooth.R, -1, -2))
    return np.concatenate([motion.t - smooth.t, turn], axis=1) * noise.weights


def chain(
    basis: Basis, c: Array, motion: Motion
) -> tuple[tuple[Array, ...], tuple[Array, ...], tuple[Array, ...]]:
    """What the coordinates and their derivatives move: maps to pose, twist and acceleration.

    motion: of the coefficients. Returns for the pose [dt; dphi], twist and acceleration the matrices (n, 6,
    6) by q; by q, q_dot; and by q, q_dot, q_ddot. A turn dphi = E dq changes the angular velocity by
    d(dphi)/dt - omega x dphi, and this in turn the angular acceleration by its rate.
    """
    q, q_dot, q_ddot = basis.coordinates(c)
    E, E_dot, E_ddot = _turns(q[:, 3:], q_dot[:, 3:], q_ddot[:, 3:])
    W, A = cross_matrix(motion.omega), cross_matrix(np.asarray(motion.alpha))
    one, zero = np.broadcast_to(np.eye(3), E.shape), np.zeros(E.shape)

    def both(position: Array, turn: Array) -> Array:
        return np.block([[position, zero], [zero, turn]])

    pose = (both(one, E),)
    twist = (both(zero, E_dot - W @ E), both(one, E))
    second = (
        both(zero, E_ddot - A @ E - W @ E_dot),
        both(zero, 2.0 * E_dot - W @ E),
        both(one, E),
    )
    return pose, twist, second


def _turns(theta: Array, rate: Array, second: Array) -> tuple[Array, Array, Array]:
    """E of omega = E theta_dot and its first two derivatives by time, (n, 3, 3)."""
    e_z = np.broadcast_to([0.0, 0.0, 1.0], theta.shape)
    (sin_y, sin_z), (cos_y, cos_z) = (f(theta[:, 1:]).T for f in (np.sin, np.cos))
    e_y = np.stack([-sin_z, cos_z, np.zeros_like(sin_z)], axis=-1)
    e_x = np.stack([cos_y * cos_z, cos_y * sin_z, -sin_y], axis=-1)
    about_y = rate[:, 2:] * e_z
    about_x = about_y + rate[:, 1:2] * e_y
    about_y_dot = second[:, 2:] * e_z
    about_x_dot = about_y_dot + second[:, 1:2] * e_y + rate[:, 1:2] * np.cross(about_y, e_y)
    columns = [
        (e, np.cross(w, e), np.cross(w_dot, e) + np.cross(w, np.cross(w, e)))
        for e, w, w_dot in ((e_x, about_x, about_x_dot), (e_y, about_y, about_y_dot))
    ]
    columns.append((e_z, np.zeros(e_z.shape), np.zeros(e_z.shape)))
    E, E_dot, E_ddot = (np.stack(parts, axis=-1) for parts in zip(*columns, strict=True))
    return E, E_dot, E_ddot
