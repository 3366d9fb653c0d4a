"""The oracle of the regressor: columns of Y drawn from inverse dynamics by its linearity in the parameters.

A machine all of whose parameters but one are zero needs the wrench that is this parameter's column. A first
moment without a mass is the difference of two bodies of 1 kg, one with its centre of mass at 1 m and no
inertia about the joint point, and one at the joint point.
"""

from collections.abc import Callable, Iterator
from types import SimpleNamespace
from typing import Any

import numpy as np

from ..motion.motion import Motion
from ..robot.robot import LEGS, Robot
from . import newton_euler
from .equations_of_motion import GEOMETRY, INERTIAL
from .newton_euler import Array, Codes


def regressor(robot: Robot, motion: Motion) -> tuple[Array, Codes]:
    """Y, (..., 6, 148), formulation `exact`, and status, (...); NaN where that is not 0."""
    zeros = {name: np.zeros_like(np.asarray(getattr(robot, name))) for name in INERTIAL}
    given = {name: getattr(robot, name) for name in ("base_joint", *GEOMETRY)}
    unloaded = Motion.unchecked(motion.R, motion.t, motion.omega, motion.v, motion.alpha, motion.a)

    def wrench(where: Any, numbers: dict[str, Any]) -> Array:
        machine: Any = SimpleNamespace(**given, **{name: value.copy() for name, value in zeros.items()})
        for name, value in numbers.items():
            getattr(machine, name)[where] = value
        return newton_euler.actuator_wrench(machine, unloaded)[0]

    def body(where: Any, *names: str) -> Iterator[Array]:
        return _body(lambda *numbers: wrench(where, dict(zip(names, numbers, strict=True))))

    columns = []
    for leg in range(LEGS):
        columns += [*body(leg, "m_d", "r_d0", "I_d0"), *body(leg, "m_u", "r_u0", "I_u0")]
        columns += [wrench(leg, {name: 1.0}) for name in ("C_u", "C_p", "C_s")]
    columns += body(..., "M", "R_0", "I_p")
    return np.stack(columns, axis=-1), newton_euler.actuator_wrench(robot, motion)[1]


def _body(wrench: Callable[..., Array]) -> Iterator[Array]:
    """Columns of a body's mass, first moment and inertia; wrench: of its mass, centre of mass and inertia."""
    none, of_mass = np.zeros(3), wrench(1.0, np.zeros(3), np.zeros((3, 3)))
    yield of_mass
    for axis in np.eye(3):
        yield wrench(1.0, axis, np.outer(axis, axis) - np.eye(3)) - of_mass
    for i, j in zip(*np.triu_indices(3), strict=True):
        inertia = np.zeros((3, 3))
        inertia[i, j] = inertia[j, i] = 1.0
        yield wrench(0.0, none, inertia)
