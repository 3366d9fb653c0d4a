"""Bodies that can exist: what a rigid body requires of base parameters, and estimates kept to it.

A body is possible if its pseudo-inertia [[S, h], [h^T, m]] is positive definite: S the second moments, with
J = tr(S) E - S, h the first moment, m the mass (Wensing, Kim and Slotine 2018). Written P = U L L^T U^T
with the robot file's U U^T and a triangular L with a positive diagonal, it is possible whatever the numbers
in L are (Rucker and Wensing 2022).
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
from ..io.extras import needed_for
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

POSSIBLE = "an estimate kept to bodies that can exist"
"""What needs SciPy, in words."""

_AXES = ("xx", "xy", "xz", "yy", "yz", "zz")
_PLATFORM = ("M", *(f"h_P_{axis}" for axis in "xyz"), *(f"J_P_{axes}" for axes in _AXES))
_BODY, _FRICTION = 10, 3
_UPPER = np.triu_indices(3)
_LOWER = np.tril_indices(4)
# Least eigenvalue of a body of the robot file beside its trace, once it is made possible.
_LEAST = 1e-3
# Deviation of the prior: in L of a body (a factor e in a length or mass), and of friction beside its size.
_WIDTH, _FRICTION_WIDTH = 1.0, 10.0
_STEP = 1e-6
# Deviations below zero from which on noise does not explain a negative value: of some thirty values that are
# looked at, noise takes one so far in one estimate of a thousand.
_SURE = 4.0
_OTHERS = re.compile(rf"(?:leg |C_[ups])[2-{LEGS}]\b")
# Most steps of one fit, and the relative decrease of its sum of squares below which it ends.
_MOST_STEPS, _NO_DECREASE = 150, 1e-6


class Negative(NamedTuple):
    """A line for each result below zero; the farthest off, in deviations, is first.

    impossible: more than four deviations below. near_zero: less, not distinguishable from 0.
    """

    impossible: tuple[str, ...]
    near_zero: tuple[str, ...]


class PossibleFit(NamedTuple):
    """Possible bodies nearest to an estimate.

    parameters: of all bodies, (148,). values, covariance: the base parameters of these, (rank,), (rank,
    rank).
    squares: how much worse they explain the measurement: sum of squares over the deviations.
    """

    parameters: ParameterVector
    values: Array
    covariance: Array
    squares: float


def negative(robot: Robot, base: BaseParametersResult, values: Array, covariance: Array) -> Negative:
    """Identified results below zero that no machine has there, by the size of their noise.

    Friction below zero; the inertia of a leg's two parts about their joints without positive second moments;
    the platform's pseudo-inertia, less the least masses that the first moments of the upper parts call for,
    not positive definite. If every base parameter is the one of ``MERGED``, these conditions are sufficient
    too.
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
    """``negative`` of legs that share their parameters: lines about leg 1 are about all."""
    of_any = (*exact_regressor.LEG_PARAMETERS, *exact_regressor.PLATFORM_PARAMETERS)
    general = {name for name, _ in of_any} - set(exact_regressor.DEPENDENT)
    # Where all of these are identified, they are the combinations of every machine.
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
    """A line about leg 1 as one about all."""
    return re.sub(r"^(C_[ups])1\b", r"\1", re.sub(r"^leg 1\b", "all legs", line))


def possible_fit(robot: Robot, base: BaseParametersResult, values: Array, covariance: Array) -> PossibleFit:
    """Fit bodies that are possible to an estimate.

    values, covariance: base parameters and their covariance, finite. The robot's own bodies, made possible
    where they are not, are the prior with a deviation of about a factor e in each length and mass: it decides
    what the measurement does not. Needs SciPy.
    """
    with needed_for(POSSIBLE):
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
    # A measurement made ever more exact leads from the prior to an estimate far away.
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
    # Where legs share their parameters, their mean is possible too and explains as much.
    pi = pi if not base.identical_legs else alike(pi)
    spread = base.matrix @ jacobian(found.x) @ np.linalg.inv(np.linalg.qr(found.jac, mode="r"))
    squares = float(np.sum(found.fun[: base.rank] ** 2))
    return PossibleFit(
        ParameterVector(pi, own.names, own.units), base.matrix @ pi, spread @ spread.T, squares
    )


