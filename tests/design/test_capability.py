"""Capability of a pose: forces that the platform can exert, compared with linear programs."""

import dataclasses

import numpy as np
import pytest
from command_line import error_of
from machines import (
    dasgupta,
    machine_size,
    random_motion,
    random_robot,
)
from scipy.optimize import linprog
from sweeps import share, sweep

import stewart_sym as ss
from stewart_sym.design.capability import WHAT
from stewart_sym.motion.motion import at_rest


def with_limits(rng: np.random.Generator) -> ss.Robot:
    robot = random_robot(rng)
    weight = 9.81 * (robot.M + robot.m_d.sum() + robot.m_u.sum())
    return dataclasses.replace(robot, force_limit=weight * rng.uniform(0.2, 3.0, 6))


def program(robot: ss.Robot, motion: ss.Motion, what: str, others: str, direction: np.ndarray) -> float:
    """Largest factor of the direction by a linear program in forces and the free part; nan if infeasible.

    Forces F and a vector x of six, x = factor * direction in the wanted part: H F = w + G x, where w is
    what the motion itself takes.
    """
    part = WHAT[what][1]
    if what.endswith("acceleration"):
        motion = dataclasses.replace(motion, a=np.zeros(3), alpha=np.zeros(3))
        gained = ss.equations_of_motion(robot, motion, backend="reference").M
    else:
        gained = np.eye(6)
    H = ss.wrench_matrix(robot, motion)
    w = H @ ss.inverse_dynamics(robot, motion, backend="reference").F
    free = [i for i in range(6) if i not in range(6)[part]] if others == "free" else []
    # In units that make the numbers of one size, as a solver wants them.
    scale = robot.force_limit.max()
    rows = 1.0 / np.abs(H).max(axis=-1)
    unit = scale / np.abs(gained).max()
    matrix = np.column_stack([H * scale, -(gained[:, part] @ direction) * unit, -gained[:, free] * unit])
    bounds = [(-limit / scale, limit / scale) for limit in robot.force_limit]
    bounds += [(0.0, None)] + [(None, None)] * len(free)
    cost = np.zeros(matrix.shape[1])
    cost[6] = -1.0
    found = linprog(
        cost,
        A_eq=matrix * rows[:, None] / scale,
        b_eq=w * rows / scale,
        bounds=bounds,
        options={"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10},
    )
    return float(found.x[6] * unit) if found.status == 0 else np.nan


def compared(seed: int, count: int) -> tuple[int, int]:
    """Compare so many poses; how many of them were in and out of reach."""
    rng = np.random.default_rng(seed)
    kinds = [(what, others) for what in WHAT for others in ("zero", "free")]
    within = without = 0
    for number in range(count):
        robot = with_limits(rng)
        motion = random_motion(rng, robot)
        what, others = kinds[number % len(kinds)]
        found = ss.capability_polytope(robot, motion, what, others)
        direction = rng.normal(size=found.normals.shape[-1])
        largest = float(found.max_along(direction))
        expected = program(robot, motion, what, others, direction)
        if np.isnan(expected) or np.isnan(largest):
            assert np.isnan([expected, largest]).all(), (number, what, others, largest, expected)
            without += 1
            continue
        assert largest == pytest.approx(expected, rel=1e-9), (number, what, others)
        within += 1
    return within, without


@pytest.mark.slow
@sweep
def test_it_equals_a_linear_program() -> None:
    count = share(1_000, 10)
    within, without = compared(seed=1, count=count)
    assert within > 0.4 * count
    assert without > 0.05 * count


@pytest.mark.parametrize("others", ["zero", "free"])
def test_corners_are_in_reach_and_nothing_beyond_them_is(others: str) -> None:
    rng = np.random.default_rng(4)
    robot = dataclasses.replace(with_limits(rng), g=np.zeros(3))
    motion = random_motion(rng, robot, load=False)
    still = dataclasses.replace(motion, v=np.zeros(3), omega=np.zeros(3))
    found = ss.capability_polytope(robot, still, "acceleration", others)
    corners = found.vertices()
    assert len(corners) >= 4
    sizes = found.max_along(corners)
    np.testing.assert_allclose(sizes, 1.0, rtol=1e-9)
    least = np.min(found.max_along(found.normals[: len(found.offsets)]))
    assert least == pytest.approx(float(found.inscribed_radius), rel=1e-12)
    # The forces of an acceleration just within the limits are within theirs, just beyond not.
    if others == "zero":
        for share, kept in ((1.0 - 1e-9, True), (1.0 + 1e-9, False)):
            at = dataclasses.replace(still, a=share * corners[0], alpha=np.zeros(3))
            F = ss.inverse_dynamics(robot, at).F
            assert bool(np.all(np.abs(F) <= robot.force_limit)) is kept


def test_capability_refers_to_the_tool_of_the_robot_file() -> None:
    rng = np.random.default_rng(14)
    robot = with_limits(rng)
    robot = dataclasses.replace(robot, tool=machine_size(robot) * np.array([0.3, -0.4, 1.2]))
    motion = random_motion(rng, robot, (40,), load=False)
    direction = np.array([0.6, 0.0, 0.8])
    size = ss.capability_polytope(robot, motion).max_along(direction)
    fast = ss.capability_polytope(robot, motion, "acceleration").max_along(direction)
    assert np.isfinite(size).any()
    assert np.isfinite(fast).any()
    R, r = motion.R, motion.R @ robot.tool
    exerted = -size[:, None] * (direction @ R)
    pushed = dataclasses.replace(motion, F_ext=exerted, M_ext=np.cross(robot.tool, exerted))
    a = fast[:, None] * direction - np.cross(motion.omega, np.cross(motion.omega, r))
    moved = dataclasses.replace(motion, a=a, alpha=np.zeros((40, 3)))
    for taken, each in ((size, pushed), (fast, moved)):
        for i in np.flatnonzero(np.isfinite(taken)):
            used = np.abs(ss.inverse_dynamics(robot, each[i]).F) / robot.force_limit
            assert used.max() == pytest.approx(1.0, rel=1e-9)


def test_a_singular_pose_has_none() -> None:
    robot = dataclasses.replace(dasgupta(), force_limit=np.full(6, 1e4))
    t = np.stack([np.array([0.0, 0.0, 0.6]), robot.b[2] - robot.p[2]])
    found = ss.capability_polytope(robot, at_rest(np.eye(3), t))
    assert np.isfinite(found.inscribed_radius).tolist() == [True, False]
    assert np.isnan(found.max_along([0.0, 0.0, 1.0])).tolist() == [False, True]


def test_what_is_no_question_of_capability_is_one_line() -> None:
    rng = np.random.default_rng(6)
    robot = with_limits(rng)
    motion = random_motion(rng, robot)
    free = dataclasses.replace(robot, force_limit=np.array([1.0, np.inf, 1.0, 1.0, np.inf, 1.0]))
    assert "legs 2, 5 have none" in error_of(lambda: ss.capability_polytope(free, motion))
    assert error_of(lambda: ss.capability_polytope(robot, motion, "torque")).startswith("quantity: expected")
    assert error_of(lambda: ss.capability_polytope(robot, motion, complement="any")).startswith(
        "complement: expected"
    )
    found = ss.capability_polytope(robot, motion)
    assert error_of(lambda: found.max_along([0.0, 0.0, 0.0])).startswith("direction: expected")
    assert error_of(lambda: found.max_along([0.0, np.nan, 0.0])).startswith("direction: expected")
    wrench = ss.capability_polytope(robot, motion, "wrench")
    assert error_of(lambda: wrench.inscribed_radius).startswith("inscribed_radius: expected")
    batch = ss.capability_polytope(robot, random_motion(rng, robot, (2,)))
    assert error_of(lambda: batch.vertices()).startswith("vertices: expected a single pose")
