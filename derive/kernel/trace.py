"""Formulas of a kernel tree: the steps of a run on SymPy symbols.

If symbols do not decide a comparison, the run takes the regular branch: no error, no leg near its joint
singularity, no exchange of rows.
"""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any

import sympy as sp

from ..mechanics import lumped_constants
from ..mechanics import quantities as n
from ..mechanics.closed_form import terms
from ..program.block import AXES, Quantity
from ..trace.constants import constants
from ..trace.interpret import Arithmetic, Interpreter
from ..trace.nodes import Element, Expression, Member, Name, Program
from .outputs import FORWARD
from .prepare import PER_LENGTH

Steps = tuple[tuple[sp.Symbol, sp.Expr], ...]

_COMPONENTS = {len(q.keys): q.keys for q in (n.t, n.I_p, n.R)}
_DECIDED = {True: True, False: False, sp.true: True, sp.false: False}


def regular(test: Any, yes: Any, no: Any) -> Any:
    """Return the regular value of an undecided selection: the smaller status, or ``no`` for numbers."""
    if isinstance(test, bool | sp.logic.boolalg.BooleanAtom):
        return yes if _DECIDED[test] else no
    return min(yes, no) if isinstance(yes, int) and isinstance(no, int) else no


SYMBOLS = Arithmetic(
    number=lambda value: sp.Integer(int(value)) if value == int(value) else sp.Float(value),
    constants={name: sp.Float(value) for name, value in constants("double").items()} | {"NAN": sp.nan},
    sqrt=sp.sqrt,
    size=sp.Abs,
    larger=lambda one, other: other,
    where=regular,
    anywhere=lambda test: test is True or test is sp.true,
    both=lambda one, other: sp.And(one, other),
    either=lambda one, other: sp.Or(one, other),
)
"""Expressions; what is larger is of no account where nothing is checked."""


@dataclass(frozen=True)
class Trace:
    """Results and steps as formulas, values of the constants, and the arguments."""

    results: Mapping[str, sp.Matrix]
    steps: Mapping[sp.Symbol, sp.Expr]
    constants: Mapping[sp.Symbol, float]
    arguments: Mapping[str, sp.Matrix]


@dataclass(frozen=True)
class Tracer(Interpreter):
    """Interpreter on ``SYMBOLS`` that names every stored value.

    Names are the names of the derivation, followed by the number of the leg.
    """

    arithmetic: Arithmetic = SYMBOLS
    steps: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    legs: dict[int, tuple[Any, int]] = field(default_factory=dict)
    """Structures of one leg, by identity, with the leg's number."""
    _called: list[int] = field(default_factory=list, init=False, repr=False, compare=False)
    """Legs of the functions that run, or 0."""

    def traced(self, name: str, model: Any, *arguments: Any) -> Any:
        """Return the result of a public function of the program."""
        for i, leg in enumerate(model.leg):
            self.legs[id(leg)] = leg, i + 1
        return self.run(name, model, *arguments)

    def run(self, name: str, *arguments: Any) -> Any:
        """Return the result of a function; it belongs to a leg if the first argument does."""
        _, leg = self.legs.get(id(arguments[0]), (None, 0))
        self._called.append(leg)
        result = super().run(name, *arguments)
        self._called.pop()
        if leg and isinstance(result, SimpleNamespace):
            self.legs[id(result)] = result, leg
        return result

    def _kept(self, target: Expression, value: str) -> str:
        return f"_self._step({value}, {', '.join(self._label(target))})"

    def _label(self, target: Expression) -> list[str]:
        """Print the parts of the name of a step."""
        match target:
            case Element(Member(_, name) as array, (index,)):
                counted = name not in _SYMMETRIC
                return [f"{name!r}", f"_self._component({self._text(array)}, {self._text(index)}, {counted})"]
            case Element(array, index):
                return [*self._label(array), " + ".join(f"str({self._text(each)} + 1)" for each in index)]
            case Member(_, name) | Name(name):
                return [f"{name!r}"]
        raise AssertionError(target)

    @staticmethod
    def _component(array: list[Any], index: int, counted: bool) -> str:
        """Return the axes of a component, or its number if the six elements of the array are ``counted``."""
        return str(index + 1) if counted and len(array) == 6 else _axes(len(array), index)

    def _step(self, value: Any, *label: str) -> Any:
        """Return the symbol of a step with this value, or the value if it needs none."""
        if not isinstance(value, sp.Expr) or value.is_number or value.is_Atom or (-value).is_Atom:
            return value
        name = whole = _joined(*label, str(self._called[-1] or ""))
        version = 1
        while (symbol := sp.Symbol(name, real=True)) in self.steps:
            if self.steps[symbol] == value:
                return symbol
            version += 1
            name = f"{whole}_v{version}"
        self.steps[symbol] = value
        return symbol


