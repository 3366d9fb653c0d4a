"""Identification: base parameters with their standard deviations from measured actuator forces.

    F = H^-1 (Y pi - [R F_ext; R M_ext]) + noise

is linear in the base parameters, so weighted least squares finds them along a motion that is known exactly.
Poses measured with noise are errors in the regressor: there the motion is a series with unknown
coefficients, fitted together with the parameters to poses and forces (maximum likelihood). Of the robot
file only geometry and gravity are used. Every fit is tested by its residual; ``Estimate.verdict`` says with
what result.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..dynamics.equations import force_derivatives
from ..dynamics.inverse import inverse_dynamics, need_motion, need_universal
from ..io.arguments import finite_array, instance, real_array, truth
from ..io.extras import need
from ..motion.motion import Motion
from ..motion.rotation import rotation_from_vector
from ..motion.smooth_motion import (
    WITHOUT_PERIOD,
    Basis,
    PoseNoise,
    chain,
    coordinates,
    from_best,
    pose_fit,
    residual,
)
from ..robot.robot import LEGS, Robot
from .base_parameters import BaseParameters, base_parameters
from .excitation import Excitation, force_regressor, need_seed
from .parameters import Parameters, inertial_parameters, is_friction, with_parameters
from .physical import POSSIBLE, Negative, negative, possible_fit

Array = NDArray[np.float64]

# Draws of errors by which a fit is seen to be linear within them, and what is too far from it, in deviations.
_DRAWS, _BENT = 8, 0.1
# Singular values below this share of the largest say that the motion does not excite all parameters.
_ROUNDING = 1e-12
# A misfit is named where a right model with the stated noise would show one this rarely.
_LEVEL = 1e-3
# Deviations are not inflated by more than this: the fit is rejected.
_MOST_INFLATION = 3.0
# Cosines over the instants, for each leg, by which the forces may still differ smoothly from the fitted ones.
_COSINES = 20
# Length beside that of a cosine below which the fit explains it already.
_NEW = 1e-8
# Steps of the joint fit, halvings of one, and the decrease of the sum of squares that counts as none.
_STEPS, _HALVINGS, _NO_DECREASE = 30, 10, 1e-4

# Parameters of the platform that a payload taken up, dropped or shifted changes.
_LOAD = ("M", "h_P_x", "h_P_y", "h_P_z")

_EXACT = ("motion: is taken as exact, expected its noise if its poses were measured",)


@dataclass(frozen=True, eq=False)
class Estimate:
    """Base parameters identified from forces, and whether model and stated noise explain the measurement.

    Attributes
    ----------
    base : BaseParameters
        What they are.
    values : ndarray
        SI, (rank,).
    covariance : ndarray
        (rank, rank), inflated by the square of ``inflation``; infinite on its diagonal if the fit is
        rejected.
    misfit : float
        RMS of the residual over its expectation, near 1 if model and noise are right.
    p_noise : float
        Probability of so large a residual under the stated noise.
    p_model : float
        Of so large a smooth part of it, or one that a changing load explains so well, whatever the size of
        the noise.
    inflation : float
        Factor on the deviations, at least 1, from the residual.
    verdict : str
        "consistent"; "misfit": one of the two is below 0.001; "rejected": inflation would be above 3, or the
        fit did not converge or is not linear within its deviations; "untested": no more forces than unknowns.
    doubts : tuple
        A line for each reason.
    impossible : tuple
        A line for each value that no machine can have, more than four deviations below zero.
    near_zero : tuple
        A line for each value that is below zero by less: not distinguishable from 0.
    motion : Motion
        Along which the parameters were estimated, (...).
    parameters : Parameters, optional
        Of possible bodies that have these values, (148,), if they were asked for.
    free : Estimate, optional
        The estimate that was not kept to possible bodies, then.
    """

    base: BaseParameters
    values: Array
    covariance: Array
    misfit: float
    p_noise: float
    p_model: float
    inflation: float
    verdict: str
    doubts: tuple[str, ...]
    impossible: tuple[str, ...]
    near_zero: tuple[str, ...]
    motion: Motion
    parameters: Parameters | None = None
    free: Estimate | None = None

    @property
    def sigma(self) -> Array:
        """Standard deviation of each value, (rank,)."""
        return np.sqrt(np.diagonal(self.covariance))

    def departure(self, robot: Robot) -> tuple[Array, float]:
        """How far the values are from a robot's: in standard deviations, (rank,), and the p-value of all.

        The probability that a robot with its own parameters would be identified so far from these or farther;
        1 if the fit is rejected.
        """
        if self.free is not None:
            return self.free.departure(robot)
        off = self.values - self.base.matrix @ inertial_parameters(robot).values
        if not np.isfinite(self.covariance).all():
            return np.zeros(len(off)), 1.0
        sigma = self.sigma
        squares = off / sigma @ np.linalg.solve(self.covariance / np.outer(sigma, sigma), off / sigma)
        return off / sigma, _tail(float(squares) / len(off), len(off))


@dataclass(frozen=True, eq=False)
class Experiment:
    """A simulated measurement and what it tells.

    Attributes
    ----------
    excitation : Excitation
        The motion.
    measured : Motion
        Its poses as measured, with noise if there is any.
    F : ndarray
        Noisy forces, N, (n, 6).
    sigma : float
        Their standard deviation, N.
    noise : PoseNoise
        Of the poses, None if they are exact.
    truth : ndarray
        The base parameters of the robot, (rank,).
    estimate : Estimate
        From F.
    """

    excitation: Excitation
    measured: Motion
    F: Array
    sigma: float
    noise: PoseNoise | None
    truth: Array
    estimate: Estimate

    @property
    def deviation(self) -> Array:
        """Error of each estimate in its standard deviations, (rank,)."""
        return np.asarray((self.estimate.values - self.truth) / self.estimate.sigma)


def identify(
    robot: Robot,
    motion: Motion,
    F: ArrayLike,
    sigma: ArrayLike,
    base: BaseParameters | None = None,
    noise: PoseNoise | None = None,
    physical: bool = False,
) -> Estimate:
    """Estimate the base parameters by weighted least squares, and test the residual.

    All noise is taken as normal and independent.

    Parameters
    ----------
    robot : Robot
        Its geometry and gravity count, the rest may be wrong.
    motion : Motion
        Measured, with any load, (...).
    F : array_like
        Measured actuator forces, N, (..., 6).
    sigma : array_like
        Standard deviation of each force, N, broadcasts to F's shape.
    base : BaseParameters, optional
        None for ``base_parameters(robot)``.
    noise : PoseNoise, optional
        Of the poses at n instants, of which only these and the load then count; the rates are those of the
        smooth motion that explains poses and forces best, and the deviations hold the noise of both. None:
        the motion, with its accelerations, is taken as exact.
    physical : bool, optional
        Keep to bodies that can exist; what the forces do not decide is then as near as can be to the robot's
        own bodies, all 148 parameters are given, and the deviations take that into account. Needs SciPy.

    Returns
    -------
    Estimate
        Values with their covariance, and what the residual shows.

    Raises
    ------
    ValueError
        For wrong shapes, for sigma not > 0, for unsolvable poses, and for a motion that does not excite every
        base parameter; pass ``base_parameters(robot, motion)`` to identify what it does excite.
    """
    need_universal(robot)
    truth(physical, "physical")
    if physical:
        need("scipy", POSSIBLE)
    if isinstance(noise, PoseNoise) and noise.period is None:
        need("scipy", WITHOUT_PERIOD)
    if noise is None:
        need_motion(robot, motion)
    if base is None:
        base = base_parameters(robot)
    instance(motion, Motion, "motion")
    instance(base, BaseParameters, "base")
    forces = finite_array(F, (LEGS,), "F")
    if forces.shape != (*motion.shape, LEGS):
        raise ValueError(f"F: expected forces of shape {(*motion.shape, LEGS)}, got {forces.shape}")
    data = _Data(robot, motion, forces, _deviations(sigma, forces.shape), base)
    if noise is None:
        found = _tested(data, _exact_fit(data, motion), _EXACT)
    else:
        instance(noise, PoseNoise, "noise")
        found = _tested(data, _joint_fit(data, noise), ())
    return _possible(robot, found) if physical and found.verdict != "rejected" else found


def simulated_experiment(
    robot: Robot,
    excited: Excitation,
    sigma: float,
    seed: int = 0,
    noise_position: float = 0.0,
    noise_angle: float = 0.0,
) -> Experiment:
    """Measure the robot's forces along a motion with normal noise and identify it from them.

    Parameters
    ----------
    robot : Robot
        The machine.
    excited : Excitation
        Motion, as from ``choose_excitation``.
    sigma : float
        Standard deviation of every force, N, > 0.
    seed : int, optional
        Of the noise, which is independent of what ``choose_excitation`` draws from the same seed.
    noise_position, noise_angle : float, optional
        Of the measured poses, m and rad, both 0 or both > 0; with noise, only poses are measured.

    Returns
    -------
    Experiment
        Motion, forces, estimate and true values.
    """
    instance(excited, Excitation, "excited")
    need_seed(seed)
    exact = inverse_dynamics(robot, excited.motion).F
    deviation = float(_deviations(sigma, ()))
    rng = np.random.default_rng((seed, 1))
    F = exact + deviation * rng.normal(size=exact.shape)
    motion, path, noise = excited.motion, excited.path, None
    if noise_position != 0.0 or noise_angle != 0.0:
        noise = PoseNoise(excited.time, noise_position, noise_angle, path.period, len(path.sine))
        shift, turn = rng.normal(size=(2, len(excited.time), 3))
        R = rotation_from_vector(noise.angle * turn) @ motion.R
        motion = Motion(R, motion.t + noise.position * shift, motion.omega, motion.v)
    estimate = identify(robot, motion, F, deviation, excited.base, noise)
    right = excited.base.matrix @ inertial_parameters(robot).values
    return Experiment(excited, motion, F, deviation, noise, right, estimate)


class _Data(NamedTuple):
    """What ``identify`` was given."""

    robot: Robot
    motion: Motion
    forces: Array
    deviations: Array
    base: BaseParameters


class _Fit(NamedTuple):
    """A least-squares fit about its solution.

    parts: residual over deviations, of the forces and, in a joint fit, of the poses, (n, 6) each. values:
    (rank,). covariance: (rank, rank). span: orthonormal basis of what the unknowns can explain, (rows,
    unknowns).
    curvature: as ``_curvature`` returns.
    """

    parts: tuple[Array, ...]
    values: Array
    covariance: Array
    span: Array
    motion: Motion
    converged: bool = True
    curvature: float = 0.0


def _deviations(sigma: ArrayLike, shape: tuple[int, ...]) -> Array:
    expected = "standard deviations > 0 N that broadcast with F"
    values = real_array(sigma, "sigma", expected)
    if not np.all(np.isfinite(values) & (values > 0.0)):
        raise ValueError(
            f"sigma: expected {expected}, got {values[~(values > 0.0) | ~np.isfinite(values)][0]}"
        )
    try:
        return np.broadcast_to(values, shape)
    except ValueError:
        raise ValueError(f"sigma: expected {expected}, {shape}, got shape {values.shape}") from None


# The linear fit along a known motion


def _exact_fit(data: _Data, motion: Motion) -> _Fit:
    A, y = _linear(data, motion)
    J = A.reshape(-1, data.base.rank)
    felt = _felt(J)
    if felt < data.base.rank:
        raise ValueError(f"motion: excites {felt} of {data.base.rank} base parameters, expected all of them")
    span, back = _factors(J)
    values = back @ (span.T @ y.ravel())
    return _Fit(((y - A @ values).reshape(-1, LEGS),), values, back @ back.T, span, motion)


def _felt(J: Array) -> int:
    """Rank of J, its columns of length 1."""
    lengths = np.linalg.norm(J, axis=0)
    values = np.linalg.svd(
        np.linalg.qr(J / np.where(lengths > 0.0, lengths, 1.0), mode="r"), compute_uv=False
    )
    return int(np.count_nonzero(values > _ROUNDING * values[0])) if values.size else 0


def _linear(data: _Data, motion: Motion) -> tuple[Array, Array]:
    """A and y of A values = y, both over the deviations: (..., 6, rank) and (..., 6)."""
    with np.errstate(over="ignore", invalid="ignore"):
        A = force_regressor(data.robot, motion, data.base) / data.deviations[..., None]
        y = (data.forces + _load_forces(data.robot, motion)) / data.deviations
    if not (np.isfinite(A).all() and np.isfinite(y).all()):
        raise ValueError("sigma: expected standard deviations beside which the forces do not overflow")
    return A, y


def _load_forces(robot: Robot, motion: Motion) -> Array:
    """H^-1 [R F_ext; R M_ext], (..., 6)."""
    if motion.F_ext is None and motion.M_ext is None:
        return np.zeros((*motion.shape, LEGS))
    zero = np.zeros((*motion.shape, 3))
    load = [
        np.einsum("...ij,...j", motion.R, zero if vector is None else vector)
        for vector in (motion.F_ext, motion.M_ext)
    ]
    H = inverse_dynamics(robot, motion).H
    return np.asarray(np.linalg.solve(H, np.concatenate(load, axis=-1)[..., None])[..., 0])


def _factors(J: Array) -> tuple[Array, Array]:
    """Orthonormal basis of the range of J, of full rank, and B such that B basis^T is the pseudoinverse."""
    lengths = np.linalg.norm(J, axis=0)
    Q, corner = np.linalg.qr(J / lengths)
    return Q, np.linalg.inv(corner) / lengths[:, None]


# The joint fit of motion and parameters


def _joint_fit(data: _Data, noise: PoseNoise) -> _Fit:
    """The fit whose basis is the next beyond that which explains poses and forces best for its size (Akaike).

    With one size more, what a basis cannot follow of the motion stays below the noise.
    """
    q = coordinates(data.motion, noise)
    best, least, before = None, math.inf, q
    for basis in from_best(noise, q):
        if 6 * basis.size + data.base.rank >= 2 * q.size:
            break
        c = pose_fit(basis, before)
        fit, c = _gauss_newton(data, noise, basis, c)
        criterion = _squares(fit.parts) + 2.0 * 6 * basis.size
        if best is None or fit.converged:
            best = fit
        if criterion >= least:
            break
        least, before = criterion, basis.value @ c
    if best is None:
        raise ValueError(f"noise: expected more than {len(q)} instants to fit motion and parameters to")
    return best


def _gauss_newton(data: _Data, noise: PoseNoise, basis: Basis, c: Array) -> tuple[_Fit, Array]:
    """Least squares in the base parameters and, from c on, the coefficients of the motion, (m, 6)."""
    values = _exact_fit(data, basis.motion(c, data.motion)).values
    parts = _residuals(data, noise, basis, values, c)
    for _ in range(_STEPS):
        r = np.concatenate([part.ravel() for part in parts])
        span, back = _factors(_jacobian(data, noise, basis, values, c))
        along = span.T @ r
        step = back @ along
        converged = bool(along @ along < _NO_DECREASE)
        if converged:
            break
        for halving in range(_HALVINGS):
            share = 0.5**halving
            next_values = values + share * step[: data.base.rank]
            next_c = c + share * step[data.base.rank :].reshape(6, -1).T
            try:
                next_parts = _residuals(data, noise, basis, next_values, next_c)
            except ValueError:
                continue
            if _squares(next_parts) < _squares(parts):
                break
        else:
            break
        values, c, parts = next_values, next_c, next_parts
    motion = basis.motion(c, data.motion)
    spread = back[: data.base.rank]

    def residuals(by_values: Array, by_c: Array) -> Array:
        shifted = _residuals(data, noise, basis, values + by_values, c + by_c)
        return np.concatenate([part.ravel() for part in shifted])

    curvature = _curvature(residuals, span, back, data.base.rank) if converged else math.inf
    return _Fit(parts, values, spread @ spread.T, span, motion, converged, curvature), c


def _curvature(residuals: Callable[[Array, Array], Array], span: Array, back: Array, rank: int) -> float:
    """Largest RMS error of a base parameter, in deviations, since the residual is not linear in the unknowns.

    residuals: of changes of values and coefficients. Seen over opposite errors drawn as the fit states them;
    inf where such an error makes a pose unsolvable.
    """
    sigma = np.linalg.norm(back[:rank], axis=1)
    centre = residuals(np.zeros(rank), np.zeros((1, 6)))
    shifts = []
    for z in np.random.default_rng(0).normal(size=(_DRAWS, back.shape[1])):
        for errors in (z, -z):
            step = back @ errors
            try:
                changed = residuals(step[:rank], step[rank:].reshape(6, -1).T) - centre
            except ValueError:
                return math.inf
            shifts.append(back[:rank] @ (span.T @ changed + errors) / sigma)
    return float(np.max(np.sqrt(np.mean(np.square(shifts), axis=0))))


def _residuals(data: _Data, noise: PoseNoise, basis: Basis, values: Array, c: Array) -> tuple[Array, Array]:
    A, y = _linear(data, basis.motion(c, data.motion))
    return y - A @ values, residual(basis, c, data.motion, noise)


def _squares(parts: tuple[Array, ...]) -> float:
    return float(sum(np.sum(part**2) for part in parts))


def _jacobian(data: _Data, noise: PoseNoise, basis: Basis, values: Array, c: Array) -> Array:
    """Of forces and poses by base parameters and coefficients, over the deviations, (12 n, rank + 6 m)."""
    motion = basis.motion(c, data.motion)
    A, _ = _linear(data, motion)
    maps = chain(basis, c, motion)
    by_c = np.zeros((*motion.shape, LEGS, 6, basis.size))
    for slopes, parts in zip(_force_slopes(data, motion, values), maps, strict=True):
        for matrix, functions in zip(parts, basis, strict=False):
            by_c += (slopes @ matrix)[..., None] * functions[:, None, None, :]
    by_c /= data.deviations[..., None, None]
    poses = (noise.weights[:, None] * maps[0][0])[..., None] * basis.value[:, None, None, :]
    unknowns = data.base.rank
    J = np.zeros((2 * LEGS * len(by_c), unknowns + 6 * basis.size))
    J[: LEGS * len(by_c), :unknowns] = A.reshape(-1, unknowns)
    J[:, unknowns:] = np.concatenate([by_c, poses]).reshape(len(J), -1)
    return J


def _force_slopes(data: _Data, motion: Motion, values: Array) -> tuple[Array, ...]:
    """Derivatives of the forces by pose, twist and acceleration at these base parameters, (n, 6, 6) each.

    Identified parameters may belong to no machine (masses or friction below zero). Forces are linear in them,
    so they are the difference of two machines that exist.
    """
    lifted = np.zeros(data.base.matrix.shape[1])
    lifted[data.base.kept] = values
    own = inertial_parameters(data.robot)
    mass = own.names.index("M")
    lesser = np.where(is_friction(own.names), np.abs(lifted), own.values)
    lesser[mass] += abs(lifted[mass])
    unloaded = Motion(motion.R, motion.t, motion.omega, motion.v, motion.alpha, motion.a)
    more = force_derivatives(with_parameters(data.robot, lesser + lifted), motion)
    less = force_derivatives(with_parameters(data.robot, lesser), unloaded)
    return tuple(
        getattr(more, name) - getattr(less, name) for name in ("by_pose", "by_twist", "by_acceleration")
    )


# The test of the residual


def _tested(data: _Data, fit: _Fit, remedy: tuple[str, ...]) -> Estimate:
    r = np.concatenate([part.ravel() for part in fit.parts])
    spare = len(r) - fit.span.shape[1]
    misfit = math.sqrt(float(r @ r) / spare) if spare > 0 else math.nan
    noise_misfit, p_noise, noise_doubts = _noise_test(fit)
    (smooth_misfit, p_smooth), (load_misfit, p_load) = (
        _gain_test(fit, r, added) for added in (_smooth_forces(fit), _changing_load(data, fit))
    )
    doubts = list(noise_doubts) if p_noise < _LEVEL else []
    inflation = max(1.0, noise_misfit) if p_noise < _LEVEL else 1.0
    if 2.0 * p_smooth < _LEVEL:
        inflation = max(inflation, smooth_misfit)
        doubts.append(
            f"forces: differ smoothly from the model's, {smooth_misfit:.2f} times as much as by noise: "
            "expected a model of all that moves, its friction and load, and poses that follow the motion"
        )
    if 2.0 * p_load < _LEVEL:
        inflation = max(inflation, min(load_misfit, _MOST_INFLATION))
        doubts.append(
            f"load: the platform's mass or first moment changes on the way, {load_misfit:.3g} times as much "
            "as by noise: expected a load that stays as it is, and forces that do not drift"
        )
    if not fit.converged:
        doubts.append("fit: did not converge, expected a smaller noise or a motion that excites more")
    elif fit.curvature > _BENT:
        doubts.append(
            f"fit: is not linear within its deviations, off by {fit.curvature:.2g} of them: expected a "
            "smaller noise or a motion that excites more"
        )
    rejected = inflation > _MOST_INFLATION or not fit.converged or fit.curvature > _BENT
    verdict = "rejected" if rejected else "misfit" if doubts else "consistent" if spare > 0 else "untested"
    covariance = np.diag(np.full(data.base.rank, np.inf)) if rejected else inflation**2 * fit.covariance
    below = Negative((), ()) if rejected else negative(data.robot, data.base, fit.values, covariance)
    return Estimate(
        base=data.base,
        values=fit.values,
        covariance=covariance,
        misfit=misfit,
        p_noise=p_noise,
        p_model=min(1.0, 2.0 * p_smooth, 2.0 * p_load),
        inflation=inflation,
        verdict=verdict,
        doubts=(*doubts, *(remedy if doubts else ())),
        impossible=below.impossible,
        near_zero=below.near_zero,
        motion=fit.motion,
    )


def _noise_test(fit: _Fit) -> tuple[float, float, tuple[str, ...]]:
    """Largest RMS residual of forces or poses over its expectation, its p-value, and which are too large."""
    worst, p, doubts, start = 0.0, 1.0, [], 0
    for name, part in zip(("forces", "poses"), fit.parts, strict=False):
        explained = float(np.sum(fit.span[start : start + part.size] ** 2))
        spare, start = part.size - explained, start + part.size
        if spare < 1.0:
            continue
        ratio = float(np.sum(part**2)) / spare
        own = len(fit.parts) * _tail(ratio, spare)
        worst, p = max(worst, math.sqrt(ratio)), min(p, own)
        if own < _LEVEL:
            doubts.append(
                f"{name}: expected a residual of the stated noise, got {math.sqrt(ratio):.3g} times as much"
            )
    return worst, p, tuple(doubts)


def _smooth_forces(fit: _Fit) -> Array:
    """Slow cosines over the instants on each leg, (6 n, count)."""
    n = len(fit.parts[0])
    order = np.arange(min(_COSINES, n // 8))
    cosines = np.cos(math.pi / n * np.outer(np.arange(n) + 0.5, order))
    return np.asarray(np.kron(cosines, np.eye(LEGS)), dtype=np.float64)


def _changing_load(data: _Data, fit: _Fit) -> Array:
    """Forces of a platform whose mass and first moment change from first to last instant, (6 n, 4)."""
    own = [i for i, name in enumerate(data.base.names) if name in _LOAD]
    A = _linear(data, fit.motion)[0].reshape(-1, LEGS, data.base.rank)[..., own]
    change = np.cos(math.pi / len(A) * (np.arange(len(A)) + 0.5))
    added = (change[:, None, None] * A).reshape(-1, len(own))
    return np.asarray(added / np.maximum(np.linalg.norm(added, axis=0), np.finfo(np.float64).tiny))


def _gain_test(fit: _Fit, r: Array, forces: Array) -> tuple[float, float]:
    """RMS over its expectation of what added forces, (6 n, count), would explain of the residual; p-value."""
    added = np.zeros((len(r), forces.shape[1]))
    added[: len(forces)] = forces
    size = np.linalg.norm(forces, axis=0).max(initial=0.0)
    span, sizes, _ = np.linalg.svd(added - fit.span @ (fit.span.T @ added), full_matrices=False)
    span = span[:, sizes > _NEW * size]
    extra = span.shape[1]
    spare = len(r) - fit.span.shape[1] - extra
    if extra == 0 or spare <= 0:
        return math.nan, 1.0
    explained = float(np.sum((span.T @ r) ** 2))
    rest = (float(r @ r) - explained) / spare
    return math.sqrt(explained / extra), _tail(explained / extra / rest, extra, spare) if rest > 0.0 else 1.0


def _tail(ratio: float, freedom: float, other: float = math.inf) -> float:
    """Probability of an F ratio above this one; chi-square over its freedom if ``other`` is infinite.

    Paulson's normal approximation of its cube root, right to some per cent of the probability from 10 degrees
    of freedom on, to a sixth from 4 on.
    """
    a, b = 2.0 / (9.0 * freedom), 2.0 / (9.0 * other)
    root = math.cbrt(ratio)
    return 0.5 * math.erfc(((1.0 - b) * root - (1.0 - a)) / math.sqrt(2.0 * (b * root**2 + a)))


def _possible(robot: Robot, found: Estimate) -> Estimate:
    """The estimate kept to possible bodies; a misfit if these explain the forces much worse."""
    fit = possible_fit(robot, found.base, found.values, found.covariance)
    ratio = fit.squares / found.base.rank
    verdict, doubts = found.verdict, found.doubts
    if _tail(ratio, found.base.rank) < _LEVEL:
        verdict = "misfit"
        doubts = (
            *doubts,
            f"bodies: possible ones are {math.sqrt(ratio):.3g} times as far from the estimate as by noise",
        )
    return replace(
        found,
        values=fit.values,
        covariance=fit.covariance,
        verdict=verdict,
        doubts=doubts,
        impossible=(),
        near_zero=(),
        parameters=fit.parameters,
        free=found,
    )
