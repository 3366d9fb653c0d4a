"""Conditions on the base parameters of physical robots.

A body is possible if its pseudo-inertia P = [[S, h], [h^T, m]] is positive definite. S contains the second
moments (J = tr(S) E - S), h the first moment, and m the mass (Wensing, Kim, and Slotine 2018).
"""

import re
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ..generated import exact_regressor
from ..io.array_types import Array
from ..robot.robot import LEGS, Robot
from .base_parameters import BaseParametersResult
from .parameters import BODIES, parameter_names, symmetric

# Number of standard deviations below zero from which noise does not explain a negative value: of about thirty
# checked values, noise causes one in one of a thousand estimates.
_SURE = 4.0


class Negative(NamedTuple):
    """Messages about negative results, sorted by their distance from zero in standard deviations.

    ``impossible`` results are more than four standard deviations below zero; the results of ``near_zero`` are
    not distinguishable from zero.
    """

    impossible: tuple[str, ...]
    near_zero: tuple[str, ...]


class _Condition(NamedTuple):
    """Coefficients, shape (148,), of a sum of parameters that is nonnegative for every physical robot."""

    text: str
    unit: str
    coefficients: Array


def negative(robot: Robot, base: BaseParametersResult, values: Array, covariance: Array) -> Negative:
    """Find identified results below zero that no physical robot has, classified by their noise.

    In a physical robot, friction is not negative. The sum of the inertias of both parts of a leg has positive
    second moments. The platform with the masses of the upper parts has a positive definite pseudo-inertia.
    Conditions on bodies are checked if only parameters that are dependent for every robot are merged.
    """
    impossible, near_zero = [], []
    for text, unit, coefficients in _conditions(robot, base, base.expansion @ values):
        row = coefficients @ base.expansion
        value, sigma = float(row @ values), float(np.sqrt(row @ covariance @ row))
        if value >= 0.0:
            continue
        got = f"{value:.3g} +- {sigma:.2g} {unit}"
        off = value / sigma if sigma > 0.0 else -np.inf
        if off < -_SURE:
            impossible.append((off, f"{text}: expected no negative value, got {got}"))
        else:
            near_zero.append((off, f"{text}: not distinguishable from 0, {got}"))
    return Negative(*(tuple(line for _, line in sorted(found)) for found in (impossible, near_zero)))


def _conditions(robot: Robot, base: BaseParametersResult, pi: Array) -> Iterator[_Condition]:
    """Yield the conditions on parameters whose dependent ones are zero, in the worst directions of ``pi``."""
    for i, (name, formula) in enumerate(zip(base.names, base.formulas, strict=True)):
        if name.startswith("C_") and formula == name:
            yield _Condition(name, base.units[i], np.eye(len(pi))[base.independent_columns[i]])
    kinds = {name: re.sub(r"\d", "", name) for name in parameter_names()[0]}
    merged = {kind for name, kind in kinds.items() if {name, kind}.isdisjoint(base.names)}
    if any(not kind.startswith("C_") and kind not in exact_regressor.DEPENDENT for kind in merged):
        return
    for leg in [1] if base.identical_legs else range(1, LEGS + 1):
        upper = BODIES[2 * leg - 1]
        along = np.linalg.eigh(pseudo_inertia(pi[upper])[:3, :3])[1][:, 0]
        place = "all legs" if base.identical_legs else f"leg {leg}"
        text = f"{place}: second moment of both parts along {_direction(along)}"
        yield _Condition(text, "kg m^2", _moment(len(pi), upper, np.append(along, 0.0)))
    length = float(np.sqrt(np.mean(np.sum(robot.p**2, axis=1)))) or 1.0
    scale = np.array([1.0, 1.0, 1.0, length])
    along = np.linalg.eigh(pseudo_inertia(pi[BODIES[-1]]) * np.outer(scale, scale))[1][:, 0]
    text = f"{_direction(along)} with lengths divided by {length:.3g} m"
    moment = _moment(len(pi), BODIES[-1], scale * along)
    yield _Condition(f"platform: smallest pseudo-inertia, along {text}", "kg m^2", moment)


def _moment(count: int, body: Array, v: Array) -> Array:
    """Return the coefficients of v^T P v of a body with these indices of its parameters, shape (10,)."""
    found = np.zeros(count)
    found[body] = [v @ pseudo_inertia(unit) @ v for unit in np.eye(len(body))]
    return found


def _direction(v: Array) -> str:
    """Return a vector as text."""
    return "(" + ", ".join(f"{x:.2g}" for x in v) + ")"


def pseudo_inertia(body: Array) -> Array:
    """Compute the pseudo-inertia, shape (4, 4), from mass, first moment, and inertia, shape (10,)."""
    J, P = symmetric(body[4:]), np.empty((4, 4))
    P[:3, :3] = 0.5 * np.trace(J) * np.eye(3) - J
    P[:3, 3] = P[3, :3] = body[1:4]
    P[3, 3] = body[0]
    return P
