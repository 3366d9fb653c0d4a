"""The nodes of a kernel tree: types, expressions, statements, functions and programs.

A tree says what is computed and in which order. How that is spelled is a printer's business, which values
pass through it an interpreter's; neither changes the order of an operation.
"""

from collections.abc import Iterator
from dataclasses import dataclass

# ---------------------------------------------------------------- types


@dataclass(frozen=True)
class Real:
    """A number of the kernel's arithmetic."""


@dataclass(frozen=True)
class Integer:
    """An index, a status or a mark."""


@dataclass(frozen=True)
class Truth:
    """The result of a comparison."""


@dataclass(frozen=True)
class Array:
    """``dims`` of ``item``, row-major."""

    item: "Real | Integer | Record"
    dims: tuple[int, ...]


@dataclass(frozen=True)
class Record:
    """A structure, by name."""

    name: str


Type = Real | Integer | Truth | Array | Record


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
    Number | Constant | Name | Member | Element | Negative | Binary | Compare | Both | Either | Select | Call
)

BUILT_IN: dict[str, Type] = {"sqrt": Real(), "size": Real(), "larger": Real(), "anywhere": Truth()}
"""Functions that every language has: square root, absolute value, the larger of two, and whether a test
holds for any of the poses side by side."""


# ---------------------------------------------------------------- statements


@dataclass(frozen=True)
class Let:
    """A constant."""

    name: str
    value: Expression


@dataclass(frozen=True)
class Variable:
    """A variable and its first value; of arrays and structures every number is zero."""

    name: str
    type: Type
    value: Expression | None = None


@dataclass(frozen=True)
class Assign:
    """``target = value``."""

    target: Expression
    value: Expression


@dataclass(frozen=True)
class For:
    """``index`` from ``first`` to ``last`` - 1, or downward from ``first`` to ``last`` + 1."""

    index: str
    first: Expression
    last: Expression
    body: tuple["Statement", ...]
    down: bool = False


@dataclass(frozen=True)
class If:
    """``body`` where ``test`` holds."""

    test: Expression
    body: tuple["Statement", ...]


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
    """The function's result."""

    value: Expression


Statement = Let | Variable | Assign | For | If | Do | Comment | Return


# ---------------------------------------------------------------- functions and programs


@dataclass(frozen=True)
class Field:
    """One member of a structure; ``meaning`` with its unit."""

    name: str
    type: Type
    meaning: str = ""


@dataclass(frozen=True)
class Structure:
    """Members in the order in which they are stored."""

    name: str
    meaning: str
    members: tuple[Field, ...]


@dataclass(frozen=True)
class Argument:
    """An argument of a function; ``changed``: the function writes to it."""

    name: str
    type: Type
    changed: bool = False


@dataclass(frozen=True)
class Function:
    """A function; ``public``: part of the program's interface. result: None where it changes an argument."""

    name: str
    meaning: str
    arguments: tuple[Argument, ...]
    result: Type | None
    body: tuple[Statement, ...]
    public: bool = False


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


def statements(body: tuple[Statement, ...]) -> Iterator[Statement]:
    """Every statement of a body, those of loops and conditions as well."""
    for each in body:
        yield each
        if isinstance(each, For | If):
            yield from statements(each.body)
