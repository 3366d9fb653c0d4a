"""The nodes of a kernel tree: types, expressions, statements, functions and programs.

A tree says what is computed and in which order. How that is spelled is a printer's business, which values
pass through it an interpreter's; neither changes the order of an operation.
"""

from collections.abc import Iterator
from dataclasses import dataclass, fields, is_dataclass
from functools import cache
from typing import Any

# ---------------------------------------------------------------- types


@dataclass(frozen=True)
class Real:
    """A number of the kernel's arithmetic."""


@dataclass(frozen=True)
class Integer:
    """An index, a status or a mark."""


@dataclass(frozen=True)
class Count:
    """How many, or which of many: never negative, and as large as the machine's memory."""


@dataclass(frozen=True)
class Truth:
    """The result of a comparison."""


@dataclass(frozen=True)
class Array:
    """``dims`` of ``item``, row-major."""

    item: "Real | Integer | Record | Pointer"
    dims: tuple[int, ...]


@dataclass(frozen=True)
class Pointer:
    """The first of a number of ``item`` that the type does not say; may be ``NULL``."""

    item: "Real | Integer | Record | Pointer"


@dataclass(frozen=True)
class Record:
    """A structure, by name."""

    name: str


Type = Real | Integer | Count | Truth | Array | Pointer | Record


# ---------------------------------------------------------------- expressions


@dataclass(frozen=True)
class Number:
    """A literal: ``int`` where an index or a status is meant, ``float`` in the kernel's arithmetic."""

    value: int | float


@dataclass(frozen=True)
class Constant:
    """A constant of the arithmetic or a status code, by name: ``EPSILON``, ``NOT_FINITE``."""

    name: str


@dataclass(frozen=True)
class Name:
    """A variable."""

    name: str


@dataclass(frozen=True)
class Member:
    """One member of a structure."""

    owner: "Expression"
    name: str


@dataclass(frozen=True)
class Element:
    """One element of an array, counted from zero."""

    array: "Expression"
    index: tuple["Expression", ...]


@dataclass(frozen=True)
class From:
    """The part of an array that begins with one element."""

    array: "Expression"
    index: "Expression"


@dataclass(frozen=True)
class As:
    """A number as another kind of number."""

    type: Type
    value: "Expression"


@dataclass(frozen=True)
class Not:
    """True where ``value`` does not hold."""

    value: "Expression"


@dataclass(frozen=True)
class Negative:
    """``-value``."""

    value: "Expression"


@dataclass(frozen=True)
class Binary:
    """``left operator right``; the operator is one of ``+ - * /``."""

    operator: str
    left: "Expression"
    right: "Expression"


@dataclass(frozen=True)
class Compare:
    """``left operator right``; the operator is one of ``< <= > >= == !=``."""

    operator: str
    left: "Expression"
    right: "Expression"


@dataclass(frozen=True)
class Both:
    """``left`` and ``right``, both evaluated."""

    left: "Expression"
    right: "Expression"


@dataclass(frozen=True)
class Either:
    """``left`` or ``right``, both evaluated."""

    left: "Expression"
    right: "Expression"


@dataclass(frozen=True)
class Select:
    """``yes`` where ``test`` holds, else ``no``; both are evaluated, of structures member by member."""

    test: "Expression"
    yes: "Expression"
    no: "Expression"


@dataclass(frozen=True)
class Call:
    """A function of the program, or one of ``BUILT_IN``."""

    function: str
    arguments: tuple["Expression", ...]


Expression = (
    Number
    | Constant
    | Name
    | Member
    | Element
    | From
    | As
    | Not
    | Negative
    | Binary
    | Compare
    | Both
    | Either
    | Select
    | Call
)


def at(array: "Expression | str", *index: "Expression | int | str") -> Element:
    """An element; of a variable by its name, at constant indices or at variables by their names."""
    found = (Number(i) if isinstance(i, int) else named(i) for i in index)
    return Element(named(array), tuple(found))


def of(owner: "Expression | str", name: str) -> Member:
    """A member of a structure, or of a variable by its name."""
    return Member(named(owner), name)


def named(value: "Expression | str") -> "Expression":
    """A variable by its name."""
    return Name(value) if isinstance(value, str) else value


BUILT_IN: dict[str, Type] = {"sqrt": Real(), "size": Real(), "larger": Real(), "anywhere": Truth()}
"""Functions that every language has: square root, absolute value, the larger of two, and whether a test
holds for any of the poses side by side."""


# ---------------------------------------------------------------- statements


@dataclass(frozen=True)
class Let:
    """A constant; ``type`` of its value."""

    name: str
    value: Expression
    type: Type = Real()


