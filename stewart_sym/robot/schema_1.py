"""Tables of a robot file of schema 1, SI units and every number of every leg, as fields of a robot."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..io import tables
from ..io.arguments import shown
from . import fields

SCHEMA = 1

_TOP_KEYS = ("schema", "name", "base_joint", "gravity", "accept", "platform", "leg_defaults", "leg")
_LATER_KEYS = ("base", "length_unit", "angle_unit", "home", "trajectory")
_BODY_KEYS = ("mass", "center_of_mass", "inertia")
_TABLES = dict.fromkeys(("platform", "lower", "upper"), _BODY_KEYS)
_TABLES["friction"] = ("universal", "prismatic", "spherical")
_SHARED_KEYS = ("lower", "upper", "friction", "length_limits", "force_limit", "speed_limit")
_LEG_KEYS = ("base_point", "platform_point", "universal_axis", *_SHARED_KEYS)

_CHECKS = dict((*fields.FIELDS.values(), *fields.LEG_FIELDS.values())) | {
    "length_limits": fields.limits,
    "force_limit": tables.positive,
    "speed_limit": tables.positive,
}
"""Check of each value of a robot file by path."""


def values(d: object, file: str) -> dict[str, Any]:
    """Fields of a robot by name, checked; ``file`` begins every message."""
    for key in _LATER_KEYS:
        if isinstance(d, Mapping) and key in d:
            raise ValueError(f"{file}{key}: expected schema = 2 beside it, got schema = 1")
    top = tables.checked_table(d, file, _TOP_KEYS, ("schema", "name", "platform", "leg"))
    joint = fields.base_joint(top.get("base_joint", "universal"), f"{file}base_joint")
    own = _values({"gravity": top.get("gravity", fields.DEFAULT_GRAVITY), "platform": top["platform"]}, file)
    tables.require(own, [path for path, _ in fields.FIELDS.values()], file, "missing")
    defaults = tables.checked_table(top.get("leg_defaults", {}), f"{file}leg_defaults.", _SHARED_KEYS)
    shared = fields.UNSTATED | _values(defaults, f"{file}leg_defaults.")
    given = top["leg"]
    if not isinstance(given, list | tuple):
        raise ValueError(f"{file}leg: expected six [[leg]] tables, got {shown(given)}")
    if len(given) != fields.LEGS:
        raise ValueError(f"{file}leg: expected exactly six [[leg]] tables, got {len(given)}")
    legs = [_leg(table, shared, joint, f"{file}leg {i}: ") for i, table in enumerate(given, 1)]
    found = {name: np.array([leg[path] for leg in legs]) for name, (path, _) in fields.LEG_FIELDS.items()}
    if joint == "spherical":
        fields.need_axisymmetric(found, lambda i, name: f"{file}leg {i + 1}: {fields.LEG_FIELDS[name][0]}")
    return {
        **{name: own[path] for name, (path, _) in fields.FIELDS.items()},
        **found,
        "name": tables.title(top["name"], f"{file}name"),
        "base_joint": joint,
        "suppressed_warnings": fields.accepted(top.get("accept", ()), f"{file}accept"),
    }


def tables_of(given: Mapping[str, Any]) -> dict[str, Any]:
    """The tables of a robot file, plain values alone, from fields of a robot; ``values`` undoes it."""
    own = nested({path: given[name] for name, (path, _) in fields.FIELDS.items()})
    return {
        "schema": SCHEMA,
        "name": given["name"],
        "base_joint": given["base_joint"],
        "gravity": own["gravity"],
        **({"accept": list(given["suppressed_warnings"])} if given["suppressed_warnings"] else {}),
        "platform": own["platform"],
        "leg": [leg_table(given, i) for i in range(fields.LEGS)],
    }


def leg_table(given: Mapping[str, Any], i: int) -> dict[str, Any]:
    """The table of one leg, counted from 0."""
    found = {path: given[name][i] for name, (path, _) in fields.LEG_FIELDS.items()}
    if given["base_joint"] == "spherical":
        del found["universal_axis"]
    stated = (
        path for path, value in found.items() if not np.array_equal(value, fields.UNSTATED.get(path, np.nan))
    )
    return nested({path: found[path] for path in stated})


def nested(found: Mapping[str, Any]) -> dict[str, Any]:
    """Tables of plain values by their paths."""
    top: dict[str, Any] = {}
    for path, value in found.items():
        table, _, key = path.rpartition(".")
        (top.setdefault(table, {}) if table else top)[key] = np.asarray(value).tolist()
    return top


def _leg(value: object, shared: Mapping[str, Any], joint: str, prefix: str) -> dict[str, Any]:
    """Values of one leg by path, filled up from the defaults."""
    table = tables.checked_table(value, prefix, _LEG_KEYS, ("base_point", "platform_point"))
    if joint == "universal":
        tables.require(table, ("universal_axis",), prefix, "missing")
    elif "universal_axis" in table:
        raise ValueError(f'{prefix}universal_axis: expected none when base_joint is "spherical"')
    leg = {"universal_axis": np.zeros(3), **shared, **_values(table, prefix)}
    reason = "missing, here and in leg_defaults"
    tables.require(leg, [path for path, _ in fields.LEG_FIELDS.values()], prefix, reason)
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
