"""Solution of H x = c, (36): two blocks of three legs, or elimination with partial pivoting."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from ..program.block import Quantity
from ..trace.recorder import MODEL, Slot, Trace, inputs_of
from ..trace.values import LEGS, Value, as_value, constant, larger, where

COLUMNS, RIGHT_SIDE, SOLUTION = "columns", "right_side", "solution"
"""Structures of H, of c, and of x with the results of the checks of the solution."""
ARM_CUBE = Quantity(
    "arm_cube",
    (),
    "1",
    "(largest coordinate of p_i - p_1, times per_length)^3, the scale of determinants of moments",
)


Results = Callable[[list[Value], Value], list[Value]]
"""Function that traces results of x and of the mark of a small pivot."""


def solution(k: Trace, H: list[Value], c: list[Value], results: Results | None = None) -> list[Value]:
    """Trace the solution of H x = c, and results of the solution.

    Parameters
    ----------
    H : list of Value
        Rows of H, with one number for each leg.
    c : list of Value
        Right side.
    results : callable, optional
        Function that traces the results in the part of the solution, so that x stays in registers. By default
        the results are x and the mark.

    Returns
    -------
    list of Value
        Results of x and of a mark, which is 1 if a pivot is small, else 0.
    """
    meaning = (
        "Solves H x = c for x in two blocks of three legs, (36). Sets `weak` if the blocks are too "
        "inaccurate, so that pivots are required."
    )
    with k.part("two_blocks" if results is None else "results", meaning, common=results is None):
        x, weak = by_blocks(k, H, c)
        found = (results or partial(_stored, k))(x, as_value(0.0))
    with k.rarely(weak > 0.0) as branch:
        y, small = pivots(k, H, c)
        other = [*y, small]
        if results is not None:
            with k.part("results_of_pivots", "Computes the results again."):
                other = results(y, small)
        for old, new in zip(found, other, strict=True):
            branch.update(old, new)
    return found


def _stored(k: Trace, x: list[Value], suspect: Value) -> list[Value]:
    """Record x and a mark with their locations."""
    found = [k.let(f"x_{i}", value, Slot(SOLUTION, "x", i)) for i, value in enumerate(x)]
    return [*found, k.let("suspect", suspect, Slot(SOLUTION, "suspect"))]


def pivots(k: Trace, H: list[Value], c: list[Value]) -> tuple[list[Value], Value]:
    """Trace the solution by pivots as a part; return x, and 1 if a pivot is small, else 0."""
    meaning = (
        "Solves H x = c for x by elimination with partial pivoting, (36). Sets `suspect` if a pivot is small."
    )
    with k.part("pivots", meaning, common=True):
        *x, suspect = _stored(k, *by_pivots(k, H, c))
    return x, suspect


def by_blocks(k: Trace, H: list[Value], c: list[Value]) -> tuple[list[Value], Value]:
    """Solve for x in two blocks; return x, and 1 if a block is nearly singular, else 0.

    The adjugate of the directions of legs 2, 4, and 6 solves the first block, and the adjugate of the Schur
    complement the second one for legs 1, 3, and 5. This requires no exchanges and only two independent
    divisions, about half the time of six pivots in sequence.
    """
    r = adjugate(k, "r", lambda row, leg: H[row].at(2 * leg + 1))
    det = k.let("det", H[0].at(1) * r[0][0] + H[1].at(1) * r[0][1] + H[2].at(1) * r[0][2])

    def eliminated(a: list[Value], name: str) -> tuple[list[Value], list[Value]]:
        """Return the forces of legs 2, 4, and 6 for columns, and the remaining moments, times det."""
        e = [k.let(f"e{name}_{i}", r[i][0] * a[0] + r[i][1] * a[1] + r[i][2] * a[2]) for i in range(3)]
        w = [det * a[j] - H[j].at(1) * e[0] - H[j].at(3) * e[1] - H[j].at(5) * e[2] for j in (3, 4, 5)]
        return e, [k.let(f"w{name}_{j}", value) for j, value in enumerate(w)]

    e, w = eliminated(H, "")
    e_c, w_c = eliminated(c, "_c")
    u = adjugate(k, "u", lambda row, leg: w[row].at(2 * leg))
    complement = k.let("complement", w[0].at(0) * u[0][0] + w[1].at(0) * u[0][1] + w[2].at(0) * u[0][2])
    square = [e[i].at(0) * e[i].at(0) + e[i].at(2) * e[i].at(2) + e[i].at(4) * e[i].at(4) for i in range(3)]
    det2 = k.let("det2", det * det)
    scale = det2 * k.input(ARM_CUBE.name)
    least = k.let("least", larger(abs(det) * constant("BLOCK_LEAST"), constant("BLOCK_SINGULAR")) * scale)
    grown = where(square[0] + square[1] + square[2] > constant("BLOCK_GROWTH") * det2, 1.0, 0.0)
    grown = k.let("grown", grown)
    weak = k.let("weak", where(abs(complement) <= least, 1.0, grown))
    inverse_det = k.let("inverse_det", 1.0 / det)
    inverse_complement = k.let("inverse_complement", 1.0 / complement)
    x: dict[int, Value] = {}
    for i in range(3):
        of_leg = (u[i][0] * w_c[0] + u[i][1] * w_c[1] + u[i][2] * w_c[2]) * inverse_complement
        x[2 * i] = k.let(f"x_{2 * i}", of_leg)
    for i in range(3):
        rest = e_c[i] - e[i].at(0) * x[0] - e[i].at(2) * x[2] - e[i].at(4) * x[4]
        x[2 * i + 1] = k.let(f"x_{2 * i + 1}", rest * inverse_det)
    return [x[i] for i in range(LEGS)], weak


def adjugate(k: Trace, name: str, a: Callable[[int, int], Value]) -> list[list[Value]]:
    """Return the adjugate of a 3 x 3 matrix of entries ``a(row, column)``."""
    return [
        [
            k.let(
                f"{name}_{i}_{j}",
                a((j + 1) % 3, (i + 1) % 3) * a((j + 2) % 3, (i + 2) % 3)
                - a((j + 2) % 3, (i + 1) % 3) * a((j + 1) % 3, (i + 2) % 3),
            )
            for j in range(3)
        ]
        for i in range(3)
    ]


def by_pivots(k: Trace, H: list[Value], c: list[Value]) -> tuple[list[Value], Value]:
    """Solve for x by elimination with partial pivoting; return x, and 1 if a pivot is small, else 0.

    Rows are exchanged by selection. The first column has no moments if they are about platform point 1.
    """
    row, right, suspect, inverse = list(H), list(c), as_value(0.0), {}
    for j in range(LEGS):
        below = [i for i in range(j + 1, LEGS) if j > 0 or H[i].name not in k.zero_at_first]
        for i in below:
            test = k.let(f"below_{i}_{j}", where(abs(row[i].at(j)) > abs(row[j].at(j)), 1.0, 0.0)) > 0.0
            for rows, name in ((row, "row"), (right, "right")):
                upper, lower = where(test, rows[i], rows[j]), where(test, rows[j], rows[i])
                rows[j], rows[i] = k.let(f"{name}_{j}", upper), k.let(f"{name}_{i}", lower)
        suspect = where(abs(row[j].at(j)) > constant("SUSPECT"), suspect, 1.0)
        inverse[j] = k.let(f"inverse_{j}", 1.0 / row[j].at(j))
        for i in below:
            factor = k.let(f"factor_{i}_{j}", row[i].at(j) * inverse[j])
            row[i] = k.let(f"row_{i}", row[i] - factor * row[j])
            right[i] = k.let(f"right_{i}", right[i] - factor * right[j])
    x: dict[int, Value] = {}
    for i in reversed(range(LEGS)):
        total = right[i]
        for j in range(i + 1, LEGS):
            total = total - row[i].at(j) * x[j]
        x[i] = k.let(f"y_{i}", total / row[i].at(i) if i == LEGS - 1 else total * inverse[i])
    return [x[i] for i in range(LEGS)], k.let("small", suspect)


def solver(about_tip: bool) -> Trace:
    """Trace the solution alone, for equations that other functions store."""
    k, H, c = _equations(about_tip)
    k.result = solution(k, H, c)
    return k


def pivot_solver(about_tip: bool) -> Trace:
    """Trace the solution by pivots alone."""
    k, H, c = _equations(about_tip)
    x, suspect = pivots(k, H, c)
    k.result = [*x, suspect]
    return k


def _equations(about_tip: bool) -> tuple[Trace, list[Value], list[Value]]:
    """Trace rows of H and c with their locations."""
    k = Trace(inputs_of(MODEL, (ARM_CUBE,)))
    with k.part("rows", per_leg=True):
        H = [k.let(f"H_{i}", as_value(0.0), Slot(COLUMNS, "H", i)) for i in range(LEGS)]
    if about_tip:
        k.zero_at_first |= {value.name for value in H[3:]}
    with k.part("wrench"):
        c = [k.let(f"c_{i}", as_value(0.0), Slot(RIGHT_SIDE, "c", i)) for i in range(LEGS)]
    return k, H, c
