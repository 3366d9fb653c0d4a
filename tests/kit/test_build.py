"""Kits as members of builds: CMake, make, install, a client that regenerates its kit, and C++.

Each test runs the real tools out of tree, on a robot file of its own.
"""

import dataclasses
import os
import shutil
import sys
import traceback
from collections.abc import Iterator
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from importlib.metadata import version
from io import StringIO
from multiprocessing.connection import Listener
from pathlib import Path
from threading import Thread

import pytest
from builds import CLIENT, QUICK, ROBOT, SYMBOL, needed, run, texts, written
from kits import contents, few_vectors
from sweeps import FULL

from stewart_sym.cli import main as cli
from stewart_sym.generated.interface import HEADERS
from stewart_sym.kit import Choice
from stewart_sym.robot.robot import Robot

GENERATOR = """\
#!{python} -IS
# Asks the process of the tests, which has the library loaded and derives a kernel once.
import os, sys
from multiprocessing.connection import Client

with Client({address!r}) as tests:
    tests.send((os.getcwd(), sys.argv[1:]))
    code, said, error = tests.recv()
sys.stdout.write(said)
sys.stderr.write(error)
sys.exit(code)
"""


@pytest.fixture(scope="module")
def generator(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """The generator as a program, whose kits test themselves little: when it is asked for is tested here."""
    program = tmp_path_factory.mktemp("bin") / "stewart-sym"
    with few_vectors(), Listener() as listener:
        Thread(target=answer, args=(listener,), daemon=True).start()
        program.write_text(GENERATOR.format(python=sys.executable, address=listener.address))
        program.chmod(0o755)
        yield program


def answer(listener: Listener) -> None:
    """Run commands until the listener is closed."""
    while True:
        try:
            asked = listener.accept()
        except OSError:
            return
        before, code = os.getcwd(), 70
        with asked, redirect_stdout(StringIO()) as said, redirect_stderr(StringIO()) as error:
            folder, words = asked.recv()
            os.chdir(folder)
            try:
                code = cli.main(words)
            except BaseException:
                # Told by the program, which would wait for an answer.
                traceback.print_exc()
            os.chdir(before)
            asked.send((code, said.getvalue(), error.getvalue()))


@pytest.fixture(scope="module")
def files() -> dict[str, str]:
    """A kit of forces, file name -> text."""
    with few_vectors():
        return texts(Robot.from_toml(ROBOT), Choice())


# --- a project that generates its kit -----------------------------------------------------------


@dataclass(frozen=True)
class Project:
    """A copy of the client with its own robot file and its build folder."""

    source: Path
    build: Path

    @property
    def robot(self) -> Path:
        return self.source / "hexapod.toml"

    @property
    def kit(self) -> Path:
        return self.build / "hexapod_kit"

    @property
    def library(self) -> Path:
        return self.build / "libhexapod.a"

    def make(self, code: int = 0) -> str:
        return run("cmake", "--build", self.build, code=code)

    def loop(self, cycles: int) -> dict[str, str]:
        lines = run(self.build / "loop", "--cycles", cycles).splitlines()
        return dict(line.split(": ", 1) for line in lines)

    def change(self, old: str, new: str) -> None:
        text = self.robot.read_text(encoding="utf-8")
        assert old in text
        self.robot.write_text(text.replace(old, new), encoding="utf-8")

    def stamps(self) -> dict[str, int]:
        """When each file that a build writes was written."""
        paths = [*self.kit.iterdir(), *self.build.rglob("*.o"), self.library, self.build / "loop"]
        return {path.name: path.stat().st_mtime_ns for path in paths}


def project(folder: Path, generator: Path, *options: str) -> Project:
    needed("cmake", "ninja")
    made = Project(folder / "source", folder / "build")
    shutil.copytree(CLIENT, made.source)
    package = Path(cli.__file__).parents[1] / "cmake"
    run(
        *("cmake", "-S", made.source, "-B", made.build, "-G", "Ninja"),
        *(f"-Dstewart-sym_DIR={package}", f"-DSTEWART_SYM_EXECUTABLE={generator}", *options),
    )
    return made


@pytest.mark.slow
def test_client_keeps_to_its_path(tmp_path: Path, generator: Path) -> None:
    """Four seconds, a hundred with STEWART_FULL=1; a loop that leaves its path ends with an error."""
    made = project(tmp_path, generator, "-DCMAKE_C_FLAGS_RELEASE=-O1")
    made.make()
    cycles = 100_000 if FULL else 4_000
    output = run(made.build / "loop", "--cycles", cycles)
    print(output)
    assert f"cycles: {cycles}\n" in output


@pytest.mark.full
@pytest.mark.slow
def test_build_follows_its_robot_file_and_stops_with_the_words_of_the_generator(
    tmp_path: Path, generator: Path
) -> None:
    made = project(tmp_path, generator, QUICK)
    made.make()
    before, force = made.stamps(), float(made.loop(20)["largest force"].split()[0])

    made.make()
    assert made.stamps() == before, "nothing changed, something was built"

    made.robot.touch()
    assert "generating" in made.make()
    assert made.stamps() == before, "the same robot came out, something was compiled"

    made.change("mass = 40.0", "mass = 80.0")
    assert "generating" in made.make()
    after = made.stamps()
    changed = {name for name, stamp in after.items() if stamp != before[name]}
    assert {"stewart_robot.c", "stewart_robot.c.o", "libhexapod.a", "loop"} <= changed
    assert "loop.c.o" not in changed
    assert float(made.loop(20)["largest force"].split()[0]) > 1.3 * force

    edited = made.kit / "stewart_robot.c"
    text = edited.read_text(encoding="utf-8")
    edited.write_text(text + "/* mine */\n", encoding="utf-8")
    said = f"  stewart-sym: error: {edited}: exists with other content; use --force to overwrite\n"
    assert said in made.make(code=1)
    assert edited.read_text(encoding="utf-8") == text + "/* mine */\n"
    edited.unlink()
    made.make()
    assert edited.read_text(encoding="utf-8") == text

    before = made.stamps()
    made.change("mass = 80.0", "mass = -80.0")
    said = f"  stewart-sym: error: {made.robot}: platform.body.mass: expected a number > 0, got -80 (at line "
    assert said in made.make(code=1)
    assert made.stamps() == before


def test_wrong_calls_are_told(tmp_path: Path, generator: Path) -> None:
    needed("cmake", "ninja")
    package = Path(cli.__file__).parents[1] / "cmake"
    for call, said in {
        "kit": "expected ROBOT <file>",
        "kit ROBOT x.toml COLOR red": "not understood: COLOR red;",
        "kit ROBOT missing.toml": "missing.toml: cannot read the robot file: No such file",
        f"kit ROBOT x.toml EXECUTABLE {tmp_path}/nowhere": "nowhere",
    }.items():
        (tmp_path / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.15)\nproject(wrong LANGUAGES NONE)\n"
            f'include("{package}/StewartSym.cmake")\nstewart_generate({call})\n'
        )
        output = run(
            *("cmake", "-S", tmp_path, "-B", tmp_path / "build", "-G", "Ninja"),
            f"-DSTEWART_SYM_EXECUTABLE={generator}",
            code=1,
        )
        assert said in " ".join(output.split()), output


