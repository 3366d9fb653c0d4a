"""Where quantities live: structures of them, loads and stores of blocks, what is checked of a leg.

A layout says where a quantity is: in a structure's member, in an array, in one of the lanes of either, or
in a constant. The lanes are the legs of a pose or the poses of a block.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from string import Template

import sympy as sp

from ..mechanics import quantities as n
from ..mechanics.lumped_constants import arm_c
from ..program.block import Block, Output, Quantity
from .tree import read
from .tree.lower import expression
from .tree.nodes import (
    Array,
    Assign,
    Binary,
    Call,
    Compare,
    Constant,
    Element,
    Expression,
    Field,
    Function,
    Let,
    Member,
    Name,
    Number,
    Real,
    Select,
    Statement,
    Structure,
    Variable,
)

LANE = Name("l")
REACH, FAULT = Name("reach"), Name("fault")
ONE = Number(1.0)
RIGHT_SIDE = (n.c_force, n.c_moment)


@dataclass(frozen=True)
class Place:
    """An array, or a number; lane: index of the lane, if there are lanes; first: index of its first part."""

    array: Expression
    lane: tuple[Expression, ...] = ()
    first: int = 0

    def part(self, quantity: Quantity, index: int) -> Expression:
        """One component of the quantity that is here."""
        own = (Number(self.first + index),) if quantity.shape else ()
        return Element(self.array, (*own, *self.lane)) if own or self.lane else self.array


Layout = Callable[[Quantity], Place | Name]
"""The place of a quantity, or the name of the constant that it is."""


def member(owner: str | Expression, quantity: Quantity, *lane: Expression) -> Place:
    """A quantity as a member of a structure."""
    return Place(Member(Name(owner) if isinstance(owner, str) else owner, quantity.name), lane)


def loads(quantities: Iterable[Quantity], used: set[str], layout: Layout) -> tuple[Statement, ...]:
    """A constant for each component that is used."""
    found: list[Statement] = []
    for q in quantities:
        place = layout(q)
        if isinstance(place, Name):
            found.append(Let(q.name, place))
        else:
            parts = enumerate(q.names)
            found += [Let(name, place.part(q, i)) for i, name in parts if name in used or not q.shape]
    return tuple(found)


def varies(statement: Statement) -> bool:
    """Whether a load is from a place with lanes."""
    return (
        isinstance(statement, Let)
        and isinstance(statement.value, Element)
        and statement.value.index[-1] == LANE
    )


def parted(found: Sequence[Statement]) -> tuple[tuple[Statement, ...], tuple[Statement, ...]]:
    """Loads that are the same for all lanes, and the others."""
    return tuple(each for each in found if not varies(each)), tuple(each for each in found if varies(each))


def stores(outputs: Iterable[Output], layout: Layout) -> tuple[Statement, ...]:
    """Each component of the outputs put into its place."""
    found: list[Statement] = []
    for out in outputs:
        place = layout(out.quantity)
        assert isinstance(place, Place)
        found += [Assign(place.part(out.quantity, i), expression(e)) for i, e in enumerate(out.exprs)]
    return tuple(found)


def set_in_order(array: Expression, exprs: Iterable[sp.Expr], *lane: Expression) -> tuple[Statement, ...]:
    """Elements of an array, one after the other."""
    return tuple(Assign(Element(array, (Number(i), *lane)), expression(e)) for i, e in enumerate(exprs))


def added(target: Expression, term: sp.Expr) -> Assign:
    """``target = target + term``, the sign of a product drawn out."""
    if not term.is_Add and term.could_extract_minus_sign():
        return Assign(target, Binary("-", target, expression(-term)))
    return Assign(target, Binary("+", target, expression(term)))


def assembled(
    exprs: Mapping[Quantity, Sequence[sp.Expr]],
    H: Callable[[int], Expression],
    c: Callable[[int], Expression],
) -> tuple[Statement, ...]:
    """``written.legs.add_leg`` of what a block makes and does not store: column of H set, part of c added.

    H, c: places of a row.
    """
    column = [(i, e) for i, q in ((0, n.H_force), (3, n.H_moment)) for i, e in enumerate(exprs.get(q, ()), i)]
    rows = ((0, n.c_force), (3, n.c_moment), (3, arm_c))
    part = [(i, e) for i, q in rows for i, e in enumerate(exprs.get(q, ()), i)]
    return (*(Assign(H(i), expression(e)) for i, e in column), *(added(c(i), e) for i, e in part))


def names_used(block: Block) -> set[str]:
    """Names that occur on some right side."""
    return {symbol.name for expr in block.expressions() for symbol in expr.free_symbols}


def loaded(block: Block, layout: Layout, *more: Quantity) -> tuple[Statement, ...]:
    """Loads of what a block reads, and of ``more``."""
    used = names_used(block) | {name for q in more for name in q.names}
    return loads(dict.fromkeys((*block.inputs, *more)), used, layout)


def exprs_of(block: Block) -> dict[Quantity, tuple[sp.Expr, ...]]:
    """Expressions of a block by the quantity that they make."""
    return {out.quantity: out.exprs for out in block.outputs}


# ---------------------------------------------------------------- legs


def reach(terms: Iterable[sp.Expr]) -> tuple[Statement, ...]:
    """The largest of the terms, and of what is too short by itself."""
    found: list[Statement] = [
        Variable("reach", Real(), Binary("/", Constant("SHORTEST"), Constant("ROUNDING")))
    ]
    sizes = (Call("size", (expression(term),)) for term in terms)
    return (*found, *(Assign(REACH, Call("larger", (size, REACH))) for size in sizes))


def suspicion(
    leg: Block, before: Expression, after: Expression, least_share: str, least_sine: str
) -> tuple[Statement, ...]:
    """1 in ``after`` where a leg is not finite, short, or too near its joint singularity, else ``before``."""
    given = exprs_of(leg)
    length = expression(given[n.L][0])
    share = Binary("*", Constant(least_share), REACH)
    tests = [(Compare("<=", length, Constant("MAX")), before), (Compare(">", length, share), FAULT)]
    if n.k3 in given:
        tests.append((Compare(">", expression(given[n.k3][0]), Constant(least_sine)), FAULT))
    selections = [Select(test, otherwise, ONE) for test, otherwise in tests]
    return (
        Variable("fault", Real(), selections[0]),
        *(Assign(FAULT, each) for each in selections[1:]),
        Assign(after, FAULT),
    )


# ---------------------------------------------------------------- structures and functions


def stored(quantity: Quantity, *lanes: int, always: bool = True) -> Field:
    """A member without a comment; always: as an array, a number as well."""
    size = (len(quantity.keys),) if quantity.shape or always else ()
    return Field(quantity.name, Array(Real(), (*size, *lanes)) if size or lanes else Real())


def described(quantity: Quantity, *lanes: int) -> Field:
    """A member with its unit and meaning."""
    return replace(stored(quantity, *lanes, always=False), meaning=f"{quantity.unit}: {quantity.meaning}")


@dataclass
class Written:
    """Functions read one after the other; each may call those before it.

    structures: by the names that the texts give them; given: constants, and statements by their names.
    """

    structures: Mapping[str, Structure]
    given: Mapping[str, read.Given]
    functions: dict[str, Function] = field(default_factory=dict)

    def function(
        self,
        written: Callable[..., object],
        name: str = "",
        public: bool = False,
        apart: bool = False,
        given: Mapping[str, read.Given] | None = None,
        **words: object,
    ) -> Function:
        """One more function, ``$word`` in its comment replaced."""
        found = read.function(
            written, self.structures, self.functions, name, public, {**self.given, **(given or {})}
        )
        meaning = Template(found.meaning).substitute({key: str(word) for key, word in words.items()})
        found = replace(found, meaning=meaning, apart=apart)
        self.functions[found.name] = found
        if public:
            self.functions[written.__name__] = found
        return found
