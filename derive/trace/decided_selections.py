"""Removal of selections that an enclosing condition has decided, in functions of one pose.

The same text computes one pose or many poses side by side. If ``anywhere(test)`` opens a branch, the branch
selects by ``test`` again. For one pose, this selection always returns its first value.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from . import nodes as t

Known = Mapping[t.Expression, bool]
"""Tests of variables that are not addresses, with their results."""

_PLAIN = (t.Name, t.Number, t.Constant, t.Binary, t.Not)


def of_one_pose(program: t.Program) -> t.Program:
    """Return the program for one pose, without decided selections."""
    return replace(program, functions=tuple(map(settled, program.functions)))


def settled(function: t.Function) -> t.Function:
    """Return the function without selections that an enclosing condition decides."""
    return replace(function, body=_body(function.body, {}))


def _body(body: Iterable[t.Statement], known: Known) -> tuple[t.Statement, ...]:
    made: list[t.Statement] = []
    for node in body:
        made.append(_statement(node, known))
        known = _kept(known, [node])
    return tuple(made)


def _statement(node: t.Statement, known: Known) -> t.Statement:
    if isinstance(node, t.For):
        inside = _kept(known, [node])
        return replace(node, body=_body(node.body, inside))
    if isinstance(node, t.If):
        test = _in(node.test, known)
        branches = ((node.body, True), (node.otherwise, False))
        yes, no = (_body(part, {**known, **_decided(test, holds)}) for part, holds in branches)
        return replace(node, test=test, body=yes, otherwise=no)
    found: t.Statement = _in(node, known)
    return found


def _in(node: Any, known: Known) -> Any:
    """Return an expression or statement with decided selections replaced."""
    if isinstance(node, tuple):
        return tuple(_in(each, known) for each in node)
    if isinstance(node, t.Select) and node.test in known:
        return _in(node.yes if known[node.test] else node.no, known)
    return t.mapped(node, lambda part: _in(part, known)) if isinstance(node, t.Node) else node


def _decided(test: t.Expression, holds: bool) -> dict[t.Expression, bool]:
    """Return the tests that are decided if a test is true, or false."""
    if isinstance(test, t.Call) and test.function == "anywhere":
        return _decided(test.arguments[0], holds)
    if not all(isinstance(each, _PLAIN) for each in t.parts_of(test)):
        return {}
    found = {test: holds}
    if isinstance(test, t.Binary) and test.operator == ("&" if holds else "|"):
        found |= _decided(test.left, holds) | _decided(test.right, holds)
    return found


def _kept(known: Known, body: Iterable[t.Statement]) -> Known:
    """Return the decided tests that are still valid after statements that may change variables."""
    written = _written(body) if known else set()
    return {test: holds for test, holds in known.items() if not written & {n.name for n in t.names_in(test)}}


def _written(body: Iterable[t.Statement]) -> set[str]:
    """Return the variables that statements may change: assigned, defined, or passed to a function."""
    found: set[str] = set()
    for node in t.parts_of(tuple(body)):
        if isinstance(node, t.Let | t.Variable):
            found.add(node.name)
        elif isinstance(node, t.For):
            found.add(node.index)
        elif isinstance(node, t.Assign):
            found |= {each.name for each in t.names_in(node.target)}
    calls = (call for call in t.calls_in(tuple(body)) if call.function not in t.BUILT_IN)
    return found | {each.name for call in calls for each in t.names_in(call.arguments)}
