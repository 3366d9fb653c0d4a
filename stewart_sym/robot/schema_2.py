"""Conversion between the tables of a robot file of schema 2 and the fields of a robot.

The file may have points by radius and angles, bodies by shape and density, millimeters and degrees, and
common values of all legs.
"""

import math
from collections.abc import Mapping
from decimal import Decimal
from typing import Any

import numpy as np

from ..io import toml_reader
from ..io.arguments import option, safe_text, shown
from ..io.array_types import Array
from ..io.error_policy import errors_of
from ..motion.trajectory_format import LENGTH_UNITS, TrajectoryFormat
from . import fields
from .bodies import INERTIA_KEYS, Meters, body
from .drive import drive_of_tables, drive_tables
from .offset_positions import lengths_at_home
from .offsets import TABLES, JointOffsets, offset_tables, offsets_of_tables

SCHEMA = 2

_TOP_KEYS = (
    *("schema", "name", "length_unit", "angle_unit", "base_joint", "gravity", "suppress_warnings"),
    *("base", "platform", "legs", "leg", "home_position", "trajectory"),
)
_NEEDED = ("schema", "name", "base", "platform")
RING_KEYS = ("radius", "angles", "z")
_POINT_KEYS = ("points", *RING_KEYS)
_PARTS = {"lower": 1.0, "upper": -1.0}
"""Parts of a leg, and the direction along x in which they extend from their joint."""
_DAMPING_KEYS = ("universal", "prismatic", "spherical")
_LIMIT_KEYS = ("length_limits", "stroke", "force_limit", "speed_limit", "joint_angle_limit")
_SHARED_KEYS = ("universal_axis", *_PARTS, "damping", "drive", *TABLES, *_LIMIT_KEYS)
_LEG_KEYS = ("base_point", "platform_point", *_SHARED_KEYS)
_NUMBERS = tuple(str(i + 1) for i in range(fields.LEGS))
_FORMAT_KEYS = (
    *("euler_order", "length_mode", "pose_mode", "length_unit", "angle_unit", "time_unit", "row_rate"),
    *("columns", "offsets", "scales"),
)
AXES = ("tangential", "radial", "horizontal")
"""Named fixed axes.

tangential: along the circle about z around the mean of the base points. radial: toward this mean. horizontal:
perpendicular to z and to the leg at the home pose.
"""

# Angles of more turns than this limit must be in degrees.
_MOST_TURNS = 2.0


@np.errstate(over="ignore", invalid="ignore")
def values(d: object, file: str) -> dict[str, Any]:
    """Return the checked fields of a robot by name; every message begins with ``file``."""
    top = toml_reader.checked_table(d, file, _TOP_KEYS, _NEEDED)
    units = {
        name: fields.POSE_FIELDS[name](top.get(name, fields.DEFAULTS[name]), f"{file}{name}")
        for name in ("length_unit", "angle_unit")
    }
    meters, degrees = _meters(units["length_unit"]), units["angle_unit"] == "deg"
    joint = fields.base_joint(top.get("base_joint", "universal"), f"{file}base_joint")
    home = (
        meters(toml_reader.vector(top["home_position"], f"{file}home_position"))
        if "home_position" in top
        else None
    )
    own = {
        "name": safe_text(toml_reader.one_line(top["name"], f"{file}name")),
        "base_joint": joint,
        "g": toml_reader.vector(top.get("gravity", fields.DEFAULT_GRAVITY), f"{file}gravity"),
        "suppressed_warnings": fields.accepted(top.get("suppress_warnings", ()), f"{file}suppress_warnings"),
        "home_position": home,
        **units,
        **_trajectory(top.get("trajectory", {}), f"{file}trajectory.", meters, home),
    }
    platform = toml_reader.checked_table(top["platform"], f"{file}platform.", (*_POINT_KEYS, "body"))
    base = toml_reader.checked_table(top["base"], f"{file}base.", _POINT_KEYS)
    rings = [
        points(table, f"{file}{name}.", meters, degrees)
        for name, table in (("base", base), ("platform", platform))
    ]
    on_top = _NO_BODY
    if "body" in platform:
        on_top = body(platform["body"], f"{file}platform.body", meters, None)
        toml_reader.require(on_top, INERTIA_KEYS, f"{file}platform.body.", "missing")
    own |= {"M": on_top["mass"], "R_0": on_top["center_of_mass"], "I_p": on_top["inertia"]}
    legs = _Legs(top, file, meters, degrees, joint, home)
    offsets = offsets_of_tables(legs.tables, meters)
    if offsets is not None and joint == "spherical":
        raise ValueError(f'{file}legs.offsets: expected none when base_joint is "spherical"')
    drive = drive_of_tables(legs.tables, meters, degrees, offsets is not None and offsets.has_spinning_parts)
    found = own | legs.values(rings[0], rings[1], offsets) | {"drive": drive, "offsets": offsets}
    # Conversions and sums may overflow.
    missing = {name for names in fields.MASS_FIELDS.values() for name in names if np.isnan(found[name]).all()}
    for name, value in found.items():
        if (
            name not in (*fields.UNSTATED, *missing)
            and isinstance(value, float | np.ndarray)
            and not np.all(np.isfinite(value))
        ):
            where = f"{file}{_SECTIONS.get(name, 'legs')}"
            raise ValueError(f"{where}: expected numbers whose sums and squares are finite")
    return found


