"""Nodes of a kernel tree: types, expressions, statements, functions, and programs.

A tree defines the computation and the order of its operations. A printer determines the notation, and an
interpreter the type of the values; neither changes the order. Other modules import this one as ``t``.
"""

import re
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass
from typing import Any, dataclass_transform


@dataclass_transform(frozen_default=True)
@dataclass(frozen=True)
class Node:
    """A part of a tree; its subclasses are frozen dataclasses."""

    def __init_subclass__(cls) -> None:
        """Makes the subclass one."""
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
    """A number of the kernel's arithmetic."""


class Integer(Type):
    """An index, a status or a mark."""


class Count(Type):
    """Count or index: never negative, and as large as an address."""


class Truth(Type):
    """The result of a comparison."""


class Array(Type):
    """``dims`` of ``item``, row-major."""

    item: Type
    dims: tuple[int, ...]


class Pointer(Type):
    """The first of a number of ``item`` that the type does not say; may be ``NULL``."""

    item: Type


class Record(Type):
    """A structure, by name."""

    name: str


# ---------------------------------------------------------------- expressions


class Number(Expression):
    """A literal: ``int`` where an index or a status is meant, ``float`` in the kernel's arithmetic."""

    value: int | float


class Constant(Expression):
    """A constant of the arithmetic or a status code, by name: ``EPSILON``, ``NOT_FINITE``."""

    name: str


class Name(Expression):
    """A variable."""

    name: str


class Member(Expression):
    """One member of a structure."""

    owner: Expression
    name: str


class Element(Expression):
    """One element of an array, counted from zero."""

    array: Expression
    index: tuple[Expression, ...]


class From(Expression):
    """The part of an array that begins with one element."""

    array: Expression
    index: Expression


class As(Expression):
    """A number as another kind of number."""

    type: Type
    value: Expression


class Not(Expression):
    """True where ``value`` does not hold."""

    value: Expression


class Negative(Expression):
    """``-value``."""

    value: Expression


class Binary(Expression):
    """``left operator right``, both evaluated.

    The operator is one of ``+ - * / < <= > >= == !=`` or, of tests alone, ``& |``.
    """

    operator: str
    left: Expression
    right: Expression


class Select(Expression):
    """``yes`` where ``test`` holds, else ``no``; both are evaluated, of structures member by member."""

    test: Expression
    yes: Expression
    no: Expression


class Call(Expression):
    """A function of the program, or one of ``BUILT_IN``."""

    function: str
    arguments: tuple[Expression, ...]


def at(array: Expression | str, *index: Expression | int | str) -> Element:
    """An element; of a variable by its name, at constant indices or at variables by their names."""
    found = (Number(i) if isinstance(i, int) else named(i) for i in index)
    return Element(named(array), tuple(found))


def of(owner: Expression | str, name: str) -> Member:
    """A member of a structure, or of a variable by its name."""
    return Member(named(owner), name)


def named(value: Expression | str) -> Expression:
    """A variable by its name."""
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
    """A constant; ``type`` of its value."""

    name: str
    value: Expression
    type: Type = Real()


class Variable(Statement):
    """A variable and its first value; of arrays and structures every number is zero.

    blank: without a first value, as it is assigned to before it is read. aligned: as a structure.
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
    """``index`` from ``first`` to ``last`` - 1, or downward from ``first`` to ``last`` + 1.

    type: of the index; step: from one index to the next. kept: stays a loop, as vectors are made of loops.
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
    """Ends the loop."""


class If(Statement):
    """``body`` where ``test`` holds, else ``otherwise``."""

    test: Expression
    body: tuple[Statement, ...]
    otherwise: tuple[Statement, ...] = ()


class Do(Statement):
    """A call of a function that changes an argument."""

    call: Call


class Comment(Statement):
    """Comment about the statements that follow."""

    text: str


class Return(Statement):
    """The function's result; None: it has none, and ends here."""

    value: Expression | None


# ---------------------------------------------------------------- functions and programs


class Field(Node):
    """One member of a structure; ``meaning`` with its unit."""

    name: str
    type: Type
    meaning: str = ""


class Structure(Node):
    """Members in the order in which they are stored; ``aligned``: the first where a vector begins."""

    name: str
    meaning: str
    members: tuple[Field, ...]
    aligned: bool = False


class Argument(Node):
    """An argument of a function; ``changed``: the function writes to it.

    alone: no other argument overlaps it.
    """

    name: str
    type: Type
    changed: bool = False
    alone: bool = False


class Function(Node):
    """A function; ``public``: part of the program's interface. result: None where it changes an argument.

    apart: never merged into the functions that call it; inlined: always.
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
    """A member that is a number, or an array of them."""
    return Field(name, Array(Real(), dims) if dims else Real(), meaning)


def snake(name: str) -> str:
    """``leg_terms`` of ``LegTerms``."""
    return re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower()


def signature(
    name: str, result: Type | None = None, changed: Collection[str] = (), **arguments: Type
) -> Function:
    """A function of which others need only how it is called."""
    given = (Argument(each, kind, each in changed) for each, kind in arguments.items())
    return Function(name, "", tuple(given), result, ())


class Table(Node):
    """A constant structure, or as many as there are rows: the numbers of its members, one after the other."""

    name: str
    structure: Structure
    rows: tuple[tuple[float, ...], ...]
    meaning: str = ""


class Program(Node):
    """Structures and functions in an order in which each is defined before it is used."""

    name: str
    structures: tuple[Structure, ...]
    functions: tuple[Function, ...]

    def structure(self, name: str) -> Structure:
        """The structure of this name."""
        return next(each for each in self.structures if each.name == name)

    def function(self, name: str) -> Function:
        """The function of this name."""
        return next(each for each in self.functions if each.name == name)


def joined(one: Program, other: Program) -> Program:
    """Two programs as one; what both have under a name is the same in both, or the second does with less."""
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
    """Calls in a node and its parts."""
    return (each for each in parts_of(node) if isinstance(each, Call))


def mapped(node: Any, change: Callable[[Any], Any]) -> Any:
    """A node with what its fields hold changed."""
    return type(node)(*(change(getattr(node, name)) for name in node.__match_args__))


def parts_of(node: Any, kind: type[Node] = Node) -> Iterator[Any]:
    """A node and its parts, their parts as well; kind: of the nodes that are gone into."""
    waiting = [node]
    while waiting:
        each = waiting.pop()
        if isinstance(each, kind):
            yield each
            names: tuple[str, ...] = each.__match_args__
            each = [getattr(each, name) for name in names]
        waiting += [part for part in reversed(each) if isinstance(part, (kind, tuple))]
