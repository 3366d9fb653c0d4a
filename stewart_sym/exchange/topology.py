"""A model as a Stewart platform: base, platform and six legs between them, found by how bodies are joined."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..io.array_types import Array
from ..robot import bodies
from ..robot.fields import LEGS
from .model import BETWEEN, WORLD, Body, Joint, Model

_EXPECTED = (
    "a universal or spherical joint, a prismatic joint and a spherical joint from the base to the platform"
)


@dataclass(frozen=True, eq=False)
class Step:
    """A joint on the way from the base to the platform; ``forward``: from its parent to its child."""

    joint: Joint
    forward: bool
    reached: str

    @property
    def axes(self) -> Array:
        """Its axes, (n, 3), world frame, those nearer the base first."""
        return self.joint.axes if self.forward else -self.joint.axes[::-1]


@dataclass(frozen=True, eq=False)
class Leg:
    """A leg: joints at the base, the prismatic one, joints at the platform; its bodies, names.

    crosses: bodies between the joints at the base and, second, at the platform.
    """

    base: tuple[Step, ...]
    slide: Step
    tip: tuple[Step, ...]
    lower: str
    upper: str
    crosses: tuple[tuple[str, ...], tuple[str, ...]]


@dataclass(frozen=True, eq=False)
class Machine:
    """The rigid bodies of a model by name, its platform and six legs.

    placed: all bodies of the model; bodies: rigid bodies, each with the name and the frame of its first
    member; members: name of the rigid body by the name of each member. The first member of the platform is
    the heaviest body to which several legs are attached.
    """

    placed: Mapping[str, Body]
    bodies: Mapping[str, Body]
    members: Mapping[str, str]
    platform: str
    legs: tuple[Leg, ...]

    def point(self, step: Step, side: str) -> Array:
        """Point of a joint, (3,), in the frame of one of the bodies that it joins."""
        own, local = step.joint.child, step.joint.point
        if step.joint.cut and self.members[step.joint.parent] == side:
            own, local = step.joint.parent, step.joint.parent_point
        return local if own == side else self.bodies[side].local(self.placed[own].placed(local))

    def place(self, step: Step) -> Array:
        """Point of a joint in the world, (3,), on its child's side."""
        return self.placed[step.joint.child].placed(step.joint.point)

    def gap(self, cut: Joint) -> float:
        """How far the points of a cut are from each other in the pose of the file, m."""
        ends = self.placed[cut.parent].placed(cut.parent_point), self.placed[cut.child].placed(cut.point)
        return float(np.linalg.norm(ends[0] - ends[1]))


def machine_of(model: Model) -> Machine:
    """Find base, platform and legs; ValueError of one line says what is none of a Stewart platform's."""
    _need_unique(model)
    members = _members(model)
    around = _around(model, members)
    for joint in model.joints:
        if joint.kind == "free" and WORLD not in (members[joint.parent], members[joint.child]):
            got = f"one between {joint.parent!r} and {joint.child!r}"
            raise ValueError(f"joint {joint.name!r}: expected a free joint to the base alone, got {got}")
    if not around.get(WORLD):
        raise ValueError(_no_base(model))
    chains = [_chain(joint, members, around) for joint in around[WORLD]]
    platform = _platform(chains, around)
    if len(around[platform]) != LEGS:
        names = sorted(
            {joint.name for joint in around[platform]} - {chain[-1].joint.name for chain in chains}
        )
        raise ValueError(
            f"joint {names[0]!r}: expected nothing but six legs at the platform {platform!r}, got one more"
        )
    held = _held(model, members, platform, around[platform])
    if held != platform:
        platform, members = held, _members(model, held)
        around = _around(model, members)
        chains = [_chain(joint, members, around) for joint in around[WORLD]]
    reached = {WORLD, *(step.reached for chain in chains for step in chain)}
    loose = sorted(set(members.values()) - reached)
    if loose:
        raise ValueError(f"body {loose[0]!r}: expected a part of a leg, the platform or the base, got none")
    legs = tuple(_leg(chain, i + 1) for i, chain in enumerate(chains))
    placed = {body.name: body for body in model.bodies}
    return Machine(placed, _merged(model, members), members, platform, legs)


