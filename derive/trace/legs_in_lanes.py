"""Transformation of a program for one pose to C with the legs in vector lanes.

The quantities of the legs are arrays of eight lanes, whose last two repeat leg 6, so that one loop computes
all legs. Sums over the legs, and tables that functions pass on, are single arrays, row by row.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from . import nodes as t

_TABLE = 6
"""Local tables with so few columns stay as they are."""

_WRITTEN_OUT = 16
"""Longest loop that is unrolled: GCC unrolls such short loops before it vectorizes."""

Step = str | t.Expression
"""A member, by its name, or an element, by its index."""


@dataclass(frozen=True)
class Layout:
    """Layout of the numbers in memory.

    ``structures`` are the structures of the program by name, and ``records`` their new names. ``sums`` gives,
    for a structure, the first index of each member in one array, and its length. ``inside`` is the member
    that contains the results of a structure. ``parts`` are members that are parts of another member, with
    their first indices. ``functions`` are the new names of functions that fill the structure of their result.
    """

    structures: Mapping[str, t.Structure]
    records: Mapping[str, str]
    sums: Mapping[str, Mapping[str, int]]
    counts: Mapping[str, int]
    inside: Mapping[str, str]
    parts: Mapping[tuple[str, str], tuple[str, int]]
    functions: Mapping[str, str]

    def type(self, kind: t.Type) -> t.Type:
        """Return a type in this layout."""
        match kind:
            case t.Record(name) if name in self.sums:
                return t.Array(t.Real(), (self.counts[name],))
            case t.Record(name):
                return t.Record(self.records.get(name, name))
            case t.Array(t.Record(name), dims):
                return t.Array(t.Record(self.records.get(name, name)), dims)
            case t.Array(item, (rows, columns)):
                return t.Array(item, (rows * columns,))
        return kind

    def structure(self, name: str) -> t.Structure:
        """Return a structure without lanes in this layout."""
        found = self.structures[name]
        members = [replace(each, type=self.type(each.type)) for each in found.members]
        if name in self.inside:
            of = t.Field("of", t.Record(self.inside[name]))
            members = [of, *(each for each in members if each.name == "status")]
        whole = {self.parts[name, each.name][0] for each in members if (name, each.name) in self.parts}
        members = [
            *(t.Field(each, t.Array(t.Real(), (6,))) for each in whole),
            *(each for each in members if (name, each.name) not in self.parts),
        ]
        return t.Structure(self.records.get(name, name), found.meaning, tuple(members))

    def function(self, function: t.Function) -> t.Function:
        """Return a function in this layout."""
        types = {each.name: each.type for each in function.arguments}
        return _Moved(self, types, set()).function(function)


@dataclass(frozen=True)
class _Moved:
    layout: Layout
    types: dict[str, t.Type]
    tables: set[str]

    def function(self, function: t.Function) -> t.Function:
        body = self.node(function.body)
        arguments = tuple(replace(each, type=self.layout.type(each.type)) for each in function.arguments)
        result = None if function.result is None else self.layout.type(function.result)
        name = self.layout.functions.get(function.name, function.name)
        moved = replace(function, name=name, arguments=arguments, result=result, body=body, public=False)
        return _filling(moved) if function.name in self.layout.functions else moved

    def node(self, node: Any) -> Any:
        """Convert a statement or an expression with its parts."""
        match node:
            case t.Let(name, value, kind):
                self.types[name] = kind
                return t.Let(name, self.node(value), self.layout.type(kind))
            case t.Variable(name, kind):
                self.types[name] = kind
                if isinstance(kind, t.Array) and len(kind.dims) == 2 and kind.dims[1] <= _TABLE:
                    self.tables.add(name)
                    return node
                first: t.Expression | None = None if node.value is None else self.node(node.value)
                aligned = isinstance(kind, t.Array) and len(kind.dims) == 2
                return replace(node, type=self.layout.type(kind), value=first, aligned=aligned)
            case t.Call("anywhere", (test,)):
                return self.node(test)
            case t.Call(name, arguments):
                return t.Call(self.layout.functions.get(name, name), self.node(arguments))
            case t.For(last=t.Number(last), kept=True) if last > _WRITTEN_OUT:
                return self.node(replace(node, kept=False))
            case t.Member() | t.Element():
                return self.place(node)
        if isinstance(node, tuple):
            return tuple(each for part in node for each in self.statements(part))
        return t.mapped(node, self.node) if isinstance(node, t.Expression | t.Statement) else node

    def statements(self, node: Any) -> tuple[Any, ...]:
        """Convert a statement; a call whose result fills a structure becomes two."""
        match node:
            case t.Let(name, t.Call(called, arguments)) | t.Variable(
                name, value=t.Call(called, arguments)
            ) if called in self.layout.functions:
                self.types[name] = node.type
                filled = t.Call(self.layout.functions[called], (*self.node(arguments), t.Name(name)))
                return t.Variable(name, self.layout.type(node.type), blank=True), t.Do(filled)
        return (self.node(node),)

    def place(self, node: t.Expression) -> t.Expression:
        """Return the location of a part of a variable."""
        steps: list[Step] = []
        while isinstance(node, t.Member | t.Element):
            found: list[Step] = [node.name] if isinstance(node, t.Member) else [*map(self.node, node.index)]
            steps = found + steps
            node = node.owner if isinstance(node, t.Member) else node.array
        assert isinstance(node, t.Name)
        kind = self.types.get(node.name, t.Real())
        name = kind.name if isinstance(kind, t.Record) else ""
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
                return t.Element(node, (_plus(first, rest[0]),)) if rest else t.From(node, t.Number(first))
        return self.flat(node, kind, steps)

    def flat(self, node: t.Name, kind: t.Type, steps: list[Step]) -> t.Expression:
        """Return a part of a structure without lanes, or of an array."""
        found: list[Step] = []
        while steps:
            step, *steps = steps
            if isinstance(kind, t.Record):
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
                        return t.From(_joined(node, found), t.Number(first))
                    steps = [_plus(first, steps[0])]
            elif node.name not in self.tables and isinstance(kind, t.Array) and len(kind.dims) == 2 and steps:
                found.append(_row(kind.dims[1], step, steps[0]))
                kind, steps = kind.item, steps[1:]
            else:
                found.append(step)
                kind = kind.item if isinstance(kind, t.Array) else kind
        return _joined(node, found)


def _filling(function: t.Function) -> t.Function:
    """Return a function that fills a structure instead of returning one, which C would copy."""
    *body, end = function.body
    assert isinstance(end, t.Return)
    assert isinstance(end.value, t.Name)
    assert function.result is not None
    out = end.value.name
    own = (each for each in body if not (isinstance(each, t.Variable) and each.name == out))
    arguments = (*function.arguments, t.Argument(out, function.result, changed=True))
    return replace(function, arguments=arguments, result=None, body=tuple(own))


def _joined(node: t.Expression, steps: list[Step]) -> t.Expression:
    for step in steps:
        node = t.Member(node, step) if isinstance(step, str) else t.Element(node, (step,))
    return node


def _plus(first: int, index: Step) -> t.Expression:
    assert not isinstance(index, str)
    if isinstance(index, t.Number):
        return t.Number(first + index.value)
    return t.Number(first) + index if first else index


def _row(width: int, row: Step, column: Step) -> t.Expression:
    assert not isinstance(row, str)
    assert not isinstance(column, str)
    if isinstance(row, t.Number) and isinstance(column, t.Number):
        return t.Number(row.value * width + column.value)
    before = t.Number(width) * row
    return (t.Number(row.value * width) if isinstance(row, t.Number) else before) + column
