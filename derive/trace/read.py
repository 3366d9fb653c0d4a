"""Reader of written functions: conversion of a subset of Python to kernel trees.

The subset contains assignments, ``for`` over ``range``, ``reversed(range)``, and ``columns``, ``if``,
``else``, ``break``, ``return``, ``+ - * /``, comparisons, ``&``, ``|``, members, elements, and calls.
``columns`` is a range over the columns of a row, which compilers vectorize. ``where(test, yes, no)`` selects
a value. ``anywhere(test)`` is true if the test is true for one or more poses. ``array(6, 7)`` and the name
of a structure create zeros. The annotation of an argument is its structure, ``"array(6, 7)"``, or ``"Real"``.

Languages with addresses also have ``and``, ``or``, ``not``, ``is None``, parts of arrays ``x[6:]``,
``"Count"``, and ``"Pointer(Real)"``. ``blank(...)`` is an array, a structure, or a type without initial
values. ``alone(...)`` around the type of an argument means that no other argument overlaps it.

Values that are known to the reader are inserted. An ``if`` or ``a if b else c`` that depends on given
constants is decided. ``for i in each(6)`` is unrolled, and ``a[i, k]`` in it becomes a variable ``a_0_1``. A
line with a single name is replaced by given statements, and a line with a string becomes a comment. Arguments
that are given as ``False`` are omitted, also in calls.

``for number in numbers(x)`` visits the numbers of a structure: ``x[number]``, and the same member of other
structures. ``for number in entries(SOME)`` visits given entries, in a lane as ``x[number, i]``, or given
expressions as ``number``.

One text can have several layouts. A line that only calls a given text is replaced by the lines of this text.
A function that is given as ``a`` replaces ``a[i, k]``. If ``ROLLED`` is given, ``for i in each(6)`` remains a
loop.
"""

import ast
import inspect
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import partial, reduce
from types import MappingProxyType
from typing import Any, cast

from . import nodes as t
from .constants import INTEGERS, NAMES
from .function_text import Filled, Names, base_of, called_name, changed_names, parsed, with_variables

