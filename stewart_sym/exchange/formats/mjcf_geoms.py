"""Geoms of MJCF as solid bodies."""

import math
from collections.abc import Mapping

import numpy as np

from ...io.arguments import shown
from ...io.array_types import Array
from ...robot.bodies import Body as Solid
from ...robot.fields import direction
from ..model import frame_along
from .xml_text import number, numbers

_SIZES = {"sphere": 1, "capsule": 2, "cylinder": 2, "box": 3, "ellipsoid": 3}
_MOST_SIZES = 3
_DENSITY = 1000.0


def solid(given: Mapping[str, str], R: Array, center: Array, where: str) -> Solid | None:
    """Compute the mass properties of a geom in the frame of R, (3, 3), and center, (3,); None without mass.

    Parameters
    ----------
    given : mapping
        Attributes, including defaults of the class.
    R, center : ndarray
        Orientation and position of the geom.
    where : str
        Location in messages.

    Raises
    ------
    ValueError
        If the mass of the type of geom is not supported.
    """
    mass = number(given["mass"], f"{where}: mass") if "mass" in given else None
    density = number(given.get("density"), f"{where}: density", _DENSITY)
    for key, value in (("mass", mass), ("density", density)):
        if value is not None and value < 0.0:
            raise ValueError(f"{where}: {key}: expected a number >= 0, got {value:g}")
    if mass == 0.0 or (mass is None and density == 0.0):
        return None
    kind = given.get("type", "sphere")
    if kind == "plane":
        return None
    if kind not in _SIZES or "mesh" in given:
        got = kind if kind not in _SIZES else "mesh"
        raise ValueError(
            f"{where}: expected an inertial of its body, got a {got}, whose mass is not computed; let MuJoCo "
            'write it: mj_saveLastXML with saveinertial="true" of the compiler'
        )
    size = _sizes(given, 1 if "fromto" in given else _SIZES[kind], where)
    if "fromto" in given:
        ends = numbers(given["fromto"], 6, f"{where}: fromto")
        if kind == "sphere":
            raise ValueError(f"{where}: fromto: expected a type with two ends, got a sphere")
        along = ends[3:] - ends[:3]
        R, center = frame_along(direction(along, f"{where}: fromto")), 0.5 * (ends[:3] + ends[3:])
        # Only the first size is used perpendicular to the line.
        size = np.append(np.repeat(size, _SIZES[kind] - 1), 0.5 * float(np.linalg.norm(along)))
    volume, squares = _volume(kind, size)
    mass = density * volume if mass is None else mass
    inertia = R @ np.diag(squares.sum() - squares) @ R.T
    return Solid(mass, center, mass * inertia)


def _sizes(given: Mapping[str, str], count: int, where: str) -> Array:
    """Return the first sizes, shape (count,), of at most three."""
    text = given.get("size")
    words = (text or "").split()
    few = text if len(words) > _MOST_SIZES else " ".join(words[:count])
    found = numbers(few if words else text, count, f"{where}: size")
    if not np.all(found > 0.0):
        raise ValueError(f"{where}: size: expected sizes > 0, got {shown(text)}")
    return found


def _volume(kind: str, size: Array) -> tuple[float, Array]:
    """Return the volume (m^3), and the mean squares of the coordinates (m^2), shape (3,)."""
    if kind == "box":
        return 8.0 * float(np.prod(size)), size**2 / 3.0
    if kind in ("sphere", "ellipsoid"):
        axes = np.resize(size, 3)
        return 4.0 / 3.0 * math.pi * float(np.prod(axes)), axes**2 / 5.0
    r, half = (float(value) for value in size)
    cylinder = 2.0 * math.pi * r**2 * half
    squares = cylinder * np.array([r**2 / 4.0, r**2 / 4.0, half**2 / 3.0])
    if kind == "cylinder":
        return cylinder, squares / cylinder
    # The centers of mass of the two half spheres are 3/8 of the radius outside the ends.
    ball = 4.0 / 3.0 * math.pi * r**3
    squares += ball * np.array([r**2 / 5.0, r**2 / 5.0, r**2 / 5.0 + half**2 + 0.75 * r * half])
    return cylinder + ball, squares / (cylinder + ball)
