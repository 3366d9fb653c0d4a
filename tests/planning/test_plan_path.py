"""Paths through via poses: condition numbers, detours, limits, free coordinates, what stands in the way."""

import dataclasses
import functools

import numpy as np
import pytest
from command_line import rejects
from machines import dasgupta, home_position, machine_size, random_robot
from sweeps import FULL
from via_cases import via_case

from stewart_sym.design.pose_limits import PoseLimits
from stewart_sym.kinematics.clearance import leg_distances
from stewart_sym.kinematics.conditioning import characteristic_length, scaled_condition_number
from stewart_sym.kinematics.inverse_kinematics import inverse_kinematics, wrench_matrix
from stewart_sym.motion.rotation import rotation_from_vector, vector_from_rotation
from stewart_sym.motion.straight_line import PAPER_PATHS
from stewart_sym.planning.path_parameterization import parameterize_path
from stewart_sym.planning.plan_path import PlannedPath, plan_path
from stewart_sym.planning.pose_path import Family, ViaPose
from stewart_sym.planning.timing.path_terms import PathLimits
from stewart_sym.singularities.path_singularities import singularity_crossings
from stewart_sym.singularities.singular_poses import singularity

S = np.linspace(0.0, 1.0, 501)
NOTHING = np.zeros(6)


def conditions(robot, motion):
    return scaled_condition_number(wrench_matrix(robot, motion), characteristic_length(robot))


@pytest.mark.slow
@pytest.mark.parametrize("objective", ["mean", "peak"] if FULL else ["mean"])
def test_condition_numbers_are_lower_and_never_above_those_of_the_straight_spline(objective: str) -> None:
    ratios = []
    for seed in range(5):
        robot, poses = via_case(seed)
        found = plan_path(robot, poses, objective=objective)
        at_first = found.initial_condition_numbers
        assert conditions(robot, found.path(S)).max() <= at_first.peak * (1.0 + 1e-9)
        ratios.append(
            [found.condition_numbers.mean / at_first.mean, found.condition_numbers.peak / at_first.peak]
        )
    assert np.max(ratios) <= 1.0
    assert np.median(ratios, axis=0)[0] < 0.99


@functools.cache
def planned() -> PlannedPath:
    return plan_path(*via_case(7))


def test_parameters_and_times_off_a_path_are_named() -> None:
    robot, _ = via_case(7)
    path = planned().path
    for s in ([-0.01], [1.1], [np.nan], 0.5, [[0.5]]):
        rejects(r"^s: expected parameters in \[0, 1\], \(n,\), got", path, s)
    for span in ((1.0, 0.0), (0.5, 0.5), (0.0, 2.0)):
        rejects(
            r"^span: expected a first s less|^s: expected parameters in", parameterize_path, robot, path, span
        )
    timed = parameterize_path(robot, path, limits=PathLimits(acceleration=1.0), grid_size=10)
    times = timed.duration * np.array([[0.1, 0.4], [0.6, 1.0]])
    np.testing.assert_allclose(timed.sample(times).t[1, 0], timed.sample(times[1, 0]).t, rtol=1e-12)


def crossed_pairs(count: int):
    """Machines with two poses, the straight path between which crosses singular poses and comes back."""
    found = []
    for seed in range(1000):
        rng = np.random.default_rng(seed)
        robot = random_robot(rng)
        size = machine_size(robot)
        t = home_position(robot.b, size) + 0.4 * size * rng.normal(size=(2, 3))
        poses = tuple(
            ViaPose(*pose) for pose in zip(rotation_from_vector(rng.normal(size=(2, 3))), t, strict=True)
        )
        found_at = singularity(robot, (np.array([pose.R for pose in poses]), t))
        same_side = np.ptp(np.sign(found_at.determinant)) == 0.0
        if same_side and found_at.condition_number.max() < 40.0:
            family = Family.of(poses, found_at.characteristic_length)
            line = family.path(
                family.coefficients(np.zeros(0), np.zeros((family.rest.shape[1], 7))), np.zeros(3), NOTHING
            )
            if singularity_crossings(robot, line, S[::5]):
                found.append((robot, poses))
        if len(found) == count:
            return found
    raise AssertionError("too few")


