"""A singular pose says what is lost there; machines singular everywhere have no pose with status ok."""

import dataclasses

import numpy as np
import pytest
from command_line import rejects
from machines import Array, dasgupta, machine_in_motion, machine_size
from sweep_machines import joined
from sweeps import FULL
from unsolvable_poses import hexagons

import stewart_sym as ss
from stewart_sym import results
from stewart_sym.motion.motion import at_rest
from stewart_sym.singularities.singular_poses import screw
from stewart_sym.studies.robustness.machines import random_machine, random_motion

ROUNDING = 1e-14


def crossing_pose() -> tuple[ss.Robot, ss.Motion]:
    robot, path = dasgupta(), ss.PAPER_PATHS["III"].path
    return robot, path.sample(ss.singularity_crossings(robot, path.sample, path.breakpoints())[0].time)


def test_no_leg_moves_under_the_lost_motion_and_no_forces_hold_the_lost_wrench() -> None:
    robot, pose = crossing_pose()
    found, H = ss.singularity(robot, pose), ss.wrench_matrix(robot, pose)
    assert np.abs(H.T @ found.twist).max() <= ROUNDING
    assert np.abs(H @ found.leg_forces).max() <= ROUNDING
    held = H @ np.linalg.lstsq(H, found.wrench, rcond=1e-12)[0]
    assert np.linalg.norm(held - found.wrench) > 0.1
    assert (found.lost_dof, found.condition_number) == (1, np.inf)
    assert found.twist @ found.wrench == pytest.approx(1.0, abs=1e-14)


@pytest.mark.parametrize("base_joint", ["universal", "spherical"])
def test_a_regular_pose_has_the_motion_that_its_legs_feel_least(base_joint: str) -> None:
    rng = np.random.default_rng(5)
    robot, motion = machine_in_motion(rng, (4, 3), base_joint)
    found, H = ss.singularity(robot, motion), ss.wrench_matrix(robot, motion)
    rates = np.einsum("...ij,...i->...j", H, found.twist)
    np.testing.assert_allclose(rates, found.smallest_singular_value[..., None] * found.leg_forces, atol=1e-13)
    length = ss.characteristic_length(robot)
    sizes = np.linalg.norm(found.twist * np.repeat([1.0, length], 3), axis=-1)
    np.testing.assert_allclose(sizes, 1.0, rtol=1e-13)
    np.testing.assert_allclose(found.condition_number, ss.scaled_condition_number(H, length))
    np.testing.assert_allclose(found.determinant * length**3, np.linalg.det(H), rtol=1e-11)
    assert found.twist.shape == (4, 3, 6)
    assert not found.lost_dof.any()
    others = rng.normal(size=(200, 4, 3, 6))
    others /= np.linalg.norm(others * np.repeat([1.0, length], 3), axis=-1, keepdims=True)
    felt = np.linalg.norm(np.einsum("...ij,k...i->k...j", H, others), axis=-1)
    assert (felt >= found.smallest_singular_value * (1 - 1e-12)).all()


def test_the_screw_has_the_twists_velocities() -> None:
    robot, motion = machine_in_motion(7, (20,))
    found = ss.singularity(robot, motion)
    v, omega = found.twist[:, :3], found.twist[:, 3:]
    on_axis = v + np.cross(omega, found.screw_point - motion.t)
    np.testing.assert_allclose(on_axis, found.screw_pitch[:, None] * omega, atol=1e-12 / machine_size(robot))
    np.testing.assert_allclose(np.cross(found.screw_axis, omega), 0.0, atol=1e-13 / machine_size(robot))
    np.testing.assert_allclose(
        np.sum((found.screw_point - motion.t) * found.screw_axis, axis=-1), 0.0, atol=1e-12
    )


