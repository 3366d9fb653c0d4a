"""Bodies between the axes of joints as mass of the parts that they join, and the effect on forces."""

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
    lateral : float
        Bound on the error of the lateral force at the end of the leg over the lost moment (1/m).
    twist : float
        Bound on the error of the moment on the platform over the lost moment.
    in_motion : bool
        True if forces in motion are exact, as forces at rest are.
    """

    body: Body
    part: str
    solid: bodies.Body
    lost: float
    lateral: float
    twist: float
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
    S = ends[1] - ends[0]
    for steps, names, point, at_base in (
        (leg.base, leg.crosses[0], ends[0], True),
        (leg.tip, leg.crosses[1], ends[1], False),
    ):
        axes = [step.axes for step in steps]
        for number, name in enumerate(names, 1):
            body = machine.bodies[name]
            if body.mass < 0.0:
                raise ValueError(f"body {name!r}: expected a mass >= 0, got {body.mass:g}")
            if body.mass or body.inertia.any():
                sides = np.concatenate(axes[:number]), np.concatenate(axes[number:])
                yield _cross(body, point, sides, S, k, at_base)


def _cross(
    body: Body, point: Array, sides: tuple[Array, Array], S: Array, k: Array | None, base: bool
) -> Cross:
    """Assign one body; ``sides`` contains the axes before and after it, shape (n, 3) and (m, 3)."""
    L = float(np.linalg.norm(S))
    s = S / L
    arm = body.placed(body.center) - point
    inertia = body.R @ body.inertia @ body.R.T
    # A leg between two spherical joints rotates freely, so that only mass on its axis remains in place.
    stays = [k is not None or float(np.linalg.norm(cross(axes[0], s))) < _SAME for axes in sides]
    part = LOWER if base else UPPER if len(sides[0]) == 1 else PLATFORM
    kept, rest = np.zeros(3), arm
    if base and len(sides[0]) == 1:
        rest = rest - (rest @ sides[0][0]) * sides[0][0]
    if base and len(sides[1]) == 1 and stays[1]:
        kept = (arm @ sides[1][0]) * sides[1][0]
    if part == UPPER and stays[0]:
        kept = (arm @ sides[0][0]) * sides[0][0]
    if part == PLATFORM:
        kept = (arm @ sides[1][0]) * sides[1][0]
    lost = float(np.linalg.norm(rest - kept))
    lost = lost if lost > _SAME * L else 0.0
    if np.linalg.norm(kept) <= _SAME * L:
        kept = np.zeros(3)
    lever = L if k is None else L * float(np.linalg.norm(cross(k, s)))
    if base and k is not None:
        # Such a body rotates about the fixed axis only.
        y = sides[1][0]
        inertia = (k @ inertia @ k) * (np.eye(3) - np.outer(y, y))
    elif k is None and part != PLATFORM:
        inertia = np.trace(inertia) / 3.0 * np.eye(3)
    three = np.concatenate(sides)
    volume = 1.0 if len(three) == 2 else abs(float(three[0] @ cross(three[1], three[2])))
    with np.errstate(divide="ignore"):
        twist = 0.0 if base else float(1.0 / np.float64(volume))
        lateral = float((1.0 if len(three) == 2 else np.sqrt(2.0) * (1.0 + 1.0 / np.float64(volume))) / lever)
    solid = bodies.Body(body.mass, point + kept, inertia)
    in_motion = lost == 0.0 and ((part == LOWER and k is not None) or not body.inertia.any())
    return Cross(body, part, solid, lost, lateral, twist, in_motion)


def with_crosses(body: Body, crosses: Sequence[Cross], part: str) -> Body:
    """Add the bodies between axes that are assigned to a part to its mass, center of mass, and inertia."""
    taken = [each.solid for each in crosses if each.part == part]
    if not taken:
        return body
    own = bodies.Body(body.mass, body.placed(body.center), body.R @ body.inertia @ body.R.T)
    whole = bodies.joined([own, *taken])
    inertia = body.R.T @ whole.inertia @ body.R
    return replace(
        body,
        mass=whole.mass,
        center=body.local(whole.center_of_mass),
        inertia=0.5 * (inertia + inertia.T),
    )


def largest_error(crosses: Sequence[Sequence[Cross]], p: Array, s: Array, g: float) -> float:
    """Compute a bound on the error of the leg forces at rest (N) from the lost moments.

    Parameters
    ----------
    crosses : sequence of sequence of Cross
        Bodies between axes of each leg.
    p : ndarray, shape (6, 3)
        Platform points relative to the platform origin, in the pose of the file.
    s : ndarray, shape (6, 3)
        Directions of the legs in the pose of the file.
    g : float
        Magnitude of gravity (m/s^2).
    """
    inverse = np.linalg.pinv(np.concatenate([s, cross(p, s)], axis=-1).T)
    total = np.zeros(len(p))
    for i, of_leg in enumerate(crosses):
        arm = inverse[:, :3] + cross(inverse[:, 3:], p[i])
        for each in of_leg:
            if each.lost:
                moment = each.body.mass * g * each.lost
                total += moment * each.lateral * np.linalg.norm(arm, axis=-1)
                total += moment * each.twist * np.linalg.norm(inverse[:, 3:], axis=-1)
    return float(total.max())


def lines_of(crosses: Sequence[Sequence[Cross]], error: float) -> Iterator[str]:
    """Write a line for each part about the bodies assigned to it, and one about the effect."""
    for part in (LOWER, UPPER, PLATFORM):
        taken = [each for of_leg in crosses for each in of_leg if each.part == part]
        if not taken:
            continue
        names = ", ".join(repr(each.body.name) for each in taken)
        count = f"{'count' if len(taken) > 1 else 'counts'} as the {part}"
        off = max(each.lost for each in taken)
        exact = f"the center of mass up to {1e3 * off:.3g} mm off is taken at their intersection"
        exact = exact if off else "which leaves forces at rest as they are"
        moving = "" if all(each.in_motion for each in taken) else "; in motion they turn as that does"
        yield f"between the axes of joints: {names} {count}, {exact}{moving}"
    if error:
        yield f"joint crosses: forces at rest in the pose of the file are off by up to {error:.3g} N"