@pytest.mark.slow
def test_detours_around_singular_poses_are_found() -> None:
    for robot, poses in crossed_pairs(2):
        assert singularity_crossings(robot, plan_path(robot, poses).path, S) == ()


def ends_of_path_III():
    motion = PAPER_PATHS["III"].path.sample(np.array([0.0, 6.0]))
    return tuple(ViaPose(R, t) for R, t in zip(motion.R, motion.t, strict=True))


def test_no_path_joins_the_ends_of_path_III() -> None:
    """det H is continuous and has other signs at the ends, a long way from its rounding."""
    robot = dasgupta()
    first, last = ends_of_path_III()
    motion = PAPER_PATHS["III"].path.sample(np.array([0.0, 6.0]))
    H = wrench_matrix(robot, motion)
    determinants = np.linalg.det(H)
    bound = 1e-12 * np.prod(np.linalg.norm(H, axis=-2), axis=-1)
    assert determinants[0] < -bound[0]
    assert determinants[1] > bound[1]
    with pytest.raises(ValueError, match="via pose 2: every path from via pose 1 crosses a singular pose"):
        plan_path(robot, (first, last))


def test_path_III_is_planned_anew_where_its_end_may_be_yawed() -> None:
    robot = dasgupta()
    first, last = ends_of_path_III()
    free = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.3])
    found = plan_path(robot, (first, ViaPose(last.R, last.t, -free, free)))
    assert singularity_crossings(robot, found.path, S) == ()
    np.testing.assert_allclose(found.reached_poses[1].t, last.t)
    turn = vector_from_rotation(last.R.T @ found.reached_poses[1].R)
    assert np.abs(turn[:2]).max() < 1e-12
    assert abs(turn[2]) <= 0.3 + 1e-12


@pytest.mark.slow
def test_limits_of_lengths_clearance_and_condition_are_kept() -> None:
    robot, poses = via_case(11, 3)
    free = plan_path(robot, poses, smoothness_weight=0.0)
    motion = free.path(S)
    L = inverse_kinematics(robot, motion).L
    via = free.path(free.path.via)
    at_via = inverse_kinematics(robot, via).L
    size = characteristic_length(robot)
    tight = np.stack(
        [
            np.minimum(at_via.min(axis=0), L.min(axis=0) + 0.02 * size) - 0.005 * size,
            at_via.max(axis=0) + 0.005 * size,
        ],
        axis=-1,
    )
    limited = dataclasses.replace(robot, length_limits=tight)
    assert (L > tight[:, 1]).any()
    clearance = 0.9 * float(leg_distances(robot, via).min())
    highest = 1.02 * float(conditions(robot, via).max())
    found = plan_path(
        limited, poses, PoseLimits(max_condition=highest, min_clearance=clearance), smoothness_weight=0.0
    )
    motion = found.path(S)
    L = inverse_kinematics(robot, motion).L
    assert (L >= tight[:, 0]).all()
    assert (L <= tight[:, 1]).all()
    assert leg_distances(robot, motion).min() >= clearance
    assert conditions(robot, motion).max() <= highest


@pytest.mark.slow
def test_a_limit_that_stands_in_the_way_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ends with singular poses between them, and no higher condition number allowed than theirs."""
    monkeypatch.setattr("stewart_sym.planning.plan_path._STARTS", 2)
    robot, poses = crossed_pairs(1)[0]
    R, t = np.array([pose.R for pose in poses]), np.array([pose.t for pose in poses])
    highest = 1.01 * float(singularity(robot, (R, t)).condition_number.max())
    with pytest.raises(ValueError, match=r"^via pose 2: .* pose 1 was found \(obstacle: condition number\)"):
        plan_path(robot, poses, PoseLimits(max_condition=highest))
