"""Bodies given by their inertia or as plain shapes: mass, center of mass, and inertia about it."""

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from ..io import toml_reader
from ..io.arguments import option, shown
from ..io.array_types import Array
from .fields import direction, inertia

INERTIA_KEYS = ("mass", "center_of_mass", "inertia")
SHAPES = {
    "rod": ("radius", "length"),
    "tube": ("radius", "inner_radius", "length"),
    "plate": ("radius", "thickness"),
    "box": ("size",),
}
"""Dimensions of each shape; a plate is round and may have a hole of ``inner_radius``."""
_MATTER = ("mass", "density")
_PLACES = {"leg": ("start",), "platform": ("center", "axis")}

LEAST_DENSITY = {"platform": 25.0, "legs": 100.0}
"""Smallest plausible densities (kg/m^3).

The density of every solid in g/cm^3 is a smaller number. Platforms may have a core of foam or honeycomb.
"""

_ROUNDING = 1e-9
"""Fraction of the largest second moment of mass below which a second moment counts as zero."""

Meters = Callable[[Any], Any]
"""Function that converts a length or an array of lengths from the unit of the file to m."""


class Body(NamedTuple):
    """Mass (kg), center of mass (m), and inertia about it (kg m^2), (3, 3), in axes of the body frame."""

    mass: float
    center_of_mass: Array
    inertia: Array


def body(value: object, where: str, meters: Meters, along: float | None) -> dict[str, Any]:
    """Return the given mass, center of mass, and inertia of a body: values, a shape, or a list of parts.

    A part of a leg also has a length (m) from its joint to its other end, from the key or from the ends of
    its shapes. ``meters`` converts lengths of the file. ``along`` is 1 or -1 for a part of a leg, which
    extends along x from the joint on that side, and None for the platform, whose shapes have positions.
    """
    if isinstance(value, list | tuple):
        if not value:
            raise ValueError(f"{where}: expected a body or a list of parts, got []")
        parts = [_one(part, f"{where} {i}: ", meters, along, True) for i, part in enumerate(value, 1)]
        length = max(part.pop("length", 0.0) for part in parts)
        return joined([Body(**part) for part in parts])._asdict() | ({"length": length} if along else {})
    return _one(value, f"{where}.", meters, along, False)


def low_densities(tables: Mapping[str, Any]) -> dict[str, float]:
    """Return implausibly low densities (kg/m^3) by their keys in the checked tables of a robot file."""
    found = {where + "density": table["density"] for where, table, _ in _inner(tables) if "density" in table}
    least = {where: LEAST_DENSITY["platform" if where.startswith("platform") else "legs"] for where in found}
    return {where: value for where, value in found.items() if value < least[where]}


def inertias_of_parts(tables: Mapping[str, Any]) -> dict[str, Array]:
    """Return the inertia (kg m^2), (3, 3), of each part of the bodies that are lists, by its key."""
    parts = ((where + "inertia", part) for where, part, number in _inner(tables) if number > 1)
    return {where: _tensor(part["inertia"], where) for where, part in parts if "inertia" in part}


def _inner(table: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Mapping[str, Any], int]]:
    """Yield prefix, content, and number of members of the inner tables and of tables in lists."""
    for key, value in table.items():
        members = value if isinstance(value, list | tuple) else [value]
        for i, part in enumerate(members, 1):
            where = f"{prefix}{key}." if part is value else f"{prefix}{key} {i}: "
            if isinstance(part, Mapping):
                yield where, part, len(members)
                yield from _inner(part, where)


def joined(parts: list[Body]) -> Body:
    """Combine several parts into one body."""
    mass = float(np.sum([part.mass for part in parts]))
    center = sum(part.mass * part.center_of_mass for part in parts) / mass
    total = np.zeros((3, 3))
    for part in parts:
        r = part.center_of_mass - center
        total += part.inertia + part.mass * (r @ r * np.eye(3) - np.outer(r, r))
    return Body(mass, np.asarray(center), total)


def tensors_of_bodies(inertia: Array, least: float = 1e-2) -> Array:
    """Return tensors of possible bodies near the given tensors, (..., 3, 3); possible tensors do not change.

    The second moments of mass of a body, tr(I)/2 - I for a tensor I, are not negative. If one is negative,
    all moments below ``least`` times the largest are raised to this value.
    """
    unit = np.eye(3)
    moments, axes = np.linalg.eigh(_trace(inertia) / 2 * unit - inertia)
    raised = np.maximum(moments, least * moments[..., -1:])
    second = np.einsum("...ij,...j,...kj->...ik", axes, raised, axes)
    impossible = moments[..., :1, None] <= _ROUNDING * moments[..., -1:, None]
    return np.where(impossible, _trace(second) * unit - second, inertia)


