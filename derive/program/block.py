"""Blocks, the common data structure of ``derive``, and the count of their operations.

A block is a named straight-line program: inputs, ordered steps ``name = expression``, and outputs. The
derivation creates blocks, passes rewrite them, printers print them, and the notebook displays them. A block
depends neither on the Stewart platform nor on a target language.
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
    """Named scalar, 3-vector, 3x3 matrix, or symmetric 3x3 tensor with unit and meaning.

    Attributes
    ----------
    name : str
        Name.
    shape : tuple of int
        ``()``, ``(3,)``, or ``(3, 3)``.
    unit, meaning : str
        Unit, and description with the frame.
    symmetric : bool
        True for a symmetric tensor, which has six symbols (xx, xy, xz, yy, yz, zz).
    """

    name: str
    shape: tuple[int, ...]
    unit: str
    meaning: str
    symmetric: bool = False

    @property
    def keys(self) -> tuple[tuple[int, ...], ...]:
        """Index of each component, in storage order."""
        if self.shape == ():
            return ((),)
        if self.shape == (3,):
            return tuple((i,) for i in range(3))
        return tuple((i, j) for i in range(3) for j in range(i if self.symmetric else 0, 3))

    @property
    def names(self) -> tuple[str, ...]:
        """Name of each component, such as ``m``, ``p_x``, or ``R_xy``."""
        return tuple(component_name(self.name, key) for key in self.keys)

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """Symbol of each component, in storage order."""
        return tuple(sp.Symbol(name, real=True) for name in self.names)

    @property
    def value(self) -> sp.Expr | sp.Matrix:
        """Quantity as used in equations: a symbol, a 3x1 matrix, or a 3x3 matrix."""
        return as_value(self, self.symbols)


def component_name(name: str, key: Sequence[int]) -> str:
    """Return the name of one component: ``component_name("R", (0, 1))`` is ``R_xy``."""
    return name + ("_" + "".join(AXES[i] for i in key) if key else "")


@dataclass(frozen=True)
class Step:
    """Assignment of an expression to a name, with its equation number in the paper and its meaning."""

    name: str
    expr: sp.Expr
    equation: str = ""
    meaning: str = ""

    @property
    def symbol(self) -> sp.Symbol:
        """Symbol by which later steps refer to this step."""
        return sp.Symbol(self.name, real=True)


@dataclass(frozen=True)
class Output:
    """Quantity that a block returns, with an expression for each component."""

    quantity: Quantity
    exprs: tuple[sp.Expr, ...]


@dataclass(frozen=True)
class Operations:
    """Count of arithmetic operations. Negations, copies, and absolute values are not counted."""

    mul: int = 0
    add: int = 0
    div: int = 0
    sqrt: int = 0

    @property
    def total(self) -> int:
        """Total number of operations."""
        return self.mul + self.add + self.div + self.sqrt

    def __add__(self, other: "Operations") -> "Operations":
        """Return the count of two successive programs."""
        return Operations(
            self.mul + other.mul, self.add + other.add, self.div + other.div, self.sqrt + other.sqrt
        )

    def __rmul__(self, times: int) -> "Operations":
        """Return the count of a program that is run ``times`` times."""
        return Operations(times * self.mul, times * self.add, times * self.div, times * self.sqrt)

    def __str__(self) -> str:
        """Return the total and the count of each kind."""
        return f"{self.total} ({self.mul} mul, {self.add} add, {self.div} div, {self.sqrt} sqrt)"


@dataclass(frozen=True)
class Block:
    """Straight-line program with named steps.

    Attributes
    ----------
    name, meaning : str
        Name, and description.
    inputs : tuple of Quantity
        Inputs.
    steps : tuple of Step
        Ordered steps; each one uses inputs and earlier steps only.
    outputs : tuple of Output
        Outputs.
    """

    name: str
    meaning: str
    inputs: tuple[Quantity, ...]
    steps: tuple[Step, ...]
    outputs: tuple[Output, ...]

    @property
    def made(self) -> tuple[Quantity, ...]:
        """Quantities that the block returns."""
        return tuple(out.quantity for out in self.outputs)

    @property
    def exprs(self) -> dict[Quantity, tuple[sp.Expr, ...]]:
        """Components of each output by quantity."""
        return {out.quantity: out.exprs for out in self.outputs}

    def operations(self) -> Operations:
        """Count the operations of the steps and of the expressions in outputs."""
        return count(self.expressions())

    def expressions(self) -> list[sp.Expr]:
        """Return the right-hand sides of all steps, followed by the expressions of all outputs."""
        return [step.expr for step in self.steps] + [e for out in self.outputs for e in out.exprs]

    def used_inputs(self) -> tuple[Quantity, ...]:
        """Return the inputs of which at least one component occurs in the block."""
        used = set().union(*(expr.free_symbols for expr in self.expressions()))
        return tuple(q for q in self.inputs if used.intersection(q.symbols))

    def run(self, values: Mapping[str, Any], sqrt: Callable[[Any], Any]) -> dict[str, tuple[Any, ...]]:
        """Run the block in any arithmetic, such as mpmath.

        Parameters
        ----------
        values : mapping
            Number for each input component, by name.
        sqrt : callable
            Square root of such numbers.

        Returns
        -------
        dict
            Components of each output by name. A component that is a constant is an ``int``, or a ``float`` if
            it is an odd multiple of 1/2.
        """
        known, (steps, outputs) = dict(values), self._runners
        for name, runner in steps:
            known[name] = runner(known, sqrt)
        return {name: tuple(runner(known, sqrt) for runner in runners) for name, runners in outputs}

    @cached_property
    def _runners(self) -> tuple[list[tuple[str, _Runner]], list[tuple[str, list[_Runner]]]]:
        """Names and functions of the steps, and names and component functions of the outputs."""
        return (
            [(step.name, _runner(step.expr)) for step in self.steps],
            [(out.quantity.name, [_runner(sp.sympify(e)) for e in out.exprs]) for out in self.outputs],
        )

    def formula(self, name: str) -> tuple[sp.Expr, ...]:
        """Return the output ``name`` as expressions of the inputs, with all steps substituted."""
        back = substitution(self.steps)
        out = next(o for o in self.outputs if o.quantity.name == name)
        return tuple(sp.sympify(e).xreplace(back) for e in out.exprs)


@dataclass
class Builder:
    """Collection of steps, in the order in which a derivation names its quantities."""

    steps: list[Step] = field(default_factory=list)

    def scalar(self, name: str, expr: sp.Expr, equation: str = "", meaning: str = "") -> sp.Expr:
        """Add the step ``name = expr`` and return its symbol.

        A number, a symbol, or a negated symbol is returned unchanged, without a step. An equal step is not
        added again.

        Raises
        ------
        ValueError
            If the name already belongs to another expression.
        """
        expr = sp.sympify(expr)
        if expr.is_Atom or (-expr).is_Atom:
            return expr
        for step in self.steps:
            if step.name == name and step.expr != expr:
                raise ValueError(f"{name}: expected an unused name, it already belongs to {step.expr}")
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
        """Return each named quantity as an expression of the inputs."""
        return substitution(self.steps)

    def block(
        self,
        name: str,
        meaning: str,
        inputs: Iterable[Quantity],
        outputs: Iterable[tuple[Quantity, sp.Expr | sp.Matrix]],
    ) -> Block:
        """Create the block without unused inputs and steps."""
        listed = tuple(Output(q, _components(q, value)) for q, value in outputs)
        block = Block(name, meaning, tuple(inputs), tuple(self.steps), listed)
        block = replace(block, steps=_needed(block))
        return replace(block, inputs=block.used_inputs())


def substitution(steps: Iterable[Step]) -> dict[sp.Symbol, sp.Expr]:
    """Return the expression of each step's symbol with all earlier steps substituted."""
    back: dict[sp.Symbol, sp.Expr] = {}
    for step in steps:
        back[step.symbol] = step.expr.xreplace(back)
    return back


