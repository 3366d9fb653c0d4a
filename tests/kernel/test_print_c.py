"""The printer of C: parentheses stand where operators bind less than the tree does.

How statements, functions, structures and tables are spelled, the committed files show, and kits with a
robot's numbers folded in: ``test_generated`` and ``test_kit`` compile them with all warnings as errors.
"""

import pytest

from stewart_sym.derive.kernel.tree import nodes as t
from stewart_sym.derive.print.c import C

A, B, INDEX = t.Name("a"), t.Name("b"), t.Name("i")


@pytest.mark.parametrize(
    ("node", "text", "bracketed"),
    [
        (t.Binary("+", A, t.Binary("*", A, B)), "a + a*b", "a + (a*b)"),
        (t.Binary("-", A, t.Binary("+", A, B)), "a - (a + b)", "a - (a + b)"),
        (t.Binary("/", A, t.Binary("*", A, B)), "a/(a*b)", "a/(a*b)"),
        (t.Binary("*", t.Negative(A), B), "(-a)*b", "(-a)*b"),
        (t.Negative(t.Binary("*", A, B)), "-a*b", "-a*b"),
        (t.Number(2.0), "REAL(2)", "REAL(2)"),
        (t.Number(0.5), "STEWART_HALF", "STEWART_HALF"),
        (t.As(t.Count(), t.Number(9)), "9U", "9U"),
        (t.As(t.Count(), INDEX), "(size_t)i", "(size_t)i"),
        (t.From(A, t.Binary("*", INDEX, t.Number(6))), "&a[i*6]", "&a[i*6]"),
        (t.Not(t.Binary(">", A, B)), "!(a > b)", "!(a > b)"),
        (
            t.Binary("|", t.Binary("==", A, t.Constant("NULL")), t.Binary("<", t.Binary("+", A, B), B)),
            "a == NULL || a + b < b",
            "(a == NULL) || ((a + b) < b)",
        ),
        (
            t.Select(t.Binary("<=", A, t.Constant("MAX")), t.Number(1), t.Select(t.Binary(">", A, B), A, B)),
            "a <= STEWART_MAX ? 1 : a > b ? a : b",
            "(a <= STEWART_MAX) ? 1 : (a > b) ? a : b",
        ),
        (t.Call("size", (t.at(A, 0, INDEX),)), "STEWART_FABS(a[0][i])", "STEWART_FABS(a[0][i])"),
    ],
)
def test_expressions_bind_as_the_tree_says(node: t.Expression, text: str, bracketed: str) -> None:
    assert C().text(node) == text
    assert C(brackets=True).text(node) == bracketed
