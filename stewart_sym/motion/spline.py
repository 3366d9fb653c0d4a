"""Smoothing splines whose smoothness is estimated from the samples, with the covariance of the result.

A curve is a spline of degree 5 on even knots. It minimizes the squared residuals plus a penalty, the weighted
squared differences of its coefficients (P-spline, Eilers and Marx 1996). The penalty is the prior of a
Gaussian model, therefore the weight and the noise are estimated by restricted maximum likelihood, and the
curve has a posterior covariance. Rows that are left out need no special treatment: the curve bridges them,
and the covariance increases there.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np
from scipy import sparse
from scipy.interpolate import BSpline
from scipy.linalg import LinAlgError, cho_solve_banded, cholesky_banded
from scipy.linalg.lapack import dtbtrs
from scipy.ndimage import uniform_filter1d
from scipy.optimize import minimize_scalar
from scipy.special import gammaln

from ..io.array_types import Array

DEGREE = 5
ORDERS = (3, 4, 6, 8)
"""Orders of the differences in the penalty; the likeliest one is used."""
# Mean square of the bias relative to its expectation, by order, fitted to 200 random motions.
_BIAS = {3: 1.0, 4: 1.0, 6: 0.25, 8: 0.1}
# A coefficient with less than this fraction of the usual number of samples is in a gap.
_EMPTY = 0.1
PAIRS = ((0, 0), (1, 0), (1, 1), (2, 0), (2, 1), (2, 2))
"""Orders of the derivatives to which the components of a covariance belong."""
# Logarithms of weights relative to the samples per cell: the smallest one, and the smallest one for which the
# knots are fine enough. The logarithm of the largest condition number limits them.
_LIGHTEST, _FINE, _CONDITION = -16.0, 6.0, 28.0
_TRIED_WEIGHTS = 8
# Largest correlation of adjacent residuals of a curve with fine knots.
_MOST_CORRELATED = 0.2
_FEWEST_CELLS = 32
# Number of samples from which the smoothness of a long log is estimated, and of blocks in them.
_TRIAL_SAMPLES, _TRIAL_BLOCKS = 8192, 64
# Number of cells per period of the cut-off frequency.
_CELLS_PER_PERIOD = 8.0
_CHUNK = 1 << 14
_BLOCK = 64
# Parts of the largest diagonal element and of the samples per cell that keep a matrix definite in gaps.
_ROUNDING, _RIDGE = 4e-16, 1e-11


class Smoothness(NamedTuple):
    """Distance of knots (s), order of the penalty, and logarithm of its weight."""

    step: float
    order: int
    log_weight: float


@dataclass(frozen=True, eq=False)
class SmoothCurve:
    """One column of samples as a curve over time.

    Attributes
    ----------
    start, step : float
        Time of the first knot (s) and distance between knots (s).
    coefficients : ndarray, shape (p,)
        B-spline coefficients.
    noise_std : float
        Standard deviation of the noise of the samples.
    band : ndarray, shape (p, 6)
        Posterior covariance of each coefficient with itself and the five next ones.
    factors : ndarray, shape (3, p)
        Ratio of the actual standard deviation to the posterior one, for values, rates, and second rates.
    """

    start: float
    step: float
    coefficients: Array
    noise_std: float
    band: Array
    factors: Array

    @property
    def knots(self) -> Array:
        """Times of the knots in the range of the samples (s)."""
        return np.asarray(self.start + self.step * np.arange(len(self.coefficients) - DEGREE + 1.0))

    def covariance(self, time: Array) -> Array:
        """Return the covariances ``PAIRS`` of value, rate, and second rate at n times, shape (n, 6)."""
        found = np.empty((len(time), len(PAIRS)))
        offsets = np.arange(DEGREE + 1)
        low, distance = np.minimum.outer(offsets, offsets), np.abs(np.subtract.outer(offsets, offsets))
        splines = BSpline(np.arange(-DEGREE, DEGREE + 2.0), np.eye(DEGREE + 1), DEGREE)
        for part in (slice(i, i + _CHUNK) for i in range(0, len(time), _CHUNK)):
            place = self.since(time[part]) / self.step
            cell = np.minimum(place.astype(int), len(self.coefficients) - DEGREE - 1)
            C = self.band[cell[:, None, None] + low, distance]
            centers = np.arange(len(self.coefficients)) - DEGREE // 2
            rows = [
                splines(place - cell, order) * np.interp(place, centers, f)[:, None] / self.step**order
                for order, f in enumerate(self.factors)
            ]
            for k, (i, j) in enumerate(PAIRS):
                found[part, k] = np.einsum("np,npq,nq->n", rows[i], C, rows[j], optimize=True)
        return found

    def since(self, time: Array) -> Array:
        """Return times since the first knot (s), limited to the range of the samples."""
        end = self.step * (len(self.coefficients) - DEGREE)
        return np.clip(time - self.start, 0.0, end * (1.0 - 1e-15))


@dataclass(frozen=True, eq=False)
class SmoothCurves:
    """Columns of samples as curves over time."""

    columns: tuple[SmoothCurve, ...]

    @property
    def noise_std(self) -> Array:
        """Standard deviation of the noise of each column, shape (c,)."""
        return np.array([curve.noise_std for curve in self.columns])

    def evaluate(self, time: Array, orders: int = 3) -> Array:
        """Return values, rates, and second rates, or fewer orders, at n times, shape (orders, n, c).

        The derivative of a spline on even knots has the differences of its coefficients, and one degree less.
        """
        found = np.empty((orders, len(time), len(self.columns)))
        steps = np.array([curve.step for curve in self.columns])
        for step in np.unique(steps):
            columns = np.flatnonzero(steps == step)
            curve = self.columns[columns[0]]
            since, knots = curve.since(time), _knots(step, len(curve.coefficients))
            c = np.stack([self.columns[column].coefficients for column in columns], axis=-1)
            for order in range(orders):
                B = BSpline.design_matrix(since, knots[order : len(knots) - order], DEGREE - order)
                found[order][:, columns] = B @ np.diff(c, order, axis=0) / step**order
        return found

    def covariance(self, time: Array) -> Array:
        """Return the covariances ``PAIRS`` of value, rate, and second rate at n times, shape (n, c, 6)."""
        return np.stack([curve.covariance(time) for curve in self.columns], axis=1)


def smooth_columns(
    time: Array,
    values: Array,
    noise_std: Array | None = None,
    least_std: Array | float = 0.0,
    cutoff: float | None = None,
    smoothness: Sequence[Smoothness] | None = None,
) -> SmoothCurves:
    """Smooth columns of samples without phase shift.

    Parameters
    ----------
    time : ndarray, shape (n,)
        Increasing times (s), at least 8.
    values : ndarray, shape (n, c)
        Samples, finite.
    noise_std : ndarray, shape (c,), optional
        Standard deviation of the noise of each column; NaN or None: estimated.
    least_std : ndarray, shape (c,), or float
        Smallest standard deviation, for example of rounding.
    cutoff : float, optional
        Frequency (Hz) at which the amplitude is halved; None: estimated.
    smoothness : sequence of Smoothness, length c, optional
        Known smoothness, for example from other rows; None: estimated.

    Returns
    -------
    SmoothCurves
        Curves with covariances.
    """
    if smoothness is None:
        smoothness = likeliest(time, values, noise_std, least_std, cutoff)
    samples: dict[float, _Samples] = {}
    curves = []
    for s, u, noise in zip(smoothness, values.T, _noises(values, noise_std, least_std), strict=True):
        if s.step not in samples:
            samples[s.step] = _Samples(time - time[0], s.step)
        curves.append(_Problem(samples[s.step], s.order, noise).curve(float(time[0]), u, s.log_weight))
    return SmoothCurves(tuple(curves))


def likeliest(
    time: Array,
    values: Array,
    noise_std: Array | None = None,
    least_std: Array | float = 0.0,
    cutoff: float | None = None,
) -> list[Smoothness]:
    """Estimate the smoothness of each column of samples; arguments as of ``smooth_columns``."""
    since = time - time[0]
    if cutoff is None:
        return [
            _likeliest(since, u - u.mean(), noise)
            for u, noise in zip(values.T, _noises(values, noise_std, least_std), strict=True)
        ]
    half, step = math.pi / _CELLS_PER_PERIOD, 1.0 / (_CELLS_PER_PERIOD * cutoff)
    # Frequency responses of the B-splines and of the differences at the cut-off frequency.
    splines, differences = (math.sin(half) / half) ** (DEGREE + 1), (2.0 * math.sin(half)) ** ORDERS[-1]
    weight = math.log(len(time) * step / float(since[-1])) + 2.0 * math.log(splines / differences)
    return [Smoothness(step, ORDERS[-1], weight)] * values.shape[1]


class _Noise(NamedTuple):
    """Known variance of the noise of a column, or NaN, and its smallest variance."""

    known: float
    least: float


def _noises(values: Array, noise_std: Array | None, least_std: Array | float) -> list[_Noise]:
    count = values.shape[1]
    known = np.full(count, np.nan) if noise_std is None else np.broadcast_to(noise_std, count) ** 2
    least = np.broadcast_to(least_std, count) ** 2 + 1e-28 * np.var(values, axis=0) + 1e-60
    return [_Noise(*pair) for pair in zip(known.tolist(), least.tolist(), strict=True)]


def inverse_band(factor: Array) -> Array:
    """Return the band of the inverse of a positive definite band matrix.

    Parameters
    ----------
    factor : ndarray, shape (w + 1, p)
        Upper Cholesky factor as returned by ``scipy.linalg.cholesky_banded``.

    Returns
    -------
    ndarray, shape (p, 6)
        Element [i, k] is the element (i, i + k) of the inverse, or 0 beyond its edge.

    Notes
    -----
    The inverse is the covariance of a Markov chain of blocks. Each block depends on the first w elements of
    the next one; the covariances follow from the last block to the first one.
    """
    width, size = len(factor) - 1, factor.shape[1]
    found, next_corner = np.zeros((size, DEGREE + 1)), np.zeros((width, width))
    for end in range(size, 0, -_BLOCK):
        start = max(end - _BLOCK, 0)
        count = end - start
        identity_and_next = np.eye(count, count + width)
        for k in range(min(width, size - end)):
            rows = min(width - k, count)
            identity_and_next[count - rows :, count + k] = factor[width - k - rows : width - k, end + k]
        solved, _ = dtbtrs(factor[:, start:end], identity_and_next)
        inverse, to_next = np.hsplit(solved, [count])
        next_columns = -to_next @ next_corner
        both = np.hstack([inverse @ inverse.T - next_columns @ to_next.T, next_columns])
        for k in range(DEGREE + 1):
            found[start:end, k] = both.diagonal(k)[:count]
        next_corner = both[:width, :width]
    return found


def _differences(size: int, order: int) -> sparse.csr_matrix:
    """Return the matrix of differences of an order of ``size`` numbers."""
    D = sparse.eye(size, format="csr")
    for k in range(order):
        shape = (size - k - 1, size - k)
        D = sparse.diags([-1.0, 1.0], [0, 1], shape=shape, format="csr") @ D
    return D


def _band(M: sparse.spmatrix, width: int) -> Array:
    """Return the upper band of a symmetric matrix in SciPy's layout."""
    band = np.zeros((width + 1, M.shape[0]))
    for k in range(width + 1):
        band[width - k, k:] = M.diagonal(k)
    return band


