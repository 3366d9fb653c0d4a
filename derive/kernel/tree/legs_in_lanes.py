"""Legs in lanes: a program of one pose as C runs it.

What the legs have stands in lanes of eight, the last two of which repeat leg 6, so that one loop computes
all; their sums are one array, and so is every table that functions hand on, row after row.
"""

from collections.abc import Mapping
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any

from .nodes import (
    Argument,
    Array,
    Binary,
    Call,
    Do,
    Element,
    Expression,
    Field,
    For,
    From,
    Function,
    Let,
    Member,
    Name,
    Number,
    Real,
    Record,
    Return,
    Structure,
    Type,
    Variable,
)

_TABLE = 6
"""Local tables with so few columns stay as they are."""

_WRITTEN_OUT = 16
"""Longer loops stay loops as they are: GCC writes out those of so few turns before it looks for vectors."""

Step = str | Expression
"""A member, by its name, or an element, by its index."""


@dataclass(frozen=True)
class Layout:
    """Where numbers are.

    structures: of the program, by name; records: their new names; sums: of a structure, where each member
    begins in one array, and how long that is; inside: the member that the results of a structure are in;
    parts: members that are parts of another, and where they begin; functions: new names of those that fill
    the structure of their result.
    """

    structures: Mapping[str, Structure]
    records: Mapping[str, str]
    sums: Mapping[str, Mapping[str, int]]
    counts: Mapping[str, int]
    inside: Mapping[str, str]
    parts: Mapping[tuple[str, str], tuple[str, int]]
    functions: Mapping[str, str]

    def type(self, kind: Type) -> Type:
        """A type as it is laid out."""
        match kind:
            case Record(name) if name in self.sums:
                return Array(Real(), (self.counts[name],))
            case Record(name):
                return Record(self.records.get(name, name))
            case Array(Record(name), dims):
                return Array(Record(self.records.get(name, name)), dims)
            case Array(item, (rows, columns)):
                return Array(item, (rows * columns,))
        return kind

    def structure(self, name: str) -> Structure:
        """A structure that has no lanes, as it is laid out."""
        found = self.structures[name]
        members = [replace(each, type=self.type(each.type)) for each in found.members]
        if name in self.inside:
            of = Field("of", Record(self.inside[name]))
            members = [of, *(each for each in members if each.name == "status")]
        whole = {self.parts[name, each.name][0] for each in members if (name, each.name) in self.parts}
        members = [
            *(Field(each, Array(Real(), (6,))) for each in whole),
            *(each for each in members if (name, each.name) not in self.parts),
        ]
        return Structure(self.records.get(name, name), found.meaning, tuple(members))

    def function(self, function: Function) -> Function:
        """A function with everything in its place."""
        types = {each.name: each.type for each in function.arguments}
        return _Moved(self, types, set()).function(function)


