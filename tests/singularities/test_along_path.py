"""Crossings are located between samples, none is missed, and the residue is what the forces do there."""

import dataclasses
from collections.abc import Callable

import numpy as np
import pytest
from command_line import rejects
from machines import Array, dasgupta, random_path, random_robot
from mpmath import mp
from numpy.typing import ArrayLike
from unsolvable_poses import hexagons

import stewart_sym as ss
from stewart_sym.motion.trajectory import Trajectory
from stewart_sym.singularities.path_warnings import crossing_warning

Path = Callable[[Array], ss.Motion]
E = np.eye(3)
III = ss.PAPER_PATHS["III"].path


@pytest.fixture(scope="module")
def root() -> float:
    """Where Path III makes det H vanish, s, at 50 digits: (1)-(3), (36), (38)-(40) written out once more."""
    with mp.workdps(50):
        robot = dasgupta()
        low, high = mp.mpf("3.6"), mp.mpf("3.7")
        for _ in range(170):
            middle = (low + high) / 2
            low, high = (low, middle) if determinant(robot, middle) > 0 else (middle, high)
        return float(low)


def determinant(robot: ss.Robot, time: mp.mpf) -> mp.mpf:
    """det H on Path III, where the position goes at constant speed and the angles may slow down."""
    t = along(III.t0, III.t1, III.V, time)
    theta = along(III.theta0, III.theta1, III.Omega, time)
    (sx, sy, sz), (cx, cy, cz) = [[f(a) for a in theta] for f in (mp.sin, mp.cos)]
    turns = [
        [[1, 0, 0], [0, cx, -sx], [0, sx, cx]],
        [[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]],
        [[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]],
    ]
    R = mp.matrix(turns[2]) * mp.matrix(turns[1]) * mp.matrix(turns[0])
    H = mp.matrix(6, 6)
    for leg in range(6):
        q = R * mp.matrix(robot.p[leg].tolist())
        S = [t[i] + q[i] - mp.mpf(float(robot.b[leg, i])) for i in range(3)]
        s = [x / mp.sqrt(sum(y * y for y in S)) for x in S]
        moment = [q[1] * s[2] - q[2] * s[1], q[2] * s[0] - q[0] * s[2], q[0] * s[1] - q[1] * s[0]]
        for i in range(3):
            H[i, leg], H[3 + i, leg] = s[i], moment[i]
    return mp.det(H)


def along(start: tuple[float, ...], end: tuple[float, ...], speed: float, time: mp.mpf) -> list[mp.mpf]:
    first, last = [mp.mpf(x) for x in start], [mp.mpf(x) for x in end]
    distance = mp.sqrt(sum((b - a) ** 2 for a, b in zip(first, last, strict=True)))
    tau_f, V = mp.mpf(III.tau_f), mp.mpf(speed)
    blend = tau_f - distance / V
    assert time > blend
    gone = V * (time - blend / 2)
    if time > tau_f - blend:
        gone = distance - V / blend * (tau_f - time) ** 2 / 2
    return [a + (b - a) * gone / distance for a, b in zip(first, last, strict=True)]


def reshaped(share: Callable[[Array], Array], rate: Callable[[Array], Array], second: float) -> Path:
    """Path III run through at another pace: share gives its time, s, at each time."""

    def path(times: Array) -> ss.Motion:
        motion, pace = III.sample(share(times)), rate(times)[:, None]
        rates = (motion.omega * pace, motion.v * pace)
        seconds = (motion.alpha * pace**2 + motion.omega * second, motion.a * pace**2 + motion.v * second)
        return ss.Motion(R=motion.R, t=motion.t, omega=rates[0], v=rates[1], alpha=seconds[0], a=seconds[1])

    return path


def along_line(start: ArrayLike, v: ArrayLike, R: ArrayLike = E) -> Path:
    """A translation at constant speed."""
    zero = np.zeros(3)
    return lambda times: ss.Motion(
        R=R, t=start + np.multiply.outer(times, v), omega=zero, v=v, alpha=zero, a=zero
    )


def there_and_back(root: float, depth: float) -> Path:
    """Crosses at -+sqrt(depth) s for depth > 0, turns back before the singular pose for depth < 0."""
    return reshaped(lambda times: root + 0.3 * (times**2 - depth), lambda times: 0.6 * times, 0.6)


def test_the_crossing_of_path_iii_is_located_to_a_nanosecond(root: float) -> None:
    for times in (III.breakpoints(), III.time_grid(0.1), [0.0, 6.0], [3.6, 3.7], np.linspace(0.0, 6.0, 601)):
        (found,) = ss.singularity_crossings(dasgupta(), III.sample, times)
        assert abs(found.time - root) <= min(1e-9, 10 * found.time_error)
        assert found.time_error < 1e-11
        assert (found.sign_before, found.sign_after) == (-1, 1)
        assert found.singularity.lost_dof == 1


