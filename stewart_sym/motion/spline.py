"""Smoothing splines whose smoothness is estimated from the samples, with the covariance of the result.

A curve is a spline of degree 5 on even knots. It minimizes the squared residuals plus a penalty, the weighted
squared differences of its coefficients (P-spline, Eilers and Marx 1996). The penalty is the prior of a
Gaussian model, therefore the weight and the noise are estimated by restricted maximum likelihood, and the
curve has a posterior covariance. Rows that are left out need no special treatment: the curve bridges them,
and the covariance increases there.
"""

import itertools
import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy import sparse
from scipy.interpolate import BSpline
from scipy.linalg import cho_solve_banded, cholesky_banded
from scipy.optimize import minimize_scalar
from scipy.special import gammaln

from ..io.array_types import Array

DEGREE = 5
ORDERS = (4, 6, 8)
"""Orders of the differences in the penalty; the likelier one is used."""
PAIRS = ((0, 0), (1, 0), (1, 1), (2, 0), (2, 1), (2, 2))
"""Orders of the derivatives to which the components of a covariance belong."""
# Range and number of the logarithms of weights among which the search for the best one starts.
_WEIGHTS = np.linspace(-16.0, 22.0, 12)
# The knots are fine enough if the logarithm of the penalty's weight relative to the samples is at least this.
_PENALTY_DOMINATES = 6.0
_FEWEST_CELLS = 32
# Number of samples in the middle of a long log from which its knots and weights are estimated.
_TRIAL_SAMPLES = 8192
# Number of cells per period of the cut-off frequency.
_CELLS_PER_PERIOD = 8.0
_CHUNK = 1 << 14
_BLOCK = 48


@dataclass(frozen=True, eq=False)
class SmoothCurve:
    """Columns of samples as curves over time, with the covariance of their values and derivatives.

    Attributes
    ----------
    start, step : float
        Time of the first knot (s) and distance between knots (s).
    coefficients : ndarray, shape (p, c)
        B-spline coefficients of the columns.
    noise_std : ndarray, shape (c,)
        Standard deviation of the noise of each column.
    bands : ndarray, shape (c, p, 6)
        Covariance of each coefficient with itself and the five next ones.
    """

    start: float
    step: float
    coefficients: Array
    noise_std: Array
    bands: Array

    def evaluate(self, time: Array) -> Array:
        """Return values, rates, and second rates at n times, shape (3, n, c)."""
        found = np.empty((3, len(time), self.coefficients.shape[1]))
        for part in _parts(len(time)):
            for order, rows in enumerate(self._rows(time[part])):
                found[order, part] = rows @ self.coefficients
        return found

    def covariance(self, time: Array) -> Array:
        """Return the covariances ``PAIRS`` of value, rate, and second rate at n times, shape (n, c, 6)."""
        found = np.empty((len(time), len(self.bands), len(PAIRS)))
        offsets = np.arange(DEGREE + 1)
        low = np.minimum.outer(offsets, offsets)
        distance = np.abs(np.subtract.outer(offsets, offsets))
        for part in _parts(len(time)):
            cell, weights = _local_rows(self._rows(time[part]))
            for column, band in enumerate(self.bands):
                C = band[cell[:, None, None] + low, distance]
                for k, (i, j) in enumerate(PAIRS):
                    found[part, column, k] = np.einsum("np,npq,nq->n", weights[i], C, weights[j])
        return found

    def _rows(self, time: Array) -> list[sparse.csr_matrix]:
        return _design(time - self.start, self.step, len(self.coefficients) - DEGREE)


class Smoothness(NamedTuple):
    """Distance of knots (s), order of the penalty, and logarithms of its weights, shape (c,)."""

    step: float
    order: int
    weights: Array