@dataclass(frozen=True)
class _Moved:
    layout: Layout
    types: dict[str, Type]
    tables: set[str]

    def function(self, function: Function) -> Function:
        body = self.node(function.body)
        arguments = tuple(replace(each, type=self.layout.type(each.type)) for each in function.arguments)
        result = None if function.result is None else self.layout.type(function.result)
        name = self.layout.functions.get(function.name, function.name)
        moved = replace(function, name=name, arguments=arguments, result=result, body=body, public=False)
        return _filling(moved) if function.name in self.layout.functions else moved

    def node(self, node: Any) -> Any:
        """A statement or an expression with its parts."""
        match node:
            case Let(name, value, kind):
                self.types[name] = kind
                return Let(name, self.node(value), self.layout.type(kind))
            case Variable(name, kind):
                self.types[name] = kind
                if isinstance(kind, Array) and len(kind.dims) == 2 and kind.dims[1] <= _TABLE:
                    self.tables.add(name)
                    return node
                first: Expression | None = None if node.value is None else self.node(node.value)
                aligned = isinstance(kind, Array) and len(kind.dims) == 2
                return replace(node, type=self.layout.type(kind), value=first, aligned=aligned)
            case Call("anywhere", (test,)):
                return self.node(test)
            case Call(name, arguments):
                return Call(self.layout.functions.get(name, name), self.node(arguments))
            case For(last=Number(last), kept=True) if last > _WRITTEN_OUT:
                return self.node(replace(node, kept=False))
            case Member() | Element():
                return self.place(node)
        if isinstance(node, tuple):
            return tuple(each for part in node for each in self.statements(part))
        if is_dataclass(node) and not isinstance(node, Array | Record | type):
            return replace(node, **{each.name: self.node(getattr(node, each.name)) for each in fields(node)})
        return node

    def statements(self, node: Any) -> tuple[Any, ...]:
        """A statement, or two where a function fills what it returned."""
        match node:
            case Let(name, Call(called, arguments)) | Variable(name, value=Call(called, arguments)) if (
                called in self.layout.functions
            ):
                self.types[name] = node.type
                filled = Call(self.layout.functions[called], (*self.node(arguments), Name(name)))
                return Variable(name, self.layout.type(node.type), blank=True), Do(filled)
        return (self.node(node),)

    def place(self, node: Expression) -> Expression:
        """A part of a variable in its place."""
        steps: list[Step] = []
        while isinstance(node, Member | Element):
            found: list[Step] = [node.name] if isinstance(node, Member) else [*map(self.node, node.index)]
            steps = found + steps
            node = node.owner if isinstance(node, Member) else node.array
        assert isinstance(node, Name)
        kind = self.types.get(node.name, Real())
        name = kind.name if isinstance(kind, Record) else ""
        match steps:
            case ["leg", leg, str(part), *rest] if name == "Model":
                return _joined(node, [part, *rest, leg])
            case ["platform", *rest] if name == "Model":
                return _joined(node, rest)
            case ["leg", leg, str(part), *rest] if name.endswith("Legs"):
                before = ["checked"] if part in ("L", "k3") else []
                return _joined(node, [*before, part, *rest, leg])
            case ["given", leg, str(part), *rest] if name.endswith("Legs"):
                return _joined(node, [part, *rest, leg])
            case ["reach", *rest] if name.endswith("Legs"):
                return _joined(node, ["checked", "reach", *rest])
            case [str(part), *rest] if name in self.layout.sums:
                first = self.layout.sums[name][part]
                return Element(node, (_plus(first, rest[0]),)) if rest else From(node, Number(first))
        return self.flat(node, kind, steps)

    def flat(self, node: Name, kind: Type, steps: list[Step]) -> Expression:
        """A part of a structure without lanes, or of an array."""
        found: list[Step] = []
        while steps:
            step, *steps = steps
            if isinstance(kind, Record):
                assert isinstance(step, str)
                members = self.layout.structures[kind.name].members
                inside = kind.name in self.layout.inside and step != "status"
                part = (kind.name, step)
                kind = next(each.type for each in members if each.name == step)
                found += ["of"] * inside
                whole, first = self.layout.parts.get(part, (step, 0))
                found.append(whole)
                if part in self.layout.parts:
                    if not steps:
                        return From(_joined(node, found), Number(first))
                    steps = [_plus(first, steps[0])]
            elif node.name not in self.tables and isinstance(kind, Array) and len(kind.dims) == 2 and steps:
                found.append(_row(kind.dims[1], step, steps[0]))
                kind, steps = kind.item, steps[1:]
            else:
                found.append(step)
                kind = kind.item if isinstance(kind, Array) else kind
        return _joined(node, found)


def _filling(function: Function) -> Function:
    """The function that fills a structure instead of returning one, which C would copy."""
    *body, end = function.body
    assert isinstance(end, Return)
    assert isinstance(end.value, Name)
    assert function.result is not None
    out = end.value.name
    own = (each for each in body if not (isinstance(each, Variable) and each.name == out))
    arguments = (*function.arguments, Argument(out, function.result, changed=True))
    return replace(function, arguments=arguments, result=None, body=tuple(own))


def _joined(node: Expression, steps: list[Step]) -> Expression:
    for step in steps:
        node = Member(node, step) if isinstance(step, str) else Element(node, (step,))
    return node


def _plus(first: int, index: Step) -> Expression:
    assert not isinstance(index, str)
    if isinstance(index, Number):
        return Number(first + index.value)
    return Binary("+", Number(first), index) if first else index


def _row(width: int, row: Step, column: Step) -> Expression:
    assert not isinstance(row, str)
    assert not isinstance(column, str)
    if isinstance(row, Number) and isinstance(column, Number):
        return Number(row.value * width + column.value)
    before = Binary("*", Number(width), row)
    return Binary("+", Number(row.value * width) if isinstance(row, Number) else before, column)
