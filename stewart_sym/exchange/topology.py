"""Identification of base, platform, and six legs in a model by the joints between the bodies."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..io.array_types import Array
from ..robot.fields import LEGS
from .model import WORLD, Body, Joint, Model

_EXPECTED = (
    "a universal or spherical joint, a prismatic joint and a spherical joint from the base to the platform"
)


@dataclass(frozen=True, eq=False)
class Step:
    """Joint on the way from the base to the platform; ``forward`` is True from its parent to its child."""

    joint: Joint
    forward: bool
    reached: str

    @property
    def axes(self) -> Array:
        """Axes of the joint, shape (n, 3), in the world frame, from base to platform."""
        return self.joint.axes if self.forward else -self.joint.axes[::-1]


@dataclass(frozen=True, eq=False)
class Leg:
    """Leg of a model: joints at the base, prismatic joint, joints at the platform, and names of its bodies.

    crosses: bodies between the joints at the base, and between the joints at the platform.
    """

    base: tuple[Step, ...]
    slide: Step
    tip: tuple[Step, ...]
    lower: str
    upper: str
    crosses: tuple[tuple[str, ...], tuple[str, ...]]


@dataclass(frozen=True, eq=False)
class Machine:
    """Rigid bodies of a model by name, its platform, and six legs.

    ``placed`` contains all bodies, and ``bodies`` the rigid bodies, each with the name and frame of its main
    member. ``members`` maps the name of each member to the name of its rigid body.
    """

    placed: Mapping[str, Body]
    bodies: Mapping[str, Body]
    members: Mapping[str, str]
    platform: str
    legs: tuple[Leg, ...]

    def place(self, step: Step) -> Array:
        """Return the point of a joint in the world frame, shape (3,), on the side of its child."""
        return self.placed[step.joint.child].placed(step.joint.point)

    def gap(self, cut: Joint) -> float:
        """Return the distance of the two points of a cut in the pose of the file (m)."""
        ends = self.placed[cut.parent].placed(cut.parent_point), self.placed[cut.child].placed(cut.point)
        return float(np.linalg.norm(ends[0] - ends[1]))


def machine_of(model: Model) -> Machine:
    """Identify base, platform, and legs; raise ValueError with one line for other mechanisms."""
    _need_unique(model)
    members = _members(model)
    around = _around(model, members)
    if not around.get(WORLD):
        hubs = [repr(name) for name, joints in around.items() if len(joints) >= LEGS]
        remedy = f"add a fixed joint from the world to {' or '.join(hubs) or 'the base'}"
        raise ValueError(f"world: expected a fixed joint to the base, got none; {remedy}")
    chains = [_chain(joint, members, around) for joint in around[WORLD]]
    platform = _platform(chains, around)
    reached = {WORLD, *(step.reached for chain in chains for step in chain)}
    loose = sorted(set(members.values()) - reached)
    if loose:
        raise ValueError(f"body {loose[0]!r}: expected a part of a leg, the platform or the base, got none")
    legs = tuple(_leg(chain, i) for i, chain in enumerate(chains, 1))
    placed = {body.name: body for body in model.bodies}
    return Machine(placed, _merged(model, members), members, platform, legs)


def _around(model: Model, members: Mapping[str, str]) -> dict[str, list[Joint]]:
    """Return the moving joints of each body."""
    found: dict[str, list[Joint]] = {}
    for joint in model.joints:
        ends = members[joint.parent], members[joint.child]
        if joint.kind == "free" and WORLD not in ends:
            got = f"one between {joint.parent!r} and {joint.child!r}"
            raise ValueError(f"joint {joint.name!r}: expected a free joint to the base alone, got {got}")
        if joint.kind in ("fixed", "free"):
            continue
        if ends[0] == ends[1]:
            raise ValueError(
                f"joint {joint.name!r}: expected one between two bodies, got {joint.parent!r} and "
                f"{joint.child!r}, which are fixed together otherwise"
            )
        for end in ends:
            found.setdefault(end, []).append(joint)
    return found


def _need_unique(model: Model) -> None:
    """Raise ValueError for repeated names of bodies, and for joints of missing bodies."""
    names = [body.name for body in model.bodies]
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise ValueError(f"body {twice[0]!r}: expected one body of that name, got {names.count(twice[0])}")
    for joint in model.joints:
        for end in (joint.parent, joint.child):
            if end not in names:
                raise ValueError(f"joint {joint.name!r}: body {end!r}: missing")


def _members(model: Model) -> dict[str, str]:
    """Return the main body of the bodies that each body is fixed to.

    It is the world, or else the body with the most joints, and among these the heaviest one. Forks and loads
    have fewer joints than the platform that holds them.
    """
    ends = [end for joint in model.joints if joint.kind != "free" for end in (joint.parent, joint.child)]
    rank = {body.name: (body.name == WORLD, ends.count(body.name), body.mass) for body in model.bodies}
    found = {name: name for name in rank}
    for joint in model.joints:
        if joint.kind == "fixed":
            pair = found[joint.parent], found[joint.child]
            main = max(pair, key=lambda name: rank[name])
            found = {name: main if own in pair else own for name, own in found.items()}
    return found


def _chain(first: Joint, members: Mapping[str, str], around: Mapping[str, Sequence[Joint]]) -> list[Step]:
    """Return the joints from the base to the first body that does not have two joints."""
    steps, at, joint = [], WORLD, first
    while True:
        forward = members[joint.parent] == at
        at = members[joint.child if forward else joint.parent]
        steps.append(Step(joint, forward, at))
        if len(around[at]) != 2 or at == WORLD:
            return steps
        joint = around[at][1] if around[at][0] is joint else around[at][0]


def _platform(chains: Sequence[Sequence[Step]], around: Mapping[str, Sequence[Joint]]) -> str:
    """Return the common end body of six chains; raise ValueError for other ends or another number."""
    ends = [chain[-1].reached for chain in chains]
    platform = max(ends, key=lambda end: (end != WORLD) * ends.count(end))
    others = [chain for chain, end in zip(chains, ends, strict=True) if end != platform]
    if others or platform == WORLD or len(chains) < 2:
        got = "; ".join(_way(chain, around) for chain in (others or chains)[:LEGS])
        loose = [repr(end) for end in ends if len(around[end]) == 1]
        if loose and len(chains) == LEGS:
            got += f"; add a joint or a loop closure from body {', '.join(loose)} to the platform"
        raise ValueError(f"expected six legs from the base to one platform, got {len(chains)}: {got}")
    if len(chains) != LEGS or len(around[platform]) != LEGS:
        names = ", ".join(repr(joint.name) for joint in around[platform])
        got = f"{len(chains)} with the joints {names} at the platform"
        raise ValueError(f"body {platform!r}: expected six legs from the base and nothing else, got {got}")
    return platform


def _way(chain: Sequence[Step], around: Mapping[str, Sequence[Joint]]) -> str:
    """Describe the end of a chain."""
    end, begin, last = chain[-1].reached, chain[0].joint.name, chain[-1].joint
    if end == WORLD:
        return f"joint {begin!r} to joint {last.name!r}, which leads back to the base"
    on = ", ".join(repr(joint.name) for joint in around[end] if joint is not last)
    return f"joint {begin!r} to body {end!r}, " + (
        f"which has further joints {on}" if on else "where it ends"
    )


def _leg(chain: Sequence[Step], number: int) -> Leg:
    """Identify the parts of one chain."""
    kinds = [step.joint.kind for step in chain]
    slides = [i for i, kind in enumerate(kinds) if kind == "prismatic"]
    if len(slides) == 1:
        slide = slides[0]
        base, tip = tuple(chain[:slide]), tuple(chain[slide + 1 :])
        if _turns(base) in (2, 3) and _turns(tip) == 3:
            between = tuple(step.reached for step in base[:-1]), tuple(step.reached for step in tip[:-1])
            return Leg(base, chain[slide], tip, base[-1].reached, chain[slide].reached, between)
    names = ", ".join(f"{step.joint.kind} {step.joint.name!r}" for step in chain)
    raise ValueError(f"leg {number}: expected {_EXPECTED}, got {names}")


def _turns(steps: Sequence[Step]) -> int:
    """Return the number of axes at one end of a leg: 2 for a universal joint, 3 for a spherical joint."""
    return sum(len(step.axes) or 3 for step in steps)


def _merged(model: Model, members: Mapping[str, str]) -> dict[str, Body]:
    """Merge bodies that are fixed together, in the frame of the main one."""
    found = {}
    for name in dict.fromkeys(members.values()):
        parts = [body for body in model.bodies if members[body.name] == name]
        main = model.body(name)
        if name != WORLD and len(parts) > 1:
            for part in parts:
                if part.mass < 0.0 or (part.mass == 0.0 and part.inertia.any()):
                    raise ValueError(f"body {part.name!r}: expected a mass > 0, got {part.mass:g}")
        heavy = [part for part in parts if part.mass > 0.0]
        alone = not heavy or heavy == [main]
        found[name] = main if alone else main.with_solids([part.solid for part in heavy])
    return found
