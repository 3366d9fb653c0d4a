"""What a user does with a kit beside building it: other flags, folders, overlapping arguments, terms."""

import contextlib
import ctypes
import os
import platform
import re
import shlex
import subprocess
from pathlib import Path

import machines
import numpy as np
import pytest
from kits import c_of, few_vectors, kit_of

import stewart_sym as ss
from stewart_sym.backend import kernel, native
from stewart_sym.calls import c_kernel
from stewart_sym.cli.main import main
from stewart_sym.derive.package.text_format import robot_symbol
from stewart_sym.dynamics.home_pose import home_pose
from stewart_sym.dynamics.sample_poses import poses, sample
from stewart_sym.kit import Choice, put, write_kit
from stewart_sym.motion.motion import Motion, at_rest


def compiled(folder: Path, *flags: str, source: str = "stewart_robot.c") -> str:
    """What the compiler says of a source of the kit."""
    command = ["gcc", "-std=c99", *flags, f"-I{folder}", "-c", source, "-o", os.devnull]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False).stderr


# ---------------------------------------------------------------- flags


@pytest.mark.parametrize("flag", ["-ffast-math", "-Ofast"])
def test_a_compiler_told_that_all_is_finite_stops_unless_allowed(tmp_path: Path, flag: str) -> None:
    put(kit_of(), tmp_path)
    assert "#error" in compiled(tmp_path, flag)
    assert compiled(tmp_path, flag, "-DSTEWART_ALLOW_FAST_MATH") == ""
    assert compiled(tmp_path, "-O2", "-fno-math-errno") == ""


def test_a_status_that_is_ignored_is_warned_of(tmp_path: Path) -> None:
    put(kit_of(choice=Choice(("reactions",))), tmp_path)
    (tmp_path / "user.c").write_text(
        '#include "stewart_exact.h"\n'
        "void f(const stewart_robot *r, const stewart_motion *m, stewart_forces *f);\n"
        "void f(const stewart_robot *r, const stewart_motion *m, stewart_forces *f)\n"
        "{\n    stewart_exact_inverse_dynamics(r, m, f);\n}\n"
    )
    assert "warn_unused_result" in compiled(tmp_path, source="user.c")
    assert "ignoring return value" in compiled(tmp_path, "-x", "c++", "-std=c++17", source="user.c")


# ---------------------------------------------------------------- files


@pytest.mark.slow
@few_vectors()
def test_the_command_of_a_readme_run_in_its_folder_changes_nothing(tmp_path: Path) -> None:
    write_kit(machines.dasgupta(), tmp_path, Choice(("forces", "kinematics")))
    before = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
    (line,) = re.findall(r"^    stewart-sym (generate .*)$", (tmp_path / "README.md").read_text(), re.M)
    with contextlib.chdir(tmp_path):
        assert main(shlex.split(line)) == 0
    assert {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()} == before


@pytest.mark.slow
def test_every_function_in_the_headers_of_a_kit_is_exercised_by_its_self_test() -> None:
    for choice in (Choice(("forces", "reactions", "motion", "derivatives", "kinematics")), Choice(bake=True)):
        files = c_of(kit_of(choice=choice))
        declared = {
            function
            for name, text in files.items()
            if name.endswith(".h")
            for function in re.findall(r"\bint (stewart_\w+)\(", text)
        }
        assert {"stewart_motion_from_rpy", "stewart_motion_from_quaternion"} <= declared
        assert all(f"{function}(" in files["test/selftest.c"] for function in declared)


def test_version_and_limits_are_in_the_headers() -> None:
    robot = machines.dasgupta()
    files = c_of(kit_of(), r"stewart\.h|stewart_robot\.[ch]")
    assert re.search(r'^#define STEWART_SYM_VERSION "\d+\.\d+', files["stewart.h"], re.M)
    library = native.load("kit_robot", files, ("-O0",))
    found = np.array((ctypes.c_double * 24).in_dll(library, f"{robot_symbol(robot.name)}_limits"))
    stated = np.concatenate([*robot.length_limits.T, robot.force_limit, robot.speed_limit])
    np.testing.assert_array_equal(found, np.where(np.isinf(stated), np.finfo(np.float64).max, stated))


# ---------------------------------------------------------------- overlap


