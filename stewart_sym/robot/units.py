"""Units of length, mass and time for one machine: powers of two, so that a change to them rounds nothing.

Every kernel takes any consistent units; in these the numbers of a machine of any size are near 1. The float
force kernels do without: their solve has a unit of length of its own, and nothing else in them depends on
units. The other kernels in float lose digits on small machines in SI units, and none in these.
"""

import dataclasses
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..io.arguments import shown
from ..motion.motion import Motion
from .robot import Robot

Array = NDArray[Any]

ROBOT: Mapping[str, tuple[int, int, int]] = {
    **dict.fromkeys(("b", "p", "r_d0", "r_u0", "R_0", "home_position", "tool"), (1, 0, 0)),
    **dict.fromkeys(("length_limits", "lower_length", "upper_length"), (1, 0, 0)),
    **dict.fromkeys(("M", "m_d", "m_u"), (0, 1, 0)),
    **dict.fromkeys(("I_p", "I_d0", "I_u0"), (2, 1, 0)),
    "g": (1, 0, -2),
    **dict.fromkeys(("C_u", "C_s"), (2, 1, -1)),
    "C_p": (0, 1, -1),
    "force_limit": (1, 1, -2),
    "speed_limit": (1, 0, -1),
}
"""Powers of length, mass and time in the fields of a robot; what is not here has no unit."""

DRIVE: Mapping[str, tuple[int, int, int]] = {
    "lead": (1, 0, 0),
    "rotor_inertia": (2, 1, 0),
    **dict.fromkeys(("screw_coulomb", "stribeck_force"), (1, 1, -2)),
    "screw_viscous": (0, 1, -1),
    **dict.fromkeys(("motor_coulomb", "torque_constant", "rated_torque", "torque_limit"), (2, 1, -2)),
    "motor_viscous": (2, 1, -1),
    **dict.fromkeys(("stribeck_speed", "regularization_speed"), (1, 0, -1)),
    "speed_limit": (0, 0, -1),
    **dict.fromkeys(("resistance", "power_limit"), (2, 1, -3)),
}
"""The same of a drive; the unit of current stays."""

OFFSETS: Mapping[str, tuple[int, int, int]] = {
    **dict.fromkeys(
        ("axis_offset", "slide_offset_y", "slide_offset_z", "wrist_offset", "cross_center"), (1, 0, 0)
    ),
    "cross_mass": (0, 1, 0),
    "cross_inertia": (2, 1, 0),
}
"""The same of offset joints."""

MOTION: Mapping[str, tuple[int, int, int]] = {
    "t": (1, 0, 0),
    "omega": (0, 0, -1),
    "v": (1, 0, -1),
    "alpha": (0, 0, -2),
    "a": (1, 0, -2),
    "F_ext": (1, 1, -2),
    "M_ext": (2, 1, -2),
}
"""The same of a motion."""

_LARGEST = 100
_FORCE = (1, 1, -2)


@dataclass(frozen=True)
class UnitScaling:
    """Units of length, m, mass, kg, and time, s: powers of two from 2^-100 to 2^100.

    A change of units multiplies by powers of two alone, so it is exact, and undone to the bit by ``inverse``,
    as long as no number leaves the range of normal numbers of its type.

    Attributes
    ----------
    length : float, optional
        Unit of length, m.
    mass : float, optional
        Unit of mass, kg.
    time : float, optional
        Unit of time, s.

    Raises
    ------
    ValueError
        Naming the unit that is no such power.
    """

    length: float = 1.0
    mass: float = 1.0
    time: float = 1.0

    def __post_init__(self) -> None:
        for field in dataclasses.fields(self):
            unit = getattr(self, field.name)
            good = isinstance(unit, float) and math.isfinite(unit) and math.frexp(unit)[0] == 0.5
            if not (good and abs(math.log2(unit)) <= _LARGEST):
                wanted = f"a power of two from 2^-{_LARGEST} to 2^{_LARGEST}"
                raise ValueError(f"{field.name}: expected {wanted}, got {shown(unit)}")

    @classmethod
    def for_robot(cls, robot: Robot) -> "UnitScaling":
        """Units in which the numbers of a robot are near 1.

        Parameters
        ----------
        robot : Robot
            The machine.

        Returns
        -------
        UnitScaling
            Length: the least power of two that no coordinate of the platform points exceeds, as in the float
            force kernels. Mass: the least that no part's mass exceeds. Time: the least not below
            sqrt(length / largest component of gravity), 1 s without gravity.
        """
        length = _power_of_two(float(np.abs(robot.p).max()))
        heaviest = max(robot.M, float(robot.m_d.max()), float(robot.m_u.max()))
        gravity = float(np.abs(robot.g).max())
        time = _power_of_two(math.sqrt(length / gravity)) if gravity else 1.0
        return cls(length, _power_of_two(heaviest), time)

    @property
    def inverse(self) -> "UnitScaling":
        """The units that undo a change to these."""
        return UnitScaling(1 / self.length, 1 / self.mass, 1 / self.time)

    def robot(self, robot: Robot) -> Robot:
        """A robot in these units.

        Parameters
        ----------
        robot : Robot
            In SI units.

        Returns
        -------
        Robot
            In these.
        """
        return rescaled(robot, 1 / self.length, 1 / self.mass, 1 / self.time)

    def motion(self, motion: Motion) -> Motion:
        """A motion in these units.

        Parameters
        ----------
        motion : Motion
            In SI units.

        Returns
        -------
        Motion
            In these; shapes and types stay.
        """
        changed = _rescaled(motion, MOTION, (1 / self.length, 1 / self.mass, 1 / self.time))
        return Motion._unchecked(**{**vars(motion), **changed})

    def forces(self, F: Array) -> Array:
        """Forces in N.

        Parameters
        ----------
        F : ndarray
            In these units.

        Returns
        -------
        ndarray
            In N; shape and type stay.
        """
        return F * _product((self.length, self.mass, self.time), _FORCE)


def rescaled(robot: Robot, length: float, mass: float, time: float = 1.0) -> Robot:
    """The robot with every length, mass and time multiplied by a factor: a similar machine of another size.

    Any factors > 0; powers of two are exact. Raises ValueError as ``Robot``.
    """
    factors = (length, mass, time)
    changed = _rescaled(robot, ROBOT, factors)
    for name, powers in (("drive", DRIVE), ("offsets", OFFSETS)):
        if (part := getattr(robot, name)) is not None:
            changed[name] = dataclasses.replace(part, **_rescaled(part, powers, factors))
    return dataclasses.replace(robot, **changed)


def _rescaled(
    record: object, powers: Mapping[str, tuple[int, int, int]], factors: tuple[float, float, float]
) -> dict[str, Any]:
    return {
        name: value * _product(factors, powers[name])
        for name in powers
        if (value := getattr(record, name)) is not None
    }


def _product(factors: tuple[float, float, float], powers: tuple[int, int, int]) -> float:
    return math.prod(factor**power for factor, power in zip(factors, powers, strict=True))


def _power_of_two(size: float) -> float:
    """The least power of two that is not below ``size``, within the range of units; 1 for zero."""
    if size == 0.0:
        return 1.0
    fraction, exponent = math.frexp(size)
    exponent -= fraction == 0.5
    return math.ldexp(1.0, max(-_LARGEST, min(_LARGEST, exponent)))
