"""What identification hands back: base parameters with their covariance and a verdict on the fit.

The verdict is whether model and stated noise explain the residual: its size, its smooth part, a load that
changes, forces that drift.
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

# By how many of its deviations a fit may be off as it is not linear within these.
_BENT = 0.1
# A misfit is named where a right model with the stated noise would show one this rarely.
LEVEL = 1e-3
# Deviations are not inflated by more than this: the fit is rejected.
_MOST_INFLATION = 3.0
# Cosines over the instants, for each leg, by which the forces may still differ smoothly from the fitted ones.
_COSINES = 20
# Instants by which the fitted forces are differentiated.
_NEAR = 7
# Share of a column below which what the fit leaves of it counts as nothing.
_NEW = 1e-8
# Smooth residual beside what a lag explains of it, both as sums of squares, that may come of the lag too.
_BEYOND_FIRST_ORDER = 0.25
# What is said of changes on the way: of the load, and of each leg's force.
_CHANGES = (
    "load: the platform's mass or first moment changes on the way, {:.3g} times as much as by noise: "
    "expected a load that stays as it is, and forces that do not drift",
    "drift: forces change steadily on the way, {:.3g} times as much as by noise: expected sensors whose "
    "zeros stay as they are, and a load that does",
)
EXACT = ("motion: is taken as exact, expected its noise if its poses were measured",)


@dataclass(frozen=True, eq=False)
class IdentificationResult:
    """Base parameters identified from forces, and whether model and stated noise explain the measurement.

    Attributes
    ----------
    base : BaseParametersResult
        What they are.
    values : ndarray
        SI, (rank,).
    covariance : ndarray
        (rank, rank), inflated by the square of ``inflation_factor``; infinite on its diagonal if the fit is
        rejected.
    normalized_residual : float
        RMS of the residual over its expectation, near 1 if model and noise are right.
    p_noise : float
        Probability of so large a residual under the stated noise.
    p_model : float
        Probability of so large a smooth part of the residual, or of one that a changing load, forces that
        drift or forces that lag measured poses explain so well; it does not depend on the stated size of the
        noise.
    inflation_factor : float
        Factor on the deviations, at least 1, from the residual.
    verdict : str
        "consistent"; "misfit": one of the two is below 0.001; "rejected": inflation would be above 3, or the
        fit did not converge or is not linear within its deviations; "untested": no more forces than unknowns.
    warnings : tuple
        A line for each reason.
    nonphysical : tuple
        A line for each value that no machine can have, more than four deviations below zero.
    near_zero : tuple
        A line for each value that is below zero by less: not distinguishable from 0.
    motion : Motion
        Along which the parameters were estimated, (...).
    parameters : ParameterVector, optional
        Of possible bodies that have these values, (148,), if they were requested.
    unconstrained : IdentificationResult, optional
        The estimate that was not kept to possible bodies, then.
    drive : DriveIdentificationResult, optional
        Terms of the drives, if they were sought.
    force_lag : tuple of float, optional
        By how much the forces lag the poses, s, as the residual shows it, and its standard deviation; of
        measured poses alone. The values are those of no lag.
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
        """Standard deviation of each value, (rank,)."""
        return np.sqrt(np.diagonal(self.covariance))

    def compare_with(self, robot: Robot) -> tuple[Array, float]:
        """How far the values, of ``unconstrained`` where there is one, are from a robot's.

        Parameters
        ----------
        robot : Robot
            The machine. Where terms of drives were sought, viscous friction of its drives counts as that of
            the prismatic joints, of which forces of motors do not tell it apart.

        Returns
        -------
        off : ndarray
            Differences in standard deviations, positive where the estimate is larger, (rank,); 0 if the fit
            is rejected.
        p : float
            The p-value of all: the probability that a robot with its own parameters would be identified so
            far from these or farther; 1 if the fit is rejected.
        """
        if self.unconstrained is not None:
            return self.unconstrained.compare_with(robot)
        robot = robot if self.drive is None else seen_by_motors(robot)
        off = self.values - self.base.matrix @ inertial_parameters(robot).values
        if not np.isfinite(self.covariance).all():
            return np.zeros(len(off)), 1.0
        return departure(off, self.covariance)


