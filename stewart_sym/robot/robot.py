"""The machine: geometry, masses, friction and limits, as read from a robot file and checked once."""

import math
import os
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..io import tables
from ..io.arguments import shown
from ..io.array_types import Array
from ..io.frozen import Frozen

SCHEMA = 1
LEGS = 6
DEFAULT_GRAVITY = (0.0, 0.0, -9.81)
BASE_JOINTS = ("universal", "spherical")
SYMMETRY_TOLERANCE = 1e-9

Check = Callable[[object, str], Any]
"""From a value and where it stands, for messages, to the value as it is kept."""

_TOP_KEYS = ("schema", "name", "base_joint", "gravity", "accept", "platform", "leg_defaults", "leg")
_BODY_KEYS = ("mass", "center_of_mass", "inertia")
_TABLES = dict.fromkeys(("platform", "lower", "upper"), _BODY_KEYS)
_TABLES["friction"] = ("universal", "prismatic", "spherical")
_SHARED_KEYS = ("lower", "upper", "friction", "length_limits", "force_limit", "speed_limit")
_NO_LIMITS = {"length_limits": (0.0, math.inf), "force_limit": math.inf, "speed_limit": math.inf}
_LEG_KEYS = ("base_point", "platform_point", "universal_axis", *_SHARED_KEYS)


DOUBTS = (
    *("platform-inertia", "lower-inertia", "upper-inertia"),
    *(
        "gravity",
        "length-unit",
        "stray-point",
        "proportion",
        "mass",
        "inertia-size",
        "center-of-mass",
        "friction",
    ),
    *("singular-everywhere", "leg-order", "condition", "crossing", "joint-singularity", "overlap"),
    *("length-limits", "force-limit", "speed-limit"),
)
"""Names of all warnings about a robot's numbers, as ``accept`` takes them: the first three are given on
loading, the others by ``plausibility.doubts``."""


class PhysicalityWarning(UserWarning):
    """Numbers that no machine, or hardly one, can have; the robot is loaded all the same."""


