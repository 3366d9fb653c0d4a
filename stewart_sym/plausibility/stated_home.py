"""Doubts about a home pose that the robot file states: far away, flat legs, or legs beyond their limits."""

from collections.abc import Iterator

import numpy as np

from ..dynamics.home_pose import level_lengths, radius
from ..robot.robot import Robot, legs_text
from .level_poses import Doubt

MOST_LEGS = 5.0
"""Shortest leg over the machine's size: machines have 0.2 to 2, limits in inches make it 8 and more."""
FLAT = 0.1
"""RMS share of the legs' directions across the plane that they come closest to."""
_PARALLEL = 0.3
"""The same of the second direction, over which legs that stand side by side have as little of it."""


def of_place(robot: Robot) -> Iterator[Doubt]:
    """A home pose at which no machine of this size is, or at which its legs lie in one plane."""
    if robot.home is None:
        return
    S = robot.p + robot.home - robot.b
    L = np.linalg.norm(S, axis=-1)
    size = radius(robot.b) + radius(robot.p)
    another = "home of another point than the platform frame's origin"
    if L.min() > MOST_LEGS * size:
        yield Doubt(
            "home",
            f"home: legs {L.min():.4g} to {L.max():.4g} m long on a machine of {size:.3g} m; likely cause: "
            f"another unit than that of the file's points, or {another}",
        )
        return
    shares = (
        np.linalg.svd(S / L[:, None], compute_uv=False) / np.sqrt(len(L)) if L.min() > 0.0 else np.zeros(3)
    )
    if shares[2] < FLAT and shares[2] <= _PARALLEL * shares[1]:
        yield Doubt(
            "home",
            f"home: all legs lie within {np.degrees(np.arcsin(shares[2])):.2g} degrees (RMS) of one plane, "
            "across which they hold next to nothing; likely cause: home at the height of the base, or "
            f"{another}",
        )


def of_limits(robot: Robot) -> Iterator[Doubt]:
    """A home pose beyond the length limits."""
    if robot.home is None:
        return
    L, (low, high) = level_lengths(robot, robot.home), robot.length_limits.T
    legs = np.flatnonzero((low > L) | (high < L)).tolist()
    if legs:
        i = max(legs, key=lambda leg: float(max(low[leg] - L[leg], L[leg] - high[leg]) / L[leg]))
        yield Doubt(
            "home",
            f"{legs_text(legs)} beyond length_limits at the home pose: {L[i]:.4g} m, limits {low[i]:.4g} to "
            f"{high[i]:.4g} m; likely cause: home of another point than the platform frame's origin, a "
            "stroke without 0 in it, or limits between other points than the joints",
        )
