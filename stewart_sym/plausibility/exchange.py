"""Doubts about which points are whose: base and platform exchanged, base joints in one place."""

from collections.abc import Iterator

import numpy as np

from ..dynamics.home_pose import radius
from ..io.array_types import Array
from ..robot.robot import LEGS, Robot, legs_text
from .level_poses import Doubt

LEAST_LARGER = 1.1
"""Platform over base from which on an exchange of the two is looked for by their axes."""
ALONG, ACROSS = 0.02, 0.1
"""Sine or cosine of the angle between fixed axes and the way from the ring's middle: axes that were laid
along or across a ring, all six, and such that were not."""
SLENDER = (1.5, 0.4, 0.5, 1.5)
"""Platform over base, radius of gyration over the platform's radius at most, and over the base's from and to:
a body that fills the ring of the base and is lost in its own."""
SAME = 1e-3
"""Distance over the radius of the ring."""


def of_exchange(robot: Robot, sizes: str) -> Iterator[Doubt]:
    """Base and platform exchanged: a larger platform, and axes or a body that belong to the other ring."""
    ratio = radius(robot.p) / radius(robot.b)
    gyration = float(np.sqrt(np.linalg.eigvalsh(robot.I_p)[-1].clip(min=0.0) / robot.M))
    larger, thin, low, high = SLENDER
    signs = []
    if ratio > LEAST_LARGER and _laid(robot.k, robot.p) < ALONG and _laid(robot.k, robot.b) > ACROSS:
        signs.append("fixed axes along or across the ring of the platform points")
    if ratio > larger and gyration < thin * radius(robot.p) and low < gyration / radius(robot.b) < high:
        signs.append(f"a platform of radius of gyration {gyration:.3g} m, which fits the base points")
    if signs:
        yield Doubt(
            "proportion",
            f"{sizes}, {' and '.join(signs)}; likely cause: base_point and platform_point exchanged "
            "(the base is fixed)",
        )


def _laid(k: Array, points: Array) -> float:
    """How far from lying along, or across, the way from the middle of the points to each one the axes are."""
    if not k.any():
        return 1.0
    out = points - points.mean(axis=0)
    out = out / np.linalg.norm(out, axis=-1, keepdims=True)
    across = float(np.abs(np.sum(k * out, axis=-1)).max())
    along = float(np.linalg.norm(np.cross(k, out), axis=-1).max())
    return min(across, along)


def of_coincidence(robot: Robot) -> Iterator[Doubt]:
    """Base joints in one place; three pairs of them are meant, as an idealisation."""
    near = np.linalg.norm(robot.b[:, None] - robot.b, axis=-1) < SAME * radius(robot.b)
    legs = np.flatnonzero(near.sum(axis=0) > 1).tolist()
    if legs and not (len(legs) == LEGS and (near.sum(axis=0) == 2).all()):
        yield Doubt(
            "coincident",
            f"base_point of {legs_text(legs)} in one place; likely cause: a point copied and not changed",
        )
