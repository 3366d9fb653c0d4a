"""Trajectories: blends as (39) and (40), quintics between instants."""

from typing import Any

import numpy as np
import pytest
from command_line import error_of, rejects
from machines import Array, rotation
from motion_fields import skew_part

import stewart_sym as ss
from stewart_sym.motion.interpolation import followed, interpolate
from stewart_sym.motion.trajectory import Trajectory


def accelerations(motion: ss.Motion) -> tuple[Array, Array]:
    return motion.a, motion.alpha


def line(**changes: Any) -> ss.StraightLinePath:
    values: dict[str, Any] = {
        "t0": (0.1, 0.2, 0.3),
        "theta0": (0.0, -0.1, 0.2),
        "t1": (0.4, 0.1, 0.9),
        "theta1": (0.3, 0.1, -0.5),
        "tau_f": 2.0,
        "V": 0.5,
        "Omega": 0.6,
    }
    return ss.StraightLinePath(**(values | changes))


# Straight lines


def test_paper_paths_have_the_paper_blends() -> None:
    path, dtau = ss.PAPER_PATHS["I"]
    assert path.tau_t == pytest.approx(6.0 - np.sqrt(0.08) / 0.08)
    assert path.tau_theta == pytest.approx(1.0)
    assert dtau == 0.1
    slow, fast = ss.PAPER_PATHS["I"].path, ss.PAPER_PATHS["II"].path
    np.testing.assert_allclose(fast.breakpoints(), slow.breakpoints() / 10.0, atol=1e-15)
    np.testing.assert_allclose(
        accelerations(fast.sample(0.05))[0], 100.0 * accelerations(slow.sample(0.5))[0]
    )
    np.testing.assert_allclose(ss.PAPER_PATHS["III"].path.sample(6.0).t, [0.8, 1.8, 1.8])


def test_sample_follows_39_and_40() -> None:
    path = line()
    direction = np.subtract(path.t1, path.t0) / path.distance
    blend = path.tau_f - path.distance / path.V
    assert path.tau_t == pytest.approx(blend)
    start, cruise, end = path.sample([0.3 * blend, 0.5 * path.tau_f, path.tau_f - 0.3 * blend])
    np.testing.assert_allclose(accelerations(start)[0], path.V / blend * direction, rtol=1e-12, atol=1e-15)
    np.testing.assert_allclose(accelerations(end)[0], -path.V / blend * direction, rtol=1e-12, atol=1e-15)
    np.testing.assert_array_equal(accelerations(cruise)[0], np.zeros(3))
    np.testing.assert_allclose(cruise.v, path.V * direction, rtol=1e-12, atol=1e-15)
    np.testing.assert_allclose(cruise.t, 0.5 * np.add(path.t0, path.t1), rtol=1e-12)
    np.testing.assert_allclose(start.v, 0.3 * path.V * direction, rtol=1e-12, atol=1e-15)


@pytest.mark.parametrize("path", [line(), *(p.path for p in ss.PAPER_PATHS.values())])
def test_between_breaks_accelerations_integrate_to_velocities(path: ss.StraightLinePath) -> None:
    nodes, weights = np.polynomial.legendre.leggauss(12)
    times = path.breakpoints()
    half, middle = 0.5 * np.diff(times), 0.5 * (times[1:] + times[:-1])
    inside = path.sample(middle[:, None] + half[:, None] * nodes)
    at = path.sample(times)
    for rate, value in (
        (accelerations(inside)[0], at.v),
        (accelerations(inside)[1], at.omega),
        (inside.v, at.t),
    ):
        integral = np.einsum("i,j,ijk->ik", half, weights, rate)
        np.testing.assert_allclose(integral, np.diff(value, axis=0), atol=1e-13)


