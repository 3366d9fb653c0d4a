"""Models of measured motions that are linear in their coefficients: Fourier series, and smoothing splines.

The coordinates are position and roll-pitch-yaw angles, q(t) = f(t) c with functions f of time. Derivatives of
f in place of the measured poses keep the noise out of the accelerations.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from scipy import sparse
from scipy.interpolate import BSpline

from ..io.arguments import finite_array, instance, number_in, real_array, shown, whole_number
from ..io.array_types import Array, Flags, Indices
from ..motion.motion import Motion
from ..motion.rotation import rpy_from_rotation, vector_from_rotation
from ..motion.sample_times import elapsed
from ..motion.spline import DEGREE, SmoothCurve, Smoother, Smoothness
from .excitation import harmonics_at

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
    covariance : ndarray, shape (n, 6, 6) or (6, 6), optional
        Covariance of position and rotation vector in the base frame, if they are not independent. Then
        ``position`` and ``angle`` are typical standard deviations.

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
    covariance: ArrayLike | None = None

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
        if self.covariance is not None:
            self._check_covariance(finite_array(self.covariance, (6, 6), "covariance"))
        if self.harmonics is None:
            return
        if self.period is None:
            raise ValueError("harmonics: expected None for a motion without a period")
        most = (len(time) - 1) // 2
        expected = f"a whole number from 1 to {most} for {len(time)} samples, or None"
        whole_number(self.harmonics, "harmonics", 1, expected, most)

    def _check_covariance(self, given: Array) -> None:
        """Raise ValueError unless there is one positive definite matrix, or one for each time."""
        if given.shape not in ((6, 6), (len(self.time), 6, 6)) or np.linalg.eigvalsh(given).min() <= 0.0:
            expected = f"positive definite matrices, (6, 6) or {(len(self.time), 6, 6)}"
            raise ValueError(f"covariance: expected {expected}, got {shown(self.covariance)}")

    def at(self, index: Indices | Flags) -> PoseNoise:
        """Return the noise at some of the times.

        Parameters
        ----------
        index : ndarray
            Indices of the times, or a flag for each time.

        Returns
        -------
        PoseNoise
            Noise at these times.
        """
        covariance = None if self.covariance is None else np.asarray(self.covariance)
        if covariance is not None and covariance.ndim == 3:
            covariance = covariance[index]
        return replace(self, time=self.time[index], covariance=covariance)

    @property
    def std(self) -> Array:
        """Typical standard deviation of each coordinate (m, rad), shape (6,)."""
        return np.repeat([self.position, self.angle], 3)

    @property
    def weights(self) -> Array:
        """Matrices that make the errors of the poses independent with variance 1, shape (n, 6, 6)."""
        given = np.diag(self.std**2) if self.covariance is None else self.covariance
        roots = np.linalg.inv(np.linalg.cholesky(np.asarray(given)))
        return np.broadcast_to(roots, (len(self.time), 6, 6))


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
    prior : sparse matrix, shape (rows, 6 size)
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

    def rows(self, derivatives: Array) -> sparse.csr_matrix:
        """Return the derivatives of 6 n values by c, shape (6 n, 6 size).

        ``derivatives``, shape (k, n, 6, 6), are derivatives by the coordinates and their first k - 1 rates.
        """
        by_c = np.einsum("knij,knw->niwj", derivatives, self.local[: len(derivatives)], optimize=True)
        n, _, width, _ = by_c.shape
        columns = 6 * self.start[:, None, None] + np.arange(6 * width) + np.zeros((1, 6, 1), dtype=np.intp)
        pointers = 6 * width * np.arange(6 * n + 1)
        return sparse.csr_matrix((by_c.ravel(), columns.ravel(), pointers), shape=(6 * n, 6 * self.size))


def motion_of(coordinates: Array, load: Motion) -> Motion:
    """Return the motion of coordinates, shape (3, n, 6), under the load of another motion."""
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
        smoother, curves, _ = _curves(noise, q)
        rates = np.stack([curve.covariance(since, [(1, 1)])[:, 0] for curve in curves], axis=-1)
        return motion_of(smoother.derivatives(curves), motion), np.sqrt(rates)
    basis, c = basis_of(noise, q)
    rates = np.linalg.norm(basis.local[1] @ np.linalg.pinv(basis.local[0]), axis=1)
    return motion_of(basis.coordinates(c), motion), rates[:, None] * noise.std


def basis_of(noise: PoseNoise, q: Array) -> tuple[Basis, Array]:
    """Return a basis for measured coordinates (n, 6), and its coefficients for the poses alone.

    If the number of harmonics is unknown, it is one size above the optimum of Akaike's criterion. The
    additional size keeps the approximation error of the motion below the noise.
    """
    if noise.period is None:
        return _spline(noise, q)
    # Samples of several periods at the same phase count once.
    phases = np.rint(elapsed(noise.time) / noise.period % 1.0 * len(q))
    most = max((3 * len(np.unique(phases)) // 4 - 1) // 2, 1)
    rising = np.geomspace(1, most, 1 + round(6.0 * math.log(most)))
    counts = rising if noise.harmonics is None else noise.harmonics
    found, costs, best = [], [], 0
    for count in np.unique(np.rint(counts).astype(int)).tolist():
        local, start = harmonics_at(elapsed(noise.time), noise.period, count), np.zeros(len(q), dtype=np.intp)
        size = local.shape[2]
        c = np.linalg.lstsq(local[0], q)[0]
        squares = float(np.sum(((q - local[0] @ c) / noise.std) ** 2))
        found.append((Basis(size, start, local, sparse.csr_matrix((0, 6 * size))), c))
        costs.append(q.size * math.log(max(squares, 1e-300)) + 12.0 * size)
        best = int(np.argmin(costs))
        if len(costs) > best + _IN_VAIN:
            break
    return found[min(best + 1, len(found) - 1)]


def _curves(noise: PoseNoise, q: Array) -> tuple[Smoother, list[SmoothCurve], list[Smoothness]]:
    """Smooth the poses alone; the noise is estimated unless the estimate is much below the stated noise."""
    smoother = Smoother(elapsed(noise.time), q)
    curves = smoother.curves(smoothness := smoother.likeliest())
    interpolated = np.array([curve.noise_std for curve in curves]) < _TOO_SMALL * noise.std
    if interpolated.any():
        smoother = Smoother(elapsed(noise.time), q, np.where(interpolated, noise.std, np.nan))
        curves = smoother.curves(smoothness := smoother.likeliest())
    return smoother, curves, smoothness


def _spline(noise: PoseNoise, q: Array) -> tuple[Basis, Array]:
    """Return the finest B-splines of the curves through the poses, with the priors of their penalties."""
    _, coarse, smoothness = _curves(noise, q)
    since, step = elapsed(noise.time), min(each.step for each in smoothness)
    # A penalty on finer knots has the same effect with this weight.
    finer = [
        each._replace(
            step=step, log_weight=each.log_weight + (2 * each.order - 1) * math.log(each.step / step)
        )
        for each in smoothness
    ]
    noise_std = np.array([curve.noise_std for curve in coarse])
    curves = Smoother(since, q, noise_std).curves(finer)
    c = np.stack([curve.coefficients for curve in curves], axis=-1)
    start, size = np.minimum((since / step).astype(np.intp), len(c) - DEGREE - 1), len(c)
    near = BSpline(np.arange(-DEGREE, DEGREE + 2.0), np.eye(DEGREE + 1), DEGREE)
    local = np.array([near(since / step - start, order) / step**order for order in range(3)])
    priors = []
    for axis, each, std in zip(np.eye(6), finer, noise_std, strict=True):
        signs = [(-1.0) ** k * math.comb(each.order, k) for k in range(each.order + 1)]
        differences = sparse.diags(signs, range(each.order + 1), shape=(size - each.order, size))
        priors.append(math.exp(0.5 * each.log_weight) / std * sparse.kron(differences, axis))
    return Basis(size, start, local, sparse.vstack(priors, "csr")), c


def pose_residual(measured: Motion, smooth: Motion, weights: Array) -> Array:
    """Return the differences from smooth to measured poses, made independent, shape (n, 6)."""
    turn = vector_from_rotation(measured.R @ np.swapaxes(smooth.R, -1, -2))
    off = np.concatenate([measured.t - smooth.t, turn], axis=1)
    return np.asarray(np.einsum("nij,nj->ni", weights, off))


def pose_derivatives(coordinates: Array, weights: Array) -> Array:
    """Return minus the derivatives of ``pose_residual`` by position and angles, shape (n, 6, 6)."""
    t, theta = coordinates[0, :, :3], coordinates[0, :, 3:]
    J = np.zeros((len(t), 6, 6))
    J[:, :3, :3] = np.eye(3)
    for axis, rates in enumerate(np.eye(3)):
        # The angular velocity of a unit rate is the derivative of the rotation.
        J[:, 3:, 3 + axis] = Motion.from_rpy(t, theta, 0.0 * t, np.broadcast_to(rates, t.shape)).omega
    return np.asarray(weights @ J)
