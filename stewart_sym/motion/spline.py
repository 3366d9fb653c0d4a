"""Smoothing splines whose smoothness is estimated from the samples, with the covariance of the result.

A curve is a spline of degree 5 on even knots. It minimizes the squared residuals plus a penalty, the weighted
squared differences of its coefficients (P-spline, Eilers and Marx 1996). The penalty is the prior of a
Gaussian model, therefore the weight and the noise are estimated by restricted maximum likelihood, and the
curve has a posterior covariance. Rows that are left out need no special treatment: the curve bridges them,
and the covariance increases there.
"""

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.polynomial.polynomial import polyder
from scipy import sparse
from scipy.interpolate import BSpline
from scipy.linalg import LinAlgError, cho_solve_banded, cholesky_banded, solveh_banded
from scipy.linalg.lapack import dtbtrs
from scipy.ndimage import maximum_filter1d, uniform_filter1d
from scipy.optimize import minimize_scalar
from scipy.special import gammaln

from ..io.array_types import Array, Indices

DEGREE = 5
ORDERS = (3, 4, 7)
"""Orders of the differences in the penalty; the likeliest one is used.

With order 8 instead of 7, three of about 90 random logs had 1.3 to 1.6 times the errors, mostly at the ends.
"""
# Mean square of the bias relative to its expectation, by order, adjusted by hand to 48 random motions: sines,
# minimum jerk, and trapezoids, with 3, 4, and 5 decimals or white noise.
_BIAS = {3: 0.7, 4: 0.7, 7: 0.1}
# A coefficient with less than this fraction of the usual number of samples is in a gap.
_EMPTY = 0.1
# Coefficients of powers of the fraction of a cell, for each of the six B-splines on the cell.
_SPLINES = BSpline(np.arange(-DEGREE, DEGREE + 2.0), np.eye(DEGREE + 1), DEGREE)
_POLYNOMIALS = np.array([_SPLINES(0.0, power) / math.factorial(power) for power in range(DEGREE + 1)])
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
# Largest number of rows for each independent error of rounding, and smallest number of such errors.
_MOST_ROWS, _FEWEST_ERRORS = 64, 64
_CHUNK = 1 << 14
_BLOCK = 64
# Parts of the largest diagonal element and of the samples per cell that keep a matrix definite in gaps.
_ROUNDING, _RIDGE = 4e-16, 1e-11


