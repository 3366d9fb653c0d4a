"""The archive of an FMI unit and its C: what it holds, what it shows and what other tools make of it."""

import io
import os
import re
import zipfile
from pathlib import Path

import fmpy
import pytest
from builds import run
from fmpy.validation import validate_fmu
from fmu_units import (
    CASES,
    EVERY,
    contents,
    folder,
    guid,
    made,
    references,
    unit,
)
from kits import COMPILERS, STRICT, few_vectors, silently
from sweeps import FULL

from stewart_sym.backend import native
from stewart_sym.kit import kit
from stewart_sym.kit.fmu import binary_folder


def test_archive_holds_description_page_all_sources_and_the_binary() -> None:
    held = contents(made("lanes").content)
    code = {f"sources/{name}": text.encode() for name, text in made("lanes").sources.items()}
    assert {name: held[name] for name in code} == code
    own = {f"sources/{name}" for name in ("stewart_fmi2.c", "stewart_fmi2.h", "stewart_unit.h")}
    binary = f"{binary_folder()}/{made('lanes').symbol}.so"
    page = {"modelDescription.xml", "documentation/index.html", "documentation/licenses/license.txt"}
    assert set(held) == set(code) | own | page | {binary}
    listed = re.findall(rb'<File name="(.*?)"', held["modelDescription.xml"])
    assert [name.decode() for name in listed] == sorted(
        name.removeprefix("sources/") for name in held if name.endswith(".c")
    )
    with zipfile.ZipFile(io.BytesIO(made("lanes").content)) as archive:
        assert {entry.date_time for entry in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}
        assert archive.namelist() == sorted(archive.namelist())


def test_guid_follows_the_contents(monkeypatch: pytest.MonkeyPatch) -> None:
    units = [guid(made(case).content) for case in ("lanes", "float")]
    sources = made("lanes").sources
    changed = sources | {"stewart_robot.c": sources["stewart_robot.c"].replace("REAL(40.0)", "REAL(41.0)")}
    assert changed != sources
    monkeypatch.setattr(native, "find_compiler", lambda: None)
    units.append(guid(unit(made("lanes").robot, changed)))
    assert len(set(units)) == 3
    assert all(re.fullmatch(r"\{[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}\}", one) for one in units)
    assert guid(made("lanes").content).encode() in contents(made("lanes").content)["sources/stewart_unit.h"]


def test_without_a_compiler_the_unit_has_sources_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(native, "find_compiler", lambda: None)
    with few_vectors():
        bare = kit(made("lanes").robot, CASES["lanes"]).files[f"{made('lanes').symbol}.fmu"]
    full = contents(made("lanes").content)
    assert contents(bare) == {name: text for name, text in full.items() if not name.startswith("binaries/")}
    (tmp_path / "unit.fmu").write_bytes(bare)
    assert validate_fmu(str(tmp_path / "unit.fmu")) == []


# --- the C ------------------------------------------------------------------------------------


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("case", [case for case in EVERY if case.values[0] in ("lanes", "baked", "float")])
def test_unit_compiles_with_every_warning_an_error(case: str, compiler: str, tmp_path: Path) -> None:
    command = [*COMPILERS[compiler], *STRICT, "-O1", "-c", "stewart_fmi2.c", "-o", str(tmp_path / "unit.o")]
    silently(command, folder(case) / "sources")


def test_binary_shows_the_functions_of_co_simulation_and_nothing_else() -> None:
    binary = next((folder("lanes") / "binaries").rglob("*.so"))
    shown = {line.split()[-1] for line in run("nm", "-D", "--defined-only", binary).splitlines()}
    standard = (Path(fmpy.__file__).parent / "c-code" / "fmi2Functions.h").read_text(encoding="utf-8")
    stepping = re.split(r"\n(?:Functions for|.*Functions for FMI2 for)", standard)[-1]
    own = set(re.findall(r"FMI2_Export fmi2\w+TYPE\s+(\w+);", stepping))
    every = set(re.findall(r"FMI2_Export fmi2\w+TYPE\s+(\w+);", standard))
    assert own <= shown <= every
    assert not shown & {"fmi2SetTime", "fmi2GetDerivatives", "fmi2EnterEventMode", "fmi2NewDiscreteStates"}


@pytest.mark.slow
@pytest.mark.parametrize("case", ["lanes", "baked"] if FULL else ["lanes"])
def test_sanitizers_find_nothing_in_a_life_of_two_instances(case: str, tmp_path: Path) -> None:
    where, driver = folder(case) / "sources", Path(__file__).parents[1] / "support" / "c" / "fmi2_driver.c"
    program, values = tmp_path / "driver", references(case)
    flags = ["-std=c99", "-g", "-O0", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"]
    flags += [f'-DUNIT_GUID="{guid(made(case).content)}"', f"-DUNIT_REALS={values['status']}"]
    silently(
        ["clang", *flags, f"-I{where}", str(driver), *map(str, where.glob("*.c")), "-o", str(program), "-lm"],
        tmp_path,
    )
    silently([str(program)], tmp_path)


@pytest.mark.slow
def test_analyzers_find_nothing() -> None:
    where = folder("lanes") / "sources"
    checks = ["--enable=warning,style,performance,portability", "--std=c99", "--quiet", "--error-exitcode=3"]
    # The standard gives the signatures; declarations stand at the head of a function, as in all the C.
    hidden = [f"--suppress={name}" for name in ("missingIncludeSystem", "constParameter", "variableScope")]
    silently(["cppcheck", *checks, *hidden, "-D__GNUC__=12", "-USTEWART_REAL", "stewart_fmi2.c"], where)
    silently(["gcc", "-std=c99", "-O2", "-fanalyzer", "-S", "-o", os.devnull, "stewart_fmi2.c"], where)
