"""Forward kinematics: what is proven is so, what is not is never proven, and nearest poses are found."""

import dataclasses

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
from stewart_sym.kinematics.pose_search import distance, newton
from stewart_sym.motion.rotation import rotation_from_rpy, rotation_from_vector
from stewart_sym.precision.truth import digits
from stewart_sym.studies.robustness.failures import path_III


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


def test_answers_of_forward_kinematics_are_proven_to_rounding() -> None:
    rng = np.random.default_rng(2)
    for _ in range(4):
        robot, motion = machine_in_motion(rng, (2,))
        L = lengths(robot, motion.R, motion.t)
        found = ss.forward_kinematics(robot, L, (motion.R, motion.t))
        proof = ss.certify_pose(robot, L, (found.R, found.t))
        assert proof.proven.all()
        assert proof.position_bound.max() < 1e-12 * np.abs(robot.b).max()


def test_what_is_no_pose_of_the_lengths_is_not_proven() -> None:
    rng = np.random.default_rng(3)
    robot, motion = machine_in_motion(rng, (20,), scale=1.0)
    L = lengths(robot, motion.R, motion.t)
    far = ss.certify_pose(robot, L, (motion.R, motion.t + 0.5 * rng.normal(size=(20, 3))))
    # Where something is proven of a pose so far off, the pose with these lengths is within its bound.
    for i in np.flatnonzero(far.proven):
        assert lengths(robot, motion.R[i], motion.t[i]) == pytest.approx(L[i])
    assert far.proven.mean() < 0.2


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


def test_two_poses_with_the_same_lengths_are_proven_apart() -> None:
    robot = dasgupta()
    home = ss.PAPER_PATHS["I"].path.sample(0.0)
    L = lengths(robot, home.R, home.t)
    starts = rotation_from_vector(np.linspace(-3, 3, 13)[:, None] * np.array([1.0, 0.3, 0.0])) @ home.R
    R, t, _, _, found = newton(robot, np.tile(L, (13, 1)), starts, np.tile(home.t, (13, 1)))
    proof = ss.certify_pose(robot, L, (R[found], t[found]))
    assert proof.proven.all()
    places = t[found]
    gaps = np.linalg.norm(places[:, None] - places, axis=-1)
    apart = gaps > 1e-6
    assert apart.any()
    # Balls in which a pose is alone hold no other pose.
    length = ss.characteristic_length(robot)
    turns = np.linalg.norm(R[found][:, None] - R[found], axis=(-2, -1)) / np.sqrt(2)
    distance = np.sqrt((gaps / length) ** 2 + (2 * np.arcsin(np.minimum(turns / 2, 1.0))) ** 2)
    assert np.all(distance[apart] > np.broadcast_to(proof.uniqueness_radius[:, None], gaps.shape)[apart])


def test_the_middle_between_two_poses_near_a_singular_one_is_not_proven_as_either() -> None:
    robots, motions = path_III()
    near, nearer = motions[20], motions[30]
    L = lengths(robots[0], near.R, near.t)
    proof = ss.certify_pose(robots[0], L, (nearer.R, nearer.t))
    assert not proof.proven or proof.position_bound >= np.linalg.norm(nearer.t - near.t)


def test_an_error_of_the_lengths_shows_in_the_bound() -> None:
    robot, motion = machine_in_motion(5, scale=1.0)
    L = lengths(robot, motion.R, motion.t)
    for error in (1e-12, 1e-9, 1e-6):
        proof = ss.certify_pose(robot, L + error, (motion.R, motion.t))
        assert proof.proven
        assert error / 10 < proof.position_bound < 1e3 * error


def test_no_pose_proves_nothing_and_bad_arguments_are_named() -> None:
    robot = dasgupta()
    L = np.ones((2, 6))
    nothing = ss.certify_pose(robot, L, (np.full((2, 3, 3), np.nan), np.full((2, 3), np.nan)))
    assert not nothing.proven.any()
    assert np.isnan(nothing.position_bound).all()
    rejects(r"^pose: expected a pose", ss.certify_pose, robot, L, np.eye(3))
    rejects(r"^pose: R: expected a rotation", ss.certify_pose, robot, L, (2.0 * np.eye(3), np.zeros(3)))
    rejects(r"^L: expected lengths > 0", ss.certify_pose, robot, -L, (np.eye(3), np.zeros(3)))


