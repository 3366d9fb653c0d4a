"""Forward kinematics: from a guess no farther than plain least squares, and without one never for nothing."""

import numpy as np
import pytest
from machines import dasgupta, home_position, machine_size, random_robot
from numpy.typing import NDArray
from sweeps import share, sweep

import stewart_sym as ss
from stewart_sym import results
from stewart_sym.kinematics.pose_search import distance
from stewart_sym.motion.rotation import rotation_from_rpy, rotation_from_vector

Array = NDArray[np.float64]
Poses = tuple[Array, Array]


def wide_poses(rng: np.random.Generator, robot: ss.Robot, count: int, width: float) -> tuple[Poses, Array]:
    """Poses of a workspace so wide that it holds singular ones, and their leg lengths."""
    size = machine_size(robot)
    R = rotation_from_rpy(rng.uniform(-width, width, (count, 3)))
    t = home_position(robot.b, size) + 0.5 * size * rng.uniform(-width, width, (count, 3))
    L = ss.inverse_kinematics(robot, ss.Motion(R, t, np.zeros(3), np.zeros(3))).L
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
            own = float(distance(robot, at, (found.R[i], found.t[i])))
            for method in ("lm", "trf"):
                other = plain(robot, L[i], *at, method)
                if other is not None:
                    its = float(distance(robot, at, other))
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
        r"^L: no pose with these leg lengths was found: none exists, legs 1 and 4 cannot have theirs at once$"
    )
    for guess in (None, (np.eye(3), np.array([0.0, 0.0, 0.5]))):
        with pytest.raises(ValueError, match=proof):
            ss.forward_kinematics(robot, none, guess)
    # No two legs exclude a pose, all six do.
    short = np.array([0.69, 0.76, 0.66, 0.95, 0.67, 0.29])
    open_ = r"^L: no pose with these leg lengths was found from {}, which does not prove that there is none$"
    with pytest.raises(ValueError, match=open_.format("100 starts")):
        ss.forward_kinematics(robot, short)
    with pytest.raises(ValueError, match=open_.format("the guess and about it")):
        ss.forward_kinematics(robot, short, (np.eye(3), np.array([0.0, 0.0, 0.5])))
