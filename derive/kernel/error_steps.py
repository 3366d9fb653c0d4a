"""Steps of a block with bounds of their rounding errors: what declares, loads, computes and stores them."""

import operator
from collections.abc import Callable, Container, Iterable
from functools import reduce

from ..mechanics import quantities as n
from ..mechanics.lumped_constants import ADDED
from ..program.block import Output, Quantity
from ..program.rounding import RECIPROCAL, ROOT, RoundedBlock, RoundedStep, error_symbol
from .layouts import CHECKED, Place, member, names_used, stored
from .tree import nodes as t
from .tree.lower import expression, remark
from .tree.read import Given


def unread_errors(block: RoundedBlock, slopes: RoundedBlock) -> set[str]:
    """Steps whose error neither another step, nor a slope, nor a limit, nor anything outside reads."""
    read = {symbol for each in (*block.steps, *slopes.steps) for symbol in each.carried.free_symbols}
    read |= {block.output_error(expr) for out in erring_outputs(block) for expr in out.exprs}
    names = {each.step.name for each in block.steps if error_symbol(each.step.name) not in read}
    return names - block.limits


def kept_outputs(block: RoundedBlock) -> tuple[Output, ...]:
    """Outputs but those by which a leg is checked."""
    return tuple(out for out in block.block.outputs if out.quantity not in CHECKED)


def erring_outputs(block: RoundedBlock) -> tuple[Output, ...]:
    """Outputs whose errors are handed out; that of D is weighed at once."""
    return tuple(out for out in kept_outputs(block) if out.quantity != n.D)


def with_errors(
    block: RoundedBlock, quantities: Iterable[Quantity], made: Callable[[Quantity], t.Field] = stored
) -> list[t.Field]:
    """Members for values, and for errors where there are any."""
    return [
        field for q in quantities for field in (made(q), *([stored(error_of(q))] if block.inexact(q) else []))
    ]


def records_of(structure: str, name: str) -> t.Field:
    """A member of six structures."""
    return t.Field(name, t.Array(t.Record(structure), (6,)))


def error_of(quantity: Quantity) -> Quantity:
    """The error of a quantity."""
    return Quantity(f"{quantity.name}_err", quantity.shape, quantity.unit, "", quantity.symmetric)


def value_and_error(
    owner: str | t.Expression, quantity: Quantity, index: int, *lane: t.Expression
) -> tuple[t.Expression, t.Expression]:
    """One component and its error."""
    value, error = (member(owner, q, *lane).part(q, index) for q in (quantity, error_of(quantity)))
    return value, error


def texts_of_sums() -> dict[str, Given]:
    """Sums of what the legs add to the platform, with errors."""
    total, more = (
        [value_and_error(each, q, i) for q in ADDED for i in range(len(q.keys))] for each in ("sum", "found")
    )
    return {
        "CLEARED": tuple(t.Assign(each, t.Number(0.0)) for pair in total for each in pair),
        "SUMMED": tuple(t.Do(t.Call("add", (*to, *term))) for to, term in zip(total, more, strict=True)),
    }


def loaded(
    block: RoundedBlock, layout: Callable[[Quantity], Place], ready: Container[str] = ()
) -> tuple[t.Statement, ...]:
    """Values, errors and largest sizes of the inputs that are read, without those that are ``ready``."""
    used = names_used(block.block) | block.limits
    found: list[t.Statement] = []
    limits: list[t.Statement] = []
    for q in (q for q in block.block.inputs if q.name not in ready):
        place = layout(q)
        read = [(i, name) for i, name in enumerate(q.names) if name in used]
        found += [t.Let(name, place.part(q, i)) for i, name in read]
        wrong = [(i, name) for i, name in read if block.errors[name] == error_symbol(name)]
        owner = place.array.owner if isinstance(place.array, t.Member) else place.array
        found += [t.Let(f"{name}_err", value_and_error(owner, q, i, *place.lane)[1]) for i, name in wrong]
        limits += [_limit(block, name) for name in q.names if name in block.limits]
    return (*found, *limits)


def _limit(block: RoundedBlock, name: str) -> t.Let:
    size, error = t.Call("size", (t.Name(name),)), block.errors[name]
    return t.Let(f"{name}_max", size + expression(error) if error != 0 else size)


def step_statements(
    block: RoundedBlock, apart: Container[str] = (), unread: Container[str] = ()
) -> Iterable[t.Statement]:
    """Each step: its value, the bound of its error, and its largest size where that is needed.

    apart: steps whose own rounding gets a name. unread: steps whose whole error nothing reads.
    """
    before = None
    for each in block.steps:
        step = each.step
        yield from remark(step, before)
        before = step
        yield t.Let(step.name, expression(step.expr, block.order_of(step)))
        own = _own_error(each)
        if each.rounds and step.name in apart:
            yield t.Let(f"{step.name}_own", own)
            own = t.Name(f"{step.name}_own")
        if not each.exact and step.name not in unread:
            yield t.Let(f"{step.name}_err", _error(each, own))
        if step.name in block.limits:
            yield _limit(block, step.name)


def _own_error(each: RoundedStep) -> t.Expression:
    """What the step's own operations round away."""
    value = t.Name(each.step.name)
    sizes = [expression(each.rounded)] if each.rounded != 0 else []
    if each.kind == ROOT:
        return t.Call("root_error", (value, _units(sizes)))
    return _units([*sizes, t.Call("size", (value,))] if each.own else sizes)


def _error(each: RoundedStep, own: t.Expression) -> t.Expression:
    """The bound: errors of what goes in, and the step's own."""
    value = t.Name(each.step.name)
    carried = [expression(each.carried)] if each.carried != 0 else []
    if each.kind == RECIPROCAL:
        return t.Call("reciprocal_error", (value, expression(each.step.expr.base), _total(carried)))
    if each.kind == ROOT:
        inner = [_units([expression(each.rounded)])] if each.rounded != 0 else []
        return t.Call("root_error", (value, _total([*carried, *inner])))
    return _total([*carried, own] if each.rounds else carried)


def _total(terms: list[t.Expression]) -> t.Expression:
    return reduce(operator.add, terms) if terms else t.Number(0.0)


def _units(sizes: list[t.Expression]) -> t.Expression:
    """Sizes times the rounding unit."""
    return _times(t.Constant("UNIT"), _total(sizes)) if sizes else t.Number(0.0)


def _times(factor: t.Expression, value: t.Expression) -> t.Expression:
    """A product from left to right."""
    if isinstance(value, t.Binary) and value.operator == "*":
        return _times(factor, value.left) * value.right
    return factor * value


def stored_outputs(block: RoundedBlock, outputs: Iterable[Output]) -> Iterable[t.Statement]:
    """Values and errors handed out."""
    for out in outputs:
        q = out.quantity
        owner = "added" if q in ADDED else "out"
        for i, expr in enumerate(out.exprs):
            value, error = value_and_error(owner, q, i)
            yield t.Assign(value, expression(expr))
            if block.inexact(q) or q in ADDED:
                yield t.Assign(error, expression(block.output_error(expr)))
