"""Requirements for each field of a robot, and its place in a robot file."""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from ..io import toml_reader
from ..io.arguments import option, shown
from ..io.array_types import Array
from ..motion.trajectory_format import LENGTH_UNITS, TrajectoryFormat

LEGS = 6
DEFAULT_GRAVITY = (0.0, 0.0, -9.81)
BASE_JOINTS = ("universal", "spherical")
SYMMETRY_TOLERANCE = 1e-9

Check = Callable[[object, str], Any]
"""Function that maps a value and its place, for messages, to the stored value."""

WARNING_NAMES = (
    *("platform-inertia", "lower-inertia", "upper-inertia", "density"),
    *("gravity", "length-unit", "proportion", "mass", "inertia-size", "center-of-mass"),
    *("leg-order", "condition", "crossing"),
    *("home", "length-limits", "force-limit", "speed-limit", "drive-limit", "drive-inertia", "drive-lead"),
    *("drive-speed", "tool"),
)
"""Names of all warnings about the numbers of a robot, as in ``suppress_warnings``.

The first four are issued on loading, the others by ``plausibility.find_implausible``.
"""

UNSTATED: dict[str, Any] = {
    "length_limits": (0.0, math.inf),
    "force_limit": math.inf,
    "speed_limit": math.inf,
    "joint_angle_limit": (math.inf, math.inf),
    "lower.length": 0.0,
    "upper.length": 0.0,
}
"""Values of the fields whose keys are missing in the table of a leg, by key."""


def legs_text(legs: Sequence[int]) -> str:
    """Return the names of legs, counted from 0, for a message."""
    if len(legs) == LEGS:
        return "all legs"
    return ("leg " if len(legs) == 1 else "legs ") + ", ".join(str(i + 1) for i in legs)


def vector_text(vector: Array) -> str:
    """Return the text of a vector for a message."""
    return "(" + ", ".join(f"{x:g}" for x in vector) + ")"


def base_joint(value: object, where: str) -> str:
    """Check the type of the base joints."""
    return option(value, BASE_JOINTS, where)


def accepted(value: object, where: str) -> tuple[str, ...]:
    """Check names of warnings."""
    if not isinstance(value, list | tuple):
        raise ValueError(f"{where}: expected a list of names of warnings, got {shown(value)}")
    return tuple(option(name, WARNING_NAMES, where) for name in value)


def limits(value: object, where: str) -> Array:
    """Check the minimum and maximum leg length, (2,)."""
    found = toml_reader.numbers(value, where, (2,))
    if not 0.0 <= found[0] < found[1]:
        raise ValueError(f"{where}: expected [min, max] with 0 <= min < max, got {shown(found.tolist())}")
    return found


def joint_angles(value: object, where: str, straight: float = math.pi) -> Array:
    """Check the largest angles of the base and platform joints, (2,), given as one angle for both or as two.

    ``straight`` is 180 degrees in the unit of the value.
    """
    both = isinstance(value, list | tuple | np.ndarray)
    found = toml_reader.numbers(value if both else [value, value], where, (2,))
    if not np.all((found > 0.0) & (found <= straight)):
        raise ValueError(f"{where}: expected angles > 0 and <= {straight:g}, got {shown(found.tolist())}")
    return found


def _or_unlimited(key: str, check: Check) -> Check:
    """Extend the check of a limit to infinity, which only memory can contain: robot files omit the key."""
    none = UNSTATED[key]

    def checked(value: object, where: str) -> Any:
        row = value.tolist() if isinstance(value, np.ndarray) else value
        if isinstance(row, list | tuple) and tuple(row) == none:
            return np.array(row)
        return none if isinstance(row, float) and row == none else check(row, where)

    return checked


def _or_missing(check: Check, shape: tuple[int, ...] = ()) -> Check:
    """Extend the check of a mass property to NaN, which means that the robot file does not contain it."""

    def checked(value: object, where: str) -> Any:
        if isinstance(value, float | list | np.ndarray) and np.all(np.isnan(np.asarray(value, dtype=float))):
            return np.full(shape, math.nan)[()]
        return check(value, where)

    return checked


