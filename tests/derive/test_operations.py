"""Operation counts: what the headers claim is what the C executes, and it stays below the limits."""

from pathlib import Path
from string import Template

import numpy as np
import pytest
from counting_c import REPORT, counted
from machines import random_motion, random_robot, random_robot_of
from sweeps import FULL

from stewart_sym.backend.kernel import module
from stewart_sym.calls.c_kernel import c_sources
from stewart_sym.derive.generated_files import reduced_forces
from stewart_sym.derive.kernel.operations import force_operations
from stewart_sym.derive.mechanics.formulation import EXACT, EXACT_DRIVE, PAPER
from stewart_sym.kit import Choice
from stewart_sym.kit.required_kernels import parts
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

PLAIN = """static stewart_forces forces;
    counts = Counts();
    int status = stewart_${KERNEL}_inverse_dynamics(&robot, &motion, &forces);"""
BLOCK = """static stewart_${KERNEL}_model model;
    stewart_${KERNEL}_prepare(&robot, &model);
    static Real F[48];
    stewart_motions all = {motion.R, motion.t, motion.omega, motion.v, motion.alpha, motion.a, 0, 0};
    counts = Counts();
    int status = stewart_${KERNEL}_forces_batch(&model, 1, &all, F, 0);"""

FOLDED_BLOCK = """static Real F[48];
    stewart_motions all = {motion.R, motion.t, motion.omega, motion.v, motion.alpha, motion.a, 0, 0};
    counts = Counts();
    int status = ${FORCES}_batch(1, &all, F, 0);"""
FOLDED_POSE = """static Real F[6];
    counts = Counts();
    int status = ${FORCES}(&motion, F);"""


OF_FORMS = pytest.mark.parametrize(
    "form", [EXACT, EXACT_DRIVE, PAPER] if FULL else [EXACT_DRIVE], ids=lambda form: form.kernel_name
)


def executed(
    kernel: str, texts: dict[str, str], robot: Robot, motion: Motion, folder: Path, *calls: str
) -> list[tuple[int, ...]]:
    """(mul, add, div, sqrt) that each call executes; texts: the C by file name."""
    includes = "\n".join(f'#include "{name}"' for name in sorted(texts) if name.endswith(".c"))
    done = Template("\n".join(f"{{ {call}{REPORT} }}" for call in calls)).substitute(KERNEL=kernel)
    found = counted(texts, includes, done, robot, motion, folder, kernel)
    assert [status for status, _ in found] == [0] * len(calls)
    return [counts for _, counts in found]


@pytest.mark.slow
@OF_FORMS
def test_header_counts_are_the_operations_that_the_c_executes(form, tmp_path: Path) -> None:
    rng = np.random.default_rng(3)
    robot = random_robot_of(rng, form)
    name = form.kernel_name
    (found,) = executed(name, c_sources(name), robot, random_motion(rng, robot), tmp_path, PLAIN)
    assert found == module(name).OPERATIONS["friction"]["total"]


@pytest.mark.slow
@OF_FORMS
def test_header_counts_of_the_force_kernel_are_what_each_lane_executes(form, tmp_path: Path) -> None:
    rng = np.random.default_rng(4)
    robot = random_robot_of(rng, form)
    name = form.kernel_name
    sources = c_sources(f"{name}_forces")
    (found,) = executed(name, sources, robot, random_motion(rng, robot), tmp_path, BLOCK)
    assert found == tuple(8 * n for n in module(name).FORCE_OPERATIONS["friction"]["total"])


@pytest.mark.slow
@pytest.mark.parametrize("scalar", [False, True])
def test_count_with_folded_numbers_is_what_the_c_executes_where_moments_are_scaled(
    scalar: bool, tmp_path: Path
) -> None:
    rng = np.random.default_rng(9)
    robot = random_robot(rng, scale=1 / 64)
    made = parts(robot, Choice(bake=True, scalar=scalar))
    (forces,) = (each for each in made.functions if each.stem == "forces")
    call = FOLDED_POSE if scalar else FOLDED_BLOCK
    sources = {name: text for name, text in made.files.items() if name != "stewart_rotation.c"}
    done = Template(call).safe_substitute(FORCES=forces.symbol)
    (found,) = executed("exact", sources, robot, random_motion(rng, robot), tmp_path, done)
    # Sums of sizes, as above, and the product of six constants that a compiler folds.
    poses, checks = (1, 9 + 5) if scalar else (8, 0)
    assert sum(found) == poses * made.baked_operations + checks


def test_force_kernel_stays_within_its_limits() -> None:
    counts = module("exact").FORCE_OPERATIONS
    assert sum(counts["frictionless"]["total"]) <= 2000
    assert sum(counts["friction"]["total"]) <= 2206


def test_a_fused_product_and_sum_are_one_of_the_two() -> None:
    counts = force_operations(reduced_forces(EXACT))
    assert 0.6 * counts.total.add < counts.fused < counts.total.add
    text = c_sources("exact_forces")["stewart_exact_forces.h"]
    assert f"fused multiply-add instructions: {counts.total.total - counts.fused} and" in text


def test_paper_kernel_is_cheaper_than_the_papers_program() -> None:
    claimed = module("paper").OPERATIONS["frictionless"]
    assert sum(claimed["leg"]) < 694
    assert sum(claimed["platform"]) < 273
    assert sum(claimed["solve"]) < 452
    assert sum(claimed["total"]) < 4889
