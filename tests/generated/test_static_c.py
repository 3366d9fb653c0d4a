"""C that never varies stands in files; compilers, cppcheck, gcc -fanalyzer and clang-tidy find nothing.

What is suppressed stands in SUPPRESSED, with the reason.
"""

import re
import shutil
from pathlib import Path

import attack_build
import pytest
from builds import needed, run, written
from kits import c_of, kit_of
from sweeps import FULL

from stewart_sym.kit import Choice
from stewart_sym.studies.robustness import oracle

REPOSITORY = Path(__file__).parents[2]
STRICT = ("-std=gnu99", "-fsyntax-only", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror")


@pytest.mark.parametrize("precision", ["float", "wide"])
def test_the_c_of_the_stability_study_compiles_without_a_warning(precision: str, tmp_path: Path) -> None:
    folder = written(oracle.sources(), tmp_path)
    compiler = "gcc" if shutil.which("gcc") else "cc"
    assert run(compiler, *STRICT, *oracle._FLAGS[precision], "kernels.c", cwd=folder) == ""


def static_c() -> list[Path]:
    """Every C file of the studies and every C template that holds no word to be filled in but a version."""
    studies = [*(REPOSITORY / "stewart_sym").rglob("*.[ch]")]
    templates = [
        path
        for path in (REPOSITORY / "derive").rglob("*.[ch].in")
        if not set(re.findall(r"\$\{?(\w+)", path.read_text(encoding="utf-8"))) - {"version"}
    ]
    return sorted(studies + templates)


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which("cppcheck"), reason="needs cppcheck")
def test_cppcheck_finds_nothing_in_static_c() -> None:
    lint = ("--enable=warning,performance,portability", "--error-exitcode=1", "--language=c", "--std=c99")
    lint += ("--max-configs=64",)
    assert run("cppcheck", "-q", *lint, *static_c()) == ""


SUPPRESSED = {
    "cppcheck": {
        "ctuuninitvar": "a structure assigned member by member; the analyzers of gcc and clang follow it",
        "duplicateValueTernary": "pairs of choices exchange rows; cppcheck takes both rows for the same",
        "variableScope": "declarations stand at the head of a function, as in all of the emitted C",
        "missingIncludeSystem": "system headers are not analyzed",
        "redundantAssignment": "the search of a pivot is unrolled: the next column's begins by an assignment",
        "unusedStructMember": "C has no structure without members",
    },
    "clang-tidy": {
        "bugprone-easily-swappable-parameters": "static functions whose only callers are emitted with them",
        "bugprone-implicit-widening-of-multiplication-result": "an index of lane or row times a width",
        "bugprone-suspicious-memory-comparison": "the self-test holds a rejected call to leaving every byte",
        "clang-analyzer-core.uninitialized.Assign": "`fault_of` repeats the test that led to it, which is "
        "not followed; gcc's analyzer and MemorySanitizer see reads of what is not set",
        "cert-exp42-c": "the same",
        "cert-flp37-c": "the same",
    },
}
EVERY = (
    *("stewart_exact", "stewart_exact_motion", "stewart_exact_bounds", "stewart_exact_forces"),
    *("stewart_exact_massless_static_forces", "stewart_exact_regressor"),
    *("stewart_kinematics", "stewart_legs"),
)
"""One source of each emitter; the last are short."""
OF_KIT = ("stewart_exact_pose", "stewart_robot", "selftest", "main")
SOURCES = (*(EVERY if FULL else EVERY[-2:]), *OF_KIT)
IN_FLOAT = ("stewart_exact_forces", "stewart_exact_pose", "stewart_kinematics")
"""Other types and constants in the same text; compilers warn of conversions in all of it."""
TIDIED = [
    *(pytest.param(source, [], id=source) for source in SOURCES),
    *(pytest.param(source, ["-DSTEWART_FLOAT"], id=f"{source}-float") for source in IN_FLOAT if FULL),
]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """All sources, those of a kit beside the committed ones."""
    place = tmp_path_factory.mktemp("sources")
    written(attack_build.sources(*(stem for stem in SOURCES if stem not in OF_KIT)), place)
    made = c_of(kit_of(choice=Choice(("forces", "kinematics"), scalar=True)))
    return written({Path(name).name: text for name, text in made.items()}, place)


@pytest.mark.slow
@pytest.mark.parametrize("source", SOURCES)
def test_cppcheck_finds_nothing(source: str, folder: Path) -> None:
    needed("cppcheck")
    command = ["cppcheck", "--enable=warning,style,performance,portability", "--std=c99"]
    # The macros that choose what is compiled, so that one configuration is checked and not each combination.
    command += ["-D__GNUC__=12", "-USTEWART_REAL", "-USTEWART_FLOAT", "-U__cplusplus", "--quiet"]
    command += [f"--suppress={name}" for name in SUPPRESSED["cppcheck"]]
    command += ["--error-exitcode=3", f"{source}.c"]
    assert attack_build.ran(command, folder) == ""


@pytest.mark.slow
@pytest.mark.parametrize("source", SOURCES)
def test_the_analyzer_of_gcc_finds_nothing(source: str, folder: Path) -> None:
    needed("gcc")
    command = ["gcc", "-std=c99", "-O2", "-fanalyzer", "-S", "-o", "/dev/null", f"{source}.c"]
    assert attack_build.ran(command, folder) == ""


@pytest.mark.slow
@pytest.mark.parametrize(("source", "precision"), TIDIED)
def test_clang_tidy_finds_nothing(source: str, precision: list[str], folder: Path) -> None:
    needed("clang-tidy")
    checks = ["-*", "bugprone-*", "cert-*", "clang-analyzer-*"]
    checks += [f"-{name}" for name in SUPPRESSED["clang-tidy"]]
    command = ["clang-tidy", "--quiet", f"--checks={','.join(checks)}", "--warnings-as-errors=*"]
    found = attack_build.ran([*command, f"{source}.c", "--", "-std=c99", *precision], folder)
    assert "warning:" not in found
