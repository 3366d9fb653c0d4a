"""Operation counts of a complete kernel: six legs, platform, sum of c, solve, and F = D - x.

+, -, *, /, and sqrt count one each; negations, copies, comparisons, and absolute values are not counted. The
expressions of blocks are counted directly. The linear solves are run on a type that counts.
"""

import random
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

from ..kernels.solve import solver
from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel
from ..mechanics.inverse_dynamics import Kernel
from ..mechanics.lumped_constants import arm_c
from ..program.block import Block, Operations, part_of
from ..trace import read
from ..trace.fused import fused, with_products_in_sums
from ..trace.lanes import Lanes
from ..trace.lower import expression, steps_of
from ..trace.nodes import Binary, Function, Node, Program, Return, calls_in, parts_of
from ..trace.operation_counter import counted
from ..trace.read import POSES, Given
from .elimination import BY_POINTERS, ONCE
from .prepare import is_scaled
from .written import scalar, solve

LEGS = 6
NOTHING = Operations()


@dataclass(frozen=True)
class KernelOperations:
    """Operation counts of one pose of the inverse dynamics by part.

    ``moments`` is the count for one leg, and ``arms`` the number of legs with moments. ``fused`` is the
    number of operations that fused multiply-adds save.
    """

    leg: Operations
    platform: Operations
    sum_c: Operations
    solve: Operations
    forces: Operations
    moments: Operations = NOTHING
    arms: int = LEGS - 1
    fused: int = 0

    @property
    def total(self) -> Operations:
        """Sum of all counts: six legs, platform, moments, the sum of c, the solve, and F = D - x."""
        parts = self.platform + self.arms * self.moments + self.sum_c + self.solve + self.forces
        return LEGS * self.leg + parts

    def parts(self) -> dict[str, Operations]:
        """Counts by name, with the total at the end."""
        return {
            "leg": self.leg,
            "platform": self.platform,
            **({"moments": self.moments} if self.moments.total else {}),
            "sum of c": self.sum_c,
            "solve": self.solve,
            "forces": self.forces,
            "total": self.total,
        }


_WRITTEN: Mapping[str, tuple[Callable[..., Any], Mapping[str, Given]]] = {
    "every output": (solve.eliminate, ONCE),
    "one pose": (scalar.solve, BY_POINTERS),
}
_TRACED = {
    "block": (False, "two_blocks"),
    "block about tip": (True, "two_blocks"),
    "pivots about tip": (True, "pivots"),
}


@cache
def solve_operations(name: str) -> Operations:
    """Count the operations of a solve; for several systems in lanes, of one of them."""
    program, count = _solve(name)
    draw = random.Random(1)
    function = program.functions[-1].name
    found = counted(program, function, lambda _: draw.uniform(0.5, 1.5), {"POSES": POSES})
    return Operations(*(each // count for each in (found.mul, found.add, found.div, found.sqrt)))


@cache
def _solve(name: str) -> tuple[Program, int]:
    """Return a program whose last function is a solve, and the number of systems that it solves."""
    if name in _WRITTEN:
        text, given = _WRITTEN[name]
        return Program("", (), (read.function(text, {}, {}, given=given),)), 1
    about_tip, part = _TRACED[name]
    schedule = Lanes(solver(about_tip), "", poses_in_lanes=True)
    return Program("", tuple(schedule.structures().values()), (schedule.functions[part],)), POSES


def _fused(function: Function, named: bool = False) -> int:
    """Count the operations that fused multiply-adds save; ``named`` also fuses named products."""
    body = with_products_in_sums(function.body) if named else function.body
    return _instructions(function) - _instructions(fused(replace(function, body=body)))


def _instructions(function: Function) -> int:
    """Count sums, products, and fused multiply-adds."""
    unread = [each for each in calls_in(function.body) if each.function == "(void)"]
    nodes = list(parts_of(function.body, Node))
    sums = sum(isinstance(each, Binary) and each.operator in ("+", "-", "*") for each in nodes)
    return sums + sum(each.function in ("fma", "fma_of") for each in calls_in(function.body)) - len(unread)


@cache
def _fused_in(block: Block, named: bool = False) -> int:
    results = [Return(expression(expr)) for out in block.outputs for expr in out.exprs]
    return _fused(Function("", "", (), None, (*steps_of(block.steps), *results)), named)


def kernel_operations(kernel: Kernel) -> KernelOperations:
    """Count the operations of a kernel; share its blocks before to count the emitted code."""
    return KernelOperations(
        leg=kernel.leg.operations(),
        platform=kernel.platform.operations(),
        sum_c=Operations(add=6 * LEGS),
        solve=solve_operations("every output"),
        forces=Operations(add=LEGS),
    )


def force_operations(kernel: ForceKernel, scalar_text: bool = False) -> KernelOperations:
    """Count the operations of a regrouped kernel; ``platform`` contains the common terms of a pose.

    If a leg has no part of c or no D, its addition is not counted. ``scalar_text`` counts the function that
    computes the legs one after the other: with leg 1 like the others, platform point 1 before them, and the
    product of the pivots. A solver that scales moments by a constant in the code includes the scaling; a
    prepared model decides this at run time.
    """
    given = kernel.leg.made
    sums = LEGS * sum(3 for quantity in (n.c_force, n.c_moment) if quantity in given)
    moments, shift = Operations(), Operations()
    solve = "one pose" if scalar_text else "block about tip" if kernel.about_tip else "block"
    arms = LEGS if scalar_text else LEGS - 1
    point = part_of(kernel.leg, n.q)
    if kernel.about_tip:
        moments, shift = kernel.moments.operations(), kernel.shift.operations()
        sums += arms * sum(3 for out in kernel.moments.outputs if out.quantity == arm_c)
    return KernelOperations(
        leg=kernel.leg.operations(),
        platform=kernel.shared.operations() + shift + (point.operations() if scalar_text else NOTHING),
        sum_c=Operations(add=sums),
        solve=solve_operations(solve) + _scaling(kernel, scalar_text),
        forces=Operations(add=LEGS if n.D in given else 0),
        moments=moments,
        arms=arms,
        fused=LEGS * _fused_in(kernel.leg)
        + _fused_in(kernel.shared, named=not scalar_text)
        + (_fused_in(kernel.shift) + arms * _fused_in(kernel.moments) if kernel.about_tip else 0)
        + (_fused_in(point) if scalar_text else 0)
        + _fused(_solve(solve)[0].functions[-1]),
    )


def _scaling(kernel: ForceKernel, scalar_text: bool) -> Operations:
    """Count the scaling of the moments of [H | c]; about platform point 1, leg 1 has none."""
    columns = LEGS + (scalar_text or not kernel.about_tip)
    return Operations(mul=3 * columns) if kernel.constants is not None and is_scaled(kernel) else NOTHING
