"""Forces with bounds near a leg's joint singularity: bit for bit the force kernel's, and bounded."""

from typing import Any

import numpy as np
import pytest
from bound_cases import DTYPE, PRECISIONS
from drawn_poses import LEAST, PATH, drawn
from numpy.typing import NDArray
from sweeps import share

import stewart_sym as ss
from stewart_sym.precision.quad import error, quad_forces
from stewart_sym.results import JOINT_SINGULAR, OK


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
            assert found.status == JOINT_SINGULAR
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
    swept(precision, share(10_000, 50))
