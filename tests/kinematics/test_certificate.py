"""Forward kinematics: what is proven is so, what is not is never proven, and nearest poses are found."""

import mpmath
import numpy as np
import pytest
from command_line import rejects
from leg_lengths import lengths
from machines import (
    Array,
    dasgupta,
    home_position,
    machine_in_motion,
    machine_size,
    random_motion,
    random_robot,
)
from sweep_machines import exact
from sweeps import share, sweep

import stewart_sym as ss
from stewart_sym import results
from stewart_sym.kinematics.pose_search import newton
from stewart_sym.motion.rotation import rotation_from_rpy, rotation_from_vector
from stewart_sym.precision.exact_forces import digits


def turn_between(exact: mpmath.matrix, R: Array) -> float:
    """Angle, rad, by the chord."""
    off = [exact[i, j] - float(R[i, j]) for i in range(3) for j in range(3)]
    return float(mpmath.sqrt(sum(x * x for x in off) / 2))


@pytest.mark.parametrize("off", [0.0, 1e-9, 1e-4])
def test_the_exact_pose_lies_within_what_is_proven(off: float) -> None:
    rng = np.random.default_rng(1)
    robot, motion = machine_in_motion(rng, (3,))
    L = lengths(robot, motion.R, motion.t)
    R = rotation_from_vector(off * rng.normal(size=(3, 3))) @ motion.R
    t = motion.t + off * rng.normal(size=(3, 3))
    proof = ss.certify_pose(robot, L, (R, t))
    assert proof.proven.all()
    for i in range(3):
        turn, place = exact_pose(robot, L[i], R[i], t[i])
        distance = mpmath.sqrt(sum((place[j] - float(t[i, j])) ** 2 for j in range(3)))
        assert float(distance) <= proof.position_bound[i]
        assert turn_between(turn, R[i]) <= proof.angle_bound[i] + 1e-15
        assert proof.position_bound[i] < 100 * (off + 1e-14)


def test_lengths_that_no_pose_has_prove_nothing() -> None:
    robot = random_robot(np.random.default_rng(4), scale=1.0)
    motion = random_motion(np.random.default_rng(4), robot)
    L = lengths(robot, motion.R, motion.t)
    impossible = L.copy()
    # One leg longer than its end can reach while the others stay.
    impossible[0] += 10.0
    R, t, *_ = newton(robot, impossible[None], motion.R[None], motion.t[None])
    assert not ss.certify_pose(robot, impossible, (R[0], t[0])).proven
    assert not ss.certify_pose(robot, impossible, (motion.R, motion.t)).proven


def test_no_pose_proves_nothing_and_bad_arguments_are_named() -> None:
    robot = dasgupta()
    L = np.ones((2, 6))
    nothing = ss.certify_pose(robot, L, (np.full((2, 3, 3), np.nan), np.full((2, 3), np.nan)))
    assert not nothing.proven.any()
    assert np.isnan(nothing.position_bound).all()
    rejects(r"^pose: expected a pose", ss.certify_pose, robot, L, np.eye(3))
    rejects(r"^pose: R: expected a rotation", ss.certify_pose, robot, L, (2.0 * np.eye(3), np.zeros(3)))
    rejects(r"^L: expected lengths > 0", ss.certify_pose, robot, -L, (np.eye(3), np.zeros(3)))


Poses = tuple[Array, Array]


def wide_poses(rng: np.random.Generator, robot: ss.Robot, count: int, width: float) -> tuple[Poses, Array]:
    """Poses of a workspace so wide that it holds singular ones, and their leg lengths."""
    size = machine_size(robot)
    R = rotation_from_rpy(rng.uniform(-width, width, (count, 3)))
    t = home_position(robot.b, size) + 0.5 * size * rng.uniform(-width, width, (count, 3))
    L = ss.inverse_kinematics(robot, ss.Motion(R=R, t=t, omega=np.zeros(3), v=np.zeros(3))).L
    return (R, t), L


def missed(seeds: range, poses: int, width: float) -> int:
    count = 0
    for seed in seeds:
        rng = np.random.default_rng(seed)
        robot = dasgupta() if seed % 4 == 0 else random_robot(rng)
        _, L = wide_poses(rng, robot, poses, width)
        found = ss.forward_kinematics(robot, L, on_failure="nan")
        count += np.count_nonzero(found.status == results.NOT_CONVERGED)
    return count


@pytest.mark.slow
@sweep
@pytest.mark.parametrize("width", [0.8, 3.1])
def test_a_pose_is_found_without_a_guess_wherever_there_is_one(width: float) -> None:
    assert missed(range(1000, 1000 + share(100, 50)), share(500, 50), width) == 0


@pytest.mark.slow
def test_what_was_tried_or_why_there_is_no_pose_is_said() -> None:
    robot = dasgupta()
    _, L = wide_poses(np.random.default_rng(0), robot, 1, 0.1)
    none = L[0].copy()
    none[3] += 3.0
    proof = (
        r"^L: no pose with these leg lengths was found: "
        r"none exists, legs 1 and 4 cannot have these lengths together$"
    )
    for guess in (None, (np.eye(3), np.array([0.0, 0.0, 0.5]))):
        rejects(proof, ss.forward_kinematics, robot, none, guess)
    # No two legs exclude a pose, all six do.
    short = np.array([0.69, 0.76, 0.66, 0.95, 0.67, 0.29])
    open_ = r"^L: no pose with these leg lengths was found from {}, which does not prove that no pose exists$"
    rejects(open_.format("100 starts"), ss.forward_kinematics, robot, short)
    with pytest.raises(ValueError, match=open_.format("the guess and about it")):
        ss.forward_kinematics(robot, short, (np.eye(3), np.array([0.0, 0.0, 0.5])))


def exact_pose(robot: ss.Robot, L: Array, R: Array, t: Array) -> tuple[Array, Array]:
    """The pose with exactly these lengths near a found one, in 50-digit arithmetic."""
    turn, place, p, b, lengths = map(exact, (R, t, robot.p, robot.b, L))
    unit = exact(np.eye(3))
    for _ in range(4):
        turn = turn @ (3 * unit - turn.T @ turn) / 2
    for _ in range(60):
        q = p @ turn.T
        S = q + place - b
        J, miss = np.hstack([S, np.cross(q, S)]), (lengths**2 - (S * S).sum(axis=-1)) / 2
        step = np.array(list(digits.lu_solve(digits.matrix(J.tolist()), digits.matrix(miss.tolist()))))
        place = place + step[:3]
        turn = np.array(digits.expm(digits.matrix(np.cross(step[3:], unit).T.tolist())).tolist()) @ turn
        if np.abs(step).max() < digits.mpf(10) ** -35:
            break
    return turn, place
