"""The generated C compiles silently wherever it is meant to, and the files hold what they should.

That they are what the derivation writes ``.ci/newcomer`` checks, by ``derive --check``.
"""

import itertools
import re
from pathlib import Path

import pytest
from attack_build import GENERATED, SOME
from builds import run
from kits import STRICT
from sweeps import slow_but

from stewart_sym.backend.kernel import defines_of
from stewart_sym.derive.mechanics.formulation import FORMULATIONS
from stewart_sym.generated.interface import HEADERS

KERNELS = [form.kernel_name for form in FORMULATIONS]


LANGUAGES = {"c99": ["-x", "c", "-std=c99"], "c++": ["-x", "c++", "-std=c++11"]}
PRECISIONS: dict[str, list[str]] = {"double": [], "float": ["-DSTEWART_FLOAT"]}
OPTIMISED = ("gcc", "double", "c99")
# One printer writes the levels: what compiles in all ways is one of each kind.
WAYS = [
    (*way, stem.removeprefix("stewart_"))
    for way in itertools.product(("gcc", "clang"), PRECISIONS, LANGUAGES)
    if way != OPTIMISED
    for stem in SOME
    if not stem.endswith("_motion")
]


def compiled_silently(compiler: str, precision: str, language: str, kernel: str, *flags: str) -> None:
    defines = [f"-D{name}" for name in defines_of(kernel)]
    command = [compiler, *LANGUAGES[language], *STRICT, *PRECISIONS[precision], *defines, *flags]
    assert run(*command, f"stewart_{kernel}.c", cwd=GENERATED) == ""


# What one compiler takes in one language, and the other in the other.
FAST_WAYS = {("gcc", "float", "c++"), ("clang", "double", "c99")}


@pytest.mark.parametrize(
    ("compiler", "precision", "language", "kernel"),
    slow_but(FAST_WAYS, WAYS, lambda way: way[:3]),
)
def test_c_compiles_silently(compiler: str, precision: str, language: str, kernel: str) -> None:
    compiled_silently(compiler, precision, language, kernel, "-fsyntax-only")


OF_EACH_KIND = sorted({*KERNELS, *(stem.removeprefix("stewart_") for stem in SOME)})


SHORT = ("exact_forces", "exact_massless_static_forces", "kinematics", "legs", "torque")


@pytest.mark.parametrize("kernel", slow_but(SHORT, OF_EACH_KIND))
def test_optimized_c_compiles_silently_and_calls_nothing_but_square_roots(
    kernel: str, tmp_path: Path
) -> None:
    """No heap, no I/O, no pow: gcc turns sqrt into an instruction, so nothing is left to link.

    Warnings that come from optimizing show here; all others need no code. Float: ``test_float``.
    """
    target = str(tmp_path / "k.o")
    compiled_silently("gcc", "double", "c99", kernel, "-O1", "-c", "-o", target)
    undefined = {line.split()[-1] for line in run("nm", "-u", target).splitlines()}
    forces = {"stewart_exact_forces", "stewart_exact_forces_batch"}
    copies = {"memcpy", "memmove", "memset"}
    assert undefined <= forces | copies | {"sqrt", "_GLOBAL_OFFSET_TABLE_"}
    data = run("nm", target)
    assert not re.search(r" [bBdDC] ", data), "a global variable"


def functions_on_plain_numbers(text: str) -> list[str]:
    """Static functions of a source in whose text no type of its own occurs."""
    defined = re.findall(r"^(?:\w+ )*static [^;{}=]*\)\n\{\n.*?^\}$", text, re.M | re.S)
    types = [*re.findall(r"^\} (?:STEWART_ALIGNED )?(\w+);", text, re.M), r"stewart_\w+_(?:leg|model)"]
    own = re.compile(rf"\b(?:{'|'.join(types)})\b")
    return [each for each in defined if not own.search(each)]


def test_a_function_on_plain_numbers_stands_in_one_source_or_in_a_header() -> None:
    """Of more than a dozen lines; no program has both the kernels with rotors and those without."""
    places: dict[str, set[str]] = {}
    for path in sorted(GENERATED.glob("*.c")):
        for each in functions_on_plain_numbers(path.read_text()):
            places.setdefault(each, set()).add(path.name.replace("_drive", ""))
    assert len(places) > 20
    many = {each: found for each, found in places.items() if len(found) > 1}
    assert {each: found for each, found in many.items() if each.count("\n") > 12} == {}


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
@pytest.mark.parametrize("language", LANGUAGES)
def test_a_header_that_sources_share_compiles_alone(compiler: str, language: str) -> None:
    for name in HEADERS:
        command = [compiler, *LANGUAGES[language], *STRICT, "-fsyntax-only", "-include", name, "/dev/null"]
        assert run(*command, cwd=GENERATED) == ""


@pytest.mark.parametrize("kernel", KERNELS)
def test_lines_of_code_cite_the_equations(kernel: str) -> None:
    # The platform is the same for all, in a header.
    source = "".join((GENERATED / f"stewart_{name}").read_text() for name in (f"{kernel}.c", "outputs.h"))
    cited = set(re.findall(r"\((\d+)\)", source))
    expected = {"1", "2", "3", "4", "7", "21", "24", "30", "31", "32", "33", "34"}
    if "spherical" not in kernel:
        expected |= {"5", "6", "8", "9", "10", "12", "13", "14", "17", "18", "19", "20", "23", "25"}
    assert expected <= cited
