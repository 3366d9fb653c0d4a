"""A singular pose says what is lost there: no leg moves under its twist, no leg forces hold its wrench."""

import dataclasses

import numpy as np
import pytest
from command_line import rejects
from hexagon_machines import Array, hexagons
from machines import dasgupta, machine_in_motion, machine_size, rotation
from unsolvable_poses import semiregular

import stewart_sym as ss
from stewart_sym.singularities.singular_poses import screw

ROUNDING = 1e-14


def crossing_pose() -> tuple[ss.Robot, ss.Motion]:
    robot, path = dasgupta(), ss.PATHS["III"].path
    return robot, path.sample(ss.crossings(robot, path.sample, path.breaks())[0].time)


def test_no_leg_moves_under_the_lost_motion_and_no_forces_hold_the_lost_wrench() -> None:
    robot, pose = crossing_pose()
    found, H = ss.singularity(robot, pose), ss.wrench_matrix(robot, pose)
    assert np.abs(H.T @ found.twist).max() <= ROUNDING
    assert np.abs(H @ found.forces).max() <= ROUNDING
    held = H @ np.linalg.lstsq(H, found.wrench, rcond=1e-12)[0]
    assert np.linalg.norm(held - found.wrench) > 0.1
    assert (found.lost, found.condition) == (1, np.inf)
    assert found.twist @ found.wrench == pytest.approx(1.0, abs=1e-14)


@pytest.mark.parametrize("base_joint", ["universal", "spherical"])
def test_a_regular_pose_has_the_motion_that_its_legs_feel_least(base_joint: str) -> None:
    rng = np.random.default_rng(5)
    robot, motion = machine_in_motion(rng, (4, 3), base_joint)
    found, H = ss.singularity(robot, motion), ss.wrench_matrix(robot, motion)
    rates = np.einsum("...ij,...i->...j", H, found.twist)
    np.testing.assert_allclose(rates, found.smallest[..., None] * found.forces, atol=1e-13)
    length = ss.characteristic_length(robot)
    sizes = np.linalg.norm(found.twist * np.repeat([1.0, length], 3), axis=-1)
    np.testing.assert_allclose(sizes, 1.0, rtol=1e-13)
    np.testing.assert_allclose(found.condition, ss.scaled_condition_number(H, length))
    np.testing.assert_allclose(found.determinant * length**3, np.linalg.det(H), rtol=1e-11)
    assert found.twist.shape == (4, 3, 6)
    assert not found.lost.any()
    others = rng.normal(size=(200, 4, 3, 6))
    others /= np.linalg.norm(others * np.repeat([1.0, length], 3), axis=-1, keepdims=True)
    felt = np.linalg.norm(np.einsum("...ij,k...i->k...j", H, others), axis=-1)
    assert (felt >= found.smallest * (1 - 1e-12)).all()


def test_poses_are_taken_one_by_one_and_as_a_pair() -> None:
    robot, motion = machine_in_motion(6, (3,))
    many, pair = ss.singularity(robot, motion), ss.singularity(robot, (motion.R, motion.t))
    for i in range(3):
        one = ss.singularity(robot, motion[i])
        for name in ("condition", "smallest", "determinant", "twist", "wrench", "forces", "pitch", "point"):
            np.testing.assert_array_equal(getattr(pair, name)[i], getattr(many, name)[i])
            np.testing.assert_allclose(getattr(one, name), getattr(many, name)[i], rtol=1e-9, atol=1e-12)


def test_the_screw_has_the_twists_velocities() -> None:
    robot, motion = machine_in_motion(7, (20,))
    found = ss.singularity(robot, motion)
    v, omega = found.twist[:, :3], found.twist[:, 3:]
    on_axis = v + np.cross(omega, found.point - motion.t)
    np.testing.assert_allclose(on_axis, found.pitch[:, None] * omega, atol=1e-12 / machine_size(robot))
    np.testing.assert_allclose(np.cross(found.axis, omega), 0.0, atol=1e-13 / machine_size(robot))
    np.testing.assert_allclose(np.sum((found.point - motion.t) * found.axis, axis=-1), 0.0, atol=1e-12)


def test_a_twist_that_does_not_turn_is_a_translation() -> None:
    pitch, axis, arm = screw(
        np.array([[0.0, 2.0, 0.0, 0.0, 1e-13, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 3.0]]), 0.5
    )
    np.testing.assert_array_equal(pitch, [np.inf, 0.0])
    np.testing.assert_array_equal(axis, [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    np.testing.assert_array_equal(arm, np.zeros((2, 3)))


@pytest.mark.parametrize("height", [0.4, 1.0, 2.5])
@pytest.mark.parametrize("turn", [90.0, -90.0])
def test_similar_hexagons_turned_by_90_degrees_are_singular_at_every_height(
    turn: float, height: float
) -> None:
    robot, R = hexagons(np.radians(turn))
    found = ss.singularity(robot, (R, [0.0, 0.0, height]))
    assert found.lost == 1
    assert np.abs(ss.wrench_matrix(robot, still(R, height)).T @ found.twist).max() <= ROUNDING
    # A screw along the axis of symmetry, as Fichter (1986) found.
    np.testing.assert_allclose(np.abs(found.axis), [0.0, 0.0, 1.0], atol=1e-10)
    np.testing.assert_allclose(found.point[:2], 0.0, atol=1e-10)


def test_the_same_hexagons_turned_otherwise_are_not() -> None:
    for turn in (-60.0, -30.0, 30.0, 60.0, 85.0):
        robot, R = hexagons(np.radians(turn))
        found = ss.singularity(robot, (R, [0.0, 0.0, 1.0]))
        assert found.lost == 0
        assert found.condition < 1e4


@pytest.mark.parametrize("turn", [0.3, 1.0, 2.0])
def test_legs_between_corresponding_corners_of_similar_hexagons_are_singular_everywhere(turn: float) -> None:
    corners = semiregular([-12, 12, 108, 132, 228, 252], 1.0)
    robot = dataclasses.replace(dasgupta(), b=corners, p=0.6 * corners)
    found = ss.singularity(robot, (rotation(np.array([0.1, -0.2, turn])), [0.1, 0.2, 1.0]))
    assert found.lost >= 1


def test_a_flat_machine_has_lost_three_degrees_of_freedom() -> None:
    robot, R = hexagons(0.3)
    found = ss.singularity(robot, (R, np.zeros(3)))
    assert found.lost == 3
    assert found.smallest <= ROUNDING


def still(R: Array, height: float) -> ss.Motion:
    return ss.Motion(R, np.array([0.0, 0.0, height]), np.zeros(3), np.zeros(3))


@pytest.mark.parametrize(
    ("pose", "text"),
    [
        (None, r"pose: expected a Motion or a pose \(R, t\), got NoneType"),
        ((np.eye(3),), r"pose: expected a Motion or a pose \(R, t\), got tuple"),
        ((np.ones((3, 3)), np.zeros(3)), "pose: R: expected a rotation matrix"),
        ((np.eye(3), [0.0, np.nan, 0.0]), "pose: t: expected finite numbers"),
    ],
)
def test_what_is_no_pose_is_named(pose: object, text: str) -> None:
    rejects(rf"\A{text}", ss.singularity, dasgupta(), pose)


def test_a_leg_of_length_zero_has_no_direction() -> None:
    robot = dasgupta()
    rejects(r"^motion: leg 3 has length zero$", ss.singularity, robot, (np.eye(3), robot.b[2] - robot.p[2]))
    rejects(r"^robot: expected a Robot", ss.singularity, None, (np.eye(3), np.zeros(3)))
