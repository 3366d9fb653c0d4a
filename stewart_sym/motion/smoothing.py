"""Smoothing splines of noisy samples: values, rates, second rates and their covariance; NumPy alone.

A spline of degree 5 on even knots minimizes squared residuals over the noise's variance plus the squared
differences of order d of its coefficients over a variance of their own: a Gaussian prior. Marginal likelihood
chooses that variance and d, so the spread of the posterior is what noise and unresolved motion leave open; in
windows for which it chooses accelerations that jump, what a jump may be is added. The knots are refined until
the penalty alone limits the resolution. Long series are smoothed in windows that overlap by half, so time and
memory grow with their length alone; where samples are even, all inner windows share their matrices. What lies
before and after a long gap is smoothed by itself: nothing is sampled in it, and equations of a curve that
bridges it would be singular to rounding.
"""

from __future__ import annotations

import functools
import itertools
import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..io.arguments import real_array, shown
from ..io.array_types import Array
from ..io.toml_reader import positive
from .interpolation import (
    DEGREE,
    PAIRS,
    Instants,
    Knots,
    along,
    b_splines,
    beside_noise,
    breaks,
    check_cutoff,
    inverse_factor,
    places,
    rates_at_half_cells,
    whole_windows,
)
from .noise_level import FEWEST_SAMPLES, LEAST_SAMPLES, SEEN, Level, like_noise, noise_level

ORDERS = (3, 4, 6, 8)
"""Orders of differences in the penalty: the lowest suits accelerations that jump, high ones smooth motion."""
CUTOFF_ORDER = 6
"""Order for a given cut-off: lower ones distort both ends of a motion by more than the stated deviations."""
_FEWEST_CELLS = 24
# Samples of a chosen few windows settle knots and order for all of them.
_TRIAL_WINDOWS = 8
# Resolution is limited by the penalty where it leaves less than this share of the coefficients free.
_FREE = 1.0 / 3.0
# A penalty of weight 1 halves the amplitude of motions with a period of eight knot intervals.
_EDGE = 2.0 * math.sin(math.pi / 8.0)
_WEIGHTS = 10.0 ** np.linspace(-9.0, 12.0, 127)
_CHUNK = 1 << 16
# By how much -2 log likelihood of all columns falls with noise in few samples where there is any.
_DECIDED = 10.0
# Samples beyond the order of a curve that show noise.
_FEWEST_LEFT = 4
# In a window accelerations that jump are likelier than the series' own order by so much in -2 log likelihood.
_CLEARLY = 10.0
# Least penalty of weight 1 of a curve that bends once in the longest step: with less, rounding bends it.
_LEAST_BENT = 1e-6


class SmoothSamplesResult(NamedTuple):
    """Smoothed columns of samples with their derivatives and covariances.

    Attributes
    ----------
    values, derivatives, second_derivatives : ndarray, shape (n, c)
        Values and time derivatives of the spline at the times of the samples.
    noise_std : ndarray, shape (c,)
        Standard deviations of the noise.
    covariance_time : ndarray, shape (g,)
        Times (s) of ``covariance``.
    covariance : ndarray, shape (g, c, 6)
        Covariance of value, first, and second derivative of each column: lower triangle, row by row.
    """

    values: Array
    derivatives: Array
    second_derivatives: Array
    noise_std: Array
    covariance_time: Array
    covariance: Array


