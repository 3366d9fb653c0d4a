"""Physically possible bodies: conditions on base parameters, and estimates restricted to them.

A body is possible if its pseudo-inertia P = [[S, h], [h^T, m]] is positive definite. S contains the second
moments (J = tr(S) E - S), h the first moment, and m the mass (Wensing, Kim, and Slotine 2018). The
parameterization is P = U L L^T U^T, with U U^T of the robot file and a triangular L with a positive diagonal.
P is possible for all values in L (Rucker and Wensing 2022).
"""

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from operator import itemgetter
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..generated import exact_regressor
from ..io.array_types import Array
from ..robot.robot import LEGS, Robot
from .base_parameters import BaseParametersResult, alike
from .parameters import (
    ParameterVector,
    body_parameters,
    inertial_parameters,
    is_friction,
    leg_name,
    parameter_names,
    symmetric,
)

Condition = tuple[str, str, Callable[[Array], float]]

_AXES = ("xx", "xy", "xz", "yy", "yz", "zz")
_PLATFORM = ("M", *(f"h_P_{axis}" for axis in "xyz"), *(f"J_P_{axes}" for axes in _AXES))
_BODY, _FRICTION = 10, 3
_UPPER = np.triu_indices(3)
_LOWER = np.tril_indices(4)
# Smallest eigenvalue, relative to the trace, of a body of the robot file after its correction.
_LEAST = 1e-3
# Standard deviation of the prior: of L of a body (factor e in a length or mass), and of relative friction.
_WIDTH, _FRICTION_WIDTH = 1.0, 10.0
_STEP = 1e-6
# Number of standard deviations below zero from which noise does not explain a negative value: of about thirty
# checked values, noise causes one in one of a thousand estimates.
_SURE = 4.0
_OTHERS = re.compile(rf"(?:leg |C_[ups])[2-{LEGS}]\b")
# Largest number of steps of one fit, and the relative decrease of its sum of squares at which it ends.
_MOST_STEPS, _NO_DECREASE = 150, 1e-6


class Negative(NamedTuple):
    """Messages about negative results, sorted by their distance from zero in standard deviations.

    Attributes
    ----------
    impossible : tuple of str
        Results more than four standard deviations below zero.
    near_zero : tuple of str
        Other negative results, which are not distinguishable from zero.
    """

    impossible: tuple[str, ...]
    near_zero: tuple[str, ...]


class PossibleFit(NamedTuple):
    """Possible bodies nearest to an estimate.

    Attributes
    ----------
    parameters : ParameterVector
        Parameters of all bodies, shape (148,).
    values, covariance : ndarray
        Their base parameters, shape (rank,), with the covariance, shape (rank, rank).
    squares : float
        Increase of the sum of squares over the variances.
    """

    parameters: ParameterVector
    values: Array
    covariance: Array
    squares: float


def negative(robot: Robot, base: BaseParametersResult, values: Array, covariance: Array) -> Negative:
    """Find identified results below zero that no physical robot has, classified by their noise.

    A physical robot satisfies three conditions. Friction is not negative. The sum of the inertias of the two
    parts of a leg has positive second moments. The pseudo-inertia of the platform is positive definite after
    subtraction of the smallest masses that the first moments of the upper parts require. The conditions are
    also sufficient if the base parameters have the general formulas of ``MERGED``.
    """
    if base.identical_legs:
        return _negative_alike(robot, base, values, covariance)
    impossible, near_zero = [], []
    for text, unit, condition in _conditions(robot, base, values):
        value = condition(values)
        if value >= 0.0:
            continue
        step = _STEP * np.sqrt(np.diagonal(covariance))
        derivative = np.array([
            (condition(values + shift) - condition(values - shift)) / (2.0 * size) if size > 0.0 else 0.0
            for shift, size in zip(np.diag(step), step, strict=True)
        ])  # fmt: skip
        sigma = float(np.sqrt(derivative @ covariance @ derivative))
        got = f"{value:.3g} +- {sigma:.2g} {unit}"
        off = value / sigma if sigma > 0.0 else -np.inf
        if off < -_SURE:
            impossible.append((off, f"{text}: expected no negative value, got {got}"))
        else:
            near_zero.append((off, f"{text}: not distinguishable from 0, {got}"))
    return Negative(*(tuple(line for _, line in sorted(found)) for found in (impossible, near_zero)))


