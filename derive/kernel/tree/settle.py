"""Selections whose test an enclosing condition has decided, in functions of one pose.

One text serves one pose and many side by side: where ``anywhere(test)`` opens a branch, it selects by
``test`` again. Of one pose the selection is its first value.
"""

from collections.abc import Iterable, Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any

from .nodes import (
    BUILT_IN,
    Assign,
    Binary,
    Both,
    Call,
    Compare,
    Constant,
    Either,
    Expression,
    For,
    Function,
    If,
    Let,
    Name,
    Not,
    Number,
    Program,
    Select,
    Statement,
    Switch,
    Variable,
    calls_in,
    names_in,
    parts_of,
)

Known = Mapping[Expression, bool]
"""Tests of variables that are no addresses, and whether they hold."""

_PLAIN = (Name, Number, Constant, Binary, Compare, Both, Either, Not)


def of_one_pose(program: Program) -> Program:
    """The program for one pose, without selections that are decided."""
    return replace(program, functions=tuple(map(settled, program.functions)))


def settled(function: Function) -> Function:
    """The function without selections that a condition around them decides."""
    return replace(function, body=_body(function.body, {}))


def _body(body: Iterable[Statement], known: Known) -> tuple[Statement, ...]:
    made: list[Statement] = []
    for node in body:
        made.append(_statement(node, known))
        known = _kept(known, [node])
    return tuple(made)


def _statement(node: Statement, known: Known) -> Statement:
    if isinstance(node, For):
        inside = _kept(known, [node])
        return replace(node, body=_body(node.body, inside))
    if isinstance(node, If):
        test = _in(node.test, known)
        yes, no = (_body(part, {**known, **_decided(test, holds)}) for part, holds in _branches(node))
        return replace(node, test=test, body=yes, otherwise=no)
    if isinstance(node, Switch):
        yes, no = (_body(part, known) for part in (node.body, node.otherwise))
        return replace(node, body=yes, otherwise=no)
    found: Statement = _in(node, known)
    return found


def _branches(node: If) -> tuple[tuple[tuple[Statement, ...], bool], ...]:
    return (node.body, True), (node.otherwise, False)


def _in(node: Any, known: Known) -> Any:
    """An expression or statement with what is known put in place of selections."""
    if isinstance(node, tuple):
        return tuple(_in(each, known) for each in node)
    if isinstance(node, Select) and node.test in known:
        return _in(node.yes if known[node.test] else node.no, known)
    if is_dataclass(node) and not isinstance(node, type):
        return replace(node, **{each.name: _in(getattr(node, each.name), known) for each in fields(node)})
    return node


def _decided(test: Expression, holds: bool) -> dict[Expression, bool]:
    """What a test says that holds, or does not."""
    if isinstance(test, Call) and test.function == "anywhere":
        return _decided(test.arguments[0], holds)
    if not all(isinstance(each, _PLAIN) for each in parts_of(test)):
        return {}
    found = {test: holds}
    if isinstance(test, Both if holds else Either):
        found |= _decided(test.left, holds) | _decided(test.right, holds)
    return found


def _kept(known: Known, body: Iterable[Statement]) -> Known:
    """What is known yet where these statements may have changed variables."""
    written = _written(body) if known else set()
    return {test: holds for test, holds in known.items() if not written & {n.name for n in names_in(test)}}


def _written(body: Iterable[Statement]) -> set[str]:
    """Variables that statements may change: what they assign to or define, or hand to a function."""
    found: set[str] = set()
    for node in parts_of(tuple(body)):
        if isinstance(node, Let | Variable):
            found.add(node.name)
        elif isinstance(node, For):
            found.add(node.index)
        elif isinstance(node, Assign):
            found |= {each.name for each in names_in(node.target)}
    calls = (call for call in calls_in(tuple(body)) if call.function not in BUILT_IN)
    return found | {each.name for call in calls for each in names_in(call.arguments)}