def smooth_samples(
    time: ArrayLike, values: ArrayLike, noise_std: ArrayLike | None = None, cutoff: float | None = None
) -> SmoothSamplesResult:
    """Smooth columns of samples without phase shift, including both ends.

    Parameters
    ----------
    time : array_like, shape (n,)
        Increasing times (s), at least four.
    values : array_like, shape (n, c)
        Samples. A column without noise is rejected, because it needs interpolation instead of smoothing.
    noise_std : array_like, shape (c,) or (), optional
        Standard deviation of the noise of each column, > 0. None: estimated from the samples.
    cutoff : float, optional
        Frequency (Hz) at which the amplitude is halved. None: most likely value. If ``cutoff`` is given
        without ``noise_std``, the noise is estimated from the residuals.

    Returns
    -------
    SmoothSamplesResult
        Smoothed columns with derivatives and covariances.

    Raises
    ------
    ValueError
        If an argument is invalid. The message names it.
    """
    when, columns = real_array(time, "time"), real_array(values, "values")
    if when.ndim != 1 or len(when) < 4 or not (np.diff(when) > 0.0).all():
        raise ValueError(f"time: expected at least 4 increasing times, s, (n,), got {shown(time)}")
    if columns.ndim != 2 or len(columns) != len(when) or not columns.size or not np.isfinite(columns).all():
        raise ValueError(f"values: expected finite columns ({len(when)}, c), got shape {columns.shape}")
    cutoff = None if cutoff is None else positive(cutoff, "cutoff")
    level = shown_noise(when, columns)
    if noise_std is not None:
        given = real_array(noise_std, "noise_std")
        if given.shape not in ((), columns.shape[1:]):
            raise ValueError(f"noise_std: expected one number or {columns.shape[1]}, got shape {given.shape}")
        known = np.array(np.broadcast_to(given, columns.shape[1:]))
        level = Level(known, known)
    if noise_std is not None or cutoff is None:
        bad = ~(np.isfinite(level.sigma) & (level.sigma > 0.0))
        if bad.any() and noise_std is None:
            text = "shows no noise: expected sigma, or columns to be smoothed"
            raise ValueError(f"values: column {int(np.argmax(bad)) + 1} {text}")
        if bad.any():
            raise ValueError(f"noise_std: expected deviations > 0, got {level.sigma[bad][0]:g}")
    return smoothed(when, columns, None if noise_std is None and cutoff is not None else level, cutoff)


def smoothed(
    time: Array, columns: Array, level: Level | None, cutoff: float | None, scale: Array | None = None
) -> SmoothSamplesResult:
    """``smooth`` of checked arrays; without a level the noise is that of the residuals about the cut-off.

    scale: times the level of the noise of each sample, (n,).
    """
    ends = [0, *breaks(time), len(time)]
    scale = np.ones(len(time)) if scale is None else scale
    parts = [
        _part(Instants.of(time[i:j], scale[i:j]), columns[i:j], level, cutoff)
        for i, j in itertools.pairwise(ends)
    ]
    if len(parts) == 1:
        return parts[0]
    shares = np.diff(ends)[:, None] / len(time)
    sigma = np.sqrt(np.sum(shares * np.square([part.noise_std for part in parts]), axis=0))
    return SmoothSamplesResult(*(np.concatenate(each) for each in zip(*parts, strict=True)))._replace(
        noise_std=sigma
    )


def shown_noise(time: Array, values: Array, step: Array | None = None) -> Level:
    """``noise_level``, and of few samples, whose differences are too few, what is likeliest.

    Of noise about a curve of any order and smoothness, each as likely as it makes the samples, the mean.
    """
    level = noise_level(time, values, step)
    if not FEWEST_SAMPLES <= len(time) < LEAST_SAMPLES:
        return level
    sigma, gain = likeliest_noise(time, values, level.least)
    noisy = like_noise(time, values, sigma)
    noisy &= np.sum(gain[noisy]) > _DECIDED
    return Level(np.where(noisy, sigma, level.sigma), np.where(noisy, sigma, level.least))


def likeliest_noise(time: Array, values: Array, least: Array) -> tuple[Array, Array]:
    """Noise of columns of few samples, (c,), at least as large as given, and how much likelier it is, (c,).

    Than the least alone, in -2 log likelihood.
    """
    instants = Instants.of(time, np.ones(len(time)))
    knots = Knots.of(instants, max(len(time), LEAST_SAMPLES))
    window = _Window.of(instants, values, knots, 0)
    return window.noise(_orders(instants.since, knots.step), least)


