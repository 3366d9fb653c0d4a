"""Blocks: the unit that travels through ``derive``, and the count of its operations.

A block is a named straight-line program: quantities come in, ordered steps ``name = expression`` follow,
quantities go out. The derivation makes blocks, ``cse`` rewrites them, the emitters print them, the
notebook shows them. A block depends neither on the Stewart platform nor on a target language.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache, cached_property, reduce
from operator import mul
from typing import Any

import sympy as sp

AXES = "xyz"

_Runner = Callable[[Mapping[str, Any], Callable[[Any], Any]], Any]


@dataclass(frozen=True)
class Quantity:
    """A named scalar, 3-vector, 3x3 matrix or symmetric 3x3 tensor with its unit and meaning.

    shape: ``()``, ``(3,)`` or ``(3, 3)``; a symmetric tensor keeps six symbols (xx, xy, xz, yy, yz, zz).
    """

    name: str
    shape: tuple[int, ...]
    unit: str
    meaning: str
    symmetric: bool = False

    @property
    def keys(self) -> tuple[tuple[int, ...], ...]:
        """Index of each component, in the order in which the components are stored."""
        if self.shape == ():
            return ((),)
        if self.shape == (3,):
            return tuple((i,) for i in range(3))
        return tuple((i, j) for i in range(3) for j in range(i if self.symmetric else 0, 3))

    @property
    def names(self) -> tuple[str, ...]:
        """Name of each component: ``m``, ``p_x``, ``R_xy``."""
        return tuple(component_name(self.name, key) for key in self.keys)

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """Symbol of each component, in storage order."""
        return tuple(sp.Symbol(name, real=True) for name in self.names)

    @property
    def value(self) -> sp.Expr | sp.Matrix:
        """The quantity as it stands in equations: a symbol, a 3x1 matrix or a 3x3 matrix."""
        return as_value(self, self.symbols)


def component_name(name: str, key: Sequence[int]) -> str:
    """Name of one component: ``component_name("R", (0, 1))`` is ``R_xy``."""
    return name + ("_" + "".join(AXES[i] for i in key) if key else "")


@dataclass(frozen=True)
class Step:
    """One assignment; ``equation`` cites the paper, ``meaning`` says what the name stands for."""

    name: str
    expr: sp.Expr
    equation: str = ""
    meaning: str = ""

    @property
    def symbol(self) -> sp.Symbol:
        """The symbol by which later steps refer to this one."""
        return sp.Symbol(self.name, real=True)


@dataclass(frozen=True)
class Output:
    """One quantity that leaves a block, with the expression of each of its components."""

    quantity: Quantity
    exprs: tuple[sp.Expr, ...]


@dataclass(frozen=True)
class Operations:
    """Count of arithmetic operations; negation, copies and absolute values are free."""

    mul: int = 0
    add: int = 0
    div: int = 0
    sqrt: int = 0

    @property
    def total(self) -> int:
        """All operations, one each."""
        return self.mul + self.add + self.div + self.sqrt

    def __add__(self, other: "Operations") -> "Operations":
        """Count of two programs, one after the other."""
        return Operations(
            self.mul + other.mul, self.add + other.add, self.div + other.div, self.sqrt + other.sqrt
        )

    def __rmul__(self, times: int) -> "Operations":
        """Count of a program run ``times`` times."""
        return Operations(times * self.mul, times * self.add, times * self.div, times * self.sqrt)

    def __str__(self) -> str:
        """Total, then each kind."""
        return f"{self.total} ({self.mul} mul, {self.add} add, {self.div} div, {self.sqrt} sqrt)"


@dataclass(frozen=True)
class Block:
    """A straight-line program with named steps.

    inputs: quantities that must be given; steps: in order, each using inputs and earlier steps only;
    outputs: what leaves the block.
    """

    name: str
    meaning: str
    inputs: tuple[Quantity, ...]
    steps: tuple[Step, ...]
    outputs: tuple[Output, ...]

    @property
    def made(self) -> tuple[Quantity, ...]:
        """The quantities that leave the block."""
        return tuple(out.quantity for out in self.outputs)

    @property
    def exprs(self) -> dict[Quantity, tuple[sp.Expr, ...]]:
        """Components of each of them."""
        return {out.quantity: out.exprs for out in self.outputs}

    def operations(self) -> Operations:
        """Operations of the steps and of whatever the outputs still compute."""
        return count(self.expressions())

    def expressions(self) -> list[sp.Expr]:
        """Right sides of all steps, then of all outputs."""
        return [step.expr for step in self.steps] + [e for out in self.outputs for e in out.exprs]

    def used_inputs(self) -> tuple[Quantity, ...]:
        """Inputs of which at least one component occurs in the block."""
        used = set().union(*(expr.free_symbols for expr in self.expressions()))
        return tuple(q for q in self.inputs if used.intersection(q.symbols))

    def run(self, values: Mapping[str, Any], sqrt: Callable[[Any], Any]) -> dict[str, tuple[Any, ...]]:
        """Run the block in any arithmetic, such as mpmath's.

        values: a number for each input component, by name; sqrt: the square root of such numbers. Returns the
        components of each output by name; constants are integers.
        """
        known, (steps, outputs) = dict(values), self._runners
        for name, runner in steps:
            known[name] = runner(known, sqrt)
        return {name: tuple(runner(known, sqrt) for runner in runners) for name, runners in outputs}

    @cached_property
    def _runners(self) -> tuple[list[tuple[str, _Runner]], list[tuple[str, list[_Runner]]]]:
        """Names and expressions of the steps, and names and components of the outputs."""
        return (
            [(step.name, _runner(step.expr)) for step in self.steps],
            [(out.quantity.name, [_runner(sp.sympify(e)) for e in out.exprs]) for out in self.outputs],
        )

    def formula(self, name: str) -> tuple[sp.Expr, ...]:
        """Output ``name`` as expressions of the inputs alone, all steps substituted back."""
        back = substitution(self.steps)
        out = next(o for o in self.outputs if o.quantity.name == name)
        return tuple(sp.sympify(e).xreplace(back) for e in out.exprs)


@dataclass
class Builder:
    """Collects steps in the order in which a derivation names its quantities."""

    steps: list[Step] = field(default_factory=list)

    def scalar(self, name: str, expr: sp.Expr, equation: str = "", meaning: str = "") -> sp.Expr:
        """Name ``expr``; a number or a symbol needs no name and is handed back as it is.

        Raises ValueError if the name stands for another expression already.
        """
        expr = sp.sympify(expr)
        if expr.is_Atom or (-expr).is_Atom:
            return expr
        for step in self.steps:
            if step.name == name and step.expr != expr:
                raise ValueError(f"{name}: the name is used for {step.expr}; choose another name")
            if step.name == name:
                return step.symbol
        self.steps.append(Step(name, expr, equation, meaning))
        return self.steps[-1].symbol

    def vector(self, name: str, exprs: sp.Matrix, equation: str = "", meaning: str = "") -> sp.Matrix:
        """Name the three components of a 3x1 matrix."""
        return sp.Matrix(
            [self.scalar(component_name(name, (i,)), exprs[i], equation, meaning) for i in range(3)]
        )

    def matrix(self, name: str, exprs: sp.Matrix, equation: str = "", meaning: str = "") -> sp.Matrix:
        """Name the nine components of a 3x3 matrix."""
        return sp.Matrix(
            3, 3, lambda i, j: self.scalar(component_name(name, (i, j)), exprs[i, j], equation, meaning)
        )

    def tensor(self, name: str, exprs: sp.Matrix, equation: str = "", meaning: str = "") -> sp.Matrix:
        """Name the six components of a symmetric 3x3 matrix."""
        named = {
            (i, j): self.scalar(component_name(name, (i, j)), exprs[i, j], equation, meaning)
            for i in range(3)
            for j in range(i, 3)
        }
        return sp.Matrix(3, 3, lambda i, j: named[min(i, j), max(i, j)])

    def substitution(self) -> dict[sp.Symbol, sp.Expr]:
        """Each named quantity as an expression of what the program was given."""
        return substitution(self.steps)

    def block(
        self,
        name: str,
        meaning: str,
        inputs: Iterable[Quantity],
        outputs: Iterable[tuple[Quantity, sp.Expr | sp.Matrix]],
    ) -> Block:
        """Close the program: unused inputs and steps that no output needs are left out."""
        listed = tuple(Output(q, _components(q, value)) for q, value in outputs)
        block = Block(name, meaning, tuple(inputs), tuple(self.steps), listed)
        block = replace(block, steps=_needed(block))
        return replace(block, inputs=block.used_inputs())


def substitution(steps: Iterable[Step]) -> dict[sp.Symbol, sp.Expr]:
    """Each step's symbol with all earlier steps substituted back into its expression."""
    back: dict[sp.Symbol, sp.Expr] = {}
    for step in steps:
        back[step.symbol] = step.expr.xreplace(back)
    return back