def smooth_columns(
    time: Array,
    values: Array,
    noise_std: Array | None = None,
    least_std: Array | float = 0.0,
    cutoff: float | None = None,
    smoothness: Smoothness | None = None,
) -> SmoothCurve:
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
        Smallest standard deviation, such as that of rounding.
    cutoff : float, optional
        Frequency (Hz) at which the amplitude is halved; None: estimated.
    smoothness : Smoothness, optional
        Known smoothness, for example from other rows; None: estimated.

    Returns
    -------
    SmoothCurve
        Curves with covariances.
    """
    u = _scaled(time, values, noise_std, least_std)
    if smoothness is None:
        smoothness = likeliest(time, values, noise_std, least_std, cutoff)
    fitted = _Problem(u.since, max(4, round(float(u.since[-1]) / smoothness.step)), smoothness.order)
    count = values.shape[1]
    coefficients, bands = np.empty((fitted.size, count)), np.empty((count, fitted.size, DEGREE + 1))
    std = np.empty(count)
    for j, weight in enumerate(smoothness.weights):
        c, _, squares = fitted.solve(u.values[:, j], weight)
        estimated = max(squares / (len(time) - fitted.order), u.least[j])
        std[j] = math.sqrt(estimated if math.isnan(u.known[j]) else u.known[j]) * u.scale[j]
        coefficients[:, j] = c * u.scale[j] + u.mean[j]
        bands[j] = std[j] ** 2 * inverse_band(fitted.normal(weight))
    return SmoothCurve(float(time[0]), fitted.step, coefficients, std, bands)


def likeliest(
    time: Array,
    values: Array,
    noise_std: Array | None = None,
    least_std: Array | float = 0.0,
    cutoff: float | None = None,
) -> Smoothness:
    """Estimate the smoothness of columns of samples; arguments as of ``smooth_columns``."""
    u = _scaled(time, values, noise_std, least_std)
    if cutoff is None:
        return _likeliest(u)
    span, edge = float(u.since[-1]), 2.0 * math.sin(math.pi / _CELLS_PER_PERIOD)
    cells = math.ceil(_CELLS_PER_PERIOD * cutoff * span)
    weight = math.log(len(time) / cells) - 2 * ORDERS[-1] * math.log(edge)
    return Smoothness(span / cells, ORDERS[-1], np.full(values.shape[1], weight))


class _Columns(NamedTuple):
    """Columns with mean 0 and standard deviation 1; known (or NaN) and least variance of their noise."""

    since: Array
    values: Array
    mean: Array
    scale: Array
    known: Array
    least: Array


def _scaled(time: Array, values: Array, noise_std: Array | None, least_std: Array | float) -> _Columns:
    count = values.shape[1]
    mean, scale = values.mean(axis=0), np.std(values, axis=0)
    scale = np.where(scale > 0.0, scale, 1.0)
    known = np.full(count, np.nan) if noise_std is None else (noise_std / scale) ** 2
    least = (np.broadcast_to(least_std, count) / scale) ** 2
    return _Columns(time - time[0], (values - mean) / scale, mean, scale, known, least)


def inverse_band(band: Array) -> Array:
    """Return the band of the inverse of a positive definite band matrix.

    Parameters
    ----------
    band : ndarray, shape (w + 1, p)
        Upper band in the layout of ``scipy.linalg.solveh_banded``; w at most ``_BLOCK``.

    Returns
    -------
    ndarray, shape (p, 6)
        Element [i, k] is the element (i, i + k) of the inverse, or 0 beyond its edge.

    Notes
    -----
    The matrix is block tridiagonal. Its Schur complements are eliminated forward; the blocks of the inverse
    follow backward (Takahashi's recurrence).
    """
    starts = range(0, band.shape[1], _BLOCK)
    diagonal = [_dense(band, i, i) for i in starts]
    beside = [_dense(band, i, i + _BLOCK) for i in starts[:-1]]
    inverses, factors = [np.linalg.inv(diagonal[0])], []
    for D, E in zip(diagonal[1:], beside, strict=True):
        factors.append(inverses[-1] @ E)
        inverses.append(np.linalg.inv(D - E.T @ factors[-1]))
    found = np.zeros((band.shape[1] + DEGREE, DEGREE + 1))
    last, next_rows = inverses[-1], np.zeros((len(inverses[-1]), 0))
    for k in reversed(range(len(starts))):
        if k < len(starts) - 1:
            next_rows = -factors[k] @ last
            last = inverses[k] - next_rows @ factors[k].T
        both = np.hstack([last, next_rows[:, :DEGREE]])
        for offset in range(DEGREE + 1):
            entries = np.diagonal(both, offset)
            found[starts[k] : starts[k] + len(entries), offset] = entries
    return found[: band.shape[1]]


def _dense(band: Array, row: int, column: int) -> Array:
    """Return a block of a symmetric band matrix that starts at a row and a column."""
    width, size = len(band) - 1, band.shape[1]
    i = np.arange(row, min(row + _BLOCK, size))[:, None]
    j = np.arange(column, min(column + _BLOCK, size))
    offset = np.abs(j - i)
    return np.where(offset <= width, band[np.maximum(width - offset, 0), np.maximum(i, j)], 0.0)


def _parts(count: int) -> list[slice]:
    return [slice(i, i + _CHUNK) for i in range(0, count, _CHUNK)]


def _differences(size: int, order: int) -> sparse.csr_matrix:
    """Return the matrix of differences of an order of ``size`` numbers."""
    D = sparse.eye(size, format="csr")
    for k in range(order):
        shape = (size - k - 1, size - k)
        D = sparse.diags([-1.0, 1.0], [0, 1], shape=shape, format="csr") @ D
    return D


def _design(since: Array, step: float, cells: int) -> list[sparse.csr_matrix]:
    """Return values, rates, and second rates of all B-splines at times (s) since the first knot."""
    knots = step * np.arange(-DEGREE, cells + DEGREE + 1)
    t = np.clip(since, 0.0, knots[-DEGREE - 1] * (1.0 - 1e-15))
    size = cells + DEGREE
    return [
        (BSpline.design_matrix(t, knots[r : len(knots) - r], DEGREE - r) @ _differences(size, r)).tocsr()
        / step**r
        for r in range(3)
    ]


def _local_rows(rows: list[sparse.csr_matrix]) -> tuple[Array, Array]:
    """Return the first of six coefficients at each time, (n,), and their factors, (3, n, 6)."""
    first = np.minimum.reduceat(rows[0].indices, rows[0].indptr[:-1])
    weights = np.zeros((3, rows[0].shape[0], DEGREE + 1))
    for order, each in enumerate(rows):
        row = np.repeat(np.arange(each.shape[0]), np.diff(each.indptr))
        place = each.indices - first[row]
        inside = (place >= 0) & (place <= DEGREE)
        weights[order, row[inside], place[inside]] = each.data[inside]
    return first, weights


def _band(M: sparse.spmatrix, width: int) -> Array:
    """Return the upper band of a symmetric matrix in SciPy's layout."""
    band = np.zeros((width + 1, M.shape[0]))
    for k in range(width + 1):
        band[width - k, k:] = M.diagonal(k)
    return band


class _Problem:
    """Least squares with a penalty for samples at fixed times, on even knots."""

    def __init__(self, since: Array, cells: int, order: int) -> None:
        self.cells, self.order, self.size = cells, order, cells + DEGREE
        self.step = float(since[-1]) / cells
        self.B, self.D = _design(since, self.step, cells)[0], _differences(self.size, order)
        width = max(DEGREE, order)
        self.gram, self.penalty = _band(self.B.T @ self.B, width), _band(self.D.T @ self.D, width)
        # Keeps cells without samples regular where the penalty's weight is small.
        self.gram[-1] += 1e-12 * len(since) / self.size

    def normal(self, log_weight: float) -> Array:
        """Return the band of the normal equations."""
        return self.gram + math.exp(log_weight) * self.penalty

    def solve(self, u: Array, log_weight: float) -> tuple[Array, Array, float]:
        """Return the coefficients, the Cholesky factor, and the minimum of the penalized sum of squares."""
        factor = cholesky_banded(self.normal(log_weight), check_finite=False)
        c = cho_solve_banded((factor, False), self.B.T @ u, check_finite=False)
        squares = np.sum((u - self.B @ c) ** 2) + math.exp(log_weight) * np.sum((self.D @ c) ** 2)
        return c, factor, max(float(squares), 1e-30 * len(u))

    def best_weight(self, u: Array, known: float, least: float) -> tuple[float, float]:
        """Return the smallest -2 log likelihood and the logarithm of its weight.

        ``known`` is the variance of the noise, or NaN, and then at least ``least``.
        """
        left = len(u) - self.order

        def cost(log_weight: float) -> float:
            _, factor, squares = self.solve(u, log_weight)
            logdet = 2.0 * float(np.sum(np.log(factor[-1])))
            logdet -= (self.size - self.order) * log_weight + self._log_determinant()
            if not math.isnan(known):
                return logdet + squares / known
            variance = max(squares / left, least, 1e-28)
            return logdet + left * math.log(variance) + squares / variance

        i = int(np.argmin([cost(x) for x in _WEIGHTS]))
        bounds = _WEIGHTS[max(i - 1, 0)], _WEIGHTS[min(i + 1, len(_WEIGHTS) - 1)]
        found = minimize_scalar(cost, bounds=bounds, method="bounded", options={"xatol": 0.1})
        return float(found.fun), float(found.x)

    def _log_determinant(self) -> float:
        """Return the logarithm of the determinant of D D^T, a Toeplitz matrix, in closed form."""
        j, m, d = np.arange(self.order), self.size - self.order, self.order
        return float(
            np.sum(gammaln(j + 1) + gammaln(m + d + j + 1) - gammaln(d + j + 1) - gammaln(m + j + 1))
        )


def _likeliest(columns: _Columns) -> Smoothness:
    """Return the likeliest smoothness of the middle of some columns, with knots as fine as necessary."""
    count = len(columns.since)
    middle = slice(max(0, (count - _TRIAL_SAMPLES) // 2), (count + _TRIAL_SAMPLES) // 2)
    t, u = columns.since[middle], columns.values[middle]
    t, u = t - t[0], u - u.mean(axis=0)
    for doubling in itertools.count():
        cells = _FEWEST_CELLS << doubling
        costs, weights = np.empty((2, len(ORDERS), u.shape[1]))
        problems = [_Problem(t, cells, order) for order in ORDERS]
        for i, problem in enumerate(problems):
            for j in range(u.shape[1]):
                known, least = columns.known[j], columns.least[j]
                costs[i, j], weights[i, j] = problem.best_weight(u[:, j], known, least)
        best = int(np.argmin(costs.sum(axis=1)))
        fine = weights[best].min() > math.log(len(t) / cells) + _PENALTY_DOMINATES
        if fine or 2 * cells > len(t):
            break
    return Smoothness(problems[best].step, ORDERS[best], weights[best])
