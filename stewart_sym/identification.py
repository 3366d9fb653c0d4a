"""Identification: base parameters with their standard deviations from measured actuator forces.

    F = H^-1 (Y pi - [R F_ext; R M_ext]) + noise

is linear in the base parameters, so weighted least squares finds them, whatever the robot file says of masses
and friction: only its geometry and gravity are used. Stands above ``excitation``; reads and writes no file.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .checks import finite_array, instance, real_array
from .dynamics import inverse_dynamics, need_motion, need_universal
from .excitation import Excitation, force_regressor, need_seed
from .identifiable import BaseParameters, base_parameters
from .motion import Motion
from .parameters import inertial_parameters
from .robot import LEGS, Robot

Array = NDArray[np.float64]

# Singular values below this share of the largest say that the motion does not excite all parameters.
_ROUNDING = 1e-12


@dataclass(frozen=True, eq=False)
class Estimate:
    """Base parameters as the forces tell them.

    base: what they are. values: SI, (rank,). covariance: (rank, rank). misfit: RMS of what is left of the
    forces beside its expectation; near 1 if model and sigma are right.
    """

    base: BaseParameters
    values: Array
    covariance: Array
    misfit: float

    @property
    def sigma(self) -> Array:
        """Standard deviation of each value, (rank,)."""
        return np.sqrt(np.diagonal(self.covariance))


@dataclass(frozen=True, eq=False)
class Experiment:
    """A simulated measurement and what it tells.

    excitation: the motion. F: noisy forces, N, (n, 6). sigma: their standard deviation, N. truth: the base
    parameters of the robot, (rank,). estimate: from F.
    """

    excitation: Excitation
    F: Array
    sigma: float
    truth: Array
    estimate: Estimate

    @property
    def deviation(self) -> Array:
        """Error of each estimate in its standard deviations, (rank,)."""
        return np.asarray((self.estimate.values - self.truth) / self.estimate.sigma)


def identify(
    robot: Robot, motion: Motion, F: ArrayLike, sigma: ArrayLike, base: BaseParameters | None = None
) -> Estimate:
    """Estimate the base parameters by weighted least squares.

    robot: its geometry and gravity count, the rest may be wrong. motion: measured, with accelerations and any
    load, (...). F: measured actuator forces, N, (..., 6). sigma: standard deviation of each force, N,
    broadcasts to F's shape. base: None for ``base_parameters(robot)``.

    The motion is taken as exact, the noise as independent. Raises ValueError for wrong shapes, for sigma not
    > 0, for poses without an answer, and for a motion that does not excite every base parameter; pass
    ``base_parameters(robot, motion)`` to identify what it does excite.
    """
    need_universal(robot)
    need_motion(robot, motion)
    if base is None:
        base = base_parameters(robot)
    instance(base, BaseParameters, "base")
    forces = finite_array(F, (LEGS,), "F")
    if forces.shape != (*motion.shape, LEGS):
        raise ValueError(f"F: expected forces of shape {(*motion.shape, LEGS)}, got {forces.shape}")
    deviations = _deviations(sigma, forces.shape)
    with np.errstate(over="ignore", invalid="ignore"):
        A = (force_regressor(robot, motion, base) / deviations[..., None]).reshape(-1, base.rank)
        y = ((forces + _load_forces(robot, motion)) / deviations).ravel()
    if not (np.isfinite(A).all() and np.isfinite(y).all()):
        raise ValueError("sigma: expected standard deviations beside which the forces do not overflow")
    return _least_squares(A, y, base)


def simulated_experiment(robot: Robot, excited: Excitation, sigma: float, seed: int = 0) -> Experiment:
    """Measure the robot's forces along a motion with normal noise and identify it from them.

    sigma: standard deviation of every force, N, > 0. seed: of the noise, which is independent of what
    ``choose_excitation`` draws from the same seed.
    """
    instance(excited, Excitation, "excited")
    need_seed(seed)
    exact = inverse_dynamics(robot, excited.motion).F
    deviation = float(_deviations(sigma, ()))
    F = exact + deviation * np.random.default_rng((seed, 1)).normal(size=exact.shape)
    estimate = identify(robot, excited.motion, F, deviation, excited.base)
    truth = excited.base.matrix @ inertial_parameters(robot).values
    return Experiment(excited, F, deviation, truth, estimate)


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


def _load_forces(robot: Robot, motion: Motion) -> Array:
    """H^-1 [R F_ext; R M_ext], (..., 6)."""
    zero = np.zeros((*motion.shape, 3))
    load = [
        np.einsum("...ij,...j", motion.R, zero if vector is None else vector)
        for vector in (motion.F_ext, motion.M_ext)
    ]
    H = inverse_dynamics(robot, motion).H
    return np.asarray(np.linalg.solve(H, np.concatenate(load, axis=-1)[..., None])[..., 0])


def _least_squares(A: Array, y: Array, base: BaseParameters) -> Estimate:
    lengths = np.linalg.norm(A, axis=0)
    U, values, V = np.linalg.svd(A / np.where(lengths > 0.0, lengths, 1.0), full_matrices=False)
    felt = int(np.count_nonzero(values > _ROUNDING * values[0])) if values.size else 0
    if felt < base.rank:
        raise ValueError(f"motion: excites {felt} of {base.rank} base parameters, expected all of them")
    back = V.T / values / lengths[:, None]
    found = back @ (U.T @ y)
    spare = len(y) - base.rank
    misfit = np.sqrt(np.sum((A @ found - y) ** 2) / spare) if spare else np.nan
    return Estimate(base, found, back @ back.T, float(misfit))
