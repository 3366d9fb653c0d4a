"""Memory layouts: structures of quantities, loads and stores of blocks, and checks of legs.

A layout gives the location of each quantity: a member of a structure, an element of an array, a lane of
either, or a constant. The lanes are the legs of one pose or the poses of a block.
"""

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from string import Template
from types import MappingProxyType
from typing import Self

import sympy as sp

from ..mechanics import quantities as n
from ..mechanics.lumped_constants import arm_c
from ..program.block import Block, Output, Quantity, Step
from ..program.order import Ready
from ..trace import nodes as t
from ..trace import read
from ..trace.function_text import Names
from ..trace.lower import expression, steps_of
from .written import legs

LANE = t.Name("l")
RIGHT_SIDE = (n.c_force, n.c_moment)
CHECKED = (n.q, n.L, n.k3)
"""Outputs of a leg by which its status is decided."""


@dataclass(frozen=True)
class Place:
    """Location of a quantity in an array or a number, with the indices of its lane and first component."""

    array: t.Expression
    lane: tuple[t.Expression, ...] = ()
    first: int = 0

    def part(self, quantity: Quantity, index: int) -> t.Expression:
        """Return one component of the quantity."""
        own = (t.Number(self.first + index),) if quantity.shape else ()
        return t.Element(self.array, (*own, *self.lane)) if own or self.lane else self.array


Arguments = dict[str, tuple[str, tuple[Quantity, ...]]]
"""Structure of each argument of a block, "" of a number or an array, and the quantities that it holds."""

Layout = Callable[[Quantity], Place | t.Name]
"""The place of a quantity, or the name of the constant that it is."""


def member(owner: str | t.Expression, quantity: Quantity, *lane: t.Expression) -> Place:
    """Return a quantity as a member of a structure."""
    return Place(t.Member(t.Name(owner) if isinstance(owner, str) else owner, quantity.name), lane)


def loads(quantities: Iterable[Quantity], used: set[str], layout: Layout) -> tuple[t.Statement, ...]:
    """Return a constant for each component that is used."""
    found: list[t.Statement] = []
    for q in quantities:
        place = layout(q)
        if isinstance(place, t.Name):
            found.append(t.Let(q.name, place))
        else:
            parts = enumerate(q.names)
            found += [t.Let(name, place.part(q, i)) for i, name in parts if name in used or not q.shape]
    return tuple(found)


def varies(statement: t.Statement) -> bool:
    """Return True if a load reads an array with lanes."""
    return (
        isinstance(statement, t.Let)
        and isinstance(statement.value, t.Element)
        and statement.value.index[-1] == LANE
    )


def parted(found: Sequence[t.Statement]) -> tuple[tuple[t.Statement, ...], tuple[t.Statement, ...]]:
    """Separate loads that are equal for all lanes from the others."""
    return tuple(each for each in found if not varies(each)), tuple(each for each in found if varies(each))


def stores(outputs: Iterable[Output], layout: Layout) -> tuple[t.Statement, ...]:
    """Return the statements that store each component of the outputs."""
    found: list[t.Statement] = []
    for out in outputs:
        place = layout(out.quantity)
        assert isinstance(place, Place)
        found += [t.Assign(place.part(out.quantity, i), expression(e)) for i, e in enumerate(out.exprs)]
    return tuple(found)


def set_in_order(
    array: t.Expression, exprs: Iterable[sp.Expr], *lane: t.Expression
) -> tuple[t.Statement, ...]:
    """Return the statements that set the elements of an array in order."""
    return tuple(t.Assign(t.Element(array, (t.Number(i), *lane)), expression(e)) for i, e in enumerate(exprs))


def added(target: t.Expression, term: sp.Expr) -> t.Assign:
    """Return ``target = target + term``, or a subtraction if the term has a minus sign."""
    if not term.is_Add and term.could_extract_minus_sign():
        return t.Assign(target, target - expression(-term))
    return t.Assign(target, target + expression(term))


