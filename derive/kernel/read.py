"""Functions written in a part of Python, read as trees: what a kernel does around its blocks.

Allowed are assignments, ``for`` over ``range`` and ``reversed(range)``, ``break``, ``if``, ``else``,
``return``, ``+ - * /``, comparisons, ``&`` and ``|``, members, elements and calls. ``where(test, yes, no)``
selects, ``anywhere(test)`` says whether a test holds for any of the poses side by side, ``array(6, 7)`` and
the name of a structure make zeros. Arguments carry the name of their structure, ``"array(6, 7)"`` or
``"Real"``.
"""

import ast
import inspect
import textwrap
from collections.abc import Callable, Mapping
from typing import Any

from .constants import INTEGERS, NAMES
from .nodes import (
    BUILT_IN,
    Argument,
    Array,
    Assign,
    Binary,
    Both,
    Break,
    Call,
    Compare,
    Constant,
    Do,
    Either,
    Element,
    Expression,
    For,
    Function,
    If,
    Integer,
    Let,
    Member,
    Name,
    Negative,
    Number,
    Real,
    Record,
    Return,
    Select,
    Statement,
    Structure,
    Truth,
    Type,
    Variable,
)

_OPERATORS = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}
_COMPARISONS = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!="}


def function(
    written: Callable[..., Any],
    structures: Mapping[str, Structure],
    functions: Mapping[str, Function],
    name: str = "",
    public: bool = False,
) -> Function:
    """A Python function as a tree.

    structures, functions: those it may name, by name. name: of the tree, if another. Raises ValueError for
    what is not allowed.
    """
    tree = ast.parse(textwrap.dedent(inspect.getsource(written))).body[0]
    assert isinstance(tree, ast.FunctionDef)
    return _Reader(structures, functions, tree).function(name or tree.name, public)


