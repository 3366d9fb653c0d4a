"""Order of the parts of a trace: loops over the legs, sums over the legs, and merged parts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

from . import nodes as t
from .recorder import Branch, Part, Step, Trace
from .values import LEGS, binary


def reads(node: Any) -> Iterator[tuple[str, int | None]]:
    """Yield the names that a node reads, with the leg if only one is read."""
    match node:
        case t.Element(t.Name(name), (t.Number(leg),)):
            yield name, int(leg)
        case t.Name(name):
            yield name, None
        case tuple():
            for each in node:
                yield from reads(each)
        case t.Node():
            members: tuple[str, ...] = node.__match_args__
            yield from reads(tuple(getattr(node, member) for member in members))


def with_sums(trace: Trace, body: list[Any]) -> list[Any]:
    """Compute each accumulator at once, after the parts of the legs that join it.

    An accumulator of marks is 1 if a leg has the mark 1. Here the mark of each leg begins with the start of
    the accumulator, and not with the marks of the legs before.
    """
    terms: dict[str, list[str]] = {name: [] for name in trace.accumulators}
    every = (step for item in body for step in _steps(item))
    marks = {step.name: step.expr for step in every if trace.accumulators.get(step.name) == "mark"}
    last = dict.fromkeys(terms, 0)
    for at, step in ((at, step) for at, item in enumerate(body) for step in _steps(item) if step.joins):
        ((name, _),) = reads(step.expr)
        terms[step.joins].append(name)
        last[step.joins] = at
    waiting: list[tuple[int, Part]] = []
    found: list[Any] = []
    for at, item in enumerate(body):
        own = [last[step.name] for step in _steps(item) if step.name in terms]
        if own:
            steps = [replace(step, expr=_sum(trace, step, terms.get(step.name, []))) for step in item.steps]
            waiting.append((max(at, *own), replace(item, steps=steps)))
        elif not isinstance(item, Part):
            found.append(item)
        elif steps := [step for step in item.steps if not step.joins]:
            found.append(replace(item, steps=[_of_one_leg(step, marks) for step in steps]))
        found += [part for last_at, part in waiting if last_at == at]
    return found


def _sum(trace: Trace, step: Step, terms: list[str]) -> t.Expression:
    """Return the value of an accumulator, leg by leg."""
    total = step.expr
    for leg in range(LEGS):
        for name in terms:
            if not (leg == 0 and name in trace.zero_at_first):
                term = t.at(name, leg)
                is_mark = trace.accumulators[step.name] == "mark"
                total = t.Call("larger", (total, term)) if is_mark else binary("+", total, term)
    return total


def _of_one_leg(step: Step, starts: Mapping[str, t.Expression]) -> Step:
    """Replace accumulators in a step of a leg by their starts."""
    return replace(step, expr=t.substituted(step.expr, starts)) if step.per_leg else step


def in_loop_order(trace: Trace, body: list[Any]) -> list[Any]:
    """Sort the parts: before the loop over the legs, in it, and after it, each in order.

    A part that is a leg ahead begins with leg 1 before the loop.
    A part that reads leg 1 only is called in the loop, so that only this leg's results are stored.
    """
    before: list[Any] = []
    loop: list[Any] = []
    after: list[Any] = []
    of_first: set[str] = set()
    for item in body:
        if isinstance(item, Branch) and not item.body:
            continue
        read = _read(item)
        legs = {leg for name, leg in read if name in trace.per_leg}
        late = {name for name, _ in read} & set().union(*map(_written, after))
        totals = {name for name, _ in read if name in trace.accumulators} - _written(item)
        if not isinstance(item, Part) or late or totals:
            after.append(item)
        elif item.per_leg:
            (before if item.ahead else loop).append(item)
        elif legs == {0} or (not legs and {name for name, _ in read} & of_first):
            of_first |= _written(item)
            loop.append(replace(item, only_first=True))
        elif not legs:
            before.append(item)
        else:
            after.append(item)
    return [*before, *_joined_once(loop), *after]


def merged(body: list[Any], poses_in_lanes: bool) -> list[Any]:
    """Merge parts with equal loops, so that their results stay in registers.

    In lanes of poses, a part joins an earlier one if the parts between them do not depend on it, nor it on
    them. In lanes of legs, it joins only the part before it.
    """
    found: list[Any] = []
    for item in body:
        for at, other in reversed(list(enumerate(found))):
            if isinstance(item, Part) and isinstance(other, Part) and _alike(other, item, poses_in_lanes):
                found[at] = replace(other, steps=[*other.steps, *item.steps])
                break
            if not poses_in_lanes or _conflict(item, other):
                found.append(item)
                break
        else:
            found.append(item)
    return found


def _alike(one: Part, other: Part, poses_in_lanes: bool) -> bool:
    """Return True if two parts can have one loop."""
    properties = [
        (each.per_leg, each.skips_first, each.only_first, each.fuses_named) for each in (one, other)
    ]
    plain = not any(each.ahead or each.common for each in (one, other))
    return plain and properties[0] == properties[1] and (poses_in_lanes or one.name == other.name)


def _steps(item: Any) -> list[Step]:
    """Return the steps of a part; other items have none."""
    return item.steps if isinstance(item, Part) else []


def _written(item: Any) -> set[str]:
    """Return the names that a part or branch defines or replaces."""
    if isinstance(item, Branch):
        return {*item.updates}.union(*map(_written, item.body))
    return {step.joins or step.name for step in _steps(item)}


def _read(item: Any) -> set[tuple[str, int | None]]:
    """Return the names that a part or branch reads, with the leg if only one is read."""
    if isinstance(item, Branch):
        return {*reads(item.test.expr), *((new, None) for new in item.updates.values())}.union(
            *map(_read, item.body)
        )
    return {found for step in _steps(item) for found in reads(step.expr)}


def _joined_once(loop: list[Part]) -> list[Part]:
    """Move the sums of leg 1 into the part of leg 1, and the sums of the others into their part."""
    first = next((part for part in reversed(loop) if part.only_first), None)
    others = next(
        (part for part in loop if part.skips_first and any(each.joins for each in part.steps)), None
    )
    if first is None or others is None:
        return loop
    between = loop[loop.index(first) + 1 : loop.index(others)]
    steps = [step for part in between if not part.skips_first for step in part.steps]
    if not all(step.joins for step in steps):
        return loop
    of_first = []
    for step in steps:
        ((name, _),) = reads(step.expr)
        of_first.append(replace(step, name=f"{step.name}_first", expr=t.at(name, 0), per_leg=False))
    joined_parts = {
        id(first): replace(first, steps=[*first.steps, *of_first]),
        id(others): replace(others, steps=[*steps, *others.steps]),
    }
    return [joined_parts.get(id(part), part) for part in loop if part not in between or part.skips_first]


def _conflict(one: Any, other: Any) -> bool:
    """Return True if the order of two items matters."""
    read = [{name for name, _ in _read(each)} for each in (one, other)]
    written = [_written(each) for each in (one, other)]
    return bool(read[0] & written[1] or read[1] & written[0] or written[0] & written[1])
