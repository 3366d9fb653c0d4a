"""The float kernels: no double in the object code, and as good as float can be on machines of any size."""

import dataclasses
import math
import platform
import re
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scalar_kernels
from attack_build import GENERATED, SOME, SOME_WITH_ROTORS
from builds import run
from machines import random_motion, random_robot, with_random_drives
from numpy.typing import NDArray
from scalar_kernels import BOUND, any_machine, numbers
from sweeps import FULL, slow_but

import stewart_sym as ss
from stewart_sym.generated.fidelities import DRIVE_FIDELITIES, FIDELITIES
from stewart_sym.motion.motion import Motion
from stewart_sym.results import OK
from stewart_sym.robot.robot import Robot

COMPILERS = [name for name in ("gcc", "clang") if shutil.which(name)]
FLOAT = ["-DSTEWART_FLOAT"]
EPSILON = float(np.finfo(np.float32).eps)

# What ends in sd or pd and yet only moves bits: two floats, or a struct of them, travel like a double.
MOVES = re.compile(
    r"v?(mov\w*|unpck[lh]|shuf|perm\w*|blendv?|broadcast|extract\w*|insert\w*|and|andn|or|xor|scatter\w*|gather\w*)"
    r"(sd|pd)"
)
# Signed doublewords, which are integers.
INTEGERS = re.compile(r"v?p(max|min)sd")


def double_instructions(listing: str) -> set[str]:
    """Mnemonics of x86 that compute with doubles or convert to or from them; those of the x87 as well."""
    mnemonics = {line.split("\t")[1].split()[0] for line in listing.splitlines() if line.count("\t") == 1}
    ends = {name for name in mnemonics if re.search(r"(sd|pd)$", name) and not MOVES.fullmatch(name)}
    ends -= {name for name in ends if INTEGERS.fullmatch(name)}
    conversions = {name for name in mnemonics if re.match(r"v?cvt.*(sd|pd)", name)}
    return (
        ends | conversions | {name for name in mnemonics if re.match(r"f(ld|st|add|sub|mul|div|sqrt)", name)}
    )


def layout_of(source: str) -> list[str]:
    """What sources of legs with rotors are compiled with."""
    return ["-DSTEWART_ROTORS"] if "_drive" in source else []


def compiled(compiler: str, flags: list[str], source: str, target: Path) -> Path:
    command = [compiler, "-std=c99", *flags, *layout_of(source), "-c", source, "-o", str(target)]
    run(*command, cwd=GENERATED)
    return target


def disassembled(target: Path) -> str:
    return run("objdump", "-d", "--no-show-raw-insn", target)


on_x86 = pytest.mark.skipif(
    platform.machine() not in ("x86_64", "AMD64") or not shutil.which("objdump"),
    reason="reads the disassembly of x86-64",
)


FAST = ["-O3", "-mavx2", "-mfma", "-fno-math-errno"]
GENERAL = ["stewart_exact.c", "stewart_exact_forces.c", "stewart_exact_motion.c", "stewart_paper_forces.c"]
# One printer writes all of them, and warnings of promotions are asked of each: of others than the general
# ones, one of each kind in the build with the fewest instructions folded or left out.
OTHERS = [f"{stem}.c" for stem in SOME if f"{stem}.c" not in GENERAL]
OTHERS += [f"{stem}.c" for stem in SOME_WITH_ROTORS]
LISTED = [(compiler, FAST, "stewart_exact_forces.c") for compiler in COMPILERS]
LISTED += [("gcc", ["-O1", *FAST[1:]], source) for source in (*OTHERS, *(GENERAL if FULL else GENERAL[:1]))]
BUILDS = {f"{source}-{compiler}{flags[0]}": (compiler, flags, source) for compiler, flags, source in LISTED}
# A double in a source is in every build of it; that builds add none of their own is a slow test, and so are
# long sources and those of the same printers.
FAST_BUILDS = ("stewart_exact_forces.c-gcc-O3", "stewart_kinematics.c-gcc-O1", f"{OTHERS[-1]}-gcc-O1")


