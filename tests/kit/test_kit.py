"""The kit of a robot: it builds silently, proves itself, repeats to the byte and spares what is there."""

import ctypes
import dataclasses
import hashlib
import json
import os
from pathlib import Path

import builds
import machines
import numpy as np
import pytest
from kits import COMPILERS, STRICT, c_of, few_vectors, kit_of, machine, proves_itself
from sweeps import FULL

from stewart_sym.backend import kernel, native
from stewart_sym.calls import c_kernel
from stewart_sym.derive.package.text_format import robot_symbol
from stewart_sym.kit import FUNCTIONS, Choice, kit, kit_names, put, write_kit
from stewart_sym.kit.required_kernels import parts

FORMULATIONS = ("exact", "paper")
SOLVE = "stewart_solve.h"
NAMES = {
    *("stewart.h", "stewart_arithmetic.h", "stewart_robot.h", "stewart_robot.c", "stewart.hpp"),
    *("stewart_rotation.h", "stewart_rotation.c", "test/selftest.c", "example/main.c", "README.md"),
    *("manifest.json", "Makefile", "robot.toml", "LICENSE", "CMakeLists.txt", "Config.cmake.in"),
}


# ---------------------------------------------------------------- what a kit does


F, R, M, D, K, T = FUNCTIONS
# Functions, formulation, level, baked, scalar, precision, unit of FMI: every two values come together.
WISHES = [
    ("spherical rotors", (F, K, T), "exact", "reflected_massless", False, False, "double", None),
    ("random drive", (F, R, M, D, K, T), "exact", "slender_static", True, True, "double", None),
    ("random drive", (F, T), "paper", None, True, False, "float", "forces-rpy"),
    ("random rotors", (F, M, D, K), "exact", None, False, False, "float", None),
    ("random drive", (F, K, T), "exact", "general_static", False, False, "float", "forces"),
    ("random", (F, R, K), "paper", None, False, False, "float", None),
    ("spherical rotors", (F, R, K, T), "exact", "reflected_slender", True, True, "float", "forces-rpy"),
    ("spherical", (F, K), "paper", None, False, False, "double", "forces"),
    ("spherical", (F, K), "exact", "slender", False, True, "float", None),
    ("random rotors", (F, M, D), "exact", "reflected_massless_friction", False, False, "double", "plant"),
    ("random", (F,), "paper", None, True, True, "double", None),
    ("random", (M, D, K), "exact", None, False, False, "float", None),
    ("random rotors", (F, K), "exact", "point_masses_friction", False, False, "double", None),
]


@pytest.mark.slow
@pytest.mark.parametrize("number", range(len(WISHES) if FULL else 2))
def test_every_two_options_together_give_a_kit_that_proves_itself(tmp_path: Path, number: int) -> None:
    which, *options = WISHES[number]
    choice = Choice(*options)
    with few_vectors():
        made, _ = write_kit(machine(which), tmp_path / "kit", choice)
    assert list(made.files) == kit_names(machine(which), choice)
    proves_itself(tmp_path / "kit", list(COMPILERS)[number % len(COMPILERS)], "-O0")


@pytest.mark.slow
def test_kit_holds_only_what_was_asked_for() -> None:
    kernels = {
        "forces": {"stewart_exact_pose.h", "stewart_exact_pose.c", "stewart_kit.h", SOLVE},
        "reactions": {"stewart_exact.h", "stewart_exact.c", SOLVE, "stewart_outputs.h"},
        "kinematics": {"stewart_kinematics.h", "stewart_kinematics.c"},
    }
    for group, files in kernels.items():
        choice = Choice((group,), scalar=group == "forces")
        assert set(kit_names(machine("random"), choice)) == NAMES | files


def test_selftest_without_stdio_prints_nothing_and_needs_no_printf(tmp_path: Path) -> None:
    put(kit_of(choice=Choice(scalar=True)), tmp_path)
    command = ["gcc", "-std=c99", *STRICT, "-DSTEWART_NO_STDIO", "-I.", "-c", "test/selftest.c"]
    builds.run(*command, cwd=tmp_path)
    assert "printf" not in builds.run("nm", "-u", "selftest.o", cwd=tmp_path)


@pytest.mark.slow
@pytest.mark.parametrize("which", ["random", "spherical"])
def test_constants_reach_the_compiled_robot_to_the_bit(which: str) -> None:
    robot = machine(which)
    with few_vectors():
        made = kit(robot, Choice(("kinematics",)))
    library = native.load("kit_robot", c_of(made, r"stewart\.h|stewart_robot\.[ch]"))
    numbers = kernel.robot_numbers(robot)
    found = (ctypes.c_double * numbers.size).in_dll(library, robot_symbol(robot.name))
    np.testing.assert_array_equal(np.array(found), numbers)


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_kernel_files_are_the_committed_ones(formulation: str) -> None:
    files = parts(machine("random"), Choice(("forces", "reactions"), formulation)).files
    committed = [c_kernel.c_sources(name) for name in (formulation, f"{formulation}_forces", "rotation")]
    assert files == dict(item for each in committed for item in each.items())


@pytest.mark.slow
def test_manifest_tells_options_version_and_every_file() -> None:
    made = kit_of(choice=Choice(("kinematics", "forces"), scalar=True))
    manifest = json.loads(made.files["manifest.json"])
    assert manifest["generator"].startswith("stewart-sym ")
    assert manifest["options"] == {
        "functions": ["forces", "kinematics"],
        "formulation": "exact",
        "fidelity": None,
        "bake": False,
        "scalar": True,
        "precision": "double",
        "fmu": None,
        "language": "c",
    }
    others = {name: hashlib.sha256(text).hexdigest() for name, text in made.files.items()}
    del others["manifest.json"]
    assert manifest["files"] == others


# ---------------------------------------------------------------- names


@pytest.mark.parametrize(
    ("name", "symbol"),
    [
        ("Dasgupta & Mruthyunjaya 1998", "stewart_robot_dasgupta_mruthyunjaya_1998"),
        ("Prüfstand Süd, Größe 2", "stewart_robot_prufstand_sud_grosse_2"),
        ("6-SPS", "stewart_robot_6_sps"),
        ("  __x__  ", "stewart_robot_x"),
        ("double", "stewart_robot_double"),
    ],
)
def test_symbol_is_an_identifier_made_of_the_name(name: str, symbol: str) -> None:
    assert robot_symbol(name) == symbol


@pytest.mark.slow
@pytest.mark.parametrize("compiler", ["gcc", "clang++"])
def test_any_name_compiles(tmp_path: Path, compiler: str) -> None:
    name = '*/ int x; /* "a" \\n %s @kernel@ //* ??/ ünï 机器人 {0} | `b` \\'
    put(kit_of(name, Choice(scalar=True)), tmp_path / "kit")
    proves_itself(tmp_path / "kit", compiler, "-O0")


# ---------------------------------------------------------------- poses


def test_robot_without_a_good_pose_is_rejected(tmp_path: Path) -> None:
    robot = machines.dasgupta()
    angle = np.array([0.1, 1.0, 2.3, 3.1, 4.4, 5.0])
    circle = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(6)])
    with pytest.raises(ValueError, match=r"\Arobot 'Dasgupta .*': no good pose for the example: .*\Z"):
        write_kit(dataclasses.replace(robot, b=circle, p=0.5 * circle), tmp_path / "kit")
    assert os.listdir(tmp_path) == []
