"""Baking: insertion of a robot's constants into a force kernel.

The constants are prepared with 50 digits and rounded once. A constant that is 0, 1, or -1 for all legs is
substituted, so that terms vanish or become shorter. A constant with the same value for all legs becomes a
literal. Other constants are a table over the legs. Constants that occur in one product or sum are merged.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import sympy as sp
from mpmath import mp, mpf

from ..program.block import Block, Output, Quantity, rebuilt
from ..program.cse import specialized
from . import quantities as n
from .actuator_forces import ForceKernel, without_zeros
from .lumped_constants import ADDED

LEGS = 6
DIGITS = 50
_MORE_DIGITS = 80

Numbers = Mapping[str, Any]
"""Numbers, or nested lists of numbers, by field of ``stewart_robot``; fields of the legs have six rows."""


@dataclass
class _Constants:
    """Values of each constant by symbol: one for all legs, or six."""

    quantities: dict[sp.Symbol, Quantity] = field(default_factory=dict)
    values: dict[sp.Symbol, tuple[mpf, ...]] = field(default_factory=dict)

    def add(self, quantity: Quantity, values: tuple[mpf, ...]) -> sp.Symbol:
        """Add a constant and return its symbol.

        Raises
        ------
        ValueError
            If the name already belongs to other values.
        """
        symbol = quantity.symbols[0]
        values = values[:1] if len(set(values)) == 1 else values
        if self.values.setdefault(symbol, values) != values:
            raise ValueError(f"{quantity.name}: expected the values that this name already has, got others")
        self.quantities.setdefault(symbol, quantity)
        return symbol


def baked(kernel: ForceKernel, robot: Numbers, name: str) -> ForceKernel:
    """Insert the numbers of a robot into a kernel whose common subexpressions are not yet eliminated.

    ``name`` is the name of the result.
    """
    kernel = replace(kernel, size=_size(robot), extent=_extent(robot))
    constants = _prepared(kernel, robot)
    shared = {symbol: values[0] for symbol, values in constants.values.items() if len(values) == 1}
    simple = {symbol: sp.Integer(int(value)) for symbol, value in shared.items() if value in (-1, 0, 1)}

    def change(block: Block) -> Block:
        given = specialized(block, simple)
        # The block near a joint singularity is rarely used. If its constants were merged, it would have to be
        # tested for each robot, because rounding errors are largest there.
        return given if block is kernel.leg_near_singular else _folded(given, constants)

    kernel = without_zeros(kernel.changed(lambda block: _with_inputs(change(block), constants)))
    used = {q for block in kernel.blocks() for q in block.inputs}
    numbers = {
        q: tuple(float(value) for value in constants.values[symbol])
        for symbol, q in constants.quantities.items()
        if q in used
    }
    return replace(kernel, constants=numbers, baked_name=name)


def _with_inputs(block: Block, constants: _Constants) -> Block:
    found = set().union(*(expr.free_symbols for expr in block.expressions()))
    inputs = [q for q in block.inputs if not constants.values.keys() & set(q.symbols)]
    inputs += [q for symbol, q in constants.quantities.items() if symbol in found]
    return rebuilt(block, block.steps, block.outputs, inputs)


def _size(robot: Numbers) -> float:
    """Return the largest coordinate of the platform points relative to the first one, platform frame (m)."""
    points = [[float(x) for x in point] for point in robot[n.p.name]]
    return max(abs(x - first) for point in points for x, first in zip(point, points[0], strict=True))


def _extent(robot: Numbers) -> float:
    """Return the largest sum of the absolute coordinates of a base or platform point (m)."""
    return max(sum(abs(float(x)) for x in point) for q in (n.p, n.b) for point in robot[q.name])


# ---------------------------------------------------------------- preparation


def _prepared(kernel: ForceKernel, robot: Numbers) -> _Constants:
    coarse, fine = (_run(kernel, robot, digits) for digits in (DIGITS, _MORE_DIGITS))
    constants = _Constants()
    for name, quantity in coarse.quantities.items():
        pairs = zip(coarse.values[name], fine.values[name], strict=True)
        constants.add(quantity, tuple(_rounded(*pair) for pair in pairs))
    return constants


def _rounded(coarse: mpf, fine: mpf) -> mpf:
    """Return the double nearest to a value, or zero if more digits show that it is a rounding error."""
    return mpf(0) if abs(fine) < abs(coarse) * mpf(10) ** -10 else mpf(float(fine))


def _run(kernel: ForceKernel, robot: Numbers, digits: int) -> _Constants:
    """Prepare the constants of the legs and of the platform with the given number of digits."""
    with mp.workdps(digits):
        of_all = _components((*n.PLATFORM, n.p_1), {**robot, n.p_1.name: robot[n.p.name][0]})
        given = [
            of_all | _components(n.of_leg(robot), {q.name: robot[q.name][leg] for q in n.of_leg(robot)})
            for leg in range(LEGS)
        ]
        found = [_by_name(kernel.prepare_leg, values) for values in given]
        added = {name: sum(leg[name] for leg in found) for q in ADDED for name in q.names}
        of_platform = _by_name(kernel.prepare_platform, given[0] | added)
        constants = _Constants()
        for quantity in (*kernel.leg_constants(), *kernel.platform_constants()):
            for name in quantity.names:
                part = Quantity(name, (), quantity.unit, quantity.meaning)
                of_legs = [leg[name] if name in leg else of_platform[name] for leg in found]
                constants.add(part, tuple(of_legs))
        return constants


def _components(quantities: Iterable[Quantity], numbers: Numbers) -> dict[str, mpf]:
    """Return numbers by the names of the blocks' inputs."""
    found = {}
    for quantity in quantities:
        for name, key in zip(quantity.names, quantity.keys, strict=True):
            value = numbers[quantity.name]
            for i in key:
                value = value[i]
            found[name] = mpf(float(value))
    return found


