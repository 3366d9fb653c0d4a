"""Models of measured motions that are linear in their coefficients: Fourier series, and smoothing splines.

The coordinates are position and roll-pitch-yaw angles, q(t) = f(t) c with functions f of time. Derivatives of
f in place of the measured poses keep the noise out of the accelerations.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..io.arguments import instance, number_in, real_array, shown, whole_number
from ..io.array_types import Array, Indices
from ..motion.motion import Motion
from ..motion.rotation import cross_matrix, rpy_from_rotation, vector_from_rotation
from ..motion.sample_times import elapsed
from ..motion.spline import likeliest, smooth_columns
from .least_squares import solution

if TYPE_CHECKING:
    from ..motion.spline import SmoothCurves, Smoothness

# Largest pitch angle (rad); beyond it, roll and yaw are too poorly determined.
_STEEPEST = 1.4
# Ratio of scatter to stated noise of the poses below which the stated noise determines the smoothness.
_TOO_SMALL = 0.5
# Number of larger series without a gain before the search ends.
_IN_VAIN = 4


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
    prior : sparse or dense matrix, shape (rows, 6 size)
        Combinations of ``c.ravel()`` with a standard normal distribution; no rows for a Fourier series.
    """

    size: int
    start: Indices
    local: Array
    prior: Any

    def coordinates(self, c: Array) -> Array:
        """Return the coordinates and their first two derivatives, shape (3, n, 6)."""
        near = c[self.start[:, None] + np.arange(self.local.shape[2])]
        return np.asarray(np.moveaxis(np.moveaxis(self.local, 0, 1) @ near, 1, 0))

    def motion(self, c: Array, load: Motion) -> Motion:
        """Return the motion of the coefficients under the load of another motion, (n,)."""
        return _motion(self.coordinates(c), load)


def _motion(coordinates: Array, load: Motion) -> Motion:
    t, v, a = coordinates[..., :3]
    theta, theta_dot, theta_ddot = coordinates[..., 3:]
    return Motion.from_rpy(t, theta, v, theta_dot, a, theta_ddot, load.F_ext, load.M_ext)


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
    basis, c = next(bases(noise, q))
    rates = np.linalg.norm(basis.local[1] @ np.linalg.pinv(basis.local[0]), axis=1)
    return basis.motion(c, motion), rates[:, None] / noise.weights


def bases(noise: PoseNoise, q: Array) -> Iterator[tuple[Basis, Array]]:
    """Yield bases for measured coordinates (n, 6), and their coefficients for the poses alone.

    Series have a rising number of harmonics, beginning with the best one for the poses (Akaike's criterion).
    """
    if noise.period is None:
        yield _spline(noise, q)
        return
    # Samples of several periods at the same phase count once.
    phases = np.rint(elapsed(noise.time) / noise.period % 1.0 * len(q))
    most = max((3 * len(np.unique(phases)) // 4 - 1) // 2, 1)
    rising = np.geomspace(1, most, 1 + round(6.0 * math.log(most)))
    counts = rising if noise.harmonics is None else noise.harmonics
    found, costs = [], []
    for count in np.unique(np.rint(counts).astype(int)).tolist():
        basis = _fourier(noise.time, noise.period, count)
        c = solution(basis.local[0], q)
        squares = float(np.sum(((q - basis.local[0] @ c) * noise.weights) ** 2))
        found.append((basis, c))
        costs.append(akaike(squares, q.size, 6 * basis.size))
        best = int(np.argmin(costs))
        if len(costs) > best + _IN_VAIN:
            break
    yield from found[best:]


def akaike(squares: float, count: int, unknowns: int) -> float:
    """Return Akaike's criterion of a fit to ``count`` samples with noise of unknown size."""
    return count * math.log(max(squares, 1e-300)) + 2.0 * unknowns


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
    size, start = 2 * harmonics + 1, np.zeros(len(time), dtype=np.intp)
    return Basis(size, start, np.array(local), np.zeros((0, 6 * size)))


def _curves(noise: PoseNoise, q: Array) -> tuple[SmoothCurves, list[Smoothness]]:
    """Smooth the poses alone; the noise is estimated unless the estimate is much below the stated noise."""
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
    from scipy import sparse
    from scipy.interpolate import BSpline, make_interp_spline

    from ..motion.spline import DEGREE

    since, step = elapsed(noise.time), min(each.step for each in smoothness)
    cells = max(1, math.ceil(float(since[-1]) / step * (1.0 - 1e-9)))
    size, start = cells + DEGREE, np.minimum((since / step).astype(np.intp), cells - 1)
    near = BSpline(np.arange(-DEGREE, DEGREE + 2.0), np.eye(DEGREE + 1), DEGREE)
    local = np.array([near(since / step - start, order) / step**order for order in range(3)])
    priors = []
    for axis, each, std in zip(np.eye(6), smoothness, curves.noise_std, strict=True):
        # A penalty on finer knots has the same effect with this weight.
        weight = each.log_weight + (2 * each.order - 1) * math.log(each.step / step)
        signs = [(-1.0) ** k * math.comb(each.order, k) for k in range(each.order + 1)]
        differences = sparse.diags(signs, range(each.order + 1), shape=(size - each.order, size))
        priors.append(math.exp(0.5 * weight) / std * sparse.kron(differences, axis))
    ends = np.array([1.0, 2.0]) / 3.0
    sites = step * np.sort(np.concatenate([np.arange(cells + 1), ends, cells - ends]))
    knots = step * np.arange(-DEGREE, size + 1)
    c = make_interp_spline(sites, curves.evaluate(sites)[0], DEGREE, knots).c
    return Basis(size, start, local, sparse.vstack(priors, "csr")), c


def residual(basis: Basis, c: Array, motion: Motion, noise: PoseNoise) -> Array:
    """Return the differences from measured to smooth poses divided by their standard deviations, (n, 6)."""
    smooth = basis.motion(c, motion)
    turn = vector_from_rotation(motion.R @ np.swapaxes(smooth.R, -1, -2))
    return np.concatenate([motion.t - smooth.t, turn], axis=1) * noise.weights


def chain(
    basis: Basis, c: Array, motion: Motion
) -> tuple[tuple[Array, ...], tuple[Array, ...], tuple[Array, ...]]:
    """Return the derivatives of pose, twist, and acceleration by the coordinates, shape (n, 6, 6) each.

    ``motion`` is the motion of the coefficients. The derivatives of the pose [dt; dphi] are by q, of the
    twist by q and q_dot, and of the acceleration by q, q_dot, and q_ddot. A rotation dphi = E dq changes the
    angular velocity by d(dphi)/dt - omega x dphi, and the angular acceleration by the rate of this.
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
    """Return E of omega = E theta_dot and its first two time derivatives, shape (n, 3, 3) each."""
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