@dataclass(frozen=True)
class Variable:
    """A variable and its first value; of arrays and structures every number is zero.

    blank: without a first value, as it is assigned to before it is read. aligned: as a structure.
    """

    name: str
    type: Type
    value: Expression | None = None
    blank: bool = False
    aligned: bool = False


@dataclass(frozen=True)
class Assign:
    """``target = value``."""

    target: Expression
    value: Expression


@dataclass(frozen=True)
class For:
    """``index`` from ``first`` to ``last`` - 1, or downward from ``first`` to ``last`` + 1.

    type: of the index; step: from one index to the next. kept: stays a loop, as vectors are made of loops.
    """

    index: str
    first: Expression
    last: Expression
    body: tuple["Statement", ...]
    down: bool = False
    type: Integer | Count = Integer()
    step: Expression = Number(1)
    kept: bool = False


@dataclass(frozen=True)
class Break:
    """Ends the loop."""


@dataclass(frozen=True)
class If:
    """``body`` where ``test`` holds, else ``otherwise``."""

    test: Expression
    body: tuple["Statement", ...]
    otherwise: tuple["Statement", ...] = ()


@dataclass(frozen=True)
class Switch:
    """``body`` where a macro is defined when the program is compiled, else ``otherwise``."""

    macro: str
    body: tuple["Statement", ...]
    otherwise: tuple["Statement", ...] = ()


@dataclass(frozen=True)
class Do:
    """A call of a function that changes an argument."""

    call: Call


@dataclass(frozen=True)
class Comment:
    """What the statements that follow are about."""

    text: str


@dataclass(frozen=True)
class Return:
    """The function's result; None: it has none, and ends here."""

    value: Expression | None


Statement = Let | Variable | Assign | For | Break | If | Switch | Do | Comment | Return


# ---------------------------------------------------------------- functions and programs


@dataclass(frozen=True)
class Field:
    """One member of a structure; ``meaning`` with its unit."""

    name: str
    type: Type
    meaning: str = ""


@dataclass(frozen=True)
class Structure:
    """Members in the order in which they are stored; ``aligned``: the first where a vector begins."""

    name: str
    meaning: str
    members: tuple[Field, ...]
    aligned: bool = False


@dataclass(frozen=True)
class Argument:
    """An argument of a function; ``changed``: the function writes to it.

    alone: no other argument overlaps it.
    """

    name: str
    type: Type
    changed: bool = False
    alone: bool = False


@dataclass(frozen=True)
class Function:
    """A function; ``public``: part of the program's interface. result: None where it changes an argument.

    apart: never merged into the functions that call it.
    """

    name: str
    meaning: str
    arguments: tuple[Argument, ...]
    result: Type | None
    body: tuple[Statement, ...]
    public: bool = False
    apart: bool = False


@dataclass(frozen=True)
class Table:
    """A constant structure, or as many as there are rows: the numbers of its members, one after the other."""

    name: str
    structure: Structure
    rows: tuple[tuple[float, ...], ...]
    meaning: str = ""


@dataclass(frozen=True)
class Program:
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
    """Two programs as one; what both have under a name is the same in both."""
    structures = {each.name: each for each in (*one.structures, *other.structures)}
    functions = {each.name: each for each in (*one.functions, *other.functions)}
    return Program(one.name, tuple(structures.values()), tuple(functions.values()))


def statements(body: tuple[Statement, ...]) -> Iterator[Statement]:
    """Every statement of a body, those of loops, conditions and switches as well."""
    for each in body:
        yield each
        if isinstance(each, For | If | Switch):
            yield from statements(each.body)
        if isinstance(each, If | Switch):
            yield from statements(each.otherwise)


def names_in(node: Any) -> Iterator[Name]:
    """Names that a node reads or writes, those of its parts as well."""
    return (each for each in parts_of(node) if isinstance(each, Name))


def calls_in(node: Any) -> Iterator[Call]:
    """Calls in a node and its parts."""
    return (each for each in parts_of(node) if isinstance(each, Call))


def parts_of(node: Any) -> Iterator[Any]:
    """A node and its parts, their parts as well."""
    waiting = [node]
    while waiting:
        each = waiting.pop()
        if isinstance(each, tuple):
            waiting.extend(reversed(each))
        elif (names := _field_names(each.__class__)) is not None:
            yield each
            waiting.extend([getattr(each, name) for name in reversed(names)])


@cache
def _field_names(kind: type) -> tuple[str, ...] | None:
    """Names of the fields of a kind of node, None of what is no node."""
    return tuple(field.name for field in fields(kind)) if is_dataclass(kind) else None