def _around(model: Model, members: Mapping[str, str]) -> dict[str, list[Joint]]:
    """Collect the joints that move, by the bodies that they join."""
    found: dict[str, list[Joint]] = {}
    for joint in model.joints:
        if joint.kind in ("fixed", "free"):
            continue
        ends = members[joint.parent], members[joint.child]
        if ends[0] == ends[1]:
            raise ValueError(
                f"joint {joint.name!r}: expected one between two bodies, got {joint.parent!r} and "
                f"{joint.child!r}, which are fixed together otherwise"
            )
        for end in ends:
            found.setdefault(end, []).append(joint)
    return found


def _held(model: Model, members: Mapping[str, str], platform: str, joints: Sequence[Joint]) -> str:
    """Find the heaviest body to which several legs are attached, among the members of the platform.

    A member that is fixed to one other member and has one leg at most, as a fork or a load, does not count.
    """
    legs = {body.name: 0 for body in model.bodies if members[body.name] == platform}
    for joint in joints:
        legs[joint.parent if joint.parent in legs else joint.child] += 1
    fixed: dict[str, set[str]] = {name: set() for name in legs}
    for joint in model.joints:
        if joint.kind == "fixed" and joint.parent in legs and joint.parent != joint.child:
            fixed[joint.parent].add(joint.child)
            fixed[joint.child].add(joint.parent)
    while hanging := [name for name in legs if legs[name] < 2 and len(fixed[name]) == 1]:
        (other,) = fixed.pop(hanging[0])
        legs[other] += legs.pop(hanging[0])
        fixed[other].remove(hanging[0])
    return max(legs, key=lambda name: model.body(name).mass)


def _need_unique(model: Model) -> None:
    names = [body.name for body in model.bodies]
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise ValueError(f"body {twice[0]!r}: expected one body of that name, got {names.count(twice[0])}")
    for joint in model.joints:
        for end in (joint.parent, joint.child):
            if end not in names:
                raise ValueError(f"joint {joint.name!r}: body {end!r}: missing")


def _members(model: Model, first: str = WORLD) -> dict[str, str]:
    """Find for each body the first one that is fixed together with it; the world and ``first`` are first."""
    found = {body.name: body.name for body in model.bodies}
    order = {body.name: i for i, body in enumerate(model.bodies)} | {first: -1, WORLD: -2}
    for joint in model.joints:
        if joint.kind == "fixed":
            one, other = sorted((found[joint.parent], found[joint.child]), key=lambda name: order[name])
            found = {name: one if first == other else first for name, first in found.items()}
    return found


def _chain(first: Joint, members: Mapping[str, str], around: Mapping[str, Sequence[Joint]]) -> list[Step]:
    """Joints from the base on, to the first body with other than two."""
    steps, at, joint = [], WORLD, first
    while True:
        forward = members[joint.parent] == at
        at = members[joint.child if forward else joint.parent]
        steps.append(Step(joint, forward, at))
        if len(around[at]) != 2 or at == WORLD:
            return steps
        joint = around[at][1] if around[at][0] is joint else around[at][0]


def _no_base(model: Model) -> str:
    """What to say of a model in which nothing is joined to the world."""
    expected = "expected legs on a base that is fixed to the world"
    free = [joint for joint in model.joints if joint.kind == "free"]
    if free:
        return f"joint {free[0].name!r}: {expected}, got body {free[0].child!r}, which is free"
    bodies_ = [body.name for body in model.bodies if body.name != WORLD]
    if bodies_:
        return f"body {bodies_[0]!r}: {expected}, got what no joint moves"
    return f"{expected}, got no body"