def assembled(
    exprs: Mapping[Quantity, Sequence[sp.Expr]],
    H: Callable[[int], t.Expression] = lambda row: t.at("column", row, "l"),
    c: Callable[[int], t.Expression] = lambda row: t.at("c", row, "l"),
) -> tuple[t.Statement, ...]:
    """Return the statements of ``written.legs.add_leg`` for results of a block that it does not store.

    They set a column of H and add a part of c. ``H`` and ``c`` are the locations of a row; by default poses
    are in lanes.
    """
    column = [(i, e) for i, q in ((0, n.H_force), (3, n.H_moment)) for i, e in enumerate(exprs.get(q, ()), i)]
    parts: list[t.Statement] = []
    for i, q in ((0, n.c_force), (3, n.c_moment), (3, arm_c)):
        for row, term, name in zip(range(i, i + 3), exprs.get(q, ()), q.names, strict=False):
            # A product is rounded before it is added, as where it is stored.
            parts += [t.Let(name, expression(term))] if term.is_Mul else []
            parts.append(added(c(row), sp.Symbol(name) if term.is_Mul else term))
    return (*(t.Assign(H(i), expression(e)) for i, e in column), *parts)


def names_used(block: Block) -> set[str]:
    """Return the names in the right sides of some steps."""
    return {symbol.name for expr in block.expressions() for symbol in expr.free_symbols}


def loaded(
    block: Block, layout: Layout, *more: Quantity, without: Collection[Quantity] = ()
) -> tuple[t.Statement, ...]:
    """Return the loads of the inputs of a block and of ``more``, except the loaded inputs ``without``."""
    used = names_used(block) | {name for q in more for name in q.names}
    inputs = (q for q in block.inputs if q not in without)
    return loads(dict.fromkeys((*inputs, *more)), used, layout)


def entries(quantities: Iterable[Quantity]) -> read.Entries:
    """Return the stored numbers of quantities that are members of a structure, in order."""
    return read.Entries(tuple(partial(_entry, q, i) for q in quantities for i in range(len(q.keys))))


def _entry(quantity: Quantity, index: int, owner: t.Expression, *lane: t.Expression) -> t.Expression:
    return member(owner, quantity, *lane).part(quantity, index)


def lines(
    block: Block, layout: Layout, without: Collection[Quantity] = (), ready: Ready | None = None
) -> tuple[t.Statement, ...]:
    """Return loads and steps of a block, except the loaded inputs ``without`` and the steps ``ready``."""
    return (*loaded(block, layout, without=without), *steps_of(block.steps, ready))


def parted_steps(block: Block, wanted: Iterable[sp.Expr]) -> tuple[tuple[Step, ...], tuple[Step, ...]]:
    """Separate the steps that some expressions need from the others, each in order."""
    names = {symbol.name for expr in wanted for symbol in expr.free_symbols}
    before: list[Step] = []
    for step in reversed(block.steps):
        if step.name in names:
            names |= {symbol.name for symbol in step.expr.free_symbols}
            before.insert(0, step)
    return tuple(before), tuple(step for step in block.steps if step not in before)


# ---------------------------------------------------------------- legs


def largest(terms: Iterable[sp.Expr]) -> dict[str, read.Given]:
    """Terms that ``written.legs.largest_term`` compares."""
    return {"largest_term": legs.largest_term, "TERMS": read.Entries(tuple(map(expression, terms)))}


def checks(leg: Block, least_length: t.Expression, least_sine: str) -> dict[str, read.Given]:
    """Conditions with which ``written.legs.checked`` and ``mark`` check a leg."""
    given = leg.exprs
    return {
        **{"checked": legs.checked, "mark": legs.mark, "HAS_SINE": int(n.k3 in given)},
        "LENGTH": expression(given[n.L][0]),
        "SINE": expression(given[n.k3][0]) if n.k3 in given else 0,
        "LEAST_LENGTH": least_length,
        "LEAST_SINE": t.Constant(least_sine),
    }


# ---------------------------------------------------------------- structures and functions


def stored(quantity: Quantity, *lanes: int) -> t.Field:
    """Return a member without a comment."""
    size = (len(quantity.keys),) if quantity.shape else ()
    return t.numbers(quantity.name, *size, *lanes)


def unit_and_meaning(quantity: Quantity) -> str:
    """Format unit and meaning such as ``kg m: first moment``; without a unit, the meaning only."""
    return f"{quantity.unit}: {quantity.meaning}".removeprefix(": ")


def described(quantity: Quantity, *lanes: int) -> t.Field:
    """Return a member with its unit and meaning."""
    return replace(stored(quantity, *lanes), meaning=unit_and_meaning(quantity))


def structure(name: str, meaning: str, quantities: Iterable[Quantity], *more: t.Field) -> t.Structure:
    """Return a structure with one member for each quantity, and ``more``."""
    return t.Structure(name, meaning, (*map(described, quantities), *more))