@dataclass(frozen=True, eq=False)
class Robot(Frozen):
    """A Stewart platform with six legs, all of them distinct if need be.  SI units; arrays are read-only.

    Attributes
    ----------
    name : str
        One line of text.
    base_joint : str
        ``"universal"`` (the paper's machine) or ``"spherical"`` (joints of that kind at both ends).
    g : ndarray
        Gravity, m/s^2, base frame, (3,).
    M : float
        Platform mass with payload, kg.
    R_0 : ndarray
        Centre of mass of the platform, m, platform frame, (3,).
    I_p : ndarray
        Its inertia about that centre of mass, kg m^2, platform frame, (3, 3).
    b : ndarray
        Base points, m, base frame, (6, 3).
    p : ndarray
        Platform points, m, platform frame, (6, 3).
    k : ndarray
        Unit fixed axes of the universal joints, base frame, (6, 3); zeros when ``base_joint`` is spherical.
    m_d, m_u : ndarray
        Masses of the lower and upper parts, kg, (6,).
    r_d0 : ndarray
        Centres of mass of the lower parts, m, frame D (origin at the base point), (6, 3).
    I_d0, I_u0 : ndarray
        Inertias about those centres of mass, kg m^2, frames D and U, (6, 3, 3).
    r_u0 : ndarray
        Centres of mass of the upper parts, m, frame U (origin at the platform point), (6, 3).
    C_u, C_p, C_s : ndarray
        Viscous friction of the base joint (N m s), prismatic joint (N s/m) and spherical joint (N m s), (6,).
    length_limits : ndarray, optional
        Shortest and longest leg, m, (6, 2); a row (0, inf) means no limit.
    force_limit, speed_limit : ndarray, optional
        Of the actuators, N and m/s, (6,); inf means no limit.
    accept : tuple, optional
        Names, of ``DOUBTS``, of warnings that are known of this robot and not given.

    Raises
    ------
    ValueError
        Naming the field when a value breaks a rule of the robot file. ``dataclasses.replace`` makes a changed
        copy and checks it again.
    """

    name: str
    base_joint: str
    g: Array
    M: float
    R_0: Array
    I_p: Array
    b: Array
    p: Array
    k: Array
    m_d: Array
    r_d0: Array
    I_d0: Array
    m_u: Array
    r_u0: Array
    I_u0: Array
    C_u: Array
    C_p: Array
    C_s: Array
    length_limits: Array = field(default_factory=lambda: np.tile([0.0, math.inf], (LEGS, 1)))
    force_limit: Array = field(default_factory=lambda: np.full(LEGS, math.inf))
    speed_limit: Array = field(default_factory=lambda: np.full(LEGS, math.inf))
    accept: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        """Check every field and freeze private float64 copies of the arrays."""
        tables.one_line(self.name, "robot: name")
        _base_joint(self.base_joint, "robot: base_joint")
        checked: dict[str, Any] = {"accept": _accepted(self.accept, "robot: accept")}
        for name, (_, check) in _FIELDS.items():
            checked[name] = check(getattr(self, name), f"robot: {name}")
        for name, (_, check) in _LEG_FIELDS.items():
            axis = name == "k" and self.base_joint == "spherical"
            checked[name] = self._per_leg(name, _no_direction if axis else check)
        self._set(checked)
        _need_axisymmetric(self, "robot: ", {})

    def _per_leg(self, name: str, check: Check) -> Array:
        given = getattr(self, name)
        rows = given.tolist() if isinstance(given, np.ndarray) else given
        if not isinstance(rows, list | tuple) or len(rows) != LEGS:
            raise ValueError(f"robot: {name}: expected one entry for each of six legs")
        return np.array([check(row, f"robot: leg {i}: {name}") for i, row in enumerate(rows, 1)])

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> "Robot":
        """Read a robot file (TOML, schema 1).

        Raises ``ValueError`` of one line, ``file: key: what was expected``, for a file that cannot be read
        and for every break of the schema; legs are numbered from 1.  Warns with ``PhysicalityWarning`` about
        inertias that no body can have, unless the file accepts them.
        """
        source = tables.file_name(path)
        robot = _from_table(cls, tables.read_toml(source, "robot file"), source)
        _warn(robot, source)
        return robot

    @classmethod
    def from_dict(cls, d: Mapping[str, Any]) -> "Robot":
        """Make a robot from the tables of a robot file as plain Python dicts and lists.

        Raises and warns as ``from_toml``, with ``robot`` in place of the file's name.
        """
        robot = _from_table(cls, d, "robot")
        _warn(robot, "robot")
        return robot

    def to_dict(self) -> dict[str, Any]:
        """Return the robot as the tables of a robot file, schema 1; ``from_dict`` undoes it to the bit."""
        own = _nested({path: getattr(self, name) for name, (path, _) in _FIELDS.items()})
        return {
            "schema": SCHEMA,
            "name": self.name,
            "base_joint": self.base_joint,
            "gravity": own["gravity"],
            **({"accept": list(self.accept)} if self.accept else {}),
            "platform": own["platform"],
            "leg": [self._leg_table(i) for i in range(LEGS)],
        }

    def _leg_table(self, i: int) -> dict[str, Any]:
        values = {path: getattr(self, name)[i] for name, (path, _) in _LEG_FIELDS.items()}
        if self.base_joint == "spherical":
            del values["universal_axis"]
        return _nested({path: value for path, value in values.items() if np.isfinite(value).all()})

    def physicality(self) -> list[str]:
        """Return one line for each part whose inertia no rigid body can have; empty when all are possible.

        Principal moments A <= B <= C of a body satisfy A >= 0 and A + B >= C.  Legs with the same tensor
        share a line.  What the robot accepts is reported as well.
        """
        return [message for _, message in _impossible_inertias(self)]


def _nested(values: Mapping[str, Any]) -> dict[str, Any]:
    """Tables of plain values by their paths."""
    found: dict[str, Any] = {}
    for path, value in values.items():
        table, _, key = path.rpartition(".")
        (found.setdefault(table, {}) if table else found)[key] = np.asarray(value).tolist()
    return found


# Physicality


def _impossible_inertias(robot: Robot) -> list[tuple[str, str]]:
    """Name, of ``DOUBTS``, and line of each impossible inertia."""
    found = [("platform-inertia", f"platform: inertia: {fault}") for fault in _inertia_fault(robot.I_p)]
    for part, tensors in (("lower", robot.I_d0), ("upper", robot.I_u0)):
        alike: dict[bytes, list[int]] = {}
        for i, tensor in enumerate(tensors):
            alike.setdefault(tensor.tobytes(), []).append(i)
        for legs in alike.values():
            for fault in _inertia_fault(tensors[legs[0]]):
                found.append((f"{part}-inertia", f"{part} part of {legs_text(legs)}: inertia: {fault}"))
    return found


def _inertia_fault(inertia: Array) -> list[str]:
    A, B, C = (float(moment) for moment in np.linalg.eigvalsh(inertia))
    tolerance = SYMMETRY_TOLERANCE * max(abs(A), abs(C))
    moments = f"principal moments {A:.3g}, {B:.3g}, {C:.3g} kg m^2"
    # A thin rod has A = 0: the limit of possible bodies is let pass.
    if A + tolerance < 0.0:
        return [f"physically impossible: {moments} are not all positive"]
    if A + B + tolerance < C:
        return [f"physically impossible: {moments} break A + B >= C"]
    return []