def as_value(quantity: Quantity, exprs: Sequence[sp.Expr]) -> sp.Expr | sp.Matrix:
    """Components in storage order as they stand in equations: the reverse of what an output stores."""
    if not quantity.shape:
        return exprs[0]
    if quantity.shape == (3,):
        return sp.Matrix(exprs)
    table = dict(zip(quantity.keys, exprs, strict=True))
    return sp.Matrix(3, 3, lambda i, j: table[(min(i, j), max(i, j)) if quantity.symmetric else (i, j)])


def rebuilt(
    block: Block, steps: Iterable[Step], outputs: Iterable[Output], inputs: Iterable[Quantity]
) -> Block:
    """The block with other steps and outputs, without what they do not need."""
    return Builder(list(steps)).block(
        block.name,
        block.meaning,
        dict.fromkeys(inputs),
        [(out.quantity, as_value(out.quantity, out.exprs)) for out in outputs],
    )


def part_of(block: Block, *quantities: Quantity) -> Block:
    """What a block does to make some of its outputs."""
    kept = [out for out in block.outputs if out.quantity in quantities]
    return rebuilt(block, block.steps, kept, block.inputs)


def _components(quantity: Quantity, value: sp.Expr | sp.Matrix) -> tuple[sp.Expr, ...]:
    if quantity.shape == ():
        return (sp.sympify(value),)
    return tuple(value[key[0]] if len(key) == 1 else value[key] for key in quantity.keys)


