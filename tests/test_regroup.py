"""The regrouped blocks give the forces of the elimination, from fewer operations."""

import functools

import numpy as np
import pytest
from machines import random_motion, random_robot
from mpmath import mp
from test_precision import block_inputs, named, truth

from stewart_sym.derive.block import Block
from stewart_sym.derive.formulation import EXACT, FORMULATIONS, PAPER, Formulation
from stewart_sym.derive.generate import reduced_forces
from stewart_sym.derive.operations import force_operations
from stewart_sym.derive.prepared import ADDED
from stewart_sym.derive.reduce import share
from stewart_sym.derive.regroup import ForceKernel, force_kernel
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

ROUNDING = 1e-13
derived = functools.cache(force_kernel)


def by_name(block: Block, outputs: dict[str, tuple]) -> dict[str, mp.mpf]:
    """The outputs of a block under the names of their components."""
    return {
        name: value
        for out in block.outputs
        for name, value in zip(out.quantity.names, outputs[out.quantity.name], strict=True)
    }


def forces(kernel: ForceKernel, robot: Robot, motion: Motion) -> mp.matrix:
    """F from the regrouped blocks, in the working precision."""
    kernel = kernel.whole()
    first = named("p_1", robot.p[0])
    raw = [block_inputs(robot, motion, leg) | first for leg in range(6)]
    legs = [by_name(kernel.prepare_leg, kernel.prepare_leg.run(values, mp.sqrt)) for values in raw]
    added = {name: sum(leg[name] for leg in legs) for quantity in ADDED for name in quantity.names}
    platform = by_name(kernel.prepare_platform, kernel.prepare_platform.run(raw[0] | added, mp.sqrt))
    shared = kernel.shared.run(raw[0] | platform, mp.sqrt)
    turn = by_name(kernel.shared, shared)
    nothing = {"D": (0,), "c_force": (0,) * 3, "c_moment": (0,) * 3, "arm_c": (0,) * 3}
    c = mp.matrix([*shared["c_force"], *shared["c_tip"]])
    D, H = mp.matrix(6, 1), mp.matrix(6, 6)
    for i, leg in enumerate(legs):
        found = nothing | kernel.leg.run(raw[i] | turn | leg, mp.sqrt)
        D[i] = found["D"][0]
        c += mp.matrix([*found["c_force"], *found["c_moment"]])
        c += mp.matrix([0, 0, 0, *found["arm_c"]])
        for j in range(3):
            H[j, i], H[j + 3, i] = found["H_force"][j], found["H_moment"][j]
    return D - mp.lu_solve(H, c)


@pytest.mark.parametrize("form", FORMULATIONS, ids=lambda form: form.kernel_name)
@pytest.mark.parametrize("friction", [True, False])
@pytest.mark.parametrize("seed", range(3))
def test_forces_are_those_of_the_elimination(form: Formulation, friction: bool, seed: int) -> None:
    rng = np.random.default_rng(seed)
    robot = random_robot(rng, form.base_joint, friction=friction)
    motion = random_motion(rng, robot)
    with mp.workdps(50):
        expected = truth(form, robot, motion)["F"]
        found = forces(derived(form, friction), robot, motion)
        # R and k are orthonormal to double rounding only, and the two forms use that at different places.
        assert mp.mnorm(found - expected, mp.inf) <= ROUNDING * mp.mnorm(expected, mp.inf)


def test_regrouping_saves_operations_in_every_formulation() -> None:
    from stewart_sym.backend.kernel import module

    for form in FORMULATIONS:
        for label, friction in (("friction", True), ("frictionless", False)):
            plain = sum(module(form.kernel_name).OPERATIONS[label]["total"])
            assert force_operations(reduced_forces(form, friction)).total.total < plain


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