@pytest.mark.parametrize("formulation", ["exact", "paper"])
def test_forces_go_to_one_infinity_before_and_to_the_other_after(root: float, formulation: str) -> None:
    robot = dasgupta()
    (found,) = ss.singularity_crossings(robot, III.sample, III.breakpoints())
    A = ss.singular_force_residue(robot, III.sample(found.time), formulation)
    for distance in (1e-3, 1e-5, 1e-7):
        times = root + np.array([-distance, distance])
        before, after = ss.inverse_dynamics(robot, III.sample(times), formulation).F
        assert (np.sign(before) == -np.sign(A)).all()
        assert (np.sign(after) == np.sign(A)).all()
        np.testing.assert_allclose(before, -A / distance, rtol=10 * distance + 1e-4)
        np.testing.assert_allclose(after, A / distance, rtol=10 * distance + 1e-4)
    leg = int(np.argmax(np.abs(before)))
    assert before[leg] * after[leg] < 0.0
    assert abs(before[leg]) > 1e11


@pytest.mark.parametrize("half", [0.5, 1e-4])
def test_two_crossings_between_two_samples_are_both_found(root: float, half: float) -> None:
    path = there_and_back(root, half**2)
    found = ss.singularity_crossings(dasgupta(), path, [-0.9, 1.1])
    np.testing.assert_allclose([item.time for item in found], [-half, half], atol=1e-12 / half + 1e-12)
    assert [(item.sign_before, item.sign_after) for item in found] == [(1, -1), (-1, 1)]


def test_a_sample_on_the_singular_pose_is_one_crossing(root: float) -> None:
    for times in ([3.0, root, 4.0], [3.0, np.nextafter(root, 4.0), 4.0]):
        (found,) = ss.singularity_crossings(dasgupta(), III.sample, times)
        assert abs(found.time - root) <= 1e-11


@pytest.mark.parametrize("depth", [0.1, 1e-6])
def test_a_path_that_only_comes_near_reports_its_nearest_approach(root: float, depth: float) -> None:
    robot, path = dasgupta(), there_and_back(root, -depth)
    for times in ([-0.9, 1.1], np.linspace(-0.9, 1.1, 12), np.linspace(-0.9, 1.1, 201)):
        found = ss.path_singularities(robot, path, times)
        assert found.crossings == ()
        (approach,) = found.approaches
        assert approach is found.nearest
        assert abs(approach.time) < 1e-6
        least = float(ss.singularity(robot, path(np.zeros(1))[0]).smallest_singular_value)
        assert float(approach.singularity.smallest_singular_value) == pytest.approx(least, rel=1e-6)
        assert float(approach.singularity.determinant) > 0.0


@pytest.mark.parametrize("count", [3, 200])
def test_a_log_of_poses_at_rest_is_warned_of_the_crossing_between_its_rows(count: int) -> None:
    path, _ = ss.PAPER_PATHS["III"]
    time = np.linspace(0.0, path.tau_f, count)
    poses, none = path.sample(time), np.zeros(3)
    rest = ss.Motion(R=poses.R, t=poses.t, omega=none, v=none, alpha=none, a=none)
    log = Trajectory(time, rest, "poses.csv", tuple(range(count)))
    assert "crosses a singular pose" in (crossing_warning(dasgupta(), log) or "")


@pytest.mark.parametrize("inside", [(), (1.5,)])
def test_a_rest_in_a_singular_pose_is_found_by_both_functions(root: float, inside: tuple[float, ...]) -> None:
    robot, time = dasgupta(), np.array([0.0, 1.0, *inside, 2.0, 3.0])

    def path(times: Array) -> ss.Motion:
        """Path III up to its singular pose, a rest of a second, and the remaining path."""
        shares = np.stack([np.clip(times, 0.0, 1.0), np.clip(times - 2.0, 0.0, 1.0)])
        moved, rate, second = (
            0.2 * factor.sum(axis=0)
            for factor in (
                shares**3 * (10.0 - 15.0 * shares + 6.0 * shares**2),
                30.0 * (shares * (1.0 - shares)) ** 2,
                60.0 * shares * (1.0 - shares) * (1.0 - 2.0 * shares),
            )
        )
        at = III.sample(root - 0.2 + moved)
        on = rate[:, None]
        return ss.Motion(
            R=at.R,
            t=at.t,
            omega=at.omega * on,
            v=at.v * on,
            alpha=at.alpha * on**2 + at.omega * second[:, None],
            a=at.a * on**2 + at.v * second[:, None],
        )

    found = ss.path_singularities(robot, path, time)
    assert [each.time for each in ss.singularity_crossings(robot, path, time)] == [
        each.time for each in found.crossings
    ]
    assert found.crossings or found.spans
    assert float(found.nearest.singularity.smallest_singular_value) < 1e-12