def test_outputs_of_one_pose_may_overlap_the_motion(tmp_path: Path) -> None:
    robot = machines.dasgupta()
    at = sample(robot, "exact")
    motion = np.concatenate([np.ravel(getattr(at, name)) for name in kernel.MOTION])
    compiled, whole = c_kernel.library("exact_motion"), c_kernel.library("exact")
    constants = kernel.robot_numbers(robot)
    model = np.zeros(4096)
    assert compiled.stewart_exact_prepare(c_kernel.address(constants), c_kernel.address(model)) == 0
    functions = {
        "stewart_exact_forces": (model, 6),
        "stewart_exact_bias_and_friction": (model, 6),
        "stewart_exact_joint_inertia": (model, 36),
        "stewart_exact_equations": (model, 168),
        "stewart_exact_inverse_dynamics": (constants, 78),
    }
    for name, (first, count) in functions.items():
        call = getattr(whole if first is constants else compiled, name)
        apart = np.zeros(count)
        assert call(c_kernel.address(first), c_kernel.address(motion), c_kernel.address(apart)) == 0
        for offset in (0, 5, 9, 24):
            both = np.concatenate([motion, np.zeros(count)])
            out = both[offset : offset + count]
            assert call(c_kernel.address(first), c_kernel.address(both), c_kernel.address(out)) == 0
            np.testing.assert_array_equal(out, apart, err_msg=f"{name} at {offset}")
    force = apart[:6].copy()
    assert compiled.stewart_exact_forward_dynamics(*map(c_kernel.address, (model, motion, force, apart))) == 0
    assert compiled.stewart_exact_forward_dynamics(*map(c_kernel.address, (model, motion, force, force))) == 0
    np.testing.assert_array_equal(force, apart[:6])


# ---------------------------------------------------------------- orientation


def oriented(function: str, *given: np.ndarray, precision: type = np.float64) -> tuple[int, np.ndarray]:
    """Status, and a motion that was all ones before."""
    flags = ["-DSTEWART_FLOAT"] if precision is np.float32 else []
    library = native.load("stewart_rotation", c_kernel.c_sources("rotation"), flags)
    motion = np.ones(30, dtype=precision)
    arrays = [np.ascontiguousarray(each, dtype=precision) for each in given]
    return getattr(library, function)(*map(c_kernel.address, (*arrays, motion))), motion


def expected(motion: Motion) -> np.ndarray:
    ones = {name: np.ones(3) for name in ("t", "v", "a", "F_ext", "M_ext")}
    fields = {**ones, "R": motion.R.ravel(), "omega": motion.omega, "alpha": motion.alpha}
    return np.concatenate([fields[name] for name in kernel.MOTION])


@pytest.mark.parametrize("precision", [np.float64, np.float32])
def test_orientation_and_rates_in_c_are_those_of_motion(precision: type) -> None:
    rng = np.random.default_rng(4)
    still = np.zeros(3)
    for _ in range(20):
        given = rng.uniform(-3, 3, (3, 3)).astype(precision).astype(np.float64)
        sine, cosine = np.sin(given[0]), np.cos(given[0])
        status, found = oriented("stewart_motion_from_rpy", sine, cosine, *given[1:], precision=precision)
        right = expected(Motion.from_rpy(still, given[0], still, given[1], still, given[2]))
        assert status == 0
        np.testing.assert_allclose(found, right, rtol=0, atol=400 * np.finfo(precision).eps)
        e = rng.standard_normal((3, 4)).astype(precision).astype(np.float64)
        e[0] *= 3.0 / np.linalg.norm(e[0])
        e = e.astype(precision).astype(np.float64)
        status, found = oriented("stewart_motion_from_quaternion", *e, precision=precision)
        right = expected(Motion.from_quaternion(still, e[0], still, e[1], still, e[2]))
        assert status == 0
        np.testing.assert_allclose(found, right, rtol=0, atol=400 * np.finfo(precision).eps)


def test_no_orientation_comes_of_what_is_not_finite_or_zero() -> None:
    rates = np.array([0.1, -0.2, 0.3])
    cases = {
        "stewart_motion_from_rpy": [np.sin(rates), np.cos(rates), rates, rates],
        "stewart_motion_from_quaternion": [np.array([0.9, 0.1, -0.2, 0.3])] * 3,
    }
    for function, given in cases.items():
        assert oriented(function, *given)[0] == 0
        for number in (np.nan, np.inf, -np.inf):
            for i, j in np.ndindex(len(given), given[0].size):
                spoilt = [each.copy() for each in given]
                spoilt[i][j] = number
                status, motion = oriented(function, *spoilt)
                assert (status, set(motion)) == (1, {1.0}), (function, i, j)
    for size in (0.0, 1e-170, 1e200):
        status, motion = oriented("stewart_motion_from_quaternion", *(size * cases[function][0],) * 3)
        assert (status, set(motion)) == (1, {1.0})


