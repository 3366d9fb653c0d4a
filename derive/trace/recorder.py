"""Trace of a kernel: its steps in parts, branches that are rarely taken, and rejected poses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import Any

import sympy as sp

from ..program.block import Block, Quantity
from ..program.order import NOTHING, ready_in
from ..trace import nodes as t
from ..trace.lower import expression
from .values import Value

MOTION, LEG, MODEL = "motion", "leg", "model"
"""Kinds of inputs: motion of a pose, constants of each leg, and constants of the robot."""


@dataclass(frozen=True)
class Input:
    """Component of a quantity that a kernel reads; a constant of the code has a ``literal``."""

    quantity: Quantity
    index: int
    kind: str
    literal: t.Expression | None = None


Inputs = dict[str, Input]
_SIMPLE = (t.Name, t.Number, t.Constant, t.Element)


def inputs_of(kind: str, quantities: Iterable[Quantity]) -> Inputs:
    """Return the components of quantities by name."""
    return {name: Input(q, i, kind) for q in quantities for i, name in enumerate(q.names)}


@dataclass(frozen=True)
class Slot:
    """Location of a result that another part reads: structure, member, and index in the member."""

    structure: str
    member: str
    index: int | None = None


@dataclass(frozen=True)
class Step:
    """Named step; ``remark`` contains its equation number and meaning.

    With ``joins``, the step is the part of a leg that joins the accumulator of this name.
    """

    name: str
    expr: t.Expression
    per_leg: bool
    remark: str = ""
    joins: str = ""


@dataclass
class Part:
    """Steps that become one function.

    Attributes
    ----------
    per_leg : bool
        True if the function computes one leg when poses are in lanes.
    ahead : bool
        True if the part of the next leg is computed before the other parts of a leg.
    skips_first : bool
        True if the results are zero for leg 1, which is then omitted.
    only_first : bool
        True if the function is called after the other parts of leg 1, because it requires their results.
    common : bool
        True if the function is in a header because several kernels use it.
    fuses_named : bool
        True if named products are fused with the sums that read them.
    """

    name: str
    meaning: str
    per_leg: bool = False
    ahead: bool = False
    skips_first: bool = False
    only_first: bool = False
    common: bool = False
    fuses_named: bool = False
    steps: list[Step] = field(default_factory=list)


@dataclass
class Reject:
    """End with the status that a function of the runtime returns, unless it is OK."""

    function: str
    arguments: tuple[Value | list[Value], ...]


@dataclass
class Branch:
    """Parts that are computed only if ``test`` is true.

    Attributes
    ----------
    alone : bool
        True if poses with a true test are left to the function of one pose when poses are in lanes.
    updates : dict
        New names of earlier values.
    """

    test: Value
    alone: bool
    body: list[Any] = field(default_factory=list)
    updates: dict[str, str] = field(default_factory=dict)

    def update(self, old: Value, new: Value) -> None:
        """Replace an earlier value."""
        self.updates[old.name] = new.name


@dataclass
class Trace:
    """Record of a kernel: parts, branches, and rejections in order.

    Attributes
    ----------
    inputs : mapping
        Inputs by name.
    slots : dict
        Locations of results, if they are not members of the structure of their part.
    per_leg : set of str
        Names of steps with one number for each leg.
    zero_at_first : set of str
        Names of steps that are zero for leg 1.
    accumulators : dict
        Operators by which the legs join an accumulator, by its name: ``+``, or ``mark`` if the value of a leg
        is the accumulator or 1.
    result : list of Value
        Results of the kernel.
    unfinished : list of Value
        Marks of poses that the function of one pose must compute if poses are in lanes.
    """

    inputs: Mapping[str, Input]
    body: list[Any] = field(default_factory=list)
    slots: dict[str, Slot] = field(default_factory=dict)
    per_leg: set[str] = field(default_factory=set)
    zero_at_first: set[str] = field(default_factory=set)
    accumulators: dict[str, str] = field(default_factory=dict)
    result: list[Value] = field(default_factory=list)
    unfinished: list[Value] = field(default_factory=list)

    def __post_init__(self) -> None:
        self._names: set[str] = set()
        self._part: Part | None = None
        self._open = self.body

    # ------------------------------------------------------------ values

    def input(self, name: str) -> Value:
        """Return an input by name."""
        return Value(t.Name(name), self.inputs[name].kind == LEG, self)

    def inputs_named(self, quantity: Quantity) -> list[Value]:
        """Return the components of a quantity."""
        return [self.input(name) for name in quantity.names]

    def let(self, name: str, value: Value, slot: Slot | None = None, remark: str = "") -> Value:
        """Record a step; a name that is in use receives a number."""
        part = self._part
        assert part is not None
        value = replace(value, expr=self._flat(name, value))
        free, count = name, 1
        while free in self._names or free in self.inputs:
            count += 1
            free = f"{name}_{count}"
        self._names.add(free)
        per_leg = value.per_leg or part.per_leg
        if per_leg:
            self.per_leg.add(free)
        if part.skips_first:
            self.zero_at_first.add(free)
        if slot is not None:
            self.slots[free] = slot
        part.steps.append(Step(free, value.expr, per_leg, remark))
        return Value(t.Name(free), per_leg, self)

    def _flat(self, name: str, value: Value) -> Any:
        """Record the operands of selections: compilers vectorize only selections between numbers."""

        def flat(node: Any) -> Any:
            if isinstance(node, tuple):
                return tuple(map(flat, node))
            if not isinstance(node, t.Node):
                return node
            changed = t.mapped(node, flat)
            if isinstance(changed, t.Select):
                yes, no = (
                    each if isinstance(each, _SIMPLE) else self.let(name, replace(value, expr=each)).expr
                    for each in (changed.yes, changed.no)
                )
                return replace(changed, yes=yes, no=no)
            return changed

        return flat(value.expr)

    def accumulator(self, name: str, start: Value, slot: Slot | None = None, operator: str = "+") -> Value:
        """Record a number that all legs change in order; ``start`` is its value before leg 1."""
        found = self.let(name, start, slot)
        self.accumulators[found.name] = operator
        return found

    def accumulate(self, total: Value, term: Value) -> None:
        """Join a recorded number of each leg to an accumulator."""
        assert self._part is not None
        assert self._part.per_leg
        self.let(f"{total.name}_and_{term.name}", term)
        self._part.steps[-1] = replace(self._part.steps[-1], joins=total.name)

    # ------------------------------------------------------------ parts

    @contextmanager
    def part(self, name: str, meaning: str = "", **properties: bool) -> Iterator[None]:
        """Record the following steps as a part; ``properties`` are attributes of ``Part``."""
        before, self._part = self._part, Part(name, meaning, steps=[], **properties)
        self._open.append(self._part)
        yield
        self._part = before

    @contextmanager
    def rarely(self, test: Value, alone: bool = False) -> Iterator[Branch]:
        """Record the following parts as a branch."""
        branch = Branch(test, alone)
        self._open.append(branch)
        before, self._open = self._open, branch.body
        yield branch
        self._open = before

    def reject(self, function: str, *arguments: Value | list[Value]) -> None:
        """Record the end with the status of a function, if it is not OK."""
        self._open.append(Reject(function, arguments))

    # ------------------------------------------------------------ blocks of the derivation

    def run(
        self,
        block: Block,
        given: Mapping[Quantity, Sequence[Value]],
        known: dict[str, Value] | None = None,
        ready: Mapping[str, int] | None = None,
    ) -> dict[Quantity, list[Value]]:
        """Record the steps of a block and return its outputs.

        Parameters
        ----------
        given : mapping
            Values of inputs that other parts compute.
        known : dict, optional
            Values of steps that are recorded; the steps of the block are added.
        ready : mapping, optional
            Times at which steps are available; they determine the order of sums.
        """
        values = dict(known or {})
        for q in block.used_inputs():
            values |= zip(q.names, given[q] if q in given else self.inputs_named(q), strict=True)
        ready = ready_in(block.steps) if ready is None else ready
        before = None
        for step in block.steps:
            said = (step.equation, step.meaning)
            remark = "" if said == before else " ".join(filter(None, said))
            before = said
            if step.name not in values:
                values[step.name] = self.let(step.name, _value(step.expr, values, ready), remark=remark)
        if known is not None:
            known |= values
        return {
            out.quantity: [
                self._output(out.quantity, i, expr, values)
                for i, expr in enumerate(map(sp.sympify, out.exprs))
            ]
            for out in block.outputs
        }

    def _output(self, quantity: Quantity, index: int, expr: sp.Expr, values: Mapping[str, Value]) -> Value:
        """Return one component of an output, which is located in an array of its quantity."""
        found = values[expr.name] if expr.is_Symbol else None
        if found is None or found.name in self.inputs:
            found = self.let(quantity.names[index], _value(expr, values, NOTHING))
        if quantity.shape and self._part is not None:
            self.slots.setdefault(found.name, Slot(self._part.name, quantity.name, index))
        return found


def _value(expr: sp.Expr, values: Mapping[str, Value], ready: Mapping[str, int]) -> Value:
    """Convert an expression; values replace its symbols."""
    read = [values[symbol.name] for symbol in sp.sympify(expr).free_symbols]
    trace = next((value.trace for value in read), None)
    known = {name: value.expr for name, value in values.items()}
    return Value(t.substituted(expression(expr, ready), known), any(each.per_leg for each in read), trace)
