"""Interpreter of kernel trees for values of any type: floats, arrays, multiprecision numbers, symbols."""

import operator
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from types import SimpleNamespace
from typing import Any

from . import nodes as t
from .constants import INTEGERS


@dataclass(frozen=True)
class Arithmetic:
    """Functions of a type of numbers, in addition to its operators, that an interpreter requires.

    ``number`` converts a literal. ``constants`` are EPSILON, MAX, and others by name. ``both`` and ``either``
    combine tests. ``where`` selects by a test that is not a ``bool`` and evaluates both sides; it is None if
    every test is true or false, so that only one side is evaluated.
    """

    number: Callable[[int | float], Any]
    constants: Mapping[str, Any]
    sqrt: Callable[[Any], Any]
    size: Callable[[Any], Any] = abs
    larger: Callable[[Any, Any], Any] = lambda one, other: one if one > other else other
    where: Callable[[Any, Any, Any], Any] | None = None
    anywhere: Callable[[Any], bool] = bool
    both: Callable[[Any, Any], Any] = operator.and_
    either: Callable[[Any, Any], Any] = operator.or_


_OPERATORS: dict[str, Callable[[Any, Any], Any]] = {
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
    "==": operator.eq,
    "!=": operator.ne,
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
}
_BUILT_IN = ("sqrt", "size", "larger", "anywhere")

Known = dict[str, Any]
_Value = Callable[[Known], Any]
_Action = Callable[[Known], Any]
"""None where the next statement follows, else how the function or the loop ends."""
_LEFT = object()


@dataclass(frozen=True)
class _Result:
    value: Any


