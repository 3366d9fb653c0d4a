"""Conversion of an estimate about a tool point to the reference point of the robot."""

from dataclasses import replace

import numpy as np

from ..io.array_types import Array
from ..robot.robot import Robot
from .base_parameters import BaseParametersResult
from .estimates import IdentificationResult
from .parameters import ParameterVector, symmetric
from .physical import negative

_PLATFORM = slice(-10, None)
_UPPER = np.triu_indices(3)


def about_reference(
    robot: Robot, base: BaseParametersResult, found: IdentificationResult, point: Array
) -> IdentificationResult:
    """Convert the estimate of ``about_point(robot, point)`` to the base parameters of the robot."""
    back = _shifted(-point)
    change = base.matrix @ back @ found.base.expansion
    values, covariance = change @ found.values, found.covariance
    impossible, near_zero = found.nonphysical, found.near_zero
    if np.isfinite(covariance).all():
        covariance = change @ covariance @ change.T
        below = negative(robot, base, values, covariance)
        impossible, near_zero = below.impossible, below.near_zero
    parameters = found.parameters
    if parameters is not None:
        parameters = ParameterVector(back @ parameters.values, parameters.names, parameters.units)
        impossible, near_zero = (), ()
    return replace(
        found,
        base=base,
        values=values,
        covariance=covariance,
        nonphysical=impossible,
        near_zero=near_zero,
        motion=found.motion.at_point(-point),
        parameters=parameters,
        unconstrained=None
        if found.unconstrained is None
        else about_reference(robot, base, found.unconstrained, point),
    )


def _shifted(point: Array) -> Array:
    """Return the matrix, shape (148, 148), that moves the moments of the platform to a point."""
    T = np.eye(148)
    T[_PLATFORM, _PLATFORM] = np.column_stack([_about(unit, point) for unit in np.eye(10)])
    return T


def _about(body: Array, c: Array) -> Array:
    """Return mass, first moment, and inertia about a point c, shape (10,)."""
    m, h, J = body[0], body[1:4], symmetric(body[4:])
    crossed = 2.0 * (c @ h) * np.eye(3) - np.outer(c, h) - np.outer(h, c)
    J = J - crossed + m * (c @ c * np.eye(3) - np.outer(c, c))
    return np.concatenate([[m], h - m * c, J[_UPPER]])
