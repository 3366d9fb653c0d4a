"""Units of length, mass, and time for one robot: powers of two, so that conversions do not round.

Every kernel accepts any consistent units; in these units the numbers of a machine of any size are near 1.
Float force kernels do not need them, because their linear solve has its own unit of length. The other float
kernels lose digits for small machines in SI units, but not in these units.
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
"""Powers of length, mass, and time in the fields of a robot; other fields have no unit."""

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
"""Powers of length, mass, and time in the fields of a drive; the unit of current does not change."""

OFFSETS: Mapping[str, tuple[int, int, int]] = {
    **dict.fromkeys(
        ("axis_offset", "slide_offset_y", "slide_offset_z", "wrist_offset", "cross_center"), (1, 0, 0)
    ),
    "cross_mass": (0, 1, 0),
    "cross_inertia": (2, 1, 0),
}
"""Powers of length, mass, and time in the fields of offset joints."""

MOTION: Mapping[str, tuple[int, int, int]] = {
    "t": (1, 0, 0),
    "omega": (0, 0, -1),
    "v": (1, 0, -1),
    "alpha": (0, 0, -2),
    "a": (1, 0, -2),
    "F_ext": (1, 1, -2),
    "M_ext": (2, 1, -2),
}
"""Powers of length, mass, and time in the fields of a motion."""

_LARGEST = 100
_FORCE = (1, 1, -2)


@dataclass(frozen=True)
class UnitScaling:
    """Units of length, mass, and time that are powers of two from 2^-100 to 2^100.

    A change of units multiplies only by powers of two. Therefore it is exact, and ``inverse`` undoes it to
    the bit, unless a number is outside the normal range of its type.

    Attributes
    ----------
    length : float, optional
        Unit of length (m).
    mass : float, optional
        Unit of mass (kg).
    time : float, optional
        Unit of time (s).

    Raises
    ------
    ValueError
        If a unit is not such a power of two; the message names the unit.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dehaeze_nano")
    >>> units = ss.UnitScaling.for_robot(robot)
    >>> units
    UnitScaling(length=0.125, mass=1.0, time=0.125)
    >>> bool((units.inverse.robot(units.robot(robot)).p == robot.p).all())
    True
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
        """Return units in which the numbers of a robot are near 1.

        Parameters
        ----------
        robot : Robot
            Robot model in SI units.

        Returns
        -------
        UnitScaling
            Length: smallest power of two that no coordinate of the platform points exceeds, as in the float
            force kernels. Mass: smallest power of two that the mass of no part exceeds. Time: smallest power
            of two not below sqrt(length / largest component of gravity); 1 s without gravity.
        """
        length = _power_of_two(float(np.abs(robot.p).max()))
        heaviest = max(robot.M, float(robot.m_d.max()), float(robot.m_u.max()))
        gravity = float(np.abs(robot.g).max())
        time = _power_of_two(math.sqrt(length / gravity)) if gravity else 1.0
        return cls(length, _power_of_two(heaviest), time)

    @property
    def inverse(self) -> "UnitScaling":
        """Units that undo a change to these units."""
        return UnitScaling(1 / self.length, 1 / self.mass, 1 / self.time)

    def robot(self, robot: Robot) -> Robot:
        """Convert a robot to these units.

        Parameters
        ----------
        robot : Robot
            Robot model in SI units.

        Returns
        -------
        Robot
            Robot model in these units.
        """
        return rescaled(robot, 1 / self.length, 1 / self.mass, 1 / self.time)

    def motion(self, motion: Motion) -> Motion:
        """Convert a motion to these units.

        Parameters
        ----------
        motion : Motion
            Motion in SI units.

        Returns
        -------
        Motion
            Motion in these units, with the same shapes and types.
        """
        changed = _rescaled(motion, MOTION, (1 / self.length, 1 / self.mass, 1 / self.time))
        return Motion._unchecked(**{**vars(motion), **changed})

    def forces(self, F: Array) -> Array:
        """Convert forces from these units to N.

        Parameters
        ----------
        F : ndarray
            Forces in these units.

        Returns
        -------
        ndarray
            Forces (N), with the same shape and type.
        """
        return F * _product((self.length, self.mass, self.time), _FORCE)


def rescaled(robot: Robot, length: float, mass: float, time: float = 1.0) -> Robot:
    """Return a similar robot of another size: every length, mass, and time is multiplied by a factor.

    All factors are > 0; powers of two are exact. Raises ValueError as ``Robot``.
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
    """Return the smallest power of two not below ``size``, within the range of units; 1 for zero."""
    if size == 0.0:
        return 1.0
    fraction, exponent = math.frexp(size)
    exponent -= fraction == 0.5
    return math.ldexp(1.0, max(-_LARGEST, min(_LARGEST, exponent)))