USER = """#include <stdio.h>
#include "stewart_kit.h"
int main(void) {
    static stewart_kit_model model;
    static const stewart_motion motion = {
        {1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, STEWART_T}, {0}, {0}, {0}, {0}, {0}, {0}};
    stewart_real F[6];
    int i, status = stewart_kit_prepare(&model);
    if (status == STEWART_OK) { status = stewart_kit_forces(&model, &motion, F); }
    for (i = 0; i < 6 && status == STEWART_OK; ++i) { printf("%.12g ", (double)F[i]); }
    return status;
}
"""


@pytest.mark.slow
@pytest.mark.parametrize("scalar", [False, True])
def test_one_program_runs_with_baked_and_other_kits(scalar: bool, tmp_path: Path) -> None:
    robot, printed = machines.dasgupta(), []
    height = float(home_pose(robot).t[2])
    for bake in (False, True):
        folder = tmp_path / str(bake)
        put(kit_of(robot.name, Choice(bake=bake, scalar=scalar)), folder)
        (tmp_path / "user.c").write_text(USER.replace("STEWART_T", repr(height)))
        sources = [*map(str, folder.glob("*.c")), str(tmp_path / "user.c")]
        flags = ["-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror", f"-I{folder}"]
        program = str(tmp_path / f"user{bake}")
        subprocess.run(["cc", *flags, *sources, "-lm", "-o", program], check=True)
        out = subprocess.run([program], check=True, capture_output=True, text=True).stdout
        printed.append([float(each) for each in out.split()])
    np.testing.assert_allclose(printed[1], printed[0], rtol=1e-9)
    F = ss.inverse_dynamics(robot, at_rest(np.eye(3), np.array([0.0, 0.0, height]))).F
    np.testing.assert_allclose(printed[0], F, rtol=1e-9)


@pytest.mark.parametrize("name", [*ss.robots.NAMES])
def test_the_example_is_at_the_home_pose_under_about_the_weight(name: str) -> None:
    robot = ss.robots.load(name)
    motion = sample(robot, "exact")
    np.testing.assert_allclose(motion.t, home_pose(robot).t, atol=1e-3 * np.ptp(robot.b, axis=0).max())
    np.testing.assert_array_equal(motion.R, np.eye(3))
    weight = 9.81 * robot.M
    assert 0.1 * weight < np.linalg.norm(motion.F_ext) < weight
    # Ordinary vectors of the self-test.
    assert np.linalg.norm(poses(robot, "exact", 12).F_ext, axis=-1).max() < 1.2 * weight


@pytest.mark.parametrize(
    "flags",
    ["", pytest.param("-march=native -DSTEWART_NO_FMA", marks=pytest.mark.slow)],
    ids=["Makefile", "no fused"],
)
def test_kits_without_fused_multiply_add_have_the_bits_of_numpy(flags: str, tmp_path: Path) -> None:
    """A plain build has none on x86-64; elsewhere the macro leaves them apart."""
    put(kit_of(), tmp_path)
    (archive,) = re.findall(r"^LIBRARY = (\S+)", (tmp_path / "Makefile").read_text(), re.MULTILINE)
    plain = "" if platform.machine() in ("x86_64", "AMD64") else "-DSTEWART_NO_FMA"
    for command in (
        ["make", f"CFLAGS=-O1 -fPIC {flags or plain}", archive],
        ["cc", "-shared", "-Wl,--whole-archive", archive, "-Wl,--no-whole-archive", "-lm", "-o", "kit.so"],
    ):
        subprocess.run(command, cwd=tmp_path, check=True, capture_output=True)
    library, robot, count = ctypes.CDLL(str(tmp_path / "kit.so")), machines.dasgupta(), 500
    motion = machines.random_motion(np.random.default_rng(46), robot, (count,))
    numbers = c_kernel.prepared_model(library.stewart_exact_prepare, robot, "exact", "double")
    arrays = [np.ascontiguousarray(getattr(motion, name)) for name in kernel.MOTION]
    F = np.empty((count, 6))
    of_poses = c_kernel.pointers(arrays)
    address = c_kernel.address
    given = (address(numbers), ctypes.c_size_t(count), of_poses, address(F), None)
    assert library.stewart_exact_forces_batch(*given) == 0
    fields = dict(zip(kernel.MOTION, arrays, strict=True))
    np.testing.assert_array_equal(ss.ArrayKernel(robot, np).forces(**fields).F, F)
