"""MISRA C:2012 by cppcheck's addon: a kit's sources depart from the listed rules and from no others.

What the addon cannot see is asked of text, objects and call graph: no recursion, no heap, no jump, no array
of variable length, no loop without a bound. The rules are those that cppcheck 2.10, of Debian 12, finds.
"""

import re
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import attack_build
import pytest
from builds import needed
from builds import written as written_to
from kits import c_of, kit_of
from sweeps import FULL, slow_but

from stewart_sym.derive.emit.header import common_header
from stewart_sym.derive.generate import motion_files
from stewart_sym.derive.package.misra_deviations import DEVIATIONS, KINDS, deviations
from stewart_sym.generated.interface import HEADERS
from stewart_sym.kit import Choice

MOTION = ("equations", "forward_dynamics")
PRECISIONS = ("-USTEWART_FLOAT", "-DSTEWART_FLOAT=1")
ARITHMETIC = {"sqrt", "sqrtf", "fabs", "fabsf"}
# What compilers make of copies of structs.
COPIES = {"memcpy", "memset", "memmove"}

pytestmark = pytest.mark.filterwarnings("ignore:.*physically impossible")


def committed(stem: str) -> dict[str, str]:
    names = (*HEADERS, f"{stem}.h", f"{stem}.c")
    files = {name: (attack_build.GENERATED / name).read_text() for name in names}
    if "_drive" in stem:
        files["stewart.h"] = common_header("0", rotors=True)
    return files


def closed_form(functions: tuple[str, ...]) -> dict[str, str]:
    return committed("stewart_exact_forces") | motion_files(functions)


def of_kit(**choice: Any) -> dict[str, str]:
    """The files of a kit of the paper's machine, its programs left out."""
    return c_of(kit_of(choice=Choice(**choice)), r"stewart\w*\.[ch]")


SOURCES: dict[str, tuple[Callable[[], dict[str, str]], str]] = {
    "forces": (lambda: committed("stewart_exact_massless_static_forces"), r"_forces\.c"),
    "forces baked": (lambda: of_kit(bake=True, fidelity="massless_static"), r"_forces\.c"),
    "forces scalar": (lambda: of_kit(scalar=True), r"_pose\.c"),
    "forces scalar baked": (lambda: of_kit(scalar=True, bake=True, fidelity="massless"), r"_pose\.c"),
    "reactions": (lambda: committed("stewart_exact"), r"exact\.c"),
    "motion": (lambda: closed_form(MOTION), r"_motion\.c"),
    "derivatives": (
        lambda: committed("stewart_exact_forces") | committed("stewart_exact_motion"),
        r"_motion\.c",
    ),
    "kinematics": (lambda: committed("stewart_kinematics"), r"_kinematics\.c"),
    "torque": (lambda: committed("stewart_torque"), r"_torque\.c"),
    "axial": (lambda: committed("stewart_exact_drive_axial"), r"_axial\.c"),
    "rotation": (lambda: committed("stewart_rotation"), r"_rotation\.c"),
    "robot": (lambda: of_kit(scalar=True), r"^stewart_robot\.c"),
}
"""Kind of source -> how its files are made, and which of them is looked at."""
EVERY = slow_but(("rotation", "robot"), SOURCES)
# But for what is printed as "motion" is, and is the longest of all.
ANY = [each for each in EVERY if FULL or each.values != ("derivatives",)]


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory):
    """The source of a kind, written beside its headers."""
    made: dict[str, Path] = {}

    def write(kind: str) -> Path:
        if kind not in made:
            make, pattern = SOURCES[kind]
            folder = written_to(make(), tmp_path_factory.mktemp("sources"))
            (made[kind],) = (path for path in folder.glob("*.c") if re.search(pattern, path.name))
        return made[kind]

    return write


def rules_found(source: Path, precision: str = PRECISIONS[0], others: Sequence[str] = ()) -> set[str]:
    """Numbers of the rules by which the addon finds something; others: names of sources beside it."""
    command = ["cppcheck", "--addon=misra", "--std=c99", "--quiet", "-D__GNUC__=12", "-USTEWART_REAL"]
    # Without the flow of values, which takes most of the time and is cut off by the clock.
    command += ["-U__cplusplus", "--performance-valueflow-max-time=0", "--template={id}", precision]
    done = subprocess.run(
        [*command, source.name, *others], cwd=source.parent, capture_output=True, text=True, check=True
    )
    found = set(done.stderr.split())
    if "STEWART_RESTRICT" in source.read_text():
        # The addon looks for the word in the source itself, where it is the macro of a header.
        found.add("misra-c2012-8.14")
    assert all(name.startswith("misra-c2012-") for name in found), found
    return {name.removeprefix("misra-c2012-") for name in found}


@pytest.mark.parametrize("name", ANY)
def test_the_rules_departed_from_are_the_listed_ones(written, name: str) -> None:
    needed("cppcheck")
    assert rules_found(written(name)) == {each.rule for each in deviations([name])}


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["reactions", *(["forces scalar"] if FULL else [])])
def test_float_departs_from_no_other_rule(written, kind: str) -> None:
    needed("cppcheck")
    assert rules_found(written(kind), PRECISIONS[1]) == {each.rule for each in deviations([kind])}


