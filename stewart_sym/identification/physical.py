"""Conditions on the base parameters of physical robots.

A body is possible if its pseudo-inertia P = [[S, h], [h^T, m]] is positive definite. S contains the second
moments (J = tr(S) E - S), h the first moment, and m the mass (Wensing, Kim, and Slotine 2018).
"""

import re
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from operator import itemgetter
from typing import NamedTuple

import numpy as np

from ..generated import exact_regressor
from ..io.array_types import Array
from ..robot.robot import LEGS, Robot
from .base_parameters import BaseParametersResult
from .parameters import BODIES, FRICTION, leg_name, parameter_names, symmetric

_PLATFORM = [name for name, _ in exact_regressor.PLATFORM_PARAMETERS]
# Parameters of a leg that its conditions contain: second and first moments of the upper part.
_OF_LEG = [name for name, _ in exact_regressor.LEG_PARAMETERS if name.startswith(("J_u", "h_u"))]
# Relative change of a parameter in a finite difference, in standard deviations.
_STEP = 1e-6
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
    """Function of all parameters that is nonnegative for every physical robot."""

    text: str
    unit: str
    value: Callable[[Array], float]


def negative(robot: Robot, base: BaseParametersResult, values: Array, covariance: Array) -> Negative:
    """Find identified results below zero that no physical robot has, classified by their noise.

    A physical robot satisfies three conditions. Friction is not negative. The sum of the inertias of the two
    parts of a leg has positive second moments. The pseudo-inertia of the platform is positive definite after
    subtraction of the smallest masses that the first moments of the upper parts require. Conditions on bodies
    are checked if only the parameters that are dependent for every robot are merged.
    """
    E, impossible, near_zero = base.expansion, [], []
    shifts = np.diag(_STEP * np.sqrt(np.diagonal(covariance)))
    for text, unit, condition in _conditions(robot, base, E @ values):
        value = condition(E @ values)
        if value >= 0.0:
            continue
        # Change of the condition for a change of each parameter by its standard deviation.
        change = [condition(E @ (values + x)) - condition(E @ (values - x)) for x in shifts]
        gradient = np.array(change) / (2.0 * np.maximum(np.diagonal(shifts), np.finfo(np.float64).tiny))
        sigma = float(np.sqrt(gradient @ covariance @ gradient))
        got = f"{value:.3g} +- {sigma:.2g} {unit}"
        off = value / sigma if sigma > 0.0 else -np.inf
        if off < -_SURE:
            impossible.append((off, f"{text}: expected no negative value, got {got}"))
        else:
            near_zero.append((off, f"{text}: not distinguishable from 0, {got}"))
    return Negative(*(tuple(line for _, line in sorted(found)) for found in (impossible, near_zero)))


def _conditions(robot: Robot, base: BaseParametersResult, pi: Array) -> Iterator[_Condition]:
    """Yield the conditions on parameters whose dependent ones are zero, in the worst directions of ``pi``."""
    checked = [1] if base.identical_legs else range(1, LEGS + 1)
    own = (lambda name, leg: name) if base.identical_legs else leg_name
    for leg in checked:
        for i, name in zip(FRICTION[leg - 1].tolist(), ("C_u", "C_p", "C_s"), strict=True):
            if _is_general(base, [own(name, leg)]):
                yield _Condition(own(name, leg), parameter_names()[1][i], itemgetter(i))
    of_legs = [own(name, leg) for leg in checked for name in _OF_LEG]
    if not _is_general(base, [*of_legs, *_PLATFORM]):
        return
    moments = []
    for leg in checked:
        values, vectors = np.linalg.eigh(_upper_part(pi, leg)[:3, :3])
        moments.append(values[0])
        place = "all legs" if base.identical_legs else f"leg {leg}"
        text = f"{place}: second moment of both parts along {_direction(vectors[:, 0])}"
        yield _Condition(text, "kg m^2", partial(_moment_along, leg, vectors[:, 0]))
    possible = [leg for leg in range(1, LEGS + 1) if moments[(leg - 1) % len(moments)] > 0.0]
    length = float(np.sqrt(np.mean(np.sum(robot.p**2, axis=1)))) or 1.0
    scale = np.array([1.0, 1.0, 1.0, length])
    _, vectors = np.linalg.eigh(_platform_alone(robot, possible, pi) * np.outer(scale, scale))
    v = scale * vectors[:, 0]
    along = f"{_direction(vectors[:, 0])} with lengths divided by {length:.3g} m"
    text = f"platform: smallest pseudo-inertia, along {along}"
    yield _Condition(text, "kg m^2", lambda pi: float(v @ _platform_alone(robot, possible, pi) @ v))


def _is_general(base: BaseParametersResult, names: Sequence[str]) -> bool:
    """Return True if base parameters exist and include only parameters that are dependent for every robot."""
    kinds = np.array([re.sub(r"\d", "", name) for name in parameter_names()[0]])
    for name in names:
        if name not in base.names:
            return False
        row = base.matrix[base.names.index(name)]
        merged = set(kinds[np.abs(row) > 1e-8 * np.abs(row).max()].tolist())
        if not merged <= {re.sub(r"\d", "", name), *exact_regressor.DEPENDENT}:
            return False
    return True


def _upper_part(pi: Array, leg: int) -> Array:
    """Return the pseudo-inertia of the upper part of a leg."""
    return pseudo_inertia(pi[BODIES[2 * leg - 1]])


def _moment_along(leg: int, v: Array, pi: Array) -> float:
    """Compute the second moment of a leg along a direction v (kg m^2)."""
    return float(v @ _upper_part(pi, leg)[:3, :3] @ v)


def _platform_alone(robot: Robot, legs: Sequence[int], pi: Array) -> Array:
    """Compute the pseudo-inertia of the platform minus the smallest upper masses at the platform points.

    The smallest mass is h^T S^-1 h. Both parts of a leg could belong to the upper one alone, so the mass of
    the upper part is larger than this.
    """
    P = pseudo_inertia(pi[BODIES[-1]])
    for leg in legs:
        upper, point = _upper_part(pi, leg), np.append(robot.p[leg - 1], 1.0)
        h = upper[:3, 3]
        P = P - h @ np.linalg.solve(upper[:3, :3], h) * np.outer(point, point)
    return P


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