def test_scale_does_not_matter_to_a_proof() -> None:
    robot, motion = machine_in_motion(7, scale=1.0)
    for scale in (1e-4, 1e3):
        scaled = dataclasses.replace(robot, b=scale * robot.b, p=scale * robot.p)
        t = scale * motion.t
        proof = ss.certify_pose(scaled, lengths(scaled, motion.R, t), (motion.R, t))
        assert proof.proven
        assert proof.position_bound < 1e-13 * scale


Poses = tuple[Array, Array]


def wide_poses(rng: np.random.Generator, robot: ss.Robot, count: int, width: float) -> tuple[Poses, Array]:
    """Poses of a workspace so wide that it holds singular ones, and their leg lengths."""
    size = machine_size(robot)
    R = rotation_from_rpy(rng.uniform(-width, width, (count, 3)))
    t = home_position(robot.b, size) + 0.5 * size * rng.uniform(-width, width, (count, 3))
    L = ss.inverse_kinematics(robot, ss.Motion(R=R, t=t, omega=np.zeros(3), v=np.zeros(3))).L
    return (R, t), L


def plain(robot: ss.Robot, L: Array, R: Array, t: Array, method: str) -> Poses | None:
    """The pose that a plain least-squares solver finds from a guess; None if it finds none."""
    from scipy.optimize import least_squares

    def miss(x: Array) -> Array:
        tips = robot.p @ (rotation_from_vector(x[3:]) @ R).T + t + x[:3]
        return np.asarray(np.linalg.norm(tips - robot.b, axis=-1) - L)

    found = least_squares(miss, np.zeros(6), method=method, xtol=1e-14, ftol=1e-14, gtol=1e-14)
    if np.abs(found.fun).max() > 1e-9 * machine_size(robot):
        return None
    return rotation_from_vector(found.x[3:]) @ R, t + found.x[:3]


def compare(seeds: range, poses: int) -> tuple[int, int]:
    """How many poses were compared, and from how many guesses the plain solver's lies farther away."""
    count = farther = 0
    for seed in seeds:
        rng = np.random.default_rng(seed)
        robot = dasgupta() if seed % 2 else random_robot(rng)
        (R, t), L = wide_poses(rng, robot, poses, 0.5)
        phi, step = (x / np.linalg.norm(x, axis=-1, keepdims=True) for x in rng.normal(size=(2, poses, 3)))
        guess = rotation_from_vector(np.radians(10.0) * phi) @ R, t + 0.1 * machine_size(robot) * step
        found = ss.forward_kinematics(robot, L, guess)
        for i in range(poses):
            at = guess[0][i], guess[1][i]
            own = float(distance(at, (found.R[i], found.t[i])))
            for method in ("lm", "trf"):
                other = plain(robot, L[i], *at, method)
                if other is not None:
                    its = float(distance(at, other))
                    assert own <= its * (1.0 + 1e-6) + 1e-7 * machine_size(robot), (seed, i, method)
                    count, farther = count + 1, farther + (own < 0.99 * its)
    return count, farther


@sweep
def test_no_pose_is_farther_from_the_guess_than_a_plain_solver_s() -> None:
    """Guesses 10 degrees and a tenth of the base's radius away; by Newton's steps alone some are farther."""
    seeds, poses = range(100, 100 + share(100)), share(100, 7)
    compared, farther = compare(seeds, poses)
    assert compared > 1.7 * len(seeds) * poses
    print(f"{compared} compared; the plain solver's is farther {farther} times")


def missed(seeds: range, poses: int, width: float) -> int:
    count = 0
    for seed in seeds:
        rng = np.random.default_rng(seed)
        robot = dasgupta() if seed % 4 == 0 else random_robot(rng)
        _, L = wide_poses(rng, robot, poses, width)
        found = ss.forward_kinematics(robot, L, on_failure="nan")
        count += np.count_nonzero(found.status == results.NOT_CONVERGED)
    return count


@sweep
@pytest.mark.parametrize("width", [0.8, 1.5, 3.1])
def test_a_pose_is_found_without_a_guess_wherever_there_is_one(width: float) -> None:
    assert missed(range(1000, 1000 + share(100)), share(500), width) == 0


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