class _Reader:
    def __init__(
        self, structures: Mapping[str, Structure], functions: Mapping[str, Function], tree: ast.FunctionDef
    ) -> None:
        self.structures, self.functions, self.tree = structures, functions, tree
        self.types: dict[str, Type] = {}
        self.whole: ast.expr | None = None
        self.changed = _changed(tree, functions)

    def function(self, name: str, public: bool) -> Function:
        tree = self.tree
        arguments = tuple(
            Argument(each.arg, self.annotated(each.annotation), each.arg in self.changed)
            for each in tree.args.args
        )
        self.types = {each.name: each.type for each in arguments}
        body = self.body(tree.body[1:])
        result = None if _is_none(tree.returns) else self.annotated(tree.returns)
        meaning = " ".join((ast.get_docstring(tree) or "").split())
        return Function(name, meaning, arguments, result, body, public)

    def annotated(self, node: ast.expr | None) -> Type:
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            node = ast.parse(node.value, mode="eval").body
        if isinstance(node, ast.Name):
            plain: dict[str, Type] = {"Real": Real(), "Integer": Integer()}
            return plain.get(node.id, Record(node.id))
        if isinstance(node, ast.Call):
            return Array(Real(), tuple(_whole(arg) for arg in node.args))
        raise self.error(node, "a structure's name, array(...), Real or Integer")

    def error(self, node: ast.AST | None, expected: str) -> ValueError:
        got = "nothing" if node is None else ast.unparse(node)
        return ValueError(f"{self.tree.name}: expected {expected}, got {got}")

    # ------------------------------------------------------------ statements

    def body(self, nodes: list[ast.stmt]) -> tuple[Statement, ...]:
        return tuple(self.statement(node) for node in nodes)

    def statement(self, node: ast.stmt) -> Statement:
        self.whole = getattr(node, "value", None)
        if isinstance(node, ast.Assign) and len(node.targets) == 1:
            return self.assigned(node.targets[0], node.value)
        if isinstance(node, ast.For) and isinstance(node.target, ast.Name):
            return self.loop(node, node.target.id)
        if isinstance(node, ast.If):
            return If(self.expression(node.test), self.body(node.body), self.body(node.orelse))
        if isinstance(node, ast.Break):
            return Break()
        if isinstance(node, ast.Return) and node.value is not None:
            return Return(self.expression(node.value))
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
            call = self.expression(node.value)
            assert isinstance(call, Call)
            return Do(call)
        raise self.error(node, "a statement that every language has")

    def assigned(self, target: ast.expr, value: ast.expr) -> Statement:
        if not isinstance(target, ast.Name):
            return Assign(self.expression(target), self.expression(value))
        name = target.id
        made = self.zeros(value)
        if made is not None:
            self.types[name] = made
            return Variable(name, made)
        found = self.expression(value)
        if name in self.types and name in self.changed:
            return Assign(Name(name), found)
        self.types[name] = self.type(found)
        return (
            Variable(name, self.types[name], found)
            if name in self.changed
            else Let(name, found, self.types[name])
        )

    def zeros(self, node: ast.expr) -> Type | None:
        if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name):
            return None
        if node.func.id == "array":
            return Array(Real(), tuple(_whole(arg) for arg in node.args))
        return Record(node.func.id) if node.func.id in self.structures else None

    def loop(self, node: ast.For, index: str) -> For:
        call = node.iter
        down = _called(call) == "reversed"
        if down:
            assert isinstance(call, ast.Call)
            call = call.args[0]
        if not isinstance(call, ast.Call) or _called(call) != "range" or len(call.args) > 2:
            raise self.error(node.iter, "range(...) or reversed(range(...))")
        self.types[index] = Integer()
        ends = [self.expression(arg) for arg in call.args]
        first, last = (Number(0), *ends)[-2:]
        if down:
            first, last = _less_one(last), _less_one(first)
        return For(index, first, last, self.body(node.body), down)

    # ------------------------------------------------------------ expressions

    def expression(self, node: ast.expr) -> Expression:
        match node:
            case ast.Constant(value=bool()):
                raise self.error(node, "a number")
            case ast.Constant(value=int() | float() as number):
                return Number(number)
            case ast.Name(id=name):
                return Constant(name) if name in (*INTEGERS, *NAMES) else Name(name)
            case ast.Attribute():
                return Member(self.expression(node.value), node.attr)
            case ast.Subscript():
                return self.element(node)
            case ast.UnaryOp(op=ast.USub()):
                return Negative(self.expression(node.operand))
            case ast.BinOp():
                return self.binary(node)
            case ast.Compare() if len(node.ops) == 1:
                operator = _COMPARISONS[type(node.ops[0])]
                return Compare(operator, self.expression(node.left), self.expression(node.comparators[0]))
            case ast.Call():
                return self.call(node)
        raise self.error(node, "an expression that every language has")

    def element(self, node: ast.Subscript) -> Element:
        index = self.expression(node.slice)
        owner = self.expression(node.value)
        if isinstance(owner, Element):
            return Element(owner.array, (*owner.index, index))
        return Element(owner, (index,))

    def binary(self, node: ast.BinOp) -> Expression:
        left, right = self.expression(node.left), self.expression(node.right)
        if isinstance(node.op, ast.BitAnd):
            return Both(left, right)
        if isinstance(node.op, ast.BitOr):
            return Either(left, right)
        if type(node.op) not in _OPERATORS:
            raise self.error(node, "one of + - * / & |")
        return Binary(_OPERATORS[type(node.op)], left, right)

    def call(self, node: ast.Call) -> Expression:
        name = _called(node)
        arguments = tuple(self.expression(arg) for arg in node.args)
        if name == "where":
            return Select(*arguments)
        if name not in BUILT_IN and name not in self.functions:
            raise self.error(node, "a function of the program")
        changes = name in self.functions and any(each.changed for each in self.functions[name].arguments)
        if changes and node is not self.whole:
            raise self.error(node, "a statement of its own for a call that changes an argument")
        return Call(name, arguments)

    def type(self, value: Expression) -> Type:
        match value:
            case Number(number):
                return Real() if isinstance(number, float) else Integer()
            case Constant(name):
                return Integer() if name in INTEGERS else Real()
            case Name(name):
                return self.types[name]
            case Member(owner, name):
                record = self.type(owner)
                assert isinstance(record, Record)
                return next(f.type for f in self.structures[record.name].members if f.name == name)
            case Element(array):
                found = self.type(array)
                assert isinstance(found, Array)
                return found.item
            case Negative(inner):
                return self.type(inner)
            case Binary(_, left, right):
                return Real() if Real() in (self.type(left), self.type(right)) else Integer()
            case Compare() | Both() | Either():
                return Truth()
            case Select(_, yes):
                return self.type(yes)
            case Call(name):
                result = BUILT_IN[name] if name in BUILT_IN else self.functions[name].result
                assert result is not None
                return result
        raise AssertionError(value)


def _changed(tree: ast.FunctionDef, functions: Mapping[str, Function]) -> set[str]:
    """Names that are assigned to more than once, in part, or by a function that changes them."""
    seen: set[str] = set()
    found: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Assign):
            target = node.targets[0]
            name = _root(target)
            if not isinstance(target, ast.Name) or name in seen:
                found.add(name)
            seen.add(name)
        if isinstance(node, ast.Call) and _called(node) in functions:
            arguments = functions[_called(node)].arguments
            found |= {_root(arg) for arg, to in zip(node.args, arguments, strict=True) if to.changed}
    return found


def _is_none(node: ast.expr | None) -> bool:
    return node is None or (isinstance(node, ast.Constant) and node.value is None)


def _root(node: ast.expr) -> str:
    while isinstance(node, ast.Attribute | ast.Subscript):
        node = node.value
    return node.id if isinstance(node, ast.Name) else ""


def _called(node: ast.expr) -> str:
    return node.func.id if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) else ""


def _whole(node: ast.expr) -> int:
    assert isinstance(node, ast.Constant)
    assert isinstance(node.value, int)
    return node.value


def _less_one(value: Expression) -> Expression:
    if isinstance(value, Number):
        return Number(value.value - 1)
    return Binary("-", value, Number(1))
