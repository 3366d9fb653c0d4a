"""Limited quantities along a path as functions of the rate of the path parameter.

Along a path with parameter s each limited quantity is

    a s'' + b s'^2 + d s' + e,    ' the derivative by time.

The reason is the form of the equations of motion M [a; alpha] + C [v; omega] + g + friction = H F + W_ext.
They are linear in the accelerations and quadratic in the velocities, and viscous friction is proportional to
the velocities. Therefore d is the viscous friction, and e is the static part due to weight and load.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np

from ...drives.motor_states import motor_rates
from ...dynamics.forces import forces_of
from ...dynamics.inverse_dynamics import Formulation, inverse_dynamics
from ...io.array_types import Array, Indices
from ...io.toml_reader import per_leg, positive
from ...kinematics.inverse_kinematics import inverse_kinematics
from ...motion.motion import Motion
from ...robot.robot import LEGS, Robot
from .motor_terms import MotorTerms, Rows

Path = Callable[[Array], Motion]
"""Function: parameters s, shape (n,) -> motion with derivatives with respect to s, including loads."""


@dataclass(frozen=True)
class PathLimits:
    """Limits of a motion along a path, which replace or extend the limits of the robot; None means no limit.

    Attributes
    ----------
    force, speed : float or sequence of float, optional
        Limits of each actuator (N and m/s), one number or six; by default the limits of the robot. The speed
        limit of the motors applies in addition.
    acceleration, jerk : float or sequence of float, optional
        Limits of the leg lengths (m/s^2 and m/s^3), one number or six. With a jerk limit the accelerations
        are 0 at both ends.
    platform_speed, platform_turn_rate : float, optional
        Limits of the speed of the reference point (m/s) and of the angular velocity of the platform (rad/s).

    Raises
    ------
    ValueError
        If a limit is not > 0.
    """

    force: object = None
    speed: object = None
    acceleration: object = None
    jerk: object = None
    platform_speed: float | None = None
    platform_turn_rate: float | None = None

    def __post_init__(self) -> None:
        """Check the limits."""
        for name in ("force", "speed", "acceleration", "jerk"):
            value = getattr(self, name)
            object.__setattr__(self, name, None if value is None else tuple(leg_limits(value, name)))
        for name in ("platform_speed", "platform_turn_rate"):
            if getattr(self, name) is not None:
                object.__setattr__(self, name, positive(getattr(self, name), name))


leg_limits = partial(per_leg, check=positive, unlimited=True)


class Terms(NamedTuple):
    """Coefficients of m limited quantities at n parameters, shape (n, m) each, and their limits, shape (m,).

    Attributes
    ----------
    caps : ndarray, shape (n,)
        Largest s'^2 within the speed limits.
    names : tuple of str
        Names of the quantities in messages.
    motors : MotorTerms, optional
        Terms of the motors, if they have limits other than speed.
    """

    a: Array
    b: Array
    d: Array
    e: Array
    limit: Array
    caps: Array
    names: tuple[str, ...]
    motors: MotorTerms | None

    @property
    def all_names(self) -> tuple[str, ...]:
        """Names of all limited quantities: of the coefficients, of the motors, and speed."""
        return (*self.names, *(() if self.motors is None else self.motors.names), "speed")

    @property
    def quantities(self) -> int:
        """Number of limited quantities."""
        return len(self.all_names)

    @property
    def crossings(self) -> Array:
        """Quantities whose zeros change the bounds of s'', shape (n, k)."""
        return self.a if self.motors is None else np.concatenate([self.a, self.motors.crossings], axis=-1)

    def values(self, square: Array, second: Array) -> Array:
        """Compute the quantities, shape (n, m), from s'^2 and s'', shape (n,)."""
        x = square[:, None]
        return np.asarray(self.a * second[:, None] + self.b * x + self.d * np.sqrt(x) + self.e)

    def used(self, square: Array, second: Array) -> Array:
        """Compute the utilization of the limits at samples of cells, shape (c, k, quantities), speed last.

        ``square`` and ``second`` are s'^2 and s'', shape (c, k), from one end of each cell to the other.
        """
        values = self.values(square.ravel(), second.ravel())
        parts = [(np.abs(values) / self.limit).reshape(*square.shape, -1)]
        if self.motors is not None:
            parts.append(self.motors.used(square, second))
        speed = np.sqrt(square / self.caps.reshape(square.shape))
        return np.concatenate([*parts, speed[..., None]], axis=-1)

    def held(self) -> Array:
        """Compute the utilization of the limits at rest or in slow motion, shape (n, quantities)."""
        parts = [np.abs(self.e) / self.limit]
        if self.motors is not None:
            parts.append(self.motors.at_rest())
        return np.concatenate([*parts, np.zeros((len(self.e), 1))], axis=-1)

    @property
    def signs(self) -> Array:
        """Signs of the leg rates, shape (n, 6), if they change the bounds."""
        return np.ones((len(self.a), LEGS)) if self.motors is None else self.motors.signs

    def at(self, index: Indices) -> Terms:
        """Return the terms at some of the parameters."""
        nodes = {name: getattr(self, name)[index] for name in ("a", "b", "d", "e", "caps")}
        return self._replace(**nodes, motors=None if self.motors is None else self.motors.at(index))

    def rows(self, rate: Array, second: Array, room: Array, signs: Array) -> Rows:
        """Return the bounds of s'', with limits multiplied by ``room``, shape (n, quantities).

        Parameters
        ----------
        rate, second : ndarray, shape (n,)
            s' and s'' of the previous motion.
        room : ndarray, shape (n, quantities)
            Factors of the limits.
        signs : ndarray, shape (n, 6)
            Signs of the leg rates; 0 for legs that may move in either direction.
        """
        count = len(self.limit)
        most = self.limit * room[:, :count]
        own = Rows.of_one_form((self.a, self.b, self.d, self.e), -most, most)
        if self.motors is None:
            return own
        return Rows.together([own, self.motors.rows(rate, second, room[:, count:-1], signs)])


