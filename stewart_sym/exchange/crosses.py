"""Bodies between the axes of joints as mass of the parts that they join."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..io.array_types import Array
from ..motion.rotation import cross
from ..robot import bodies
from .model import Body
from .topology import Leg, Machine

LOWER, UPPER, PLATFORM = "lower part", "upper part", "platform"
_SAME = 1e-9


@dataclass(frozen=True, eq=False)
class Cross:
    """A body between two axes of a joint, as mass of a part of the machine.

    Attributes
    ----------
    body : Body
        Body of the file.
    part : str
        ``LOWER``, ``UPPER``, or ``PLATFORM``.
    solid : bodies.Body
        Mass, center of mass, and inertia that are added to the part, world frame.
    lost : float
        Distance (m) by which the center of mass is displaced, with an error of its moment.
    in_motion : bool
        True if forces in motion are exact, as forces at rest are.
    """

    body: Body
    part: str
    solid: bodies.Body
    lost: float
    in_motion: bool


def crosses_of(machine: Machine, leg: Leg, ends: Array, k: Array | None) -> Iterator[Cross]:
    """Assign the bodies between the axes at both ends of a leg to the parts.

    Parameters
    ----------
    machine : Machine
        Identified model.
    leg : Leg
        Leg of the model.
    ends : ndarray, shape (2, 3)
        Intersections of the axes at both ends.
    k : ndarray, shape (3,), or None
        Fixed axis of a universal joint at the base.
    """
    for steps, names, point in zip((leg.base, leg.tip), leg.crosses, ends, strict=True):
        axes = [step.axes for step in steps]
        for number, name in enumerate(names, 1):
            body = machine.bodies[name]
            if body.mass < 0.0:
                raise ValueError(f"body {name!r}: expected a mass >= 0, got {body.mass:g}")
            if body.mass or body.inertia.any():
                sides = np.concatenate(axes[:number]), np.concatenate(axes[number:])
                yield _cross(body, point, sides, ends[1] - ends[0], k, steps is leg.base)


def _cross(
    body: Body, point: Array, sides: tuple[Array, Array], S: Array, k: Array | None, base: bool
) -> Cross:
    """Assign one body; ``sides`` contains the axes before and after it, shape (n, 3) and (m, 3)."""
    L = float(np.linalg.norm(S))
    before, behind = sides
    arm = body.placed(body.center) - point
    inertia = body.R @ body.inertia @ body.R.T
    part = LOWER if base else UPPER if len(before) == 1 else PLATFORM
    # The body rotates with the part about this axis only; mass on the axis remains in place.
    axis = before[0] if part == UPPER else behind[0]
    kept, rest = np.zeros(3), arm
    if base and len(before) == 1:
        rest = rest - (rest @ before[0]) * before[0]
    if part == PLATFORM or (len(behind if base else before) == 1 and _stays(axis, S, k)):
        kept = (arm @ axis) * axis
    lost = float(np.linalg.norm(rest - kept))
    if np.linalg.norm(kept) <= _SAME * L:
        kept = np.zeros(3)
    if base and k is not None:
        # Such a body rotates about the fixed axis only.
        inertia = (k @ inertia @ k) * (np.eye(3) - np.outer(axis, axis))
    elif k is None and part != PLATFORM:
        inertia = np.trace(inertia) / 3.0 * np.eye(3)
    lost = lost if lost > _SAME * L else 0.0
    in_motion = lost == 0.0 and ((part == LOWER and k is not None) or not body.inertia.any())
    return Cross(body, part, bodies.Body(body.mass, point + kept, inertia), lost, in_motion)


def _stays(axis: Array, S: Array, k: Array | None) -> bool:
    """Return True if an axis remains in the part: a leg between spherical joints rotates about S."""
    return k is not None or float(np.linalg.norm(cross(axis, S))) < _SAME * float(np.linalg.norm(S))


def with_crosses(body: Body, crosses: Sequence[Cross], part: str) -> Body:
    """Add the bodies between axes that are assigned to a part to its mass, center of mass, and inertia."""
    taken = [each.solid for each in crosses if each.part == part]
    if not taken:
        return body
    own = bodies.Body(body.mass, body.placed(body.center), body.R @ body.inertia @ body.R.T)
    whole = bodies.joined([own, *taken])
    inertia = body.R.T @ whole.inertia @ body.R
    center = body.local(whole.center_of_mass)
    return replace(body, mass=whole.mass, center=center, inertia=0.5 * (inertia + inertia.T))


def lines_of(crosses: Sequence[Cross]) -> Iterator[str]:
    """Write a line for each part about the bodies assigned to it."""
    for part in (LOWER, UPPER, PLATFORM):
        taken = [each for each in crosses if each.part == part]
        if not taken:
            continue
        names = ", ".join(repr(each.body.name) for each in taken)
        count = f"{'count' if len(taken) > 1 else 'counts'} as the {part}"
        off = max(each.lost for each in taken)
        exact = f"the center of mass up to {1e3 * off:.3g} mm off is taken at their intersection"
        exact = exact if off else "which leaves forces at rest as they are"
        moving = "" if all(each.in_motion for each in taken) else "; in motion they turn as that does"
        yield f"between the axes of joints: {names} {count}, {exact}{moving}"
