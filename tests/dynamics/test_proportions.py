"""Rounding errors stay within ten units times the condition number, whatever a machine's proportions are."""

import dataclasses

import numpy as np
import pytest
from machines import machine_in_motion
from sweeps import share

import stewart_sym as ss
from stewart_sym.studies.robustness.oracle import FORCES, cases_of, check

pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("sweep_library")]

UNITS = 10.0
"""Largest error in rounding units of the largest force, times the condition number."""
WIDEST = 50.0
"""Largest bound in the same units: all errors of one pose with the signs that add up."""


def proportioned(rng: np.random.Generator) -> tuple[ss.Robot, ss.Motion]:
    """A machine with a platform of 1 to 1e-5 of its base, some with a leg up to 1e4 times the others."""
    robot, motion = machine_in_motion(rng)
    small = 10 ** rng.uniform(-5, 0)
    load = None if motion.M_ext is None else small * motion.M_ext
    robot = dataclasses.replace(robot, p=small * robot.p, R_0=small * robot.R_0, I_p=small**2 * robot.I_p)
    motion = dataclasses.replace(motion, M_ext=load)
    if rng.uniform() < 0.5:
        leg, longer = rng.integers(6), 10 ** rng.uniform(0, 4)
        b = np.array(robot.b)
        tip = motion.R @ robot.p[leg] + motion.t
        b[leg] = tip + longer * (b[leg] - tip)
        robot = dataclasses.replace(robot, b=b)
    return robot, motion


def far_off(
    rng: np.random.Generator,
) -> tuple[ss.Robot, ss.Motion, ss.Robot, ss.Motion]:
    """A machine, and the same from a reference point up to 1e4 platform radii away."""
    robot, motion = machine_in_motion(rng)
    d = rng.normal(size=3)
    d *= 10 ** rng.uniform(0, 4) * ss.characteristic_length(robot) / np.linalg.norm(d)
    r = motion.R @ d
    a = motion.a - np.cross(motion.alpha, r) - np.cross(motion.omega, np.cross(motion.omega, r))
    moved = dataclasses.replace(
        motion,
        t=motion.t - r,
        v=motion.v - np.cross(motion.omega, r),
        a=a,
        M_ext=motion.M_ext + np.cross(d, motion.F_ext),
    )
    return robot, motion, dataclasses.replace(robot, p=robot.p + d, R_0=robot.R_0 + d), moved


def checked(precision: str, seeds: range, afar: bool = False) -> np.ndarray:
    """Largest error of each kernel over the condition number, (kernels, cases).

    afar: from a far reference point; the condition number of H is the one from the platform itself.
    """
    draw = far_off if afar else proportioned
    parts = list(zip(*(draw(np.random.default_rng(seed)) for seed in seeds), strict=True))
    found = check(cases_of(*map(list, parts[-2:])), FORCES, precision)
    near = check(cases_of(*map(list, parts[:2])), FORCES[2:], precision)[FORCES[2]]
    assert all((each.truth == 0).all() for each in found.values())
    least = np.fmax(near.condition, 1.0) if afar else 1.0
    return np.array([each.error / np.fmax(each.condition, least) for each in found.values()])


@pytest.mark.parametrize("precision", ["double", "float"])
def test_no_kernel_loses_digits_with_the_proportions(precision: str) -> None:
    error = checked(precision, range(share(10_000, 200)))
    assert np.isfinite(error).all()
    assert error.max() <= UNITS


@pytest.mark.parametrize("precision", ["double", "float"])
def test_nor_with_the_distance_of_the_reference_point(precision: str) -> None:
    error = checked(precision, range(share(10_000, 250)), afar=True)
    assert np.isfinite(error).all()
    assert error.max() <= UNITS


def test_bounds_are_no_wider_from_a_far_reference_point() -> None:
    for seed in range(6):
        robot, motion, far_robot, far_motion = far_off(np.random.default_rng(seed))
        found = check(cases_of([robot, far_robot], [motion, far_motion]), FORCES[2:])[FORCES[2]]
        unit = np.finfo(float).eps * found.size[1] * found.condition.max()
        assert ss.force_error_bounds(far_robot, far_motion).bound.max() <= WIDEST * unit
