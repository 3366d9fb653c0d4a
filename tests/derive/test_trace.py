"""Traces of kernels: recorded steps, and the functions of their schedules."""

import pytest

from stewart_sym.derive.kernel.shared import common_parts
from stewart_sym.derive.kernels.solve import solver
from stewart_sym.derive.program.block import Quantity
from stewart_sym.derive.trace import nodes as t
from stewart_sym.derive.trace.lanes import Lanes
from stewart_sym.derive.trace.recorder import LEG, MOTION, Trace, inputs_of
from stewart_sym.derive.trace.values import where

SPEED = Quantity("speed", (), "m/s", "speed")
MASS = Quantity("mass", (), "kg", "mass of a leg")


def momentum() -> Trace:
    """Trace the sum of the momenta of the legs, which is doubled above a threshold."""
    k = Trace(inputs_of(MOTION, (SPEED,)) | inputs_of(LEG, (MASS,)))
    with k.part("legs", per_leg=True):
        product = k.let("product", k.input("mass") * k.input("speed"))
        k.let("unused", product * product)
    with k.part("sum"):
        total = k.accumulator("total", k.input("speed") * 0.0)
    with k.part("legs", per_leg=True):
        k.accumulate(total, product)
    with k.rarely(total > 1.0) as branch, k.part("doubled"):
        branch.update(total, k.let("twice", total * 2.0))
    k.result = [total]
    return k


def names(function: t.Function) -> set[str]:
    """Return the names that a function defines."""
    return {each.name for each in t.statements(function.body) if isinstance(each, t.Let)}


def test_condition_on_a_value_is_rejected() -> None:
    k = Trace(inputs_of(MOTION, (SPEED,)))
    with pytest.raises(TypeError, match=r"use where\(test, yes, no\)"):
        bool(k.input("speed") > 0.0)
    assert where(k.input("speed") > 0.0, 1.0, 0.0).expr != t.Number(1.0)


@pytest.mark.parametrize("poses_in_lanes", [False, True])
def test_steps_that_no_result_needs_are_omitted(poses_in_lanes: bool) -> None:
    schedule = Lanes(momentum(), "model", poses_in_lanes)
    assert not any("unused" in names(function) for function in schedule.functions.values())
    # In a block each leg joins the sum at once.
    assert set(schedule.structures()) == ({"sum"} if poses_in_lanes else {"legs", "sum"})


def test_branch_selects_by_pose_if_poses_are_in_lanes() -> None:
    one, block = (Lanes(momentum(), "model", each).functions["doubled"] for each in (False, True))
    assert not any(isinstance(each, t.Select) for each in t.parts_of(one.body))
    assert any(isinstance(each, t.Select) for each in t.parts_of(block.body))


def test_part_of_a_leg_is_a_loop_over_legs_or_a_function_of_one_leg() -> None:
    one, block = (Lanes(momentum(), "model", each).functions["legs"] for each in (False, True))
    ends = [
        next(each.last for each in t.statements(of.body) if isinstance(each, t.For)) for of in (one, block)
    ]
    assert ends == [t.Constant("LANES"), t.Constant("POSES")]
    assert [each.name for each in block.arguments if each.type == t.Integer()] == ["leg"]


def test_first_leg_has_no_moments_about_its_own_point() -> None:
    solves = (Lanes(solver(about_tip), "", True).functions["two_blocks"] for about_tip in (True, False))
    about_tip, about_reference = (len(list(t.parts_of(each.body))) for each in solves)
    assert about_tip < about_reference


def test_common_functions_are_in_the_header_once() -> None:
    found = [each.name for each in common_parts()]
    assert len(found) == len(set(found))
    assert {"compute_two_blocks_pose", "compute_pivots_pose", "compute_pivots_block"} <= set(found)