_OPERATORS: Mapping[type[ast.AST], str] = {
    **{ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"},
    **{ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!="},
    **{ast.Is: "==", ast.IsNot: "!=", ast.BitAnd: "&", ast.And: "&", ast.BitOr: "|", ast.Or: "|"},
}

_SETTLED = (ast.Constant, ast.Name, ast.BoolOp, ast.UnaryOp, ast.BinOp, ast.Compare, ast.IfExp)
"""Nodes that a decided expression may contain."""

LANES = 8
POSES = 16
"""Poses of a block, of which C has fewer in double."""
_COUNTS = {"LANES": LANES, "POSES": POSES}


@dataclass(frozen=True)
class Entries:
    """Values of a loop over placeholders: expressions, or numbers of structures, optionally in a lane."""

    places: tuple[t.Expression | Callable[..., t.Expression], ...]


Given = int | t.Expression | tuple[t.Statement, ...] | Callable[..., Any] | Entries
"""A constant; an expression or statements that are read where their name stands; a text that is read where it
is called; what makes an expression of indices; or numbers that are gone through."""


def function(
    written: Callable[..., Any],
    structures: Mapping[str, t.Structure],
    functions: Mapping[str, t.Function],
    name: str = "",
    public: bool = False,
    given: Mapping[str, Given] | None = None,
    names: Names = MappingProxyType({}),
) -> t.Function:
    """Read a Python function as a tree.

    ``structures`` and ``functions`` are available by name. ``name`` is the name in the tree, by default the
    name of the function. ``given`` are constants, and statements by the names of their placeholders.
    ``names`` are replacements of other names. Raises ValueError for Python outside of the subset.
    """
    tree = parsed(written, names)
    return _Reader(structures, functions, tree, dict(given or {}), names).function(name or tree.name, public)


def used(
    written: Callable[..., Any],
    names: Names = MappingProxyType({}),
    given: Mapping[str, Given] = MappingProxyType({}),
) -> list[str]:
    """Return the names of the structures and functions that a text and its given texts use, in order."""
    tree = parsed(written, names)
    typed = [*(each.annotation for each in tree.args.args), tree.returns]
    named = [node.id for node in typed if isinstance(node, ast.Name)]
    called = [called_name(node) for node in ast.walk(tree) if isinstance(node, ast.Call)]
    texts = {each: text for each in called if inspect.isfunction(text := given.get(each))}
    inside = [each for text in texts.values() for each in used(text, names, given)]
    return list(dict.fromkeys([*named, *inside, *(each for each in called if each not in texts)]))


@dataclass
class _Reader:
    structures: Mapping[str, t.Structure]
    functions: Mapping[str, t.Function]
    tree: ast.FunctionDef
    given: dict[str, Given]
    names: Names
    types: dict[str, t.Type] = field(default_factory=dict)
    whole: ast.expr | None = None

    def function(self, name: str, public: bool) -> t.Function:
        tree = self.tree
        typed = [(each.arg, *self.argument(each.annotation)) for each in tree.args.args]
        typed = [each for each in typed if self.given.get(each[0]) is not False]
        self.types = {name: kind for name, kind, _ in typed}
        read = self.body(tree.body[ast.get_docstring(tree) is not None :])
        changed = changed_names(read, self.functions, self.is_address)
        arguments = tuple(t.Argument(name, kind, name in changed, alone) for name, kind, alone in typed)
        result = None if isinstance(tree.returns, ast.Constant | None) else self.annotated(tree.returns)
        paragraphs = (ast.get_docstring(tree) or "").split("\n\n")
        meaning = "\n\n".join(" ".join(each.split()) for each in paragraphs)
        return t.Function(name, meaning, arguments, result, with_variables(read, changed), public)

    def argument(self, node: ast.expr | None) -> tuple[t.Type, bool]:
        match node:
            case ast.Call(func=ast.Name(id="alone"), args=[inner]):
                return self.annotated(inner), True
        return self.annotated(node), False

    def annotated(self, node: ast.expr | None) -> t.Type:
        match node:
            case ast.Name(id=name):
                plain: dict[str, t.Type] = {"Real": t.Real(), "Integer": t.Integer(), "Count": t.Count()}
                named = self.structures.get(name)
                return plain.get(name, t.Record(named.name if named else name))
            case ast.Call(func=ast.Name(id="Pointer"), args=[item]):
                return t.Pointer(self.annotated(item))
            case ast.Call(func=ast.Name(id="array" | "pointers" as kind), args=dims):
                of = t.Real() if kind == "array" else t.Pointer(t.Real())
                return t.Array(of, tuple(map(self.dimension, dims)))
        raise self.error(node, "a structure's name, array(...), Pointer(...), Real, Integer or Count")

    def dimension(self, node: ast.expr) -> int:
        found = self.settled(node, _COUNTS)
        if not isinstance(found, int):
            raise self.error(node, "a whole number")
        return found

    def error(self, node: ast.AST | None, expected: str) -> ValueError:
        got = "nothing" if node is None else ast.unparse(node)
        return ValueError(f"{self.tree.name}: expected {expected}, got {got}")

    # ------------------------------------------------------------ statements

    def body(self, nodes: list[ast.stmt]) -> tuple[t.Statement, ...]:
        return tuple(found for node in nodes for found in self.statements(node))

    def inner(self, nodes: list[ast.stmt]) -> tuple[t.Statement, ...]:
        """Read a body whose names are local to it."""
        outside = dict(self.types)
        found = self.body(nodes)
        self.types = outside
        return found

    def statements(self, node: ast.stmt) -> Iterable[t.Statement]:
        """Read a statement; return the remaining statements if it is decided."""
        match node:
            case ast.If() if (holds := self.settled(node.test)) is not None:
                return self.body(node.body if holds else node.orelse)
            case ast.For(target=ast.Name(id=index)) if called_name(node.iter) == "each":
                return self.loop(node, index) if self.given.get("ROLLED") else self.repeated(node, index)
            case ast.For(target=ast.Name(id=index)) if called_name(node.iter) == "numbers":
                return self.of_numbers(node, index)
            case ast.For(iter=ast.Call(args=[ast.Name(id=name)])) if called_name(node.iter) == "entries":
                return self.of_entries(node, cast("Entries", self.given[name]))
            case ast.For(target=ast.Name(id=index)):
                return self.loop(node, index)
            case ast.Expr(value=ast.Call() as call) if callable(text := self.given.get(called_name(call))):
                return self.inlined(text, call)
            case ast.Expr(value=ast.Call(func=ast.Name(id=name))) if self.given.get(name) == ():
                return []
            case ast.Expr(value=ast.Name(id=name)) if isinstance(self.given.get(name), tuple):
                return cast("tuple[t.Statement, ...]", self.given[name])
            case ast.Expr(value=ast.Constant(value=str(text))):
                return [t.Comment(text)]
        return [self.statement(node)]

    def repeated(self, node: ast.For, index: str) -> list[t.Statement]:
        assert isinstance(node.iter, ast.Call)
        found: list[t.Statement] = []
        for i in range(*(self.dimension(arg) for arg in node.iter.args)):
            self.given[index] = i
            found += self.body(node.body)
        return found

    def of_entries(self, node: ast.For, entries: Entries) -> Iterable[t.Statement]:
        """Return the body for each of some numbers of structures."""
        assert isinstance(node.target, ast.Name)
        for each in entries.places:
            self.given[node.target.id] = each
            yield from self.body(node.body)

    def of_numbers(self, node: ast.For, index: str) -> Iterable[t.Statement]:
        """Return the body for each real number of a structure, in loops over arrays."""
        assert isinstance(node.iter, ast.Call)
        for each in self.members(self.type(self.expression(node.iter.args[0]))):
            dims = each.type.dims if isinstance(each.type, t.Array) else ()
            if each.type != t.Integer():
                self.given[index] = partial(_number, each.name, tuple(map(t.Name, "ij"[: len(dims)])))
                found = self.body(node.body)
                for i, count in reversed(list(zip("ij", dims, strict=False))):
                    found = (t.For(i, t.Number(0), t.Number(count), found),)
                yield from found

    def inlined(self, text: Callable[..., Any], call: ast.Call) -> tuple[t.Statement, ...]:
        """Return the lines of another text with its arguments replaced."""
        tree = parsed(text, self.names)
        names = (each.arg for each in tree.args.args)
        settled = (self.settled(arg) for arg in call.args)
        values = (arg if i is None else ast.Constant(i) for arg, i in zip(call.args, settled, strict=True))
        filled = Filled(dict(zip(names, values, strict=True)))
        lines = tree.body[ast.get_docstring(tree) is not None :]
        return self.body([filled.visit(each) for each in lines])

    def settled(self, node: ast.expr, counts: Mapping[str, int] = MappingProxyType({})) -> int | None:
        """Return a value that is known to the reader, else None; ``counts`` are dimensions by name."""
        if isinstance(node, ast.Constant):
            return node.value if isinstance(node.value, int) else None
        if not isinstance(node, _SETTLED):
            return None
        parts = [each for each in ast.walk(node) if isinstance(each, ast.expr)]
        if not all(isinstance(each, _SETTLED) for each in parts):
            return None
        names = {each.id for each in parts if isinstance(each, ast.Name)}
        given = {name: self.given.get(name, counts.get(name)) for name in names}
        known = {name: value for name, value in given.items() if isinstance(value, int)}
        if (names and not known) or any(value is False for value in known.values()):
            return None
        try:
            value = eval(ast.unparse(node), {"__builtins__": {}}, known)
        except NameError:
            return None
        return value if isinstance(value, int) else None

    def statement(self, node: ast.stmt) -> t.Statement:
        self.whole = getattr(node, "value", None)
        if isinstance(node, ast.Assign) and len(node.targets) == 1:
            return self.assigned(node.targets[0], node.value)
        if isinstance(node, ast.If):
            return t.If(self.expression(node.test), self.inner(node.body), self.inner(node.orelse))
        if isinstance(node, ast.Break):
            return t.Break()
        if isinstance(node, ast.Return):
            return t.Return(None if node.value is None else self.expression(node.value))
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
            call = self.expression(node.value)
            assert isinstance(call, t.Call)
            return t.Do(call)
        raise self.error(node, "a statement that every language has")

    def assigned(self, to: ast.expr, value: ast.expr) -> t.Statement:
        target = self.expression(to)
        if not isinstance(target, t.Name):
            return t.Assign(target, self.expression(value))
        name = target.name
        made = self.made(name, value)
        if made is not None:
            self.types[name] = made.type
            return made
        found = self.expression(value)
        if name in self.types:
            return t.Assign(target, found)
        self.types[name] = self.type(found)
        return t.Let(name, found, self.types[name])

    def made(self, name: str, node: ast.expr) -> t.Variable | t.Let | None:
        """Create a variable of zeros, a blank one, or the address of a table."""
        if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name):
            return None
        if node.func.id == "address":
            return t.Let(
                name, t.Name(base_of(node.args[0])), t.Pointer(t.Record(self.structures["Model"].name))
            )
        if node.func.id == "blank":
            return t.Variable(name, self.annotated(node.args[0]), blank=True)
        if node.func.id == "array":
            return t.Variable(name, self.annotated(node))
        if node.func.id in self.structures:
            return t.Variable(name, t.Record(self.structures[node.func.id].name))
        return None

    def loop(self, node: ast.For, index: str) -> list[t.Statement]:
        """Create a loop, unless its body is empty."""
        call = node.iter
        is_reversed = called_name(call) == "reversed"
        if isinstance(call, ast.Call) and is_reversed:
            call = call.args[0]
        if not isinstance(call, ast.Call) or called_name(call) not in ("range", "columns", "each"):
            raise self.error(node.iter, "range(...), reversed(range(...)) or columns(...)")
        down = is_reversed or (called_name(call) == "each" and len(call.args) == 3)
        ends = [self.expression(arg) for arg in call.args[:2]]
        first, last = (t.Number(0), *ends)[-2:]
        kind = t.Count() if self.type(last) == t.Count() else t.Integer()
        self.types[index] = kind
        if is_reversed:
            first, last = _less_one(last), _less_one(first)
        step = self.expression(call.args[2]) if len(call.args) == 3 and not down else t.Number(1)
        step = t.As(t.Count(), step) if kind == t.Count() and step != t.Number(1) else step
        kept = called_name(call) == "columns" and self.given.get("LONG") != 0
        body = self.inner(node.body)
        return [t.For(index, first, last, body, down, kind, step, kept)] if body else []

    # ------------------------------------------------------------ expressions

    def expression(self, node: ast.expr) -> t.Expression:
        settled = self.settled(node)
        if settled is not None:
            return t.Number(int(settled))
        match node:
            case ast.Constant(value=float() as number):
                return t.Number(number)
            case ast.Constant(value=None):
                return t.Constant("NULL")
            case ast.Name(id=name):
                found = self.given.get(name)
                if isinstance(found, t.Expression):
                    return found
                return t.Constant(name) if name in (*INTEGERS, *NAMES) else t.Name(name)
            case ast.Attribute():
                return t.Member(self.expression(node.value), node.attr)
            case ast.Subscript(
                slice=ast.Name(id=name) | ast.Tuple(elts=[ast.Name(id=name), *_]) as index
            ) if callable(place := self.given.get(name)):
                lanes = index.elts[1:] if isinstance(index, ast.Tuple) else []
                return cast("t.Expression", place(*map(self.expression, (node.value, *lanes))))
            case ast.Subscript(slice=ast.Tuple(elts=index), value=ast.Name(id=name)) if callable(
                place := self.given.get(name)
            ):
                return cast("t.Expression", place(*map(self.expression, index)))
            case ast.Subscript(slice=ast.Tuple(elts=index), value=ast.Name(id=name)):
                return t.Name("_".join([name, *(str(self.dimension(each)) for each in index)]))
            case ast.Subscript(slice=ast.Slice(lower=ast.expr() as lower)):
                return t.From(self.expression(node.value), self.expression(lower))
            case ast.Subscript():
                return self.element(node)
            case ast.UnaryOp(op=ast.USub()):
                return t.Negative(self.expression(node.operand))
            case ast.UnaryOp(op=ast.Not()):
                return t.Not(self.expression(node.operand))
            case ast.BoolOp():
                joined = partial(t.Binary, _OPERATORS[type(node.op)])
                return reduce(joined, map(self.expression, node.values))
            case (
                ast.BinOp(left=left, op=operator, right=right)
                | ast.Compare(left=left, ops=[operator], comparators=[right])
            ) if type(operator) in _OPERATORS:
                return t.Binary(_OPERATORS[type(operator)], *self.alike(left, right))
            case ast.BinOp():
                raise self.error(node, "one of + - * / & |")
            case ast.IfExp() if (holds := self.settled(node.test)) is not None:
                return self.expression(node.body if holds else node.orelse)
            case ast.IfExp():
                return t.Select(*map(self.expression, (node.test, node.body, node.orelse)))
            case ast.Call():
                return self.call(node)
        raise self.error(node, "an expression that every language has")

    def alike(self, *nodes: ast.expr) -> tuple[t.Expression, ...]:
        """Return operands of one type: if one is a count, all are."""
        found = tuple(map(self.expression, nodes))
        kinds = [self.type(each) for each in found]
        if t.Count() not in kinds:
            return found
        return tuple(
            t.As(t.Count(), each) if kind == t.Integer() else each
            for each, kind in zip(found, kinds, strict=True)
        )

    def element(self, node: ast.Subscript) -> t.Element:
        index = self.expression(node.slice)
        owner = self.expression(node.value)
        if isinstance(owner, t.Element):
            return t.Element(owner.array, (*owner.index, index))
        return t.Element(owner, (index,))

    def call(self, node: ast.Call) -> t.Expression:
        name = called_name(node)
        arguments = tuple(
            self.expression(arg)
            for arg in node.args
            if self.given.get(base_of(arg)) is not False or base_of(arg) in self.types
        )
        if name == "where":
            return t.Select(*arguments)
        if name == "numbers_of":
            return t.As(t.Pointer(t.Real()), *arguments)
        if name not in t.BUILT_IN and name not in self.functions:
            raise self.error(node, "a function of the program")
        changes = name in self.functions and any(each.changed for each in self.functions[name].arguments)
        if changes and node is not self.whole:
            raise self.error(node, "a statement of its own for a call that changes an argument")
        return t.Call(self.functions[name].name if name in self.functions else name, arguments)

    def type(self, value: t.Expression) -> t.Type:
        match value:
            case t.Number(number):
                return t.Real() if isinstance(number, float) else t.Integer()
            case t.Constant(name):
                return t.Integer() if name in INTEGERS else t.Real()
            case t.Name(name):
                return self.types.get(name, t.Real())
            case t.Member(owner, name):
                return self.member(self.type(owner), name)
            case t.Element(array, index):
                found = self.type(array)
                assert isinstance(found, t.Array | t.Pointer)
                dims = found.dims if isinstance(found, t.Array) else (0,)
                if len(index) > len(dims) and isinstance(found.item, t.Pointer):
                    return found.item.item
                return t.Array(found.item, dims[len(index) :]) if len(index) < len(dims) else found.item
            case t.From(array):
                found = self.type(array)
                assert isinstance(found, t.Array | t.Pointer)
                return t.Pointer(found.item)
            case t.As(kind):
                return kind
            case t.Negative(inner):
                return self.type(inner)
            case t.Binary("+" | "-" | "*" | "/", left, right):
                kinds = (self.type(left), self.type(right))
                return t.Real() if t.Real() in kinds else kinds[0]
            case t.Binary() | t.Not():
                return t.Truth()
            case t.Select(_, yes):
                return self.type(yes)
            case t.Call(name):
                result = t.BUILT_IN[name] if name in t.BUILT_IN else self.functions[name].result
                assert result is not None
                return result
        raise AssertionError(value)

    def member(self, owner: t.Type, name: str) -> t.Type:
        """Return the type of a structure's member."""
        return next(each.type for each in self.members(owner) if each.name == name)

    def members(self, owner: t.Type) -> tuple[t.Field, ...]:
        record = owner.item if isinstance(owner, t.Pointer) else owner
        assert isinstance(record, t.Record)
        return next(each.members for each in self.structures.values() if each.name == record.name)

    def is_address(self, node: t.Expression) -> bool:
        """Return True if a member of an argument is an address, whose target is not part of the argument."""
        node = node.array if isinstance(node, t.From) else node
        if not isinstance(node, t.Member) or not isinstance(node.owner, t.Name):
            return False
        owner = self.types.get(node.owner.name)
        return isinstance(owner, t.Record) and isinstance(self.member(owner, node.name), t.Pointer)


def _number(member: str, index: tuple[t.Name, ...], owner: t.Expression) -> t.Expression:
    """Return one of the numbers of a structure."""
    found = t.of(owner, member)
    return t.Element(found, index) if index else found


def _less_one(value: t.Expression) -> t.Expression:
    if isinstance(value, t.Number):
        return t.Number(value.value - 1)
    return value - t.Number(1)