def _part(
    instants: Instants, columns: Array, level: Level | None, cutoff: float | None
) -> SmoothSamplesResult:
    """``smoothed`` of samples without a long gap."""
    ones = np.ones(columns.shape[1])
    if cutoff is not None:
        check_cutoff(instants.unit * instants.since, cutoff)
        knots = Knots.of(instants, 8.0 * cutoff * instants.unit * float(instants.since[-1]))
        orders = np.full(len(ones), CUTOFF_ORDER)
        turns = cutoff * instants.unit * knots.step
        weight = float(np.sinc(turns) ** (2 * DEGREE + 2))
        weight *= (_EDGE / (2.0 * math.sin(math.pi * turns))) ** (2 * CUTOFF_ORDER)
        found = _smoothed(instants, columns, ones if level is None else level.sigma, knots, orders, weight)
        return _scaled(found, columns) if level is None else found
    assert level is not None
    knots, orders, seen = _resolve(instants, columns, level.sigma)
    # Modes that show less than rounding makes are those of numbers that stay the same: off alike by as much.
    still = seen < 0.5 * level.least
    likely = np.where(still, level.sigma, np.clip(seen, level.least, 1.5 * level.sigma))
    known = level.least == level.sigma
    found = _smoothed(instants, columns, np.where(known, level.sigma, likely), knots, orders, None)
    sigma = np.where(still, level.least, found.noise_std)
    most = np.max(found.covariance[:, :, 0], axis=0)
    share = np.where(still, np.minimum(1.0, sigma**2 / np.where(most > 0.0, most, 1.0)), 1.0)
    return found._replace(noise_std=sigma, covariance=found.covariance * share[:, None])


def _scaled(unit: SmoothSamplesResult, columns: Array) -> SmoothSamplesResult:
    """A fit under noise of deviation 1 with the deviation that its residuals show."""
    leverage = np.mean(unit.covariance[..., 0], axis=0)
    left = np.mean((columns - unit.values) ** 2, axis=0) / np.maximum(1.0 - leverage, 1.0 / len(columns))
    return unit._replace(noise_std=np.sqrt(left), covariance=unit.covariance * left[:, None])


# Knots


def _orders(since: Array, step: float) -> list[int]:
    """The orders whose penalty holds a curve in the longest gap between samples, in knots ``step`` apart."""
    bend = 2.0 * math.sin(min(1.0, step / float(np.diff(since).max())) * math.pi / 2.0) / _EDGE
    return [
        order
        for order in ORDERS
        if order == ORDERS[0] or (order < len(since) and bend ** (2 * order) > _LEAST_BENT)
    ]


def _resolve(instants: Instants, values: Array, sigma: Array) -> tuple[Knots, NDArray[np.int64], Array]:
    """Knots so fine that the penalty limits the resolution, and the likeliest order and noise, (c,)."""
    since = instants.since
    # Of few samples so many that these alone limit a curve.
    cells = _FEWEST_CELLS if len(since) >= LEAST_SAMPLES else LEAST_SAMPLES
    while True:
        knots = Knots.of(instants, cells)
        orders = _orders(since, knots.step)
        starts = knots.windows()
        trial = {starts[int(i)] for i in np.linspace(0, len(starts) - 1, min(len(starts), _TRIAL_WINDOWS))}
        cost, free, squares, count = np.zeros((4, len(orders), values.shape[1]))
        for start in trial:
            window = _Window.of(instants, values, knots, start)
            for i, order in enumerate(orders):
                found = window.likeliest(order, sigma)
                cost[i] += found.cost
                free[i] = np.maximum(free[i], found.free / window.size)
                squares[i] += found.noise[0]
                count[i] += found.noise[1]
        best = np.argmin(cost, axis=0)
        pick = (best, np.arange(len(best)))
        finer = whole_windows(2 * cells)
        if free[pick].max() <= _FREE or finer > len(since):
            seen = np.sqrt(squares[pick] / np.maximum(count[pick], 1.0))
            return knots, np.array(orders)[best], np.where(count[pick] > 0.0, seen, sigma)
        cells = finer


