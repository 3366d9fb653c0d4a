"""Nodes of a kernel tree: types, expressions, statements, functions, and programs.

A tree defines the computation and the order of its operations. A printer determines the notation, and an
interpreter the type of the values; neither changes the order. Other modules import this one as ``t``.
"""

import re
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, dataclass_transform


@dataclass_transform(frozen_default=True)
@dataclass(frozen=True)
class Node:
    """Part of a tree; its subclasses are frozen dataclasses."""

    def __init_subclass__(cls) -> None:
        """Make the subclass a frozen dataclass."""
        dataclass(frozen=True)(cls)


class Type(Node):
    """Type of a value."""


def _of_two(operator: str) -> Callable[["Expression", "Expression"], "Binary"]:
    return lambda left, right: Binary(operator, left, right)


class Expression(Node):
    """Expression with a value; + - * / combine two expressions."""

    __add__, __sub__, __mul__, __truediv__ = map(_of_two, "+-*/")


class Statement(Node):
    """Statement."""


# ---------------------------------------------------------------- types


class Real(Type):
    """Number of the kernel's arithmetic."""


class Integer(Type):
    """Index, status, or mark."""


class Count(Type):
    """Count or index: never negative, and as large as an address."""


class Truth(Type):
    """Result of a comparison."""


class Array(Type):
    """Row-major array of ``item`` with the dimensions ``dims``."""

    item: Type
    dims: tuple[int, ...]


class Pointer(Type):
    """Address of the first of several ``item``, whose count is not part of the type; may be ``NULL``."""

    item: Type


class Record(Type):
    """Structure, by name."""

    name: str


# ---------------------------------------------------------------- expressions


class Number(Expression):
    """Literal: ``int`` for an index or a status, ``float`` in the kernel's arithmetic."""

    value: int | float


class Constant(Expression):
    """Arithmetic constant or status code, by name: ``EPSILON``, ``NOT_FINITE``."""

    name: str


class Name(Expression):
    """Variable."""

    name: str


class Member(Expression):
    """Member of a structure."""

    owner: Expression
    name: str


class Element(Expression):
    """Element of an array, counted from zero."""

    array: Expression
    index: tuple[Expression, ...]


class From(Expression):
    """Part of an array from one element on."""

    array: Expression
    index: Expression


class As(Expression):
    """Conversion of a number to another type."""

    type: Type
    value: Expression


class Not(Expression):
    """True if ``value`` is false."""

    value: Expression


class Negative(Expression):
    """``-value``."""

    value: Expression


class Binary(Expression):
    """``left operator right``, both evaluated.

    The operator is one of ``+ - * / < <= > >= == !=`` or, only for tests, ``& |``.
    """

    operator: str
    left: Expression
    right: Expression


class Select(Expression):
    """``yes`` if ``test`` is true, else ``no``; both are evaluated, and structures member by member."""

    test: Expression
    yes: Expression
    no: Expression


class Call(Expression):
    """Call of a function of the program, or of ``BUILT_IN``."""

    function: str
    arguments: tuple[Expression, ...]


def at(array: Expression | str, *index: Expression | int | str) -> Element:
    """Return an element of an expression or a named variable, at constant or named indices."""
    found = (Number(i) if isinstance(i, int) else named(i) for i in index)
    return Element(named(array), tuple(found))


def of(owner: Expression | str, name: str) -> Member:
    """Return a member of a structure or of a named variable."""
    return Member(named(owner), name)


def named(value: Expression | str) -> Expression:
    """Return a variable by its name."""
    return Name(value) if isinstance(value, str) else value


BUILT_IN: dict[str, Type] = {
    "sqrt": Real(),
    "size": Real(),
    "larger": Real(),
    "fma": Real(),
    "fma_of": Real(),
    "anywhere": Truth(),
}
"""Functions that every language has: square root, absolute value, the larger of two, a product and a sum
rounded once if that costs no more, also with the product given (in C alone), and whether a
test holds for any of the poses side by side."""


# ---------------------------------------------------------------- statements


class Let(Statement):
    """Constant with the ``type`` of its value."""

    name: str
    value: Expression
    type: Type = Real()


class Variable(Statement):
    """Variable with its initial value; numbers of arrays and structures are initially zero.

    A ``blank`` variable has no initial value, because it is assigned before it is read. ``aligned`` aligns it
    like a structure.
    """

    name: str
    type: Type
    value: Expression | None = None
    blank: bool = False
    aligned: bool = False


class Assign(Statement):
    """``target = value``."""

    target: Expression
    value: Expression


class For(Statement):
    """Loop of ``index`` from ``first`` to ``last`` - 1, or downward from ``first`` to ``last`` + 1.

    ``type`` is the type of the index, and ``step`` its increment. ``kept`` loops are not unrolled, because
    compilers vectorize them.
    """

    index: str
    first: Expression
    last: Expression
    body: tuple[Statement, ...]
    down: bool = False
    type: Integer | Count = Integer()
    step: Expression = Number(1)
    kept: bool = False


