"""Models that other people write: other frames, other cuts, degrees, classes, masses of shapes."""

import re
from pathlib import Path

import numpy as np
import pytest
from exported_models import HEXAPOD, exported, imported
from numpy.typing import NDArray

import stewart_sym as ss

TURNS = np.radians([-10.0, 10.0, 110.0, 130.0, 230.0, 250.0])
UPPER_TURNS = np.radians([-50.0, 50.0, 70.0, 170.0, 190.0, -70.0])
HEIGHT, LONG, THICK = 0.8, 0.5, 0.03


def ring(radius: float, turns: NDArray[np.float64], z: float) -> NDArray[np.float64]:
    return np.stack([radius * np.cos(turns), radius * np.sin(turns), np.full(6, z)], axis=-1)


BASE, PLATFORM = ring(0.7, TURNS, 0.1), ring(0.4, UPPER_TURNS, -0.02)


def text(values: NDArray[np.float64]) -> str:
    return " ".join(f"{value:.17g}" for value in np.ravel(values))


def frame(i: int) -> tuple[float, NDArray[np.float64]]:
    """Length of a leg, and axes in columns of its bodies: the third one along it, the first two across."""
    S = np.array([0.0, 0.0, HEIGHT]) + PLATFORM[i] - BASE[i]
    L, y = float(np.linalg.norm(S)), np.cross([0.0, 0.0, 1.0], S)
    z, y = S / L, y / np.linalg.norm(y)
    return L, np.stack([np.cross(y, z), y, z], axis=-1)


def leg(i: int, top: str) -> str:
    """A leg along z of its bodies, which slides against its axis; the parts are cylinders."""
    L, R = frame(i)
    half = f"{L / 2:.17g}"
    end = top.replace("AT", half) or f'<site name="end{i}" pos="0 0 {half}"/>'
    return f"""
    <body name="cylinder{i}" pos="{text(BASE[i])}" xyaxes="{text(R[:, :2].T)}" childclass="leg">
      <frame euler="0 0 90"><geom class="heavy" fromto="0 0 0 0 0 {LONG}"/></frame>
      <joint name="first{i}" axis="{text(R[2])}"/>
      <joint name="second{i}" axis="0 1 0"/>
      <body name="rod{i}" pos="0 0 {half}">
        <joint name="slide{i}" type="slide" axis="0 0 -1" range="-0.2 0.1" damping="7"/>
        <geom class="heavy" fromto="0 0 {half} 0 0 {L / 2 - LONG:.17g}"/>{end}
      </body>
    </body>"""


def model() -> str:
    """The platform hangs on the last leg; five closures are left."""
    sites = "".join(f'<site name="top{i}" pos="{text(PLATFORM[i] - PLATFORM[5])}"/>' for i in range(5))
    top = f"""
        <body name="top" pos="0 0 AT" xyaxes="{text(frame(5)[1][:2])}">
          <joint name="ball" type="ball" damping="0.3"/>
          <inertial mass="30" pos="0 0 0.05" diaginertia="2 1 2.5" euler="0 0 90"/>{sites}
          <body name="load" pos="0 0 0.2"><inertial mass="10" pos="0 0 0" diaginertia="1 1 1"/></body>
        </body>"""
    legs = "".join(leg(i, "") for i in range(5))
    # A body in frames of the base has its own joints; the frames have none.
    legs += f'<frame euler="0 0 90"><frame euler="0 0 -90">{leg(5, top)}</frame></frame>'
    closures = "".join(f'<connect site1="end{i}" site2="top{i}"/>' for i in range(5))
    motors = "".join(f'<motor joint="slide{i}" gear="50" ctrlrange="-10 10"/>' for i in range(6))
    return f"""<mujoco model="foreign"><compiler angle="degree"/>
    <default><default class="leg"><joint damping="0.4"/><default class="heavy">
      <geom type="cylinder" size="{THICK}" density="7850"/></default></default></default>
    <option gravity="0 0 9.81"/>
    <worldbody><body name="floor"><geom size="9 9 9" type="box"/>{legs}</body></worldbody>
    <equality>{closures}</equality><actuator>{motors}</actuator></mujoco>"""


@pytest.fixture
def foreign(tmp_path: Path) -> ss.ImportedModel:
    return imported(model(), tmp_path)


