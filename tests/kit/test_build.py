"""Kits as members of builds: CMake, make, install, a client that regenerates its kit, and C++.

Each test runs the real tools out of tree, on a robot file of its own.
"""

import dataclasses
import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from sweeps import FULL

from stewart_sym.backend.kernel import c_sources
from stewart_sym.cli import main as cli
from stewart_sym.derive.kernel.interface import CALLS
from stewart_sym.derive.package import build as kit_build
from stewart_sym.derive.package import cpp as kit_cpp
from stewart_sym.derive.package.functions import MODEL, NOTHING, Function
from stewart_sym.derive.package.functions import ROBOT as OF_ROBOT
from stewart_sym.dynamics.equations import ForwardDynamics
from stewart_sym.generated.interface import HEADERS
from stewart_sym.kit import Choice, kit
from stewart_sym.motion.motion import Motion
from stewart_sym.motion.rotation import rotation_from_vector, vector_from_rotation
from stewart_sym.robot.robot import Robot
from stewart_sym.simulation import actuator_models, fixed_step

Array = NDArray[np.float64]

CLIENT = Path(__file__).parents[1] / "support" / "client"
README = Path(__file__).parents[2] / "README.md"
ROBOT = CLIENT / "hexapod.toml"
SYMBOL = "stewart_robot_client_hexapod"
GENERATORS = ["Ninja", *(["Unix Makefiles"] if FULL else [])]
QUICK = "-DCMAKE_BUILD_TYPE=Debug"
STRICT = ("-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror")


def run(*command: object, cwd: Path | None = None, code: int = 0) -> str:
    """What a command printed; it must end with the code."""
    done = subprocess.run(
        [str(word) for word in command], cwd=cwd, capture_output=True, text=True, check=False
    )
    assert done.returncode == code, done.stdout + done.stderr
    return done.stdout + done.stderr


def needed(*tools: str) -> None:
    for tool in tools:
        if shutil.which(tool) is None:
            pytest.skip(f"{tool} is missing: apt-get install cmake ninja-build make clang g++")


GENERATOR = """\
#!{python}
# A kit of the same robot and choice is made once: when it is asked for is what is tested here.
import hashlib, pathlib, pickle, sys
from stewart_sym.cli import main as cli
from stewart_sym.kit import write

made = write.kit

def kept(*arguments):
    path = pathlib.Path({folder!r}, hashlib.sha256(pickle.dumps(arguments)).hexdigest())
    if not path.exists():
        path.write_bytes(pickle.dumps(made(*arguments)))
    return pickle.loads(path.read_bytes())

write.kit = kept
sys.exit(cli.main())
"""