def direction(value: object, where: str) -> Array:
    """Convert a direction to a unit vector, (3,)."""
    vector = toml_reader.vector(value, where)
    largest = float(np.max(np.abs(vector)))
    if largest == 0.0:
        raise ValueError(f"{where}: expected a non-zero direction, got {vector_text(vector)}")
    norm = math.sqrt(float(vector @ vector)) if 1e-100 < largest < 1e100 else 0.0
    # A unit vector is not scaled, so that tables of to_dict are read without changing a bit.
    if abs(norm - 1.0) <= 4.0 * np.finfo(np.float64).eps:
        return vector
    scaled = vector / largest
    return np.asarray(scaled / math.sqrt(float(scaled @ scaled)))


def no_direction(value: object, where: str) -> Array:
    """Check that a vector is zero, (3,)."""
    vector = toml_reader.vector(value, where)
    if np.any(vector != 0.0):
        raise ValueError(
            f'{where}: expected (0, 0, 0) when base_joint is "spherical", got {vector_text(vector)}'
        )
    return vector


def inertia(value: object, where: str) -> Array:
    """Check a symmetric tensor, (3, 3)."""
    tensor = toml_reader.numbers(value, where, (3, 3))
    if (tensor == tensor.T).all():
        return tensor
    skew = np.abs(tensor - tensor.T)
    if np.max(skew) > SYMMETRY_TOLERANCE * np.max(np.abs(tensor)):
        i, j = divmod(int(np.argmax(skew)), 3)
        raise ValueError(
            f"{where}: expected a symmetric tensor, got {tensor[i, j]:g} at ({i + 1}, {j + 1}) "
            f"and {tensor[j, i]:g} at ({j + 1}, {i + 1})"
        )
    return np.asarray(0.5 * tensor + 0.5 * tensor.T)


def need_axisymmetric(legs: Mapping[str, Array], name: Callable[[int, str], str]) -> None:
    """Raise ValueError for legs that are not bodies of revolution, whose spin spherical joints do not fix.

    ``legs`` contains fields of a robot by name. ``name`` returns the name of a field of a leg, counted from
    0, for messages.
    """
    for i in range(LEGS):
        for of_center, of_tensor in (("r_d0", "I_d0"), ("r_u0", "I_u0")):
            center, tensor = legs[of_center][i], legs[of_tensor][i]
            if np.any(np.abs(center[1:]) > SYMMETRY_TOLERANCE * np.max(np.abs(center))):
                expected = 'expected (x, 0, 0) when base_joint is "spherical"'
                raise ValueError(f"{name(i, of_center)}: {expected}, got {vector_text(center)}")
            wanted = np.diag([tensor[0, 0], tensor[1, 1], tensor[1, 1]])
            if np.any(np.abs(tensor - wanted) > SYMMETRY_TOLERANCE * np.max(np.abs(tensor))):
                raise ValueError(
                    f'{name(i, of_tensor)}: expected diag(Ia, It, It) when base_joint is "spherical"'
                )


class LegTables(NamedTuple):
    """Tables of a robot file of schema 2 about legs; a key of one leg replaces the key of all legs.

    tables: table of all legs, then the table of each leg. prefixes: prefixes of their keys in messages.
    """

    tables: tuple[Mapping[str, Any], ...]
    prefixes: tuple[str, ...]

    @classmethod
    def of(cls, shared: Mapping[str, Any], own: Sequence[Mapping[str, Any]], file: str) -> "LegTables":
        """Return the tables ``legs`` and of each leg; every message begins with ``file``."""
        return cls((shared, *own), (f"{file}legs.", *(f"{file}leg.{i + 1}." for i in range(LEGS))))

    def inner(self, name: str, keys: Sequence[str]) -> "LegTables":
        """Return the inner tables of a name, empty if missing, and check that all keys are known."""
        prefixes = tuple(f"{prefix}{name}." for prefix in self.prefixes)
        pairs = zip(self.tables, prefixes, strict=True)
        found = (toml_reader.checked_table(table.get(name, {}), prefix, keys) for table, prefix in pairs)
        return LegTables(tuple(found), prefixes)

    def of_leg(self, i: int) -> dict[str, Any]:
        """Return all values of a leg, counted from 0."""
        return {**self.tables[0], **self.tables[i + 1]}

    def where(self, i: int, key: str) -> str:
        """Return the place of a key that a leg defines itself or shares."""
        return (self.prefixes[i + 1] if key in self.tables[i + 1] else self.prefixes[0]) + key

    def get(self, i: int, key: str, check: Check, default: Any) -> Any:
        """Return the checked value of a key of a leg."""
        given = self.of_leg(i)
        return check(given[key], self.where(i, key)) if key in given else default

    def each(self, key: str, check: Check, default: Any) -> Array:
        """Return the values of all legs, (6, ...)."""
        return np.array([self.get(i, key, check, default) for i in range(LEGS)])


