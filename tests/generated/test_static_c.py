"""C that never varies stands in files: compilers and linters take each as it is."""

import ast
import re
import shutil
from collections.abc import Iterator
from importlib.resources import files
from pathlib import Path

import pytest
from builds import run, written

from stewart_sym.derive import package
from stewart_sym.precision import quad
from stewart_sym.studies.robustness.sweep import oracle

REPOSITORY = Path(__file__).parents[2]
STRICT = ("-std=gnu99", "-fsyntax-only", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror")
TEMPLATES = files(package) / "templates" / "kit"
LONGEST = 20
"""Lines of another language that may stand in a Python string."""

SWEEP = oracle.sources()
OWN = sorted(name for name in SWEEP if not name.startswith("stewart_") and name.endswith(".c"))
UNIT = {
    "prepared": '#include "stewart_exact_forces.h"\n#define ROBOT {0}\n#define MODEL stewart_exact_model\n'
    "#define PREPARE stewart_exact_prepare\n#define KERNEL stewart_exact_forces\n"
    "#define TAKE_PAYLOAD(value, robot) narrowed(value, 1, &robot.M);\n",
    "baked": '#include "stewart.h"\nint of_robot(const stewart_motion *motion, stewart_real F[6]);\n'
    "#define KERNEL of_robot\n",
}
"""Two units as ``stewart_unit.h`` may describe them, but for what both have."""


def checked(folder: Path, name: str, *flags: str) -> None:
    """Compile a file without a word of gcc and clang, and let cppcheck read it."""
    commands = [(compiler, *STRICT, *flags, name) for compiler in ("gcc", "clang") if shutil.which(compiler)]
    if shutil.which("cppcheck"):
        lint = ("--enable=warning,portability", "--error-exitcode=1", "--inline-suppr", "-USTEWART_REAL")
        commands.append(("cppcheck", "-q", *lint, "--suppress=preprocessorErrorDirective", name))
    for command in commands:
        assert run(*command, cwd=folder) == "", command


@pytest.mark.parametrize("name", OWN)
def test_the_c_of_the_sweep_compiles_without_a_warning(name: str, tmp_path: Path) -> None:
    if "QUAD" in SWEEP[name] and not shutil.which("gcc"):
        pytest.skip("needs gcc: __float128")
    folder = written(SWEEP, tmp_path)
    compiler = "gcc" if shutil.which("gcc") else "cc"
    command = [compiler, *STRICT, "-Wno-float-conversion", name]
    assert run(*command, cwd=folder) == ""


def test_the_c_of_quadruple_precision_compiles_without_a_warning(tmp_path: Path) -> None:
    folder = written(quad.sources("exact"), tmp_path)
    macros = [f"-D{name}={value}" for name, value in quad._MACROS.items()]
    command = ["gcc", *STRICT, "-include", "quadmath.h", *macros, "quad.c"]
    assert run(*command, cwd=folder) == ""


@pytest.mark.parametrize("which", UNIT)
def test_the_c_of_the_unit_is_c_before_it_is_filled(which: str, tmp_path: Path) -> None:
    """``$version`` stands in comments alone."""
    for name in ("stewart_fmi2.h", "stewart_fmi2.c"):
        (tmp_path / name).write_text((TEMPLATES / f"{name}.in").read_text(encoding="utf-8"))
    for path in (files("stewart_sym.generated") / "c").iterdir():
        if path.name.endswith(".h"):
            (tmp_path / path.name).write_text(path.read_text(encoding="utf-8"))
    common = (
        '#define GUID "{}"\n#define INPUTS 30u\n#define REALS 37u\n#define START_VALUES {0}\n'
        '#define STATUS_MEANINGS {"solved"}\n'
        "#define TAKE_MOTION(value, motion) narrowed(value, 9, motion.R);\n"
    )
    (tmp_path / "stewart_unit.h").write_text(UNIT[which] + common)
    checked(tmp_path, "stewart_fmi2.c")


def static_c() -> list[Path]:
    """Every C file of the studies and every C template that holds no word to be filled in but a version."""
    studies = [*(REPOSITORY / "stewart_sym").rglob("*.[ch]")]
    templates = [
        path
        for path in (REPOSITORY / "derive").rglob("*.[ch].in")
        if not set(re.findall(r"\$\{?(\w+)", path.read_text(encoding="utf-8"))) - {"version"}
    ]
    return sorted(studies + templates)


@pytest.mark.skipif(not shutil.which("cppcheck"), reason="needs cppcheck")
@pytest.mark.parametrize("path", static_c(), ids=lambda path: path.name)
def test_cppcheck_finds_nothing_in_static_c(path: Path) -> None:
    lint = ("--enable=warning,performance,portability", "--error-exitcode=1", "--language=c", "--std=c99")
    lint += ("--max-configs=64",)
    assert run("cppcheck", "-q", *lint, path) == ""


@pytest.mark.parametrize("folder", sorted((REPOSITORY / "derive").rglob("templates")), ids=str)
def test_every_template_is_filled_somewhere(folder: Path) -> None:
    users = "".join(path.read_text(encoding="utf-8") for path in (REPOSITORY / "derive").rglob("*.py"))
    unused = []
    for path in folder.rglob("*.in"):
        name = path.name.removesuffix(".in")
        # The names of some are put together: of a language, or of a list.
        known = (name, name.partition("_")[2].partition(".")[0], name.partition(".")[0])
        if not any(re.search(rf"[\"/]{re.escape(each)}\b", users) for each in known if each):
            unused.append(str(path))
    assert unused == []


def literals(path: Path) -> Iterator[tuple[int, int]]:
    """Line and height of each string over several lines that is no docstring."""
    nodes = list(ast.walk(ast.parse(path.read_text(encoding="utf-8"))))
    joined = [node for node in nodes if isinstance(node, ast.JoinedStr)]
    left_out = {id(node.value) for node in nodes if isinstance(node, ast.Expr)}
    left_out |= {id(part) for node in joined for part in ast.walk(node) if part is not node}
    texts = [node for node in nodes if isinstance(node, ast.Constant) and isinstance(node.value, str)]
    for node in (*joined, *texts):
        if id(node) not in left_out:
            yield node.lineno, (node.end_lineno or node.lineno) - node.lineno + 1


@pytest.mark.parametrize("folder", ["derive/package", "derive/kernel", "derive/print", "stewart_sym"])
def test_no_long_text_of_another_language_stands_in_python(folder: str) -> None:
    long = [
        f"{path.relative_to(REPOSITORY)}:{line}: {height} lines"
        for path in sorted((REPOSITORY / folder).rglob("*.py"))
        for line, height in literals(path)
        if height > LONGEST
    ]
    assert long == []
