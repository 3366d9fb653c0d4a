"""Smoothing splines whose smoothness is estimated from the samples, with the covariance of the result.

A curve is a spline of degree 5 on even knots. It minimizes the squared residuals plus a penalty, the weighted
squared differences of its coefficients (P-spline, Eilers and Marx 1996). The penalty is the prior of a
Gaussian model, therefore the weight and the noise are estimated by restricted maximum likelihood, and the
curve has a posterior covariance. Rows that are left out need no special treatment: the curve bridges them,
and the covariance increases there.
"""

import functools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from scipy.interpolate import BSpline
from scipy.linalg import LinAlgError, cho_solve_banded, cholesky_banded
from scipy.linalg.lapack import dtbtrs
from scipy.ndimage import maximum_filter1d, uniform_filter1d
from scipy.optimize import minimize_scalar
from scipy.special import gammaln

from ..io.array_types import Array, Flags

DEGREE = 5
ORDERS = (3, 4, 7)
"""Orders of the differences in the penalty; the likeliest one is used.

With order 8 instead of 7, three of about 90 random logs had 1.3 to 1.6 times the errors, mostly at the ends.
"""
# Largest additional cost of the lowest order, which models jumps of the acceleration, and rows that add 1.
# Without it, errors of minimum-jerk motions with 3 decimals are 1.1 times as large.
_EVIDENCE, _ROWS = 20.0, 50.0
# Mean square of the bias relative to its expectation, by order, adjusted by hand to 48 random motions: sines,
# minimum jerk, and trapezoids, with 3, 4, and 5 decimals or white noise.
_BIAS = {3: 0.7, 4: 0.7, 7: 0.1}
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
# Largest number of rows for each independent error of rounding, and smallest number of such errors.
_MOST_ROWS, _FEWEST_ERRORS = 64, 64
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
    """B-splines of degree 5 on even knots from ``start`` (s), with their posterior covariance.

    ``band`` contains the covariance of each coefficient with itself and the five next ones, (p, 6), and
    ``factors`` the ratio of actual to posterior standard deviations of values, rates, and second rates,
    (3, p). ``values`` are the values at the samples, (n,).
    """

    start: float
    step: float
    coefficients: Array
    noise_std: float
    band: Array
    factors: Array
    values: Array

    @property
    def knots(self) -> Array:
        """Times of the knots in the range of the samples (s)."""
        return np.asarray(self.start + self.step * np.arange(len(self.coefficients) - DEGREE + 1.0))

    def covariance(self, time: Array, pairs: Sequence[tuple[int, int]] = PAIRS) -> Array:
        """Return the covariances of derivatives of orders ``pairs`` at n times, shape (n, len(pairs))."""
        size = len(self.coefficients)
        since = np.clip((time - self.start) / self.step, 0.0, (size - DEGREE) * (1.0 - 1e-15))
        cells, offsets = since.astype(int), np.arange(DEGREE + 1)
        first = cells[:, None, None] + np.minimum.outer(offsets, offsets)
        C = self.band[first, np.abs(np.subtract.outer(offsets, offsets))]
        near = BSpline(_all_knots(1.0, DEGREE + 1), np.eye(DEGREE + 1), DEGREE)
        rows = [
            near(since - cells, order)
            / self.step**order
            * np.interp(since, np.arange(size) - DEGREE // 2, factors)[:, None]
            for order, factors in enumerate(self.factors)
        ]
        products = [np.einsum("np,npq,nq->n", rows[i], C, rows[k], optimize=True) for i, k in pairs]
        return np.stack(products, axis=-1)


class Smoother:
    """Columns of samples (n, c) at n increasing times (s), smoothed without phase shift.

    Unknown standard deviations of the noise are None or NaN; then they are estimated, and not smaller than
    ``least_std``, for example of rounding. ``cutoff`` is the frequency (Hz) at which the amplitude is halved.
    """

    def __init__(
        self,
        time: Array,
        values: Array,
        noise_std: Array | None = None,
        least_std: Array | float = 0.0,
        cutoff: float | None = None,
    ) -> None:
        self.time, self.since, self.cutoff = time, time - time[0], cutoff
        self.values = np.asfortranarray(values)
        known = np.full(values.shape[1], np.nan) if noise_std is None else np.asarray(noise_std) ** 2
        least = np.asarray(least_std) ** 2 + 1e-28 * np.var(values, axis=0) + 1e-60
        # Known variance of each column, or NaN, and the smallest one.
        self.variances = np.stack(np.broadcast_arrays(known, least), axis=-1)
        self._splines = functools.cache(functools.partial(_design_matrix, self.since))

    def curves(self, smoothness: Sequence[Smoothness], used: Flags | None = None) -> list[SmoothCurve]:
        """Return the curves of a smoothness through the used rows."""
        rows = slice(None) if used is None or used.all() else used
        grids = {step: _Grid(self._splines(step)[rows], step) for step in {each.step for each in smoothness}}
        found = []
        for (step, order, weight, count), u, variances in zip(
            smoothness, self.values.T, self.variances, strict=True
        ):
            mean = float(u[rows].mean())
            column = _Column(grids[step], u[rows] - mean, *variances)
            c, _, squares = column.solve(order, weight)
            variance = column.variance(order, squares)
            band = count * variance * _inverse_band(column.grid.factor(order, weight)[0])
            factors, values = column.factors(c, order, weight), self._splines(step) @ c + mean
            start, noise_std = float(self.time[0]), math.sqrt(variance)
            found.append(SmoothCurve(start, step, c + mean, noise_std, band, factors, values))
        return found

    def likeliest(self, used: Flags | None = None) -> list[Smoothness]:
        """Estimate the smoothness of each column by the used rows."""
        rows = slice(None) if used is None else used
        since, values = self.since[rows], self.values[rows]
        span = float(since[-1] - since[0])
        if self.cutoff is not None:
            half, step = math.pi / _CELLS_PER_PERIOD, 1.0 / (_CELLS_PER_PERIOD * self.cutoff)
            # Frequency responses of the B-splines and of the differences at the cut-off frequency.
            splines, differences = (
                (math.sin(half) / half) ** (DEGREE + 1),
                (2.0 * math.sin(half)) ** ORDERS[-1],
            )
            weight = math.log(len(since) * step / span) + 2.0 * math.log(splines / differences)
            return [Smoothness(step, ORDERS[-1], weight)] * values.shape[1]

        @functools.cache
        def grid(first: int, end: int, every: int, cells: int) -> _Grid:
            step = span * (end - first) / len(since) / cells
            return _Grid(_design_matrix(since[first:end:every] - since[first], step), step)

        found = []
        for u, variances in zip(values.T, self.variances, strict=True):
            every = _rows_for_each_error(u, math.sqrt(variances[1]))
            trial = min(len(since) // every, _TRIAL_SAMPLES)
            first = _busiest(u, trial * every)
            end, cells = first + trial * every, _FEWEST_CELLS
            some = u[first:end:every] - u[first:end:every].mean()
            while (best := _Column(grid(first, end, every, cells), some, *variances).likeliest()) is None:
                cells *= 2
            found.append(best._replace(rows=every, log_weight=best.log_weight + math.log(every)))
        return found

    def derivatives(self, curves: Sequence[SmoothCurve]) -> Array:
        """Return values, rates, and second rates of the curves at the samples, (3, n, c)."""
        found = np.stack([np.stack([curve.values for curve in curves], axis=-1)] * 3)
        # Columns with the same knots are evaluated together, which is faster.
        for step in {curve.step for curve in curves}:
            columns = [i for i, curve in enumerate(curves) if curve.step == step]
            c = np.stack([curves[i].coefficients for i in columns], axis=-1)
            spline = BSpline(_all_knots(step, len(c)), c, DEGREE)
            inside = np.minimum(self.since, step * (len(c) - DEGREE) * (1.0 - 1e-15))
            for order in (1, 2):
                found[order][:, columns] = spline(inside, order)
        return found


def _inverse_band(factor: Array) -> Array:
    """Return the band of the inverse of a positive definite band matrix: elements (i, i + k), (p, 6).

    The inverse is the covariance of a Markov chain of blocks. Each block depends on the first elements of the
    next one; the covariances follow from the last block to the first one. ``factor`` is the upper Cholesky
    factor of ``scipy.linalg.cholesky_banded``.
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


def _all_knots(step: float, size: int) -> Array:
    """Return the times (s) of all knots of ``size`` B-splines, also outside of the samples."""
    return np.asarray(step * np.arange(-DEGREE, size + 1.0))


def _design_matrix(since: Array, step: float) -> Any:
    """Return the values of all B-splines at times from 0 (s), a sparse matrix (n, p)."""
    cells = max(1, math.ceil(float(since[-1]) / step * (1.0 - 1e-9)))
    inside = np.minimum(since, step * cells * (1.0 - 1e-15))
    return BSpline.design_matrix(inside, _all_knots(step, cells + DEGREE), DEGREE)


class _Grid:
    """B-splines at the times of samples, and the penalties of their differences."""

    def __init__(self, B: Any, step: float) -> None:
        (self.count, self.size), self.B, self.step = B.shape, B, step
        self.cells = self.size - DEGREE
        self.density = math.log(self.count / self.cells)
        product, self.gram = B.T @ B, np.zeros((ORDERS[-1] + 1, self.size))
        for k in range(DEGREE + 1):
            self.gram[ORDERS[-1] - k, k:] = product.diagonal(k)
        self._factors: dict[tuple[int, float], tuple[Array, float]] = {}

    def factor(self, order: int, log_weight: float) -> tuple[Array, float]:
        """Return the Cholesky factor of the matrix of least squares, and the cost of its determinant."""
        if (order, log_weight) in self._factors:
            return self._factors[order, log_weight]
        width, count = max(DEGREE, order), self.size - order
        difference, penalty = np.diff(np.pad([1.0], order), order), np.zeros((width + 1, self.size))
        for i in range(order + 1):
            for k in range(i, order + 1):
                penalty[width - (k - i), k : k + count] += difference[i] * difference[k]
        matrix = self.gram[-width - 1 :] + math.exp(log_weight) * penalty
        matrix[-1] += _ROUNDING * matrix[-1].max() + _RIDGE * math.exp(self.density)
        factor = cholesky_banded(matrix, overwrite_ab=True, check_finite=False)
        # Logarithm of the determinant of D D^T, a Toeplitz matrix, in closed form.
        j = np.arange(order)
        determinant = np.sum(gammaln(j + 1) + gammaln(count + order + j + 1))
        determinant -= np.sum(gammaln(order + j + 1) + gammaln(count + j + 1))
        cost = float(2.0 * np.sum(np.log(factor[-1])) - count * log_weight - determinant)
        self._factors[order, log_weight] = factor, cost
        return factor, cost


class _Column:
    """Least squares of a column of samples (n,).

    The variance of its noise is known, or NaN and at least ``least``.
    """

    def __init__(self, grid: _Grid, u: Array, known: float, least: float) -> None:
        self.grid, self.u, self.known, self.least = grid, u, known, least
        self.product = grid.B.T @ u

    def solve(self, order: int, log_weight: float) -> tuple[Array, Array, float]:
        """Return coefficients, residuals, and the minimum of the penalized sum of squares."""
        factor = self.grid.factor(order, log_weight)[0]
        c = cho_solve_banded((factor, False), self.product, check_finite=False)
        residuals = self.u - self.grid.B @ c
        penalty = math.exp(log_weight) * float(np.sum(np.diff(c, order) ** 2))
        return c, residuals, float(residuals @ residuals) + penalty

    def variance(self, order: int, squares: float) -> float:
        """Return the variance of the noise, known or estimated."""
        estimate = max(squares / (self.grid.count - order), self.least)
        return float(estimate if math.isnan(self.known) else self.known)

    def cost(self, order: int, log_weight: float) -> float:
        """Return -2 times the restricted log likelihood."""
        try:
            squares = self.solve(order, log_weight)[2]
        except LinAlgError:
            return math.inf
        variance = self.variance(order, squares)
        free = self.grid.count - order
        cost = min(_EVIDENCE, self.grid.count / _ROWS) if order == ORDERS[0] else 0.0
        cost += self.grid.factor(order, log_weight)[1] + free * math.log(variance) + squares / variance
        return float(cost)

    def likeliest(self) -> Smoothness | None:
        """Return the likeliest smoothness; None if it requires finer knots."""
        grid, heaviest = self.grid, _CONDITION - np.array(ORDERS) * math.log(4.0)
        weights = grid.density + np.linspace(_LIGHTEST, heaviest, _TRIED_WEIGHTS)
        tried = dict(zip(ORDERS, weights.T, strict=True))
        best = {order: min((self.cost(order, x), x) for x in tried[order].tolist()) for order in ORDERS}
        order = min(ORDERS, key=lambda order: best[order])
        if 2 * grid.cells <= grid.count and not self._has_fine_knots(order, best[order][1]):
            return None
        refined = [self._refined(order, best[order][1], np.ptp(tried[order][:2])) for order in ORDERS]
        return Smoothness(grid.step, *min(refined)[1:])

    def _refined(self, order: int, log_weight: float, distance: float) -> tuple[float, int, float]:
        """Return cost, order, and logarithm of the best weight near a tried one."""
        bounds = log_weight - distance, log_weight + distance
        options = {"bounds": bounds, "method": "bounded", "options": {"xatol": 0.1}}
        found = minimize_scalar(lambda x: self.cost(order, float(x)), **options)
        return float(found.fun), order, float(found.x)

    def _has_fine_knots(self, order: int, log_weight: float) -> bool:
        """Return False for a light penalty or correlated adjacent residuals, because knots are too coarse."""
        if log_weight <= self.grid.density + _FINE:
            return False
        residuals = self.solve(order, log_weight)[1]
        return float(residuals[1:] @ residuals[:-1]) <= _MOST_CORRELATED * float(residuals @ residuals)

    def factors(self, c: Array, order: int, log_weight: float) -> Array:
        """Return the ratios of actual to posterior standard deviations, shape (3, p).

        The posterior variance is the noise that passes the filter, plus the expected bias. The bias increases
        with the penalized differences, for example at a jump of the jerk.
        """
        left = order // 2
        squares = np.pad(np.diff(c, order) ** 2, (left, order - left), mode="edge")
        # Cells per period of the fastest motion that the curve follows.
        period = 2.0 * math.pi * math.exp((log_weight - self.grid.density) / (2 * order))
        size = min(max(3, round(period)), len(squares))
        local = uniform_filter1d(squares, size, mode="nearest")
        bias = _BIAS[order] * local / max(float(np.mean(squares)), 1e-300)
        noise = 1.0 - (2.0 * np.arange(3)[:, None] + 1.0) / (2 * order)
        variance = noise + (1.0 - noise) * bias
        # Near the ends, and near places without samples, the bias has the whole variance of the prior.
        empty = self.grid.gram[-1] < _EMPTY * np.median(self.grid.gram[-1])
        near = maximum_filter1d(empty, size)
        return np.asarray(np.sqrt(np.where(near, np.maximum(variance, 1.0), variance)))


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