_QUANTITIES = [
    each
    for module in (n, terms, lumped_constants)
    for each in vars(module).values()
    if isinstance(each, Quantity)
]
_SYMMETRIC = {each.name for each in _QUANTITIES if each.symmetric}


def described(constants: Iterable[str]) -> dict[str, tuple[str, str]]:
    """Return unit and meaning of the quantities to which constants belong, by name, in order."""
    of = {name: each for each in reversed(_QUANTITIES) for name in each.names}
    unit, meaning = PER_LENGTH.meaning.split(": ", 1)
    found = {}
    for name in constants:
        quantity = of.get(re.sub(r"_[1-6]$", "", name))
        if quantity is not None:
            found[quantity.name] = quantity.unit, quantity.meaning
        else:
            found[name] = unit, meaning
    return found


def needed(steps: Mapping[sp.Symbol, sp.Expr], results: Iterable[sp.Expr]) -> Steps:
    """Return the steps that results need, in order; sums and copies that only one step uses are inserted."""
    exprs = [sp.sympify(each) for each in results]
    users = dict.fromkeys(steps, 0)
    wanted = {symbol for expr in exprs for symbol in expr.free_symbols}
    for symbol in reversed(steps):
        if symbol in wanted:
            for used in steps[symbol].free_symbols & users.keys():
                users[used] += 1
            wanted |= steps[symbol].free_symbols
    given = {symbol for expr in exprs for symbol in expr.free_symbols}
    inside: dict[sp.Symbol, sp.Expr] = {}
    found = []
    for symbol, expr in steps.items():
        if symbol not in wanted:
            continue
        whole = expr.xreplace(inside)
        plain = all(term.is_Atom or (-term).is_Atom for term in sp.Add.make_args(expr.xreplace(inside)))
        if plain and users[symbol] <= 1 and symbol not in given:
            inside[symbol] = whole
        else:
            found.append((symbol, whole))
    return tuple(found)


def renamed(steps: Steps) -> dict[sp.Symbol, sp.Symbol]:
    """Give the first of several values with one name this name."""
    taken: dict[str, sp.Symbol] = {}
    for symbol, _ in steps:
        taken.setdefault(re.sub(r"_v\d+$", "", symbol.name), symbol)
    return {symbol: sp.Symbol(name, real=True) for name, symbol in taken.items() if symbol.name != name}


def trace(program: Program, function: str, model: Any) -> Trace:
    """Trace a public function of a program, with the numbers of a model or robot."""
    constants: dict[sp.Symbol, float] = {}
    named = _named("", "", [model], constants)
    arguments = {q.name: q.value for q in n.MOTION}
    given = SimpleNamespace(**{q.name: list(q.symbols) for q in n.MOTION})
    more = []
    if function == FORWARD:
        arguments["F"] = sp.Matrix(sp.symbols("F_1:7", real=True))
        more.append(list(arguments["F"]))
    tracer = Tracer(program)
    found = tracer.traced(function, named, given, *more)
    results = {name: _matrix(value) for name, value in vars(found).items() if name != "status"}
    return Trace(results, tracer.steps, constants, arguments)


def _matrix(parts: list[Any]) -> sp.Matrix:
    rows = [each if isinstance(each, list) else [each] for each in parts]
    return sp.Matrix(rows).applyfunc(lambda value: SYMBOLS.number(value) if value.is_Float else value)


def _named(name: str, leg: str, alike: list[Any], values: dict[sp.Symbol, float]) -> Any:
    """Return symbols for the numbers of the first of ``alike``, whose values are added to ``values``.

    ``leg`` is the number of the leg, or "". Numbers that are zero in all of ``alike`` remain zero.
    """
    first = alike[0]
    if isinstance(first, SimpleNamespace):
        parts = {part: [getattr(each, part) for each in alike] for part in vars(first)}
        return SimpleNamespace(**{part: _named(part, leg, each, values) for part, each in parts.items()})
    if name == "leg":
        return [_named("", str(i), [each, *first], values) for i, each in enumerate(first, 1)]
    if isinstance(first, list):
        return [
            _named(_joined(name, _axes(len(first), i)), leg, list(part), values)
            for i, part in enumerate(zip(*alike, strict=True))
        ]
    if name == "status":
        return first
    if not any(alike):
        return sp.Integer(0)
    symbol = sp.Symbol(_joined(name, leg), real=True)
    values[symbol] = float(first)
    return symbol


def _axes(count: int, index: int) -> str:
    return "".join(AXES[i] for i in _COMPONENTS[count][index])


def _joined(*parts: str) -> str:
    return "_".join(part for part in parts if part)
