"""Near joint singularities forces lose no more digits than the machine itself, and the singular pose is told.

Every other output, heavy and short legs, and unlike proportions: ``test_degenerate_families``.
"""

import numpy as np
import pytest
from fifty_digits import truth as true_forces
from leaning_legs import leaning
from machines import machine_in_motion, random_motion, random_robot
from mpmath import mp
from reduced_machines import as_simple_as, at_rest

import stewart_sym as ss
from stewart_sym.derive.mechanics.formulation import EXACT, FORMULATIONS
from stewart_sym.derive.mechanics.reduced_models import FIDELITIES

EPSILON = np.finfo(np.float64).eps
UNITS = 1000
SINES = [1e-1, 1e-5, 1e-11]


def calm(seed: int) -> tuple[ss.Robot, ss.Motion]:
    """A machine at rest with axisymmetric legs: no force depends on the joint singularity."""
    rng = np.random.default_rng(seed)
    robot = as_simple_as(random_robot(rng), FIDELITIES["axisymmetric"])
    return robot, at_rest(random_motion(rng, robot))


@pytest.mark.parametrize("sine", SINES)
def test_a_machine_that_does_not_feel_the_joint_singularity_keeps_its_digits(sine: float) -> None:
    robot, motion = calm(1)
    robot = leaning(robot, motion, sine)
    with mp.workdps(50):
        expected = np.array([float(F) for F in true_forces(EXACT, robot, motion)["F"]])
    whole = ss.inverse_dynamics(robot, motion)
    size = max(np.abs(values).max() for values in (whole.F, whole.D, whole.x))
    bound = UNITS * EPSILON * ss.condition_number(whole.H) * size
    names = [name for name in FIDELITIES if not name.startswith(("massless", "point"))]
    found = [ss.ForceKernel(robot, fidelity=name).forces(motion) for name in names]
    found += [ss.inverse_dynamics(robot, motion, backend=backend).F for backend in ("c", "numpy")]
    for F in found:
        assert np.abs(F - expected).max() <= bound


@pytest.mark.parametrize("formulation", ["exact", "paper"])
@pytest.mark.parametrize("sine", [1e-2, 1e-8])
def test_a_general_machine_loses_no_more_than_its_own_sensitivity(formulation: str, sine: float) -> None:
    robot, motion = machine_in_motion(4)
    robot = leaning(robot, motion, sine)
    form = next(form for form in FORMULATIONS if form.kernel_name == formulation)
    with mp.workdps(50):
        expected = np.array([float(F) for F in true_forces(form, robot, motion)["F"]])
    # The leg's spin grows like the inverse sine, and with it what the error of a number does to the forces.
    kernel = ss.ForceKernel(robot, formulation)
    error = np.abs(kernel.forces(motion) - expected).max() / np.abs(expected).max()
    assert error <= UNITS * EPSILON * 60 / sine