@pytest.mark.slow
def test_sources_side_by_side_depart_from_one_rule_more(tmp_path: Path) -> None:
    needed("cppcheck")
    choice = Choice(("forces", "reactions", "kinematics"), fidelity="massless_static", scalar=True)
    written_to(c_of(kit_of(choice=choice), r"stewart\w*\.[ch]"), tmp_path)
    sources = sorted(path.name for path in tmp_path.glob("*.c"))
    found = rules_found(tmp_path / sources[0], PRECISIONS[0], sources[1:])
    listed = {each.rule for each in deviations(["forces scalar", "reactions", "kinematics"])}
    # Types that one source does not use another does.
    assert found | {"2.3", "2.4"} == listed


def test_the_checker_finds_what_is_there(tmp_path: Path) -> None:
    needed("cppcheck")
    source = tmp_path / "wrong.c"
    source.write_text(
        "#include <stdlib.h>\n"
        "double f(double x, int n)\n{\n"
        "    if (n)\n        goto end;\n"
        "    x = 2 * x;\n"
        "    free(0);\n"
        "end:\n    return f(x, n);\n}\n"
    )
    assert rules_found(source) >= {"8.4", "10.3", "14.4", "15.1", "17.2", "21.3"}


def test_every_deviation_is_of_a_kind_that_is_checked() -> None:
    assert set(KINDS) == set(SOURCES)
    assert all(each.kinds and set(each.kinds) <= set(KINDS) for each in DEVIATIONS)
    assert len({each.rule for each in DEVIATIONS}) == len(DEVIATIONS)


# ---------------------------------------------------------------- beyond the addon


def call_graph(source: Path) -> tuple[dict[str, set[str]], str]:
    """Function -> functions that it calls, before any inlining; and what gcc says of the stack's use."""
    flags = ["-std=c99", "-O0", "-fno-math-errno", "-fcallgraph-info=su", "-Wvla", "-Walloca", "-Werror"]
    attack_build.ran(["gcc", *flags, "-c", source.name, "-o", "graph.o"], source.parent)
    text = next(source.parent.glob("*.ci")).read_text()
    names = dict(re.findall(r'node: { title: "([^"]*)" label: "(\w+)', text))
    calls: dict[str, set[str]] = {names[title]: set() for title in names}
    for caller, called in re.findall(r'edge: { sourcename: "([^"]*)" targetname: "([^"]*)"', text):
        calls[names[caller]].add(names[called])
    return calls, text


@pytest.mark.parametrize("name", ANY)
def test_nothing_recurses_and_the_stack_is_known(written, name: str) -> None:
    needed("gcc")
    calls, said = call_graph(written(name))
    while calls:
        leaves = {function for function, called in calls.items() if not called & set(calls)}
        assert leaves, f"these call each other: {sorted(calls)}"
        calls = {function: called for function, called in calls.items() if function not in leaves}
    assert "bytes (static)" in said or name == "robot"
    assert "bytes (dynamic)" not in said


@pytest.mark.parametrize("name", ANY)
def test_a_source_calls_square_roots_and_copies_alone(written, name: str) -> None:
    needed("gcc", "nm")
    source = written(name)
    for flags in (["-O0"], ["-O2", "-DSTEWART_FLOAT"]):
        attack_build.ran(["gcc", "-std=c99", *flags, "-c", source.name, "-o", "called.o"], source.parent)
        listed = attack_build.ran(["nm", "-u", "called.o"], source.parent).split()
        called = {symbol for symbol in listed if symbol != "U" and not symbol.startswith(("__", "_GLOBAL"))}
        model = {"stewart_exact_forces"} if name in ("motion", "derivatives") else set()
        assert called <= ARITHMETIC | COPIES | model


@pytest.mark.parametrize("name", EVERY)
def test_every_loop_counts_to_a_bound_and_nothing_jumps(written, name: str) -> None:
    text = re.sub(r"/\*.*?\*/", "", written(name).read_text(), flags=re.S)
    assert not re.search(r"\b(while|do|goto|setjmp|longjmp|malloc|calloc|realloc|free|alloca)\b", text)
    step = r"(?:\+\+(\w+)|--(\w+)|(\w+) \+= \(size_t\)(?:LANES|POSES))"
    for loop in re.findall(r"for \((.*)\) {", text):
        counter, end, *stepped = re.fullmatch(rf"(\w+) = [^;]+; ([^;]+); {step}", loop).groups()
        assert counter in stepped
        assert re.search(rf"\b{counter} (<|<=|>=) [\w(]", end)
    assert text.count("for (") == len(re.findall(r"for \((.*)\) {", text))


@pytest.mark.parametrize("name", EVERY)
def test_no_comma_operator(written, name: str) -> None:
    needed("clang")
    source = written(name)
    attack_build.ran(["clang", "-std=c99", "-fsyntax-only", "-Wcomma", "-Werror", source.name], source.parent)
