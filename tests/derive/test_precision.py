"""The symbolic D, K, H, c evaluated at 50 digits agree with the C's to rounding."""

import numpy as np
import pytest
from fifty_digits import DIGITS, truth
from machines import dasgupta, random_motion, random_robot_of
from motion_fields import FIELDS
from mpmath import mp
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.derive.mechanics.formulation import EXACT, FORMULATIONS, PAPER, Formulation

UNITS = 40
EPSILON = np.finfo(np.float64).eps


def error(found: NDArray[np.float64], true: mp.matrix) -> float:
    """Largest difference beside the largest entry."""
    expected = list(true)
    difference = max(abs(mp.mpf(float(a)) - b) for a, b in zip(found.ravel(), expected, strict=True))
    return float(difference / max(abs(value) for value in expected))


@pytest.mark.parametrize("form", FORMULATIONS, ids=lambda form: form.kernel_name)
@pytest.mark.parametrize("seed", range(2))
def test_c_equals_50_digit_truth_to_rounding(form: Formulation, seed: int) -> None:
    """Every output, and forces of the prepared kernel, of one pose and of a batch."""
    rng = np.random.default_rng(seed)
    robot = dasgupta() if seed == 0 and form in (EXACT, PAPER) else random_robot_of(rng, form)
    motion = random_motion(rng, robot)
    found = ss.inverse_dynamics(robot, motion, form.name)  # type: ignore[arg-type]
    kernel = ss.prepare(robot, form.name)  # type: ignore[arg-type]
    slot = kernel.one_pose()
    slot.numbers[:] = np.concatenate([np.ravel(getattr(motion, name)) for name in FIELDS])
    assert slot.solve() == 0
    condition = ss.condition_number(found.H)
    with mp.workdps(DIGITS):
        true = truth(form, robot, motion)
        for name in ("D", "K", "H", "c"):
            assert error(getattr(found, name), true[name]) <= UNITS * EPSILON, name
        for name in ("x", "F"):
            assert error(getattr(found, name), true[name]) <= UNITS * EPSILON * condition, name
        for F in (slot.F, kernel.forces(motion)):
            assert error(F, true["F"]) <= UNITS * EPSILON * condition
