"""Estimates restricted to physically possible bodies by a parameterization of their pseudo-inertias.

The pseudo-inertia of a body is P = U L L^T U^T, with U U^T of the robot file and a triangular L with a
positive diagonal. P is possible for all values in L (log-Cholesky parameters, Rucker and Wensing 2022).
"""

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from scipy.optimize import least_squares
from scipy.special import chdtrc

from ..io.array_types import Array
from ..robot.robot import Robot
from .base_parameters import alike
from .estimates import LEVEL, IdentificationResult
from .parameters import BODIES, FRICTION, ParameterVector, inertial_parameters
from .physical import pseudo_inertia

_UPPER, _LOWER = np.triu_indices(3), np.tril_indices(4)
# Smallest eigenvalue, relative to the trace, of a body of the robot file after its correction.
_LEAST = 1e-3
# Standard deviation of the prior: of L of a body (factor e in a length or mass), and of relative friction.
_WIDTH, _FRICTION_WIDTH = 1.0, 10.0
# Initial value of relative friction that is zero in the robot file.
_INSIDE = 1e-6
# Largest number of steps of each fit, and the relative decrease of its sum of squares at which it ends.
_STEPS, _DECREASE = 500, 1e-9


class _Coordinates(NamedTuple):
    """Coordinates x of all bodies and of friction: 10 of L for each body, and 18 friction coefficients.

    ``roots``, shape (13, 4, 4), are U of each body; ``unit``, shape (18,), are units of friction.
    """

    roots: Array
    unit: Array

    def parameters(self, x: Array) -> Array:
        """Compute all parameters, shape (148,)."""
        pi = np.empty(BODIES.size + FRICTION.size)
        U = self.roots @ _triangles(x[: BODIES.size])
        pi[BODIES], pi[FRICTION.ravel()] = _bodies(U @ np.swapaxes(U, 1, 2)), self.unit * x[BODIES.size :]
        return pi

    def jacobian(self, x: Array) -> Array:
        """Compute the derivatives of the parameters, shape (148, 148)."""
        J, L = np.zeros((len(x), len(x))), _triangles(x[: BODIES.size])
        for j, (row, column) in enumerate(zip(*_LOWER, strict=True)):
            change = np.zeros(L.shape)
            change[:, row, column] = L[:, row, row] if row == column else 1.0
            half = self.roots @ change @ np.swapaxes(self.roots @ L, 1, 2)
            columns = np.arange(j, BODIES.size, BODIES.shape[1])[:, None]
            J[BODIES, columns] = _bodies(half + np.swapaxes(half, 1, 2))
        J[FRICTION.ravel(), np.arange(BODIES.size, len(x))] = self.unit
        return J


def possible_estimate(robot: Robot, found: IdentificationResult) -> IdentificationResult:
    """Return the possible bodies nearest to an estimate, with the verdict "misfit" if they fit much worse.

    The prior consists of the bodies of the robot, corrected if they are impossible, with a standard deviation
    of about a factor e in each length and mass. It determines the parameters that the measurement does not.
    """
    base, own = found.base, inertial_parameters(robot)
    friction = own.values[FRICTION].ravel()
    unit = np.maximum((base.expansion @ (np.abs(found.values) + found.std))[FRICTION].ravel(), friction)
    unit = np.where(unit > 0.0, unit, 1.0)
    coordinates = _Coordinates(np.array([_root(body) for body in own.values[BODIES]]), unit)
    x, residual, jacobian = _nearest(found, coordinates, np.append(np.zeros(BODIES.size), friction / unit))
    pi = coordinates.parameters(x)
    # With identical legs the mean over the legs is also possible and fits equally well.
    pi = pi if not base.identical_legs else alike(pi)
    spread = base.matrix @ coordinates.jacobian(x) @ np.linalg.inv(np.linalg.qr(jacobian, mode="r"))
    squares = float(np.sum(residual[: base.rank] ** 2))
    misfit = float(chdtrc(base.rank, squares)) < LEVEL
    size = f"{math.sqrt(squares / base.rank):.3g} times as far from the estimate as expected from noise"
    return replace(
        found,
        values=base.matrix @ pi,
        covariance=spread @ spread.T,
        verdict="misfit" if misfit else found.verdict,
        warnings=(*found.warnings, *[f"bodies: the nearest possible bodies are {size}"] * misfit),
        nonphysical=(),
        near_zero=(),
        parameters=ParameterVector(pi, own.names, own.units),
        unconstrained=found,
    )


def _nearest(
    found: IdentificationResult, coordinates: _Coordinates, prior: Array
) -> tuple[Array, Array, Array]:
    """Fit the coordinates to the base parameters and, with a large standard deviation, to the prior.

    Returns the coordinates, shape (148,), with the residual and its derivatives.
    """
    base, sigma = found.base, found.std
    variances, vectors = np.linalg.eigh(found.covariance / np.outer(sigma, sigma))
    weight = (vectors / np.sqrt(variances)).T / sigma
    of_friction = np.arange(len(prior)) >= BODIES.size
    width = np.where(of_friction, _FRICTION_WIDTH, _WIDTH)

    def residual(x: Array, easier: float) -> Array:
        off = base.matrix @ coordinates.parameters(x) - found.values
        return np.append(weight @ off / easier, (x - prior) / width)

    def jacobian(x: Array, easier: float) -> Array:
        return np.vstack([weight @ base.matrix @ coordinates.jacobian(x) / easier, np.diag(1.0 / width)])

    x = np.where(of_friction, np.maximum(prior, _INSIDE), prior)
    bounds = np.where(of_friction, 0.0, -np.inf), np.inf
    far = max(1.0, float(np.max(np.abs(residual(x, 1.0)[: base.rank]))))
    # Continuation from a large covariance to the given one makes the fit converge to distant estimates.
    for easier in np.geomspace(far, 1.0, 2 + math.ceil(math.log10(far))):
        x = least_squares(
            residual, x, jacobian, bounds, ftol=_DECREASE, x_scale="jac", max_nfev=_STEPS, args=(easier,)
        ).x
    return x, residual(x, 1.0), jacobian(x, 1.0)


def _bodies(P: Array) -> Array:
    """Compute mass, first moment, and inertia, shape (n, 10), from pseudo-inertias, shape (n, 4, 4)."""
    S = P[:, :3, :3]
    J = np.trace(S, axis1=1, axis2=2)[:, None, None] * np.eye(3) - S
    return np.hstack([P[:, 3, 3, None], P[:, :3, 3], J[:, *_UPPER]])


def _root(body: Array) -> Array:
    """Compute U, shape (4, 4), of the pseudo-inertia U U^T of the nearest possible body."""
    P = pseudo_inertia(body)
    about_center = P[:3, :3] - np.outer(body[1:4], body[1:4]) / body[0]
    values, vectors = np.linalg.eigh(about_center)
    floor = _LEAST * np.sum(np.abs(values))
    P[:3, :3] += (vectors * (np.maximum(values, floor) - values)) @ vectors.T
    return np.asarray(np.linalg.cholesky(P[::-1, ::-1])[::-1, ::-1])


def _triangles(x: Array) -> Array:
    """Return the triangular matrices L, shape (n, 4, 4), of coordinates x, shape (10 n,)."""
    L = np.zeros((len(x) // len(_LOWER[0]), 4, 4))
    L[:, *_LOWER] = x.reshape(len(L), -1)
    diagonal = np.arange(4)
    L[:, diagonal, diagonal] = np.exp(L[:, diagonal, diagonal])
    return L