def _needed(block: Block) -> tuple[Step, ...]:
    wanted = set().union(*(e.free_symbols for out in block.outputs for e in out.exprs))
    kept: list[Step] = []
    for step in reversed(block.steps):
        if step.symbol in wanted:
            kept.append(step)
            wanted |= step.expr.free_symbols
    return tuple(reversed(kept))


def run(expr: sp.Expr, known: Mapping[str, Any], sqrt: Callable[[Any], Any]) -> Any:
    """Value of one expression in the arithmetic of the numbers in ``known``."""
    return _runner(expr)(known, sqrt)


def _runner(expr: sp.Expr) -> _Runner:
    """What runs an expression; made once, it is many times as fast as a walk over SymPy's tree."""
    if expr.is_Symbol:
        name = expr.name
        return lambda known, sqrt: known[name]
    if expr.is_Integer or (expr.is_Rational and expr.q == 2):
        constant = int(expr) if expr.is_Integer else expr.p * 0.5
        return lambda known, sqrt: constant
    first, *others = parts = [_runner(arg) for arg in (expr.args[:1] if expr.is_Pow else expr.args)]
    if expr.is_Pow and expr.exp == sp.Rational(1, 2):
        return lambda known, sqrt: sqrt(first(known, sqrt))
    if expr.is_Add:
        return lambda known, sqrt: sum([part(known, sqrt) for part in others], first(known, sqrt))
    if expr.is_Mul:
        return lambda known, sqrt: reduce(mul, [part(known, sqrt) for part in parts])
    if expr.is_Pow and expr.exp == -1:
        return lambda known, sqrt: 1 / first(known, sqrt)
    if expr.is_Pow and expr.exp.is_Integer and expr.exp > 1:
        times = int(expr.exp)
        return lambda known, sqrt: reduce(mul, [first(known, sqrt)] * times)
    raise ValueError(f"no value for {type(expr).__name__} in {expr}")


def count(exprs: Iterable[sp.Expr]) -> Operations:
    """Operations of a list of expressions, as the emitters print them."""
    return sum((_count(sp.sympify(expr)) for expr in exprs), Operations())


@cache
def common_factor(expr: sp.Add) -> sp.Integer:
    """The whole number by which all terms of a sum are multiplied, and programs the sum.

    J_xx + J_yy - J_zz of a rod is zero to the last digit, and so is three times that, which the sum of three
    products need not be.
    """
    found = expr.as_content_primitive()[0]
    return found if found.is_Integer else sp.S.One


@cache
def _count(expr: sp.Expr) -> Operations:
    if expr.is_Atom:
        return Operations()
    if expr.is_Add and (common := common_factor(expr)) != 1:
        return Operations(mul=1) + _count(expr / common)
    inner = sum((_count(arg) for arg in expr.args), Operations())
    if expr.is_Add:
        return inner + Operations(add=len(expr.args) - 1)
    if expr.is_Mul:
        return _count_product(expr)
    if expr.is_Pow:
        return inner + _count_power(expr)
    raise ValueError(f"no operation count for {type(expr).__name__} in {expr}")


def _count_product(expr: sp.Mul) -> Operations:
    sign, rest = expr.as_coeff_Mul()
    factors = [f for f in sp.Mul.make_args(rest) if f != 1]
    if sign not in (1, -1):
        factors.insert(0, sign)
    over = [f for f in factors if f.is_Pow and f.exp == -1]
    upper = len(factors) - len(over)
    inner = sum((_count(f.base if f in over else f) for f in factors), Operations())
    if not over:
        return inner + Operations(mul=upper - 1)
    return inner + Operations(mul=max(upper - 1, 0) + len(over) - 1, div=1)


def _count_power(expr: sp.Pow) -> Operations:
    if expr.exp == sp.Rational(1, 2):
        return Operations(sqrt=1)
    if expr.exp == -1:
        return Operations(div=1)
    if expr.exp.is_Integer and expr.exp > 1:
        return Operations(mul=int(expr.exp) - 1)
    raise ValueError(f"no operation count for the power {expr}")
