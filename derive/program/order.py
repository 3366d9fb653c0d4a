"""The order of a sum's terms: terms that are ready first are added first, so that a processor waits least.

Times are counted in additions; a block's inputs are ready at once. Of terms that are ready at the same time,
positive ones come first. A processor with few registers gains nothing by this order.
"""

from collections.abc import Iterable, Mapping
from functools import cache
from types import MappingProxyType

import sympy as sp

from .block import Step

ROOT, QUOTIENT = 5, 4
"""How long a square root and a division take, in additions."""

Ready = Mapping[str, int]
"""When named steps are ready."""
NOTHING: Ready = MappingProxyType({})
"""Nothing has to be waited for."""
AS_DERIVED: Ready = MappingProxyType({"": 0})
"""Positive terms before negative ones, else in SymPy's order."""


def ready_in(steps: Iterable[Step]) -> dict[str, int]:
    """When each of the steps of a block is ready."""
    found: dict[str, int] = {}
    for step in steps:
        found[step.name] = ready_when(step.expr, found)
    return found


@cache
def _ordered(expr: sp.Add) -> tuple[sp.Expr, ...]:
    return tuple(expr.as_ordered_terms())


def terms_in_order(expr: sp.Add, ready: Ready) -> tuple[sp.Expr, ...]:
    """The terms of a sum in the order in which programs add them up; the first is positive where one is."""
    terms = list(_ordered(expr))
    terms.sort(
        key=lambda term: (
            0 if ready is AS_DERIVED else ready_when(term, ready),
            term.could_extract_minus_sign(),
        )
    )
    first = next((term for term in terms if not term.could_extract_minus_sign()), terms[0])
    return first, *(term for term in terms if term is not first)


def ready_when(expr: sp.Expr, ready: Ready) -> int:
    """When the value of an expression is known."""
    if expr.is_Symbol:
        return ready.get(expr.name, 0)
    if not expr.args:
        return 0
    times = sorted(ready_when(each, ready) for each in expr.args)
    if expr.is_Add:
        at = 0
        for each in times:
            at = max(at, each) + 1
        return at
    if expr.is_Mul:
        return times[-1] + len(times) - 1
    # Powers count from the start, as if their base were read: counted from their base, terms that wait for
    # roots come later, chains are shorter but more numbers are kept, and a batch took 1 to 2 % longer.
    return times[0] + {sp.Rational(1, 2): ROOT, sp.Integer(-1): QUOTIENT}.get(expr.exp, 1)