@on_x86
@pytest.mark.parametrize("build", slow_but(FAST_BUILDS, BUILDS))
def test_float_object_code_holds_no_double(build: str, tmp_path: Path) -> None:
    compiler, flags, source = BUILDS[build]
    target = compiled(compiler, [*flags, *FLOAT], source, tmp_path / "kernel.o")
    assert double_instructions(disassembled(target)) == set()
    listed = run("nm", "-u", target)
    own, copies = {"stewart_exact_forces", "stewart_exact_forces_batch"}, {"memcpy", "memmove", "memset"}
    assert {*listed.split()} <= own | copies | {"U", "sqrtf", "_GLOBAL_OFFSET_TABLE_"}


# --- accuracy ---------------------------------------------------------------------------------


def in_lanes(robot: Robot, motion: Motion, formulation: str) -> NDArray[Any]:
    return ss.ForceKernel(robot, formulation, "float").forces(motion)


def one_pose(robot: Robot, motion: Motion, formulation: str) -> NDArray[Any]:
    status, F = scalar_kernels.prepared(robot, formulation, "general", "float").one(numbers(motion))
    assert status == OK
    return F


@pytest.mark.parametrize("forces", [in_lanes, one_pose])
def test_float_forces_are_within_100_units_times_condition_on_machines_of_any_size(forces: Any) -> None:
    """Inputs rounded to float too."""
    rng = np.random.default_rng(60)
    for _ in range(50):
        robot, motion = any_machine(rng)
        formulation = "exact" if rng.random() < 0.7 else "paper"
        truth = ss.inverse_dynamics(robot, motion, formulation)
        found = forces(robot, motion, formulation)
        assert found.dtype == np.float32
        condition = ss.scaled_condition_number(truth.H, ss.characteristic_length(robot))
        largest = max(np.abs(values).max() for values in (truth.F, truth.D, truth.x))
        assert np.abs(found - truth.F).max() <= BOUND * EPSILON * condition * largest


@pytest.mark.parametrize(
    ("fidelity", "rotors"),
    [*((level, False) for level in FIDELITIES), *slow_but((), ((level, True) for level in DRIVE_FIDELITIES))],
)
def test_every_level_in_float_is_within_100_units_times_condition_of_its_double(
    fidelity: str, rotors: bool
) -> None:
    rng = np.random.default_rng(65)
    for scale in (1e-3, 0.1, 10.0):
        robot = random_robot(rng, scale=scale)
        if rotors:
            robot = with_random_drives(rng, robot)
        motion = random_motion(rng, robot, (20,))
        expected = ss.ForceKernel(robot, fidelity=fidelity).forces(motion)
        found = ss.ForceKernel(robot, precision="float", fidelity=fidelity).forces(motion)
        full = ss.inverse_dynamics(robot, motion)
        condition = ss.scaled_condition_number(full.H, ss.characteristic_length(robot))
        largest = np.max([np.abs(values).max(axis=-1) for values in (full.F, full.D, full.x)], axis=0)
        assert (np.abs(found - expected).max(axis=-1) <= BOUND * EPSILON * condition * largest).all()


SIZES = (1e-40, 1e-4, 0.1, 0.124, 0.126, 0.5, 1.0, 63.0, 65.0, 1e3, 1e40)


def per_length(size: float) -> float:
    """One over the least power of two, 2^-100 to 2^100, that ``size`` does not exceed; 1 from 1/8 to 16."""
    power = min(max(math.ceil(math.log2(size)), -100), 100)
    return 1.0 if 0.125 <= size <= 16.0 else 2.0**-power


@pytest.mark.parametrize("precision", ["double", "float"])
def test_moments_are_taken_over_a_power_of_two_unless_the_platform_is_of_about_a_meter(
    precision: Any,
) -> None:
    robot = random_robot(np.random.default_rng(64))
    size = np.abs(robot.p - robot.p[0]).max()
    sizes = SIZES[1:-1] if precision == "float" else SIZES
    for wanted in (*sizes, 2.0**-5, 2.0**8):
        # A size that is a power of two itself is the last that has it as its length.
        similar = dataclasses.replace(robot, p=(robot.p - robot.p[0]) / size * wanted)
        expected = per_length(np.abs(similar.p).max())
        assert ss.ForceKernel(similar, precision=precision).model[-3] == expected