def _meters(unit: str) -> Meters:
    """Return a conversion of lengths to m, exact for decimals: the result is the nearest double."""
    factor = Decimal(repr(LENGTH_UNITS[unit]))
    exact = np.vectorize(lambda x: float(Decimal(repr(float(x))) * factor), otypes=[np.float64])
    return lambda length: np.asarray(length if unit == "m" else exact(length))[()]


def _trajectory(value: object, prefix: str, meters: Meters, home: Array | None) -> dict[str, Any]:
    """Return the fields that define the representation of poses."""
    table = dict(toml_reader.checked_table(value, prefix, ("tool", *_FORMAT_KEYS)))
    tool = toml_reader.vector(table.pop("tool", np.zeros(3)), f"{prefix}tool")
    with errors_of(prefix):
        form = TrajectoryFormat(**table)
    fields.need_home(form, home, prefix)
    return {"tool": meters(tool), "trajectory_format": form}


_NO_BODY = {"mass": math.nan, "center_of_mass": np.full(3, math.nan), "inertia": np.full((3, 3), math.nan)}
"""Mass properties of a body that the file does not contain."""

_SECTIONS = {"b": "base", "p": "platform", "M": "platform", "R_0": "platform", "I_p": "platform"}
_SECTIONS |= {"home_position": "home_position", "tool": "trajectory", "g": "gravity"}


