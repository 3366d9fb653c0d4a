"""Reference for the equations of motion: M, C, g, friction, and Y, from inverse dynamics by linearity.

The wrench H F of the actuators is affine in the accelerations, quadratic in the velocities, and linear in
gravity and in friction. Therefore differences of inverse dynamics, none of them small, give each term to
rounding for any implementation of inverse dynamics. This module uses the vector reference.
"""

import dataclasses
import functools
from collections.abc import Callable, Iterator
from types import SimpleNamespace
from typing import Any

import numpy as np

from ..motion.motion import Motion
from ..results import OK, EquationsOfMotionResult
from ..robot.robot import LEGS, Robot
from . import newton_euler
from .newton_euler import Array, Codes

ActuatorWrench = Callable[[Robot, Motion], tuple[Array, Codes]]
"""Function that returns the wrench H F (..., 6) for a motion of a robot, and the status of every pose."""


def equations_of_motion(
    robot: Robot, motion: Motion, faults: frozenset[int] = newton_euler.EXACT
) -> EquationsOfMotionResult:
    """Compute M, C, g, friction, and bias of the vector reference; load and accelerations are ignored.

    ``faults`` contains the numbers of the printed faults to keep, as for ``newton_euler.inverse_dynamics``.
    """
    return by_linearity(functools.partial(newton_euler.actuator_wrench, faults=faults), robot, motion)


def by_linearity(wrench: ActuatorWrench, robot: Robot, motion: Motion) -> EquationsOfMotionResult:
    """Compute M, C, g, friction, and bias of any inverse dynamics ``wrench``."""
    with np.errstate(all="ignore"):
        parts, status = _terms(wrench, robot, motion)
    status = newton_euler.without_overflow(parts, status)
    return EquationsOfMotionResult(**newton_euler.with_status(parts, status))


def _terms(wrench: ActuatorWrench, robot: Robot, motion: Motion) -> tuple[dict[str, Array], Codes]:
    M, bias, status = inertia_and_bias(wrench, robot, motion)
    zero = np.zeros_like(motion.t)
    g, _ = wrench(robot, with_rates(motion, zero, zero, zero, zero))
    # At such low velocities inertial forces, which are quadratic, vanish compared with friction.
    slow = with_rates(motion, motion.v * _SLOWLY, motion.omega * _SLOWLY, zero, zero)
    bare, still = bare_robot(robot), np.zeros((*motion.shape, 6, 3))
    resisted, inertial = (wrench(machine, slow)[0] for machine in (_without(robot, ("g",)), bare))
    C = coriolis(
        lambda v, omega: wrench(bare, with_rates(motion, v, omega, still, still))[0], robot, motion, M
    )
    friction = (resisted - inertial) / _SLOWLY
    terms = {"M": M, "C": C, "g": g, "friction": friction, "bias": bias - friction}
    return terms | {"bias_and_friction": bias}, status


_SLOWLY = 2.0**-100


def inertia_and_bias(wrench: ActuatorWrench, robot: Robot, motion: Motion) -> tuple[Array, Array, Codes]:
    """Compute M, (..., 6, 6), bias, (..., 6), and status, (...), with seven evaluations per pose."""
    zero = np.zeros_like(motion.t)
    still = np.zeros((*motion.shape, 6, 3))
    unit = np.broadcast_to(np.eye(6), (*motion.shape, 6, 6))
    columns_of = with_rates(motion, still, still, unit[..., :3], unit[..., 3:])
    columns, of_columns = wrench(bare_robot(robot), columns_of)
    bias, status = wrench(robot, with_rates(motion, motion.v, motion.omega, zero, zero))
    status = np.where(status == OK, of_columns.max(axis=-1), status).astype(np.int32)
    return np.swapaxes(columns, -1, -2), bias, status


GEOMETRY = ("g", "b", "p", "k")
INERTIAL = (
    *("M", "R_0", "I_p", "m_d", "r_d0", "I_d0", "m_u", "r_u0", "I_u0"),
    *("C_u", "C_p", "C_s", "reflected_mass", "rotor_momentum"),
)
"""Values of a robot on which its forces depend.

``GEOMETRY`` contains gravity and geometry; forces are linear in ``INERTIAL``.
"""


