"""Expressions as text that C and Python read alike; shared by the emitters.

Only sums, products, integer powers, reciprocals and square roots occur; anything else is an error here and
not a surprise in a compiler. The order of the terms fixes the order of the rounding errors, so that C and
NumPy agree.
"""

import re

import sympy as sp

from ..block import terms_in_order

WIDTH = 108
HALF = {"STEWART_SQRT": "STEWART_HALF"}
WHOLE = {"STEWART_SQRT": "REAL({})"}
"""One half and whole numbers by the language's square root: C has them for each arithmetic."""


def infix(expr: sp.Expr, sqrt: str) -> str:
    """``expr`` as text; ``sqrt`` is the name of the square root function. ValueError for other functions."""
    expr = sp.sympify(expr)
    if expr.is_Symbol:
        return str(expr.name)
    if expr.is_Integer:
        return _whole(int(expr), sqrt)
    if expr == sp.Rational(1, 2):
        return HALF.get(sqrt, "0.5")
    if expr.is_Add:
        return _sum(expr, sqrt)
    if expr.is_Mul:
        return _product(expr, sqrt)
    if expr.is_Pow:
        return _power(expr, sqrt)
    raise ValueError(f"cannot print {type(expr).__name__}: {expr}")


def _whole(number: int, sqrt: str) -> str:
    text = WHOLE.get(sqrt, "{}").format(abs(number))
    return f"-{text}" if number < 0 else text


def _sum(expr: sp.Add, sqrt: str) -> str:
    text = ""
    for term in terms_in_order(expr):
        if term.could_extract_minus_sign():
            text = f"{text} - {_factor(-term, sqrt)}" if text else f"-{_factor(-term, sqrt)}"
        else:
            text = f"{text} + {infix(term, sqrt)}" if text else infix(term, sqrt)
    return text


def _product(expr: sp.Mul, sqrt: str) -> str:
    coefficient, rest = expr.as_coeff_Mul()
    if coefficient.is_negative:
        return "-" + _factor(-expr, sqrt)
    factors = ([coefficient] if coefficient != 1 else []) + list(sp.Mul.make_args(rest))
    over = [f.base for f in factors if f.is_Pow and f.exp == -1]
    upper = [f for f in factors if not (f.is_Pow and f.exp == -1)]
    text = "*".join(_factor(f, sqrt) for f in upper) or _whole(1, sqrt)
    if not over:
        return text
    under = "*".join(_factor(f, sqrt) for f in over)
    return f"{text}/{under}" if len(over) == 1 else f"{text}/({under})"


def _factor(expr: sp.Expr, sqrt: str) -> str:
    text = infix(expr, sqrt)
    return f"({text})" if expr.is_Add or text.startswith("-") else text


def _power(expr: sp.Pow, sqrt: str) -> str:
    if expr.exp == sp.Rational(1, 2):
        return f"{sqrt}({infix(expr.base, sqrt)})"
    if expr.exp == -1:
        return f"{_whole(1, sqrt)}/{_factor(expr.base, sqrt)}"
    if expr.exp.is_Integer and expr.exp > 1 and expr.base.is_Symbol:
        return "*".join([expr.base.name] * int(expr.exp))
    raise ValueError(f"cannot print the power {expr}: its base needs a name")


def wrap(text: str, indent: str, before: str = "[+-]") -> str:
    """Break a long sum before a ``+`` or ``-`` between terms; continuation lines get ``indent``.

    before: pattern of the operators.
    """
    lines, line = [], ""
    for piece in re.split(rf" (?={before} )", text):
        if line and len(line) + 1 + len(piece) > WIDTH:
            lines.append(line)
            line = indent + piece
        else:
            line = f"{line} {piece}" if line else piece
    return "\n".join([*lines, line])
