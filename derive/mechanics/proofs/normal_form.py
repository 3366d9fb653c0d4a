"""Normal form of the expressions of a leg, which proves that two of them are equal.

Expressions are polynomials in all symbols and in 1/L and 1/k3. The symbols of the leg's geometry satisfy
relations such as k1^2 + k3^2 = 1. These relations are a Groebner basis, so the remainder of the division by
them is unique. Two expressions are equal if the normal form of their difference is zero, without a search for
the simplest form.
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
    """Reduce an expression to a polynomial in L, k1, k3 and the other symbols, with k1 to the power 0 or 1.

    kappa, inv_rho, inv_L, and inv_k3 are replaced by their definitions.

    Raises
    ------
    ValueError
        If the expression is not a polynomial in its other symbols.
    """
    expr = sp.sympify(expr).xreplace(_QUOTIENTS)
    powers = [power for power in expr.atoms(sp.Pow) if power.base in _INVERSES and power.exp.is_negative]
    expr = expr.xreplace({power: _INVERSES[power.base] ** -power.exp for power in powers})
    rest = sorted(expr.free_symbols - set(_FIRST), key=str)
    ring = sp.ring([*_FIRST, *rest], sp.QQ, "grevlex")[0]
    left = ring.from_expr(expr).rem([ring.from_expr(relation) for relation in _RELATIONS])
    return left.as_expr().xreplace({short: 1 / symbol for symbol, short in _INVERSES.items()})


def vanishes(expr: sp.Expr | sp.Matrix) -> bool:
    """Return True if the expression, or every entry of the matrix, is zero."""
    return all(normal_form(entry) == 0 for entry in (expr if isinstance(expr, sp.MatrixBase) else [expr]))
