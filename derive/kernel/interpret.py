"""Runs a kernel tree on values of any kind: floats, arrays, multiprecision numbers, symbols."""

import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any

from .constants import INTEGERS
from .nodes import (
    Array,
    Assign,
    Binary,
    Both,
    Break,
    Call,
    Comment,
    Compare,
    Constant,
    Do,
    Either,
    Element,
    Expression,
    For,
    Function,
    If,
    Let,
    Member,
    Name,
    Negative,
    Not,
    Number,
    Program,
    Record,
    Return,
    Select,
    Statement,
    Type,
    Variable,
)


@dataclass(frozen=True)
class Arithmetic:
    """What an interpreter needs of a kind of number besides its operators.

    number: from a literal; constants: EPSILON, MAX and others by name; where: the selection; both, either: of
    tests.
    """

    number: Callable[[int | float], Any]
    constants: Mapping[str, Any]
    sqrt: Callable[[Any], Any]
    size: Callable[[Any], Any] = abs
    larger: Callable[[Any, Any], Any] = lambda one, other: one if one > other else other
    where: Callable[[Any, Any, Any], Any] = lambda test, yes, no: yes if test else no
    anywhere: Callable[[Any], bool] = bool
    both: Callable[[Any, Any], Any] = operator.and_
    either: Callable[[Any, Any], Any] = operator.or_


class _Left(Exception):  # noqa: N818
    """A loop has ended early."""


class _Finished(Exception):  # noqa: N818
    def __init__(self, value: Any) -> None:
        self.value = value


_COMPARE: dict[str, Callable[[Any, Any], Any]] = {
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
    "==": operator.eq,
    "!=": operator.ne,
}
_ARITHMETIC: dict[str, Callable[[Any, Any], Any]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
}


@dataclass(frozen=True)
class Interpreter:
    """Runs the functions of a program in one arithmetic.

    A structure is a ``SimpleNamespace``, an array a list, or lists of lists.
    """

    program: Program
    arithmetic: Arithmetic

    def run(self, name: str, *arguments: Any) -> Any:
        """Result of a function of the program; arguments that it changes are changed."""
        function = self.program.function(name)
        known = dict(zip((each.name for each in function.arguments), arguments, strict=True))
        return self._body(function, known)

    def zero(self, kind: Type) -> Any:
        """A value of this type with zeros."""
        if isinstance(kind, Array):
            count, *others = kind.dims
            inner = Array(kind.item, tuple(others)) if others else kind.item
            return [self.zero(inner) for _ in range(count)]
        if isinstance(kind, Record):
            members = self.program.structure(kind.name).members
            return SimpleNamespace(**{each.name: self.zero(each.type) for each in members})
        return self.arithmetic.number(0)

    def _body(self, function: Function, known: dict[str, Any]) -> Any:
        try:
            self._run(function.body, known)
        except _Finished as result:
            return result.value
        return None

    def _run(self, body: tuple[Statement, ...], known: dict[str, Any]) -> None:
        for each in body:
            match each:
                case Let(name, value):
                    known[name] = self._kept(each, self._value(value, known), known)
                case Variable(name, kind, value):
                    found = self.zero(kind) if value is None else self._value(value, known)
                    known[name] = self._kept(each, found, known)
                case Assign(target, value):
                    self._store(target, self._kept(each, self._value(value, known), known), known)
                case For():
                    self._loop(each, known)
                case If(test, inner, otherwise):
                    holds = self.arithmetic.anywhere(self._value(test, known))
                    self._run(inner if holds else otherwise, known)
                case Do(call):
                    self._value(call, known)
                case Return(value):
                    raise _Finished(None if value is None else self._value(value, known))
                case Break():
                    raise _Left
                case Comment():
                    pass

    def _kept(self, statement: Let | Variable | Assign, value: Any, known: dict[str, Any]) -> Any:
        """What a statement stores."""
        return value

    def _loop(self, loop: For, known: dict[str, Any]) -> None:
        first, last = self._value(loop.first, known), self._value(loop.last, known)
        for index in range(first, last, -1 if loop.down else 1):
            known[loop.index] = index
            try:
                self._run(loop.body, known)
            except _Left:
                return

    def _store(self, target: Expression, value: Any, known: dict[str, Any]) -> None:
        match target:
            case Name(name):
                known[name] = value
            case Member(owner, name):
                setattr(self._value(owner, known), name, value)
            case Element(array, index):
                self._put(self._value(array, known), [self._value(each, known) for each in index], value)

    def _value(self, value: Expression, known: dict[str, Any]) -> Any:
        of = self._value
        match value:
            case Number(number):
                return number if isinstance(number, int) else self.arithmetic.number(number)
            case Constant(name):
                return INTEGERS[name][0] if name in INTEGERS else self.arithmetic.constants[name]
            case Name(name):
                return known[name]
            case Member(owner, name):
                return getattr(of(owner, known), name)
            case Element(array, index):
                return self._at(of(array, known), [of(each, known) for each in index])
            case Not(inner):
                return self.arithmetic.where(of(inner, known), False, True)
            case Negative(inner):
                return -of(inner, known)
            case Binary(operator, left, right):
                return _ARITHMETIC[operator](of(left, known), of(right, known))
            case Compare(operator, left, right):
                return _COMPARE[operator](of(left, known), of(right, known))
            case Both(left, right):
                return self.arithmetic.both(of(left, known), of(right, known))
            case Either(left, right):
                return self.arithmetic.either(of(left, known), of(right, known))
            case Select(test, yes, no):
                return self._select(of(test, known), of(yes, known), of(no, known))
            case Call(name, arguments):
                found = [of(each, known) for each in arguments]
                built_in = getattr(self.arithmetic, name, None)
                return self.run(name, *found) if built_in is None else built_in(*found)

    def _at(self, array: Any, index: list[Any]) -> Any:
        """An element; where poses side by side differ in it, a selection."""
        if not index:
            return array
        first, *others = index
        if isinstance(first, int):
            return self._at(array[first], others)
        found, *more = (self._at(each, others) for each in array)
        for i, each in enumerate(more, 1):
            found = self._select(first == i, each, found)
        return found

    def _put(self, array: Any, index: list[Any], value: Any) -> None:
        first, *others = index
        if others and isinstance(first, int):
            self._put(array[first], others, value)
        elif isinstance(first, int):
            array[first] = value
        else:
            for i, each in enumerate(array):
                self._put(array, [i, *others], self._select(first == i, value, self._at(each, others)))

    def _select(self, test: Any, yes: Any, no: Any) -> Any:
        if isinstance(yes, SimpleNamespace):
            parts = {name: self._select(test, part, getattr(no, name)) for name, part in vars(yes).items()}
            return SimpleNamespace(**parts)
        if isinstance(yes, list):
            return [self._select(test, one, other) for one, other in zip(yes, no, strict=True)]
        return self.arithmetic.where(test, yes, no)