@pytest.mark.parametrize(
    ("name", "times", "words"),
    [
        ("time_grid", [0.0, -0.1, 3.0, np.nan, np.inf, 1e-14, "a"], "dtau: expected"),
        ("sample", [-1e-6, 2.000001, [0.0, 3.0], np.nan], "tau: expected times in [0, 2] s, got"),
        ("sample", ["a", 1j, [[0.0, 0.1], [0.2]], None], "tau: expected times, got"),
    ],
)
def test_steps_and_times_outside_of_the_path_and_no_numbers_are_named(
    name: str, times: list[Any], words: str
) -> None:
    for time in times:
        assert error_of(lambda time=time: getattr(line(), name)(time)).startswith(words)


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        (
            {"t1": (0.1, 0.2, 1.3), "V": 0.5},
            "V: 0.5 m/s is too small for tau_f = 2 s, expected more than 0.5 and at most 1 m/s",
        ),
        (
            {"t1": (0.1, 0.2, 1.3), "V": 1.001},
            "V: 1.001 m/s is too large for tau_f = 2 s, expected more than 0.5 and at most 1 m/s",
        ),
        (
            {"Omega": 0.0},
            "Omega: 0 rad/s is too small for tau_f = 2 s, expected more than 0.3937 and at most 0.787401",
        ),
        ({"tau_f": 0.0}, "tau_f: expected a duration > 0 s"),
        ({"axes": -np.eye(3)}, "axes: expected a rotation matrix, this one is a reflection"),
        ({"tau_f": "2"}, "tau_f: expected a finite number, got '2'"),
        ({"t0": (0.0, 1.0)}, "t0: expected shape (3,), got (2,)"),
    ],
)
def test_impossible_path_is_named(changes: dict[str, Any], expected: str) -> None:
    assert error_of(lambda: line(**changes)).startswith(expected)


def wild(count: int = 7) -> Trajectory:
    """Random rotations of up to a half turn from one instant to the next, loads included."""
    rng = np.random.default_rng(0)
    R = np.array([rotation(vector) for vector in rng.normal(size=(count, 3))])
    time = np.cumsum(rng.uniform(0.3, 1.0, count))
    names = ("t", "omega", "v", "alpha", "a", "F_ext", "M_ext")
    motion = ss.Motion(R=R, **dict(zip(names, rng.normal(size=(7, count, 3)), strict=True)))
    return Trajectory(time, motion, "wild.csv", tuple(range(2, count + 2)))


def test_rates_and_accelerations_are_those_of_the_poses() -> None:
    path, h = interpolate(wild()), 1e-5
    times = np.linspace(1.0, 3.5, 301)
    before, at, after = path(times - h), path(times), path(times + h)
    np.testing.assert_allclose((after.t - before.t) / (2 * h), at.v, atol=1e-6)
    np.testing.assert_allclose((after.v - before.v) / (2 * h), at.a, atol=1e-5)
    np.testing.assert_allclose((after.omega - before.omega) / (2 * h), at.alpha, atol=1e-5)
    spin = (after.R - before.R) / (2 * h) @ np.swapaxes(at.R, -1, -2)
    np.testing.assert_allclose(skew_part(spin), at.omega, atol=1e-6)


def test_times_outside_and_single_instants_are_rejected() -> None:
    trajectory = wild(2)
    path = interpolate(trajectory)
    for time in (trajectory.time[0] - 1e-3, trajectory.time[1] + 1e-3, np.nan):
        rejects(r"^times: expected times in \[", path, np.array([time]))
    motion = trajectory.motion
    still = ss.Motion(R=motion.R, t=motion.t, omega=motion.omega, v=motion.v)
    for time, at, text in (
        (trajectory.time[:1], motion[:1], "at least 2 samples, got 1"),
        (np.array([1.0, 1.0]), motion, "increasing times"),
        (trajectory.time, still, "a motion with accelerations, got none"),
    ):
        odd = Trajectory(time, at, "odd.csv", (2, 3)[: len(time)])
        for function in (interpolate, followed, lambda odd: ss.resample(odd, 10.0)):
            rejects(f"^odd.csv: expected {text}$", function, odd)
