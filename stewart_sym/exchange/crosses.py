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
    arms : ndarray, shape (2, 3)
        Center of mass relative to the intersection of the axes (m): of the body, and of its assigned mass.
    turns : ndarray, shape (2, 3, 6), or None
        Angular velocities of the body and of the part per velocity of the platform point and angular velocity
        of the platform. None if the joints at the base leave them open.
    in_motion : bool
        True if forces in motion are exact, as forces at rest are.
    """

    body: Body
    part: str
    solid: bodies.Body
    lost: float
    lateral: float
    twist: float
    arms: Array
    turns: Array | None
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
    base, tip = (np.array([axis for step in steps for axis in step.axes]) for steps in (leg.base, leg.tip))
    turns = _turns(S, base, tip) if len(base) == 2 else None
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
                cross_turns = None
                if turns is not None:
                    body_turns = turns[0][0] if at_base else turns[1][len(sides[0]) - 1]
                    part_turns = turns[1][-1] if not at_base and len(sides[0]) > 1 else turns[0][1]
                    cross_turns = np.stack([body_turns, part_turns])
                yield _cross(body, point, sides, S, k, at_base, cross_turns)


def _turns(S: Array, base: Array, tip: Array) -> tuple[Array, Array] | None:
    """Return the angular velocities after each axis at both ends, shape (2, 3, 6) and (m, 3, 6), else None.

    They are linear in the velocity of the platform point and the angular velocity of the platform. ``base``
    (2, 3) and ``tip`` (m, 3) are the axes: two at the tip if the leg spins, none of a ball.
    """
    L = float(np.linalg.norm(S))
    s = S / L
    ahead = np.stack([L * cross(base[0], s), L * cross(base[1], s), s], axis=-1)
    behind = np.stack({0: [*np.eye(3)], 2: [s, *tip]}.get(len(tip), [*tip]), axis=-1)
    if behind.shape != (3, 3) or min(abs(np.linalg.det(ahead / L)), abs(np.linalg.det(behind))) < _SAME:
        return None
    rates = np.hstack([np.linalg.inv(ahead), np.zeros((3, 3))])
    first = base[0][:, None] * rates[0]
    leg = first + base[1][:, None] * rates[1]
    relative = np.linalg.inv(behind) @ (np.hstack([np.zeros((3, 3)), np.eye(3)]) - leg)
    steps = np.cumsum(behind.T[:, :, None] * relative[:, None, :], axis=0) + leg
    return np.stack([first, leg]), steps[3 - len(tip) :]


def _cross(
    body: Body,
    point: Array,
    sides: tuple[Array, Array],
    S: Array,
    k: Array | None,
    base: bool,
    turns: Array | None,
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
    return Cross(body, part, solid, lost, lateral, twist, np.stack([arm, kept]), turns, in_motion)


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


def largest_error(crosses: Sequence[Sequence[Cross]], p: Array, s: Array, g: Array) -> float:
    """Compute the largest error of the leg forces at rest (N) from the lost moments, in the pose of the file.

    The error is exact if the joints determine the angular velocity of a body, else a bound.

    Parameters
    ----------
    crosses : sequence of sequence of Cross
        Bodies between axes of each leg.
    p : ndarray, shape (6, 3)
        Platform points relative to the platform origin, in the pose of the file.
    s : ndarray, shape (6, 3)
        Directions of the legs in the pose of the file.
    g : ndarray, shape (3,)
        Gravity (m/s^2).
    """
    inverse = np.linalg.pinv(np.concatenate([s, cross(p, s)], axis=-1).T)
    exact, bound = np.zeros((2, len(p)))
    for i, of_leg in enumerate(crosses):
        arm = inverse[:, :3] + cross(inverse[:, 3:], p[i])
        for each in of_leg:
            if not each.lost:
                continue
            if each.turns is not None:
                moments = cross(each.arms, each.body.mass * g)
                load = moments[0] @ each.turns[0] - moments[1] @ each.turns[1]
                exact += inverse @ np.concatenate([load[:3], cross(p[i], load[:3]) + load[3:]])
                continue
            moment = each.body.mass * float(np.linalg.norm(g)) * each.lost
            bound += moment * each.lateral * np.linalg.norm(arm, axis=-1)
            bound += moment * each.twist * np.linalg.norm(inverse[:, 3:], axis=-1)
    return float((np.abs(exact) + bound).max())


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