def tested_estimate(data: Data, fit: Fit, remedy: tuple[str, ...]) -> IdentificationResult:
    """The estimate of a fit whose residual was tested; ``remedy``: doubts to give where it fails."""
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
        beside = "noise" if smooth_misfit >= 1.0 else "the stated noise, which is more than their scatter"
        doubts.append(
            f"forces: differ smoothly from the model's, {smooth_misfit:.2f} times as much as by {beside}: "
            "expected a model of all that moves, its friction and load, and poses that follow the motion"
        )
    for (changed, p_changed), text in zip(changes, _CHANGES, strict=True):
        if tests * p_changed < LEVEL:
            inflation = max(inflation, min(changed, _MOST_INFLATION))
            doubts.append(text.format(changed))
            break  # A load that changes looks like a drift too.
    if not fit.converged:
        doubts.append("fit: did not converge, expected a smaller noise or a motion that excites more")
    elif fit.curvature > _BENT:
        doubts.append(
            f"fit: is not linear within its deviations, off by {fit.curvature:.2g} of them: expected a "
            "smaller noise or a motion that excites more"
        )
    if doubts and data.robot.has_rotors and (data.terms is None or not data.terms.of_rotors):
        doubts.append(
            "rotors: forces are taken as the motors', with the rotor_inertia of the robot file: if it is not "
            "sure, seek reflected_mass of the drive; of forces measured in the legs, leave rotor_inertia out"
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
    """By how much forces lag the poses, s, with its deviation, and the probability of so large a one.

    inflation: of the deviations, from what it changes of the values. column: what a lag of 1 s adds to the
    residual, without what the unknowns can explain. named: whether it explains most of the residual. alone:
    whether nothing else is missing.
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
        """One line about it."""
        how = "lag" if self.time > 0.0 else "are ahead of"
        size = f"the poses by {1e3 * abs(self.time):.3g} +- {1e3 * self.sigma:.2g} ms"
        if not self.alone:
            return (
                f"times: forces that {how} {size} would explain a part of it, as may what is missing in the "
                "model: shift the times of one only if nothing is"
            )
        return f"times: the forces {how} {size}: expected both at the same times, shift those of one by it"


def _model_tests(
    data: Data, fit: Fit, r: Array
) -> tuple[_Lag | None, tuple[float, float], list[tuple[float, float]]]:
    """Lag of forces behind measured poses, and ``_gain_test`` of smooth forces and of ``_CHANGES``.

    Where a lag explains the residual, these are of what it leaves.
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
    # What a lag of several rows changes is not linear in it.
    alone = all(4.0 * p >= LEVEL for _, p in rest) or beside < _BEYOND_FIRST_ORDER * explained
    if alone or explained > beside:
        return lag._replace(named=True, alone=alone), rest[0], rest[1:]
    return lag, smooth, changes


def _lag(data: Data, fit: Fit, r: Array) -> _Lag | None:
    """The lag of a joint fit, to first order; None of another fit, and where forces don't show it."""
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
    """Rates of values, (n, m), at times, s, (n,), by polynomials through ``_NEAR`` of them around each."""
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
    """Largest RMS residual of forces or poses over its expectation, its p-value, and which are too large.

    left_out: forces that do not count.
    """
    worst, p, doubts = 0.0, 1.0, []
    shares = fit.factors.shares(fit.parts[0].size)
    for name, part, share, absent in zip(("forces", "poses"), fit.parts, shares, (left_out, 0), strict=False):
        spare = part.size - absent - share
        if spare < 1.0:
            continue
        ratio = float(np.sum(part**2)) / spare
        own = len(fit.parts) * tail(ratio, spare)
        worst, p = max(worst, math.sqrt(ratio)), min(p, own)
        if own < LEVEL:
            doubts.append(
                f"{name}: expected a residual of the stated noise, got {math.sqrt(ratio):.3g} times as much"
            )
    return worst, p, tuple(doubts)


def _smooth_forces(fit: Fit) -> Array:
    """Slow cosines over the instants on each leg, (6 n, count)."""
    n = len(fit.parts[0])
    order = np.arange(min(_COSINES, n // 8))
    cosines = np.cos(math.pi / n * np.outer(np.arange(n) + 0.5, order))
    return np.asarray(np.kron(cosines, np.eye(LEGS)), dtype=np.float64)


def _changing_load(data: Data, fit: Fit) -> Array:
    """Forces of a platform whose mass and first moment change from first to last instant, (6 n, 4)."""
    own = [i for i, name in enumerate(data.base.names) if name in LOAD]
    A = linear_system(data, fit.motion)[0].reshape(-1, LEGS, len(fit.values))[..., own]
    change = np.cos(math.pi / len(A) * (np.arange(len(A)) + 0.5))
    added = (change[:, None, None] * A).reshape(-1, len(own))
    return np.asarray(added / np.maximum(np.linalg.norm(added, axis=0), np.finfo(np.float64).tiny))


def _gain_test(fit: Fit, r: Array, forces: Array, left_out: int) -> tuple[float, float]:
    """RMS over its expectation of what added forces, (6 n, count), would explain of the residual; p-value."""
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
