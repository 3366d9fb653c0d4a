"""Drives of the legs, screw or rack, rotor, friction, and motor limits, and their tables in robot files.

The motor angle is ``transmission_ratio`` times the change of leg length. The equations of motion include only
the rotor. Friction, efficiency, and the motor constants act between the leg force F and the motor.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from ..io import toml_reader
from ..io.array_types import Array, Frozen
from .fields import LEGS, Check, LegTables, legs_text

_ONE_TURN = 2.0 * math.pi


class _Key(NamedTuple):
    """Check, default, and unit of one number of a drive."""

    check: Check
    default: float
    unit: str = ""
    """``length`` or ``angle`` if the unit of this name in the file applies."""


_NOT_ZERO = partial(toml_reader.number, rule="other than 0", allowed=lambda x: x != 0.0)
_FRACTION = partial(toml_reader.number, rule="> 0 and <= 1", allowed=lambda x: 0.0 < x <= 1.0)
_AT_MOST_1 = partial(toml_reader.number, rule="<= 1", allowed=lambda x: x <= 1.0)

NUMBERS: Mapping[str, _Key] = {
    "lead": _Key(_NOT_ZERO, math.nan, "length"),
    "rotor_inertia": _Key(toml_reader.not_negative, 0.0),
    "efficiency": _Key(_FRACTION, 1.0),
    "backdrive_efficiency": _Key(_AT_MOST_1, 1.0),
    "screw_coulomb": _Key(toml_reader.not_negative, 0.0),
    "screw_viscous": _Key(toml_reader.not_negative, 0.0),
    "motor_coulomb": _Key(toml_reader.not_negative, 0.0),
    "motor_viscous": _Key(toml_reader.not_negative, 0.0),
    "stribeck_force": _Key(toml_reader.not_negative, 0.0),
    "stribeck_speed": _Key(toml_reader.not_negative, 0.0, "length"),
    "regularization_speed": _Key(toml_reader.not_negative, 0.0, "length"),
    "torque_constant": _Key(toml_reader.not_negative, 0.0),
    "resistance": _Key(toml_reader.not_negative, 0.0),
    "rated_torque": _Key(toml_reader.positive, math.inf),
    "torque_limit": _Key(toml_reader.positive, math.inf),
    "speed_limit": _Key(toml_reader.positive, math.inf, "angle"),
    "current_limit": _Key(toml_reader.positive, math.inf),
    "power_limit": _Key(toml_reader.positive, math.inf),
    "gear_ratio": _Key(toml_reader.positive, 1.0),
}
"""Check, default, and unit of each field of a drive; a lead has no default."""

KEYS = ("lead", "radius", "gear_ratio", *(name for name in NUMBERS if name not in ("lead", "gear_ratio")))
"""Keys of a drive table in a robot file of schema 2."""


# Defaults for all six legs; the checks convert them to arrays.
_ZERO: Any = 0.0
_ONE: Any = 1.0
_UNLIMITED: Any = math.inf
_OF_EFFICIENCY: Any = None


@dataclass(frozen=True, eq=False)
class Drive(Frozen):
    """Drives of six legs.

    Each field is one number for all legs or six numbers, stored as a read-only array of shape (6,). Torques
    and speeds are at the motor, whose angle increases with the leg length.

    Attributes
    ----------
    lead : ndarray, shape (6,)
        Change of leg length per turn of the screw (m); negative for a left-handed screw.
    rotor_inertia : ndarray, shape (6,)
        Inertia of all parts that rotate with the motor, about the motor axis (kg m^2).
    efficiency : ndarray, shape (6,)
        Efficiency of the transmission if the motor drives the leg, in (0, 1].
    backdrive_efficiency : ndarray, shape (6,)
        Efficiency of the transmission if the leg drives the motor, at most 1; 0 or less is self-locking.
        None, the default, means 2 - 1 / ``efficiency``.
    screw_coulomb, screw_viscous : ndarray, shape (6,)
        Friction along the leg (N and N s/m), in addition to ``C_p`` of the robot.
    motor_coulomb, motor_viscous : ndarray, shape (6,)
        Friction of the motor (N m and N m s).
    stribeck_force : ndarray, shape (6,)
        Increase of the friction at rest above ``screw_coulomb`` (N).
    stribeck_speed : ndarray, shape (6,)
        Rate of length at which this increase has decayed to 1/e (m/s).
    regularization_speed : ndarray, shape (6,)
        Rate of length below which the sign in the friction is smoothed (m/s); 0 for a discontinuous sign.
    torque_constant : ndarray, shape (6,)
        Motor torque per current (N m/A); 0 if unknown.
    resistance : ndarray, shape (6,)
        Winding resistance for this current (ohm); 0 if unknown.
    rated_torque : ndarray, shape (6,)
        Limit of the root mean square torque (N m); inf means no limit.
    torque_limit, speed_limit, current_limit, power_limit : ndarray, shape (6,)
        Peak limits (N m, rad/s, A, and W); inf means no limit.
    gear_ratio : ndarray, shape (6,)
        Motor turns per screw turn.

    Raises
    ------
    ValueError
        If a number violates a rule; the message names the field.

    Examples
    --------
    >>> import dataclasses
    >>> import stewart_sym as ss
    >>> drive = ss.Drive(lead=0.005, gear_ratio=2.0)
    >>> drive.transmission_ratio.round(1).tolist()
    [2513.3, 2513.3, 2513.3, 2513.3, 2513.3, 2513.3]
    >>> robot = dataclasses.replace(ss.robots.load("unal"), drive=drive)
    """

    lead: Array
    rotor_inertia: Array = _ZERO
    efficiency: Array = _ONE
    backdrive_efficiency: Array = _OF_EFFICIENCY
    screw_coulomb: Array = _ZERO
    screw_viscous: Array = _ZERO
    motor_coulomb: Array = _ZERO
    motor_viscous: Array = _ZERO
    stribeck_force: Array = _ZERO
    stribeck_speed: Array = _ZERO
    regularization_speed: Array = _ZERO
    torque_constant: Array = _ZERO
    resistance: Array = _ZERO
    rated_torque: Array = _UNLIMITED
    torque_limit: Array = _UNLIMITED
    speed_limit: Array = _UNLIMITED
    current_limit: Array = _UNLIMITED
    power_limit: Array = _UNLIMITED
    gear_ratio: Array = _ONE

    def __post_init__(self) -> None:
        if self.backdrive_efficiency is None:
            self._set({"backdrive_efficiency": _driven_back(_six(self.efficiency, "efficiency"))})
        checked = {each.name: _six(getattr(self, each.name), each.name) for each in fields(self)}
        for i in range(LEGS):
            leg = {name: float(values[i]) for name, values in checked.items()}
            _need_sound(leg, lambda name, i=i: f"{name}: leg {i + 1}")  # type: ignore[misc]
        self._set(checked)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Drive):
            return NotImplemented
        return all(np.array_equal(getattr(self, name), getattr(other, name)) for name in NUMBERS)

    @property
    def transmission_ratio(self) -> Array:
        """Motor angle N per change of leg length (rad/m), shape (6,): 2 pi ``gear_ratio`` / ``lead``."""
        return np.asarray(_ONE_TURN * self.gear_ratio / self.lead)

    @property
    def rotor_momentum(self) -> Array:
        """Angular momentum of the rotor about the leg per rate of length (kg m), J_r N, shape (6,)."""
        return np.asarray(self.rotor_inertia * self.transmission_ratio)

    @property
    def reflected_mass(self) -> Array:
        """Mass at the leg that is equivalent to the rotor inertia (kg), J_r N^2, shape (6,)."""
        return np.asarray(self.rotor_momentum * self.transmission_ratio)


def _driven_back(efficiency: Any) -> Any:
    """Return the backdrive efficiency for the same friction angle on a screw of small pitch."""
    return 2.0 - 1.0 / efficiency


def _six(value: object, name: str) -> Array:
    """Return one checked number per leg; infinity is accepted if it means no limit."""
    return toml_reader.per_leg(value, name, NUMBERS[name].check, NUMBERS[name].default == math.inf)


def _need_sound(leg: Mapping[str, float], where: Callable[[str], str]) -> None:
    """Raise ValueError if numbers of a drive contradict each other; ``where`` returns a number's place."""
    turns = _ONE_TURN * leg["gear_ratio"] / leg["lead"]
    # The bounds avoid an OverflowError, which Python raises in contrast to NumPy.
    if not (1e-100 < abs(turns) < 1e100 and math.isfinite(leg["rotor_inertia"] * turns * turns)):
        raise ValueError(f"{where('lead')}: expected a lead with which the rotor's inertia is a finite mass")
    if leg["stribeck_force"] > 0.0 and leg["stribeck_speed"] == 0.0:
        raise ValueError(f"{where('stribeck_force')}: requires a stribeck_speed > 0")
    for name in ("current_limit", "resistance"):
        if leg["torque_constant"] == 0.0 and leg[name] != NUMBERS[name].default:
            raise ValueError(f"{where(name)}: requires a torque_constant > 0")
    if leg["rated_torque"] > leg["torque_limit"] < math.inf and leg["rated_torque"] < math.inf:
        raise ValueError(
            f"{where('rated_torque')}: expected at most the torque_limit, {leg['torque_limit']:g} N m, got "
            f"{leg['rated_torque']:g}"
        )


