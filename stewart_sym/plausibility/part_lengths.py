"""Lengths of the legs' parts that do not go with the lengths of the legs."""

from collections.abc import Iterator

import numpy as np

from ..robot.robot import Robot, legs_text
from .level_poses import Doubt, Home

LEAST_REACH, MOST_LENGTH = 0.8, 1.0 + 1e-9
"""Of both parts over the longest leg: joints, which are left out of simple shapes, may take the rest; and of
one part over the shortest leg."""


def of_part_lengths(robot: Robot, home: Home) -> Iterator[Doubt]:
    """Parts that come apart in the longest leg, or of which one is longer than the shortest.

    Of the limits, and of the leg at home where there is none; with offsets, of the limits alone.
    """
    low, high = robot.length_limits.T
    at_home = np.full((2, len(home.L)), np.nan) if robot.offsets is not None else np.stack([home.L, home.L])
    shortest = np.where(low > 0.0, low, at_home[0])
    longest = np.where(np.isfinite(high), high, at_home[1])
    lower, upper = robot.lower_length, robot.upper_length
    stated = (lower > 0.0) & (upper > 0.0)
    short = np.flatnonzero(stated & (lower + upper < LEAST_REACH * longest)).tolist()
    if short:
        i = short[0]
        yield Doubt(
            "part-length",
            f"lower and upper parts of {legs_text(short)}: {lower[i]:.4g} m and {upper[i]:.4g} m long, which "
            f"do not reach through a leg of {longest[i]:.4g} m; likely cause: the length of a part left out, "
            "or not measured from its joint",
        )
    for part, length in (("lower", lower), ("upper", upper)):
        long = np.flatnonzero(length > MOST_LENGTH * shortest).tolist()
        if long:
            i = long[0]
            yield Doubt(
                "part-length",
                f"{part} part of {legs_text(long)}: {length[i]:.4g} m long, longer than a leg of "
                f"{shortest[i]:.4g} m; likely cause: the length in another unit, or of the whole leg",
            )