# One window


@dataclass(frozen=True, eq=False)
class _Modes:
    """Modes of the coefficients of a window, in which samples and a penalty of weight 1 are diagonal.

    M: normal equations, (p, p); inverse: of their Cholesky factor. X: the coefficients of each mode in its
    columns, X^T M X = 1; rho: the penalty's share of a mode, (p, 1), from 0 for polynomials.
    """

    M: Array
    inverse: Array
    X: Array
    rho: Array


# Windows on which the knots were tried in every order are smoothed on them.
@functools.lru_cache(maxsize=48)
def _modes(samples: bytes, size: int, order: int, density: float) -> _Modes:
    """Modes by the bytes of G = B^T B."""
    rough = np.diff(np.eye(size), order, axis=0)
    P = density / _EDGE ** (2 * order) * rough.T @ rough
    # What is added to the penalty keeps a gap in the log regular.
    M = np.frombuffer(samples).reshape(size, size) + (P + 1e-12 * density * np.eye(size))
    inverse = inverse_factor(M)
    rho, V = np.linalg.eigh(inverse @ P @ inverse.T)
    rho = np.clip(rho, 0.0, 1.0)[:, None]
    rho[:order] = 0.0
    return _Modes(M, inverse, inverse.T @ V, rho)


@functools.lru_cache(maxsize=8)
def _products(modes: _Modes, width: int) -> list[Array]:
    """Products of ``PAIRS`` at every half cell, of knots 1 apart: (g, p) each."""
    rows = [each @ modes.X for each in rates_at_half_cells(width)]
    return [rows[i] * rows[j] for i, j in PAIRS]


class _Fit(NamedTuple):
    """Columns in the modes of one window and order: mean and variance of each mode, (p, c).

    cost: -2 log likelihood, (c,). free: effective number of coefficients, (c,). noise: sum of squares and
    number of the modes just beyond the resolution, which hold noise alone, (c,) each.
    """

    modes: _Modes
    mean: Array
    variance: Array
    cost: Array
    free: Array
    noise: tuple[Array, Array]