class Break(Statement):
    """End of the loop."""


class If(Statement):
    """``body`` if ``test`` is true, else ``otherwise``."""

    test: Expression
    body: tuple[Statement, ...]
    otherwise: tuple[Statement, ...] = ()


class Do(Statement):
    """Call of a function that changes an argument."""

    call: Call


class Comment(Statement):
    """Comment about the statements that follow."""

    text: str


class Return(Statement):
    """End of the function with its result; None if it has none."""

    value: Expression | None


# ---------------------------------------------------------------- functions and programs


class Field(Node):
    """Member of a structure; ``meaning`` includes its unit."""

    name: str
    type: Type
    meaning: str = ""


class Structure(Node):
    """Structure with its members in memory order; ``aligned`` is the first member of a vector."""

    name: str
    meaning: str
    members: tuple[Field, ...]
    aligned: bool = False


class Argument(Node):
    """Argument of a function; the function writes to a ``changed`` argument.

    No other argument overlaps an argument that is ``alone``.
    """

    name: str
    type: Type
    changed: bool = False
    alone: bool = False


class Function(Node):
    """Function; a ``public`` one is part of the interface. ``result`` is None if it changes an argument.

    ``apart`` functions are never merged into their callers, and ``inlined`` functions always.
    """

    name: str
    meaning: str
    arguments: tuple[Argument, ...]
    result: Type | None
    body: tuple[Statement, ...]
    public: bool = False
    apart: bool = False
    inlined: bool = False


def numbers(name: str, *dims: int, meaning: str = "") -> Field:
    """Return the members that are numbers or arrays of numbers."""
    return Field(name, Array(Real(), dims) if dims else Real(), meaning)


def snake(name: str) -> str:
    """Return ``leg_terms`` for ``LegTerms``."""
    return re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower()


def signature(
    name: str, result: Type | None = None, changed: Collection[str] = (), **arguments: Type
) -> Function:
    """Return a function without body for callers."""
    given = (Argument(each, kind, each in changed) for each, kind in arguments.items())
    return Function(name, "", tuple(given), result, ())


class Table(Node):
    """Constant structure, or several: the numbers of their members row by row."""

    name: str
    structure: Structure
    rows: tuple[tuple[float, ...], ...]
    meaning: str = ""


class Program(Node):
    """Structures and functions, each defined before it is used."""

    name: str
    structures: tuple[Structure, ...]
    functions: tuple[Function, ...]

    def structure(self, name: str) -> Structure:
        """Return the structure of this name."""
        return next(each for each in self.structures if each.name == name)

    def function(self, name: str) -> Function:
        """Return the function of this name."""
        return next(each for each in self.functions if each.name == name)


def joined(one: Program, other: Program) -> Program:
    """Join two programs; a common name must mean the same in both, or less in the second."""
    structures = {each.name: each for each in one.structures}
    for each in other.structures:
        structures.setdefault(each.name, each)
    functions = {each.name: each for each in (*one.functions, *other.functions)}
    return Program(one.name, tuple(structures.values()), tuple(functions.values()))


def statements(body: tuple[Statement, ...]) -> Iterator[Statement]:
    """Yield every statement of a body, including the statements of loops and conditions."""
    return parts_of(body, Statement)


def names_in(node: Any) -> Iterator[Name]:
    """Return the names that a node and its parts read or write."""
    return (each for each in parts_of(node) if isinstance(each, Name))


def calls_in(node: Any) -> Iterator[Call]:
    """Return the calls in a node and its parts."""
    return (each for each in parts_of(node) if isinstance(each, Call))


def mapped(node: Any, change: Callable[[Any], Any]) -> Any:
    """Return a node with changed contents of its fields."""
    return type(node)(*(change(getattr(node, name)) for name in node.__match_args__))


def substituted(node: Any, expressions: Mapping[str, Expression]) -> Any:
    """Replace names by expressions; other names remain."""
    if isinstance(node, Name):
        return expressions.get(node.name, node)
    if isinstance(node, tuple):
        return tuple(substituted(each, expressions) for each in node)
    return mapped(node, lambda part: substituted(part, expressions)) if isinstance(node, Node) else node


def parts_of(node: Any, kind: type[Node] = Node) -> Iterator[Any]:
    """Return a node and all its parts; ``kind`` are the nodes whose parts are visited."""
    waiting = [node]
    while waiting:
        each = waiting.pop()
        if isinstance(each, kind):
            yield each
            names: tuple[str, ...] = each.__match_args__
            each = [getattr(each, name) for name in names]
        waiting += [part for part in reversed(each) if isinstance(part, (kind, tuple))]
