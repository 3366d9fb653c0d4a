"""Between its instants a trajectory is the quintic through its poses, rates and accelerations."""

import numpy as np
import pytest
from log_files import NAMES, write
from machines import rotation
from motion_fields import FIELDS, UNLOADED, skew_part
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.motion.interpolation import between, followed
from stewart_sym.motion.log_reader import read_csv
from stewart_sym.motion.rotation import angular_motion_from_vector, rotation_from_vector, vector_second_rate
from stewart_sym.motion.trajectory import Trajectory

Array = NDArray[np.float64]


def wild(count: int = 7) -> Trajectory:
    """Random rotations of up to a half turn from one instant to the next, loads included."""
    rng = np.random.default_rng(0)
    R = np.array([rotation(vector) for vector in rng.normal(size=(count, 3))])
    time = np.cumsum(rng.uniform(0.3, 1.0, count))
    motion = ss.Motion(R, *rng.normal(size=(5, count, 3)), *rng.normal(size=(2, count, 3)))
    return Trajectory(time, motion, "wild.csv", tuple(range(2, count + 2)))


def test_instants_are_kept() -> None:
    trajectory = wild()
    found = between(trajectory)(trajectory.time)
    for name in FIELDS:
        np.testing.assert_allclose(getattr(found, name), getattr(trajectory.motion, name), atol=1e-12)


def test_rates_and_accelerations_are_those_of_the_poses() -> None:
    path, h = between(wild()), 1e-5
    times = np.linspace(1.0, 3.5, 301)
    before, at, after = path(times - h), path(times), path(times + h)
    np.testing.assert_allclose((after.t - before.t) / (2 * h), at.v, atol=1e-6)
    np.testing.assert_allclose((after.v - before.v) / (2 * h), at.a, atol=1e-5)
    np.testing.assert_allclose((after.omega - before.omega) / (2 * h), at.alpha, atol=1e-5)
    spin = (after.R - before.R) / (2 * h) @ np.swapaxes(at.R, -1, -2)
    np.testing.assert_allclose(skew_part(spin), at.omega, atol=1e-6)


def test_the_papers_path_comes_back_between_its_samples() -> None:
    path = ss.PATHS["III"].path
    time = path.times(0.1)
    found = between(Trajectory(time, path.sample(time), "III", tuple(range(61))))
    inside = np.linspace(3.6, 4.1, 101)
    for name, tolerance in zip(UNLOADED, (1e-14, 1e-14, 1e-13, 1e-13, 1e-11, 1e-11), strict=True):
        expected = getattr(path.sample(inside), name)
        np.testing.assert_allclose(getattr(found(inside), name), expected, atol=tolerance)


def test_positions_are_the_spline_that_gave_the_rates(tmp_path) -> None:
    from scipy.interpolate import make_interp_spline

    rng = np.random.default_rng(1)
    time, t = np.cumsum(rng.uniform(0.1, 0.3, 9)), rng.normal(size=(9, 3))
    log = write(tmp_path / "t.csv", NAMES, np.hstack([time[:, None], t, 0.1 * t]))
    path = between(read_csv(log))
    times = np.linspace(time[0], time[-1], 200)
    spline = make_interp_spline(time - time[0], t, k=5)
    np.testing.assert_allclose(path(times).t, spline(times - time[0]), atol=1e-9)


@pytest.mark.parametrize("angle", [0.0, 1e-9, 1e-3, 0.5, 0.999, 1.001, 3.0, 5.5])
def test_second_rates_of_a_rotation_vector_and_back(angle: float) -> None:
    rng = np.random.default_rng(2)
    direction, rate, second = rng.normal(size=(3, 3))
    phi = angle * direction / np.linalg.norm(direction)
    omega, alpha = angular_motion_from_vector(phi, rate, second)
    np.testing.assert_allclose(vector_second_rate(phi, omega, alpha), second, atol=1e-11)
    h = 1e-5

    def later(time: float) -> Array:
        return rotation_from_vector(phi + time * rate + time**2 / 2 * second)

    spin = (later(h) - later(-h)) / (2 * h) @ later(0.0).T
    np.testing.assert_allclose(skew_part(spin), omega, atol=1e-7)


def test_times_outside_and_single_instants_are_rejected() -> None:
    trajectory = wild(2)
    path = between(trajectory)
    for time in (trajectory.time[0] - 1e-3, trajectory.time[1] + 1e-3, np.nan):
        with pytest.raises(ValueError, match=r"^times: expected times in \["):
            path(np.array([time]))
    motion = trajectory.motion
    still = ss.Motion(motion.R, motion.t, motion.omega, motion.v)
    for time, given, text in (
        (trajectory.time[:1], motion[:1], "at least 2 instants, got 1"),
        (np.array([1.0, 1.0]), motion, "increasing times"),
        (trajectory.time, still, "a motion with accelerations, got none"),
    ):
        odd = Trajectory(time, given, "odd.csv", (2, 3)[: len(time)])
        for function in (between, followed, lambda odd: ss.resampled(odd, 10.0)):
            with pytest.raises(ValueError, match=f"^odd.csv: expected {text}$"):
                function(odd)


def test_one_time_after_the_other_gives_the_same_motion_since_the_first_instant() -> None:
    trajectory = wild()
    path, one = between(trajectory), followed(trajectory)
    for time in np.linspace(*trajectory.time[[0, -1]], 23)[:-1]:
        expected, found = path(time), one(time - trajectory.time[0])
        for name in FIELDS:
            np.testing.assert_allclose(getattr(found, name), getattr(expected, name), rtol=1e-9, atol=1e-9)
    after = one(1e3)
    np.testing.assert_array_equal(after.t, trajectory.motion.t[-1])
    np.testing.assert_array_equal(after.F_ext, trajectory.motion.F_ext[-1])
    assert not after.omega.any()