class _Legs:
    """Values that the legs share, and values of single legs."""

    def __init__(
        self,
        top: Mapping[str, Any],
        file: str,
        meters: Meters,
        degrees: bool,
        joint: str,
        home: Array | None,
    ) -> None:
        self.file, self.meters, self.degrees, self.joint, self.home = file, meters, degrees, joint, home
        shared = toml_reader.checked_table(top.get("legs", {}), f"{file}legs.", _SHARED_KEYS)
        given = top.get("leg", {})
        if not isinstance(given, Mapping):
            raise ValueError(f"{file}leg: expected tables [leg.1] to [leg.6], got {shown(given)}")
        some = toml_reader.checked_table(given, f"{file}leg.", _NUMBERS)
        own = [toml_reader.checked_table(some.get(n, {}), f"{file}leg.{n}.", _LEG_KEYS) for n in _NUMBERS]
        self.tables = fields.LegTables.of(shared, own, file)
        self.damping = self.tables.inner("damping", _DAMPING_KEYS)

    def values(
        self, base: Array | None, platform: Array | None, offsets: JointOffsets | None
    ) -> dict[str, Any]:
        """Return the fields with an entry per leg, from the points of both rings (None if not given)."""
        ends = [
            np.array([self._point(i, key, ring) for i in range(fields.LEGS)])
            for key, ring in (("base_point", base), ("platform_point", platform))
        ]
        at_home = None if self.home is None else self.home + ends[1] - ends[0]
        k = self._axes(ends[0], at_home)
        lengths = None
        if at_home is not None and offsets is not None:
            lengths = lengths_at_home(offsets, k, at_home)
        elif at_home is not None:
            lengths = np.linalg.norm(at_home, axis=-1)
        legs = [self._leg(i, None if lengths is None else float(lengths[i])) for i in range(fields.LEGS)]
        paths = {name: path for name, (path, _) in fields.LEG_FIELDS.items() if name not in "bpk"}
        found = {name: np.array([leg[path] for leg in legs]) for name, path in paths.items()}
        if self.joint == "spherical":
            fields.need_axisymmetric(
                found, lambda i, name: self.tables.where(i, paths[name].partition(".")[0])
            )
        return {"b": ends[0], "p": ends[1], "k": k, **found}

    def _point(self, i: int, key: str, ring: Array | None) -> Array:
        own = self.tables.tables[i + 1]
        if key in own:
            return np.asarray(self.meters(toml_reader.vector(own[key], self.tables.where(i, key))))
        if ring is None:
            section = key.partition("_")[0]
            raise ValueError(f"{self.file}{section}.points: missing, and leg.{i + 1}.{key} as well")
        return np.asarray(ring[i])

    def _axes(self, b: Array, at_home: Array | None) -> Array:
        found = np.zeros((fields.LEGS, 3))
        for i in range(fields.LEGS):
            given, where = self.tables.of_leg(i), self.tables.where(i, "universal_axis")
            if self.joint == "spherical":
                if "universal_axis" in given:
                    raise ValueError(f'{where}: expected none when base_joint is "spherical"')
                continue
            if "universal_axis" not in given:
                raise ValueError(f"{where}: missing")
            leg = None if at_home is None else at_home[i]
            found[i] = axis(given["universal_axis"], where, b[i], b.mean(axis=0), leg)
        return found

    def _leg(self, i: int, at_home: float | None) -> dict[str, Any]:
        """Return the values of a leg by path, without points and axis; ``at_home`` is its home length (m)."""
        found: dict[str, Any] = {}
        for part in _PARTS:
            found |= {f"{part}.{key}": value for key, value in self._part(i, part).items()}
        for name in _DAMPING_KEYS:
            found[f"damping.{name}"] = self.damping.get(i, name, toml_reader.not_negative, 0.0)
        for name in ("force_limit", "speed_limit"):
            found[name] = self.tables.get(i, name, toml_reader.positive, fields.UNSTATED[name])
        found["speed_limit"] = self.meters(found["speed_limit"])
        angles = self._joint_angles(i, at_home)
        return found | {"length_limits": self._length_limits(i, at_home), "joint_angle_limit": angles}

    def _part(self, i: int, part: str) -> dict[str, Any]:
        """Return mass, center of mass, inertia, and length of the lower or upper part."""
        side, shared, found, reason = _PARTS[part], self.tables.tables[0].get(part), {}, "missing"
        if shared is not None:
            found = body(shared, f"{self.file}legs.{part}", self.meters, side)
        if part in self.tables.tables[i + 1]:
            own = body(self.tables.tables[i + 1][part], self.tables.where(i, part), self.meters, side)
            # The inertia of shapes would be wrong for another mass.
            if isinstance(shared, list | tuple) or (isinstance(shared, Mapping) and "shape" in shared):
                found, reason = own, f"missing, since legs.{part} is by shape"
            else:
                found = found | own
        elif shared is None and not any(part in table for table in self.tables.tables):
            found = _NO_BODY
        elif shared is None:
            raise ValueError(f"{self.file}legs.{part}: missing")
        toml_reader.require(found, INERTIA_KEYS, f"{self.tables.where(i, part)}.", reason)
        return {"length": fields.UNSTATED[f"{part}.length"]} | found

    def _length_limits(self, i: int, at_home: float | None) -> Array:
        """Return the minimum and maximum length (m), (2,), given directly or about the home length."""
        for j in (i + 1, 0):
            table, prefix = self.tables.tables[j], self.tables.prefixes[j]
            if "length_limits" in table and "stroke" in table:
                raise ValueError(f"{prefix}stroke: expected stroke or length_limits, got both")
            if "length_limits" in table:
                return np.asarray(
                    self.meters(fields.limits(table["length_limits"], f"{prefix}length_limits"))
                )
            if "stroke" in table:
                return self._about_home(table["stroke"], f"{prefix}stroke", at_home)
        return np.array(fields.UNSTATED["length_limits"])

    def _joint_angles(self, i: int, at_home: float | None) -> Array:
        """Return the largest angles (rad) of both joints from the home pose, (2,)."""
        given, where = self.tables.of_leg(i), self.tables.where(i, "joint_angle_limit")
        if "joint_angle_limit" not in given:
            return np.array(fields.UNSTATED["joint_angle_limit"])
        found = fields.joint_angles(given["joint_angle_limit"], where, 180.0 if self.degrees else np.pi)
        if at_home is None:
            raise ValueError(
                f"{where}: is from the leg's direction at the home pose, expected a key home_position"
            )
        return np.radians(found) if self.degrees else found

    def _about_home(self, value: object, where: str, length: float | None) -> Array:
        given = toml_reader.numbers(value, where, (2,))
        stroke = self.meters(given)
        if stroke[0] >= stroke[1]:
            raise ValueError(f"{where}: expected [least, most] with least < most, got {shown(value)}")
        if length is None:
            raise ValueError(f"{where}: is about the length at the home pose, expected a key home_position")
        if np.isnan(length):
            raise ValueError(f"{where}: is about the length at the home pose, which the offsets cannot reach")
        if length + stroke[0] < 0.0:
            at_home = length / float(self.meters(np.float64(1.0)))
            text = f"expected a leg that is longer at home, {at_home:.6g}, than it can retract"
            raise ValueError(f"{where}: {text}, got {-given[0]:g}")
        return length + np.asarray(stroke)


