"""Test vectors: answers are the truth, the C stays within their bounds, and the bounds are sharp enough."""

import dataclasses
from typing import Any

import kits
import numpy as np
import pytest
from fifty_digits import orthonormal
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.backend.kernel import MOTION
from stewart_sym.dynamics.sample_poses import MAX_CONDITION, poses, sample
from stewart_sym.kinematics.conditioning import characteristic_length, scaled_condition_number
from stewart_sym.kinematics.inverse_kinematics import clear_of_joint_singularities
from stewart_sym.kit.extreme_motions import extreme_motions
from stewart_sym.kit.interpreter import KitInterpreter
from stewart_sym.kit.vectors import vectors

WHOLE = ("inverse_dynamics", "joint_reactions")


def machine(base_joint: str = "universal") -> ss.Robot:
    return kits.machine("random" if base_joint == "universal" else base_joint)


def exactly_orthonormal(base_joint: str = "universal") -> tuple[dict[str, Any], dict[str, Any]]:
    robot = machine(base_joint)
    return orthonormal(robot, sample(robot, "exact"))


def off(found: NDArray[Any], wanted: NDArray[Any]) -> float:
    """Largest difference of 50-digit numbers over the largest of them."""
    scale = max(abs(number) for number in wanted.flat)
    return float(max(abs(a - b) for a, b in zip(found.flat, wanted.flat, strict=True)) / scale)


@pytest.mark.parametrize("formulation", ["exact", "paper"])
@pytest.mark.parametrize("base_joint", ["universal", "spherical"])
def test_derived_and_generated_forces_are_the_same_to_45_digits(base_joint: str, formulation: str) -> None:
    """Where rotation and axes are of length one exactly: the two readings share no text of the equations."""
    numbers, at = exactly_orthonormal(base_joint)
    interpreter = KitInterpreter(numbers, base_joint, formulation)
    assert off(interpreter.forces(at)["F"], interpreter.inverse_dynamics(at)["F"]) < 1e-45


def test_closed_form_is_the_inverse_dynamics_to_45_digits() -> None:
    """M [a; alpha] + bias = H F + external wrench, and forward dynamics goes back."""
    numbers, at = exactly_orthonormal()
    interpreter = KitInterpreter(numbers, "universal")
    F, terms = interpreter.forces(at)["F"], interpreter.found("equations", at)
    M, H = terms["M"].reshape(6, 6), terms["H"].reshape(6, 6)
    acceleration = np.concatenate([at["a"], at["alpha"]])
    load = np.concatenate([at["R"].reshape(3, 3) @ at[name] for name in ("F_ext", "M_ext")])
    assert off(M @ acceleration + terms["bias_and_friction"], H @ F + load) < 1e-45
    assert (
        off(interpreter.found("bias_and_friction", at)["bias_and_friction"], terms["bias_and_friction"])
        < 1e-45
    )
    held = {**at, "F": F}
    back = interpreter.found("forward_dynamics", held)["acceleration"]
    assert off(back, acceleration) < 1e-45


@pytest.mark.parametrize("formulation", ["exact", "paper"])
@pytest.mark.parametrize("base_joint", ["universal", "spherical"])
def test_answers_are_those_of_the_reference(base_joint: str, formulation: str) -> None:
    robot = machine(base_joint)
    motion = poses(robot, formulation, 2)
    made = vectors(robot, WHOLE, formulation, count=2)
    for i in range(2):
        forces, reactions = made[i], made[2 + i]
        true = ss.inverse_dynamics(robot, motion[i], formulation, "reference")
        bearing = reactions.inputs["bearing"]
        joints = ss.joint_reactions(robot, motion[i], formulation, "reference", bearing)
        for vector, wanted in ((forces, true), (reactions, joints)):
            for name, answer in vector.answers.items():
                value = np.asarray(getattr(wanted, name)).ravel()
                np.testing.assert_allclose(answer, value, rtol=0, atol=1e-11 * max(np.abs(value).max(), 1e-3))


def test_poses_begin_with_the_examples_and_are_all_good() -> None:
    robot = machine()
    motions = poses(robot, "exact", 8)
    example = sample(robot, "exact")
    for name in MOTION:
        np.testing.assert_array_equal(getattr(motions, name)[0], getattr(example, name))
    assert motions.shape == (8,)
    assert poses(robot, "exact", 1).shape == (1,)
    H = ss.wrench_matrix(robot, motions)
    assert (scaled_condition_number(H, characteristic_length(robot)) <= MAX_CONDITION).all()
    assert clear_of_joint_singularities(robot, ss.inverse_kinematics(robot, motions)).all()
    assert (motions.omega == 0).all(axis=-1).any()
    for name in ("t", "omega", "v", "alpha", "a", "F_ext", "M_ext"):
        assert all(float(f"{number:.5g}") == number for number in getattr(motions, name).flat), name
    apart = np.abs(motions.R[:, None] - motions.R[None]).max(axis=(-1, -2)) + np.eye(8)
    assert apart.min() > 0.01


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"m_u": np.array([1, 1, 1e39, 1, 1, 1])}, "^robot: constants or their products exceed the range of"),
        ({"M": 4e37}, r"^robot: M: 4e\+37 kg exceeds the range of float; use a smaller mass$"),
    ],
)
def test_constants_that_float_cannot_hold_are_an_error(change: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        vectors(dataclasses.replace(machine(), **change), ("forces",), precision="float")


def test_extreme_motions_are_of_solvable_poses_and_some_near_joint_singularities() -> None:
    robot = machine()
    first = sample(robot, "exact")
    found = extreme_motions(robot, first, True)
    clear = [clear_of_joint_singularities(robot, ss.inverse_kinematics(robot, each)) for each in found]
    assert not all(clear)
    assert len(extreme_motions(robot, first, False)) == sum(map(bool, clear))
    for each in found:
        assert np.isfinite(ss.inverse_dynamics(robot, each).F).all()