def _knots(step: float, size: int) -> Array:
    return np.asarray(step * np.arange(-DEGREE, size + 1.0))


class _Samples:
    """Times of samples on even knots: B-splines at the times, and their inner products."""

    def __init__(self, since: Array, step: float) -> None:
        self.count, self.step = len(since), step
        self.cells = max(1, math.ceil(float(since[-1]) / step * (1.0 - 1e-9)))
        self.size = self.cells + DEGREE
        t = np.minimum(since, step * self.cells * (1.0 - 1e-15))
        self.B = BSpline.design_matrix(t, _knots(step, self.size), DEGREE)
        self.gram = self.B.T @ self.B


class _Problem:
    """Least squares with a penalty for a column of samples with a noise."""

    def __init__(self, samples: _Samples, order: int, noise: _Noise) -> None:
        self.samples, self.order, self.noise, self.size = samples, order, noise, samples.size
        self.density = math.log(samples.count / samples.cells)
        self.D, width = _differences(self.size, order), max(DEGREE, order)
        self.gram, self.penalty = _band(samples.gram, width), _band(self.D.T @ self.D, width)

    def curve(self, start: float, values: Array, log_weight: float) -> SmoothCurve:
        """Return the curve through samples, with its covariance."""
        mean = values.mean()
        c, factor, squares = self.solve(values - mean, log_weight)
        variance = self.variance(squares)
        band = variance * inverse_band(factor)
        return SmoothCurve(
            start, self.samples.step, c + mean, math.sqrt(variance), band, self._factors(c, log_weight)
        )

    def _factors(self, c: Array, log_weight: float) -> Array:
        """Return the ratios of actual to posterior standard deviations, shape (3, p).

        The posterior variance is the noise that passes the filter, plus the expected bias. The bias is large
        where the penalized differences are large, such as at a jump of the jerk; it is small if the motion is
        smoother than the prior.
        """
        left = self.order // 2
        squares = np.pad((self.D @ c) ** 2, (left, self.order - left), mode="edge")
        period = 2.0 * math.pi * math.exp((log_weight - self.density) / (2 * self.order))
        local = uniform_filter1d(squares, min(max(3, round(period)), len(squares)), mode="nearest")
        bias = _BIAS[self.order] * local / max(float(np.mean(squares)), 1e-300)
        noise = 1.0 - (2.0 * np.arange(3)[:, None] + 1.0) / (2 * self.order)
        variance = noise + (1.0 - noise) * bias
        # Without samples there is no noise, but the whole uncertainty of the prior.
        empty = self.gram[-1] < _EMPTY * np.median(self.gram[-1])
        return np.asarray(np.sqrt(np.where(empty, np.maximum(variance, 1.0), variance)))

    def solve(self, u: Array, log_weight: float) -> tuple[Array, Array, float]:
        """Return the coefficients, the Cholesky factor, and the minimum of the penalized sum of squares."""
        B, weight = self.samples.B, math.exp(log_weight)
        normal = self.gram + weight * self.penalty
        normal[-1] += _ROUNDING * normal[-1].max() + _RIDGE * math.exp(self.density)
        factor = cholesky_banded(normal, check_finite=False)
        c = cho_solve_banded((factor, False), B.T @ u, check_finite=False)
        return c, factor, float(np.sum((u - B @ c) ** 2) + weight * np.sum((self.D @ c) ** 2))

    def variance(self, squares: float) -> float:
        """Return the variance of the noise, known or by the minimum of the sum of squares."""
        if not math.isnan(self.noise.known):
            return self.noise.known
        return max(squares / (self.samples.count - self.order), self.noise.least)

    def cost(self, u: Array, log_weight: float) -> float:
        """Return -2 times the restricted log likelihood."""
        try:
            _, factor, squares = self.solve(u, log_weight)
        except LinAlgError:
            return math.inf
        logdet = 2.0 * float(np.sum(np.log(factor[-1])))
        logdet -= (self.size - self.order) * log_weight + self._log_determinant()
        variance = self.variance(squares)
        return logdet + (self.samples.count - self.order) * math.log(variance) + squares / variance

    def best_tried(self, u: Array) -> tuple[float, float, float]:
        """Return the smallest cost of a few weights, the logarithm of its weight, and their distance."""
        heaviest = _CONDITION - self.order * math.log(4.0)
        tried = self.density + np.linspace(_LIGHTEST, heaviest, _TRIED_WEIGHTS)
        costs = [self.cost(u, log_weight) for log_weight in tried]
        i = int(np.argmin(costs))
        return costs[i], float(tried[i]), float(tried[1] - tried[0])

    def has_white_residuals(self, u: Array, log_weight: float) -> bool:
        """Return False if adjacent residuals are correlated, because the knots are too coarse."""
        residuals = u - self.samples.B @ self.solve(u, log_weight)[0]
        return float(residuals[1:] @ residuals[:-1]) <= _MOST_CORRELATED * float(residuals @ residuals)

    def _log_determinant(self) -> float:
        """Return the logarithm of the determinant of D D^T, a Toeplitz matrix, in closed form."""
        j, m, d = np.arange(self.order), self.size - self.order, self.order
        return float(
            np.sum(gammaln(j + 1) + gammaln(m + d + j + 1) - gammaln(d + j + 1) - gammaln(m + j + 1))
        )