def coriolis(h: Callable[[Array, Array], Array], robot: Robot, motion: Motion, M: Array) -> Array:
    """Compute C, (..., 6, 6), from the Levi-Civita connection of M in the frame of twists [v; omega].

    The quadratic wrench h of v and omega, (..., 6, 3), gives by polarization the part of C that is symmetric
    in twist and direction. Twists are not rates of coordinates: the fields of two constant twists have the
    Lie bracket [0; -omega_1 x omega_2], base axes, and C contains half of M times this bracket. Then dM/dt =
    C + C^T. h and M may have axes before the axes of the motion.
    """
    length = float(np.sqrt(np.mean(np.sum(robot.p**2, axis=-1)))) or 1.0
    speed = _size(motion.omega) + _size(motion.v) / length
    # Directions of the magnitude of the twist lose no digits in the differences.
    step = np.where(speed > 0.0, speed, 1.0)[..., None] * np.repeat([length, 1.0], 3)
    twist = np.concatenate([motion.v, motion.omega], axis=-1)[..., None, :]
    direction = step[..., None] * np.eye(6)
    there, back = (h(twists[..., :3], twists[..., 3:]) for twists in (twist + direction, twist - direction))
    symmetric = (there - back) / (4 * step[..., None])
    bracket = -np.cross(motion.omega[..., None, :], np.eye(3), axisc=-2)
    of_bracket = np.zeros_like(M)
    of_bracket[..., 3:] = M[..., 3:] @ bracket
    return np.asarray(np.swapaxes(symmetric, -1, -2) + of_bracket / 2)


def with_rates(motion: Motion, v: Array, omega: Array, a: Array, alpha: Array) -> Motion:
    """Return the poses of a motion with other velocities and accelerations, and without a load."""
    R, t = motion.R, motion.t
    if v.ndim > t.ndim:
        R = np.broadcast_to(R[..., None, :, :], (*v.shape, 3))
        t = np.broadcast_to(t[..., None, :], v.shape)
    return Motion._unchecked(R, t, omega, v, alpha, a)


def _size(vectors: Array) -> Array:
    return np.asarray(np.sqrt(np.sum(vectors * vectors, axis=-1)))


def bare_robot(robot: Robot) -> Robot:
    """Return the robot without gravity and friction."""
    return _without(robot, ("g", "C_u", "C_p", "C_s"))


@functools.lru_cache(maxsize=16)
def _without(robot: Robot, names: tuple[str, ...]) -> Robot:
    """Return the robot with zeros in the named fields."""
    return dataclasses.replace(robot, **{name: np.zeros_like(getattr(robot, name)) for name in names})


# The regressor

# The wrench of a machine with a single nonzero parameter is the column of this parameter. A first moment
# without a mass is the difference between two bodies of 1 kg. One has its center of mass at 1 m and no
# inertia about the joint point; the other is at the joint point.


def regressor(robot: Robot, motion: Motion) -> tuple[Array, Codes]:
    """Compute Y, (..., 6, 148), formulation `exact`, and status, (...); NaN if the status is not 0."""
    zeros = {name: np.zeros_like(np.asarray(getattr(robot, name))) for name in INERTIAL}
    given = {name: getattr(robot, name) for name in ("base_joint", *GEOMETRY)}
    unloaded = Motion._unchecked(motion.R, motion.t, motion.omega, motion.v, motion.alpha, motion.a)

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
    """Yield the columns of mass, first moment, and inertia of a body with the given ``wrench``."""
    none, of_mass = np.zeros(3), wrench(1.0, np.zeros(3), np.zeros((3, 3)))
    yield of_mass
    for axis in np.eye(3):
        yield wrench(1.0, axis, np.outer(axis, axis) - np.eye(3)) - of_mass
    for i, j in zip(*np.triu_indices(3), strict=True):
        inertia = np.zeros((3, 3))
        inertia[i, j] = inertia[j, i] = 1.0
        yield wrench(0.0, none, inertia)
