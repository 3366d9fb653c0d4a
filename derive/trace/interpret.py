"""Interpreter of kernel trees for values of any type: floats, arrays, multiprecision numbers, symbols."""

import operator
from collections.abc import Callable, Iterable, Mapping, Sequence
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


_BUILT_IN = ("sqrt", "size", "larger", "anywhere", "both", "either", "number")


@dataclass(frozen=True)
class Interpreter:
    """Interpreter of the functions of a program in one arithmetic.

    A structure is a ``SimpleNamespace``, and an array a list or a list of lists. ``instead`` are replacements
    of functions by name. A function is printed as Python code when it is called for the first time. All names
    except variables have a leading underscore in this code.
    """

    program: t.Program
    arithmetic: Arithmetic
    instead: Mapping[str, Callable[..., Any]] = field(default_factory=dict)
    _names: dict[str, Any] = field(default_factory=dict, init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        functions = {name: getattr(self.arithmetic, name) for name in _BUILT_IN} | dict(self.instead)
        self._names.update({f"_{name}": function for name, function in functions.items()})
        self._names.update(_self=self, _zero=self.arithmetic.number(0), namespace=SimpleNamespace)

    def run(self, name: str, *arguments: Any) -> Any:
        """Run a function of the program and return its result; changed arguments are changed."""
        if name not in self._names:
            self._define(self.program.function(name))
        return self._names[name](*arguments)

    def _define(self, function: t.Function) -> None:
        """Compile a function; the functions that it calls are compiled when they are called."""
        head = f"def {function.name}({', '.join(each.name for each in function.arguments)}):"
        text = "\n".join([head, *self._body(function.body, " ")])
        for each in t.calls_in(function.body):
            self._names.setdefault(f"_{each.function}", partial(self.run, each.function))
        exec(text, self._names)

    # ------------------------------------------------------------ statements

    def _body(self, body: Iterable[t.Statement], before: str) -> list[str]:
        lines = [line for each in body for line in self._statement(each, before)]
        return lines or [f"{before}pass"]

    def _statement(self, statement: t.Statement, before: str) -> list[str]:
        text, more = self._text, f"{before} "
        match statement:
            case t.Comment():
                return []
            case t.Let(name, value):
                return [f"{before}{name} = {self._kept(t.Name(name), text(value))}"]
            case t.Variable(name, kind, value):
                first = self._zeros(kind) if value is None else self._kept(t.Name(name), text(value))
                return [f"{before}{name} = {first}"]
            case t.Assign(t.Element(array, index) as target, value) if not self._plain(index):
                kept = self._kept(target, text(value))
                return [f"{before}_self._put({text(array)}, {self._list(index)}, {kept})"]
            case t.Assign(target, value):
                return [f"{before}{text(target)} = {self._kept(target, text(value))}"]
            case t.For(index, first, last, body, down, _, step):
                by = "-1" if down else text(step)
                loop = f"{before}for {index} in range({text(first)}, {text(last)}, {by}):"
                return [loop, *self._body(body, more)]
            case t.If(test, body, otherwise):
                yes, no = self._body(body, more), self._body(otherwise, more)
                return [f"{before}if _anywhere({text(test)}):", *yes, f"{before}else:", *no]
            case t.Do(call):
                return [f"{before}{text(call)}"]
            case t.Return(value):
                return [f"{before}return {'' if value is None else text(value)}"]
            case t.Break():
                return [f"{before}break"]
        raise ValueError(f"statement: expected one without macros, got {type(statement).__name__}")

    def _zeros(self, kind: t.Type) -> str:
        # Python prints a SimpleNamespace as a call.
        return str(filled(self.program, kind, lambda *_: "_zero")).replace("'", "")

    def _kept(self, target: t.Expression, value: str) -> str:
        """Print the value that a statement stores."""
        return value

    # ------------------------------------------------------------ expressions

    def _text(self, value: t.Expression) -> str:
        text = self._text
        match value:
            case t.Number(number):
                whole = isinstance(number, int)
                return str(number) if whole else self._constant(self.arithmetic.number(number))
            case t.Constant(name):
                known = self.arithmetic.constants
                return self._constant(known[name] if name in known else INTEGERS[name][0])
            case t.Name(name):
                return name
            case t.Member(owner, name):
                return f"{text(owner)}.{name}"
            case t.Element(array, index) if self._plain(index):
                return text(array) + "".join(f"[{text(each)}]" for each in index)
            case t.Element(array, index):
                return f"_self._at({text(array)}, {self._list(index)})"
            case t.As(kind, inner):
                return f"_number({text(inner)})" if kind == t.Real() else text(inner)
            case t.Not(inner):
                return self._selection(text(inner), "False", "True")
            case t.Negative(inner):
                return f"(-{text(inner)})"
            case t.Binary("&" | "|" as sign, left, right):
                return f"{'_both' if sign == '&' else '_either'}({text(left)}, {text(right)})"
            case t.Binary(sign, left, right):
                return f"({text(left)} {sign} {text(right)})"
            case t.Select(test, yes, no):
                return self._selection(text(test), text(yes), text(no))
            case t.Call(name, arguments):
                return f"_{name}({', '.join(map(text, arguments))})"
        raise ValueError(f"expression: expected one without addresses, got {type(value).__name__}")

    def _constant(self, value: Any) -> str:
        name = f"_{len(self._names)}"
        self._names[name] = value
        return name

    def _list(self, index: Sequence[t.Expression]) -> str:
        return f"[{', '.join(map(self._text, index))}]"

    def _plain(self, index: Sequence[t.Expression]) -> bool:
        """Return True if the poses have the same index."""
        return self.arithmetic.where is None or all(isinstance(each, t.Number) for each in index)

    def _selection(self, test: str, yes: str, no: str) -> str:
        if self.arithmetic.where is None:
            return f"({yes} if {test} else {no})"
        return f"_self._select({test}, lambda: {yes}, lambda: {no})"

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

    def _select(self, test: Any, yes: Callable[[], Any], no: Callable[[], Any]) -> Any:
        """Select one of two values; if the test is decided, the other one is not evaluated."""
        if isinstance(test, bool):
            return (yes if test else no)()
        return self._selected(test, yes(), no())

    def _selected(self, test: Any, yes: Any, no: Any) -> Any:
        if isinstance(yes, SimpleNamespace):
            parts = {name: self._selected(test, part, getattr(no, name)) for name, part in vars(yes).items()}
            return SimpleNamespace(**parts)
        if isinstance(yes, list):
            return [self._selected(test, one, other) for one, other in zip(yes, no, strict=True)]
        where = self.arithmetic.where
        assert where is not None
        return where(test, yes, no)


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