class _Window(NamedTuple):
    """Normal equations of the samples in a window, with B the B-splines at the samples.

    G = B^T B, (p, p). pilot: coefficients of a fit, (p, c); what differs from it is as small as the noise, so
    nothing cancels. rest: B^T times its residuals, (p, c). residual, spread: sums of squares, (c,), of the
    residuals and about the mean. density: as of the knots. samples: how many.
    """

    G: Array
    pilot: Array
    rest: Array
    residual: Array
    spread: Array
    density: float
    samples: int

    @property
    def size(self) -> int:
        return len(self.G)

    @classmethod
    def of(cls, instants: Instants, values: Array, knots: Knots, start: int) -> _Window:
        """The window that begins with a cell; of samples over their scale, whose noise is alike."""
        since = instants.since
        begin, width = knots.place(start), knots.width(start)
        first, last = np.searchsorted(since, [begin, knots.place(start + width)])
        end = len(since) if start + width >= knots.cells else int(last)
        cell, u = places(since[first:end] - begin, knots.step, width)
        weights = 1.0 / instants.scale[first:end, None]
        N, y = weights * b_splines(u, DEGREE), weights * values[first:end]
        size, inner = width + DEGREE, range(DEGREE + 1)
        # Samples lie in order of time, those of a cell side by side.
        filled, starts = np.unique(cell, return_index=True)

        def sums(x: Array) -> Array:
            return np.add.reduceat(x, starts, axis=0) if len(starts) else x

        def project(x: Array) -> Array:
            total = np.zeros((size, x.shape[1]))
            for i in inner:
                total[filled + i] += sums(N[:, i, None] * x)
            return total

        G = np.zeros((size, size))
        for i in inner:
            products = sums(N[:, i, None] * N)
            for j in inner:
                G[filled + i, filled + j] += products[:, j]
        inverse = _modes(G.tobytes(), size, ORDERS[0], knots.density).inverse
        pilot, rest = np.zeros((size, y.shape[1])), y
        for _ in range(2):
            pilot = pilot + inverse.T @ (inverse @ project(rest))
            rest = y - along(N, cell, pilot)
        spread = np.sum((y - y.sum(axis=0) / max(1, len(y))) ** 2, axis=0)
        return cls(G, pilot, project(rest), np.sum(rest**2, axis=0), spread, knots.density, len(y))

    def _explained(self, order: int, weights: Array) -> tuple[_Modes, Array, Array, Array, Array, Array]:
        """Modes, products of samples and pilot with these, (p, c), and for weights, (w,), what they leave.

        Pull of the penalty and its sum with that of the samples, (p, w), and sums of squares, (w, c).
        """
        modes = _modes(self.G.tobytes(), self.size, order, self.density)
        z, bent = modes.X.T @ self.rest, modes.X.T @ (modes.M @ self.pilot)
        gamma, pull = 1.0 - modes.rho, modes.rho * weights
        A = gamma + pull
        share = (pull / A).T
        # With the sum of pull bent^2 - (z - pull bent)^2 / A.
        squares = self.residual + share @ (gamma * bent**2 + 2.0 * z * bent) - (1.0 / A).T @ z**2
        return modes, z, bent, pull, A, squares

    def noise(self, orders: list[int], least: Array) -> tuple[Array, Array]:
        """Noise, (c,), at least as large as given, and by how much likelier it is than the least alone, (c,).

        The latter in -2 log likelihood.
        """
        floor = np.maximum(least, np.sqrt(np.finfo(float).tiny)) ** 2
        costs: list[Array] = []
        alone: list[Array] = []
        variances: list[Array] = []
        for order in (each for each in orders if self.samples - each >= _FEWEST_LEFT):
            modes, _, _, pull, _, squares = self._explained(order, _WEIGHTS)
            for found, variance in (
                (costs, np.maximum(squares / (self.samples - order), floor)),
                (alone, np.broadcast_to(floor, squares.shape)),
            ):
                free = _freedom(modes, pull, variance / np.maximum(self.spread, variance))
                found.append(free + self.samples * np.log(variance) + squares / variance)
            variances.append(np.maximum(squares / (self.samples - order - 2), floor))
        cost, variance = np.concatenate(costs), np.concatenate(variances)
        likely = np.exp(0.5 * (cost.min(axis=0) - cost))
        sigma = np.sqrt(np.sum(likely * variance, axis=0) / likely.sum(axis=0))
        return sigma, np.concatenate(alone).min(axis=0) - cost.min(axis=0)

    def likeliest(self, order: int, sigma: Array, weight: float | None = None) -> _Fit:
        """Posterior of the coefficients under noise sigma, (c,), with the likeliest weight or a given one."""
        weights = _WEIGHTS if weight is None else np.array([weight])
        modes, z, bent, pull, A, squares = self._explained(order, weights)
        rho, gamma = modes.rho, 1.0 - modes.rho
        cost = _freedom(modes, pull, sigma**2 / np.maximum(self.spread, sigma**2)) + squares / sigma**2
        best = np.argmin(cost, axis=0)
        pull, A = pull[:, best], A[:, best]
        idle = (pull > 10.0 * gamma) & (gamma > SEEN)
        seen = np.maximum(gamma, SEEN)
        noise = np.where(idle, (gamma * bent + z) ** 2 / seen, 0.0)
        # Expected square of the error: the noise's, and that of smoothing as far as the samples show it.
        steep = (np.maximum(rho, 1e-300) / seen) ** (2.0 / order) * (pull / A) ** 2 * (pull < 3.0 * gamma)
        square = np.sum(steep * (((gamma * bent + z) / seen) ** 2 - sigma**2 / seen), axis=0)
        prior = np.sum(steep * sigma**2 / np.maximum(pull, 1e-300), axis=0)
        bias = np.clip(square / np.maximum(prior, 1e-300), 0.0, 1.0)
        return _Fit(
            modes=modes,
            mean=bent + (z - pull * bent) / A,
            variance=sigma**2 * (gamma + bias * pull) / A**2,
            cost=np.take_along_axis(cost, best[None], axis=0)[0],
            free=np.sum(gamma / A, axis=0),
            noise=(noise.sum(axis=0), np.count_nonzero(idle, axis=0).astype(np.float64)),
        )


