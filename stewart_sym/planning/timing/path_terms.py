"""What a path takes of a machine: forces and leg rates as functions of how fast the path is traveled.

Along a path of parameter s each limited quantity is

    a s'' + b s'^2 + d s' + e,    ' the derivative by time,

since the equations of motion M [a; alpha] + C [v; omega] + g + friction = H F + W_ext are linear in the
accelerations, quadratic in the rates and have friction in proportion to these: d is the viscous friction,
e what weight and load take at rest.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ...drives.motor_states import motor_rates
from ...dynamics.force_noise import forces_of
from ...dynamics.inverse_dynamics import Formulation, inverse_dynamics
from ...io.arguments import shown
from ...io.array_types import Array, Indices
from ...io.toml_reader import positive
from ...kinematics.inverse_kinematics import inverse_kinematics
from ...motion.motion import Motion
from ...robot.robot import LEGS, Robot
from .motor_terms import MotorTerms, Rows

Path = Callable[[Array], Motion]
"""Parameters s, (n,) -> motion of shape (n,) whose rates are derivatives by s, loads included."""


@dataclass(frozen=True)
class PathLimits:
    """Limits of a plan beside those of the robot; None: no limit.

    Attributes
    ----------
    force, speed : float or sequence of float, optional
        Of each actuator, N and m/s, one number or six; None: the robot's. The speed limit of a drive's motor
        counts beside it.
    acceleration, jerk : float or sequence of float, optional
        Of the leg lengths, m/s^2 and m/s^3, one number or six. With a limit of jerk accelerations are 0 at
        both ends.
    platform_speed, platform_turn_rate : float, optional
        Of the reference point, m/s, and of the platform's rotation, rad/s.

    Raises
    ------
    ValueError
        Naming the limit that is not > 0.
    """

    force: object = None
    speed: object = None
    acceleration: object = None
    jerk: object = None
    platform_speed: float | None = None
    platform_turn_rate: float | None = None

    def __post_init__(self) -> None:
        for name in ("force", "speed", "acceleration", "jerk"):
            value = getattr(self, name)
            object.__setattr__(self, name, None if value is None else six_positive(value, name))
        for name in ("platform_speed", "platform_turn_rate"):
            if getattr(self, name) is not None:
                object.__setattr__(self, name, positive(getattr(self, name), name))


def six_positive(value: object, where: str) -> tuple[float, ...]:
    """One number > 0 for all legs or six of them; infinity is no limit."""
    given = list(value) if isinstance(value, list | tuple | np.ndarray) else [value] * 6
    if len(given) != 6:
        raise ValueError(f"{where}: expected one number or six, got {shown(value)}")
    return tuple(
        math.inf if isinstance(each, float) and each == math.inf else positive(each, where) for each in given
    )


class Terms(NamedTuple):
    """Coefficients at n parameters of m limited quantities, (n, m) each, and their limits, (m,).

    caps: largest s'^2 that the speed limits allow, (n,). names: of the quantities, for messages. motors: what
    the path takes of the motors, where these have limits beside their speed.
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
        """Names of the quantities that are limited: of the coefficients, of the motors, and speed."""
        return (*self.names, *(() if self.motors is None else self.motors.names), "speed")

    @property
    def quantities(self) -> int:
        """How many quantities are limited."""
        return len(self.all_names)

    @property
    def crossings(self) -> Array:
        """What changes the bounds of s'' where it passes zero, (n, k)."""
        return self.a if self.motors is None else np.concatenate([self.a, self.motors.crossings], axis=-1)

    def values(self, square: Array, second: Array) -> Array:
        """The quantities, (n, m), at s'^2 and s'', (n,)."""
        x = square[:, None]
        return np.asarray(self.a * second[:, None] + self.b * x + self.d * np.sqrt(x) + self.e)

    def used(self, square: Array, second: Array) -> Array:
        """Compute the used shares of the limits at places of cells, (c, k, quantities), of speed last.

        square, second: s'^2 and s'', (c, k), from one end of each cell to the other.
        """
        values = self.values(square.ravel(), second.ravel())
        parts = [(np.abs(values) / self.limit).reshape(*square.shape, -1)]
        if self.motors is not None:
            parts.append(self.motors.used(square, second))
        speed = np.sqrt(square / self.caps.reshape(square.shape))
        return np.concatenate([*parts, speed[..., None]], axis=-1)

    def held(self) -> Array:
        """Shares of the limits that are used at rest or in slow motion, (n, quantities)."""
        parts = [np.abs(self.e) / self.limit]
        if self.motors is not None:
            parts.append(self.motors.at_rest())
        return np.concatenate([*parts, np.zeros((len(self.e), 1))], axis=-1)

    @property
    def signs(self) -> Array:
        """Signs of the rates of the legs, (n, 6), where these change bounds."""
        return np.ones((len(self.a), LEGS)) if self.motors is None else self.motors.signs

    def at(self, index: Indices) -> Terms:
        """The terms at some of the parameters."""
        nodes = {name: getattr(self, name)[index] for name in ("a", "b", "d", "e", "caps")}
        return self._replace(**nodes, motors=None if self.motors is None else self.motors.at(index))

    def rows(self, rate: Array, second: Array, room: Array, signs: Array) -> Rows:
        """What bounds s'', limits times room, (n, quantities).

        rate, second: s' and s'' of the motion found last, (n,). signs: of the rates of the legs, (n, 6), 0:
        either.
        """
        count = len(self.limit)
        most = self.limit * room[:, :count]
        own = Rows.of_one_form((self.a, self.b, self.d, self.e), -most, most)
        if self.motors is None:
            return own
        return Rows.together([own, self.motors.rows(rate, second, room[:, count:-1], signs)])