def legs_text(legs: Sequence[int]) -> str:
    """Legs, counted from 0, as a message names them."""
    if len(legs) == LEGS:
        return "all legs"
    return ("leg " if len(legs) == 1 else "legs ") + ", ".join(str(i + 1) for i in legs)


def _warn(robot: Robot, source: str) -> None:
    for name, message in _impossible_inertias(robot):
        if name not in robot.accept:
            warnings.warn(f"{source}: {message} [{name}]", PhysicalityWarning, stacklevel=3)


# From tables to a Robot


def _from_table(cls: type[Robot], d: object, source: str) -> Robot:
    """Check the tables of a robot file; ``source: `` begins every message."""
    file = f"{source}: "
    top = tables.checked_table(d, file, _TOP_KEYS, ("schema", "name", "platform", "leg"))
    tables.need_schema(top["schema"], SCHEMA, f"{file}schema")
    joint = _base_joint(top.get("base_joint", "universal"), f"{file}base_joint")
    own = _values({"gravity": top.get("gravity", DEFAULT_GRAVITY), "platform": top["platform"]}, file)
    tables.require(own, [path for path, _ in _FIELDS.values()], file, "missing")
    defaults = tables.checked_table(top.get("leg_defaults", {}), f"{file}leg_defaults.", _SHARED_KEYS)
    shared = _NO_LIMITS | _values(defaults, f"{file}leg_defaults.")
    given = top["leg"]
    if not isinstance(given, list | tuple):
        raise ValueError(f"{file}leg: expected six [[leg]] tables, got {shown(given)}")
    if len(given) != LEGS:
        raise ValueError(f"{file}leg: expected exactly six [[leg]] tables, got {len(given)}")
    legs = [_leg(table, shared, joint, f"{file}leg {i}: ") for i, table in enumerate(given, 1)]
    # Checked where a message can name the key, and so not again as fields.
    robot = object.__new__(cls)
    robot._set(
        {name: own[path] for name, (path, _) in _FIELDS.items()}
        | {name: np.array([leg[path] for leg in legs]) for name, (path, _) in _LEG_FIELDS.items()}
        | {"name": tables.one_line(top["name"], f"{file}name"), "base_joint": joint}
        | {"accept": _accepted(top.get("accept", ()), f"{file}accept")}
    )
    _need_axisymmetric(robot, file, {name: path for name, (path, _) in _LEG_FIELDS.items()})
    return robot


def _leg(value: object, shared: Mapping[str, Any], joint: str, prefix: str) -> dict[str, Any]:
    """Values of one leg by path, filled up from the defaults."""
    table = tables.checked_table(value, prefix, _LEG_KEYS, ("base_point", "platform_point"))
    if joint == "universal":
        tables.require(table, ("universal_axis",), prefix, "missing")
    elif "universal_axis" in table:
        raise ValueError(f'{prefix}universal_axis: expected none when base_joint is "spherical"')
    leg = {"universal_axis": np.zeros(3), **shared, **_values(table, prefix)}
    tables.require(
        leg, [path for path, _ in _LEG_FIELDS.values()], prefix, "missing, here and in leg_defaults"
    )
    return leg


def _values(table: Mapping[str, Any], prefix: str) -> dict[str, Any]:
    """Checked values of a table and of those in it, by path; any of them may be absent."""
    found: dict[str, Any] = {}
    for key, value in table.items():
        if key in _TABLES:
            inner = tables.checked_table(value, f"{prefix}{key}.", _TABLES[key])
            given = {f"{key}.{name}": each for name, each in inner.items()}
        else:
            given = {key: value}
        found |= {path: _CHECKS[path](each, prefix + path) for path, each in given.items()}
    return found


# Single values


def _vector_text(vector: Array) -> str:
    return "(" + ", ".join(f"{x:g}" for x in vector) + ")"


def _base_joint(value: object, where: str) -> str:
    if not isinstance(value, str) or value not in BASE_JOINTS:
        raise ValueError(f'{where}: expected "universal" or "spherical", got {shown(value)}')
    return value


def _accepted(value: object, where: str) -> tuple[str, ...]:
    if not isinstance(value, list | tuple):
        raise ValueError(f"{where}: expected a list of names of warnings, got {shown(value)}")
    return tuple(tables.choice(name, DOUBTS, where) for name in value)


def _limits(value: object, where: str) -> Array:
    limits = tables.numbers(value, (2,), where)
    if not 0.0 <= limits[0] < limits[1]:
        raise ValueError(f"{where}: expected [min, max] with 0 <= min < max, got {shown(limits.tolist())}")
    return limits


# A robot file says "no limit" by leaving the key out, so infinity is for robots in memory only.


