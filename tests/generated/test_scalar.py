"""Kernels for processors without vector registers answer as those with lanes, with a status where they do."""

import ctypes
import dataclasses
from typing import Any, cast

import numpy as np
import pytest
from leaning_legs import leaning
from machines import machine_in_motion, random_motion, random_robot
from scalar_kernels import BOUND, UNTOUCHED, Array, Kernel, compiled, numbers, prepared
from sweeps import FULL, slow_but
from unsolvable_poses import leg_along_its_axis, singular, zero_length_leg

import stewart_sym as ss
from stewart_sym.backend.kernel import robot_numbers
from stewart_sym.calls.c_kernel import function
from stewart_sym.generated.fidelities import FIDELITIES
from stewart_sym.motion.motion import Motion
from stewart_sym.results import BAD_ARGUMENT, JOINT_SINGULAR, OK, SINGULAR, ZERO_LENGTH
from stewart_sym.robot.robot import Robot

EPSILON = {"double": float(np.finfo(np.float64).eps), "float": float(np.finfo(np.float32).eps)}
PLAIN = ["general", "massless_static"]
# Of the others one; the rest with STEWART_FULL=1. A kit
# of every level proves itself in `test_kit`.
SPANNING = ["slender"]
OTHERS = [level for level in FIDELITIES if level not in PLAIN and (FULL or level in SPANNING)]
LEVELS = slow_but(PLAIN, [*PLAIN, *OTHERS])


def baked_kernel(robot: Robot, level: str, precision: str = "double") -> Kernel:
    return Kernel(*compiled(robot, precision, bake=True, fidelity=level), precision, None)


def agree(kernel: Kernel, robot: Robot, motion: Motion, formulation: str, level: str) -> None:
    """Same statuses as with lanes; forces within units of rounding, condition and largest force."""
    lanes = ss.ForceKernel(robot, formulation, kernel.precision, level)  # type: ignore[arg-type]
    F, status = kernel.forces_and_status(motion)
    expected, codes = lanes.forces_and_status(motion)
    np.testing.assert_array_equal(status, codes)
    good = np.flatnonzero(status == OK)
    full = ss.inverse_dynamics(robot, motion[good], formulation, on_singular="nan")  # type: ignore[arg-type]
    condition = ss.scaled_condition_number(full.H, ss.characteristic_length(robot))
    largest = np.max(
        [np.abs(values).max(axis=-1) for values in (full.F, full.D, full.x, expected[good])], axis=0
    )
    bound = BOUND * EPSILON[kernel.precision] * condition * largest
    assert (np.abs(F[good] - expected[good]).max(axis=-1) <= bound).all()


# --- the same answers -------------------------------------------------------------------------


@pytest.mark.parametrize("precision", ["double", "float"])
@pytest.mark.parametrize("level", LEVELS)
def test_every_level_answers_as_with_lanes(level: str, precision: str) -> None:
    # Moments are taken over a length but for scales near one.
    for seed, scale in ((1, 1.0), (2, 1e-3), (3, 10.0), (4, 100.0)):
        robot, motion = machine_in_motion(seed, (20,), scale=scale)
        agree(prepared(robot, "exact", level, precision), robot, motion, "exact", level)


@pytest.mark.parametrize("precision", slow_but(["double"], ["double", "float"]))
@pytest.mark.parametrize(
    ("formulation", "joint"),
    [("paper", "universal"), ("exact", "spherical"), *slow_but((), [("paper", "spherical")])],
)
def test_every_formulation_and_joint_answers_as_with_lanes(
    formulation: str, joint: str, precision: str
) -> None:
    for seed in range(3):
        robot, motion = machine_in_motion(seed, (20,), joint)
        kernel = prepared(robot, formulation, "general", precision)
        agree(kernel, robot, motion, formulation, "general")


# --- near failure -----------------------------------------------------------------------------


@pytest.mark.parametrize("precision", ["double", "float"])
@pytest.mark.parametrize("formulation", ["exact", "paper"])
def test_near_a_joint_singularity_status_and_code_path_are_those_of_the_lanes(
    formulation: str, precision: str
) -> None:
    rng = np.random.default_rng(9)
    seen = set()
    for sine in 10.0 ** rng.uniform(-17, 0, 20):
        robot, motion = machine_in_motion(rng)
        robot = leaning(robot, motion, float(sine))
        kernel = prepared(robot, formulation, "general", precision)
        lanes = ss.ForceKernel(robot, formulation, precision)  # type: ignore[arg-type]
        status, F = kernel.one(numbers(motion))
        expected, code = lanes.forces_and_status(motion)
        assert status == code
        seen.add(int(status))
        if status == OK:
            # The leg's spin grows like the inverse sine, and with it what the rounding of a number does.
            assert np.abs(F - expected).max() <= 1e5 * EPSILON[precision] / sine * np.abs(expected).max()
    assert seen == {OK, JOINT_SINGULAR}


