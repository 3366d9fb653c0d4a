"""The regrouped blocks give the forces of the elimination, from fewer operations."""

import functools

import numpy as np
import pytest
from block_forces import forces
from fifty_digits import truth
from machines import random_motion, random_robot_of
from mpmath import mp

from stewart_sym.derive.generate import reduced_forces
from stewart_sym.derive.kernel.operations import force_operations
from stewart_sym.derive.mechanics.actuator_forces import force_kernel
from stewart_sym.derive.mechanics.formulation import EXACT, FORMULATIONS, PAPER, Formulation
from stewart_sym.derive.program.cse import share

ROUNDING = 1e-13
derived = functools.cache(force_kernel)


@pytest.mark.parametrize("form", FORMULATIONS, ids=lambda form: form.kernel_name)
@pytest.mark.parametrize("friction", [True, False])
def test_forces_are_those_of_the_elimination(form: Formulation, friction: bool) -> None:
    rng = np.random.default_rng(0)
    robot = random_robot_of(rng, form, friction)
    motion = random_motion(rng, robot)
    with mp.workdps(50):
        expected = truth(form, robot, motion)["F"]
        found = forces(derived(form, friction), robot, motion)
        # R and k are orthonormal to double rounding only, and the two forms use that at different places.
        assert mp.mnorm(found - expected, mp.inf) <= ROUNDING * mp.mnorm(expected, mp.inf)


def test_regrouping_saves_operations_in_every_formulation() -> None:
    from stewart_sym.backend.kernel import module

    for form in FORMULATIONS:
        for label, counts in module(form.kernel_name).OPERATIONS.items():
            regrouped = force_operations(reduced_forces(form, label == "friction"))
            assert regrouped.total.total < sum(counts["total"])


def test_paper_needs_no_more_than_exact() -> None:
    for friction in (True, False):
        paper, exact = (
            force_operations(reduced_forces(form, friction)).total.total for form in (PAPER, EXACT)
        )
        assert paper <= exact


def test_named_steps_survive_sharing() -> None:
    leg = derived(EXACT, True).leg
    names = [step.name for step in leg.steps]
    assert [step.name for step in share(leg).steps if step.name in set(names)] == names
