"""The printer of C: every node is spelled as C99 that compiles without a warning."""

import subprocess
from pathlib import Path

import pytest

from stewart_sym.derive.kernel.tree import nodes as t
from stewart_sym.derive.print.c import C

A, B, INDEX, LANE = t.Name("a"), t.Name("b"), t.Name("i"), t.Name("l")
HEAD = """#include <math.h>
#include <stddef.h>
typedef double stewart_real;
#define REAL(value) ((stewart_real)(value))
#define STEWART_HALF REAL(0.5)
#define STEWART_SQRT(value) sqrt(value)
#define STEWART_FABS(value) fabs(value)
#define STEWART_LARGER(one, other) ((one) > (other) ? (one) : (other))
#define STEWART_FMA(a, b, c) ((a) * (b) + (c))
#define STEWART_MAX 1e300
#define STEWART_RESTRICT restrict
#define STEWART_APART __attribute__((noinline))
#define STEWART_ALIGNED __attribute__((aligned(64)))
#define STEWART_LOOP _Pragma("GCC unroll 1")
#define STEWART_NODISCARD __attribute__((warn_unused_result))
#define LANES 8
"""


def at(array: t.Expression, *index: t.Expression | int) -> t.Element:
    return t.Element(array, tuple(t.Number(i) if isinstance(i, int) else i for i in index))


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
        (t.Call("size", (at(A, 0, INDEX),)), "STEWART_FABS(a[0][i])", "STEWART_FABS(a[0][i])"),
    ],
)
def test_expressions_bind_as_the_tree_says(node: t.Expression, text: str, bracketed: str) -> None:
    assert C().text(node) == text
    assert C(brackets=True).text(node) == bracketed


def every_statement() -> tuple[list[t.Structure], t.Table, list[t.Function]]:
    real = t.Real()
    pair = t.Structure(
        "pair",
        "Two numbers and lanes.",
        (t.Field("a", real, "m: one"), t.Field("lanes", t.Array(real, (3, 8)))),
        aligned=True,
    )
    table = t.Table(
        "numbers",
        t.Structure("row", "", (t.Field("x", real), t.Field("y", t.Array(real, (2,))))),
        ((1.0, 0.5, 3.0),),
    )
    to = t.Member(t.Name("to"), "lanes")
    missing = t.Binary("|", *(t.Binary("==", t.Name(each), t.Constant("NULL")) for each in ("many", "out")))
    inner = t.Function(
        "inner",
        "Sums lanes; the comment of a function may be longer than one line of it can be, and is then broken "
        "between its words.",
        (
            t.Argument("from", t.Array(real, (3, 8)), alone=True),
            t.Argument("to", t.Record("pair"), changed=True, alone=True),
            t.Argument("total", real, changed=True),
            t.Argument("unread", t.Integer()),
        ),
        None,
        (
            t.Assign(t.Name("total"), t.Number(0.0)),
            t.For(
                "i",
                t.Number(0),
                t.Number(3),
                (
                    t.For(
                        "l",
                        t.Number(0),
                        t.Constant("LANES"),
                        (t.Assign(at(to, INDEX, LANE), at(t.Name("from"), INDEX, LANE)),),
                        kept=True,
                    ),
                    t.Let("x", at(t.Name("from"), INDEX, 0)),
                    t.Let("y", at(t.Name("from"), INDEX, 1)),
                    t.If(t.Binary(">", t.Name("x"), t.Constant("MAX")), (t.Break(),), (t.Comment("Each."),)),
                    t.Assign(
                        t.Name("total"),
                        t.Binary("+", t.Name("total"), t.Binary("*", t.Name("x"), t.Name("y"))),
                    ),
                ),
            ),
        ),
        apart=True,
    )
    outer = t.Function(
        "outer",
        "Everything else.",
        (
            t.Argument("given", t.Record("pair")),
            t.Argument("count", t.Count()),
            t.Argument("many", t.Pointer(real), changed=True),
            t.Argument("out", t.Array(real, (3,)), changed=True),
        ),
        t.Integer(),
        (
            t.Variable("sum", real, t.Number(0.0)),
            t.Variable("made", t.Record("pair")),
            t.Variable("rows", t.Array(real, (2, 7)), blank=True, aligned=True),
            t.Let("table", t.Name("numbers"), t.Pointer(t.Record("row"))),
            t.Let("bad", t.Select(missing, t.Number(1), t.Number(0)), t.Integer()),
            t.If(t.Binary("!=", t.Name("bad"), t.Number(0)), (t.Return(t.Number(5)),)),
            t.Assign(at(t.Name("rows"), 0, 6), t.Member(t.Name("table"), "x")),
            t.Do(
                t.Call(
                    "inner", (t.Member(t.Name("made"), "lanes"), t.Name("made"), t.Name("sum"), t.Number(1))
                )
            ),
            t.For(
                "pose",
                t.As(t.Count(), t.Number(0)),
                t.Name("count"),
                (t.Assign(at(t.Name("many"), t.Name("pose")), t.Member(t.Name("made"), "a")),),
                type=t.Count(),
                step=t.As(t.Count(), t.Constant("LANES")),
            ),
            t.Assign(at(t.Name("out"), 0), at(t.Name("rows"), 0, 6)),
            t.Return(t.Number(0)),
        ),
        public=True,
    )
    return [pair], table, [inner, outer]


@pytest.mark.parametrize("brackets", [False, True])
def test_every_statement_compiles_without_a_warning(tmp_path: Path, brackets: bool) -> None:
    structures, table, functions = every_statement()
    printer = C(functions, {8: "LANES"}, brackets)
    parts = [
        *(printer.structure(each) for each in structures),
        printer.table(table),
        printer.declaration(functions[-1]),
        *(printer.function(each) for each in functions),
    ]
    text = HEAD + "\n\n".join("\n".join(lines) for lines in parts) + "\n"
    assert [line for line in text.splitlines() if len(line) > 108] == []
    assert "const stewart_real x = from[i][0], y = from[i][1];" in text
    assert "inner(made.lanes, &made, &sum, 1);" in text
    assert "for (pose = 0U; pose < count; pose += (size_t)LANES)" in text
    assert "STEWART_LOOP for (l = 0; l < LANES; ++l)" in text
    assert "} STEWART_ALIGNED pair;" in text
    assert "STEWART_ALIGNED stewart_real rows[2][7];" in text
    source = tmp_path / "all.c"
    source.write_text(text)
    command = ["gcc", "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-c", str(source)]
    subprocess.run([*command, "-o", str(tmp_path / "all.o")], check=True)