# Conditions


def _conditions(robot: Robot, base: BaseParametersResult, values: Array) -> list[Condition]:
    """Texts, units and functions of the base parameters that no machine makes negative."""
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
    return float(v @ _second_moments(x[inertia]) @ v)


def _platform_condition(
    robot: Robot, own: list[int], legs: Sequence[tuple[int, list[int], list[int]]], values: Array
) -> Condition:
    """The platform's pseudo-inertia less the least masses of upper parts, h^T S^-1 h, at their points.

    Both parts of a leg could belong to the upper one alone, so its mass is larger than this.
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
        f"platform: least pseudo-inertia, along {_direction(vectors[:, 0])} with the mass over {length:.3g} m"
    )
    return text, "kg m^2", lambda x: float(v @ rest(x) @ v)


def _usual(robot: Robot, base: BaseParametersResult) -> Callable[[Sequence[str]], list[int] | None]:
    """A function: places of base parameters if all of them are the combinations that ``MERGED`` names."""
    rows = _general_rows(robot)
    place = {name: i for i, name in enumerate(base.names)}

    def usual(wanted: Sequence[str]) -> list[int] | None:
        found = [place[name] for name in wanted if name in place]
        same = [np.allclose(base.matrix[i], rows[base.names[i]], rtol=1e-6, atol=1e-8) for i in found]
        return found if len(found) == len(wanted) and all(same) else None

    return usual


def _general_rows(robot: Robot) -> dict[str, Array]:
    """Base parameters of every machine by name: shares of the parameters in each, (148,)."""
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
    return "(" + ", ".join(f"{x:.2g}" for x in v) + ")"


def _second_moments(six: Array) -> Array:
    J = symmetric(six)
    return np.asarray(0.5 * np.trace(J) * np.eye(3) - J)


def _pseudo_inertia(body: Array) -> Array:
    """Pseudo-inertia, (4, 4), of mass, first moment and inertia, (10,)."""
    P = np.empty((4, 4))
    P[:3, :3] = _second_moments(body[4:])
    P[:3, 3] = P[3, :3] = body[1:4]
    P[3, 3] = body[0]
    return P


# Bodies and their coordinates


def _split(values: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Bodies, (13, 10), and friction, (6, 3), of all parameters, (148,)."""
    legs, platform = values[:-_BODY].reshape(LEGS, -1), values[None, -_BODY:]
    return np.concatenate([legs[:, : 2 * _BODY].reshape(-1, _BODY), platform]), legs[:, 2 * _BODY :]


def _joined(bodies: Array, friction: Array) -> Array:
    """All parameters, (148,), of bodies and friction."""
    legs = np.hstack([bodies[:-1].reshape(LEGS, -1), friction])
    return np.concatenate([legs.ravel(), bodies[-1]])


def _friction(x: Array) -> Array:
    return x[-LEGS * _FRICTION :].reshape(LEGS, _FRICTION)


def _root(body: Array) -> Array:
    """U of the pseudo-inertia U U^T of the nearest possible body, (4, 4)."""
    P = _pseudo_inertia(body)
    r = body[1:4] / body[0]
    about = P[:3, :3] - body[0] * np.outer(r, r)
    values, vectors = np.linalg.eigh(about)
    floor = _LEAST * np.sum(np.abs(values))
    about = (vectors * np.maximum(values, floor)) @ vectors.T
    P[:3, :3] = about + body[0] * np.outer(r, r)
    return np.asarray(np.linalg.cholesky(P[::-1, ::-1])[::-1, ::-1])


def _bodies(roots: Array, x: Array) -> Array:
    """Mass, first moment and inertia of bodies of coordinates (13, 10)."""
    L = np.zeros((len(x), 4, 4))
    L[:, *_LOWER] = x
    diagonal = np.arange(4)
    L[:, diagonal, diagonal] = np.exp(L[:, diagonal, diagonal])
    U = roots @ L
    P = U @ np.swapaxes(U, 1, 2)
    S = P[:, :3, :3]
    J = np.trace(S, axis1=1, axis2=2)[:, None, None] * np.eye(3) - S
    return np.hstack([P[:, 3, 3, None], P[:, :3, 3], J[:, *_UPPER]])