class Smoothness(NamedTuple):
    """Distance of knots (s), order and logarithm of the weight of the penalty, and rows for each error.

    Rounding errors of adjacent rows are nearly equal if the motion is slower than a step of rounding per
    row. Then several rows contain one independent error.
    """

    step: float
    order: int
    log_weight: float
    rows: int = 1


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
        size = len(self.coefficients)
        centers = self.step * (np.arange(size) - DEGREE // 2)
        for part in (slice(i, i + _CHUNK) for i in range(0, len(time), _CHUNK)):
            since = self.since(time[part])
            C = self.band[_cells(since, self.step, size)[:, None, None] + low, distance]
            rows = [
                _weights(since, self.step, size, order) * np.interp(since, centers, f)[:, None]
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
        """Return values, rates, and second rates, or fewer orders, at n times, shape (orders, n, c)."""
        found = np.empty((orders, len(time), len(self.columns)))
        steps = np.array([curve.step for curve in self.columns])
        for step in np.unique(steps):
            columns = np.flatnonzero(steps == step)
            since = self.columns[columns[0]].since(time)
            c = np.stack([self.columns[column].coefficients for column in columns], axis=-1)
            for order in range(orders):
                found[order][:, columns] = _matrix(since, float(step), len(c), order) @ c
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
    noise, mean = _noise(values, noise_std, least_std), values.mean(axis=0)
    curves: dict[int, SmoothCurve] = {}
    for step in {each.step for each in smoothness}:
        columns = [k for k, each in enumerate(smoothness) if each.step == step]
        samples = _Samples(time - time[0], values[:, columns] - mean[columns], step, noise.of(columns))
        for i, k in enumerate(columns):
            problem = _Problem(samples, smoothness[k].order)
            curves[k] = problem.curve(i, smoothness[k], float(time[0]), float(mean[k]))
    return SmoothCurves(tuple(curves[k] for k in range(len(smoothness))))


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
        noise = _noise(values, noise_std, least_std)
        found: dict[int, Smoothness] = {}
        rows = [_rows_for_each_error(u, std) for u, std in zip(values.T, np.sqrt(noise.least), strict=True)]
        trials = [min(len(since) // each, _TRIAL_SAMPLES) for each in rows]
        firsts = [_busiest(u, n * each) for u, n, each in zip(values.T, trials, rows, strict=True)]
        for first, every, trial in set(zip(firsts, rows, trials, strict=True)):
            columns = [k for k, each in enumerate(zip(firsts, rows, strict=True)) if each == (first, every)]
            some = slice(first, first + trial * every, every)
            t, u = since[some] - since[first], values[some, columns]
            step = float(since[-1]) * trial * every / len(since) / _FEWEST_CELLS
            each = _likeliest(t, u - u.mean(axis=0), noise.of(columns), step)
            found |= {
                k: one._replace(rows=every, log_weight=one.log_weight + math.log(every))
                for k, one in zip(columns, each, strict=True)
            }
        return [found[k] for k in range(values.shape[1])]
    half, step = math.pi / _CELLS_PER_PERIOD, 1.0 / (_CELLS_PER_PERIOD * cutoff)
    # Frequency responses of the B-splines and of the differences at the cut-off frequency.
    splines, differences = (math.sin(half) / half) ** (DEGREE + 1), (2.0 * math.sin(half)) ** ORDERS[-1]
    weight = math.log(len(time) * step / float(since[-1])) + 2.0 * math.log(splines / differences)
    return [Smoothness(step, ORDERS[-1], weight)] * values.shape[1]


class _Noise(NamedTuple):
    """Known variances of the noise of columns, or NaN, and smallest variances."""

    known: Array
    least: Array

    def of(self, columns: Sequence[int]) -> "_Noise":
        """Return the variances of some columns."""
        return _Noise(self.known[columns], self.least[columns])

    def variances(self, mean_squares: Array) -> Array:
        """Return the variances, known or estimated by the mean squares of residuals."""
        return np.where(np.isnan(self.known), np.maximum(mean_squares, self.least), self.known)


def _noise(values: Array, noise_std: Array | None, least_std: Array | float) -> _Noise:
    count = values.shape[1]
    known = np.full(count, np.nan) if noise_std is None else np.broadcast_to(noise_std, count) ** 2
    return _Noise(known, np.broadcast_to(least_std, count) ** 2 + 1e-28 * np.var(values, axis=0) + 1e-60)


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


def _cells(since: Array, step: float, size: int) -> Indices:
    """Return the indices of the cells between knots that contain times (s) since the first knot."""
    return np.asarray(np.minimum((since / step).astype(int), size - DEGREE - 1))


def _weights(since: Array, step: float, size: int, order: int = 0) -> Array:
    """Return a derivative of the six B-splines that are not zero at each time, shape (n, 6)."""
    fraction = since / step - _cells(since, step, size)
    powers = np.vander(fraction, DEGREE + 1 - order, increasing=True)
    return np.asarray(powers @ polyder(_POLYNOMIALS, order) / step**order)


def _matrix(since: Array, step: float, size: int, order: int = 0) -> sparse.csr_matrix:
    """Return a derivative of all B-splines at each time, shape (n, size)."""
    count, width = len(since), DEGREE + 1
    indices = (_cells(since, step, size)[:, None] + np.arange(width)).astype(np.int32)
    ends = np.arange(0, width * count + 1, width, dtype=np.int32)
    weights = _weights(since, step, size, order)
    return sparse.csr_matrix((weights.ravel(), indices.ravel(), ends), shape=(count, size))


class _Samples:
    """Columns of samples (n, c) on even knots.

    Sums of squared residuals are quadratic functions of the difference from ``center``, the coefficients of
    least squares. Therefore many weights are tried without all samples.
    """

    def __init__(self, since: Array, values: Array, step: float, noise: _Noise) -> None:
        self.count, self.step, self.values, self.noise = len(since), step, values, noise
        self.cells = max(1, math.ceil(float(since[-1]) / step * (1.0 - 1e-9)))
        self.size, self.density = self.cells + DEGREE, math.log(self.count / self.cells)
        self.B = _matrix(since, step, self.size)
        gram, self.products = self.B.T @ self.B, self.B.T @ values
        self.gram = np.zeros((ORDERS[-1] + 1, self.size))
        for k in range(DEGREE + 1):
            self.gram[ORDERS[-1] - k, k:] = gram.diagonal(k)
        self.center = solveh_banded(self.definite(self.gram[-DEGREE - 1 :]), self.products)
        residuals = values - self.B @ self.center
        self.least_squares, self.gradient = np.sum(residuals**2, axis=0), self.B.T @ residuals

    def definite(self, band: Array) -> Array:
        """Return a band that is positive definite in gaps."""
        band = band.copy()
        band[-1] += _ROUNDING * band[-1].max() + _RIDGE * math.exp(self.density)
        return band

    def squares(self, c: Array, columns: slice) -> Array:
        """Return the sum of the squared residuals of each column with coefficients c, (p, c)."""
        d = self.center[:, columns] - c
        found = self.least_squares[columns] + 2.0 * np.sum(d * self.gradient[:, columns], axis=0)
        found += self.gram[-1] @ d**2
        for k in range(1, DEGREE + 1):
            found += 2.0 * (self.gram[-1 - k, k:] @ (d[k:] * d[:-k]))
        return np.asarray(found)


class _Problem:
    """Least squares of columns of samples with a penalty on differences of an order."""

    def __init__(self, samples: _Samples, order: int) -> None:
        self.samples, self.order, self.size = samples, order, samples.size
        width, count = max(DEGREE, order), samples.size - order
        self.gram, self.penalty = samples.gram[-width - 1 :], np.zeros((width + 1, samples.size))
        difference = np.diff(np.pad([1.0], order), order)
        for i, k in itertools.combinations_with_replacement(range(order + 1), 2):
            self.penalty[width - (k - i), k : k + count] += difference[i] * difference[k]
        # Logarithm of the determinant of D D^T, a Toeplitz matrix, in closed form.
        j = np.arange(order)
        self.log_determinant = float(
            np.sum(gammaln(j + 1) + gammaln(count + order + j + 1))
            - np.sum(gammaln(order + j + 1) + gammaln(count + j + 1))
        )
        heaviest = _CONDITION - order * math.log(4.0)
        self.tried = samples.density + np.linspace(_LIGHTEST, heaviest, _TRIED_WEIGHTS)

    def solve(self, log_weight: float, columns: slice) -> tuple[Array, Array, Array]:
        """Return coefficients, the Cholesky factor, and the minima of the penalized sums of squares."""
        weight = math.exp(log_weight)
        factor = cholesky_banded(
            self.samples.definite(self.gram + weight * self.penalty), overwrite_ab=True, check_finite=False
        )
        c = cho_solve_banded((factor, False), self.samples.products[:, columns], check_finite=False)
        penalty = np.sum(np.diff(c, self.order, axis=0) ** 2, axis=0)
        return c, factor, self.samples.squares(c, columns) + weight * penalty

    def costs(self, log_weight: float, columns: slice = slice(None)) -> Array:
        """Return -2 times the restricted log likelihood of each column."""
        try:
            _, factor, squares = self.solve(log_weight, columns)
        except LinAlgError:
            return np.full(self.samples.products[:1, columns].size, np.inf)
        logdet = 2.0 * float(np.sum(np.log(factor[-1])))
        logdet -= (self.size - self.order) * log_weight + self.log_determinant
        free = self.samples.count - self.order
        variances = _Noise(*(each[columns] for each in self.samples.noise)).variances(squares / free)
        return np.asarray(logdet + free * np.log(variances) + squares / variances)

    def refined(self, column: int, log_weight: float) -> tuple[float, int, float]:
        """Return cost, order, and logarithm of the best weight near a tried one."""
        distance, only = self.tried[1] - self.tried[0], slice(column, column + 1)
        found = minimize_scalar(
            lambda x: float(self.costs(x, only)[0]),
            bounds=(log_weight - distance, log_weight + distance),
            method="bounded",
            options={"xatol": 0.1},
        )
        return float(found.fun), self.order, float(found.x)

    def has_white_residuals(self, column: int, log_weight: float) -> bool:
        """Return False if adjacent residuals are correlated, because the knots are too coarse."""
        only = slice(column, column + 1)
        residuals = (self.samples.values[:, only] - self.samples.B @ self.solve(log_weight, only)[0])[:, 0]
        return float(residuals[1:] @ residuals[:-1]) <= _MOST_CORRELATED * float(residuals @ residuals)

    def curve(self, column: int, smoothness: Smoothness, start: float, mean: float) -> SmoothCurve:
        """Return the curve through the samples of a column, with its covariance."""
        only = slice(column, column + 1)
        c, factor, squares = self.solve(smoothness.log_weight, only)
        noise = self.samples.noise.of([column])
        variance = float(noise.variances(squares / (self.samples.count - self.order))[0])
        band = smoothness.rows * variance * inverse_band(factor)
        factors = self._factors(c[:, 0], smoothness.log_weight)
        return SmoothCurve(start, self.samples.step, c[:, 0] + mean, math.sqrt(variance), band, factors)

    def _factors(self, c: Array, log_weight: float) -> Array:
        """Return the ratios of actual to posterior standard deviations, shape (3, p).

        The posterior variance is the noise that passes the filter, plus the expected bias. The bias is large
        where the penalized differences are large, such as at a jump of the jerk; it is small if the motion is
        smoother than the prior.
        """
        left = self.order // 2
        squares = np.pad(np.diff(c, self.order) ** 2, (left, self.order - left), mode="edge")
        period = 2.0 * math.pi * math.exp((log_weight - self.samples.density) / (2 * self.order))
        size = min(max(3, round(period)), len(squares))
        local = uniform_filter1d(squares, size, mode="nearest")
        bias = _BIAS[self.order] * local / max(float(np.mean(squares)), 1e-300)
        noise = 1.0 - (2.0 * np.arange(3)[:, None] + 1.0) / (2 * self.order)
        variance = noise + (1.0 - noise) * bias
        # Near the ends, and near places without samples, the bias has the whole variance of the prior.
        empty = self.gram[-1] < _EMPTY * np.median(self.gram[-1])
        near = maximum_filter1d(empty, size)
        return np.asarray(np.sqrt(np.where(near, np.maximum(variance, 1.0), variance)))


def _likeliest(since: Array, values: Array, noise: _Noise, step: float) -> list[Smoothness]:
    """Return the likeliest smoothness of each column, with knots as fine as necessary."""
    found: dict[int, Smoothness] = {}
    while len(found) < values.shape[1]:
        missing = [k for k in range(values.shape[1]) if k not in found]
        samples = _Samples(since, values[:, missing], step, noise.of(missing))
        problems = [_Problem(samples, order) for order in ORDERS]
        costs = np.array([[problem.costs(x) for x in problem.tried] for problem in problems])
        for i, k in enumerate(missing):
            own = costs[..., i]
            best = [float(problem.tried[j]) for problem, j in zip(problems, own.argmin(axis=1), strict=True)]
            order = int(own.min(axis=1).argmin())
            fine = best[order] > samples.density + _FINE
            fine = fine and problems[order].has_white_residuals(i, best[order])
            if fine or 2 * samples.cells > samples.count:
                refined = [problem.refined(i, x) for problem, x in zip(problems, best, strict=True)]
                found[k] = Smoothness(step, *min(refined)[1:])
        step /= 2.0
    return [found[k] for k in range(values.shape[1])]


def _rows_for_each_error(u: Array, rounding: float) -> int:
    """Return the number of rows, a power of 2, in which a moving column changes by a step of rounding.

    Noise also changes a column, and makes rounding errors of adjacent rows independent.
    """
    count = _MOST_ROWS * ((len(u) - 1) // _MOST_ROWS)
    speeds = np.abs(np.diff(u[: count + 1 : _MOST_ROWS])) / _MOST_ROWS
    usual = float(np.sum(speeds**2) / max(float(np.sum(speeds)), 1e-300))
    change = max(usual, float(np.mean(np.abs(np.diff(u)))), 1e-300)
    rows = min(math.sqrt(12.0) * rounding / change, len(u) / _FEWEST_ERRORS)
    return int(2 ** min(max(round(math.log2(max(rows, 1.0))), 0), round(math.log2(_MOST_ROWS))))


def _busiest(u: Array, trial: int) -> int:
    """Return the index of the first of ``trial`` samples with the largest change of rate."""
    size = max(1, trial // _TRIAL_BLOCKS)
    blocks = u[: len(u) // size * size].reshape(-1, size).mean(axis=1)
    changes = np.concatenate([[0.0], np.cumsum(np.diff(blocks, 2) ** 2)])
    span = min(_TRIAL_BLOCKS - 2, len(changes) - 1)
    return min(size * int(np.argmax(changes[span:] - changes[: len(changes) - span])), len(u) - trial)