# Tables of a robot file


def drive_of_tables(
    legs: LegTables, meters: Callable[[Any], Any], degrees: bool, spins: bool = False
) -> Drive | None:
    """Return the drives of a robot file of schema 2, or None if no leg has a drive.

    ``meters`` converts lengths of the file. ``degrees`` is True if the file has angles in degrees. ``spins``
    is True if the upper parts of the legs rotate in the lower parts.
    """
    if not any("drive" in table for table in legs.tables):
        return None
    drives = legs.inner("drive", KEYS)
    common, *own = drives.tables
    if not common and not all(own):
        alone = [prefix for prefix, mine in zip(drives.prefixes[1:], own, strict=True) if mine]
        prefix = (alone or drives.prefixes)[0].rstrip(".")
        without = legs_text([i for i, mine in enumerate(own) if not mine])
        raise ValueError(
            f"{prefix}: expected a drive of every leg, or a table legs.drive with keys; missing for {without}"
        )
    found = [_leg(drives, i, meters, degrees, spins) for i in range(LEGS)]
    return Drive(**{name: np.array([leg[name] for leg in found]) for name in NUMBERS})


def _leg(
    drives: LegTables, i: int, meters: Callable[[Any], Any], degrees: bool, spins: bool
) -> dict[str, float]:
    """Return the numbers of the drive of leg i, counted from 0."""
    given, mine = drives.of_leg(i), drives.tables[i + 1]
    if {"lead", "radius"} & mine.keys():
        # A transmission of the leg replaces the transmission of all legs, even under another key.
        given = {key: value for key, value in given.items() if key in mine or key not in ("lead", "radius")}

    def where(name: str) -> str:
        return drives.where(i, name) if name in given else drives.prefixes[(i + 1) * bool(mine)] + name

    if spins and "radius" in given:
        raise ValueError(f'{where("radius")}: a rack cannot turn with a "universal" platform_joint; use lead')
    found = {"lead": _lead(given, where, meters)}
    for name, key in NUMBERS.items():
        if name == "lead":
            continue
        if name not in given:
            found[name] = key.default
            continue
        value = key.check(given[name], where(name))
        if key.unit == "length":
            value = float(meters(value))
        found[name] = math.radians(value) if key.unit == "angle" and degrees else value
    if "backdrive_efficiency" not in given:
        found["backdrive_efficiency"] = _driven_back(found["efficiency"])
    _need_sound(found, where)
    return found


def _lead(given: Mapping[str, Any], where: Callable[[str], str], meters: Callable[[Any], Any]) -> float:
    """Return the change of leg length per turn (m) of a screw or of a pinion on its rack."""
    if "lead" in given and "radius" in given:
        raise ValueError(f"{where('radius')}: expected lead or radius, got both")
    if "radius" in given:
        return _ONE_TURN * float(meters(toml_reader.positive(given["radius"], where("radius"))))
    if "lead" not in given:
        raise ValueError(f"{where('lead')}: missing, and radius as well")
    check = NUMBERS["lead"].check
    # The check is repeated, because a tiny number of millimeters can be 0 in meters.
    return float(check(meters(check(given["lead"], where("lead"))), where("lead")))


def drive_tables(drive: Drive) -> list[dict[str, float]]:
    """Return the table of each leg in SI units without defaults; ``drive_of_tables`` is the inverse."""
    legs: list[dict[str, float]] = []
    for i in range(LEGS):
        found = {name: float(getattr(drive, name)[i]) for name in NUMBERS}
        kept = {name: value for name, value in found.items() if value != NUMBERS[name].default}
        legs.append(kept | {"backdrive_efficiency": found["backdrive_efficiency"]})
    return legs
