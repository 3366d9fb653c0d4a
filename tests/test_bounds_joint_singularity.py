"""Forces with bounds near a leg's joint singularity: bit for bit the force kernel's, and bounded."""

import dataclasses
from typing import Any

import numpy as np
import pytest
from machines import random_motion, random_robot
from numpy.typing import NDArray
from sweeps import share
from test_bounds import DTYPE, PRECISIONS

import stewart_sym as ss
from stewart_sym.motion.motion import Motion
from stewart_sym.precision.quad import error, quad_forces
from stewart_sym.results import OK, POLE
from stewart_sym.robot.robot import Robot

LEAST = 4096
"""Rounding units of the sine below which a leg is at its joint singularity."""
PATH = 1 / 32
"""Sine below which the kernels take their code path near the joint singularity."""


def drawn(rng: np.random.Generator, precision: str) -> tuple[Robot, Motion, float]:
    """A machine with some of its legs at one sine from their joint singularity, and that sine.

    From half the least sine that has a solution to 0.5; a quarter of them where the code path changes.
    """
    least = LEAST * float(np.finfo(DTYPE[precision]).eps)
    sine = np.exp(rng.uniform(np.log(0.5 * least), np.log(0.5)))
    if rng.random() < 0.25:
        sine = PATH * (1 + 1e-6 * rng.normal())
    robot = random_robot(rng)
    motion = random_motion(rng, robot)
    s = ss.inverse_kinematics(robot, motion).s
    across = np.cross(s, rng.normal(size=(6, 3)))
    across /= np.linalg.norm(across, axis=-1, keepdims=True)
    near = rng.random(6) < rng.choice([0.2, 1.0])
    k = np.where(near[:, None], np.sqrt(1 - sine**2) * s + sine * across, robot.k)
    return dataclasses.replace(robot, k=k), motion, sine if near.any() else 1.0


def swept(precision: Any, cases: int) -> dict[str, int]:
    """How many cases were solved on either path and not; every one is compared."""
    rng = np.random.default_rng(12)
    seen = {"near": 0, "far": 0, "singular": 0}
    for _ in range(cases):
        robot, motion, sine = drawn(rng, precision)
        found = ss.forces_with_bounds(robot, motion, precision, on_singular="nan")
        kernel = ss.prepare(robot, precision=precision)
        assert found.status == kernel.status(motion)
        if found.status != OK:
            assert found.status == POLE
            assert sine < 2 * LEAST * np.finfo(DTYPE[precision]).eps
            seen["singular"] += 1
            continue
        seen["near" if sine < PATH else "far"] += 1
        np.testing.assert_array_equal(found.F, kernel.forces(motion))
        errors: NDArray[np.float64] = np.abs(error(found.F, quad_forces(robot, motion, DTYPE[precision])))
        assert (errors <= found.bound).all()
        assert np.isfinite(found.bound).all() or sine < 1e3 * LEAST * np.finfo(DTYPE[precision]).eps
    return seen


@pytest.mark.parametrize("precision", PRECISIONS)
def test_forces_are_those_of_the_kernel_and_within_their_bound(precision: str) -> None:
    assert min(swept(precision, 60).values()) > 0


@pytest.mark.slow
@pytest.mark.parametrize("precision", PRECISIONS)
def test_forces_are_those_of_the_kernel_and_within_their_bound_over_ten_thousand(precision: str) -> None:
    swept(precision, share(10_000))