def _limits_or_none(value: object, where: str) -> Array:
    row = value.tolist() if isinstance(value, np.ndarray) else value
    if isinstance(row, list | tuple) and tuple(row) == _NO_LIMITS["length_limits"]:
        return np.array(row)
    return _limits(row, where)


def _limit_or_none(value: object, where: str) -> float:
    return math.inf if isinstance(value, float) and value == math.inf else tables.positive(value, where)


def _direction(value: object, where: str) -> Array:
    vector = tables.vector(value, where)
    largest = float(np.max(np.abs(vector)))
    if largest == 0.0:
        raise ValueError(f"{where}: expected a non-zero direction, got {_vector_text(vector)}")
    norm = math.sqrt(float(vector @ vector)) if 1e-100 < largest < 1e100 else 0.0
    # A vector that is unit to rounding is left alone: reading what to_dict wrote must change no bit.
    if abs(norm - 1.0) <= 4.0 * np.finfo(np.float64).eps:
        return vector
    scaled = vector / largest
    return np.asarray(scaled / math.sqrt(float(scaled @ scaled)))


def _no_direction(value: object, where: str) -> Array:
    vector = tables.vector(value, where)
    if np.any(vector != 0.0):
        raise ValueError(
            f'{where}: expected (0, 0, 0) when base_joint is "spherical", got {_vector_text(vector)}'
        )
    return vector


def _inertia(value: object, where: str) -> Array:
    inertia = tables.numbers(value, (3, 3), where)
    skew = np.abs(inertia - inertia.T)
    if np.max(skew) > SYMMETRY_TOLERANCE * np.max(np.abs(inertia)):
        i, j = divmod(int(np.argmax(skew)), 3)
        raise ValueError(
            f"{where}: expected a symmetric tensor, got {inertia[i, j]:g} at ({i + 1}, {j + 1}) "
            f"and {inertia[j, i]:g} at ({j + 1}, {i + 1})"
        )
    return np.asarray(0.5 * inertia + 0.5 * inertia.T)


def _need_axisymmetric(robot: Robot, prefix: str, names: Mapping[str, str]) -> None:
    """Reject legs that are no bodies of revolution where spherical joints leave their spin free.

    names: of fields in messages, where these are others.
    """
    for i in range(LEGS if robot.base_joint == "spherical" else 0):
        for center, inertia in (("r_d0", "I_d0"), ("r_u0", "I_u0")):
            where = (f"{prefix}leg {i + 1}: {names.get(name, name)}" for name in (center, inertia))
            _axisymmetric(getattr(robot, center)[i], getattr(robot, inertia)[i], *where)


def _axisymmetric(center: Array, inertia: Array, where_center: str, where_inertia: str) -> None:
    if np.any(np.abs(center[1:]) > SYMMETRY_TOLERANCE * np.max(np.abs(center))):
        got = _vector_text(center)
        raise ValueError(f'{where_center}: expected (x, 0, 0) when base_joint is "spherical", got {got}')
    wanted = np.diag([inertia[0, 0], inertia[1, 1], inertia[1, 1]])
    if np.any(np.abs(inertia - wanted) > SYMMETRY_TOLERANCE * np.max(np.abs(inertia))):
        raise ValueError(f'{where_inertia}: expected diag(Ia, It, It) when base_joint is "spherical"')


_FIELDS: dict[str, tuple[str, Check]] = {
    "g": ("gravity", tables.vector),
    "M": ("platform.mass", tables.positive),
    "R_0": ("platform.center_of_mass", tables.vector),
    "I_p": ("platform.inertia", _inertia),
}
"""Path in a robot file and check of each field."""

_LEG_FIELDS: dict[str, tuple[str, Check]] = {
    "b": ("base_point", tables.vector),
    "p": ("platform_point", tables.vector),
    "k": ("universal_axis", _direction),
    "m_d": ("lower.mass", tables.positive),
    "r_d0": ("lower.center_of_mass", tables.vector),
    "I_d0": ("lower.inertia", _inertia),
    "m_u": ("upper.mass", tables.positive),
    "r_u0": ("upper.center_of_mass", tables.vector),
    "I_u0": ("upper.inertia", _inertia),
    "C_u": ("friction.universal", tables.not_negative),
    "C_p": ("friction.prismatic", tables.not_negative),
    "C_s": ("friction.spherical", tables.not_negative),
    "length_limits": ("length_limits", _limits_or_none),
    "force_limit": ("force_limit", _limit_or_none),
    "speed_limit": ("speed_limit", _limit_or_none),
}
"""The same of the fields with an entry for each leg, path in a leg's table."""

_CHECKS = dict((*_FIELDS.values(), *_LEG_FIELDS.values())) | {
    "length_limits": _limits,
    "force_limit": tables.positive,
    "speed_limit": tables.positive,
}
"""Check of each value of a robot file by path."""
