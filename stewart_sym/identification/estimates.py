"""Result of an identification: base parameters with their covariance, and the tests of the residual.

The tests compare the residual with the specified noise: its size, its smooth part, a changing load, drifting
forces, and a time lag.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..io.array_types import Array
from ..motion.motion import Motion
from ..robot.robot import LEGS, Robot
from .base_parameters import BaseParametersResult
from .drive_terms import DriveIdentificationResult, seen_by_motors
from .fits import LOAD, Data, Fit, fitted_forces, linear_system
from .least_squares import departure, tail
from .parameters import ParameterVector, inertial_parameters
from .physical import Negative, negative

# Largest error, in standard deviations, that the nonlinearity of a fit may cause.
_BENT = 0.1
# Significance level: a correct model with the specified noise causes a warning with this probability.
LEVEL = 1e-3
# Largest inflation factor of the standard deviations; fits with a larger factor are rejected.
_MOST_INFLATION = 3.0
# Number of cosines over time, for each leg, in the test for a smooth residual of the forces.
_COSINES = 20
# Number of samples in the finite differences of the fitted forces.
_NEAR = 7
# Relative residual below which a column is explained completely by the fit.
_NEW = 1e-8
# Largest ratio (sums of squares) of smooth residual to explained part that a lag alone may cause.
_BEYOND_FIRST_ORDER = 0.25
# Warnings about changes during the measurement: of the load, and of the force of each leg.
_CHANGES = (
    "load: the mass or first moment of the platform changes during the measurement, {:.3g} times as much "
    "as expected from noise; keep the load constant and avoid drift of the force sensors",
    "drift: the forces drift during the measurement, {:.3g} times as much as expected from noise; use "
    "sensors with a constant zero, and keep the load constant",
)
EXACT = ("motion: is taken as exact; state the pose noise if the poses were measured",)


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
        Smallest p-value, multiplied by the number of tests, of the tests for a smooth residual, a changing
        load, drifting forces, and a time lag. It does not depend on the specified size of the noise.
    inflation_factor : float
        Factor of the standard deviations computed from the residual, at least 1.
    verdict : str
        "consistent"; "misfit" if ``p_noise`` or ``p_model`` is below 0.001. "untested" if there are not more
        forces than unknowns. "rejected" if the inflation factor would exceed 3, the fit did not converge, or
        it is not linear within its standard deviations.
    warnings : tuple of str
        One message for each reason of the verdict.
    nonphysical : tuple of str
        One message for each value that no physical body has, more than four standard deviations below zero.
    near_zero : tuple of str
        One message for each value below zero that is not distinguishable from zero.
    motion : Motion
        Motion along which the parameters were estimated, shape (...).
    parameters : ParameterVector, optional
        All 148 parameters of possible bodies, with ``enforce_physical``.
    unconstrained : IdentificationResult, optional
        Estimate without the restriction to possible bodies, with ``enforce_physical``.
    drive : DriveIdentificationResult, optional
        Drive terms, if requested.
    force_lag : tuple of float, optional
        Time lag of the forces behind the measured poses (s) and its standard deviation, estimated from the
        residual. The other values are not corrected for the lag.
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
    parameters: ParameterVector | None = None
    unconstrained: IdentificationResult | None = None
    drive: DriveIdentificationResult | None = None
    force_lag: tuple[float, float] | None = None

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


def tested_estimate(data: Data, fit: Fit, remedy: tuple[str, ...]) -> IdentificationResult:
    """Create the result of a fit with the tests of its residual; ``remedy`` is added to any warnings."""
    r = np.concatenate([part.ravel() for part in fit.parts])
    spare = len(r) - data.left_out - fit.unknowns
    misfit = math.sqrt(float(r @ r) / spare) if spare > 0 else math.nan
    noise_misfit, p_noise, noise_doubts = _noise_test(fit, data.left_out)
    lag, (smooth_misfit, p_smooth), changes = _model_tests(data, fit, r)
    tests = 3.0 if lag is None else 4.0
    doubts = list(noise_doubts) if p_noise < LEVEL else []
    inflation = max(1.0, noise_misfit) if p_noise < LEVEL else 1.0
    if lag is not None and lag.named:
        inflation = max(inflation, lag.inflation)
    if tests * p_smooth < LEVEL:
        inflation = max(inflation, smooth_misfit)
        beside = "noise" if smooth_misfit >= 1.0 else "the specified noise, which exceeds the scatter"
        doubts.append(
            f"forces: differ smoothly from the model, {smooth_misfit:.2f} times as much as expected from "
            f"{beside}; model all moving parts, friction, and load, and check the poses"
        )
    for (changed, p_changed), text in zip(changes, _CHANGES, strict=True):
        if tests * p_changed < LEVEL:
            inflation = max(inflation, min(changed, _MOST_INFLATION))
            doubts.append(text.format(changed))
            break  # A changing load also causes a drift.
    if not fit.converged:
        doubts.append("fit: did not converge; reduce the noise or use a motion with more excitation")
    elif fit.curvature > _BENT:
        doubts.append(
            f"fit: is not linear within its standard deviations (error: {fit.curvature:.2g} of them); reduce "
            "the noise or use a motion with more excitation"
        )
    if doubts and data.robot.has_rotors and (data.terms is None or not data.terms.of_rotors):
        doubts.append(
            "rotors: the forces are taken as motor forces with the rotor_inertia of the robot file; if it is "
            "uncertain, identify reflected_mass; for forces measured in the legs, remove rotor_inertia"
        )
    if lag is not None and lag.named:
        doubts.insert(0 if lag.alone else len(doubts), lag.doubt)
    rejected = inflation > _MOST_INFLATION or not fit.converged or fit.curvature > _BENT
    verdict = "rejected" if rejected else "misfit" if doubts else "consistent" if spare > 0 else "untested"
    unknowns, rank = len(fit.values), data.base.rank
    covariance = np.diag(np.full(unknowns, np.inf)) if rejected else inflation**2 * fit.covariance
    values, own = fit.values[:rank], covariance[:rank, :rank]
    below = Negative((), ()) if rejected else negative(data.robot, data.base, values, own)
    terms = data.terms
    return IdentificationResult(
        base=data.base,
        values=values,
        covariance=own,
        normalized_residual=misfit,
        p_noise=p_noise,
        p_model=min(
            1.0, *(tests * p for p in (p_smooth, *(p for _, p in changes), 1.0 if lag is None else lag.p))
        ),
        inflation_factor=inflation,
        verdict=verdict,
        warnings=(*doubts, *(remedy if doubts else ())),
        nonphysical=below.impossible,
        near_zero=below.near_zero,
        motion=fit.motion,
        drive=None if terms is None else terms.estimate(fit.values[rank:], covariance[rank:, rank:]),
        force_lag=None if lag is None else (lag.time, lag.sigma),
    )


class _Lag(NamedTuple):
    """Time lag of the forces behind the poses (s), with its standard deviation and p-value.

    Attributes
    ----------
    inflation : float
        Inflation factor of the standard deviations that accounts for the effect of the lag on the values.
    column : ndarray, shape (rows,)
        Effect of a lag of 1 s on the residual, without the part that the unknowns explain.
    named : bool
        True if the lag explains most of the residual.
    alone : bool
        True if the lag is the only significant effect.
    """

    time: float
    sigma: float
    p: float
    inflation: float
    column: Array
    named: bool = False
    alone: bool = False

    @property
    def doubt(self) -> str:
        """Warning about the lag, in one line."""
        how = "lag" if self.time > 0.0 else "are ahead of"
        size = f"the poses by {1e3 * abs(self.time):.3g} +- {1e3 * self.sigma:.2g} ms"
        if not self.alone:
            return (
                f"times: a time error, at which the forces {how} {size}, explains part of the residual, as "
                "may effects missing from the model; correct the times only if the model is complete"
            )
        return f"times: the forces {how} {size}; shift the times of the forces or the poses by this amount"


def _model_tests(
    data: Data, fit: Fit, r: Array
) -> tuple[_Lag | None, tuple[float, float], list[tuple[float, float]]]:
    """Test for a lag behind measured poses, for a smooth residual of the forces, and for ``_CHANGES``.

    If a lag explains the residual, the other tests apply to the remaining residual.
    """
    line = np.linspace(-1.0, 1.0, len(fit.parts[0]))
    drifting = np.asarray(np.kron(line[:, None], np.eye(LEGS)), dtype=np.float64)
    added = (_smooth_forces(fit), _changing_load(data, fit), drifting)
    smooth, *changes = (_gain_test(fit, r, forces, data.left_out) for forces in added)
    lag = _lag(data, fit, r)
    if lag is None or 4.0 * lag.p >= LEVEL:
        return lag, smooth, changes
    unit = lag.column / np.linalg.norm(lag.column)
    other, left = fit._replace(beside=unit), r - unit * (unit @ r)
    rest = [_gain_test(other, left, forces, data.left_out) for forces in added]
    explained = float(unit @ r) ** 2
    beside = added[0].shape[1] * rest[0][0] ** 2
    # The effect of a lag of several samples is not linear in the lag.
    alone = all(4.0 * p >= LEVEL for _, p in rest) or beside < _BEYOND_FIRST_ORDER * explained
    if alone or explained > beside:
        return lag._replace(named=True, alone=alone), rest[0], rest[1:]
    return lag, smooth, changes


def _lag(data: Data, fit: Fit, r: Array) -> _Lag | None:
    """Estimate the lag of a joint fit to first order; return None if it cannot be identified."""
    if fit.time is None:
        return None
    F = fitted_forces(data, fit)
    column = np.zeros(len(r))
    column[: F.size] = (-_rates(fit.time, F) / data.deviations).ravel()
    seen = fit.unexplained(column)
    size, spare = float(np.linalg.norm(seen)), len(r) - data.left_out - fit.unknowns - 1
    if size <= _NEW * np.linalg.norm(column) or spare <= 0:
        return None
    explained = float(seen @ r / size) ** 2
    rest = (float(r @ r) - explained) / spare
    time, p = float(seen @ r) / size**2, tail(explained / rest, 1, spare) if rest > 0.0 else 1.0
    off = time * fit.factors.solve(column)[: len(fit.values)] / np.sqrt(np.diagonal(fit.covariance))
    return _Lag(time, max(1.0, math.sqrt(rest)) / size, p, math.sqrt(1.0 + float(np.mean(off**2))), seen)


def _rates(time: Array, values: Array) -> Array:
    """Differentiate values (n, m) at times (s), shape (n,), by polynomials through ``_NEAR`` samples."""
    n, near = len(time), min(_NEAR, len(time))
    first = np.clip(np.arange(n) - near // 2, 0, n - near)
    at = first[:, None] + np.arange(near)
    x = (time[at] - time[:, None]) / np.ptp(time[at], axis=1)[:, None]
    apart = x[:, :, None] - x[:, None, :] + np.eye(near)
    b = 1.0 / apart.prod(axis=-1)
    own = at == np.arange(n)[:, None]
    factors = np.where(own, 0.0, -b / np.where(own, 1.0, x) / b[own][:, None])
    factors[own] = -factors.sum(axis=1)
    factors /= np.ptp(time[at], axis=1)[:, None]
    return np.asarray(np.einsum("nk,nkm->nm", factors, values[at]))


def _noise_test(fit: Fit, left_out: int) -> tuple[float, float, tuple[str, ...]]:
    """Compare the RMS residual of forces and poses with the specified noise.

    Return the largest ratio, its p-value, and warnings about ratios that are too large; ``left_out`` is the
    number of ignored forces.
    """
    worst, p, doubts = 0.0, 1.0, []
    shares = fit.factors.shares([part.size for part in fit.parts])
    for name, part, share, absent in zip(("forces", "poses"), fit.parts, shares, (left_out, 0), strict=False):
        spare = part.size - absent - share
        if spare < 1.0:
            continue
        ratio = float(np.sum(part**2)) / spare
        own = min(len(fit.parts), 2) * tail(ratio, spare)
        worst, p = max(worst, math.sqrt(ratio)), min(p, own)
        if own < LEVEL:
            doubts.append(
                f"{name}: expected a residual of the size of the specified noise, got {math.sqrt(ratio):.3g} "
                "times this size"
            )
    return worst, p, tuple(doubts)


def _smooth_forces(fit: Fit) -> Array:
    """Return slow cosines over time for each leg, shape (6 n, count)."""
    n = len(fit.parts[0])
    order = np.arange(min(_COSINES, n // 8))
    cosines = np.cos(math.pi / n * np.outer(np.arange(n) + 0.5, order))
    return np.asarray(np.kron(cosines, np.eye(LEGS)), dtype=np.float64)


def _changing_load(data: Data, fit: Fit) -> Array:
    """Return the forces due to a gradual change of mass and first moment of the platform, shape (6 n, 4)."""
    own = [i for i, name in enumerate(data.base.names) if name in LOAD]
    A = linear_system(data, fit.motion)[0].reshape(-1, LEGS, len(fit.values))[..., own]
    change = np.cos(math.pi / len(A) * (np.arange(len(A)) + 0.5))
    added = (change[:, None, None] * A).reshape(-1, len(own))
    return np.asarray(added / np.maximum(np.linalg.norm(added, axis=0), np.finfo(np.float64).tiny))


def _gain_test(fit: Fit, r: Array, forces: Array, left_out: int) -> tuple[float, float]:
    """Return normalized RMS and p-value of the residual that added forces, shape (6 n, count), explain."""
    added = np.zeros((len(r), forces.shape[1]))
    added[: len(forces)] = forces
    size = np.linalg.norm(forces, axis=0).max(initial=0.0)
    span, sizes, _ = np.linalg.svd(fit.unexplained(added), full_matrices=False)
    span = span[:, sizes > _NEW * size]
    extra = span.shape[1]
    spare = len(r) - left_out - fit.unknowns - extra
    if extra == 0 or spare <= 0:
        return math.nan, 1.0
    explained = float(np.sum((span.T @ r) ** 2))
    rest = (float(r @ r) - explained) / spare
    return math.sqrt(explained / extra), tail(explained / extra / rest, extra, spare) if rest > 0.0 else 1.0
