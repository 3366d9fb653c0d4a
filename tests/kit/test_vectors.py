"""Test vectors: answers are the truth, the C stays within their bounds, and the bounds are sharp enough."""

import dataclasses
from functools import cache
from pathlib import Path
from typing import Any

import kits
import machines
import numpy as np
import pytest
from fifty_digits import as_stored, further, orthonormal
from kits import few_vectors, proves_itself
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.backend.kernel import MOTION
from stewart_sym.dynamics.sample_poses import MAX_CONDITION, poses, sample
from stewart_sym.kinematics.conditioning import characteristic_length, scaled_condition_number
from stewart_sym.kinematics.inverse_kinematics import clear_of_joint_singularities
from stewart_sym.kit import Choice, write_kit
from stewart_sym.kit.interpreter import KitInterpreter
from stewart_sym.kit.kit_options import STEMS
from stewart_sym.kit.vectors import FUNCTIONS, Vector, vectors
from stewart_sym.motion.motion import Motion
from stewart_sym.precision.exact_forces import Truth, digits
from stewart_sym.reference import newton_euler

WHOLE = ("inverse_dynamics", "joint_reactions")
WITHOUT_DRIVE = tuple(name for name in FUNCTIONS if name not in STEMS["torque"])

IN_FLOAT = ("forces", "forward_kinematics")


def machine(base_joint: str = "universal") -> ss.Robot:
    return kits.machine("random" if base_joint == "universal" else base_joint)


@cache
def everything() -> tuple[Vector, ...]:
    return vectors(machine(), WITHOUT_DRIVE, count=2)


def of(function: str) -> list[Vector]:
    return [vector for vector in everything() if vector.function == function]


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


@pytest.mark.slow
@few_vectors()
def test_forces_of_vectors_are_those_of_truth_to_the_bit() -> None:
    robot = machine()
    made = vectors(robot, ("forces",), count=2)[:2]
    true = Truth(robot, "exact", "general").forces(poses(robot, "exact", 2))
    for vector, F in zip(made, true, strict=True):
        np.testing.assert_array_equal(vector.answers["F"], F.astype(np.float64))


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


def moved(at: dict[str, Any], column: int, step: Any) -> dict[str, Any]:
    """The motion with one of [dt; dphi], [v; omega], [a; alpha] a step further."""
    kind, i = divmod(column, 6)
    name = (("t", "R"), ("v", "omega"), ("a", "alpha"))[kind][i // 3]
    return further(at, **{name: np.array([step * (j == i % 3) for j in range(3)])})


def test_linearization_is_that_of_forward_dynamics_to_25_digits() -> None:
    numbers, at = exactly_orthonormal()
    at["F"] = np.array([*map(digits.mpf, (10, -20, 30, 40, -50, 60))])
    interpreter = KitInterpreter(numbers, "universal")
    found = interpreter.found("linearization", at)
    A, B = found["A"].reshape(12, 12), found["B"].reshape(12, 6)
    step = digits.mpf("1e-15")
    for column in (1, 3, 5, 7, 9, 11):
        pair = [interpreter.found("forward_dynamics", moved(at, column, sign * step)) for sign in (1, -1)]
        slope = (pair[0]["acceleration"] - pair[1]["acceleration"]) / (2 * step)
        assert off(slope, A[6:, column]) < 1e-25
    more = {**at, "F": at["F"] + np.eye(6, dtype=int)[2]}
    pushed = interpreter.found("forward_dynamics", more)["acceleration"]
    assert off(pushed - found["acceleration"], B[6:, 2]) < 1e-40


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


def test_forward_kinematics_is_asked_only_where_lengths_settle_the_pose() -> None:
    """Similar circles are singular everywhere, these almost: lengths in float leave some poses open."""
    angle = np.array([0.1, 1.0, 2.3, 3.1, 4.4, 5.0])
    circle = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(6)])
    bump = 0.05 * np.eye(6)[:, :3]
    robot = dataclasses.replace(machine("spherical"), b=circle, p=0.5 * circle + bump)
    counts = {
        precision: len(vectors(robot, ("forward_velocity",), precision=precision))
        for precision in ("double", "float")
    }
    assert counts["float"] < counts["double"] == 8


@pytest.mark.slow
def test_forward_kinematics_starts_away_from_its_answer() -> None:
    for vector in of("forward_kinematics"):
        assert np.abs(vector.inputs["R_guess"] - vector.answers["R"]).max() > 1e-3


def test_an_answer_wrong_by_one_part_in_a_thousand_million_is_out_of_bounds() -> None:
    epsilon = np.finfo(np.float64).eps
    for vector in everything():
        for name, answer in vector.answers.items():
            largest = np.abs(answer).max()
            assert not largest or vector.bounds[name].max() * epsilon < 1e-9 * largest, name


@pytest.mark.slow
def test_numbers_of_float_vectors_fit_into_floats_and_answers_are_of_these() -> None:
    robot = machine()
    stored, _ = as_stored(robot, sample(robot, "exact"))
    rounded = dataclasses.replace(
        robot,
        **{name: value.astype(np.float32).astype(float)[()] for name, value in stored.items()},
    )
    for vector in vectors(robot, IN_FLOAT, precision="float", count=1):
        for values in vector.inputs.values():
            np.testing.assert_array_equal(values, values.astype(np.float32))
    vector = vectors(robot, ("forces",), precision="float", count=1)[0]
    shaped = {name: vector.inputs[name].reshape(shape) for name, shape in MOTION.items()}
    F = newton_euler.inverse_dynamics(rounded, Motion._unchecked(**shaped), newton_euler.EXACT).F
    np.testing.assert_allclose(vector.answers["F"], F, rtol=0, atol=1e-6 * np.abs(F).max())
    baked = vectors(robot, ("forces",), precision="float", count=1, baked=True)[0]
    F = newton_euler.inverse_dynamics(robot, Motion._unchecked(**shaped), newton_euler.EXACT).F
    assert np.abs(baked.answers["F"] - F).max() < np.abs(vector.answers["F"] - F).max()


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


def test_poses_within_the_length_limits_come_first() -> None:
    robot = machine()
    L = ss.inverse_kinematics(robot, poses(robot, "exact", 40)).L
    limits = np.column_stack([L[0] * 0.85, L[0] * 1.15])
    limited = dataclasses.replace(robot, length_limits=limits)
    found = ss.inverse_kinematics(limited, poses(limited, "exact", 40)).L
    within = ((limits[:, 0] <= found) & (found <= limits[:, 1])).all(axis=-1)
    assert 1 < within.sum() < len(within)
    assert within[: within.sum()].all()


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


@pytest.mark.slow
@pytest.mark.parametrize(
    ("scale", "precision"), [(1e-3, "double"), pytest.param(10.0, "float", marks=pytest.mark.full)]
)
def test_the_c_keeps_within_the_bounds_on_machines_of_any_size(
    scale: float, precision: str, tmp_path: Path
) -> None:
    robot = machines.random_robot(np.random.default_rng(1000), scale=scale)
    write_kit(robot, tmp_path / "kit", Choice(("forces", "reactions", "kinematics"), precision=precision))
    proves_itself(tmp_path / "kit", "gcc", "-O0")
