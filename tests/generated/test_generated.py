"""The generated C compiles silently wherever it is meant to, and the files hold what they should.

That they are what the derivation writes ``.ci/newcomer`` checks, by ``derive --check``.
"""

import itertools
import re
from pathlib import Path

import pytest
from attack_build import SOME, rotor_flags, sources
from builds import run, written
from kits import STRICT
from sweeps import FULL, slow_but

LANGUAGES = {"c99": ["-x", "c", "-std=c99"], "c++": ["-x", "c++", "-std=c++11"]}
PRECISIONS: dict[str, list[str]] = {"double": [], "float": ["-DSTEWART_FLOAT"]}
OPTIMISED = ("gcc", "double", "c99")
# What one compiler takes in one language, and the other in the other.
FAST_WAYS = {("gcc", "float", "c++"), ("clang", "double", "c99")}
SHORT = ("exact_massless_static_forces", "kinematics", "legs", "torque")
# One printer writes the levels: what compiles in all ways is one of each kind.
WAYS = [
    (*way, stem.removeprefix("stewart_"))
    for way in (itertools.product(("gcc", "clang"), PRECISIONS, LANGUAGES) if FULL else sorted(FAST_WAYS))
    if way != OPTIMISED
    for stem in SOME
    if not stem.endswith("_motion")
]


def compiled_silently(
    folder: Path, compiler: str, precision: str, language: str, kernel: str, *flags: str
) -> None:
    defines = rotor_flags(kernel)
    command = [compiler, *LANGUAGES[language], *STRICT, *PRECISIONS[precision], *defines, *flags]
    written(sources(f"stewart_{kernel}"), folder)
    assert run(*command, f"stewart_{kernel}.c", cwd=folder) == ""


@pytest.mark.parametrize(
    ("compiler", "precision", "language", "kernel"),
    slow_but(SHORT, WAYS, lambda way: way[3] if way[:3] in FAST_WAYS else ""),
)
def test_c_compiles_silently(
    compiler: str, precision: str, language: str, kernel: str, tmp_path: Path
) -> None:
    compiled_silently(tmp_path, compiler, precision, language, kernel, "-fsyntax-only")


OF_EACH_KIND = [stem.removeprefix("stewart_") for stem in SOME]


@pytest.mark.parametrize("kernel", slow_but(SHORT, OF_EACH_KIND if FULL else SHORT))
def test_optimized_c_compiles_silently_and_calls_nothing_but_square_roots(
    kernel: str, tmp_path: Path
) -> None:
    """No heap, no I/O, no pow: gcc turns sqrt into an instruction, so nothing is left to link.

    Warnings that come from optimizing show here; all others need no code. Float: ``test_float``.
    """
    target = str(tmp_path / "k.o")
    compiled_silently(tmp_path, "gcc", "double", "c99", kernel, "-O1", "-c", "-o", target)
    undefined = {line.split()[-1] for line in run("nm", "-u", target).splitlines()}
    forces = {"stewart_exact_forces", "stewart_exact_forces_batch"}
    copies = {"memcpy", "memmove", "memset"}
    assert undefined <= forces | copies | {"sqrt", "_GLOBAL_OFFSET_TABLE_"}
    data = run("nm", target)
    assert not re.search(r" [bBdDC] ", data), "a global variable"