def tables_of(given: Mapping[str, Any]) -> dict[str, Any]:
    """Return the tables of a robot file, plain values in SI units; ``values`` restores them to the bit."""
    body = (
        {}
        if math.isnan(given["M"])
        else {
            "body": _nested(
                {name.partition(".")[2]: given[key] for key, (name, _) in fields.FIELDS.items() if key != "g"}
            )
        }
    )
    home, drive, offsets = given["home_position"], given["drive"], given["offsets"]
    trajectory = {"tool": np.asarray(given["tool"]).tolist()} | format_table(given["trajectory_format"])
    drives = [{}] * fields.LEGS if drive is None else [{"drive": table} for table in drive_tables(drive)]
    shared, joints = ({}, [{}] * fields.LEGS) if offsets is None else offset_tables(offsets)
    accepted = given["suppressed_warnings"]
    return {
        "schema": SCHEMA,
        "name": given["name"],
        "base_joint": given["base_joint"],
        "gravity": np.asarray(given["g"]).tolist(),
        **({"suppress_warnings": list(accepted)} if accepted else {}),
        **({} if home is None else {"home_position": home.tolist()}),
        "base": {"points": np.asarray(given["b"]).tolist()},
        "platform": {"points": np.asarray(given["p"]).tolist(), **body},
        "legs": shared,
        "leg": {
            n: _leg_table(given, i) | own | joint
            for i, (n, own, joint) in enumerate(zip(_NUMBERS, drives, joints, strict=True))
        },
        "trajectory": trajectory,
    }


def format_table(form: TrajectoryFormat) -> dict[str, Any]:
    """Return the keys of a trajectory format that differ from the defaults."""
    given = {key: getattr(form, key) for key in _FORMAT_KEYS}
    return {
        key: dict(value) if isinstance(value, Mapping) else value for key, value in given.items() if value
    }


def _leg_table(given: Mapping[str, Any], i: int) -> dict[str, Any]:
    """Return the table of one leg, counted from 0, without its points."""
    found = {path: given[name][i] for name, (path, _) in fields.LEG_FIELDS.items() if name not in ("b", "p")}
    if given["base_joint"] == "spherical":
        del found["universal_axis"]
    stated = (
        path
        for path, value in found.items()
        if not (np.array_equal(value, fields.UNSTATED.get(path, np.nan)) or np.isnan(value).all())
    )
    return _nested({path: found[path] for path in stated})


