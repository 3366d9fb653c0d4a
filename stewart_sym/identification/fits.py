"""Least-squares fits: linear along a known motion, or jointly with a smooth motion for measured poses."""

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ..dynamics.equations import force_derivatives
from ..dynamics.inverse_dynamics import inverse_dynamics
from ..io.array_types import Array
from ..motion.motion import Motion
from ..motion.sample_times import elapsed
from ..robot.drive import Drive
from ..robot.robot import LEGS, Robot
from .base_parameters import BaseParametersResult
from .drive_terms import Terms, rotor_forces
from .excitation import force_regressor
from .least_squares import Arrow, Factors, arrow, factors, solution
from .motion_basis import Basis, PoseNoise, akaike, bases, chain, coordinates, residual
from .parameters import inertial_parameters, is_friction, with_parameters

# Relative size of singular values below which the motion does not excite all parameters.
_ROUNDING = 1e-12
# Parameters of the platform that change with its payload.
LOAD = ("M", "h_P_x", "h_P_y", "h_P_z")


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
    def left_out(self) -> int:
        """Number of ignored forces."""
        return int(np.isinf(self.deviations).sum())


class Fit(NamedTuple):
    """Least-squares fit, linearized at its solution.

    Attributes
    ----------
    parts : tuple of ndarray
        Residual divided by the standard deviations: of the forces and, in a joint fit, of the poses, shape
        (n, 6) each, and of the prior of the motion.
    values : ndarray, shape (m,)
        Base parameters and drive terms.
    factors : DenseFactors or ArrowFactors
        Factors of the derivatives of ``parts`` with respect to all unknowns, ``values`` first.
    curvature : float
        Result of ``_curvature``.
    time : ndarray, shape (n,), optional
        Times of a joint fit (s).
    beside : ndarray, shape (rows,), optional
        Unit vector of an additional explained direction that is orthogonal to the unknowns of ``factors``.
    """

    parts: tuple[Array, ...]
    values: Array
    factors: Factors
    motion: Motion
    converged: bool = True
    curvature: float = 0.0
    time: Array | None = None
    beside: Array | None = None

    @property
    def unknowns(self) -> int:
        """Number of unknowns, including the unknowns of the motion."""
        return self.factors.unknowns + (0 if self.beside is None else 1)

    @property
    def covariance(self) -> Array:
        """Covariance of ``values``, shape (m, m)."""
        return self.factors.covariance(len(self.values))

    def unexplained(self, y: Array) -> Array:
        """Return the part of y, shape (rows,) or (rows, columns), that no unknown explains."""
        left = y - self.factors.explained(y)
        return left if self.beside is None else left - np.multiply.outer(self.beside, self.beside @ left)


def exact_fit(data: Data, motion: Motion) -> Fit:
    """Fit the unknowns along an exactly known motion."""
    A, y = linear_system(data, motion)
    J = A.reshape(-1, A.shape[-1])
    felt = _felt(J[:, : data.base.rank])
    if felt < data.base.rank:
        raise ValueError(
            f"motion: excites {felt} of {data.base.rank} base parameters; use a motion that excites all, or "
            "pass base_parameters(robot, motion)"
        )
    solved = factors(J)
    values = solved.solve(y.ravel())
    return Fit(((y - A @ values).reshape(-1, LEGS),), values, solved, motion)


def _felt(J: Array) -> int:
    """Return the rank of J, with columns of length 1."""
    lengths = np.linalg.norm(J, axis=0)
    values = np.linalg.svd(
        np.linalg.qr(J / np.where(lengths > 0.0, lengths, 1.0), mode="r"), compute_uv=False
    )
    return int(np.count_nonzero(values > _ROUNDING * values[0])) if values.size else 0


def linear_system(data: Data, motion: Motion) -> tuple[Array, Array]:
    """Return A and y of A values = y divided by the standard deviations, shape (..., 6, m) and (..., 6)."""
    with np.errstate(over="ignore", invalid="ignore"):
        A = force_regressor(data.robot, motion, data.base)
        if data.terms is not None:
            A = np.concatenate([A, data.terms.along(data.robot, motion)], axis=-1)
        A = A / data.deviations[..., None]
        known = _load_forces(data.robot, motion) - _forces_of_rotors(data, motion)
        y = (data.forces + known) / data.deviations
    if not (np.isfinite(A).all() and np.isfinite(y).all()):
        raise ValueError("force_std: expected standard deviations for which the forces do not overflow")
    return A, y