def _negative_alike(robot: Robot, base: BaseParametersResult, values: Array, covariance: Array) -> Negative:
    """Apply ``negative`` to identical legs; messages about leg 1 apply to all legs."""
    of_any = (*exact_regressor.LEG_PARAMETERS, *exact_regressor.PLATFORM_PARAMETERS)
    general = {name for name, _ in of_any} - set(exact_regressor.DEPENDENT)
    # If all of these are identified, their formulas are the general ones.
    if any(name not in base.names and not is_friction([name])[0] for name in general):
        return Negative((), ())
    rows, unit_of = _general_rows(robot), dict(zip(*parameter_names(), strict=True))
    merged = {leg_name(name, leg) for name in exact_regressor.DEPENDENT for leg in range(1, LEGS + 1)}
    kept = [name for name in rows if name not in merged]
    full = replace(
        base,
        names=tuple(kept),
        units=tuple(unit_of[name] for name in kept),
        matrix=np.array([rows[name] for name in kept]),
        identical_legs=False,
    )
    apart = full.matrix @ base.expansion
    found = negative(robot, full, apart @ values, apart @ covariance @ apart.T)
    own = ([line for line in lines if not _OTHERS.match(line)] for lines in found)
    return Negative(*(tuple(map(_of_all_legs, lines)) for lines in own))


def _of_all_legs(line: str) -> str:
    """Change a message about leg 1 to all legs."""
    return re.sub(r"^(C_[ups])1\b", r"\1", re.sub(r"^leg 1\b", "all legs", line))


def possible_fit(robot: Robot, base: BaseParametersResult, values: Array, covariance: Array) -> PossibleFit:
    """Fit possible bodies to an estimate.

    The prior consists of the bodies of the robot, corrected if they are impossible, with a standard deviation
    of about a factor e in each length and mass. It determines the parameters that the measurement does not.

    Parameters
    ----------
    robot : Robot
        Robot model.
    base : BaseParametersResult
        Definition of the base parameters.
    values, covariance : ndarray
        Base parameters, shape (rank,), and their finite covariance, shape (rank, rank).

    Returns
    -------
    PossibleFit
        Parameters, base parameters, and quality of the fit.
    """
    from scipy.optimize import least_squares

    own = inertial_parameters(robot)
    bodies, friction = _split(own.values)
    roots = np.array([_root(body) for body in bodies])
    sigma = np.sqrt(np.diagonal(covariance))
    measured = base.expansion @ (np.abs(values) + sigma)
    _, unit = _split(measured)
    unit = np.where(np.maximum(unit, friction) > 0.0, np.maximum(unit, friction), 1.0)
    share, vectors = np.linalg.eigh(covariance / np.outer(sigma, sigma))
    weight = (vectors / np.sqrt(share)).T / sigma

    def all_parameters(x: Array) -> Array:
        return _joined(_bodies(roots, x[: bodies.size].reshape(bodies.shape)), unit * _friction(x))

    def jacobian(x: Array) -> Array:
        J = np.zeros((len(own.values), len(x)))
        places, of_friction = _split(np.arange(len(J)))
        for j in range(_BODY):
            shift = np.zeros(bodies.shape)
            shift[:, j] = _STEP
            x_bodies = x[: bodies.size].reshape(bodies.shape)
            derivative = (_bodies(roots, x_bodies + shift) - _bodies(roots, x_bodies - shift)) / (2.0 * _STEP)
            J[places, j + _BODY * np.arange(len(bodies))[:, None]] = derivative
        J[of_friction.ravel(), bodies.size + np.arange(friction.size)] = unit.ravel()
        return J

    prior = np.concatenate([np.zeros(bodies.size), (friction / unit).ravel()])
    width = np.concatenate([np.full(bodies.size, _WIDTH), np.full(friction.size, _FRICTION_WIDTH)])
    least = np.concatenate([np.full(bodies.size, -np.inf), np.zeros(friction.size)])
    x = np.maximum(prior, _STEP)
    far = float(np.max(np.abs(weight @ (base.matrix @ all_parameters(x) - values))))
    # Continuation from a large covariance to the given one makes the fit converge to distant estimates.
    for easier in np.geomspace(max(far, 1.0), 1.0, 2 + math.ceil(math.log10(max(far, 1.0)))):
        W = weight / easier
        found = least_squares(
            lambda x, W=W: np.concatenate(
                [W @ (base.matrix @ all_parameters(x) - values), (x - prior) / width]
            ),
            x,
            lambda x, W=W: np.concatenate([W @ base.matrix @ jacobian(x), np.diag(1.0 / width)]),
            bounds=(least, np.inf),
            x_scale="jac",
            max_nfev=_MOST_STEPS,
            ftol=_NO_DECREASE,
        )
        x = found.x
    pi = all_parameters(found.x)
    # With identical legs the mean over the legs is also possible and fits equally well.
    pi = pi if not base.identical_legs else alike(pi)
    spread = base.matrix @ jacobian(found.x) @ np.linalg.inv(np.linalg.qr(found.jac, mode="r"))
    squares = float(np.sum(found.fun[: base.rank] ** 2))
    return PossibleFit(
        ParameterVector(pi, own.names, own.units), base.matrix @ pi, spread @ spread.T, squares
    )