@pytest.fixture(scope="module")
def generator(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The generator as a program."""
    program = tmp_path_factory.mktemp("bin") / "stewart-sym"
    kept = str(tmp_path_factory.mktemp("kits"))
    program.write_text(GENERATOR.format(python=sys.executable, folder=kept))
    program.chmod(0o755)
    return program


@pytest.fixture(scope="module")
def files() -> dict[str, str]:
    """A kit of forces and motion, file name -> text."""
    return texts(Robot.from_toml(ROBOT), Choice(("forces", "motion")))


def texts(robot: Robot, choice: Choice) -> dict[str, str]:
    """A kit, file name -> text."""
    return {name: content.decode() for name, content in kit(robot, choice).files.items()}


def written(files: dict[str, str], folder: Path) -> Path:
    folder.mkdir(exist_ok=True)
    for name, text in files.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return folder


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


def project(folder: Path, generator: Path, tool: str, *options: str) -> Project:
    needed("cmake", "ninja" if tool == "Ninja" else "make")
    made = Project(folder / "source", folder / "build")
    shutil.copytree(CLIENT, made.source)
    package = Path(cli.__file__).parents[1] / "cmake"
    run(
        *("cmake", "-S", made.source, "-B", made.build, "-G", tool),
        *(f"-Dstewart-sym_DIR={package}", f"-DSTEWART_SYM_EXECUTABLE={generator}", *options),
    )
    return made


def test_client_runs_the_law_of_the_library_and_keeps_to_its_path(tmp_path: Path, generator: Path) -> None:
    """A hundred thousand cycles by themselves, and fifty beside the same law, path and machine in Python."""
    made = project(tmp_path, generator, "Ninja", "-DCMAKE_C_FLAGS_RELEASE=-O1")
    made.make()
    output = run(made.build / "loop")
    print(output)
    assert "cycles: 100000\n" in output
    told = made.loop(50)
    end = np.array([float(word) for word in told["at the end"].split()])
    state = python_loop(Robot.from_toml(ROBOT), 50)
    x, y, z, w = *end[4:7], end[3]
    np.testing.assert_allclose(end[:3], state.t, rtol=0, atol=1e-11)
    np.testing.assert_allclose(end[7:], np.r_[state.v, state.omega], rtol=0, atol=1e-10)
    half = np.linalg.norm([x, y, z])
    phi = 2.0 * np.arctan2(half, w) * np.array([x, y, z]) / half
    np.testing.assert_allclose(phi, vector_from_rotation(state.R), rtol=0, atol=1e-11)


def python_loop(robot: Robot, cycles: int) -> Motion:
    """What loop.c does: the state after so many cycles."""
    law = actuator_models.ComputedTorque(robot, wanted, 900.0, 60.0)
    plant = ForwardDynamics(robot)
    begin = wanted(0.0)
    off = np.full(3, 1e-4)
    state = Motion(rotation_from_vector(off) @ begin.R, begin.t + off, begin.omega, begin.v)
    for cycle in range(cycles):
        state, status = fixed_step.advance(plant, state, law(cycle * 1e-3, state), 1e-3, 2)
        assert int(status) == 0
    return state


def wanted(time: float) -> Motion:
    amplitude, rate = np.array([0.08, 0.05, 0.06, 0.2]), np.array([2.0, 3.1, 2.6, 2.3])
    axis = np.array([2.0, 3.0, 6.0]) / 7.0
    x = amplitude * np.sin(rate * time)
    x_dot, x_ddot = amplitude * rate * np.cos(rate * time), -(rate**2) * x
    t = np.array([0.0, 0.0, 0.7]) + x[:3]
    R = rotation_from_vector(axis * x[3])
    return Motion(R, t, axis * x_dot[3], x_dot[:3], axis * x_ddot[3], x_ddot[:3])


@pytest.mark.slow
@pytest.mark.parametrize("tool", GENERATORS)
def test_build_follows_its_robot_file_and_stops_with_the_words_of_the_generator(
    tmp_path: Path, generator: Path, tool: str
) -> None:
    made = project(tmp_path, generator, tool, QUICK)
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

    fails = 1 if tool == "Ninja" else 2
    edited = made.kit / "stewart_robot.c"
    text = edited.read_text(encoding="utf-8")
    edited.write_text(text + "/* mine */\n", encoding="utf-8")
    said = f"  stewart-sym: error: {edited}: exists with other content; use --force to overwrite\n"
    assert said in made.make(code=fails)
    assert edited.read_text(encoding="utf-8") == text + "/* mine */\n"
    edited.unlink()
    made.make()
    assert edited.read_text(encoding="utf-8") == text

    before = made.stamps()
    made.change("mass = 80.0", "mass = -80.0")
    said = f"  stewart-sym: error: {made.robot}: platform.mass: expected a number > 0, got -80\n"
    assert said in made.make(code=fails)
    assert made.stamps() == before


def readmes_command() -> str:
    """The custom command that the README shows, as a project."""
    (command,) = re.findall(r"```cmake\n(set\(kit .*?)```", README.read_text(encoding="utf-8"), re.DOTALL)
    return f"cmake_minimum_required(VERSION 3.15)\nproject(client LANGUAGES C)\n{command}"


@pytest.mark.slow
@pytest.mark.parametrize("tool", ["Unix Makefiles", *(["Ninja"] if FULL else [])])
def test_custom_command_of_ones_own_follows_the_robot_file(
    tmp_path: Path, generator: Path, monkeypatch: pytest.MonkeyPatch, tool: str
) -> None:
    needed("cmake", "ninja", "make")
    monkeypatch.setenv("PATH", str(generator.parent), prepend=os.pathsep)
    made = Project(tmp_path, tmp_path / "build")
    shutil.copy(ROBOT, made.robot)
    (tmp_path / "CMakeLists.txt").write_text(readmes_command())
    run("cmake", "-S", tmp_path, "-B", made.build, "-G", tool, QUICK)
    made.make()

    def stamps() -> list[int]:
        return [path.stat().st_mtime_ns for path in (made.library, made.build / "kit" / "stewart_robot.c")]

    before = stamps()
    made.make()
    assert stamps() == before
    made.robot.touch()
    made.make()
    assert stamps() > before
    before = stamps()
    made.make()
    assert stamps() == before
    made.change("mass = 40.0", "mass = -40.0")
    assert "stewart-sym: error: " in made.make(code=1 if tool == "Ninja" else 2)


@pytest.mark.slow
def test_other_options_and_another_generator_run_it_again(tmp_path: Path, generator: Path) -> None:
    made = project(tmp_path, generator, "Ninja", QUICK)
    again = shutil.copy(generator, tmp_path / "newer")
    lists = made.source / "CMakeLists.txt"
    for old, new in (
        ("forces motion)", "forces motion PRECISION float)"),
        ("ROBOT}", 'ROBOT}" EXECUTABLE "' + str(again)),
    ):
        assert "generating" not in run("cmake", made.build)
        text = lists.read_text(encoding="utf-8")
        assert old in text
        lists.write_text(text.replace(old, new), encoding="utf-8")
        assert "generating" in run("cmake", made.build)
    Path(again).touch()
    assert "generating" in run("ninja", "-C", made.build, "build.ninja")
    assert "define STEWART_FLOAT" in (made.kit / "stewart.h").read_text(encoding="utf-8")


def test_wrong_calls_are_told(tmp_path: Path, generator: Path) -> None:
    needed("cmake", "ninja")
    package = Path(cli.__file__).parents[1] / "cmake"
    for call, said in {
        "kit": "expected ROBOT <file>",
        "kit ROBOT x.toml COLOUR red": "not understood: COLOUR red;",
        "kit ROBOT x.toml FIDELITY": "without a value: FIDELITY",
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
    number = version("stewart-sym")
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


def test_cross_compiling_runs_nothing_and_builds_the_library_alone(
    tmp_path: Path, files: dict[str, str]
) -> None:
    needed("cmake", "ninja", "clang")
    kit, build = written(files, tmp_path / "kit"), tmp_path / "build"
    toolchain = tmp_path / "bare.cmake"
    toolchain.write_text(
        "set(CMAKE_SYSTEM_NAME Generic)\nset(CMAKE_SYSTEM_PROCESSOR arm)\nset(CMAKE_C_COMPILER clang)\n"
        "set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)\n"
    )
    run("cmake", "-S", kit, "-B", build, "-G", "Ninja", QUICK, f"-DCMAKE_TOOLCHAIN_FILE={toolchain}")
    output = run("cmake", "--build", build, "--verbose")
    assert (build / f"lib{SYMBOL}.a").exists()
    assert not (build / "selftest").exists()
    compiled = [line for line in output.splitlines() if " -c " in line]
    assert len(compiled) == 4
    assert all("-ffp-contract=off" in line and "-std=c99" in line for line in compiled)


def test_kit_is_built_proved_and_installed_by_plain_make(tmp_path: Path, files: dict[str, str]) -> None:
    needed("make")
    kit = written(files, tmp_path / "kit")
    before = contents(kit)
    assert "warning" not in run("make", "CFLAGS=-O0 -Wall -Wextra -Wconversion -Werror", cwd=kit)
    run(kit / "example" / "example")
    objects = {path.name: path.stat().st_mtime_ns for path in kit.glob("*.o")}
    run("make", cwd=kit)
    assert {path.name: path.stat().st_mtime_ns for path in kit.glob("*.o")} == objects
    run("make", "install", "PREFIX=/opt/kit", f"DESTDIR={tmp_path / 'staged'}", cwd=kit)
    staged = tmp_path / "staged" / "opt" / "kit"
    command = ("cc", "-I", staged / "include" / SYMBOL, tmp_path / "main.c", "-o", tmp_path / "user")
    (tmp_path / "main.c").write_text(USER_C)
    run(*command, "-L", staged / "lib", f"-l{SYMBOL}", "-lm")
    run(tmp_path / "user")
    run("make", "clean", cwd=kit)
    assert contents(kit) == before


@pytest.mark.parametrize("compiler", ["gcc", pytest.param("clang", marks=pytest.mark.slow)])
def test_make_tells_the_stack_of_every_function(tmp_path: Path, files: dict[str, str], compiler: str) -> None:
    needed("make", compiler)
    kit = written(files, tmp_path / "kit")
    before = contents(kit)
    output = run("make", "stack", f"CC={compiler}", "CFLAGS=-O0", cwd=kit)
    told = {line.split(": ")[1]: line.split(" bytes, ")[0] for line in output.splitlines() if "bytes" in line}
    assert int(told["stewart_exact_forces"]) > 0
    assert int(told["stewart_exact_forward_dynamics"]) > 0
    assert contents(kit) == before


def test_make_fails_where_the_self_test_does(tmp_path: Path, files: dict[str, str]) -> None:
    needed("make", "cmake", "ninja")
    wrong = files | {"stewart_robot.c": files["stewart_robot.c"].replace("REAL(40.0)", "REAL(40.5)")}
    kit = written(wrong, tmp_path / "kit")
    assert wrong != files
    run("make", "CFLAGS=-O0", cwd=kit, code=2)
    run("cmake", "-S", kit, "-B", tmp_path / "build", "-G", "Ninja", QUICK)
    run("cmake", "--build", tmp_path / "build")
    run("ctest", "--test-dir", tmp_path / "build", code=8)


def test_version_that_is_no_release_still_configures() -> None:
    package = kit_build.Package("x", "1.2.0.dev3+gabc", ("a.c",), ("a.h",))
    assert "project(x VERSION 1.2.0 LANGUAGES C)" in kit_build.cmake_lists(package)
    with pytest.raises(ValueError, match=r"^version: expected one that begins with a number, got 'new'$"):
        kit_build.cmake_lists(kit_build.Package("x", "new", ("a.c",), ("a.h",)))


# --- C++ ----------------------------------------------------------------------------------------


MOTION = ("equations", "bias", "forward_dynamics", "joint_inertia", "derivatives", "linearisation")
BAKED = f"{SYMBOL}_forces"


def of_model(stem: str, header: str, prefix: str = "stewart_exact") -> Function:
    return Function(stem, f"{prefix}_{stem}", header, MODEL, prefix)


FUNCTIONS = (
    of_model("forces", "stewart_exact_forces.h"),
    *(of_model(stem, "stewart_exact_motion.h") for stem in MOTION),
    *(
        Function(stem, f"stewart_exact_{stem}", "stewart_exact.h", OF_ROBOT, "")
        for stem in ("inverse_dynamics", "joint_reactions")
    ),
    Function("forces", BAKED, f"{BAKED}.h", NOTHING, ""),
)
KINEMATICS_H = """
#pragma once
#include "stewart.h"
extern "C" {
typedef struct { stewart_real R[9]; stewart_real t[3]; } stewart_pose;
int stewart_inverse_kinematics(
    const stewart_robot *robot, const stewart_motion *motion, stewart_real L[6], stewart_real L_dot[6]);
int stewart_forward_kinematics(const stewart_robot *robot, const stewart_real L[6], stewart_pose *pose);
int stewart_forward_velocity(
    const stewart_robot *robot, const stewart_pose *pose, const stewart_real L_dot[6], stewart_real v[3],
    stewart_real omega[3]);
}
"""
USER_CPP = f"""
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include "stewart_robot.h"
#include "stewart.hpp"

using stewart::status;
static_assert(std::is_same_v<stewart::forces_kernel, stewart::exact_kernel>);
static_assert(std::is_same_v<stewart::motion_kernel, stewart::exact_kernel>);
static_assert(std::is_nothrow_constructible_v<stewart::exact_kernel, const stewart_robot &>);
static_assert(!std::is_constructible_v<stewart::reactions_kernel, stewart_robot &&>);
static_assert(std::is_trivially_copyable_v<stewart::exact_kernel>);
static_assert(stewart::text(status::ok)[0] == 's');

// The number of the first thing that is not as it should be.
int main()
{{
    const stewart::forces_kernel kernel({SYMBOL});
    if (kernel.prepared() != status::ok) return 1;
    stewart_motion motion{{}};
    motion.R[0] = motion.R[4] = motion.R[8] = 1;
    motion.t[2] = static_cast<stewart::real>(0.7);
    motion.a[0] = 2;
    motion.omega[1] = 1;

    std::array<stewart::real, 6> F{{}}, acceleration{{}}, bias{{}};
    stewart::real plain[6];
    if (kernel(motion, F) != status::ok || kernel(motion, plain) != status::ok) return 2;
    stewart_exact_model model;
    stewart::real by_c[6];
    if (stewart_exact_prepare(&{SYMBOL}, &model) != STEWART_OK) return 3;
    if (stewart_exact_forces(&model, &motion, by_c) != STEWART_OK) return 4;
    for (std::size_t i = 0; i < 6; ++i) if (F[i] != by_c[i] || plain[i] != by_c[i]) return 5;

    const auto off = 100000 * std::numeric_limits<stewart::real>::epsilon();
    if (kernel.forward_dynamics(motion, F, acceleration) != status::ok) return 6;
    if (!(std::fabs(acceleration[0] - 2) < off) || !(std::fabs(acceleration[5]) < off)) return 7;
    stewart_equations equations;
    if (kernel.equations(motion, equations) != status::ok) return 8;
    if (kernel.bias(motion, bias) != status::ok) return 9;
    if (!(std::fabs(bias[2] - equations.bias[2]) <= off * std::fabs(bias[2]))) return 10;

    const stewart::reactions_kernel whole({SYMBOL});
    stewart_forces forces;
    stewart_reactions at_base, above;
    const std::array<stewart::real, 6> bearing{{1, 1, 1, 1, 1, 1}};
    if (whole.inverse_dynamics(motion, forces) != status::ok) return 11;
    if (whole.joint_reactions(motion, forces, at_base) != status::ok) return 12;
    if (whole.joint_reactions(motion, bearing, forces, above) != status::ok) return 13;
    if (!(std::fabs(forces.F[3] - F[3]) < 1000 * off) || at_base.M_p[0][1] == above.M_p[0][1]) return 14;

    const stewart::{SYMBOL.removeprefix("stewart_")}_kernel baked{{}};
    if (baked(motion, plain) != status::ok || !(std::fabs(plain[2] - F[2]) < 1000 * off)) return 15;

    stewart::real two[18], R[18]{{}}, zeros[6]{{}}, t[6]{{}};
    for (int i : {{0, 4, 8, 9, 13, 17}}) R[i] = 1;
    t[2] = t[5] = motion.t[2];
    const stewart_motions poses{{R, t, zeros, zeros, zeros, zeros, nullptr, nullptr}};
    int each[3] = {{-1, -1, -1}};
    if (kernel.batch(2, poses, two, each) != status::ok || each[1] != 0 || two[0] != two[6]) return 16;
#if __cplusplus >= 202002L
    if (kernel.batch(poses, std::span(two).first(12), std::span(each).first(2)) != status::ok) return 17;
    if (kernel.batch(poses, two, std::span(each).first(2)) != status::bad_argument) return 18;
    if (kernel(motion, std::span(two).first<6>()) != status::ok || two[0] != F[0]) return 19;
#endif

    F.fill(-1);
    motion.t[0] = std::numeric_limits<stewart::real>::quiet_NaN();
    if (kernel(motion, F) != status::not_finite || F[0] != -1) return 20;
    const stewart::motion_kernel empty;
    if (empty.prepared() != status::bad_argument || empty.bias(motion, F) != status::bad_argument) return 21;
    stewart_robot broken = {SYMBOL};
    broken.M = motion.t[0];
    if (stewart::forces_kernel(broken)(motion, F) != status::not_finite || F[0] != -1) return 22;
    return 0;
}}
"""
CPP = ("-fno-exceptions", "-fno-rtti", *STRICT)


@pytest.fixture(scope="module", params=["double", pytest.param("float", marks=pytest.mark.slow)])
def wrapped(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder of a kit with everything that C++ wraps, and its library."""
    needed("make")
    robot = Robot.from_toml(ROBOT)
    files = texts(robot, Choice(("forces", "reactions", "motion", "derivatives"), precision=request.param))
    baked = texts(robot, Choice(bake=True, precision=request.param))
    more = {name: text for name, text in baked.items() if name.startswith(BAKED)}
    sources = [name for name in (files | more) if name.endswith(".c") and "/" not in name]
    package = kit_build.Package("all", "0", tuple(sources), ("stewart.h",), has_cpp=True)
    more |= {"Makefile": kit_build.makefile(package), "stewart.hpp": kit_cpp.wrapper(FUNCTIONS, "0")}
    folder = written(files | more, tmp_path_factory.mktemp("wrapped"))
    (folder / "user.cpp").write_text(USER_CPP)
    run("make", "liball.a", "CFLAGS=-O0", cwd=folder)
    return folder


@pytest.mark.parametrize("standard", ["c++17", "c++20"])
@pytest.mark.parametrize("compiler", ["g++", "clang++"])
def test_functions_are_called_from_cpp(wrapped: Path, compiler: str, standard: str) -> None:
    needed(compiler)
    program = f"{compiler}-{standard}"
    flags = (f"-std={standard}", "-O0", *CPP)
    assert run(compiler, *flags, "user.cpp", "liball.a", "-o", program, cwd=wrapped) == ""
    run(wrapped / program)


@pytest.mark.parametrize("compiler", ["g++", "clang++"])
def test_every_function_can_be_wrapped_and_no_status_ignored(tmp_path: Path, compiler: str) -> None:
    needed(compiler)
    stems = ("inverse_kinematics", "forward_kinematics", "forward_velocity")
    functions = [Function(s, f"stewart_{s}", "stewart_kinematics.h", OF_ROBOT, "") for s in stems]
    turned = {"motion_from_rpy", "motion_from_quaternion"}  # of a kit of the forces, made elsewhere
    assert {function.stem for function in (*FUNCTIONS, *functions)} | turned == set(CALLS)
    (tmp_path / "stewart_kinematics.h").write_text(KINEMATICS_H)
    (tmp_path / "stewart.h").write_text(c_sources("exact")["stewart.h"])
    (tmp_path / "stewart.hpp").write_text(kit_cpp.wrapper(functions, "0"))
    use = (
        '#include "stewart.hpp"\n'
        "status call(const stewart_robot &robot, stewart_pose &pose);\n"
        "status call(const stewart_robot &robot, stewart_pose &pose)\n{\n"
        "    const std::array<stewart::real, 6> L{};\n"
        "    KEEP stewart::kinematics_kernel(robot).forward_kinematics(L, pose);\n}\n"
    ).replace("status call", "stewart::status call")
    command = (compiler, "-std=c++17", "-fsyntax-only", *CPP, "user.cpp")
    (tmp_path / "user.cpp").write_text(use.replace("KEEP", "return"))
    run(*command, cwd=tmp_path)
    (tmp_path / "user.cpp").write_text(use.replace("KEEP", "").replace("\n}\n", "\n    return {};\n}\n"))
    assert "nodiscard" in run(*command, cwd=tmp_path, code=1)


def test_kernels_of_one_pose_have_no_batch_and_unknown_functions_are_told() -> None:
    pose = of_model("forces", "stewart_exact_pose.h", "stewart_exact_pose")
    pose = dataclasses.replace(pose, one_pose=True)
    text = kit_cpp.wrapper([pose], "0")
    assert "class exact_pose_kernel" in text
    assert "batch" not in text
    with pytest.raises(ValueError, match=r"^functions: expected some of forces, .*, got 'torque'$"):
        kit_cpp.wrapper([dataclasses.replace(pose, stem="torque")], "0")


def contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}
