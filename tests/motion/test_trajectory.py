"""Trajectories: blends as (39) and (40), splines, quintics between instants; bad CSV by row and column."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command_line import error_of, rejects
from log_files import NAMES as POSE
from log_files import RATES, write
from machines import Array, rotation
from motion_fields import skew_part

import stewart_sym as ss
from stewart_sym.motion.interpolation import followed, interpolate
from stewart_sym.motion.log_reader import read_csv
from stewart_sym.motion.rotation import (
    rotation_from_rpy,
)
from stewart_sym.motion.trajectory import Trajectory

LOADS = [f"{name}_{axis}" for name in ("F_ext", "M_ext") for axis in "xyz"]


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


@pytest.mark.parametrize("name", list(ss.PAPER_PATHS))
def test_path_starts_and_ends_at_rest_in_the_given_poses(name: str) -> None:
    path, _ = ss.PAPER_PATHS[name]
    ends = path.sample([0.0, path.tau_f])
    np.testing.assert_array_equal(ends.t, [path.t0, path.t1])
    np.testing.assert_array_equal(ends.R, rotation_from_rpy([path.theta0, path.theta1]))
    np.testing.assert_array_equal(ends.v, np.zeros((2, 3)))
    np.testing.assert_array_equal(ends.omega, np.zeros((2, 3)))


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


@pytest.mark.parametrize("name", list(ss.PAPER_PATHS))
def test_grid_of_the_paper_has_61_times(name: str) -> None:
    path, dtau = ss.PAPER_PATHS[name]
    times = path.time_grid(dtau)
    assert len(times) == 61
    np.testing.assert_allclose(times, np.arange(61) * dtau, rtol=1e-15)
    assert times[-1] == path.tau_f


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
        ({"t0": (0.0, 1.0)}, "t0: expected three numbers, got (0.0, 1.0)"),
    ],
)
def test_impossible_path_is_named(changes: dict[str, Any], expected: str) -> None:
    assert error_of(lambda: line(**changes)).startswith(expected)


# CSV


def smooth(n: int, degree: int) -> tuple[Array, Array, Array, Array]:
    """Uneven times and six polynomial coordinates with their derivatives; far from a turn between rows."""
    rng = np.random.default_rng(degree)
    time = (np.arange(n) + rng.uniform(-0.2, 0.2, n)) / n
    polynomials = [np.polynomial.Polynomial(0.3 * rng.normal(size=degree + 1)) for _ in range(6)]
    x, x_dot, x_ddot = (np.column_stack([p.deriv(k)(time) for p in polynomials]) for k in range(3))
    return time + 1e4, x, x_dot, x_ddot


def test_csv_with_derivatives_and_loads_is_taken_as_it_is(tmp_path: Path) -> None:
    rng = np.random.default_rng(3)
    header = POSE + RATES + LOADS
    table = rng.normal(size=(7, len(header)))
    table[:, 0] = np.arange(7) * 0.1
    order = rng.permutation(len(header))
    path = write(tmp_path / "full.csv", [header[i] for i in order], table[:, order])
    time, motion, *_ = read_csv(path)
    t, theta, v, theta_dot, a, theta_ddot, F, M = np.split(table[:, 1:], 8, axis=1)
    expected = ss.Motion.from_rpy(t, theta, v, theta_dot, a, theta_ddot, F, M)
    np.testing.assert_array_equal(time, table[:, 0])
    for name in ("R", "t", "omega", "v", "alpha", "a", "F_ext", "M_ext"):
        np.testing.assert_array_equal(getattr(motion, name), getattr(expected, name))


@pytest.mark.parametrize(("n", "degree"), [(4, 3), (40, 5)])
def test_spline_differentiates_polynomials_of_its_degree(tmp_path: Path, n: int, degree: int) -> None:
    time, x, x_dot, x_ddot = smooth(n, degree)
    path = write(tmp_path / "pose.csv", POSE, np.column_stack([time, x]))
    read_time, motion, *_ = read_csv(path)
    np.testing.assert_array_equal(read_time, time)
    expected = ss.Motion.from_rpy(
        *(y[:, part] for y in (x, x_dot, x_ddot) for part in (slice(0, 3), slice(3, 6)))
    )
    assert motion.F_ext is motion.M_ext is None
    # Times near 1e4 s are known to 1e-12 s, which the second derivative of 40 rows magnifies by 40^2.
    for name in ("R", "t", "omega", "v", "alpha", "a"):
        np.testing.assert_allclose(getattr(motion, name), getattr(expected, name), atol=1e-8)


def test_wrapped_angles_give_smooth_rates(tmp_path: Path) -> None:
    time = np.linspace(0.0, 4.0, 60)
    theta_z = 2.0 * time
    wrapped = (theta_z + np.pi) % (2.0 * np.pi) - np.pi
    zero = np.zeros_like(time)
    path = write(
        tmp_path / "turn.csv", POSE, np.column_stack([time, zero, zero, zero + 1, zero, zero, wrapped])
    )
    motion = read_csv(path).motion
    np.testing.assert_allclose(motion.omega, np.tile([0.0, 0.0, 2.0], (60, 1)), atol=1e-9)
    np.testing.assert_allclose(accelerations(motion)[1], 0.0, atol=1e-7)


def test_forgiving_of_spaces_blank_lines_windows_and_byte_order_mark(tmp_path: Path) -> None:
    time, x, _, _ = smooth(6, 5)
    plain = write(tmp_path / "plain.csv", POSE, np.column_stack([time, x]))
    text = plain.read_text(encoding="utf-8").replace(",", " , ") + "\n  \n"
    odd = tmp_path / "with spaces.csv"
    odd.write_bytes(b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode())
    np.testing.assert_array_equal(read_csv(str(odd))[1].a, read_csv(plain)[1].a)


GOOD = [",".join(POSE), *(f"{0.1 * i:g},0.1,0,0.5,0,0,{0.01 * i:g}" for i in range(6))]
FULL = [",".join(POSE + RATES), *(f"{0.1 * i:g}," + ",".join(["0"] * 18) for i in range(2))]


def with_line(number: int, line: str, lines: list[str] = GOOD) -> str:
    """The text with line ``number`` replaced; line 1 is the header."""
    return "\n".join([*lines[: number - 1], line, *lines[number:]]) + "\n"


BAD: list[tuple[str, str]] = [
    ("", "the file is empty"),
    (GOOD[0], "expected rows of numbers below the header, got none"),
    (with_line(4, "0.2,0.1,0,0.5,0,0"), "line 4: expected 7 columns, got 6"),
    (with_line(5, "0.1,0.1,0,0.5,0,0,0"), "line 5: time: expected increasing times, got 0.1 after 0.2"),
    (with_line(3, "0.1,left,0,0.5,0,0,0"), "line 3: t_x: expected a finite number, got 'left'"),
    (with_line(7, "0.5,0.1,0,0.5,0,0,nan"), "line 7: theta_z: expected a finite number, got 'nan'"),
    (GOOD[1] + "\n" + GOOD[2], "unknown column '0'"),
    (with_line(1, "time,t_x,t_y,t_z,theta_x,theta_y"), "missing column theta_z"),
    (with_line(1, "time,t_x,t_y,t_z,theta_x,theta_y,yaw"), "unknown column 'yaw'"),
    (with_line(1, "time,t_x,t_x,t_z,theta_x,theta_y,theta_z"), "column t_x is given twice"),
    (
        with_line(1, ",".join(POSE + RATES[:6]), FULL),
        "missing column a_x: expected velocities and accelerations",
    ),
    ("\n".join(GOOD[:4]), "expected at least 4 rows to fit a spline, got 3"),
    (with_line(3, '0.1,"' + "9" * 200_000 + '",0,0.5,0,0,0'), "line 3: not valid CSV"),
]


@pytest.mark.filterwarnings("error::RuntimeWarning")
@pytest.mark.parametrize(("text", "expected"), BAD)
def test_bad_csv_is_named(tmp_path: Path, text: str, expected: str) -> None:
    path = tmp_path / "traj.csv"
    path.write_text(text, encoding="utf-8")
    assert error_of(lambda: read_csv(path)).startswith(f"{path}: {expected}")


def test_a_row_that_makes_no_motion_is_named(tmp_path: Path) -> None:
    path = tmp_path / "traj.csv"
    turning = FULL[1].split(",")
    turning[(POSE + RATES).index("theta_dot_y")] = "1e200"
    turning[(POSE + RATES).index("theta_dot_z")] = "1e200"
    path.write_text("\n\n".join([*FULL, ",".join(["0.3", *turning[1:]])]), encoding="utf-8")
    with np.errstate(all="ignore"):
        message = error_of(lambda: read_csv(path))
    assert message.startswith(f"{path}: line 7: alpha: expected finite numbers")


def test_rows_are_counted_as_in_the_file(tmp_path: Path) -> None:
    path = tmp_path / "traj.csv"
    path.write_text("\n" + with_line(4, "\n0.2,0.1"), encoding="utf-8")
    assert error_of(lambda: read_csv(path)) == f"{path}: line 6: expected 7 columns, got 2"


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