@pytest.mark.parametrize("precision", ["double", "float"])
@pytest.mark.parametrize("level", slow_but(["general"], ["general", "massless"]))
def test_zero_length_legs_have_the_status_of_the_lanes_at_every_length(level: str, precision: str) -> None:
    rng = np.random.default_rng(11)
    seen = set()
    for length in 10.0 ** rng.uniform(-18, -3, 20):
        robot = random_robot(rng, scale=float(10 ** rng.uniform(-3, 1)))
        robot = dataclasses.replace(robot, b=robot.b + 10 ** rng.uniform(-2, 2) * rng.uniform(-1, 1, 3))
        motion, leg = random_motion(rng, robot), int(rng.integers(6))
        along = rng.normal(size=3)
        t = robot.b[leg] - motion.R @ robot.p[leg] + length * along / np.linalg.norm(along)
        motion = dataclasses.replace(motion, t=t)
        lanes = ss.ForceKernel(robot, "exact", precision, level)  # type: ignore[arg-type]
        status, _ = prepared(robot, "exact", level, precision).one(numbers(motion))
        assert status == lanes.forces_and_status(motion)[1]
        seen.add(int(status))
    assert {OK, ZERO_LENGTH} <= seen


@pytest.mark.parametrize("precision", slow_but(["double"], ["double", "float"]))
@pytest.mark.parametrize("make", [zero_length_leg, leg_along_its_axis, singular])
def test_failures_have_the_status_of_the_lanes(make: Any, precision: str) -> None:
    robot, motion = make()
    for level in ("general", "massless_static"):
        lanes = ss.ForceKernel(robot, "exact", precision, level)  # type: ignore[arg-type]
        kernels = [prepared(robot, "exact", level, precision)]
        if (level == "general") == (precision == "double"):
            kernels.append(baked_kernel(robot, level, precision))
        for kernel in kernels:
            status, F = kernel.one(numbers(motion))
            assert status == lanes.forces_and_status(motion)[1]
            assert status == OK or (F == UNTOUCHED).all()


# --- wrong calls ------------------------------------------------------------------------------


@pytest.mark.parametrize("level", LEVELS if FULL else PLAIN)
def test_an_unprepared_model_and_null_pointers_have_a_status(level: str) -> None:
    robot = random_robot(np.random.default_rng(14))
    motion = numbers(random_motion(np.random.default_rng(15), robot))
    for precision in ("double", "float"):
        kernel = prepared(robot, "exact", level, precision)
        blank = dataclasses.replace(kernel, model=np.zeros_like(cast(Array, kernel.model)))
        status, F = blank.one(motion)
        assert status in (ZERO_LENGTH, JOINT_SINGULAR, SINGULAR)
        assert (F == UNTOUCHED).all()
        given, F = motion.astype(kernel.dtype), np.full(6, UNTOUCHED, dtype=kernel.dtype)
        pointers = [cast(Array, kernel.model).ctypes.data, given.ctypes.data, F.ctypes.data]
        call = getattr(kernel.library, f"{kernel.prefix}_forces")
        for missing in range(3):
            some = [None if i == missing else pointer for i, pointer in enumerate(pointers)]
            assert call(*map(ctypes.c_void_p, some)) == BAD_ARGUMENT
        assert (F == UNTOUCHED).all()


@pytest.mark.parametrize("level", LEVELS if FULL else PLAIN)
def test_a_robot_that_is_not_finite_is_rejected_and_the_model_left_alone(level: str) -> None:
    robot = random_robot(np.random.default_rng(16))
    kernel = prepared(robot, "exact", level)
    call = getattr(kernel.library, f"{kernel.prefix}_prepare")
    numbers = robot_numbers(robot)
    model = np.full(1000, UNTOUCHED)
    lanes = function(ss.ForceKernel(robot, fidelity=level).name, "prepare", "_forces")
    other, rejected = np.full(5000, UNTOUCHED), 0
    for where in range(numbers.size):
        for value in (np.nan, np.inf, 1e308):
            given = numbers.copy()
            given[where] = value
            status = call(ctypes.c_void_p(given.ctypes.data), ctypes.c_void_p(model.ctypes.data))
            expected = lanes(ctypes.c_void_p(given.ctypes.data), ctypes.c_void_p(other.ctypes.data))
            assert status == expected, (where, value)
            if status != OK:
                rejected += 1
                assert (model == UNTOUCHED).all()
            model[:], other[:] = UNTOUCHED, UNTOUCHED
    assert rejected > 50
    for pointers in ((0, model.ctypes.data), (numbers.ctypes.data, 0)):
        assert call(*map(ctypes.c_void_p, pointers)) == BAD_ARGUMENT