def _platform(chains: Sequence[Sequence[Step]], around: Mapping[str, Sequence[Joint]]) -> str:
    """The body that six chains lead to; ValueError names those that lead elsewhere, or are too many."""
    ends = [chain[-1].reached for chain in chains]
    reached = [end for end in ends if end != WORLD and ends.count(end) > 1]
    if not reached:
        got = "; ".join(_way(chain, around) for chain in chains[:LEGS])
        more = f" and {len(chains) - LEGS} more" if len(chains) > LEGS else ""
        raise ValueError(f"expected six legs from the base to one platform, got {len(chains)}: {got}{more}")
    platform = max(reached, key=ends.count)
    for number, chain in enumerate(chains, 1):
        if ends[number - 1] != platform:
            expected = "expected joints and closures from the base to the platform"
            got = f"{_way(chain, around)}; other legs lead to {platform!r}"
            raise ValueError(f"leg {number}: {expected}, got {got}")
    if len(chains) != LEGS:
        names = ", ".join(repr(_bodies(chain)[0]) for chain in chains)
        raise ValueError(
            f"body {platform!r}: expected six legs from the base, got {len(chains)}, which begin with {names}"
        )
    return platform


def _way(chain: Sequence[Step], around: Mapping[str, Sequence[Joint]]) -> str:
    """Where a chain leads."""
    end, begin = chain[-1].reached, f"joint {chain[0].joint.name!r}"
    where = f"body {end!r}"
    if end == WORLD:
        last = chain[-1].joint.name
        return f"{begin} to joint {last!r}, which leads back to the base"
    if len(around[end]) == 1:
        return f"{begin} to {where}, where it ends"
    if len(around[end]) == 2:
        return f"{begin} to {where}"
    on = ", ".join(repr(joint.name) for joint in around[end] if joint is not chain[-1].joint)
    return f"{begin} to {where}, which joints {on} lead on from"


def _leg(chain: Sequence[Step], number: int) -> Leg:
    kinds = [step.joint.kind for step in chain]
    slides = [i for i, kind in enumerate(kinds) if kind == "prismatic"]
    if len(slides) == 1:
        slide = slides[0]
        base, tip = tuple(chain[:slide]), tuple(chain[slide + 1 :])
        if _turns(base) in ("universal", "spherical") and _turns(tip) == "spherical":
            between = tuple(step.reached for step in base[:-1]), tuple(step.reached for step in tip[:-1])
            return Leg(base, chain[slide], tip, base[-1].reached, chain[slide].reached, between)
    names = ", ".join(f"{step.joint.kind} {step.joint.name!r}" for step in chain)
    through = ", ".join(map(repr, _bodies(chain)))
    raise ValueError(f"leg {number}: expected {_EXPECTED}, got {names}, by way of {through}")


def _bodies(chain: Sequence[Step]) -> list[str]:
    """Bodies on a way, without those that stand between the joints of one body of a file."""
    found = [step.reached for step in chain if BETWEEN not in step.reached]
    return found or [chain[-1].reached]


def _turns(steps: Sequence[Step]) -> str:
    """What joints at one end of a leg are together."""
    kinds = [step.joint.kind for step in steps]
    if kinds == ["spherical"]:
        return "spherical"
    if kinds and set(kinds) <= {"revolute", "universal"}:
        return {2: "universal", 3: "spherical"}.get(sum(len(step.axes) for step in steps), "other")
    return "other"


def _need_possible_mass(part: Body) -> None:
    """Reject a part that would count for something else than its mass and inertia say."""
    if part.mass < 0.0 or (part.mass == 0.0 and part.inertia.any()):
        raise ValueError(f"body {part.name!r}: expected a mass > 0, got {part.mass:g}")


def _merged(model: Model, members: Mapping[str, str]) -> dict[str, Body]:
    """What is fixed together as one body, in the frame of the first."""
    found = {}
    for name in dict.fromkeys(members.values()):
        parts = [body for body in model.bodies if members[body.name] == name]
        first = model.body(name)
        if name != WORLD and len(parts) > 1:
            for part in parts:
                _need_possible_mass(part)
        heavy = [part for part in parts if part.mass > 0.0]
        if not heavy or heavy == [first]:
            found[name] = first
            continue
        turned = [(part, first.R.T @ part.R) for part in heavy]
        whole = bodies.joined(
            [
                bodies.Body(part.mass, first.local(part.placed(part.center)), Q @ part.inertia @ Q.T)
                for part, Q in turned
            ]
        )
        found[name] = replace(first, mass=whole.mass, center=whole.center_of_mass, inertia=whole.inertia)
    return found
