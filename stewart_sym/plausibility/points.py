"""Doubts about points: base and platform exchanged, base joints in one place, the home pose, the tool."""

from collections.abc import Iterator

import numpy as np

from ..dynamics.home_pose import level_lengths, radius
from ..io.array_types import Array
from ..robot.robot import LEGS, Robot, legs_text
from .level_poses import Finding

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


def of_exchange(robot: Robot, sizes: str) -> Iterator[Finding]:
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
        yield Finding(
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


def of_coincidence(robot: Robot) -> Iterator[Finding]:
    """Base joints in one place; three pairs of them are meant, as an idealisation."""
    near = np.linalg.norm(robot.b[:, None] - robot.b, axis=-1) < SAME * radius(robot.b)
    legs = np.flatnonzero(near.sum(axis=0) > 1).tolist()
    if legs and not (len(legs) == LEGS and (near.sum(axis=0) == 2).all()):
        yield Finding(
            "coincident",
            f"base_point of {legs_text(legs)} in one place; likely cause: a point copied and not changed",
        )


# A home pose that the robot file states: far away, flat legs, or legs beyond their limits

MOST_LEGS = 5.0
"""Shortest leg over the machine's size: machines have 0.2 to 2, limits in inches make it 8 and more."""
FLAT = 0.1
"""RMS share of the legs' directions across the plane that they come closest to."""
_PARALLEL = 0.3
"""The same of the second direction, over which legs that stand side by side have as little of it."""


def of_place(robot: Robot) -> Iterator[Finding]:
    """A home pose at which no machine of this size is, or at which its legs lie in one plane."""
    if robot.home_position is None:
        return
    S = robot.p + robot.home_position - robot.b
    L = np.linalg.norm(S, axis=-1)
    size = radius(robot.b) + radius(robot.p)
    another = "home of another point than the platform frame's origin"
    if L.min() > MOST_LEGS * size:
        yield Finding(
            "home",
            f"home: legs {L.min():.4g} to {L.max():.4g} m long on a machine of {size:.3g} m; likely cause: "
            f"another unit than that of the file's points, or {another}",
        )
        return
    shares = (
        np.linalg.svd(S / L[:, None], compute_uv=False) / np.sqrt(len(L)) if L.min() > 0.0 else np.zeros(3)
    )
    if shares[2] < FLAT and shares[2] <= _PARALLEL * shares[1]:
        yield Finding(
            "home",
            f"home: all legs lie within {np.degrees(np.arcsin(shares[2])):.2g} degrees (RMS) of one plane, "
            "across which they hold next to nothing; likely cause: home at the height of the base, or "
            f"{another}",
        )


def of_limits(robot: Robot) -> Iterator[Finding]:
    """A home pose beyond the length limits."""
    if robot.home_position is None:
        return
    L, (low, high) = level_lengths(robot, robot.home_position), robot.length_limits.T
    legs = np.flatnonzero((low > L) | (high < L)).tolist()
    if legs:
        i = max(legs, key=lambda leg: float(max(low[leg] - L[leg], L[leg] - high[leg]) / L[leg]))
        yield Finding(
            "home",
            f"{legs_text(legs)} beyond length_limits at the home pose: {L[i]:.4g} m, limits {low[i]:.4g} to "
            f"{high[i]:.4g} m; likely cause: home of another point than the platform frame's origin, a "
            "stroke without 0 in it, or limits between other points than the joints",
        )


# The tool of trajectories

FAR = 10.0
"""Distance from the platform over the machine's size: millimeters read as meters make it 50 and more."""
NEAR = (1e-6, 1e-3)
"""The same from the frame's origin: meters in a file of millimeters; below it, zero but for rounding."""


def of_tool(robot: Robot) -> Iterator[Finding]:
    """A tool far from the machine, or next to the origin of the platform frame but not there."""
    size = radius(robot.b) + radius(robot.p)
    away = float(np.linalg.norm(robot.tool))
    apart = min(away, float(np.linalg.norm(robot.tool - robot.p.mean(axis=0))))
    if apart > FAR * size:
        yield Finding(
            "tool",
            f"tool: {apart:.3g} m from the platform, on a machine of {size:.3g} m; likely cause: given in "
            "millimeters, or in micrometers in a file of millimeters",
        )
    elif NEAR[0] * size < away < NEAR[1] * size:
        yield Finding(
            "tool",
            f"tool: {away:.3g} m from the origin of the platform frame, on a machine of {size:.3g} m; likely "
            "cause: given in meters in a file of millimeters",
        )
