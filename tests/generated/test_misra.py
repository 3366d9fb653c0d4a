"""MISRA C:2012 by cppcheck's addon: a kit's sources depart from the listed rules and from no others.

What the addon cannot see is asked of text, objects and call graph: no recursion, no heap, no jump, no array
of variable length, no loop without a bound. The rules are those that cppcheck 2.10, of Debian 12, finds.
"""

import re
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import attack_build
import pytest
from builds import needed
from builds import written as written_to
from kits import c_of, kit_of
from sweeps import FULL, slow_but

from stewart_sym.derive.emit.header import common_header
from stewart_sym.derive.generated_files import motion_files
from stewart_sym.derive.package.misra_deviations import deviations
from stewart_sym.kit import Choice

MOTION = ("equations", "forward_dynamics")
PRECISIONS = ("-USTEWART_FLOAT", "-DSTEWART_FLOAT=1")
pytestmark = pytest.mark.filterwarnings("ignore:.*physically impossible")


def committed(stem: str) -> dict[str, str]:
    files = attack_build.sources(stem)
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
EVERY = slow_but(("rotation",), SOURCES)
# Long sources are printed as the others are.
LONG = ("forces", "motion", "derivatives", "reactions", "forces baked", "forces scalar")
ANY = [each for each in EVERY if FULL or each.values[0] not in LONG]


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


def rules_found(source: Path, precision: str = PRECISIONS[0]) -> set[str]:
    """Numbers of the rules by which the addon finds something."""
    command = ["cppcheck", "--addon=misra", "--std=c99", "--quiet", "-D__GNUC__=12", "-USTEWART_REAL"]
    # Without the flow of values, which takes most of the time and is cut off by the clock.
    command += ["-U__cplusplus", "--performance-valueflow-max-time=0", "--template={id}", precision]
    done = subprocess.run(
        [*command, source.name], cwd=source.parent, capture_output=True, text=True, check=True
    )
    found = set(done.stderr.split())
    if "STEWART_RESTRICT" in source.read_text():
        # The addon looks for the word in the source itself, where it is the macro of a header.
        found.add("misra-c2012-8.14")
    assert all(name.startswith("misra-c2012-") for name in found), found
    return {name.removeprefix("misra-c2012-") for name in found}


@pytest.mark.slow
@pytest.mark.parametrize("name", ANY)
def test_the_rules_departed_from_are_the_listed_ones(written, name: str) -> None:
    needed("cppcheck")
    assert rules_found(written(name)) == {each.rule for each in deviations([name])}


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