@dataclass(frozen=True)
class Interpreter:
    """Interpreter of the functions of a program in one arithmetic.

    A structure is a ``SimpleNamespace``, and an array a list or a list of lists. ``instead`` are replacements
    of functions by name.
    """

    program: t.Program
    arithmetic: Arithmetic
    instead: Mapping[str, Callable[..., Any]] = field(default_factory=dict)
    _bodies: dict[str, _Action] = field(default_factory=dict, init=False, repr=False, compare=False)

    def run(self, name: str, *arguments: Any) -> Any:
        """Run a function of the program and return its result; changed arguments are changed."""
        function = self.program.function(name)
        return self._call(function, self._known(function, arguments))

    @staticmethod
    def _known(function: t.Function, arguments: tuple[Any, ...]) -> Known:
        return dict(zip((each.name for each in function.arguments), arguments, strict=True))

    def _call(self, function: t.Function, known: Known) -> Any:
        body = self._bodies.get(function.name)
        if body is None:
            body = self._bodies[function.name] = self._run(function.body)
        result = body(known)
        return result.value if isinstance(result, _Result) else None

    def zero(self, kind: t.Type) -> Any:
        """Return a value of this type that contains zeros."""
        return self._zeros(kind)()

    # ------------------------------------------------------------ statements, made into functions once

    def _run(self, body: Sequence[t.Statement]) -> _Action:
        actions = [self._action(each) for each in body if not isinstance(each, t.Comment)]

        def run(known: Known) -> Any:
            for action in actions:
                if (end := action(known)) is not None:
                    return end
            return None

        return run

    def _action(self, statement: t.Statement) -> _Action:
        match statement:
            case t.Let() | t.Variable() | t.Assign():
                return self._stored(statement)
            case t.For():
                return self._loop(statement)
            case t.If(test, body, otherwise):
                holds, yes, no = self._value(test), self._run(body), self._run(otherwise)
                anywhere = self.arithmetic.anywhere
                return lambda known: (yes if anywhere(holds(known)) else no)(known)
            case t.Do(call):
                called = self._value(call)

                def done(known: Known) -> None:
                    called(known)

                return done
            case t.Return(value):
                result = self._value(value) if value is not None else lambda known: None
                return lambda known: _Result(result(known))
            case t.Break():
                return lambda known: _LEFT
        raise ValueError(f"statement: expected one without macros, got {type(statement).__name__}")

    def _stored(self, statement: t.Let | t.Variable | t.Assign) -> _Action:
        target = statement.target if isinstance(statement, t.Assign) else t.Name(statement.name)
        found, kept, store = self._first(statement), self._kept, self._store(target)

        def action(known: Known) -> None:
            store(known, kept(statement, found(known), known))

        return action

    def _first(self, statement: t.Let | t.Variable | t.Assign) -> _Value:
        if not isinstance(statement, t.Variable) or statement.value is not None:
            assert statement.value is not None
            return self._value(statement.value)
        make = self._zeros(statement.type)
        return lambda known: make()

    def _zeros(self, kind: t.Type) -> Callable[[], Any]:
        """Return a function that creates zeros of this type."""
        zero = self.arithmetic.number(0)
        return lambda: filled(self.program, kind, lambda *_: zero)

    def _kept(self, statement: t.Let | t.Variable | t.Assign, value: Any, known: Known) -> Any:
        """Return the value that a statement stores."""
        return value

    def _loop(self, loop: t.For) -> _Action:
        first, last, step = self._value(loop.first), self._value(loop.last), self._value(loop.step)
        body, index = self._run(loop.body), loop.index

        def action(known: Known) -> Any:
            for at in range(first(known), last(known), -1 if loop.down else step(known)):
                known[index] = at
                if (end := body(known)) is not None:
                    return None if end is _LEFT else end
            return None

        return action

    def _store(self, target: t.Expression) -> Callable[[Known, Any], None]:
        match target:
            case t.Name(name):
                return lambda known, value: known.__setitem__(name, value)
            case t.Member(owner, name):
                of = self._value(owner)
                return lambda known, value: setattr(of(known), name, value)
            case t.Element(array, index):
                held, parts = self._value(array), [self._value(each) for each in index]
                return lambda known, value: self._put(held(known), [part(known) for part in parts], value)
        raise ValueError(f"target: expected a name, a member or an element, got {type(target).__name__}")

    # ------------------------------------------------------------ expressions

    def _value(self, value: t.Expression) -> _Value:
        of = self._value
        match value:
            case t.Number(number):
                constant = number if isinstance(number, int) else self.arithmetic.number(number)
                return lambda known: constant
            case t.Constant(name):
                known = self.arithmetic.constants
                named = INTEGERS[name][0] if name in INTEGERS and name not in known else known[name]
                return lambda known: named
            case t.Name(name):
                return operator.itemgetter(name)
            case t.Member(owner, name):
                held = of(owner)
                return lambda known: getattr(held(known), name)
            case t.Element(array, index):
                return self._element(of(array), [of(each) for each in index])
            case t.As(kind, inner):
                plain, made = of(inner), self.arithmetic.number
                return (lambda known: made(plain(known))) if kind == t.Real() else plain
            case t.Not(inner):
                holds = of(inner)
                return lambda known: self._select(holds(known), lambda _: False, lambda _: True, known)
            case t.Negative(inner):
                plain = of(inner)
                return lambda known: -plain(known)
            case t.Binary(sign, left, right):
                of_tests = {"&": self.arithmetic.both, "|": self.arithmetic.either}
                operation, one, other = (_OPERATORS | of_tests)[sign], of(left), of(right)
                return lambda known: operation(one(known), other(known))
            case t.Select(test, yes, no):
                holds, one, other = of(test), of(yes), of(no)
                return lambda known: self._select(holds(known), one, other, known)
            case t.Call(name, arguments):
                called, given = self._called(name), [of(each) for each in arguments]
                return lambda known: called(*[each(known) for each in given])
        raise ValueError(f"expression: expected one without addresses, got {type(value).__name__}")

    def _called(self, name: str) -> Callable[..., Any]:
        if name in self.instead:
            return self.instead[name]
        return getattr(self.arithmetic, name) if name in _BUILT_IN else partial(self.run, name)

    def _element(self, array: _Value, index: Sequence[_Value]) -> _Value:
        if len(index) == 1:
            (only,) = index

            def one(known: Known) -> Any:
                held, at = array(known), only(known)
                return held[at] if isinstance(at, int) else self._at(held, [at])

            return one
        return lambda known: self._at(array(known), [each(known) for each in index])

    def _at(self, array: Any, index: list[Any]) -> Any:
        """Return an element; if poses side by side have different indices, a selection."""
        if not index:
            return array
        first, *others = index
        if isinstance(first, int):
            return self._at(array[first], others)
        found, *more = (self._at(each, others) for each in array)
        for i, each in enumerate(more, 1):
            found = self._selected(first == i, each, found)
        return found

    def _put(self, array: Any, index: list[Any], value: Any) -> None:
        first, *others = index
        if others and isinstance(first, int):
            self._put(array[first], others, value)
        elif isinstance(first, int):
            array[first] = value
        else:
            for i, each in enumerate(array):
                self._put(array, [i, *others], self._selected(first == i, value, self._at(each, others)))

    def _select(self, test: Any, yes: _Value, no: _Value, known: Known) -> Any:
        """Select one of two values; if the test is decided, the other one is not evaluated."""
        if isinstance(test, bool) or self.arithmetic.where is None:
            return (yes if test else no)(known)
        return self._selected(test, yes(known), no(known))

    def _selected(self, test: Any, yes: Any, no: Any) -> Any:
        if isinstance(yes, SimpleNamespace):
            parts = {name: self._selected(test, part, getattr(no, name)) for name, part in vars(yes).items()}
            return SimpleNamespace(**parts)
        if isinstance(yes, list):
            return [self._selected(test, one, other) for one, other in zip(yes, no, strict=True)]
        where = self.arithmetic.where
        return (yes if test else no) if where is None else where(test, yes, no)


def filled(program: t.Program, kind: t.Type, number: Callable[[str, t.Type], Any], name: str = "") -> Any:
    """Return a value of this type; ``number`` creates a number from the name and type of a member."""
    if isinstance(kind, t.Array):
        count, *others = kind.dims
        inner = t.Array(kind.item, tuple(others)) if others else kind.item
        return [filled(program, inner, number, name) for _ in range(count)]
    if isinstance(kind, t.Record):
        members = program.structure(kind.name).members
        return SimpleNamespace(
            **{each.name: filled(program, each.type, number, each.name) for each in members}
        )
    return number(name, kind)