def _load_forces(robot: Robot, motion: Motion) -> Array:
    """Compute H^-1 [R F_ext; R M_ext], shape (..., 6)."""
    if motion.F_ext is None and motion.M_ext is None:
        return np.zeros((*motion.shape, LEGS))
    H = inverse_dynamics(robot, motion).H
    return np.asarray(np.linalg.solve(H, motion.external_wrench()[..., None])[..., 0])


def _forces_of_rotors(data: Data, motion: Motion) -> Array:
    """Compute the motor forces of the rotors in the robot file, shape (..., 6); 0 if rotors are unknowns."""
    robot = data.robot
    if robot.drive is None or not robot.has_rotors or (data.terms is not None and data.terms.of_rotors):
        return np.zeros((*motion.shape, LEGS))
    return np.asarray(rotor_forces(robot, motion, robot.drive) @ robot.reflected_mass)


# Joint fit by Gauss-Newton steps

# Largest numbers of Gauss-Newton steps and of halvings of a step. The fit ends at this decrease of the sum of
# squares, multiplied by the mean square if it exceeds 1, its expectation.
_STEPS, _HALVINGS, _NO_DECREASE = 30, 10, 1e-4
# Number of successive bases without convergence after which larger ones are not tried.
_IN_VAIN = 3
# Number of random errors in the test for linearity within the standard deviations.
_DRAWS = 8
# Lead of a screw (m) so small that the rotor acts along the leg only.
_FINE = 1e-6


def joint_fit(data: Data, noise: PoseNoise) -> Fit:
    """Fit motion and parameters jointly.

    If the number of harmonics is unknown, it is one size above the optimum of Akaike's criterion. The
    additional size keeps the approximation error of the motion below the noise.
    """
    q = coordinates(data.motion, noise)
    best, least = None, math.inf
    for basis, c in bases(noise, q):
        if 6 * basis.size + data.unknowns >= 2 * q.size + basis.prior.shape[0]:
            break
        found = _gauss_newton(data, noise, basis, c)
        if best is None or found.converged:
            best = found
        criterion = akaike(_squares(found.parts), 2 * q.size, 6 * basis.size)
        if criterion >= least:
            break
        least = criterion
    if best is None:
        raise ValueError(f"pose_noise: expected more than {len(q)} samples for motion and parameters")
    return _with_deviations(data, noise, best)


class _Solution(NamedTuple):
    """Parameters and terms (m,), coefficients of the motion (size, 6), and parts of the residual."""

    basis: Basis
    values: Array
    c: Array
    parts: tuple[Array, ...]
    converged: bool


def _gauss_newton(data: Data, noise: PoseNoise, basis: Basis, c: Array) -> _Solution:
    """Solve for the parameters and the coefficients of the motion, with initial coefficients c."""
    motion = basis.motion(c, data.motion)
    values = exact_fit(data, motion).values
    parts = _residuals(data, noise, basis, values, c)
    for _ in range(_STEPS):
        r = np.concatenate([part.ravel() for part in parts])
        J = _jacobian(data, noise, basis, values, c)
        step = solution(J, r)
        if float(r @ (J @ step)) < _NO_DECREASE * max(1.0, float(np.mean(r**2))):
            return _Solution(basis, values, c, parts, converged=True)
        for halving in range(_HALVINGS):
            share = 0.5**halving
            next_values = values + share * step[: data.unknowns]
            next_c = c + share * step[data.unknowns :].reshape(-1, 6)
            try:
                next_parts = _residuals(data, noise, basis, next_values, next_c)
            except ValueError:
                continue
            if _squares(next_parts) < _squares(parts):
                break
        else:
            break
        values, c, parts = next_values, next_c, next_parts
    return _Solution(basis, values, c, parts, converged=False)


def _with_deviations(data: Data, noise: PoseNoise, found: _Solution) -> Fit:
    """Convert a solution to a fit, with its covariance and the error due to its nonlinearity."""
    basis, values, c, parts, converged = found
    solved = factors(_jacobian(data, noise, basis, values, c))
    curvature = _curvature(data, noise, found, solved) if converged else math.inf
    motion = basis.motion(c, data.motion)
    return Fit(parts, values, solved, motion, converged, curvature, elapsed(noise.time))


def fitted_forces(data: Data, fit: Fit) -> Array:
    """Compute the forces of a fit along its motion (N), shape (n, 6)."""
    A, y = linear_system(data._replace(deviations=np.ones(data.forces.shape)), fit.motion)
    return np.asarray(A @ fit.values + data.forces - y)


