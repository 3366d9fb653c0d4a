"""Mass, centre of mass and inertia of MJCF's solid geoms, where a body states no inertia of its own."""

import math
from collections.abc import Mapping

import numpy as np

from ...io.array_types import Array
from ...robot.bodies import Body
from ..chain import frame_along
from .xml_text import number, numbers

_SIZES = {"sphere": 1, "capsule": 2, "cylinder": 2, "box": 3, "ellipsoid": 3}
_DENSITY = 1000.0


def solid(given: Mapping[str, str], R: Array, center: Array, where: str) -> Body | None:
    """The body of a geom, in the frame that R, (3, 3), and center, (3,), are in; None of one without a mass.

    given: attributes, those of its class among them. Raises ValueError for a heavy geom of another type.
    """
    mass = number(given["mass"], f"{where}: mass") if "mass" in given else None
    density = number(given.get("density"), f"{where}: density", _DENSITY)
    if mass == 0.0 or (mass is None and density == 0.0):
        return None
    kind = given.get("type", "sphere")
    if kind == "plane":
        return None
    if kind not in _SIZES:
        raise ValueError(
            f"{where}: expected an inertial of its body, got a {kind}, whose mass is not computed"
        )
    ends = numbers(given["fromto"], 6, f"{where}: fromto") if "fromto" in given else None
    size = numbers(given.get("size"), _SIZES[kind] - (ends is not None), f"{where}: size")
    if ends is not None:
        along = ends[3:] - ends[:3]
        R, center = frame_along(along), 0.5 * (ends[:3] + ends[3:])
        half = 0.5 * float(np.linalg.norm(along))
        size = np.array([size[0], half] if len(size) == 1 else [*size, half])
    volume, squares = _shape(kind, size)
    mass = density * volume if mass is None else mass
    inertia = R @ np.diag(squares.sum() - squares) @ R.T
    return Body(mass, center, mass * inertia)


def _shape(kind: str, size: Array) -> tuple[float, Array]:
    """Volume, m^3, and mean squares of the coordinates, m^2, (3,)."""
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
    # Two half spheres, their centres of mass 3/8 of the radius outside the ends.
    ball = 4.0 / 3.0 * math.pi * r**3
    squares += ball * np.array([r**2 / 5.0, r**2 / 5.0, r**2 / 5.0 + half**2 + 0.75 * r * half])
    return cylinder + ball, squares / (cylinder + ball)