def traveled(motion: Motion, rate: Array | float, second: Array | float) -> Motion:
    """Convert a motion by parameter to a motion in time, with s' and s'', shape (n,)."""
    z, u = (np.broadcast_to(np.asarray(x, dtype=np.float64), motion.shape)[..., None] for x in (rate, second))
    assert motion.a is not None
    assert motion.alpha is not None
    alpha, a = motion.alpha * z**2 + motion.omega * u, motion.a * z**2 + motion.v * u
    rates = motion.omega * z, motion.v * z, alpha, a
    return Motion._unchecked(motion.R, motion.t, *rates, motion.F_ext, motion.M_ext)


def terms_along(
    robot: Robot, path: Path, s: Array, limits: PathLimits, formulation: Formulation, motors: bool = False
) -> Terms:
    """Compute the coefficients of forces, limited accelerations, and motors at s, shape (n,).

    With ``motors`` the terms of the motors are always included. Raises ValueError for unsolvable poses.
    """
    motion, forces_along = path(s), forces_of(robot, formulation, "c")

    def forces(rate: float, second: float) -> Array:
        return forces_along(traveled(motion, rate, second))

    still, ahead, back = forces(0.0, 0.0), forces(1.0, 0.0), forces(-1.0, 0.0)
    if not np.isfinite(still).all():
        inverse_dynamics(robot, motion, formulation)  # Raises an error that names the poses.
    columns = [(forces(0.0, 1.0) - still, 0.5 * (ahead + back) - still, 0.5 * (ahead - back), still)]
    limit = [force_limits(robot, limits)]
    names = [f"force of leg {leg + 1}" for leg in range(6)]
    legs = inverse_kinematics(robot, motion)
    if limits.acceleration is not None:
        assert legs.L_ddot is not None
        none = np.zeros_like(legs.L)
        columns.append((legs.L_dot, legs.L_ddot, none, none))
        limit.append(np.array(limits.acceleration))
        names += [f"acceleration of leg {leg + 1}" for leg in range(6)]
    a, b, d, e = (np.concatenate(each, axis=-1) for each in zip(*columns, strict=True))
    own = MotorTerms.of(robot, motion, np.stack([x[:, :LEGS] for x in (a, b, d, e)]), legs.L_dot)
    speeds, allowed = limited_speeds(robot, motion, legs.L_dot, limits)
    with np.errstate(divide="ignore"):
        caps = ((allowed / speeds) ** 2).min(axis=-1)
    counted = own if own.limited or motors else None
    return Terms(a, b, d, e, np.concatenate(limit), caps, tuple(names), counted)


def force_limits(robot: Robot, limits: PathLimits) -> Array:
    """Return the force limits of the actuators (N), shape (6,)."""
    return robot.force_limit if limits.force is None else np.array(limits.force)


def leg_accelerations(robot: Robot, motion: Motion) -> Array:
    """Return the second derivatives of the leg lengths, shape (n, 6), of a motion with accelerations."""
    found = inverse_kinematics(robot, motion).L_ddot
    assert found is not None
    return found


def limited_speeds(robot: Robot, motion: Motion, L_dot: Array, limits: PathLimits) -> tuple[Array, Array]:
    """Return magnitudes of limited speeds (m/s and rad/s), shape (n, m), and their limits, (m,), or inf.

    The speeds are the rates of the legs and motors, the speed of the reference point, and the angular
    velocity of the platform.
    """
    speeds = [L_dot, *(np.linalg.norm(x, axis=-1, keepdims=True) for x in (motion.v, motion.omega))]
    legs = robot.speed_limit if limits.speed is None else np.array(limits.speed)
    most = [legs, [limits.platform_speed or math.inf, limits.platform_turn_rate or math.inf]]
    if robot.drive is not None:
        speeds.append(motor_rates(robot, robot.drive, motion, L_dot))
        most.append(robot.drive.speed_limit / np.abs(robot.drive.transmission_ratio))
    return np.abs(np.concatenate(speeds, axis=-1)), np.concatenate(most)
