"""Joint points by radius and angles or one by one, and fixed axes of universal joints by name."""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from ..io import tables
from ..io.arguments import shown
from ..io.array_types import Array
from .bodies import Metres
from .fields import LEGS, direction, vector_text

RING_KEYS = ("radius", "angles", "z")
AXES = ("tangential", "radial", "horizontal")
"""Fixed axes by name: along the circle about z whose middle is the mean of the base points, to that middle,
and across z and the leg of the home pose."""

# Angles of more turns than this are in degrees.
_MOST_TURNS = 2.0


def points(table: Mapping[str, Any], prefix: str, metres: Metres, degrees: bool) -> Array | None:
    """Six points, m, (6, 3), by ``points`` or by ``radius``, ``angles`` and ``z``; None without any."""
    ring = [key for key in RING_KEYS if key in table]
    if "points" in table:
        if ring:
            raise ValueError(f"{prefix}{ring[0]}: expected points or radius and angles, got both")
        return _listed(table["points"], f"{prefix}points", metres)
    if not ring:
        return None
    tables.require(table, RING_KEYS[:2], prefix, "missing")
    radius = tables.per_leg(table["radius"], f"{prefix}radius")
    if np.any(radius <= 0.0):
        raise ValueError(f"{prefix}radius: expected a number > 0, got {shown(table['radius'])}")
    angles = tables.numbers(table["angles"], (LEGS,), f"{prefix}angles")
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
    z = tables.per_leg(table.get("z", 0.0), f"{prefix}z")
    radius = metres(radius)
    return np.stack([radius * c, radius * s, metres(z)], axis=-1)


def _listed(value: object, where: str, metres: Metres) -> Array:
    if not isinstance(value, list | tuple) or len(value) != LEGS:
        raise ValueError(f"{where}: expected six points, got {shown(value)}")
    return np.stack([metres(tables.vector(point, f"{where} {i}")) for i, point in enumerate(value, 1)])


def cosine_and_sine(angle: float, degrees: bool) -> tuple[float, float]:
    """Cosine and sine; of degrees with zeros at whole quarters of a turn, and alike on both sides of them."""
    if not degrees:
        return math.cos(angle), math.sin(angle)
    quarters = round(angle / 90.0)
    rest = math.radians(angle - 90.0 * quarters)
    c, s = math.cos(rest), math.sin(rest)
    return ((c, s), (-s, c), (-c, -s), (s, -c))[quarters % 4]


def axis(value: object, where: str, b: Array, middle: Array, home: Array | None) -> Array:
    """Unit vector of the fixed axis of a leg, (3,): a direction, or one of ``AXES``.

    b: its base point, m. middle: of all base points. home: the leg at the home pose, from joint to joint.
    """
    if not isinstance(value, str):
        return direction(value, where)
    name = tables.choice(value, AXES, where)
    along = b - middle
    if name == "horizontal":
        if home is None:
            raise ValueError(f'{where}: "{name}" is across the leg at the home pose, expected a key home')
        along = home
    x, y, _ = along
    if x == y == 0.0:
        raise ValueError(f'{where}: "{name}" is no direction at {vector_text(along)} m, expected a vector')
    return direction(np.array([x, y, 0.0] if name == "radial" else [-y, x, 0.0]), where)