def _nested(found: Mapping[str, Any]) -> dict[str, Any]:
    """Return tables of plain values by their paths."""
    top: dict[str, Any] = {}
    for path, value in found.items():
        table, _, key = path.rpartition(".")
        (top.setdefault(table, {}) if table else top)[key] = np.asarray(value).tolist()
    return top


# Points and axes


def points(table: Mapping[str, Any], prefix: str, meters: Meters, degrees: bool) -> Array | None:
    """Return six points (m), (6, 3), from ``points`` or from ``radius``, ``angles``, and ``z``, or None."""
    ring = [key for key in RING_KEYS if key in table]
    if "points" in table:
        if ring:
            raise ValueError(f"{prefix}{ring[0]}: expected points or radius and angles, got both")
        return _listed(table["points"], f"{prefix}points", meters)
    if not ring:
        return None
    toml_reader.require(table, RING_KEYS[:2], prefix, "missing")
    radius = toml_reader.per_leg(table["radius"], f"{prefix}radius", toml_reader.positive)
    angles = toml_reader.numbers(table["angles"], f"{prefix}angles", (fields.LEGS,))
    turns = np.abs(angles) / (360.0 if degrees else 2.0 * math.pi)
    if np.any(turns > _MOST_TURNS):
        i = int(np.argmax(turns))
        hint = "" if degrees else ': is angle_unit = "deg" missing?'
        raise ValueError(
            f"{prefix}angles: expected at most {_MOST_TURNS:g} turns, got {angles[i]:g} "
            f"{'deg' if degrees else 'rad'}{hint}"
        )
    if degrees and np.abs(angles).max() <= 2.0 * math.pi:
        most = np.abs(angles).max()
        raise ValueError(
            f"{prefix}angles: expected degrees all round, got at most {most:g}: are they in rad?"
        )
    c, s = np.array([cosine_and_sine(angle, degrees) for angle in angles]).T
    z = toml_reader.per_leg(table.get("z", 0.0), f"{prefix}z")
    radius = meters(radius)
    return np.stack([radius * c, radius * s, meters(z)], axis=-1)


def _listed(value: object, where: str, meters: Meters) -> Array:
    if not isinstance(value, list | tuple) or len(value) != fields.LEGS:
        raise ValueError(f"{where}: expected six points, got {shown(value)}")
    return np.stack([meters(toml_reader.vector(point, f"{where} {i}")) for i, point in enumerate(value, 1)])


def cosine_and_sine(angle: float, degrees: bool) -> tuple[float, float]:
    """Return cosine and sine; for degrees, exact at multiples of 90 and symmetric about them."""
    if not degrees:
        return math.cos(angle), math.sin(angle)
    quarters = round(angle / 90.0)
    rest = math.radians(angle - 90.0 * quarters)
    c, s = math.cos(rest), math.sin(rest)
    return ((c, s), (-s, c), (-c, -s), (s, -c))[quarters % 4]


def axis(value: object, where: str, b: Array, middle: Array, home: Array | None) -> Array:
    """Return the unit vector of the fixed axis of a leg, (3,), from a direction or one of ``AXES``.

    ``b`` is the base point of the leg (m), and ``middle`` is the mean of all base points (m). ``home`` is the
    vector of the leg at the home pose, from joint to joint.
    """
    if not isinstance(value, str):
        return fields.direction(value, where)
    name = option(value, AXES, where)
    along = b - middle
    if name == "horizontal":
        if home is None:
            raise ValueError(
                f'{where}: "{name}" is across the leg at the home pose, expected a key home_position'
            )
        along = home
    x, y, _ = along
    if x == y == 0.0:
        raise ValueError(f'{where}: "{name}" is no direction on the axis of the base, expected a vector')
    return fields.direction(np.array([x, y, 0.0] if name == "radial" else [-y, x, 0.0]), where)