def _likeliest(since: Array, u: Array, noise: _Noise) -> Smoothness:
    """Return the likeliest smoothness of a column, with knots as fine as necessary."""
    trial = min(len(since), _TRIAL_SAMPLES)
    step = float(since[-1]) * trial / len(since) / _FEWEST_CELLS
    first = _busiest(u, trial)
    t, u = since[first : first + trial] - since[first], u[first : first + trial]
    u = u - u.mean()
    while True:
        samples = _Samples(t, step)
        problems = [_Problem(samples, order, noise) for order in ORDERS]
        tried = [problem.best_tried(u) for problem in problems]
        best = tried.index(min(tried))
        fine = tried[best][1] > problems[best].density + _FINE
        if (fine and problems[best].has_white_residuals(u, tried[best][1])) or 2 * samples.cells > trial:
            break
        step /= 2.0
    refined = []
    for problem, (_, log_weight, distance) in zip(problems, tried, strict=True):
        bounds = log_weight - distance, log_weight + distance
        options = {"bounds": bounds, "method": "bounded", "options": {"xatol": 0.1}}
        found = minimize_scalar(partial(problem.cost, u), **options)
        refined.append((float(found.fun), problem.order, float(found.x)))
    _, order, log_weight = min(refined)
    return Smoothness(step, order, log_weight)


def _busiest(u: Array, trial: int) -> int:
    """Return the index of the first of ``trial`` samples with the largest change of rate."""
    size = max(1, trial // _TRIAL_BLOCKS)
    blocks = u[: len(u) // size * size].reshape(-1, size).mean(axis=1)
    changes = np.concatenate([[0.0], np.cumsum(np.diff(blocks, 2) ** 2)])
    span = min(_TRIAL_BLOCKS - 2, len(changes) - 1)
    return min(size * int(np.argmax(changes[span:] - changes[: len(changes) - span])), len(u) - trial)
