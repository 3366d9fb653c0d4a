"""The reader of written functions: what is settled when a text is read, scopes, early return, addresses."""

from typing import Any

import pytest

from stewart_sym.derive.kernel.tree import nodes as t
from stewart_sym.derive.kernel.tree import read
from stewart_sym.derive.print.c import C

# What stands in these texts are names of the program that they are read into.
# ruff: noqa: F821, B018


def settled(x: "array(3)", y: "Real") -> "Real":  # type: ignore[name-defined]
    if FIRST:
        ADDED
    else:
        y = y + 2.0
    for i in each(2):
        part[i,] = x[i] if FIRST else x[2]
    return part[0,] + part[1,]


def scoped(x: "array(3)", count: "Integer") -> "Integer":  # type: ignore[name-defined]
    for i in range(3):
        code = count + i
        if code > 2:
            return code
    code = 7
    code = code + count
    return code


def scaled(x: "array(3)", by: "Real") -> None:  # type: ignore[name-defined]
    for i in columns(1, 3):
        x[i] = x[i] * by
    for i in range(3):
        x[i] = x[i] * by


def through(to: "Arrays", from_one: "Pointer(Real)", count: "Count") -> None:  # type: ignore[name-defined]
    for pose in range(count):
        if from_one is not None and not from_one[pose] > 1.0:
            to.F[pose * 6 + 1] = from_one[pose]


def shaped(A: "array(3, 3)", x: "array(3)") -> "Real":  # type: ignore[name-defined]
    for i in each(2, -1, -1):
        before(i)
        for j in each(i, LAST if LAST < 3 and i == 0 else 3):
            total[i,] = a[i, j] if i == 2 else x[j]
    return x[0]


def divided(i) -> None:
    """What stands before."""
    if not ROLLED or LAST == 4:
        a[i, i] = a[i, i] / x[i]


def checked(x: "array(3)", most: "Real") -> "Integer":  # type: ignore[name-defined]
    for i in each(3):
        begin(i)
    for i in each(3):
        reject(x[i] <= 2.0 * most, i + 1)
    return 0


def returned(holds, code) -> None:
    """An early return."""
    if not holds:
        return code


def element(*index: Any) -> t.Element:
    return t.Element(t.Name("A"), index)


def test_one_text_is_read_into_several_shapes() -> None:
    """Loops, or line after line; entries of an array, or variables; calls replaced by lines."""
    common = {"before": divided, "LAST": 3}
    shapes = {"total": lambda *_: t.Name("sum"), "a": element, "ROLLED": 1, "LAST": 4}
    rolled = "\n".join(C().function(read.function(shaped, {}, {}, given=common | shapes)))
    assert "for (i = 2; i >= 0; --i)" in rolled
    assert "for (j = i; j < 3; ++j)" in rolled
    assert "A[i][i] = A[i][i]/x[i];" in rolled
    assert "sum = i == 2 ? A[i][j] : x[j];" in rolled
    lines = "\n".join(C().function(read.function(shaped, {}, {}, given=common | {"a": element, "ROLLED": 0})))
    assert "for (" not in lines
    assert lines.index("A[2][2] = A[2][2]/x[2];") < lines.index("A[0][0] = A[0][0]/x[0];")
    assert "total_2 = A[2][2];" in lines
    assert "total_1 = x[1];" in lines


def test_lines_of_another_text_take_what_it_is_called_with() -> None:
    """Expressions as well; a call for which nothing is given leaves nothing, nor does a loop around it."""
    given = {"ROLLED": 1, "begin": (), "reject": returned}
    rolled = "\n".join(C().function(read.function(checked, {}, {}, given=given)))
    assert rolled.count("for (") == 1
    assert "if (!(x[i] <= REAL(2)*most)) {\n            return i + 1;" in rolled
    assert read.used(checked, given={"reject": shaped}) == [
        *("Real", "Integer", "each", "array", "before"),
        "begin",
    ]


def test_conditions_loops_and_registers_are_settled_when_a_text_is_read() -> None:
    added = (t.Assign(t.Name("y"), t.Number(1.0)),)
    one = read.function(settled, {}, {}, given={"FIRST": 1, "ADDED": added})
    other = read.function(settled, {}, {}, given={"FIRST": 0, "ADDED": added})
    assert one.body[0] == added[0]
    assert [each.name for each in one.body if isinstance(each, t.Let)] == ["part_0", "part_1"]
    assert len({each.value for each in one.body if isinstance(each, t.Let)}) == 2
    assert len({each.value for each in other.body if isinstance(each, t.Let)}) == 1


def test_columns_are_a_range_that_stays_a_loop() -> None:
    row, other = (each for each in read.function(scaled, {}, {}).body if isinstance(each, t.For))
    assert (row.first, row.last, row.kept) == (t.Number(1), t.Number(3), True)
    assert not other.kept


def test_a_name_ends_with_its_block_and_changes_make_variables() -> None:
    body = read.function(scoped, {}, {}).body
    made = [
        each for each in t.statements(body) if isinstance(each, t.Let | t.Variable) and each.name == "code"
    ]
    assert len(made) == 2
    assert sum(isinstance(each, t.Return) for each in t.statements(body)) == 2


def test_an_argument_given_as_false_is_left_out() -> None:
    found = read.function(scoped, {}, {}, given={"x": False})
    assert [each.name for each in found.arguments] == ["count"]


def test_what_an_address_in_a_structure_leads_to_is_no_part_of_it() -> None:
    arrays = t.Structure("arrays", "", (t.Field("F", t.Pointer(t.Real())),))
    signature = t.Function("take", "", (), None, (t.Return(None),))
    found = read.function(through, {"Arrays": arrays}, {"take": signature})
    text = "\n".join(C().function(found))
    assert "to->F[pose*6U + 1U] = from_one[pose];" in text
    assert "if (from_one != NULL && !(from_one[pose] > REAL(1))) {" in text
    assert "for (pose = 0; pose < count; ++pose) {" in text


def test_a_call_of_a_function_that_is_not_known_is_rejected() -> None:
    def wrong(x: "Real") -> "Real":  # type: ignore[name-defined]
        return unknown(x)

    with pytest.raises(ValueError, match="wrong: expected a function of the program, got unknown"):
        read.function(wrong, {}, {})


def test_calls_are_counted_against_their_arguments() -> None:
    none: tuple[Any, ...] = ()
    with pytest.raises(ValueError, match="zip"):
        C([t.Function("f", "", none, None, none)]).text(t.Call("f", (t.Name("x"),)))
