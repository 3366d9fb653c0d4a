"""The search of a pose: one text is run as it stands and in C alike."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from kernel_cases import ON_ARRAYS, motion_numbers, robot_numbers
from kinematics_calls import forward, inverse, velocity
from leg_lengths import lengths, nudged
from machines import random_motion, random_robot

import stewart_sym as ss
from stewart_sym.derive.generate import reduced_kinematics
from stewart_sym.derive.kernel.kinematics import PUBLIC, search_program
from stewart_sym.derive.kernel.tree.interpret import Interpreter
from stewart_sym.derive.kernel.tree.nodes import Program
from stewart_sym.results import NOT_CONVERGED, NOT_FINITE, OK, SINGULAR, ZERO_LENGTH

Array = np.ndarray


@pytest.fixture(scope="module")
def tree() -> Program:
    return search_program(reduced_kinematics(), PUBLIC)


def side_by_side(values: Array) -> list[Array]:
    """Components first, poses last."""
    return list(np.moveaxis(np.asarray(values, dtype=float), -1, 0))


def stacked(values: list[Any]) -> Array:
    return np.stack(np.broadcast_arrays(*values), axis=-1)


def run(tree: Program, name: str, *arguments: Any) -> Any:
    with np.errstate(all="ignore"):
        return Interpreter(tree, ON_ARRAYS).run(name, *arguments)


def pose_numbers(R: Array, t: Array) -> SimpleNamespace:
    return SimpleNamespace(R=side_by_side(R.reshape(-1, 9)), t=side_by_side(t))


def searched(tree: Program, robot: ss.Robot, L: Array, R: Array, t: Array) -> Any:
    given = robot_numbers(robot), side_by_side(L), pose_numbers(R, t)
    return run(tree, "forward_kinematics", *given)


def test_poses_side_by_side_are_found_as_the_c_finds_each(tree: Program) -> None:
    rng = np.random.default_rng(31)
    robot = random_robot(rng)
    motion = random_motion(rng, robot, (40,))
    L = lengths(robot, motion.R, motion.t)
    R, t = nudged(rng, motion.R, motion.t, 0.2, 0.1)
    L[1, 2], L[2, 3], t[5, 0] = -1.0, np.nan, np.inf
    L[3] *= np.linspace(0.2, 5.0, 6)
    R[4], R[6] = -R[4], 1.01 * R[6]
    found = searched(tree, robot, L, R, t)
    R_c, t_c, status = forward(robot, L, R, t)
    good = status == OK
    np.testing.assert_array_equal(found.status, status)
    np.testing.assert_array_equal(stacked(found.pose.R)[good], R_c.reshape(-1, 9)[good])
    np.testing.assert_array_equal(stacked(found.pose.t)[good], t_c[good])
    assert np.isnan(stacked(found.pose.R)[~good]).all()
    assert list(status[1:6]) == [ZERO_LENGTH, NOT_FINITE, NOT_CONVERGED, NOT_CONVERGED, NOT_FINITE]
    assert good.sum() > 30


def test_rates_and_velocities_are_those_of_the_c_to_the_bit(tree: Program) -> None:
    rng = np.random.default_rng(32)
    robot = random_robot(rng)
    motion = random_motion(rng, robot, (20,))
    found = run(tree, "inverse_kinematics", robot_numbers(robot), motion_numbers(motion))
    L, L_dot = inverse(robot, motion, "double")
    np.testing.assert_array_equal(stacked(found.L), L)
    np.testing.assert_array_equal(stacked(found.L_dot), L_dot)
    pose = pose_numbers(motion.R, motion.t)
    back = run(tree, "forward_velocity", robot_numbers(robot), pose, side_by_side(L_dot))
    twist, status = velocity(robot, motion.R, motion.t, L_dot)
    np.testing.assert_array_equal(back.status, status)
    np.testing.assert_array_equal(stacked([*back.v, *back.omega]), twist)


def test_a_pose_that_lengths_leave_open_is_singular(tree: Program) -> None:
    robot = random_robot(np.random.default_rng(33))
    flat = replace(robot, b=robot.b * [1.0, 1.0, 0.0], p=0.5 * robot.b * [1.0, 1.0, 0.0])
    R, t = np.broadcast_to(np.eye(3), (4, 3, 3)), np.outer([1.0, 2.0, 3.0, 4.0], [0.0, 0.0, 1.0])
    L = lengths(flat, R, t)
    found = searched(tree, flat, L, R, t)
    np.testing.assert_array_equal(found.status, forward(flat, L, R, t)[2])
    assert set(found.status) == {SINGULAR}
    assert np.isnan(stacked(found.pose.t)).all()
