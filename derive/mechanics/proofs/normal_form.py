"""The normal form of a leg's expressions, by which two of them are shown to be equal.

Expressions are polynomials in all symbols and in 1/L and 1/k3; the symbols of the leg's geometry obey k1^2
+ k3^2 = 1. Division by these relations, which are a Groebner basis, leaves one form for each expression:
zero is zero, with no search for the simplest form.
"""

import sympy as sp

from ..legs import tip

inv_k3 = sp.Symbol("inv_k3", real=True)
cos_phi, sin_phi = sp.symbols("cos_phi sin_phi", real=True)

_RELATIONS = (
    tip.k1**2 + tip.k3**2 - 1,
    cos_phi**2 + sin_phi**2 - 1,
    tip.L * tip.inv_L - 1,
    tip.k3 * inv_k3 - 1,
)
# The leading terms k1^2, cos_phi^2, L / L and k3 / k3 have no symbol in common.
_FIRST = (tip.k1, cos_phi, tip.L, tip.inv_L, inv_k3, tip.k3, sin_phi)
_QUOTIENTS = {tip.kappa: tip.k1 * inv_k3, tip.inv_rho: tip.inv_L * inv_k3}
_INVERSES = {tip.L: tip.inv_L, tip.k3: inv_k3}


def normal_form(expr: sp.Expr) -> sp.Expr:
    """The expression in L, k1, k3 and the symbols that are no geometry, k1 to the power 0 or 1, expanded.

    kappa, inv_rho, inv_L and inv_k3 are written out. ValueError if the expression is no polynomial in its
    other symbols.
    """
    expr = sp.sympify(expr).xreplace(_QUOTIENTS)
    powers = [power for power in expr.atoms(sp.Pow) if power.base in _INVERSES and power.exp.is_negative]
    expr = expr.xreplace({power: _INVERSES[power.base] ** -power.exp for power in powers})
    rest = sorted(expr.free_symbols - set(_FIRST), key=str)
    ring = sp.ring([*_FIRST, *rest], sp.QQ, "grevlex")[0]
    left = ring.from_expr(expr).rem([ring.from_expr(relation) for relation in _RELATIONS])
    return left.as_expr().xreplace({short: 1 / symbol for symbol, short in _INVERSES.items()})


def vanishes(expr: sp.Expr | sp.Matrix) -> bool:
    """Whether the expression, or every entry of the matrix, is zero."""
    return all(normal_form(entry) == 0 for entry in (expr if isinstance(expr, sp.MatrixBase) else [expr]))