def test_minima_of_random_paths_are_those_of_dense_samples() -> None:
    for seed in range(3):
        rng = np.random.default_rng(seed)
        robot = random_robot(rng)
        path, period = random_path(rng, robot), 1.0
        times = np.linspace(0.0, period, 4001)
        dense = ss.singularity(robot, path(times)).smallest_singular_value
        inner = np.flatnonzero((dense[1:-1] < dense[:-2]) & (dense[1:-1] < dense[2:])) + 1
        for given in ([0.0, period], np.linspace(0.0, period, 9), np.linspace(0.0, period, 101)):
            found = ss.path_singularities(robot, path, given)
            np.testing.assert_allclose(
                [approach.time for approach in found.approaches], times[inner], atol=period / 4000
            )


def test_a_path_along_singular_poses_is_a_span_and_no_crossing() -> None:
    robot, R = hexagons(np.pi / 2)
    path = along_line([0.0, 0.0, 1.0], [0.0, 0.0, 0.1], R)
    found = ss.path_singularities(robot, path, [0.0, 1.0, 2.0])
    assert found.crossings == ()
    assert found.approaches == ()
    assert found.spans == ((0.0, 2.0),)
    assert found.nearest.singularity.lost_dof == 1


def test_a_leg_that_passes_through_length_zero_is_no_crossing() -> None:
    """Its direction turns round, and with it the sign of det H, but no freedom is lost there."""
    robot = dasgupta()
    path = along_line(robot.b[2] - robot.p[2], [0.3, 0.1, 0.7])
    for times in ([-0.5, 0.3], [-0.5, 0.0, 0.3]):
        found = ss.path_singularities(robot, path, times)
        assert found.crossings == ()
        assert abs(found.min_length.time[2]) < 1e-7
        assert found.min_length.value[2] < 1e-7


def test_leg_extremes_are_those_of_dense_samples() -> None:
    rng = np.random.default_rng(3)
    robot = random_robot(rng)
    path = random_path(rng, robot)
    found = ss.path_singularities(robot, path, np.linspace(0.0, 1.0, 7))
    legs = ss.inverse_kinematics(robot, path(np.linspace(0.0, 1.0, 20001)))
    sine = np.linalg.norm(np.cross(robot.k, legs.s), axis=-1)
    for extreme, expected in (
        (found.min_length, legs.L.min(axis=0)),
        (found.max_length, legs.L.max(axis=0)),
        (found.min_joint_sine, sine.min(axis=0)),
    ):
        np.testing.assert_allclose(extreme.value, expected, rtol=1e-6)
    at = [ss.inverse_kinematics(robot, path(found.min_length.time[[leg]])).L[0, leg] for leg in range(6)]
    np.testing.assert_allclose(found.min_length.value, at, rtol=1e-15)
    assert (
        ss.path_singularities(random_robot(rng, "spherical"), path, [0.0, 0.1]).min_joint_sine.value == 1.0
    ).all()


def test_a_leg_through_its_joint_singularity_is_found_between_samples() -> None:
    robot, v, start = dasgupta(), np.array([0.05, 0.02, 0.1]), np.array([0.1, 0.0, 0.5])
    axes = robot.k.copy()
    axes[4] = robot.p[4] + start + 0.123 * v - robot.b[4]
    robot = dataclasses.replace(robot, k=axes)
    sine = ss.path_singularities(robot, along_line(start, v), [0.0, 1.0]).min_joint_sine
    assert sine.time[4] == pytest.approx(0.123, abs=1e-6)
    assert sine.value[4] < 1e-6


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ((None, III.sample, [0, 1]), "robot: expected a Robot, got NoneType"),
        ((dasgupta(), III, [0, 1]), "path: expected a function of times, got StraightLinePath"),
        ((dasgupta(), III.sample, [0]), "time: expected at least two finite times, increasing"),
        ((dasgupta(), III.sample, [1, 1]), "time: expected at least two finite times, increasing"),
        ((dasgupta(), III.sample, [0, np.nan]), "time: expected at least two finite times, increasing"),
        ((dasgupta(), III.sample, "a"), "time: expected increasing times"),
        ((dasgupta(), lambda times: times, [0, 1]), "path: expected a Motion, got ndarray"),
        ((dasgupta(), lambda times: III.sample(1.0), [0, 1]), r"path: expected a motion of shape \(n,\)"),
    ],
)
def test_bad_arguments_are_one_line(arguments: tuple[object, ...], text: str) -> None:
    for function in (ss.singularity_crossings, ss.path_singularities):
        rejects(rf"\A{text}.*\Z", function, *arguments)
