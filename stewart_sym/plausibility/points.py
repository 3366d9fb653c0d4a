"""Plausibility of points: exchanged base and platform, coincident joints, the home pose, and the tool."""

from collections.abc import Iterator

import numpy as np

from ..dynamics.home_pose import level_lengths, radius
from ..io.array_types import Array
from ..robot.robot import LEGS, Robot, legs_text
from .level_poses import Finding

LEAST_LARGER = 1.1
"""Ratio of platform to base from which their exchange is checked by the axes."""
ALONG, ACROSS = 0.02, 0.1
"""Thresholds of the sine or cosine between the fixed axes and the radial directions of the points.

Below the first, all six axes are radial or tangential to a ring; above the second, they are not.
"""
SLENDER = (1.5, 0.4, 0.5, 1.5)
"""Thresholds of a body that fits the ring of the base and is much smaller than its own ring.

They are the ratio of platform to base, the largest radius of gyration over the platform radius, and the
smallest and largest radius of gyration over the base radius.
"""
SAME = 1e-3
"""Distance, relative to the radius of the ring, below which joints coincide."""


def of_exchange(robot: Robot, sizes: str) -> Iterator[Finding]:
    """Yield a finding if sizes, axes, or inertia indicate that base and platform are exchanged."""
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
    """Return the deviation of the axes from radial or tangential directions of the points, 0 to 1."""
    if not k.any():
        return 1.0
    out = points - points.mean(axis=0)
    out = out / np.linalg.norm(out, axis=-1, keepdims=True)
    across = float(np.abs(np.sum(k * out, axis=-1)).max())
    along = float(np.linalg.norm(np.cross(k, out), axis=-1).max())
    return min(across, along)


def of_coincidence(robot: Robot) -> Iterator[Finding]:
    """Yield a finding about coincident base joints, except for three intentional pairs."""
    near = np.linalg.norm(robot.b[:, None] - robot.b, axis=-1) < SAME * radius(robot.b)
    legs = np.flatnonzero(near.sum(axis=0) > 1).tolist()
    if legs and not (len(legs) == LEGS and (near.sum(axis=0) == 2).all()):
        yield Finding(
            "coincident",
            f"base_point of {legs_text(legs)} in one place; likely cause: a point copied and not changed",
        )


# A home pose that the robot file states: far away, flat legs, or legs beyond their limits

MOST_LEGS = 5.0
"""Largest plausible shortest leg over machine size; machines have 0.2 to 2, limits in inches at least 8."""
FLAT = 0.1
"""Threshold of the RMS component of the leg directions normal to their closest plane."""
_PARALLEL = 0.3
"""Largest ratio of the smallest to the second component for flat legs; both are small for parallel legs."""


def of_place(robot: Robot) -> Iterator[Finding]:
    """Yield a finding about a home pose that is too far away, or whose legs are in one plane."""
    if robot.home_position is None:
        return
    S = robot.p + robot.home_position - robot.b
    L = np.linalg.norm(S, axis=-1)
    size = radius(robot.b) + radius(robot.p)
    another = "home of another point than the platform frame's origin"
    if L.min() > MOST_LEGS * size:
        yield Finding(
            "home",
            f"home_position: legs {L.min():.4g} to {L.max():.4g} m long on a machine of {size:.3g} m; likely "
            f"cause: another unit than the file's points, or {another}",
        )
        return
    shares = (
        np.linalg.svd(S / L[:, None], compute_uv=False) / np.sqrt(len(L)) if L.min() > 0.0 else np.zeros(3)
    )
    if shares[2] < FLAT and shares[2] <= _PARALLEL * shares[1]:
        yield Finding(
            "home",
            f"home_position: all legs are within {np.degrees(np.arcsin(shares[2])):.2g} degrees (RMS) of one "
            "plane, normal to which they support almost no load; likely cause: home at base height, or "
            f"{another}",
        )


UNITS_OF_LIMITS = (("m", 1e3), ("m", 1e2), ("cm", 10.0), ("mm", 1e-3), ("cm", 1e-2), ("in", 0.0254))
"""Units in which limits may be given by mistake, and the factors that correct them."""


def of_limits(robot: Robot) -> Iterator[Finding]:
    """Yield a finding about a home pose beyond the length limits."""
    if robot.home_position is None:
        return
    L, (low, high) = level_lengths(robot, robot.home_position), robot.length_limits.T
    legs = np.flatnonzero((low > L) | (high < L)).tolist()
    if legs:
        i = max(legs, key=lambda leg: float(max(low[leg] - L[leg], L[leg] - high[leg]) / L[leg]))
        cause = (
            "home of another point than the platform frame's origin, a stroke without 0 in it, or limits "
            "between other points than the joints"
        )
        for unit, factor in UNITS_OF_LIMITS:
            if np.all((factor * low <= L) & (factor * high >= L)):
                cause = f"limits given in {unit} in a file of another length_unit"
                break
        yield Finding(
            "home",
            f"{legs_text(legs)} beyond length_limits at the home pose: {L[i]:.4g} m, limits {low[i]:.4g} to "
            f"{high[i]:.4g} m; likely cause: {cause}",
        )


# The tool of trajectories

FAR = 10.0
"""Largest plausible distance of the tool from the platform over machine size.

Millimeters that are read as meters make it 50 or more.
"""
NEAR = (1e-6, 1e-3)
"""Bounds of the distance of the tool from the origin, over machine size, that indicate a wrong unit.

Such values are meters in a file of millimeters. Values below the bounds are zero except for rounding.
"""


def of_tool(robot: Robot) -> Iterator[Finding]:
    """Yield a finding about a tool far from the machine, or almost but not exactly at the platform origin."""
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