def _one(value: object, prefix: str, meters: Meters, along: float | None, whole: bool) -> dict[str, Any]:
    """Return one body given by itself; ``whole`` requires all keys."""
    place = _PLACES["platform" if along is None else "leg"]
    of_shapes = (*dict.fromkeys(key for sizes in SHAPES.values() for key in sizes), "density", *place)
    table = toml_reader.checked_table(value, prefix, (*INERTIA_KEYS, "shape", *of_shapes))
    own = () if along is None else ("length",)
    if "shape" in table or any(key in table for key in of_shapes if key not in own):
        return _by_shape(table, prefix, meters, along, place)
    return _by_inertia(table, prefix, meters, whole)


def _by_shape(
    table: dict[str, Any], prefix: str, meters: Meters, along: float | None, place: tuple[str, ...]
) -> dict[str, Any]:
    toml_reader.require(table, ("shape",), prefix, "missing")
    shape = option(table["shape"], tuple(SHAPES), f"{prefix}shape")
    known = ("shape", *SHAPES[shape], *_MATTER, *place)
    known += ("inner_radius",) if shape == "plate" else ()
    known = tuple(key for key in known if (shape, key) != ("box", "axis"))
    toml_reader.checked_table(table, prefix, known, SHAPES[shape])
    if shape == "box":
        size = meters(toml_reader.vector(table["size"], f"{prefix}size"))
        if np.any(size <= 0.0):
            raise ValueError(f"{prefix}size: expected three numbers > 0, got {shown(table['size'])}")
        length, volume = float(size[0]), float(size[0] * size[1] * size[2])
        tensor = np.diag(size @ size - size**2) / 12.0
    else:
        # The default axis is x for parts of a leg and z for the platform.
        own = (0.0, 0.0, 1.0) if along is None else (1.0, 0.0, 0.0)
        axis = direction(table.get("axis", own), f"{prefix}axis")
        length, volume, tensor = _cylinder(table, prefix, meters, axis)
    mass = _mass(table, prefix, volume)
    if along is None:
        center = meters(toml_reader.vector(table.get("center", (0.0, 0.0, 0.0)), f"{prefix}center"))
        return Body(mass, np.asarray(center), mass * tensor)._asdict()
    start = float(meters(toml_reader.number(table.get("start", 0.0), f"{prefix}start")))
    center = np.array([along * (start + 0.5 * length), 0.0, 0.0])
    return Body(mass, center, mass * tensor)._asdict() | {"length": max(0.0, start + length)}


def _by_inertia(table: dict[str, Any], prefix: str, meters: Meters, whole: bool) -> dict[str, Any]:
    if whole:
        toml_reader.require(table, INERTIA_KEYS, prefix, "missing")
    found: dict[str, Any] = {}
    if "mass" in table:
        found["mass"] = toml_reader.positive(table["mass"], f"{prefix}mass")
    if "center_of_mass" in table:
        found["center_of_mass"] = meters(
            toml_reader.vector(table["center_of_mass"], f"{prefix}center_of_mass")
        )
    if "inertia" in table:
        found["inertia"] = _tensor(table["inertia"], f"{prefix}inertia")
    if "length" in table:
        found["length"] = float(meters(toml_reader.positive(table["length"], f"{prefix}length")))
    return found


def _tensor(given: Any, where: str) -> Array:
    """Return an inertia (kg m^2), (3, 3), from three moments or a matrix."""
    plain = isinstance(given, list | tuple) and not any(isinstance(row, list | tuple) for row in given)
    return np.diag(toml_reader.vector(given, where)) if plain else inertia(given, where)


def _cylinder(table: dict[str, Any], prefix: str, meters: Meters, axis: Array) -> tuple[float, float, Array]:
    """Return length (m), volume (m^3), and inertia over mass (m^2) of a cylinder with or without a bore."""
    key = "thickness" if "thickness" in table else "length"
    length, outer = (meters(toml_reader.positive(table[name], prefix + name)) for name in (key, "radius"))
    inner = meters(toml_reader.not_negative(table.get("inner_radius", 0.0), f"{prefix}inner_radius"))
    if inner >= outer:
        got = f"{table['inner_radius']:g} in {table['radius']:g}"
        raise ValueError(f"{prefix}inner_radius: expected a radius smaller than the outer radius, got {got}")
    squares = outer**2 + inner**2
    about, across = squares / 2.0, squares / 4.0 + length**2 / 12.0
    tensor = across * np.eye(3) + (about - across) * np.outer(axis, axis)
    return length, math.pi * (outer**2 - inner**2) * length, tensor


def _mass(table: dict[str, Any], prefix: str, volume: float) -> float:
    given = [key for key in _MATTER if key in table]
    if not given:
        raise ValueError(f"{prefix}mass: missing, expected mass or density")
    if len(given) > 1:
        raise ValueError(f"{prefix}density: expected mass or density, got both")
    amount = toml_reader.positive(table[given[0]], prefix + given[0])
    mass = float(amount if given[0] == "mass" else amount * volume)
    if not 0.0 < mass < math.inf:
        raise ValueError(f"{prefix}{given[0]}: expected a body with a mass, got {mass:g} kg")
    return mass


def _trace(matrix: Array) -> Array:
    """Return traces, (..., 1, 1)."""
    return np.asarray(np.trace(matrix, axis1=-2, axis2=-1))[..., None, None]