def _by_name(block: Block, values: Mapping[str, mpf]) -> dict[str, mpf]:
    outputs = block.run(values, mp.sqrt)
    return {
        name: mpf(value)
        for out in block.outputs
        for name, value in zip(out.quantity.names, outputs[out.quantity.name], strict=True)
    }


# ---------------------------------------------------------------- merged constants


def _folded(block: Block, constants: _Constants) -> Block:
    """Merge constants that occur in one product or sum of the block."""
    steps = [replace(step, expr=_fold(step.expr, constants)) for step in block.steps]
    outputs = [Output(out.quantity, tuple(_fold(e, constants) for e in out.exprs)) for out in block.outputs]
    return rebuilt(block, steps, outputs, (*block.inputs, *constants.quantities.values()))


def _fold(expr: sp.Expr, constants: _Constants) -> sp.Expr:
    if expr.is_Atom:
        return expr
    args = [_fold(arg, constants) for arg in expr.args]
    if not (expr.is_Add or expr.is_Mul):
        return expr.func(*args)
    known = [arg for arg in args if _is_constant(arg, constants)]
    signs = [arg for arg in known if arg in (1, -1)]
    known = [arg for arg in known if arg not in signs]
    if len(known) < 2:
        return expr.func(*args)
    rest = [arg for arg in args if arg not in known]
    return expr.func(*rest, _joined(expr.func, known, constants))


def _is_constant(expr: sp.Expr, constants: _Constants) -> bool:
    bare = -expr if expr.could_extract_minus_sign() else expr
    return bool(expr.is_Number) or bare in constants.values


def _joined(join: type[sp.Expr], known: list[sp.Expr], constants: _Constants) -> sp.Expr:
    """Merge several constants into one, and name it after them."""
    name = ("_plus_" if join is sp.Add else "_").join(_word(arg) for arg in known)
    with mp.workdps(DIGITS):
        rows = zip(*(_values(arg, constants) for arg in known), strict=True)
        values = tuple(mpf(float(sum(row) if join is sp.Add else mp.fprod(row))) for row in rows)
    meaning = (" + " if join is sp.Add else " ").join(str(arg) for arg in known)
    return constants.add(Quantity(name, (), "", meaning), values)


def _word(arg: sp.Expr) -> str:
    """Return the name of a number or a constant: ``two``, ``h_s``, or ``minus_h_s``."""
    if arg.could_extract_minus_sign():
        return f"minus_{_word(-arg)}"
    return {sp.Integer(2): "two", sp.Rational(1, 2): "half"}.get(arg, str(arg).replace("/", "_over_"))


def _values(arg: sp.Expr, constants: _Constants) -> tuple[mpf, ...]:
    if arg.is_Number:
        return (mpf(arg.p) / mpf(arg.q),) * LEGS
    sign = -1 if arg.could_extract_minus_sign() else 1
    values = constants.values[sign * arg]
    return tuple(sign * value for value in (values * LEGS if len(values) == 1 else values))
