"""Arrangement of the legs: legs that cross, legs in a wrong order, and machines singular at any height."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ..io.array_types import Array
from ..kinematics.clearance import PAIRS, meeting_legs
from ..kinematics.mounting_side import level_positions
from ..robot.robot import LEGS, Robot
from .finding import Finding, finding
from .level_poses import GOOD_CONDITION, HEIGHTS, MISPAIRED, level_conditions

TWISTED = np.radians(75.0)
"""Smallest twist of the platform against the base (rad) of legs in a wrong order, which have 120 degrees."""
EXCHANGED = -0.5
"""Least scalar product of the differences of base points and platform points of two legs in sound machines.

The differences are projected along the machine axis and divided by both radii.
"""
MEETING = 0.01
"""Largest distance of center lines that meet, over the mean leg length; legs of machines are thicker."""
MOST_CONDITION = 1e3


def of_order(robot: Robot, t: Array) -> Iterator[Finding]:
    """Yield a finding about the assignment of platform points to base points.

    Legs are sorted by the angle of their base points. The platform points are assigned in their own order,
    shifted or reversed, which gives twelve assignments.
    """
    axis = t + robot.p.mean(axis=0) - robot.b.mean(axis=0)
    axis /= np.linalg.norm(axis)
    around_b, around_p = (_around(points, axis) for points in (robot.b, robot.p))
    crossed = _crossed(around_b, around_p) or meeting_legs(robot, t, MEETING)
    order = np.argsort(np.angle(around_b), kind="stable")
    b, p, heights = robot.b[order], robot.p[order], level_positions(robot, axis, HEIGHTS)
    turned = np.sum(around_p * np.conj(around_b))
    clear = abs(turned) > 0.5 * np.sum(np.abs(around_p) * np.abs(around_b))
    given = float(level_conditions(b, p, heights).min())
    better = _better_order(b, p, heights, bool(clear and abs(np.angle(turned)) > TWISTED))
    if better is not None and given < MOST_CONDITION:
        yield better
    elif given > MOST_CONDITION:
        found = f"scaled condition number {given:.2g}" if np.isfinite(given) else "H is singular"
        cause = (
            "platform points of wrong legs or mirrored, points in one place, nearly parallel or concurrent "
            "legs, or similar hexagons (expected pairs of base points above gaps of the platform points)"
        )
        yield finding("condition", f"{found} with the platform parallel to the base, at any height", cause)
    elif crossed:
        cause = (
            "their platform points exchanged, platform points in another order than base points, or mirrored"
        )
        text = f"legs {crossed[0] + 1}, {crossed[1] + 1} cross at the home pose"
        yield finding("crossing", text, cause)


def _better_order(b: Array, p: Array, heights: Array, twisted: bool) -> Finding | None:
    """Return a finding if another of the twelve orders has much better level poses, else None."""
    ways = {(turn, k): np.roll(p[::turn], k, axis=0) for turn in (1, -1) for k in range(LEGS)}
    conditions = level_conditions(b, np.array(list(ways.values()))[:, None], heights).min(axis=-1)
    given, least = float(conditions[0]), int(np.argmin(conditions))
    turn, k = list(ways)[least]
    ratio = given / conditions[least]
    mispaired = given > GOOD_CONDITION and ratio > MISPAIRED and (turn, k) != (1, 0)
    if not mispaired and not (twisted and ratio > 2.0):
        return None
    shifted = f"shifted by {min(k, LEGS - k)} of six places"
    cause = shifted if turn > 0 else "in the opposite sense (mirrored) or exchanged"
    text = f"scaled condition number {given:.2g} with the platform parallel to the base, "
    text += f"{conditions[least]:.2g} with its points in another order"
    cause = f"platform points {cause} against the base points, or a platform frame turned about its normal"
    return finding("leg-order", text, cause)


def _crossed(b: NDArray[np.complex128], p: NDArray[np.complex128]) -> tuple[int, int] | None:
    """Return the legs that cross most, seen along the machine axis in the complex plane, or None."""
    first, second = np.array(PAIRS).T
    sizes = np.sqrt(np.mean(np.abs(b) ** 2) * np.mean(np.abs(p) ** 2))
    products = ((b[first] - b[second]) * np.conj(p[first] - p[second])).real / sizes
    return PAIRS[int(np.argmin(products))] if products.min() < EXCHANGED else None


def _around(points: Array, axis: Array) -> NDArray[np.complex128]:
    """Return points relative to their mean as complex numbers in the plane normal to an axis."""
    plane = np.linalg.svd(axis[None])[2][1:]
    plane = plane if np.linalg.det(np.vstack([axis, plane])) > 0.0 else plane[::-1]
    x, y = plane @ (points - points.mean(axis=0)).T
    return np.asarray(x + 1j * y)
