"""What the derivation cannot take is rejected.

That its steps give the printed equations and the corrected ones, and that the closed form is the elimination
and Lagrange's equations, the notebook asserts cell by cell: ``test_notebook`` runs it.
"""

import pytest
import sympy as sp
from command_line import rejects

from stewart_sym.derive.mechanics import platform
from stewart_sym.derive.mechanics.legs.base_frame import Transverse, scalar_form, vector_form
from stewart_sym.derive.program.block import Builder
from stewart_sym.derive.trace.lower import expression

A, B = sp.symbols("a b", real=True)


def vector(name: str) -> sp.Matrix:
    return sp.Matrix(sp.symbols(f"{name}_x {name}_y {name}_z", real=True))


def test_legs_that_enter_differently_are_rejected() -> None:
    N, R_G, F, E, M = (vector(name) for name in ("N", "R_G", "F", "E", "M"))
    found = platform.equations_of_motion(N, R_G, F, E, M)
    twisted = platform.PlatformEquations(found.H * sp.diag(1, 1, 1, 1, 1, 2), found.x, found.c)
    rejects("in the same way", platform.leg_share, twisted)


def transverse(name: str) -> Transverse:
    y, z = sp.symbols(f"{name}_y {name}_z", real=True)
    return Transverse(name, y, z, vector(f"{name}_base"))


def test_anisotropic_results_are_rejected() -> None:
    v = transverse("v")
    with pytest.raises(ValueError, match="not isotropic in v"):
        vector_form(Builder(), "Q", sp.Matrix([2 * v.y, v.z]), (v,), vector("s"))
    with pytest.raises(ValueError, match="belongs to no vector"):
        vector_form(Builder(), "Q", sp.Matrix([v.y + 1, v.z]), (v,), vector("s"))
    with pytest.raises(ValueError, match="not a function of"):
        scalar_form(v.y**2 + 2 * v.z**2, v, sp.Symbol("vv"))


@pytest.mark.parametrize(
    "expr", [sp.sin(A), A ** sp.Rational(1, 3), (A + B) ** 2, A * sp.Rational(1, 3), A**-2, 1 / sp.sqrt(A)]
)
def test_what_no_language_has_is_rejected(expr: sp.Expr) -> None:
    rejects(r"cannot lower|base needs a name", expression, expr)
