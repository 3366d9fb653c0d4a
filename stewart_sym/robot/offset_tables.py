"""Offset joints in a robot file of schema 2: tables ``offsets`` and ``cross`` of all legs or of one."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from ..io import tables
from ..io.array_types import Array
from .fields import LEGS, direction
from .offsets import PLATFORM_JOINTS, Offsets

LENGTHS = ("cross", "along", "across", "wrist")
OFFSET_KEYS = (*LENGTHS, "platform_joint", "platform_axis")
CROSS_KEYS = ("mass", "center_of_mass", "inertia")
TABLES = {"offsets": OFFSET_KEYS, "cross": CROSS_KEYS}
"""Keys of both tables."""


def offsets_of_tables(
    shared: Mapping[str, Any],
    own: Sequence[Mapping[str, Any]],
    file: str,
    metres: Callable[[Any], Any],
) -> Offsets | None:
    """The offsets of a robot file; None where no leg states any.

    shared: the table ``legs``. own: those of each leg. file: begins every message. metres: from lengths of
    the file. A key of a leg stands in for that of all.
    """
    if not any(name in table for name in TABLES for table in (shared, *own)):
        return None
    prefixes = [f"{file}legs.", *(f"{file}leg.{i + 1}." for i in range(LEGS))]
    every = [
        {
            name: tables.checked_table(table.get(name, {}), f"{prefix}{name}.", keys)
            for name, keys in TABLES.items()
        }
        for table, prefix in zip((shared, *own), prefixes, strict=True)
    ]

    def of_leg(i: int, table: str, key: str, check: Callable[[object, str], Any], default: Any) -> Any:
        for j in (i + 1, 0):
            if key in every[j][table]:
                return check(every[j][table][key], f"{prefixes[j]}{table}.{key}")
        return default

    def numbers(table: str, key: str, check: Callable[[object, str], Any], default: Any) -> Array:
        return np.array([of_leg(i, table, key, check, default) for i in range(LEGS)])

    joint = _platform_joint(every, prefixes)
    found = {name: metres(numbers("offsets", name, tables.number, 0.0)) for name in LENGTHS}
    none = np.zeros(3)
    if joint == "universal":
        for i in range(LEGS):
            if not any("platform_axis" in every[j]["offsets"] for j in (i + 1, 0)):
                where = f"{prefixes[0]}offsets.platform_axis"
                raise ValueError(
                    f'{where}: missing, and leg.{i + 1} has none, with platform_joint "universal"'
                )
        found["platform_axis"] = numbers("offsets", "platform_axis", direction, none)
    else:
        _need_none(every, prefixes, ("platform_axis", "wrist"))
    return Offsets(
        **found,
        platform_joint=joint,
        cross_mass=numbers("cross", "mass", tables.not_negative, 0.0),
        cross_center=metres(numbers("cross", "center_of_mass", tables.vector, none)),
        cross_inertia=numbers("cross", "inertia", tables.not_negative, 0.0),
    )


def _platform_joint(every: Sequence[Mapping[str, Any]], prefixes: Sequence[str]) -> str:
    """Kind of the platform joints, the same for all legs."""
    for leg, prefix in zip(every[1:], prefixes[1:], strict=True):
        if "platform_joint" in leg["offsets"]:
            raise ValueError(f"{prefix}offsets.platform_joint: expected it in legs.offsets, for all legs")
    given = every[0]["offsets"].get("platform_joint", "spherical")
    return tables.choice(given, PLATFORM_JOINTS, f"{prefixes[0]}offsets.platform_joint")


def _need_none(every: Sequence[Mapping[str, Any]], prefixes: Sequence[str], keys: Sequence[str]) -> None:
    for table, prefix in zip(every, prefixes, strict=True):
        for key in keys:
            if key in table["offsets"]:
                raise ValueError(
                    f'{prefix}offsets.{key}: expected none unless legs.offsets.platform_joint is "universal"'
                )


def offset_tables(offsets: Offsets) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    """What ``legs`` and each leg have, SI units; ``offsets_of_tables`` undoes it to the bit."""
    shared = {"offsets": {"platform_joint": offsets.platform_joint}}
    names = LENGTHS if offsets.spins else LENGTHS[:-1]
    legs = []
    for i in range(LEGS):
        own: dict[str, Any] = {name: float(getattr(offsets, name)[i]) for name in names}
        if offsets.spins:
            own["platform_axis"] = offsets.platform_axis[i].tolist()
        cross = {
            "mass": float(offsets.cross_mass[i]),
            "center_of_mass": offsets.cross_center[i].tolist(),
            "inertia": float(offsets.cross_inertia[i]),
        }
        legs.append({"offsets": own, "cross": cross})
    return shared, legs