def test_subcommand_prints_the_folder_of_the_package(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["cmake-dir"]) == 0
    folder = Path(capsys.readouterr().out.strip())
    assert {path.name for path in folder.iterdir()} >= {"stewart-symConfig.cmake", "StewartSym.cmake"}


# --- the kit's own build files ------------------------------------------------------------------

USER_C = f"""
#include <stdio.h>
#include "stewart_robot.h"
#include "stewart_exact_forces.h"
int main(void)
{{
    static stewart_exact_model model;
    return stewart_exact_prepare(&{SYMBOL}, &model);
}}
"""


@pytest.mark.slow
def test_kit_is_built_proved_installed_and_found_by_cmake(tmp_path: Path, files: dict[str, str]) -> None:
    needed("cmake", "ninja")
    kit, build, prefix = written(files, tmp_path / "kit"), tmp_path / "build", tmp_path / "prefix"
    before = contents(kit)
    run("cmake", "-S", kit, "-B", build, "-G", "Ninja", QUICK, f"-DCMAKE_INSTALL_PREFIX={prefix}")
    run("cmake", "--build", build)
    assert "100% tests passed" in run("ctest", "--test-dir", build)
    run(build / "example")
    run("cmake", "--install", build)
    assert contents(kit) == before, "the build wrote into the source folder"
    headers = {path.name for path in (prefix / "include" / SYMBOL).iterdir()}
    own = set(HEADERS) - {"stewart.h"}  # of the kit's sources alone
    assert headers == {name for name in files if name.endswith((".h", ".hpp"))} - own
    shutil.rmtree(kit)
    shutil.rmtree(build)
    number = version("stewart-sym").partition(".dev")[0]
    (tmp_path / "user").mkdir()
    (tmp_path / "user" / "main.c").write_text(USER_C)
    (tmp_path / "user" / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.15)\nproject(user LANGUAGES C)\n"
        f"find_package({SYMBOL} {number} CONFIG REQUIRED)\n"
        f"add_executable(user main.c)\ntarget_link_libraries(user PRIVATE {SYMBOL}::{SYMBOL})\n"
    )
    found = f"-DCMAKE_PREFIX_PATH={prefix}"
    run("cmake", "-S", tmp_path / "user", "-B", build, "-G", "Ninja", QUICK, found)
    run("cmake", "--build", build)
    run(build / "user")