def test_points_axes_and_limits_are_found_whatever_the_frames(foreign: ss.ImportedModel) -> None:
    robot = foreign.robot
    np.testing.assert_allclose(robot.b, BASE, atol=1e-12)
    np.testing.assert_allclose(np.abs(robot.k), np.tile([0.0, 0.0, 1.0], (6, 1)), atol=1e-12)
    # The platform's frame is that of the body, in the point that leg 6 carries.
    np.testing.assert_allclose(robot.p, PLATFORM - PLATFORM[5], atol=1e-12)
    np.testing.assert_allclose(robot.home, [0.0, 0.0, HEIGHT] + PLATFORM[5], atol=1e-12)
    L = np.linalg.norm(robot.home + robot.p - robot.b, axis=-1)
    np.testing.assert_allclose(robot.length_limits, np.stack([L - 0.1, L + 0.2], axis=-1))
    np.testing.assert_array_equal(robot.force_limit, 500.0)
    np.testing.assert_array_equal(robot.g, [0.0, 0.0, 9.81])
    np.testing.assert_array_equal([robot.C_u, robot.C_p], [np.full(6, 0.4), np.full(6, 7.0)])
    np.testing.assert_allclose(robot.C_s, [0.0, 0.0, 0.0, 0.0, 0.0, 0.3])


def test_a_machine_that_is_turned_in_its_file_has_its_home_there(
    foreign: ss.ImportedModel, tmp_path: Path
) -> None:
    turned = model().replace('<body name="floor">', '<body name="floor" euler="0 0 90">')
    found = imported(turned, tmp_path)
    assert "axes those of the base in the pose in the file" in "".join(found.assumptions)
    robot, R = foreign.robot, np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    for name in ("b", "p", "home", "R_0"):
        np.testing.assert_allclose(getattr(found.robot, name), getattr(robot, name) @ R.T, atol=1e-12)
    np.testing.assert_allclose(found.robot.I_p, R @ robot.I_p @ R.T, atol=1e-12)
    F = [
        ss.inverse_dynamics(each, ss.Motion(np.eye(3), each.home, zero := np.zeros(3), zero, zero, zero)).F
        for each in (robot, found.robot)
    ]
    np.testing.assert_allclose(F[1], F[0], rtol=1e-9)


def test_masses_of_shapes_are_those_of_a_robot_file_with_the_same_shapes(foreign: ss.ImportedModel) -> None:
    robot = foreign.robot
    mass = 7850.0 * np.pi * THICK**2 * LONG
    across = mass * (THICK**2 / 4.0 + LONG**2 / 12.0)
    rod = np.diag([mass * THICK**2 / 2.0, across, across])
    for part, side in (("d", 1.0), ("u", -1.0)):
        np.testing.assert_allclose(getattr(robot, f"m_{part}"), mass)
        center = np.tile([side * LONG / 2.0, 0.0, 0.0], (6, 1))
        np.testing.assert_allclose(getattr(robot, f"r_{part}0"), center, atol=1e-12)
        np.testing.assert_allclose(getattr(robot, f"I_{part}0"), np.tile(rod, (6, 1, 1)), atol=1e-10)


def test_what_is_fixed_to_the_platform_is_part_of_it(foreign: ss.ImportedModel) -> None:
    robot = foreign.robot
    assert robot.M == 40.0
    np.testing.assert_allclose(robot.R_0, [0.0, 0.0, 0.0875], atol=1e-12)
    arms = 30.0 * 0.0375**2 + 10.0 * 0.1125**2
    np.testing.assert_allclose(robot.I_p, np.diag([1.0 + 1.0 + arms, 2.0 + 1.0 + arms, 3.5]), atol=1e-12)


def test_a_slide_that_is_stated_from_the_rod_to_the_cylinder_is_the_same(tmp_path: Path) -> None:
    robot, text = ss.Robot.from_toml(HEXAPOD), exported("sdf").text

    def reversed_slide(found: re.Match[str]) -> str:
        start, low, between, high, end = found.groups()
        start = start.replace("<parent>lower_1", "<parent>upper_1").replace(
            "<child>upper_1", "<child>lower_1"
        )
        return f"{start}{-float(high)!r}{between}{-float(low)!r}{end}"

    joint = r'(<joint name="leg_1".*?<lower>)(.*?)(</lower>\s*<upper>)(.*?)(</upper>)'
    changed = re.sub(joint, reversed_slide, text, flags=re.DOTALL)
    assert changed != text
    found = imported(changed, tmp_path).robot
    np.testing.assert_allclose(found.length_limits, robot.length_limits, rtol=1e-12)
    assert found.to_dict()["leg"][1:] == robot.to_dict()["leg"][1:]
