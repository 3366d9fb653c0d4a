"""Result of an identification: base parameters with their covariance, and the tests of the residual.

The residual test compares the residual with the specified noise, in size and in smoothness. The lag test
relates the residual to the rates of the forces.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.special import chdtrc, fdtrc

from ..io.array_types import Array, Flags, Indices
from ..motion.bad_rows import LIMIT
from ..motion.motion import Motion
from ..robot.robot import LEGS, Robot
from .base_parameters import BaseParametersResult
from .drive_terms import DriveIdentificationResult, seen_by_motors
from .fits import Data, Fit, force_rates
from .least_squares import departure
from .parameters import ParameterVector, inertial_parameters
from .physical import Negative, negative

LEVEL = 1e-3
"""Significance level: a correct model with the specified noise causes a warning with this probability."""
# Largest inflation factor of the standard deviations; fits with a larger factor are rejected.
_MOST_INFLATION = 3.0
# Numbers of cosines over time, for each leg, in the tests for a smooth residual: of slow and of fast effects.
_COSINES = (4, 20)
# Number of columns that are eliminated together, to save memory.
_TOGETHER = 20
# Part of the square of a column below which the unknowns and other columns explain it completely.
_NEW = 1e-8
# Smallest divisor.
_TINY = 1e-100


@dataclass(frozen=True, eq=False)
class IdentificationResult:
    """Base parameters identified from forces, with tests of the model and of the specified noise.

    Attributes
    ----------
    base : BaseParametersResult
        Definition of the base parameters.
    values : ndarray, shape (rank,)
        Values in SI units.
    covariance : ndarray, shape (rank, rank)
        Covariance, multiplied by the square of ``inflation_factor``; inf on the diagonal if the fit is
        rejected.
    normalized_residual : float
        RMS of the residual divided by its expectation, near 1 for a correct model and noise.
    p_noise : float
        Probability of a residual of at least this size under the specified noise.
    p_model : float
        Smaller p-value, multiplied by the number of tests, of the tests for a smooth residual of the forces
        and for a time lag. It does not depend on the specified size of the noise.
    inflation_factor : float
        Factor of the standard deviations computed from the residual, at least 1.
    verdict : str
        "consistent"; "misfit" if ``p_noise`` or ``p_model`` is below 0.001. "untested" if there are not more
        forces than unknowns. "rejected" if the inflation factor would exceed 3 or the fit did not converge.
    warnings : tuple of str
        One message for each reason of the verdict.
    nonphysical : tuple of str
        One message for each value that no physical body has, more than four standard deviations below zero.
    near_zero : tuple of str
        One message for each value below zero that is not distinguishable from zero.
    motion : Motion
        Motion along which the parameters were estimated, shape (...).
    excluded_samples : ndarray of int
        Indices of samples that are not used: forces with a residual of more than 8 robust standard deviations
        (median absolute deviation) of the leg, at most 1 % of the samples.
    parameters : ParameterVector, optional
        All 148 parameters of possible bodies, with ``enforce_physical``.
    unconstrained : IdentificationResult, optional
        Estimate without the restriction to possible bodies, with ``enforce_physical``.
    drive : DriveIdentificationResult, optional
        Drive terms, if requested.
    force_lag : tuple of float, optional
        Time lag of the forces behind the measured poses (s) and its standard deviation, estimated from the
        residual. The other values are not corrected for the lag.
    largest_residual : tuple
        Index of the sample, index of the leg, and size in standard deviations of the largest residual of the
        forces.
    """

    base: BaseParametersResult
    values: Array
    covariance: Array
    normalized_residual: float
    p_noise: float
    p_model: float
    inflation_factor: float
    verdict: str
    warnings: tuple[str, ...]
    nonphysical: tuple[str, ...]
    near_zero: tuple[str, ...]
    motion: Motion
    excluded_samples: Indices
    parameters: ParameterVector | None = None
    unconstrained: IdentificationResult | None = None
    drive: DriveIdentificationResult | None = None
    force_lag: tuple[float, float] | None = None
    largest_residual: tuple[int, int, float] = (0, 0, 0.0)

    @property
    def std(self) -> Array:
        """Standard deviation of each value, shape (rank,)."""
        return np.sqrt(np.diagonal(self.covariance))

    def compare_with(self, robot: Robot) -> tuple[Array, float]:
        """Compare the values, or the values of ``unconstrained``, with the parameters of a robot.

        Parameters
        ----------
        robot : Robot
            Robot model. If drive terms were identified, the viscous friction of its drives is added to the
            prismatic joints, because motor forces do not distinguish between the two.

        Returns
        -------
        off : ndarray, shape (rank,)
            Differences in standard deviations, positive if the estimate is larger; 0 if the fit is rejected.
        p : float
            Joint p-value: the probability of an estimate at least this far from the parameters of the robot
            if they are correct; 1 if the fit is rejected.
        """
        if self.unconstrained is not None:
            return self.unconstrained.compare_with(robot)
        robot = robot if self.drive is None else seen_by_motors(robot)
        off = self.values - self.base.matrix @ inertial_parameters(robot).values
        if not np.isfinite(self.covariance).all():
            return np.zeros(len(off)), 1.0
        return departure(off, self.covariance)


def tested_estimate(data: Data, fit: Fit, outliers: Flags) -> IdentificationResult:
    """Create the result of a fit with the tests of its residual; ``outliers`` are as in ``robust_fit``."""
    left_out = int(np.isinf(data.deviations).sum())
    spare = len(fit.residual) - left_out - fit.factors.unknowns
    misfit = math.sqrt(float(np.sum(fit.residual**2)) / spare) if spare > 0 else math.nan
    sizes = _size_tests(fit, left_out)
    lag, smooth = _model_tests(data, fit, spare)
    doubts = [] if fit.converged else ["fit: did not converge; use a motion with more excitation"]
    doubts += [test.doubt for test in (*sizes, smooth) if test.p < LEVEL]
    if doubts and data.robot.has_rotors and not data.seeks_rotors:
        doubts.append(
            "rotors: the forces are taken as motor forces with the rotor_inertia of the robot file; if it is "
            "uncertain, identify reflected_mass; for forces measured in the legs, remove rotor_inertia"
        )
    excluded = outliers & np.isinf(data.deviations).reshape(-1, LEGS).all(axis=1)
    if outliers.any() and not excluded.any():
        doubts.append(
            f"forces: {outliers.sum()} of {len(outliers)} samples, more than 1 %, differ from the model by "
            f"more than {LIMIT:g} robust standard deviations: the residuals do not fit the model; all "
            "samples are used; check them and the model"
        )
    if lag is not None and lag.test.p < LEVEL and lag.test.doubt:
        doubts.insert(0, lag.test.doubt)
    if doubts and fit.time is None:
        doubts.append("motion: is taken as exact; state the pose noise if the poses were measured")
    tests = (*sizes, smooth, *(() if lag is None else (lag.test,)))
    inflation = max([1.0, *(test.inflation for test in tests if test.p < LEVEL)])
    rejected = inflation > _MOST_INFLATION or not fit.converged
    verdict = "rejected" if rejected else "misfit" if doubts else "consistent" if spare > 0 else "untested"
    unknowns, rank, terms = len(fit.values), data.base.rank, data.terms
    covariance = np.diag(np.full(unknowns, np.inf)) if rejected else inflation**2 * fit.factors.covariance()
    values, own = fit.values[:rank], covariance[:rank, :rank]
    below = Negative((), ()) if rejected else negative(data.robot, data.base, values, own)
    return IdentificationResult(
        base=data.base,
        values=values,
        covariance=own,
        normalized_residual=misfit,
        p_noise=min([1.0, *(test.p for test in sizes)]),
        p_model=smooth.p if lag is None else min(smooth.p, lag.test.p),
        inflation_factor=inflation,
        verdict=verdict,
        warnings=tuple(doubts),
        nonphysical=below.impossible,
        near_zero=below.near_zero,
        motion=fit.motion,
        excluded_samples=np.flatnonzero(excluded),
        drive=None if terms is None else terms.estimate(fit.values[rank:], covariance[rank:, rank:]),
        force_lag=None if lag is None else (lag.time, lag.sigma),
        largest_residual=_largest(fit.parts[0]),
    )


def _largest(residual: Array) -> tuple[int, int, float]:
    """Return sample, leg, and size of the largest residual, shape (n, 6)."""
    sample, leg = np.unravel_index(int(np.argmax(np.abs(residual))), residual.shape)
    return int(sample), int(leg), float(abs(residual[sample, leg]))


class _Test(NamedTuple):
    """Result of a test of the residual.

    ``p`` is multiplied by the number of tests of the same kind. ``inflation`` is the factor of the standard
    deviations that accounts for the effect. ``doubt`` is the warning if p is small; it is empty if another
    test explains the effect better.
    """

    p: float
    inflation: float = 1.0
    doubt: str = ""


class _Lag(NamedTuple):
    """Lag of the forces behind the poses (s), its standard deviation, and its test."""

    time: float
    sigma: float
    test: _Test


def _size_tests(fit: Fit, left_out: int) -> list[_Test]:
    """Compare the mean squares of the residuals of forces and poses with the specified noise."""
    tests, first = [], 0
    for name, part, ignored in zip(("forces", "poses"), fit.parts, (left_out, 0), strict=False):
        spare = part.size - ignored - fit.factors.freedom(slice(first, first + part.size))
        first += part.size
        if spare < 1.0:
            continue
        ratio = float(np.sum(part**2)) / spare
        p = min(len(fit.parts), 2) * float(chdtrc(spare, ratio * spare))
        size = f"got {math.sqrt(ratio):.3g} times this size"
        text = f"{name}: expected a residual of the size of the specified noise, {size}"
        tests.append(_Test(p, math.sqrt(ratio), text))
    return tests


class _Effects(NamedTuple):
    """Effects on the forces, without the parts that the unknowns explain.

    ``gram`` and ``along`` are the products of k effects with each other and with the residual, whose sum of
    squares is ``squares`` and whose degrees of freedom are ``spare``.
    """

    gram: Array
    along: Array
    squares: float
    spare: int

    def explained(self, count: int) -> tuple[float, int]:
        """Return the sum of squares that the first effects explain, and the number of independent ones."""
        values, vectors = np.linalg.eigh(self.gram[:count, :count])
        kept = values > _NEW
        return float(np.sum((vectors.T @ self.along[:count])[kept] ** 2 / values[kept])), int(kept.sum())

    def test(self, more: int, fewer: int = 0) -> tuple[float, float, int]:
        """Test the effects after the first ``fewer`` ones up to ``more``.

        Returns the probability that noise explains so much, the sum of squares that they explain in addition
        to the first ones, and the number of independent ones.
        """
        (whole, number), (part, without) = self.explained(more), self.explained(fewer)
        count, rest = number - without, self.spare - number
        if count == 0 or rest <= 0:
            return 1.0, 0.0, 0
        mean_square = max((self.squares - whole) / rest, _TINY)
        return float(fdtrc(count, rest, (whole - part) / count / mean_square)), whole - part, count


def _model_tests(data: Data, fit: Fit, spare: int) -> tuple[_Lag | None, _Test]:
    """Test for a lag behind measured poses, and for a smooth residual in addition to it."""
    n, used = len(fit.parts[0]), np.isfinite(data.deviations).reshape(-1, 1)
    phase = math.pi / n * np.outer(np.arange(n) + 0.5, np.arange(min(max(_COSINES), n // 8)))
    columns = np.asarray(np.kron(np.cos(phase), np.eye(LEGS)) * used, dtype=np.float64)
    if fit.time is None:
        return None, _smooth_test(_unexplained(fit, columns, spare), 0)[0]
    lagging = (-force_rates(data, fit) / data.deviations).ravel()
    effects = _unexplained(fit, np.column_stack([lagging, columns]), spare)
    smooth, by_smooth = _smooth_test(effects, 1)
    p, by_lag, count = effects.test(1)
    if count == 0:
        return None, smooth
    length, size = np.linalg.norm(lagging), math.sqrt(effects.gram[0, 0])
    time = float(effects.along[0] / size**2 / length)
    mean_square = (effects.squares - by_lag) / (spare - 1)
    sigma = float(max(1.0, math.sqrt(mean_square)) / size / length)
    test = _Test(min(1.0, (1 + len(_COSINES)) * p))
    # Another effect explains a residual that is mainly smooth.
    if by_lag > by_smooth:
        effect = np.zeros(len(fit.residual))
        effect[: len(lagging)] = time * lagging
        off = fit.factors.solve(effect)[: len(fit.values)] / np.sqrt(np.diagonal(fit.factors.covariance()))
        how = "lag" if time > 0.0 else "are ahead of"
        finding = f"the forces {how} the poses by {1e3 * abs(time):.3g} +- {1e3 * sigma:.2g} ms"
        text = f"times: {finding}; shift the times of the forces or the poses by this amount"
        test = _Test(test.p, math.sqrt(1.0 + float(np.mean(off**2))), text)
    return _Lag(time, sigma, test), smooth


def _unexplained(fit: Fit, columns: Array, spare: int) -> _Effects:
    """Return effects on the forces, shape (6 n, k), divided by their lengths, as ``_Effects``."""
    columns = columns / np.maximum(np.linalg.norm(columns, axis=0), _TINY)
    gram, rows = np.empty((columns.shape[1], columns.shape[1])), len(columns)
    for some in np.array_split(np.arange(columns.shape[1]), 1 + columns.shape[1] // _TOGETHER):
        added = np.zeros((len(fit.residual), len(some)))
        added[:rows] = columns[:, some]
        gram[:, some] = columns.T @ fit.factors.unexplained(added)[:rows]
    left = fit.factors.unexplained(fit.residual)
    return _Effects(gram, columns.T @ left[:rows], float(left @ left), spare)


def _smooth_test(effects: _Effects, first: int) -> tuple[_Test, float]:
    """Test for slow cosines and for all cosines in addition to the first effects.

    Returns also the sum of squares that they explain.
    """
    p, explained, count = min(effects.test(first + LEGS * count, first) for count in _COSINES)
    size = math.sqrt(explained / max(count, 1))
    source = "noise" if size >= 1.0 else "the specified noise, which exceeds the scatter"
    text = (
        f"forces: differ smoothly from the model, {size:.2f} times as much as expected from {source}; model "
        "all moving parts and friction, keep the load constant, avoid drift of sensors, and check the poses"
    )
    return _Test(min(1.0, (len(_COSINES) + first) * p), size, text), explained