def test_a_twist_that_does_not_turn_is_a_translation() -> None:
    pitch, axis, arm = screw(
        np.array([[0.0, 2.0, 0.0, 0.0, 1e-13, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 3.0]]), 0.5
    )
    np.testing.assert_array_equal(pitch, [np.inf, 0.0])
    np.testing.assert_array_equal(axis, [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    np.testing.assert_array_equal(arm, np.zeros((2, 3)))


@pytest.mark.parametrize("height", [1.0, 2.5])
def test_similar_hexagons_turned_by_90_degrees_are_singular_at_every_height(height: float) -> None:
    turn = 90.0
    robot, R = hexagons(np.radians(turn))
    found = ss.singularity(robot, (R, [0.0, 0.0, height]))
    assert found.lost_dof == 1
    assert np.abs(ss.wrench_matrix(robot, at_rest(R, [0.0, 0.0, height])).T @ found.twist).max() <= ROUNDING
    # A screw along the axis of symmetry, as Fichter (1986) found.
    np.testing.assert_allclose(np.abs(found.screw_axis), [0.0, 0.0, 1.0], atol=1e-10)
    np.testing.assert_allclose(found.screw_point[:2], 0.0, atol=1e-10)


def test_the_same_hexagons_turned_otherwise_are_not() -> None:
    for turn in (-60.0, -30.0, 30.0, 60.0, 85.0):
        robot, R = hexagons(np.radians(turn))
        found = ss.singularity(robot, (R, [0.0, 0.0, 1.0]))
        assert found.lost_dof == 0
        assert found.condition_number < 1e4


def test_a_flat_machine_has_lost_three_degrees_of_freedom() -> None:
    robot, R = hexagons(0.3)
    found = ss.singularity(robot, (R, np.zeros(3)))
    assert found.lost_dof == 3
    assert found.smallest_singular_value <= ROUNDING


def test_a_leg_of_length_zero_has_no_direction() -> None:
    robot = dasgupta()
    rejects(r"^motion: leg 3 has length zero$", ss.singularity, robot, (np.eye(3), robot.b[2] - robot.p[2]))
    rejects(r"^robot: expected a Robot", ss.singularity, None, (np.eye(3), np.zeros(3)))


LARGEST_CONDITION = {"double": 1e12, "float": 1e12 * np.finfo(np.float64).eps / np.finfo(np.float32).eps}
"""Up to these condition numbers of H no pose is singular to rounding."""


def from_afar(
    rng: np.random.Generator, robot: ss.Robot, motion: ss.Motion, radii: float
) -> tuple[ss.Robot, ss.Motion]:
    """The same from a reference point so many sizes away."""
    d = rng.normal(size=3)
    d *= radii * np.abs(robot.b).max() / np.linalg.norm(d)
    moved = dataclasses.replace(robot, p=robot.p + d, R_0=robot.R_0 + d)
    return moved, dataclasses.replace(motion, t=motion.t - motion.R @ d)


def statuses(robot: ss.Robot, motion: ss.Motion) -> dict[str, Array]:
    """Status of every pose by every kernel that solves with H."""
    found = {}
    for formulation in ("exact", "paper"):
        for backend in ("c", "numpy"):
            name = f"double inverse_dynamics {formulation} {backend}"
            found[name] = ss.inverse_dynamics(
                robot, motion, formulation=formulation, backend=backend, on_singular="nan"
            ).status
        for precision in ("double", "float"):
            kernel = ss.ForceKernel(robot, formulation=formulation, precision=precision)
            found[f"{precision} forces {formulation}"] = kernel.forces_and_status(motion)[1]
    for fidelity in ("slender", "massless_static"):
        for precision in ("double", "float"):
            kernel = ss.ForceKernel(robot, precision=precision, fidelity=fidelity)
            found[f"{precision} forces {fidelity}"] = kernel.forces_and_status(motion)[1]
    found["double bounds"] = ss.force_error_bounds(robot, motion, on_singular="nan").status
    for backend in ("c", "numpy"):
        inertia = ss.joint_space_inertia(robot, motion, on_singular="nan", backend=backend)
        lost = np.isnan(inertia).any(axis=(-2, -1))
        found[f"double joint inertia {backend}"] = np.where(lost, results.SINGULAR, results.OK)
    return found


@pytest.mark.slow
def test_good_poses_are_not_singular_from_far_away() -> None:
    """Up to the distance at which rounding of the points is that of a condition number of 1e12."""
    for seed, radii in enumerate(10.0 ** np.arange(1, 9, 1 if FULL else 3)):
        rng = np.random.default_rng(seed)
        robot = random_machine(rng)
        far = from_afar(rng, robot, joined([random_motion(rng, robot) for _ in range(10)]), radii)
        for name, status in statuses(*far).items():
            if radii <= LARGEST_CONDITION[name.split()[0]] / 1e3:
                assert (status == results.OK).all(), (name, radii)