# Conditions


def _conditions(robot: Robot, base: BaseParametersResult, values: Array) -> list[Condition]:
    """Return names, units, and functions of quantities that are nonnegative for every physical robot."""
    usual = _usual(robot, base)
    friction = [name for name in base.names if is_friction([name])[0]]
    found: list[Condition] = [
        (name, base.units[own[0]], itemgetter(own[0]))
        for name in friction
        if (own := usual([name])) is not None
    ]
    legs = []
    for leg in range(1, LEGS + 1):
        inertia = usual([leg_name(f"J_u_{axes}", leg) for axes in _AXES])
        if inertia is None:
            continue
        moments, vectors = np.linalg.eigh(_second_moments(values[inertia]))
        text = f"leg {leg}: second moment of both parts along {_direction(vectors[:, 0])}"
        found.append((text, "kg m^2", partial(_second_moment_along, vectors[:, 0], inertia)))
        first = usual([leg_name(f"h_u_{axis}", leg) for axis in "xyz"])
        if first is not None and moments[0] > 0.0:
            legs.append((leg, inertia, first))
    platform = usual(_PLATFORM)
    if platform is not None:
        found.append(_platform_condition(robot, platform, legs, values))
    return found


def _second_moment_along(v: Array, inertia: list[int], x: Array) -> float:
    """Compute the second moment of a leg along a direction v (kg m^2)."""
    return float(v @ _second_moments(x[inertia]) @ v)


def _platform_condition(
    robot: Robot, own: list[int], legs: Sequence[tuple[int, list[int], list[int]]], values: Array
) -> Condition:
    """Return the condition on the pseudo-inertia of the platform minus the smallest upper masses.

    The smallest mass is h^T S^-1 h at each platform point. Both parts of a leg could belong to the upper one
    alone, so the mass of the upper part is larger than this.
    """

    def rest(x: Array) -> Array:
        P = _pseudo_inertia(x[own])
        for leg, inertia, first in legs:
            h, point = x[first], np.append(robot.p[leg - 1], 1.0)
            P = P - h @ np.linalg.solve(_second_moments(x[inertia]), h) * np.outer(point, point)
        return P

    length = float(np.sqrt(np.mean(np.sum(robot.p**2, axis=1)))) or 1.0
    scale = np.array([1.0, 1.0, 1.0, length])
    _, vectors = np.linalg.eigh(rest(values) * np.outer(scale, scale))
    v = scale * vectors[:, 0]
    text = (
        f"platform: smallest pseudo-inertia, along {_direction(vectors[:, 0])} with lengths divided by "
        f"{length:.3g} m"
    )
    return text, "kg m^2", lambda x: float(v @ rest(x) @ v)


