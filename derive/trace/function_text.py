"""Texts of written functions: replacement of names, changed variables, and roots of element expressions."""

import ast
import inspect
import textwrap
from collections.abc import Callable, Mapping
from functools import cache
from typing import Any, cast

from . import nodes as t

Names = Mapping[str, str | int]
"""Replacements of names in a text by other names or numbers, so that several functions use one text."""


def parsed(written: Callable[..., Any], names: Names) -> ast.FunctionDef:
    """Return the Python tree of a function with replaced names."""
    tree = ast.parse(_source(written)).body[0]
    assert isinstance(tree, ast.FunctionDef)
    for each in tree.args.args:
        each.annotation = _quoted(each.annotation, names)
        each.arg = str(names.get(each.arg, each.arg))
    tree.returns = _quoted(tree.returns, names)
    made = _Renamed(names).visit(tree)
    assert isinstance(made, ast.FunctionDef)
    return made


@cache
def _source(written: Callable[..., Any]) -> str:
    """Return the text of a function, cached because many kernels read the same one."""
    return textwrap.dedent(inspect.getsource(written))


def _quoted(node: ast.expr | None, names: Names) -> ast.expr | None:
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return cast("ast.expr", _Renamed(names).visit(ast.parse(node.value, mode="eval").body))
    return node


class _Renamed(ast.NodeTransformer):
    """Replacement of names, also at the end of other names: ``solve_WIDTH`` becomes ``solve_24``."""

    def __init__(self, names: Names) -> None:
        self.names = names

    def visit_Name(self, node: ast.Name) -> ast.expr:
        """Replace a name by a name or a number."""
        if isinstance(value := self.names.get(node.id), int):
            return ast.Constant(value)
        name = node.id if value is None else value
        for key, number in self.names.items():
            if isinstance(number, int) and name.endswith(f"_{key}"):
                name = f"{name.removesuffix(key)}{number}"
        return ast.Name(name, node.ctx) if name.isidentifier() else ast.parse(name, mode="eval").body


class Filled(ast.NodeTransformer):
    """Replacement of names by expressions."""

    def __init__(self, values: Mapping[str, ast.expr]) -> None:
        """Store the expressions by the names that they replace."""
        self.values = values

    def visit_Name(self, node: ast.Name) -> ast.expr:
        """Replace a name by an expression."""
        return self.values.get(node.id, node)


def changed_names(
    body: tuple[t.Statement, ...],
    functions: Mapping[str, t.Function],
    is_address: Callable[[t.Expression], bool],
) -> set[str]:
    """Return names that are assigned again, in part, or by a function that changes them."""
    found: set[str] = set()
    for each in t.statements(body):
        if isinstance(each, t.Assign):
            found.add(root_of(each.target))
    for call in t.calls_in(body):
        arguments = functions[call.function].arguments if call.function in functions else ()
        pairs = zip(call.arguments, arguments, strict=False)
        found |= {root_of(value) for value, to in pairs if to.changed and not is_address(value)}
    return found


def with_variables(node: Any, changed: set[str]) -> Any:
    """Return a body in which constants that are changed later are variables."""
    match node:
        case tuple():
            return tuple(with_variables(each, changed) for each in node)
        case t.Let(name, value, kind) if name in changed:
            return t.Variable(name, kind, value)
        case t.For() | t.If():
            return t.mapped(node, lambda part: with_variables(part, changed))
    return node


def root_of(node: t.Expression) -> str:
    """Return the name of the variable to which an element or member belongs."""
    while isinstance(node, t.Member | t.Element | t.From | t.Select):
        if isinstance(node, t.Select):
            node = node.yes
        else:
            node = node.owner if isinstance(node, t.Member) else node.array
    return node.name if isinstance(node, t.Name) else ""


def base_of(node: ast.expr) -> str:
    """Return the name of the variable to which an element or member of Python's tree belongs."""
    while isinstance(node, ast.Attribute | ast.Subscript):
        node = node.value
    return node.id if isinstance(node, ast.Name) else ""


def called_name(node: ast.expr) -> str:
    """Return the name of the called function."""
    return node.func.id if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) else ""
