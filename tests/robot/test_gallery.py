"""Machines that come with the package: files that people can read, and numbers that their sources give."""

import warnings
from pathlib import Path

import numpy as np
import pytest
from command_line import Run
from numpy.typing import ArrayLike

import stewart_sym as ss
from stewart_sym import robots
from stewart_sym.motion.motion import at_rest
from stewart_sym.motion.rotation import cross, rotation_about_axes

FOLDER = Path(robots.__file__).parent


@pytest.mark.parametrize("name", robots.NAMES)
def test_every_machine_is_a_function_a_file_and_without_a_doubt(name: str, run: Run) -> None:
    with warnings.catch_warnings(action="error"):
        robot = getattr(ss.robots, name)()
    assert robot.name
    assert run("check", FOLDER / f"{name}.toml").err == ""


def virtual_work_forces(robot: ss.Robot, motion: ss.Motion) -> np.ndarray:
    """Tsai's equations: spherical joints at both ends, legs that don't spin, axisymmetric parts.

    tau = -J_p^-T (F_p + sum of J_1^T F_1 + J_2^T F_2), with the wrenches of applied and inertial forces F of
    platform, lower and upper part at their centers of mass, and Jacobians J from the platform's velocity to
    theirs. His leg frame has z along the leg; any vectors do as well.
    """
    E, g = np.eye(3), robot.g
    R, v, omega, a, alpha = motion.R, motion.v, motion.omega, motion.a, motion.alpha
    inertia = R @ robot.I_p @ R.T
    total = np.concatenate([robot.M * (g - a), -inertia @ alpha - cross(omega, inertia @ omega)])
    rows = []
    for i in range(6):
        b = R @ robot.p[i]
        leg = motion.t + b - robot.b[i]
        d = np.linalg.norm(leg)
        s = leg / d
        point = np.hstack([E, cross(E, b).T])
        v_b = v + cross(omega, b)
        a_b = a + cross(alpha, b) + cross(omega, cross(omega, b))
        d_dot, w = s @ v_b, cross(s, v_b) / d
        d_ddot, w_dot = s @ a_b + d * (w @ w), (cross(s, a_b) - 2.0 * d_dot * w) / d
        e_1, e_2 = robot.r_d0[i, 0], -robot.r_u0[i, 0]
        turning = cross(E, s) @ point / d
        across = point - np.outer(s, s) @ point
        lower, upper = e_1 / d * across, np.outer(s, s) @ point + (d - e_2) / d * across
        a_1 = e_1 * (cross(w_dot, s) + cross(w, cross(w, s)))
        a_2 = (d - e_2) * (cross(w_dot, s) + cross(w, cross(w, s)))
        a_2 = a_2 + 2.0 * d_dot * cross(w, s) + d_ddot * s
        for m, I_0, J, acceleration in (
            (robot.m_d[i], robot.I_d0[i], lower, a_1),
            (robot.m_u[i], robot.I_u0[i], upper, a_2),
        ):
            I = I_0[1, 1] * E + (I_0[0, 0] - I_0[1, 1]) * np.outer(s, s)  # noqa: E741
            total = total + J.T @ (m * (g - acceleration))
            total = total + turning.T @ (-I @ w_dot - cross(w, I @ w))
        rows.append(s @ point)
    return -np.linalg.solve(np.array(rows).T, total)


@pytest.mark.parametrize("number", robots.TSAI_MOTIONS)
@pytest.mark.parametrize("backend", ["c", "numpy", "reference"])
def test_tsais_forces_are_those_of_his_virtual_work(number: int, backend: str) -> None:
    robot = ss.robots.tsai2000()
    motions = ss.robots.tsai2000_motion(number, np.linspace(0.0, 2.0, 41))
    found = ss.inverse_dynamics(robot, motions, backend=backend).F
    expected = np.array([virtual_work_forces(robot, motion) for motion in motions])
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=1e-12)


def test_tsais_machine_at_rest_needs_its_published_forces() -> None:
    found = ss.inverse_dynamics(ss.robots.tsai2000(), ss.robots.tsai2000_motion(4, 0.0)).F
    expected = [7.215468, 7.217588, 7.217588, 7.215468, 7.217699, 7.217699]
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=5e-7)


def held(robot: ss.Robot, t: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Leg lengths and forces at rest at a level pose."""
    motion = at_rest(np.eye(3), t)
    return ss.inverse_kinematics(robot, motion).L, ss.inverse_dynamics(robot, motion).F


def test_the_simulink_platform_has_its_lengths_and_masses() -> None:
    robot = ss.robots.mathworks2002()
    L, F = held(robot, robot.home_position)
    np.testing.assert_allclose(L, 3.153801, atol=5e-7)
    np.testing.assert_allclose(robot.r_d0[:, 0], 3.0 / 8.0 * L, rtol=1e-6)
    np.testing.assert_allclose(
        [robot.m_d[0], robot.m_u[0], robot.M], [92.1107, 143.9229, 1216.9268], rtol=1e-6
    )
    np.testing.assert_allclose(F, 5184.2287, rtol=1e-6)


def test_the_unal_hexapod_holds_its_weight_with_equal_forces() -> None:
    L, F = held(ss.robots.unal(), [0.0, 0.0, 0.75])
    np.testing.assert_allclose(L, 0.6664, atol=5e-5)
    np.testing.assert_allclose(F, 5.890, atol=5e-4)


@pytest.mark.parametrize("name", ["rubin_camera", "rubin_m2"])
def test_rubin_hexapods_have_the_strut_lengths_of_their_documentation(name: str) -> None:
    """|x + pivot + R (moving point - pivot) - fixed point| less what it is at x = 0, R = E."""
    robot = getattr(ss.robots, name)()
    rng = np.random.default_rng(8)
    x, theta = 0.01 * rng.uniform(-1, 1, (20, 3)), np.radians(0.3) * rng.uniform(-1, 1, (20, 3))
    R = rotation_about_axes(theta, robot.trajectory_format.rotation_order)
    ends = (x + robot.tool)[:, None] + (robot.p - robot.tool) @ np.swapaxes(R, -1, -2)
    expected = np.linalg.norm(ends - robot.b, axis=-1) - np.linalg.norm(robot.p - robot.b, axis=-1)
    poses = at_rest(R, x + robot.tool).at_point(-robot.tool)
    found = ss.inverse_kinematics(robot, poses).L
    np.testing.assert_allclose(found - robot.length_limits.mean(axis=-1), expected, atol=1e-15)