def traveled(motion: Motion, rate: Array | float, second: Array | float) -> Motion:
    """Motion in time of a motion by parameter, at s' and s'', (n,)."""
    z, u = (np.broadcast_to(np.asarray(x, dtype=np.float64), motion.shape)[..., None] for x in (rate, second))
    assert motion.a is not None
    assert motion.alpha is not None
    alpha, a = motion.alpha * z**2 + motion.omega * u, motion.a * z**2 + motion.v * u
    rates = motion.omega * z, motion.v * z, alpha, a
    return Motion._unchecked(motion.R, motion.t, *rates, motion.F_ext, motion.M_ext)


def terms_along(
    robot: Robot, path: Path, s: Array, limits: PathLimits, formulation: Formulation, motors: bool = False
) -> Terms:
    """Coefficients at parameters s, (n,): of forces, of leg accelerations and motors where they are limited.

    motors: with those of the motors in any case. Raises ValueError at poses that have no forces.
    """
    motion, forces_along = path(s), forces_of(robot, formulation, "c")

    def forces(rate: float, second: float) -> Array:
        return forces_along(traveled(motion, rate, second))

    still, ahead, back = forces(0.0, 0.0), forces(1.0, 0.0), forces(-1.0, 0.0)
    if not np.isfinite(still).all():
        inverse_dynamics(robot, motion, formulation)  # which names the poses
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
    """Force limits of the actuators, N, (6,)."""
    return robot.force_limit if limits.force is None else np.array(limits.force)


def leg_accelerations(robot: Robot, motion: Motion) -> Array:
    """Second derivatives of the legs' lengths, (n, 6), of a motion with accelerations."""
    found = inverse_kinematics(robot, motion).L_ddot
    assert found is not None
    return found


def limited_speeds(robot: Robot, motion: Motion, L_dot: Array, limits: PathLimits) -> tuple[Array, Array]:
    """Sizes of the rates that are limited, m/s and rad/s, (n, m), and their limits, (m,), inf for none.

    Those of the legs and of the drives' motors, of the reference point and of the platform's rotation.
    """
    speeds = [L_dot, *(np.linalg.norm(x, axis=-1, keepdims=True) for x in (motion.v, motion.omega))]
    legs = robot.speed_limit if limits.speed is None else np.array(limits.speed)
    most = [legs, [limits.platform_speed or math.inf, limits.platform_turn_rate or math.inf]]
    if robot.drive is not None:
        speeds.append(motor_rates(robot, robot.drive, motion, L_dot))
        most.append(robot.drive.speed_limit / np.abs(robot.drive.transmission_ratio))
    return np.abs(np.concatenate(speeds, axis=-1)), np.concatenate(most)