def _freedom(modes: _Modes, pull: Array, loose: Array) -> Array:
    """Sum over the modes of log(1 + gamma / (pull + loose)), (w, c); pull, (p, w); loose, (c,) or (w, c)."""
    terms = pull[:, None] + np.atleast_2d(loose).T
    terms = 1.0 + np.divide(1.0 - modes.rho[:, None], terms, out=terms)
    # Logarithms of products take less time where a double holds these.
    few = 5 if loose.min() > 1e-60 else 1
    products = [terms[i : i + few].prod(axis=0) for i in range(0, len(terms), few)]
    return np.asarray(np.log(products).sum(axis=0).T)


def _smoothed(
    instants: Instants,
    values: Array,
    sigma: Array,
    knots: Knots,
    orders: NDArray[np.int64],
    weight: float | None,
) -> SmoothSamplesResult:
    count, step = values.shape[1], instants.unit * knots.step
    jumping = ORDERS[0] if weight is None else CUTOFF_ORDER
    coefficients = np.zeros((knots.cells + DEGREE, count))
    grid = np.arange(2 * knots.cells + 1) / 2.0
    covariance, resolved = np.zeros((len(grid), count, len(PAIRS))), np.zeros((len(grid), count))
    apart = np.zeros((3, len(grid), count))
    for start in knots.windows():
        window = _Window.of(instants, values, knots, start)
        width = knots.width(start)
        inside = slice(2 * start, 2 * (start + width) + 1)
        share = knots.share(start, grid[inside])
        centers = np.clip(np.arange(window.size) - DEGREE // 2, 0, width)
        blend = knots.share(start, (start + centers).astype(np.float64))
        fits = {order: window.likeliest(order, sigma, weight) for order in {jumping, *orders.tolist()}}
        usual = np.array([fits[order].cost[i] for i, order in enumerate(orders.tolist())])
        likely = np.where(fits[jumping].cost < usual - _CLEARLY, jumping, orders)
        for order in np.unique(likely):
            own, fit = np.flatnonzero(likely == order), fits[int(order)]
            mean = fit.modes.X @ fit.mean[:, own]
            coefficients[start : start + window.size, own] += blend[:, None] * mean
            for rate, rows in enumerate(rates_at_half_cells(width)):
                apart[rate][inside, own] += share[:, None] * (rows @ mean) / step**rate
            if order == ORDERS[0]:
                resolved[inside, own] += share[:, None] * width / fit.free[own]
            for k, product in enumerate(_products(fit.modes, width)):
                scaled = share[:, None] / step ** sum(PAIRS[k])
                covariance[inside, own, k] += scaled * (product @ fit.variance[:, own])
    covariance += beside_noise(coefficients, resolved, apart, step)
    found = np.empty((3, *values.shape))
    for part in (slice(i, i + _CHUNK) for i in range(0, len(values), _CHUNK)):
        cell, u = places(instants.since[part], knots.step, knots.cells)
        for rate in range(3):
            N = b_splines(u, DEGREE, rate) / step**rate
            found[rate, part] = along(N, cell, coefficients)
    return SmoothSamplesResult(found[0], found[1], found[2], sigma, instants.start + step * grid, covariance)