def _curvature(data: Data, noise: PoseNoise, found: _Solution, solved: Factors) -> float:
    """Return the largest RMS error of the values, in standard deviations, that nonlinearity causes.

    It is evaluated for pairs of opposite random errors with the covariance of the fit; inf if such an error
    makes a pose unsolvable.
    """
    basis, values, c, parts, _ = found
    unknowns, center, shifts = data.unknowns, np.concatenate([part.ravel() for part in parts]), []
    sigma = np.sqrt(np.diagonal(solved.covariance(unknowns)))
    rng = np.random.default_rng(0)
    for _ in range(_DRAWS):
        drawn = solved.solve(rng.normal(size=len(center)))
        for step in (drawn, -drawn):
            shifted = values + step[:unknowns], c + step[unknowns:].reshape(-1, 6)
            try:
                changed = np.concatenate([part.ravel() for part in _residuals(data, noise, basis, *shifted)])
            except ValueError:
                return math.inf
            shifts.append((solved.solve(changed - center) + step)[:unknowns] / sigma)
    return float(np.max(np.sqrt(np.mean(np.square(shifts), axis=0))))


def _residuals(data: Data, noise: PoseNoise, basis: Basis, values: Array, c: Array) -> tuple[Array, ...]:
    """Compute the residuals of forces, poses, and prior divided by their standard deviations."""
    A, y = linear_system(data, basis.motion(c, data.motion))
    return y - A @ values, residual(basis, c, data.motion, noise), -(basis.prior @ c.ravel())


def _squares(parts: tuple[Array, ...]) -> float:
    """Return the sum of squares."""
    return float(sum(np.sum(part**2) for part in parts))


def _jacobian(data: Data, noise: PoseNoise, basis: Basis, values: Array, c: Array) -> Array | Arrow:
    """Compute the derivatives of the scaled forces, poses, and prior, shape (12 n + p, unknowns + 6 m)."""
    motion = basis.motion(c, data.motion)
    A, _ = linear_system(data, motion)
    maps = chain(basis, c, motion)
    local = basis.local
    n, width = local.shape[1:]
    by_c = np.zeros((n, LEGS, width, 6))
    for derivatives, parts in zip(_force_derivatives(data, motion, values), maps, strict=True):
        for matrix, functions in zip(parts, local, strict=False):
            by_c += (derivatives @ matrix)[:, :, None, :] * functions[:, None, :, None]
    by_c /= data.deviations[..., None, None]
    poses = (noise.weights[:, None] * maps[0][0])[:, :, None, :] * local[0][:, None, :, None]
    local_rows = np.concatenate([by_c, poses]).reshape(2 * LEGS * n, -1)
    start = np.tile(np.repeat(6 * basis.start, LEGS), 2)
    return arrow(A.reshape(LEGS * n, -1), local_rows, start, basis.prior)


def _force_derivatives(data: Data, motion: Motion, values: Array) -> tuple[Array, ...]:
    """Compute the derivatives of the forces by pose, twist, and acceleration, shape (n, 6, 6) each.

    Identified parameters may be nonphysical (negative masses or friction). Because forces are linear in the
    parameters, the derivatives are the difference of two physical robots. The first one has the load, and
    also the rotors unless rotors are unknowns.
    """
    lifted = data.base.expansion @ values[: data.base.rank]
    own = inertial_parameters(data.robot)
    mass = own.names.index("M")
    if data.terms is not None:
        along_leg = [own.names.index(f"C_p{leg}") for leg in range(1, LEGS + 1)]
        lifted[along_leg] += data.terms.by_leg("viscous", values[data.base.rank :])
    lesser = np.where(is_friction(own.names), np.abs(lifted), own.values)
    lesser[mass] += abs(lifted[mass])
    unloaded = Motion(R=motion.R, t=motion.t, omega=motion.omega, v=motion.v, alpha=motion.alpha, a=motion.a)
    greater = with_parameters(data.robot, lesser + lifted)
    bodies = replace(with_parameters(data.robot, lesser), drive=None)
    if data.terms is not None and data.terms.of_rotors:
        reflected = data.terms.by_leg("reflected_mass", values[data.base.rank :])
        greater = _with_rotors(greater, data.robot.drive, np.abs(reflected) + reflected)
        bodies = _with_rotors(bodies, data.robot.drive, np.abs(reflected))
    more, less = force_derivatives(greater, motion), force_derivatives(bodies, unloaded)
    return tuple(
        getattr(more, name) - getattr(less, name) for name in ("by_pose", "by_twist", "by_acceleration")
    )


def _with_rotors(robot: Robot, drive: Drive | None, reflected: Array) -> Robot:
    """Return the robot with drives whose rotors have the reflected masses (kg), shape (6,)."""
    given = Drive(lead=_FINE) if drive is None else drive  # type: ignore[arg-type]
    return replace(robot, drive=replace(given, rotor_inertia=reflected / given.transmission_ratio**2))
