"""Schedules with vector lanes: one pose with its legs in lanes, and a block of poses in lanes.

Each part is one function. A step of a leg is computed in a loop over lanes (one pose), in a function that is
called for each leg (block), or, in a part that combines legs, once for each leg that is read (block).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby
from typing import Any

from . import nodes as t
from .fused import with_products_in_sums
from .part_order import reads
from .placement import where_read
from .read import LANES, POSES
from .recorder import Branch, Part, Reject, Step, Trace
from .schedule import LANE, LEG_INDEX, Schedule, placed
from .values import LEGS, Value, binary

INLINE_STEPS = 12
"""Most steps of a part with legs in lanes that compilers may inline; a larger one requires all registers."""


class Lanes(Schedule):
    """Functions of a trace with lanes, which are the poses of a block or the legs of one pose."""

    def __init__(self, trace: Trace, model: str, poses_in_lanes: bool) -> None:
        super().__init__(trace, model, "_block" if poses_in_lanes else "_pose", poses_in_lanes)
        self.lanes = t.Constant("POSES" if poses_in_lanes else "LANES")
        self._names_read: dict[str, set[str]] = {}
        self.functions = {part.name: self._function(part) for part in self.parts}

    # ------------------------------------------------------------ functions

    def _function(self, part: Part) -> t.Function:
        """Return a part as a function of the structures that it reads and changes."""
        body = self._of_block(part) if self.poses_in_lanes else self._of_pose(part)
        used = {each.name for each in t.names_in(body)}
        motion = "motion_lanes" if self.poses_in_lanes else "stewart_motion"
        arguments = [
            t.Argument(name, t.Record(kind), alone=True)
            for name, kind in (("model", self.model), ("at", motion))
            if name in used
        ]
        arguments += [t.Argument(name, t.Real()) for name in self._numbers(part)]
        if LEG_INDEX.name in used:
            arguments.append(t.Argument(LEG_INDEX.name, t.Integer()))
        for name, changed in self._structures(part).items():
            kind = t.Record(f"{name}{self.end}") if self._computes_own_leg(part) else self.type_of(name)
            arguments.append(t.Argument(name, kind, changed, alone=True))
        large = part.per_leg and not self.poses_in_lanes and len(part.steps) > INLINE_STEPS
        legs = {leg for step in part.steps for _, leg in reads(step.expr) if leg is not None}
        combines = self.poses_in_lanes and len(legs) > 1
        apart = part.ahead or combines or part.name in self.branch_of or large
        name = f"compute_{part.name}{self.end}"
        return t.Function(name, part.meaning, tuple(arguments), None, body, apart=apart)

    def _computes_own_leg(self, part: Part) -> bool:
        """Return True for a function that receives the structures of one leg."""
        return self.poses_in_lanes and part.per_leg

    def _numbers(self, part: Part) -> list[str]:
        """Return the constants of the model that a common function receives as numbers."""
        names = (name for step in self.steps_of(part) for name, _ in reads(step.expr)) if part.common else ()
        return [name for name in dict.fromkeys(names) if name in self.trace.inputs]

    def _structures(self, part: Part) -> dict[str, bool]:
        """Return the structures that a part reads, with True if it changes them."""
        found: dict[str, bool] = {}
        for step in self.steps_of(part):
            if step.joins:
                found[self.slot(step.joins).structure] = True
            for name, _ in reads(step.expr):
                if name in self.home and self.home[name] is not part and name not in self.fixed:
                    found.setdefault(self.slot(name).structure, False)
            if step.name in self.moved and self.poses_in_lanes:
                for name, _ in reads(self.moved[step.name][1].test.expr):
                    if name in self.home:
                        found.setdefault(self.slot(name).structure, False)
        return found | {self.slot(step.name).structure: True for step in self.stored(part)}

    def _local(self, part: Part, name: str) -> str:
        """Return the name of a value in a function; common functions use the names of locations."""
        if not part.common or name not in self.home or self.home[name] is part:
            return name
        slot = self.slot(name)
        return slot.member if slot.index is None else f"{slot.member}_{slot.index}"

    def _computed(self, part: Part, step: Step, name: str, value: t.Expression) -> list[t.Statement]:
        """Return a step as a constant, or as an assignment if it is stored at once."""
        if step.name in self.crossing and not self._is_stored_last(part, step):
            return [*_remark(step), self._store(step, value)]
        return [*_remark(step), t.Let(name, value)]

    def _is_stored_last(self, part: Part, step: Step) -> bool:
        """Return True for a result that its own part reads or selects, and for a quotient.

        Processors store in order, so that every store after that of a quotient would wait for it.
        """
        is_quotient = isinstance(step.expr, t.Binary) and step.expr.operator == "/"
        read = step.name in self._read_in(part) or step.per_leg != part.per_leg
        return is_quotient or read or self._is_selected(step.name)

    def _read_in(self, part: Part) -> set[str]:
        """Return the names that a part reads, which are searched once."""
        if part.name not in self._names_read:
            read = (name for step in self.steps_of(part) for name, _ in reads(step.expr))
            self._names_read[part.name] = set(read)
        return self._names_read[part.name]

    def _to_store(self, part: Part) -> list[Step]:
        """Return the results that are stored at the end of a part."""
        return [step for step in self.stored(part) if self._is_stored_last(part, step)]

    def _store(self, step: Step, value: t.Expression) -> t.Assign:
        """Return the assignment of a result to its location."""
        leg = LEG_INDEX if self.poses_in_lanes else LANE
        own = self._computes_own_leg(self.home[step.name])
        target = self.place(step.name, leg if step.per_leg else None, own)
        return t.Assign(target, value)

    def _is_selected(self, name: str) -> bool:
        """Return True if a value replaces another one in some of the lanes."""
        moved = self.poses_in_lanes and name in self.moved
        return moved and not self.is_uniform(self.moved[name][1].test)

    def _of_pose(self, part: Part) -> tuple[t.Statement, ...]:
        """Return the body of a part with legs in lanes: loops over lanes, and steps without a leg."""
        own = {step.name for step in part.steps}
        numbers = self._numbers(part)
        steps = self.steps_of(part)
        stages = [(per_leg, list(run)) for per_leg, run in groupby(steps, lambda step: step.per_leg)]
        read = [(name, leg) for step in steps for name, leg in reads(step.expr)]
        loads = dict.fromkeys(
            name for name, leg in read if leg is None and name not in own and not self.is_per_leg(name)
        )
        kept = self._to_store(part)
        body: list[t.Statement] = [
            t.Let(self._local(part, name), self.at(name, None))
            for name in loads
            if name not in numbers and not isinstance(self.at(name, None), t.Number)
        ]

        def place(name: str, leg: int | None) -> t.Expression:
            if name in numbers:
                return t.Name(name)
            if leg is None:
                return self.fixed.get(name) or self._literal(name) or t.Name(self._local(part, name))
            return t.at(f"{name}_of", leg) if name in own else self.at(name, leg)

        for per_leg, run in stages:
            here = {step.name for step in run}
            if not per_leg:
                for step in run:
                    body += self._computed(part, step, step.name, placed(step.expr, place))
                continue
            picked = {name for step in steps if step.name not in here for name, _ in reads(step.expr)} & here
            dims = t.Array(t.Real(), (LANES,))
            body += [t.Variable(f"{step.name}_of", dims, blank=True) for step in run if step.name in picked]
            of_legs = dict.fromkeys(
                name
                for step in run
                for name, leg in reads(step.expr)
                if leg is None and name not in here and self.is_per_leg(name)
            )
            loop: list[t.Statement] = [
                t.Let(
                    self._local(part, name),
                    t.at(f"{name}_of", LANE) if name in own else self.place(name, LANE),
                )
                for name in of_legs
            ]
            for step in run:
                value = placed(step.expr, place)
                loop += self._computed(part, step, step.name, value)
            loop += [
                t.Assign(t.at(f"{step.name}_of", LANE), t.Name(step.name))
                for step in run
                if step.name in picked
            ]
            loop += [self._store(step, t.Name(step.name)) for step in run if step in kept]
            body.append(t.For(LANE.name, t.Number(0), self.lanes, tuple(loop)))
        body += [self._store(step, t.Name(step.name)) for step in kept if not step.per_leg]
        return with_products_in_sums(body) if part.fuses_named else tuple(body)

    def _literal(self, name: str) -> t.Expression | None:
        """Return the number of an input that is a literal."""
        literal = self.trace.inputs[name].literal if name in self.trace.inputs else None
        return literal if isinstance(literal, t.Number) else None

    def _of_block(self, part: Part) -> tuple[t.Statement, ...]:
        """Return the body of a part with poses in lanes."""
        own, numbers = {step.name for step in part.steps}, self._numbers(part)
        steps: list[t.Statement] = []
        loads: dict[str, t.Expression] = {}

        def place(name: str, of: int | None) -> t.Expression:
            if of == 0 and name in self.trace.zero_at_first:
                return t.Number(0.0)
            named = self._local(part, name)
            named = named if of is None else f"{named}_leg{of + 1}"
            if name in own and name not in self.fixed:
                return t.Name(named)
            leg = t.Number(of) if of is not None else LEG_INDEX if self.is_per_leg(name) else None
            found = t.Name(name) if name in numbers else self.place(name, leg, self._computes_own_leg(part))
            if isinstance(found, t.Number) or name in numbers:
                return found
            loads.setdefault(named, found)
            return t.Name(named)

        totals: dict[str, t.Expression] = {}
        for step in self.steps_of(part):
            if step.joins or step.name in self.trace.accumulators:
                name, term = step.joins or step.name, placed(step.expr, place)
                if step.joins and self.trace.accumulators[name] != "mark":
                    term = binary("+", totals.get(name, self.place(name, None)), term)
                totals[name] = term
                continue
            legs: Sequence[int | None] = [None]
            if step.per_leg and not part.per_leg:
                legs = sorted(leg for name, leg in self.needed if name == step.name and leg is not None)
            for leg in legs:

                def of_leg(name: str, of: int | None, leg: int | None = leg) -> t.Expression:
                    return place(name, leg if of is None and self.is_per_leg(name) else of)

                name = step.name if leg is None else f"{step.name}_leg{leg + 1}"
                steps += self._computed(part, step, name, placed(step.expr, of_leg))
        steps += [t.Assign(self.place(name, None), value) for name, value in totals.items()]
        kept, rest = where_read([t.Let(name, found) for name, found in loads.items()], steps)
        to_store = self._to_store(part)
        selected = [step for step in to_store if self._is_selected(step.name)]
        stores = [self._store(step, t.Name(step.name)) for step in to_store if step not in selected]
        stores += [t.Assign(t.at(f"{step.name}_of", LANE), t.Name(step.name)) for step in selected]
        body = (*rest, *kept, *stores)
        body = with_products_in_sums(body) if part.fuses_named else body
        loop = t.For(LANE.name, t.Number(0), self.lanes, body)
        return (loop,) if not selected else self._with_selections(loop, selected)

    def _with_selections(self, loop: t.For, steps: Sequence[Step]) -> tuple[t.Statement, ...]:
        """Select in a loop of its own; otherwise gcc computes the values only in lanes with a true test."""
        lanes = t.Array(t.Real(), (POSES,))
        variables = [t.Variable(f"{step.name}_of", lanes, blank=True) for step in steps]
        selections = []
        for step in steps:
            test = placed(self.moved[step.name][1].test.expr, self.at)
            target = self.place(step.name, None)
            value = t.Select(test, t.at(f"{step.name}_of", LANE), target)
            selections.append(t.Assign(target, value))
        return (*variables, loop, t.For(LANE.name, t.Number(0), self.lanes, tuple(selections)))

    # ------------------------------------------------------------ calls

    def variables(self) -> list[t.Variable]:
        """Return the variables of the structures."""
        return [t.Variable(name, self.type_of(name), blank=True) for name in self.structures()]

    def calls(self, items: list[Any] | None = None) -> Iterator[t.Statement]:
        """Yield the calls of the parts in order."""
        begun: list[Part] = []
        items = self.body if items is None else items
        for in_loop, run in groupby(items, self._is_in_loop):
            found = list(run)
            if in_loop:
                ahead = [part for part in found if part.ahead]
                begun += ahead
                yield from (self._call(part, t.Number(0)) for part in ahead)
                if others := [part for part in found if not part.ahead]:
                    yield self._loop(begun, others)
                    begun = []
                continue
            for item in found:
                yield from self._item(item)

    def _is_in_loop(self, item: Part | Branch | Reject) -> bool:
        """Return True for a part that is called in a loop over the legs."""
        return self.poses_in_lanes and isinstance(item, Part) and (item.per_leg or item.only_first)

    def _item(self, item: Part | Branch | Reject) -> Iterator[t.Statement]:
        if isinstance(item, Part):
            yield self._call(item, None)
        elif isinstance(item, Reject):
            yield from self._rejection(item)
        elif self.poses_in_lanes and not self.is_uniform(item.test):
            ((name, _),) = reads(item.test.expr)
            most = t.Name(f"most_{name}")
            yield t.Variable(most.name, t.Real(), t.Number(0.0))
            largest = t.Assign(most, t.Call("larger", (self.at(name, None), most)))
            yield t.For(LANE.name, t.Number(0), self.lanes, (largest,))
            yield t.If(t.Binary(">", most, t.Number(0.0)), tuple(self.calls(item.body)))
        else:
            yield t.If(placed(item.test.expr, self.at), tuple(self.calls(item.body)))

    def _call(self, part: Part, leg: t.Expression | None) -> t.Statement:
        function = self.functions[part.name]
        motion = t.Name("at" if self.poses_in_lanes else "motion")
        given = {LEG_INDEX.name: leg, "at": motion} | {
            name: self.at(name, None) for name in self._numbers(part)
        }
        if leg is not None and self._computes_own_leg(part):
            given |= {name: t.Element(t.Name(name), (leg,)) for name in self.of_one_leg}
        arguments = (given.get(each.name) or t.Name(each.name) for each in function.arguments)
        return t.Do(t.Call(function.name, tuple(arguments)))

    def _loop(self, begun: Iterable[Part], parts: Sequence[Part]) -> t.Statement:
        """Return the loop over the legs; parts that are ``begun`` are one leg ahead."""
        body: list[t.Statement] = []
        first = int(all(part.skips_first for part in parts))
        for part in begun:
            test = t.Binary("<", LEG_INDEX, t.Number(LEGS - 1))
            body.append(t.If(test, (self._call(part, LEG_INDEX + t.Number(1)),)))
        for part in parts:
            call = self._call(part, LEG_INDEX)
            if part.only_first:
                body.append(t.If(t.Binary("==", LEG_INDEX, t.Number(0)), (call,)))
            elif part.skips_first and not first:
                body.append(t.If(t.Binary(">", LEG_INDEX, t.Number(0)), (call,)))
            else:
                body.append(call)
        return t.For(LEG_INDEX.name, t.Number(first), t.Number(LEGS), tuple(body))

    def _rejection(self, item: Reject) -> Iterator[t.Statement]:
        """Yield the check of a status, which ends the function."""
        status = t.Name("status")
        yield t.Assign(status, t.Call(item.function, tuple(map(self._argument, item.arguments))))
        yield t.If(t.Binary("!=", status, t.Constant("OK")), (t.Return(status),))

    def _argument(self, given: Value | list[Value]) -> t.Expression:
        """Return a number, or the array of a list of values that one member contains."""
        if isinstance(given, Value):
            return placed(given.expr, self.at)
        slot = self.slot(given[0].name)
        return t.of(slot.structure, slot.member)

    # ------------------------------------------------------------ end of a kernel

    def return_results(self, array: str) -> tuple[t.Statement, ...]:
        """Return the statements that check and store the results of one pose, which are one member."""
        slot, i = self.slot(self.trace.result[0].name), t.Name("i")
        found = t.at(t.of(slot.structure, slot.member), i)
        finite = t.Binary("<=", t.Call("size", (found,)), t.Constant("MAX"))
        check = t.If(t.Not(finite), (t.Return(t.Constant("NOT_FINITE")),))
        loops = (
            t.For(i.name, t.Number(0), t.Number(len(self.trace.result)), (each,))
            for each in (check, t.Assign(t.at(array, i), found))
        )
        return (*loops, t.Return(t.Constant("OK")))


def _remark(step: Step) -> list[t.Statement]:
    return [t.Comment(step.remark)] if step.remark else []
