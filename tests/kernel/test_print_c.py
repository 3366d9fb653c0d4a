"""The printer of C: every node is spelled as C99 that compiles without a warning."""

import subprocess
from pathlib import Path

import pytest

from stewart_sym.derive.kernel.tree.nodes import (
    Argument,
    Array,
    As,
    Assign,
    Binary,
    Break,
    Call,
    Comment,
    Constant,
    Count,
    Do,
    Element,
    Expression,
    Field,
    For,
    From,
    Function,
    If,
    Integer,
    Let,
    Member,
    Name,
    Negative,
    Not,
    Number,
    Pointer,
    Real,
    Record,
    Return,
    Select,
    Structure,
    Table,
    Variable,
)
from stewart_sym.derive.print.c import C

A, B, INDEX, LANE = Name("a"), Name("b"), Name("i"), Name("l")
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


def at(array: Expression, *index: Expression | int) -> Element:
    return Element(array, tuple(Number(i) if isinstance(i, int) else i for i in index))


@pytest.mark.parametrize(
    ("node", "text", "bracketed"),
    [
        (Binary("+", A, Binary("*", A, B)), "a + a*b", "a + (a*b)"),
        (Binary("-", A, Binary("+", A, B)), "a - (a + b)", "a - (a + b)"),
        (Binary("/", A, Binary("*", A, B)), "a/(a*b)", "a/(a*b)"),
        (Binary("*", Negative(A), B), "(-a)*b", "(-a)*b"),
        (Negative(Binary("*", A, B)), "-a*b", "-a*b"),
        (Number(2.0), "REAL(2)", "REAL(2)"),
        (Number(0.5), "STEWART_HALF", "STEWART_HALF"),
        (As(Count(), Number(9)), "9U", "9U"),
        (As(Count(), INDEX), "(size_t)i", "(size_t)i"),
        (From(A, Binary("*", INDEX, Number(6))), "&a[i*6]", "&a[i*6]"),
        (Not(Binary(">", A, B)), "!(a > b)", "!(a > b)"),
        (
            Binary("|", Binary("==", A, Constant("NULL")), Binary("<", Binary("+", A, B), B)),
            "a == NULL || a + b < b",
            "(a == NULL) || ((a + b) < b)",
        ),
        (
            Select(Binary("<=", A, Constant("MAX")), Number(1), Select(Binary(">", A, B), A, B)),
            "a <= STEWART_MAX ? 1 : a > b ? a : b",
            "(a <= STEWART_MAX) ? 1 : (a > b) ? a : b",
        ),
        (Call("size", (at(A, 0, INDEX),)), "STEWART_FABS(a[0][i])", "STEWART_FABS(a[0][i])"),
    ],
)
def test_expressions_bind_as_the_tree_says(node: Expression, text: str, bracketed: str) -> None:
    assert C().text(node) == text
    assert C(brackets=True).text(node) == bracketed


def every_statement() -> tuple[list[Structure], Table, list[Function]]:
    real = Real()
    pair = Structure(
        "pair",
        "Two numbers and lanes.",
        (Field("a", real, "m: one"), Field("lanes", Array(real, (3, 8)))),
        aligned=True,
    )
    table = Table(
        "numbers", Structure("row", "", (Field("x", real), Field("y", Array(real, (2,))))), ((1.0, 0.5, 3.0),)
    )
    to = Member(Name("to"), "lanes")
    missing = Binary("|", *(Binary("==", Name(each), Constant("NULL")) for each in ("many", "out")))
    inner = Function(
        "inner",
        "Sums lanes; the comment of a function may be longer than one line of it can be, and is then broken "
        "between its words.",
        (
            Argument("from", Array(real, (3, 8)), alone=True),
            Argument("to", Record("pair"), changed=True, alone=True),
            Argument("total", real, changed=True),
            Argument("unread", Integer()),
        ),
        None,
        (
            Assign(Name("total"), Number(0.0)),
            For(
                "i",
                Number(0),
                Number(3),
                (
                    For(
                        "l",
                        Number(0),
                        Constant("LANES"),
                        (Assign(at(to, INDEX, LANE), at(Name("from"), INDEX, LANE)),),
                        kept=True,
                    ),
                    Let("x", at(Name("from"), INDEX, 0)),
                    Let("y", at(Name("from"), INDEX, 1)),
                    If(Binary(">", Name("x"), Constant("MAX")), (Break(),), (Comment("Each."),)),
                    Assign(Name("total"), Binary("+", Name("total"), Binary("*", Name("x"), Name("y")))),
                ),
            ),
        ),
        apart=True,
    )
    outer = Function(
        "outer",
        "Everything else.",
        (
            Argument("given", Record("pair")),
            Argument("count", Count()),
            Argument("many", Pointer(real), changed=True),
            Argument("out", Array(real, (3,)), changed=True),
        ),
        Integer(),
        (
            Variable("sum", real, Number(0.0)),
            Variable("made", Record("pair")),
            Variable("rows", Array(real, (2, 7)), blank=True, aligned=True),
            Let("table", Name("numbers"), Pointer(Record("row"))),
            Let("bad", Select(missing, Number(1), Number(0)), Integer()),
            If(Binary("!=", Name("bad"), Number(0)), (Return(Number(5)),)),
            Assign(at(Name("rows"), 0, 6), Member(Name("table"), "x")),
            Do(Call("inner", (Member(Name("made"), "lanes"), Name("made"), Name("sum"), Number(1)))),
            For(
                "pose",
                As(Count(), Number(0)),
                Name("count"),
                (Assign(at(Name("many"), Name("pose")), Member(Name("made"), "a")),),
                type=Count(),
                step=As(Count(), Constant("LANES")),
            ),
            Assign(at(Name("out"), 0), at(Name("rows"), 0, 6)),
            Return(Number(0)),
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
