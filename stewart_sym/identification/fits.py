"""Least-squares fits: linear along a known motion, or jointly with a smooth motion for measured poses."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from scipy import sparse
from scipy.interpolate import make_interp_spline

from ..dynamics.inverse_dynamics import inverse_dynamics
from ..io.array_types import Array, Flags
from ..motion.bad_rows import LIMIT
from ..motion.motion import Motion
from ..motion.sample_times import elapsed
from ..robot.robot import LEGS, Robot
from .base_parameters import BaseParametersResult
from .drive_terms import Terms
from .excitation import force_regressor
from .least_squares import Factors
from .motion_basis import (
    Basis,
    PoseNoise,
    basis_of,
    coordinates,
    motion_of,
    pose_derivatives,
    pose_residual,
)
from .parameters import regressor

# Largest numbers of Gauss-Newton steps and of halvings of a step. The fit ends at this decrease of the sum of
# squares, multiplied by the mean square if it exceeds 1, its expectation.
_STEPS, _HALVINGS, _NO_DECREASE = 30, 10, 1e-4
# Relative change of a coordinate in a finite difference.
_CHANGE = 1e-5
# Smallest number of samples per outlier, and largest number of fits without the outliers of the fit before.
_FEWEST_PER_OUTLIER, _MOST_REFITS = 100, 4


class Data(NamedTuple):
    """Arguments of ``identify``; forces with an infinite standard deviation are ignored."""

    robot: Robot
    motion: Motion
    forces: Array
    deviations: Array
    base: BaseParametersResult
    terms: Terms | None = None

    @property
    def unknowns(self) -> int:
        """Number of unknown base parameters and drive terms."""
        return self.base.rank + (0 if self.terms is None else int(self.terms.identifiable.sum()))

    @property
    def seeks_rotors(self) -> bool:
        """True if the rotors are unknowns."""
        return self.terms is not None and self.terms.of_rotors


class Fit(NamedTuple):
    """Least-squares fit, linearized at its solution.

    Attributes
    ----------
    parts : tuple of ndarray
        Residual divided by the standard deviations: of the forces and, in a joint fit, of the poses, shape
        (n, 6) each, and of the prior of the motion.
    values : ndarray, shape (m,)
        Base parameters and drive terms.
    factors : Factors
        Factors of the derivatives of ``parts`` with respect to all unknowns, ``values`` first.
    motion : Motion
        Motion of the fit.
    time : ndarray, shape (n,), optional
        Times of a joint fit (s).
    converged : bool
        False if the joint fit did not converge.
    """

    parts: tuple[Array, ...]
    values: Array
    factors: Factors
    motion: Motion
    time: Array | None = None
    converged: bool = True

    @property
    def residual(self) -> Array:
        """Residual of all rows, shape (rows,)."""
        return np.concatenate([part.ravel() for part in self.parts])


def robust_fit(data: Data, noise: PoseNoise | None) -> tuple[Data, Fit, Flags]:
    """Fit without outliers of the forces; return the data without them, the fit, and the outliers, (n,).

    An outlier is a sample with a force that differs from the model by more than ``LIMIT`` robust standard
    deviations of its leg. An outlier that disturbs the fit has an effect on the residual of other samples.
    Therefore each fit excludes at most one percent of the samples. If more samples differ from the last fit,
    the model is wrong: all these samples are returned, with the first fit and the unchanged data.
    """

    def fitted(data: Data) -> Fit:
        return exact_fit(data, data.motion) if noise is None else joint_fit(data, noise)

    used, first = data, fitted(data)
    fit, distance = first, _distances(data, first)
    most, outliers = len(distance) // _FEWEST_PER_OUTLIER, np.zeros(len(distance), dtype=bool)
    for _ in range(_MOST_REFITS):
        found = distance > max(LIMIT, float(np.sort(distance)[-most - 1]))
        if np.array_equal(found, outliers):
            break
        outliers = found
        ignored = outliers.reshape(*data.motion.shape, 1)
        used = data._replace(deviations=np.where(ignored, np.inf, data.deviations))
        fit = fitted(used)
        distance = _distances(data, fit)
    differs = distance > LIMIT
    return (data, first, differs) if differs.sum() > most else (used, fit, outliers)


def _distances(data: Data, fit: Fit) -> Array:
    """Return the largest residual of the forces of each sample, (n,), in robust standard deviations."""
    off = np.abs(data.forces - _forces(data, fit.motion, fit.values)) / data.deviations
    off = off.reshape(-1, LEGS)
    median = np.array([np.median(leg[leg > 0.0]) if leg.any() else 0.0 for leg in off.T])
    # The median of normal deviations is 0.6745 standard deviations.
    return np.asarray(np.max(off / np.maximum(median / 0.6745, 1.0), axis=1))


def exact_fit(data: Data, motion: Motion) -> Fit:
    """Fit the unknowns along an exactly known motion."""
    with np.errstate(over="ignore", invalid="ignore"):
        J = _scaled_regressor(data, motion).reshape(-1, data.unknowns)
        known = _forces(data, motion, np.zeros(data.unknowns))
        y = ((data.forces - known) / data.deviations).reshape(-1, LEGS)
    if not (np.isfinite(J).all() and np.isfinite(y).all()):
        raise ValueError("force_std: expected standard deviations for which the forces do not overflow")
    factors = Factors(J, sparse.csr_matrix((len(J), 0)))
    if (excited := factors.rank(data.base.rank)) < data.base.rank:
        raise ValueError(
            f"motion: excites {excited} of {data.base.rank} base parameters; use a motion that excites all, "
            "or pass base_parameters(robot, motion)"
        )
    values = factors.solve(y.ravel())
    return Fit((y - (J @ values).reshape(-1, LEGS),), values, factors, motion)


def _scaled_regressor(data: Data, motion: Motion) -> Array:
    """Return derivatives of the forces by all unknowns, divided by standard deviations, shape (..., 6, m)."""
    A = force_regressor(data.robot, motion, data.base)
    if data.terms is not None:
        A = np.concatenate([A, data.terms.along(data.robot, motion)], axis=-1)
    return np.asarray(A / data.deviations[..., None])


def _forces(data: Data, motion: Motion, values: Array) -> Array:
    """Compute the forces (N), shape (..., 6), along a motion with the load of the measured one."""
    robot, base = data.robot, data.base
    found = inverse_dynamics(robot, motion)
    Y = base.reduce(regressor(robot, motion, columns=base.required_columns()))
    wrench = Y @ values[: base.rank] - motion.external_wrench()
    F = np.linalg.solve(found.H, wrench[..., None])[..., 0]
    if robot.has_rotors and not data.seeks_rotors:
        F = F + found.F - inverse_dynamics(replace(robot, drive=None), motion).F
    if data.terms is not None:
        F = F + data.terms.along(robot, motion) @ values[base.rank :]
    return np.asarray(F)


def joint_fit(data: Data, noise: PoseNoise) -> Fit:
    """Fit motion and parameters jointly by the Gauss-Newton method."""
    q, weights = coordinates(data.motion, noise), noise.weights
    basis, c = basis_of(noise, q)
    if 6 * basis.size + data.unknowns >= 2 * q.size + basis.prior.shape[0]:
        raise ValueError(f"pose_noise: expected more than {len(q)} samples for motion and parameters")
    values = exact_fit(data, motion_of(basis.coordinates(c), data.motion)).values
    parts = _residuals(data, weights, basis, values, c)
    for _ in range(_STEPS):
        factors = _factors(data, weights, basis, values, c)
        motion = motion_of(basis.coordinates(c), data.motion)
        fit = Fit(parts, values, factors, motion, elapsed(noise.time))
        step = factors.solve(fit.residual)
        decrease = float(fit.residual @ factors.product(step))
        if decrease < _NO_DECREASE * max(1.0, float(np.mean(fit.residual**2))):
            return fit
        for size in 0.5 ** np.arange(_HALVINGS):
            next_values = values + size * step[: data.unknowns]
            next_c = c + size * step[data.unknowns :].reshape(-1, 6)
            try:
                next_parts = _residuals(data, weights, basis, next_values, next_c)
            except ValueError:
                continue  # A pose is unsolvable.
            if _squares(next_parts) < _squares(parts):
                break
        else:
            break
        values, c, parts = next_values, next_c, next_parts
    return fit._replace(converged=False)


def _residuals(data: Data, weights: Array, basis: Basis, values: Array, c: Array) -> tuple[Array, ...]:
    """Compute the residuals of forces, poses, and prior divided by their standard deviations."""
    motion = motion_of(basis.coordinates(c), data.motion)
    off = (data.forces - _forces(data, motion, values)) / data.deviations
    return off, pose_residual(data.motion, motion, weights), -(basis.prior @ c.ravel())


def _squares(parts: tuple[Array, ...]) -> float:
    """Return the sum of squares."""
    return float(sum(np.sum(part**2) for part in parts))


def _factors(data: Data, weights: Array, basis: Basis, values: Array, c: Array) -> Factors:
    """Factorize the derivatives of the scaled forces, poses, and prior by values and coefficients."""
    at = basis.coordinates(c)
    A = _scaled_regressor(data, motion_of(at, data.motion)).reshape(-1, data.unknowns)
    by_coordinates = _force_derivatives(data, at, values) / data.deviations[..., None]
    local = basis.rows(by_coordinates), basis.rows(pose_derivatives(at, weights)[None]), basis.prior
    return Factors(A, sparse.vstack(local, "csr"))


def _force_derivatives(data: Data, at: Array, values: Array) -> Array:
    """Compute the derivatives of the forces by coordinates and their rates, shape (3, n, 6, 6)."""
    found = np.empty((*at.shape[:2], LEGS, 6))
    for order, change in enumerate(_CHANGE * np.ptp(at, axis=1).max(axis=1)):
        for axis, unit in enumerate(np.eye(6)):
            shifted = np.repeat(at[:, None], 2, axis=1)
            shifted[order] += change * np.array([unit, -unit])[:, None]
            rise, fall = _forces(data, motion_of(shifted, data.motion), values)
            found[order, ..., axis] = (rise - fall) / (2.0 * change)
    return found


def force_rates(data: Data, fit: Fit) -> Array:
    """Compute the rates of the forces of a joint fit (N/s), shape (n, 6)."""
    time, forces = fit.time, _forces(data, fit.motion, fit.values)
    return np.asarray(make_interp_spline(time, forces, min(5, len(forces) - 1))(time, 1))