def _usual(robot: Robot, base: BaseParametersResult) -> Callable[[Sequence[str]], list[int] | None]:
    """Return a function that finds base parameters by name if all of them have the formulas of ``MERGED``."""
    rows = _general_rows(robot)
    place = {name: i for i, name in enumerate(base.names)}

    def usual(wanted: Sequence[str]) -> list[int] | None:
        found = [place[name] for name in wanted if name in place]
        same = [np.allclose(base.matrix[i], rows[base.names[i]], rtol=1e-6, atol=1e-8) for i in found]
        return found if len(found) == len(wanted) and all(same) else None

    return usual


def _general_rows(robot: Robot) -> dict[str, Array]:
    """Return the coefficients of the general base parameters by name, shape (148,) each."""
    names, _ = parameter_names()
    column = {name: i for i, name in enumerate(names)}
    rows = dict(zip(names, np.eye(len(names)), strict=True))
    for leg in range(1, LEGS + 1):
        for axes in _AXES:
            rows[leg_name(f"J_u_{axes}", leg)][column[leg_name(f"J_d_{axes}", leg)]] = 1.0
        point = body_parameters(np.ones(1), robot.p[leg - 1][None], np.zeros((1, 3, 3)))[0]
        for name, share in zip(_PLATFORM, point, strict=True):
            rows[name][column[f"m_u{leg}"]] = share
    return rows


def _direction(v: Array) -> str:
    """Return a vector as text."""
    return "(" + ", ".join(f"{x:.2g}" for x in v) + ")"


def _second_moments(six: Array) -> Array:
    """Compute the second moments S, shape (3, 3), from an inertia, shape (6,)."""
    J = symmetric(six)
    return np.asarray(0.5 * np.trace(J) * np.eye(3) - J)


def _pseudo_inertia(body: Array) -> Array:
    """Compute the pseudo-inertia, shape (4, 4), from mass, first moment, and inertia, shape (10,)."""
    P = np.empty((4, 4))
    P[:3, :3] = _second_moments(body[4:])
    P[:3, 3] = P[3, :3] = body[1:4]
    P[3, 3] = body[0]
    return P


# Coordinates of bodies


def _split(values: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Split all parameters, shape (148,), into bodies, shape (13, 10), and friction, shape (6, 3)."""
    legs, platform = values[:-_BODY].reshape(LEGS, -1), values[None, -_BODY:]
    return np.concatenate([legs[:, : 2 * _BODY].reshape(-1, _BODY), platform]), legs[:, 2 * _BODY :]


def _joined(bodies: Array, friction: Array) -> Array:
    """Join bodies and friction to all parameters, shape (148,)."""
    legs = np.hstack([bodies[:-1].reshape(LEGS, -1), friction])
    return np.concatenate([legs.ravel(), bodies[-1]])


def _friction(x: Array) -> Array:
    """Return the friction coordinates, shape (6, 3)."""
    return x[-LEGS * _FRICTION :].reshape(LEGS, _FRICTION)


def _root(body: Array) -> Array:
    """Compute U, shape (4, 4), of the pseudo-inertia U U^T of the nearest possible body."""
    P = _pseudo_inertia(body)
    r = body[1:4] / body[0]
    about = P[:3, :3] - body[0] * np.outer(r, r)
    values, vectors = np.linalg.eigh(about)
    floor = _LEAST * np.sum(np.abs(values))
    about = (vectors * np.maximum(values, floor)) @ vectors.T
    P[:3, :3] = about + body[0] * np.outer(r, r)
    return np.asarray(np.linalg.cholesky(P[::-1, ::-1])[::-1, ::-1])


def _bodies(roots: Array, x: Array) -> Array:
    """Compute mass, first moment, and inertia from coordinates, shape (13, 10)."""
    L = np.zeros((len(x), 4, 4))
    L[:, *_LOWER] = x
    diagonal = np.arange(4)
    L[:, diagonal, diagonal] = np.exp(L[:, diagonal, diagonal])
    U = roots @ L
    P = U @ np.swapaxes(U, 1, 2)
    S = P[:, :3, :3]
    J = np.trace(S, axis1=1, axis2=2)[:, None, None] * np.eye(3) - S
    return np.hstack([P[:, 3, 3, None], P[:, :3, 3], J[:, *_UPPER]])