FIELDS: dict[str, tuple[str, Check]] = {
    "g": ("gravity", toml_reader.vector),
    "M": ("platform.mass", _or_missing(toml_reader.positive)),
    "R_0": ("platform.center_of_mass", _or_missing(toml_reader.vector, (3,))),
    "I_p": ("platform.inertia", _or_missing(inertia, (3, 3))),
}
"""Path in a robot file, without the folder of the body, and check of each field."""

LEG_FIELDS: dict[str, tuple[str, Check]] = {
    "b": ("base_point", toml_reader.vector),
    "p": ("platform_point", toml_reader.vector),
    "k": ("universal_axis", direction),
    "m_d": ("lower.mass", _or_missing(toml_reader.positive)),
    "r_d0": ("lower.center_of_mass", _or_missing(toml_reader.vector, (3,))),
    "I_d0": ("lower.inertia", _or_missing(inertia, (3, 3))),
    "m_u": ("upper.mass", _or_missing(toml_reader.positive)),
    "r_u0": ("upper.center_of_mass", _or_missing(toml_reader.vector, (3,))),
    "I_u0": ("upper.inertia", _or_missing(inertia, (3, 3))),
    "C_u": ("damping.universal", toml_reader.not_negative),
    "C_p": ("damping.prismatic", toml_reader.not_negative),
    "C_s": ("damping.spherical", toml_reader.not_negative),
    "length_limits": ("length_limits", _or_unlimited("length_limits", limits)),
    "force_limit": ("force_limit", _or_unlimited("force_limit", toml_reader.positive)),
    "speed_limit": ("speed_limit", _or_unlimited("speed_limit", toml_reader.positive)),
    "joint_angle_limit": ("joint_angle_limit", _or_unlimited("joint_angle_limit", joint_angles)),
    "lower_length": ("lower.length", toml_reader.not_negative),
    "upper_length": ("upper.length", toml_reader.not_negative),
}
"""Path in the table of a leg, and check of each field with an entry per leg."""

MASS_FIELDS = {
    "platform.body": ("M", "R_0", "I_p"),
    "legs.lower": ("m_d", "r_d0", "I_d0"),
    "legs.upper": ("m_u", "r_u0", "I_u0"),
}
"""Fields of mass properties, NaN if not given, by their key in a robot file."""


def need_whole_bodies(values: Mapping[str, Any], prefix: str) -> None:
    """Raise ValueError for a body of which some mass properties are missing, and others not."""
    for key, names in MASS_FIELDS.items():
        missing = np.concatenate([np.ravel(np.isnan(values[name])) for name in names])
        if missing.any() and not missing.all():
            raise ValueError(f"{prefix}{key}: expected mass, center_of_mass, and inertia, or none of them")


POSE_FIELDS: dict[str, Check] = {
    "home_position": lambda value, where: None if value is None else toml_reader.vector(value, where),
    "tool": toml_reader.vector,
    "length_unit": lambda value, where: option(value, tuple(LENGTH_UNITS), where),
    "angle_unit": lambda value, where: option(value, ("rad", "deg"), where),
}
"""Check of each field that defines the representation of poses and numbers."""

DEFAULTS: dict[str, Any] = {
    "home_position": None,
    "tool": np.zeros(3),
    "length_unit": "m",
    "angle_unit": "rad",
    "trajectory_format": TrajectoryFormat(),
    "drive": None,
    "offsets": None,
}
"""Values of the fields that a robot file may omit."""


def need_home(form: TrajectoryFormat, home: Array | None, prefix: str) -> None:
    """Raise ValueError for relative coordinates of a robot without a home position."""
    for name in ("length_mode", "pose_mode"):
        if getattr(form, name) == "relative" and home is None:
            raise ValueError(f'{prefix}{name}: "relative" refers to the home pose; add home_position')
