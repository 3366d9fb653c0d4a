"""C++ that wraps a kit's functions: called from C++17 and C++20, no status ignored."""

import dataclasses
from functools import cache
from pathlib import Path

import pytest
from builds import ROBOT, SYMBOL, needed, run, texts, written
from kits import STRICT, few_vectors

from stewart_sym.derive.kernel.interface import CALLS
from stewart_sym.derive.package import cpp as kit_cpp
from stewart_sym.derive.package.build import build_files
from stewart_sym.derive.package.functions import Function
from stewart_sym.kit import Choice
from stewart_sym.kit.required_kernels import parts
from stewart_sym.robot.robot import Robot

GROUPS = ("forces", "reactions", "motion", "derivatives", "kinematics")


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
    if (kernel.bias_and_friction(motion, bias) != status::ok) return 9;
    if (!(std::fabs(bias[2] - equations.bias_and_friction[2]) <= off * std::fabs(bias[2]))) return 10;

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
    stewart::real apart[12], beside[18]{{}}, height[6]{{}};
    for (int i : {{0, 1, 8, 9, 16, 17}}) beside[i] = 1;
    height[4] = height[5] = motion.t[2];
    const stewart_motions columns{{beside, height, zeros, zeros, zeros, zeros, nullptr, nullptr}};
    if (kernel.columns(2, 2, columns, apart, each) != status::ok) return 20;
    for (int i = 0; i < 6; ++i) if (apart[2 * i] != two[i] || apart[2 * i + 1] != two[i]) return 21;
#if __cplusplus >= 202002L
    if (kernel.batch(poses, std::span(two).first(12), std::span(each).first(2)) != status::ok) return 17;
    if (kernel.batch(poses, two, std::span(each).first(2)) != status::bad_argument) return 18;
    if (kernel(motion, std::span(two).first<6>()) != status::ok || two[0] != F[0]) return 19;
#endif

    F.fill(-1);
    motion.t[0] = std::numeric_limits<stewart::real>::quiet_NaN();
    if (kernel(motion, F) != status::not_finite || F[0] != -1) return 20;
    const stewart::motion_kernel empty;
    if (empty.prepared() != status::bad_argument) return 21;
    if (empty.bias_and_friction(motion, F) != status::bad_argument) return 21;
    stewart_robot broken = {SYMBOL};
    broken.M = motion.t[0];
    if (stewart::forces_kernel(broken)(motion, F) != status::not_finite || F[0] != -1) return 22;
    return 0;
}}
"""
CPP = ("-fno-exceptions", "-fno-rtti", *STRICT)


@cache
def wrapped_functions() -> list[Function]:
    """Those of a kit with everything but torques, and forces with the robot's numbers folded in."""
    robot = Robot.from_toml(ROBOT)
    whole, baked = parts(robot, Choice(GROUPS)), parts(robot, Choice(bake=True))
    return [*whole.functions, *baked.parts[0].functions]


@pytest.fixture(
    scope="module", params=["double", pytest.param("float", marks=[pytest.mark.slow, pytest.mark.full])]
)
def wrapped(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder of a kit with everything that C++ wraps."""
    needed("make")
    robot = Robot.from_toml(ROBOT)
    with few_vectors():
        files = texts(robot, Choice(("kinematics",), precision=request.param))
    for choice in (Choice(GROUPS), Choice(bake=True)):
        files |= parts(robot, dataclasses.replace(choice, precision=request.param)).files
    sources = [name for name in files if name.endswith(".c") and "/" not in name]
    files |= build_files("all", "0", sources, ("stewart.h",))
    files |= {"stewart.hpp": kit_cpp.wrapper(wrapped_functions(), "0"), "user.cpp": USER_CPP}
    return written(files, tmp_path_factory.mktemp("wrapped"))


@pytest.mark.slow
@pytest.mark.parametrize(("compiler", "standard"), [("g++", "c++17"), ("clang++", "c++20")])
def test_functions_are_called_from_cpp(wrapped: Path, compiler: str, standard: str) -> None:
    needed(compiler)
    run("make", "liball.a", "CFLAGS=-O0", cwd=wrapped)
    program = f"{compiler}-{standard}"
    flags = (f"-std={standard}", "-O0", *CPP)
    assert run(compiler, *flags, "user.cpp", "liball.a", "-o", program, cwd=wrapped) == ""
    run(wrapped / program)


def test_every_function_is_wrapped() -> None:
    torques = {"axial_forces", "motor_torques"}  # ``test_torque_kits``
    assert {function.stem for function in wrapped_functions()} | torques == set(CALLS)


@pytest.mark.slow
@pytest.mark.parametrize("compiler", ["g++", "clang++"])
def test_no_status_is_ignored(wrapped: Path, compiler: str) -> None:
    needed(compiler)
    use = (
        '#include "stewart.hpp"\n'
        "stewart::status call(const stewart_robot &robot, stewart_pose &pose);\n"
        "stewart::status call(const stewart_robot &robot, stewart_pose &pose)\n{\n"
        "    const std::array<stewart::real, 6> L{};\n"
        "    KEEP stewart::kinematics_kernel(robot).forward_kinematics(L, pose);\n}\n"
    )
    command = (compiler, "-std=c++17", "-fsyntax-only", *CPP, "call.cpp")
    (wrapped / "call.cpp").write_text(use.replace("KEEP", "return"))
    run(*command, cwd=wrapped)
    (wrapped / "call.cpp").write_text(use.replace("KEEP", "").replace("\n}\n", "\n    return {};\n}\n"))
    assert "nodiscard" in run(*command, cwd=wrapped, code=1)
