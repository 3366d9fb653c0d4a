"""Order of the parts of a trace, the steps that they require, and the location of each result.

A schedule turns a trace into functions. ``lanes`` has the schedules with legs or poses in vector lanes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

from . import nodes as t
from .part_order import in_loop_order, merged, reads, with_sums
from .read import LANES, POSES
from .recorder import LEG, MODEL, MOTION, Branch, Part, Reject, Slot, Step, Trace
from .values import LEGS, ZERO, Value, binary

LANE, LEG_INDEX = t.Name("l"), t.Name("leg")
Place = Callable[[str, int | None], t.Expression]
"""Expression of a name, or of the number of one leg."""


def placed(node: Any, place: Place) -> Any:
    """Replace the names of a node, and simplify zeros and decided selections."""
    match node:
        case t.Element(t.Name(name), (t.Number(leg),)):
            return place(name, int(leg))
        case t.Name(name):
            return place(name, None)
        case tuple():
            return tuple(placed(each, place) for each in node)
        case t.Binary("+" | "-" | "*" as operator, left, right):
            return binary(operator, placed(left, place), placed(right, place))
        case t.Select(t.Binary(">", left, right), yes, no):
            test = placed(left, place), placed(right, place)
            if all(isinstance(each, t.Number) for each in test):
                return placed(yes if test[0].value > test[1].value else no, place)
    return t.mapped(node, lambda part: placed(part, place)) if isinstance(node, t.Node) else node


@dataclass
class Schedule:
    """Ordered parts of a trace with the locations of their results.

    Attributes
    ----------
    trace : Trace
        Trace of the kernel.
    model : str
        Name of the structure of the constants.
    end : str
        Ending of the names of structures and functions.
    poses_in_lanes : bool
        True for a block of poses in lanes. Parts with equal loops are then merged, and poses with a true test
        of a branch that is ``alone`` are left to the function of one pose.
    """

    trace: Trace
    model: str
    end: str
    poses_in_lanes: bool

    def __post_init__(self) -> None:
        body = list(self._scheduled(self.trace.body))
        body = in_loop_order(self.trace, body) if self.poses_in_lanes else with_sums(self.trace, body)
        self.body = merged(body, self.poses_in_lanes)
        self.parts: list[Part] = []
        self.branch_of: dict[str, Branch] = {}
        self.of_one_leg: set[str] = set()
        self.moved: dict[str, tuple[str, Branch]] = {}
        self._collect(self.body, None)
        self.home = {step.name: part for part in self.parts for step in part.steps}
        self.steps = {step.name: step for part in self.parts for step in part.steps}
        updated = {old for old, _ in self.moved.values()}
        self.fixed = {
            name: step.expr
            for name, step in self.steps.items()
            if isinstance(step.expr, t.Number)
            and name not in {*updated, *self.moved, *self.trace.accumulators}
            and name not in self.trace.slots
        }
        self._mark()
        self.structures()

    # ------------------------------------------------------------ order

    def _scheduled(self, items: list[Any]) -> Iterator[Any]:
        """Yield the parts that this schedule computes."""
        for item in items:
            if isinstance(item, Branch):
                omitted = self.poses_in_lanes and item.alone
                body = [] if omitted else list(self._scheduled(item.body))
                yield replace(item, body=body, updates=item.updates if body else {})
            elif isinstance(item, Part) or not self.poses_in_lanes:
                yield item

    def _collect(self, items: list[Any], branch: Branch | None) -> None:
        """List the parts, their branches, and the names that replace others."""
        for item in items:
            if isinstance(item, Part):
                self.parts.append(item)
                if branch is not None:
                    self.branch_of[item.name] = branch
            elif isinstance(item, Branch):
                self.moved |= {new: (old, item) for old, new in item.updates.items()}
                self._collect(item.body, item)

    def branches(self, items: list[Any] | None = None) -> Iterator[Branch]:
        """Yield all branches."""
        for item in self.body if items is None else items:
            if isinstance(item, Branch):
                yield item
                yield from self.branches(item.body)

    # ------------------------------------------------------------ required steps

    def _mark(self) -> None:
        """Find the steps that are needed, of which legs, and the steps that other parts read."""
        waiting: list[tuple[str, int | None]] = [(value.name, None) for value in self.trace.result]
        if self.poses_in_lanes:
            waiting += [(value.name, None) for value in self.trace.unfinished]
        later: dict[str, str] = {}
        for branch in self.branches():
            waiting += reads(branch.test.expr)
            later |= branch.updates
        for reject in _rejects(self.body):
            waiting += [name for value in values_of(reject) for name in reads(value.expr)]
        self.crossing: set[str] = set()

        def cross(name: str) -> None:
            """Note that another part reads a name, and require the value that replaces it."""
            self.crossing.add(name)
            if name in later:
                waiting.append((later[name], None))
                self.crossing.add(later[name])

        for name, _ in list(waiting):
            cross(name)
        joining: dict[str, list[str]] = {}
        for step in self.steps.values():
            if step.joins:
                joining.setdefault(step.joins, []).append(step.name)
        readers: dict[str, list[tuple[Part, int | None]]] = {}
        self.needed: set[tuple[str, int | None]] = set()
        while waiting:
            name, leg = waiting.pop()
            if (name, leg) in self.needed or name not in self.steps:
                continue
            self.needed.add((name, leg))
            if name in joining:
                waiting += [(step, None) for step in joining[name]]
                cross(name)
            for other, of in reads(self.steps[name].expr):
                if other in self.steps:
                    own = leg if of is None and other in self.trace.per_leg else of
                    if not (own == 0 and other in self.trace.zero_at_first):
                        waiting.append((other, own))
                    if self.home[other] is not self.home[name]:
                        cross(other)
                        readers.setdefault(other, []).append((self.home[name], of))
        self._names_needed = {name for name, _ in self.needed}
        self.of_current_leg = {
            name
            for name in self.crossing & self.trace.per_leg
            if self.poses_in_lanes and self._lives_in_loop(name, readers.get(name, []))
        }

    def _lives_in_loop(self, name: str, readers: list[tuple[Part, int | None]]) -> bool:
        """Return True if only the loop over the legs reads a result, and never the result of another leg."""
        home = self.home[name]
        own = (reader.only_first if of == 0 else reader.per_leg and of is None for reader, of in readers)
        in_loop = (
            home.per_leg
            and not home.ahead
            and not {home.name, *(r.name for r, _ in readers)} & {*self.branch_of}
        )
        return bool(readers) and in_loop and name not in self.moved and all(own)

    def steps_of(self, part: Part) -> list[Step]:
        """Return the needed steps of a part."""
        return [
            step for step in part.steps if step.name in self._names_needed and step.name not in self.fixed
        ]

    def stored(self, part: Part) -> list[Step]:
        """Return the steps of a part that other parts read."""
        return [step for step in self.steps_of(part) if step.name in self.crossing]

    # ------------------------------------------------------------ locations

    def target(self, name: str) -> str:
        """Return the value that a result replaces, or its own name."""
        return self.moved[name][0] if name in self.moved else name

    def slot(self, name: str) -> Slot:
        """Return the location of a result, or of the value that it replaces."""
        name = self.target(name)
        slot = self.trace.slots.get(name) or Slot(self.home[name].name, name)
        return replace(slot, structure=f"{slot.structure}_now") if name in self.of_current_leg else slot

    def structures(self) -> dict[str, t.Structure]:
        """Return the structures of all results.

        If poses are in lanes, a structure whose members all belong to a leg contains one leg. Compilers then
        know the distances of its members for every leg.
        """
        members: dict[str, dict[str, tuple[int, bool]]] = {}
        for part in self.parts:
            for step in self.stored(part):
                slot = self.slot(step.name)
                of = members.setdefault(slot.structure, {})
                count = max(of.get(slot.member, (0, False))[0], 0 if slot.index is None else slot.index + 1)
                of[slot.member] = count, self.has_legs(self.target(step.name))
        if self.poses_in_lanes:
            self.of_one_leg = {
                name for name, of in members.items() if all(per_leg for _, per_leg in of.values())
            }
        return {
            name: t.Structure(
                f"{name}{self.end}",
                "",
                tuple(
                    t.numbers(member, *self._dims(count, per_leg and name not in self.of_one_leg))
                    for member, (count, per_leg) in sorted(of.items())
                ),
                aligned=True,
            )
            for name, of in members.items()
        }

    def type_of(self, structure: str) -> t.Type:
        """Return the type of the variable or argument that contains a structure."""
        record = t.Record(f"{structure}{self.end}")
        return t.Array(record, (LEGS,)) if structure in self.of_one_leg else record

    def _dims(self, count: int, per_leg: bool) -> tuple[int, ...]:
        """Return the dimensions of a member with ``count`` components, or of a number if it is 0."""
        own = (count,) if count > 0 else ()
        if self.poses_in_lanes:
            return (*((LEGS,) if per_leg else ()), *own, POSES)
        return (*own, LANES) if per_leg else own

    def is_per_leg(self, name: str) -> bool:
        """Return True if a name has one number for each leg."""
        found = self.trace.inputs.get(name)
        return name in self.trace.per_leg if found is None else found.kind == LEG

    def has_legs(self, name: str) -> bool:
        """Return True if the numbers of all legs are stored."""
        return self.is_per_leg(name) and name not in self.of_current_leg

    def place(self, name: str, leg: t.Expression | None, own_leg: bool = False) -> t.Expression:
        """Return the location of a number outside of its part.

        A function with ``own_leg`` has only the structures of its leg.
        """
        if name in self.fixed:
            return self.fixed[name]
        if name in self.trace.inputs:
            found = self.trace.inputs[name]
            if found.literal is not None:
                return found.literal
            own = (t.Number(found.index),) if found.quantity.shape else ()
            lane = (LANE,) if self.poses_in_lanes else ()
            more = {MOTION: lane, LEG: () if leg is None else (leg,), MODEL: ()}[found.kind]
            array = t.of("at" if found.kind == MOTION else "model", found.quantity.name)
            return t.Element(array, (*own, *more)) if own or more else array
        if leg == t.Number(0) and name in self.trace.zero_at_first:
            return ZERO
        slot = self.slot(name)
        own = () if slot.index is None else (t.Number(slot.index),)
        of_leg = () if leg is None or not self.has_legs(name) else (leg,)
        index = (*of_leg, *own, LANE) if self.poses_in_lanes else (*own, *of_leg)
        array = t.of(slot.structure, slot.member)
        if of_leg and slot.structure in self.of_one_leg:
            owner = t.Name(slot.structure) if own_leg else t.Element(t.Name(slot.structure), of_leg)
            array, index = t.of(owner, slot.member), index[1:]
        return t.Element(array, index) if index else array

    def at(self, name: str, leg: int | None) -> t.Expression:
        """Return the location of a number by the index of its leg."""
        return self.place(name, None if leg is None else t.Number(leg))

    def is_uniform(self, test: Value) -> bool:
        """Return True if a test is equal for all poses."""
        return all(
            name in self.trace.inputs and self.trace.inputs[name].kind == MODEL
            for name, _ in reads(test.expr)
        )


def values_of(reject: Reject) -> list[Value]:
    """Return the arguments of a rejection as one list."""
    return [value for given in reject.arguments for value in (given if isinstance(given, list) else [given])]


def _rejects(items: list[Any]) -> Iterator[Reject]:
    for item in items:
        if isinstance(item, Reject):
            yield item
        elif isinstance(item, Branch):
            yield from _rejects(item.body)