def block_function(block: Block, name: str, result: str, arguments: Arguments) -> t.Function:
    """Return a block as a function that returns the structure ``result`` of its outputs.

    ``arguments`` are, by name, the structures that it reads with the quantities in each. Without the name of
    a structure, the argument is a number, or an array of all components.
    """
    owners = {q: argument for argument, (_, held) in arguments.items() for q in held}
    of_structures = [q for q in block.used_inputs() if arguments[owners[q]][0]]
    used = names_used(block)
    body = [*loads(of_structures, used, lambda q: member(owners[q], q))]
    given = []
    for argument, (kind, held) in arguments.items():
        parts = [part for q in held for part in q.names]
        of: t.Type = t.Record(kind) if kind else t.Real()
        if not kind and any(q.shape for q in held):
            of = t.Array(t.Real(), (len(parts),))
            body += [t.Let(part, t.at(argument, i)) for i, part in enumerate(parts) if part in used]
        given.append(t.Argument(argument, of))
    body += [*steps_of(block.steps), t.Variable("out", t.Record(result), blank=True)]
    body += [*stores(block.outputs, lambda q: member("out", q)), t.Return(t.Name("out"))]
    meaning = f"{block.meaning[0].upper()}{block.meaning[1:]}: {block.operations()}."
    return t.Function(name, meaning, tuple(given), t.Record(result), tuple(body))


def filling(block: Block, made: t.Structure) -> t.Function:
    """Return a block as a function that fills a structure; steps keep equation number and meaning."""
    inputs = block.inputs
    given = [q for q in inputs if q in (n.x, n.bearing)]
    arguments = [
        *([t.Argument("robot", t.Record("stewart_robot"))] if any(q in n.PLATFORM for q in inputs) else []),
        *([t.Argument("leg", t.Record("stewart_leg"))] if any(q in n.OF_LEG for q in inputs) else []),
        t.Argument("at", t.Record("stewart_motions")),
        *(t.Argument(q.name, t.Real()) for q in given),
        t.Argument("out", t.Record(made.name), changed=True),
    ]
    body = (*lines(block, _place, given), *stores(block.outputs, lambda q: member("out", q)))
    meaning = f"{block.meaning[0].upper()}{block.meaning[1:]}. Operations: {block.operations()}."
    return t.Function(block.name, meaning, tuple(arguments), None, body)


def _place(q: Quantity) -> Place:
    return member("robot" if q in n.PLATFORM else "leg" if q in n.OF_LEG else "at", q)


@dataclass
class Written:
    """Functions read in order; each may call the previous ones.

    ``structures`` are the structures by the names in the texts, and ``given`` constants and statements by
    name.
    """

    structures: Mapping[str, t.Structure]
    given: Mapping[str, read.Given]
    functions: dict[str, t.Function] = field(default_factory=dict)

    @classmethod
    def of(
        cls,
        structures: Iterable[t.Structure],
        functions: Iterable[t.Function] = (),
        given: Mapping[str, read.Given] = MappingProxyType({}),
    ) -> Self:
        """Create the collection with structures and functions by their own names."""
        return cls({each.name: each for each in structures}, given, {each.name: each for each in functions})

    def function(
        self,
        written: Callable[..., object],
        name: str = "",
        public: bool = False,
        apart: bool = False,
        given: Mapping[str, read.Given] = MappingProxyType({}),
        structures: Mapping[str, t.Structure] = MappingProxyType({}),
        names: Names = MappingProxyType({}),
        **words: object,
    ) -> t.Function:
        """Read one more function; ``structures`` are additional structures for this function only."""
        known, given = {**self.structures, **structures}, {**self.given, **given}
        found = read.function(written, known, self.functions, name, public, given, names)
        meaning = Template(found.meaning).substitute({key: str(word) for key, word in words.items()})
        found = replace(found, meaning=meaning, apart=apart)
        self.functions[found.name] = found
        if public:
            self.functions[written.__name__] = found
        return found

    def add(
        self, *written: Callable[..., object], given: Mapping[str, read.Given] = MappingProxyType({})
    ) -> None:
        """Read several functions."""
        for each in written:
            self.function(each, given=given)

    def program(self, name: str) -> t.Program:
        """Return the program of all functions."""
        functions = dict.fromkeys(self.functions.values())
        return t.Program(name, tuple(self.structures.values()), tuple(functions))