def as_value(quantity: Quantity, exprs: Sequence[sp.Expr]) -> sp.Expr | sp.Matrix:
    """Convert components in storage order to a scalar, a 3x1 matrix, or a 3x3 matrix for equations."""
    if not quantity.shape:
        return exprs[0]
    if quantity.shape == (3,):
        return sp.Matrix(exprs)
    table = dict(zip(quantity.keys, exprs, strict=True))
    return sp.Matrix(3, 3, lambda i, j: table[(min(i, j), max(i, j)) if quantity.symmetric else (i, j)])


def rebuilt(
    block: Block, steps: Iterable[Step], outputs: Iterable[Output], inputs: Iterable[Quantity]
) -> Block:
    """Return the block with other steps and outputs, without unneeded steps and inputs."""
    return Builder(list(steps)).block(
        block.name,
        block.meaning,
        dict.fromkeys(inputs),
        [(out.quantity, as_value(out.quantity, out.exprs)) for out in outputs],
    )


def part_of(block: Block, *quantities: Quantity) -> Block:
    """Return the part of a block that computes some of its outputs."""
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
    """Evaluate one expression in the arithmetic of the numbers in ``known``."""
    return _runner(expr)(known, sqrt)


def _runner(expr: sp.Expr) -> _Runner:
    """Compile an expression to a function, which is much faster than a walk over SymPy's tree."""
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
    """Count the operations of expressions in the form in which the printers print them."""
    return sum((_count(sp.sympify(expr)) for expr in exprs), Operations())


@cache
def common_factor(expr: sp.Add) -> sp.Integer:
    """Return the common integer factor of all terms of a sum.

    Programs multiply the sum by this factor: 3 a + 3 b - 3 c is computed as 3 (a + b - c). If a + b - c is
    exactly zero, as J_xx + J_yy - J_zz of a rod, the result is exactly zero too. A sum of three separate
    products may have a rounding error.
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