@pytest.mark.slow
def test_two_kits_are_parts_of_one_project(tmp_path: Path, files: dict[str, str]) -> None:
    """As subfolders, which is what FetchContent makes of them; neither tests nor installs by itself."""
    needed("cmake", "ninja")
    robot = Robot.from_toml(ROBOT)
    other = texts(dataclasses.replace(robot, name="Other"), Choice())
    written(files, tmp_path / "first")
    written(other, tmp_path / "second")
    (tmp_path / "main.c").write_text(USER_C)
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.15)\nproject(user LANGUAGES C)\n"
        "add_subdirectory(first)\nadd_subdirectory(second)\nadd_executable(user main.c)\n"
        f"target_link_libraries(user PRIVATE {SYMBOL}::{SYMBOL})\n"
    )
    build = tmp_path / "build"
    run("cmake", "-S", tmp_path, "-B", build, "-G", "Ninja", QUICK)
    run("cmake", "--build", build)
    run(build / "user")
    assert not list(build.rglob("selftest*"))
    run("cmake", build, "-DSTEWART_KIT_TESTS=ON", "-DSTEWART_KIT_INSTALL=ON")
    run("cmake", "--build", build)
    for folder in ("first", "second"):
        run(build / folder / "selftest")


@pytest.mark.slow
def test_kit_is_built_proved_and_installed_by_plain_make(tmp_path: Path, files: dict[str, str]) -> None:
    needed("make")
    kit = written(files, tmp_path / "kit")
    before = contents(kit)
    assert "warning" not in run("make", "CFLAGS=-O0 -Wall -Wextra -Wconversion -Werror", cwd=kit)
    run(kit / "example" / "example")
    objects = {path.name: path.stat().st_mtime_ns for path in kit.glob("*.o")}
    run("make", cwd=kit)
    assert {path.name: path.stat().st_mtime_ns for path in kit.glob("*.o")} == objects
    for target in ("check", "test"):  # beside a folder that is called test
        assert "selftest" in run("make", "-s", target, cwd=kit)
    run("make", "install", "PREFIX=/opt/kit", f"DESTDIR={tmp_path / 'staged here'}", cwd=kit)
    staged = tmp_path / "staged here" / "opt" / "kit"
    command = ("cc", "-I", staged / "include" / SYMBOL, tmp_path / "main.c", "-o", tmp_path / "user")
    (tmp_path / "main.c").write_text(USER_C)
    run(*command, "-L", staged / "lib", f"-l{SYMBOL}", "-lm")
    run(tmp_path / "user")
    run("make", "clean", cwd=kit)
    assert contents(kit) == before


def test_make_tells_the_stack_of_every_function(tmp_path: Path, files: dict[str, str]) -> None:
    needed("make", "gcc")
    kit = written(files, tmp_path / "kit")
    before = contents(kit)
    output = run("make", "stack", "CC=gcc", "CFLAGS=-O0", cwd=kit)
    told = {line.split(": ")[1]: line.split(" bytes, ")[0] for line in output.splitlines() if "bytes" in line}
    assert int(told["stewart_exact_forces"]) > 0
    assert contents(kit) == before


@pytest.mark.slow
def test_make_fails_where_the_self_test_does(tmp_path: Path, files: dict[str, str]) -> None:
    needed("make", "cmake", "ninja")
    wrong = files | {"stewart_robot.c": files["stewart_robot.c"].replace("REAL(40.0)", "REAL(40.5)")}
    kit = written(wrong, tmp_path / "kit")
    assert wrong != files
    run("make", "CFLAGS=-O0", cwd=kit, code=2)
    run("cmake", "-S", kit, "-B", tmp_path / "build", "-G", "Ninja", QUICK)
    run("cmake", "--build", tmp_path / "build")
    run("ctest", "--test-dir", tmp_path / "build", code=8)
