"""Drives and offset joints in robot files: their tables, what follows from them, and mistakes in them."""

import copy
import dataclasses
import json
import math
import pickle
import re
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command_line import rejects
from machines import offset_case
from pages import DOCS
from public_calls import calls
from robot_files import PRESS, written

import stewart_sym as ss
from stewart_sym.motion.rotation import rotation_from_rpy

SHARED = """\
[legs.drive]
lead = 5
gear_ratio = 2.0
rotor_inertia = 4e-5
efficiency = 0.9
screw_coulomb = 30.0
screw_viscous = 200.0
motor_coulomb = 0.02
motor_viscous = 1e-4
stribeck_force = 10.0
stribeck_speed = 3
regularization_speed = 0.1
torque_constant = 0.6
resistance = 2.5
rated_torque = 1.3
torque_limit = 3.8
speed_limit = 18000
current_limit = 7.0
power_limit = 400.0

"""
OWN = """\
[leg.3.drive]
radius = 12
screw_coulomb = 45.0

[leg.5]
drive.lead = -5
drive.backdrive_efficiency = -0.1
"""


def read(text: str, folder: Path) -> ss.Robot:
    path = folder / "robot.toml"
    path.write_text(PRESS + text, encoding="utf-8")
    return ss.Robot.from_toml(path)


def drive(text: str, folder: Path) -> ss.Drive:
    found = read(text, folder).drive
    return found


def test_numbers_of_a_file_are_in_si_units_and_a_leg_may_have_its_own(tmp_path: Path) -> None:
    found = drive(SHARED + OWN, tmp_path)
    ordinary = [0, 1, 3, 5]
    np.testing.assert_allclose(found.lead[ordinary], 5e-3, rtol=1e-15)
    assert found.lead[2] == pytest.approx(2 * math.pi * 12e-3)
    assert found.lead[4] == -5e-3
    np.testing.assert_array_equal(found.gear_ratio, 2.0)
    np.testing.assert_array_equal(found.screw_coulomb, [30, 30, 45, 30, 30, 30])
    np.testing.assert_allclose(found.backdrive_efficiency, [2 - 1 / 0.9] * 4 + [-0.1] + [2 - 1 / 0.9])
    np.testing.assert_allclose(found.speed_limit, 100 * math.pi)
    np.testing.assert_allclose(found.stribeck_speed, 3e-3)
    np.testing.assert_allclose(found.regularization_speed, 1e-4)
    np.testing.assert_allclose(found.transmission_ratio[0], 2 * math.pi / 2.5e-3)
    np.testing.assert_allclose(found.reflected_mass[0], 4e-5 * (2 * math.pi / 2.5e-3) ** 2)
    np.testing.assert_allclose(found.rotor_momentum[4], -4e-5 * 2 * math.pi / 2.5e-3)


def test_a_drive_goes_through_tables_and_files_to_the_bit(tmp_path: Path) -> None:
    robot = read(SHARED + OWN, tmp_path)
    assert ss.Robot.from_dict(json.loads(json.dumps(robot.to_dict()))).drive == robot.drive
    assert ss.Robot.from_toml(written(robot, tmp_path / "again.toml")).drive == robot.drive
    for other in (copy.deepcopy(robot), pickle.loads(pickle.dumps(robot)), dataclasses.replace(robot, M=9.0)):
        assert other.drive == robot.drive
        assert not other.drive.lead.flags.writeable


BAD = {
    "[legs.drive]\nefficiency = 0.9\n": "legs.drive.lead: missing, and radius as well (at line 18)",
    "[legs.drive]\nlead = 0\n": "legs.drive.lead: expected a number other than 0, got 0 (at line 19)",
    "[legs.drive]\nlead = 5\nefficiency = 90\n": (
        "legs.drive.efficiency: expected a number > 0 and <= 1, got 90 (at line 20)"
    ),
    "[legs.drive]\nlead = 5\n[leg.2.drive]\nrotor_inertia = -1e-5\n": (
        "leg.2.drive.rotor_inertia: expected a number >= 0, got -1e-05 (at line 21)"
    ),
    "[legs.drive]\nlead = 5\ninertia = 3\n": (
        'legs.drive.inertia: unknown key, did you mean "rotor_inertia"? (at line 20)'
    ),
    "[legs.drive]\nlead = 5\nstribeck_force = 3\n": (
        "legs.drive.stribeck_force: requires a stribeck_speed > 0 (at line 20)"
    ),
    "[legs.drive]\nlead = 5\ntorque_limit = 2\n[leg.2.drive]\nrated_torque = 3\n": (
        "leg.2.drive.rated_torque: expected at most the torque_limit, 2 N m, got 3 (at line 22)"
    ),
    "[leg.2]\ndrive = []\n": "leg.2.drive: expected a table, got [] (at line 19)",
    "[leg.3.drive]\nlead = 5\n": (
        "leg.3.drive: expected a drive of every leg, or a table legs.drive with keys; missing for legs "
        "1, 2, 4, 5, 6 (at line 18)"
    ),
}


@pytest.mark.parametrize("text", BAD)
def test_a_bad_drive_gives_one_line_with_key_and_line(text: str, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"\A[^\n]*\Z") as error:
        read(text, tmp_path)
    assert str(error.value).startswith(f"{tmp_path / 'robot.toml'}: {BAD[text]}"), error.value
    assert "at line" in str(error.value)


EXAMPLE = DOCS / "examples" / "offset-joints.toml"

SERVED = {
    *(
        "inverse_dynamics",
        "joint_reactions",
        "massless_forces",
        "leg_dynamics_fraction",
        "equations_of_motion",
    ),
    *("forward_dynamics", "joint_space_inertia", "inverse_kinematics", "wrench_matrix", "forward_kinematics"),
    *("jacobian", "inverse_jacobian", "axis_travel"),
    *("forward_velocity", "forward_acceleration", "motion_from_lengths", "ArrayKernel"),
    *("ForceKernel", "LegSprings", "LegSprings.in_equilibrium", "ComputedTorque", "simulate", "singularity"),
    *(
        "force_std",
        "motor_angles",
        "pose_from_motor_angles",
        "capability_polytope",
        "drive_effort",
        "motor_forces",
    ),
    *("view", "export_model", "joint_angles", "actuator_requirements", "wrench_matrix_rate"),
}
"""Functions that compute offset joints."""
OF_POINTS = {"up_direction", "characteristic_length", "read_trajectory", "write_trajectory"}
"""Functions of the joints' points alone, or of files."""


def _example() -> dict[str, Any]:
    return tomllib.loads(EXAMPLE.read_text(encoding="utf-8"))


@pytest.mark.parametrize("joint", ["spherical", "universal"])
def test_what_to_dict_writes_is_read_to_the_bit(joint: str) -> None:
    robot, _ = offset_case(0, joint, screws=True)
    again = ss.Robot.from_dict(robot.to_dict())
    for each in dataclasses.fields(ss.JointOffsets):
        np.testing.assert_array_equal(getattr(again.offsets, each.name), getattr(robot.offsets, each.name))
    assert (
        ss.Robot.from_dict(
            _example()
            | {"legs": {k: v for k, v in _example()["legs"].items() if k not in ("offsets", "cross")}}
        ).offsets
        is None
    )


UNIVERSAL = {"platform_joint": "universal", "platform_axis": [0, 1, 0], "wrist_offset": 3.0}


@pytest.mark.parametrize(
    ("table", "value", "message"),
    [
        ("offsets", {"cros": 1.0}, "legs.offsets.cros"),
        ("offsets", {"axis_offset": "10"}, "legs.offsets.axis_offset: expected a finite number"),
        ("offsets", {"wrist_offset": 1.0}, "legs.offsets.wrist_offset: expected none unless"),
        ("offsets", {"platform_joint": "hooke"}, "legs.offsets.platform_joint: expected"),
        ("offsets", {"platform_joint": "universal"}, "legs.offsets.platform_axis: missing"),
        ("cross", {"mass": -1.0}, "legs.cross.mass: expected a number >= 0"),
        ("cross", {"center_of_mass": [0.0, 1.0]}, "legs.cross.center_of_mass: expected 3 finite"),
        ("stroke", [-1.0, 1.0], "legs.stroke: expected stroke or length_limits, got both"),
    ],
)
def test_bad_files_give_one_line_with_the_key(table: str, value: object, message: str) -> None:
    d = _example()
    d["legs"][table] = value
    rejects(re.escape(f"robot: {message}"), ss.Robot.from_dict, d)


def test_a_rack_moves_no_leg_whose_upper_part_turns() -> None:
    d = _example()
    d["legs"]["drive"] = {"radius": 12.0, "gear_ratio": 5.0}
    assert ss.Robot.from_dict(d).drive is not None
    d["legs"]["offsets"] |= UNIVERSAL
    rejects(r'\Arobot: legs\.drive\.radius: a rack cannot turn with a "universal"', ss.Robot.from_dict, d)


@pytest.mark.parametrize("joint", [{}, UNIVERSAL], ids=["spherical", "universal"])
def test_a_stroke_is_about_the_length_along_the_line_of_sliding(joint: dict[str, Any]) -> None:
    d = _example()
    d["legs"]["offsets"] |= joint
    del d["legs"]["length_limits"]
    d["legs"]["stroke"] = [-50.0, 30.0]
    robot = ss.Robot.from_dict(d)
    L = ss.inverse_kinematics(
        robot, ss.Motion(R=np.eye(3), t=robot.home_position, omega=np.zeros(3), v=np.zeros(3))
    ).L
    np.testing.assert_allclose(robot.length_limits, np.stack([L - 0.05, L + 0.03], axis=-1), rtol=1e-14)
    plain = np.linalg.norm(robot.home_position + robot.p - robot.b, axis=-1)
    assert np.abs(L - plain).min() > 1e-3
    d["legs"]["offsets"]["slide_offset_z"] = 5000.0
    rejects(r"legs\.stroke: .* which the offsets cannot reach", ss.Robot.from_dict, d)


def test_joints_swing_as_the_lines_of_sliding_do() -> None:
    d = _example()
    d["legs"]["offsets"] |= UNIVERSAL
    robot = ss.Robot.from_dict(d)
    R = rotation_from_rpy(np.array([0.1, -0.05, 0.2]))
    home, away = (
        ss.Motion(R=turn, t=robot.home_position, omega=np.zeros(3), v=np.zeros(3)) for turn in (np.eye(3), R)
    )
    s, neutral = (ss.inverse_kinematics(robot, pose).s for pose in (away, home))
    found = ss.joint_angles(robot, away)
    np.testing.assert_allclose(np.cos(found.base), np.sum(s * neutral, axis=-1), rtol=1e-12)
    np.testing.assert_allclose(np.cos(found.platform), np.sum((s @ R) * neutral, axis=-1), rtol=1e-12)
    assert ss.joint_angles(robot, home).base.max() < 1e-12


def test_every_public_function_computes_offsets_or_rejects_them() -> None:
    every = calls()
    seen = {name for name, call in every.items() if "robot" in call.arguments}
    assert SERVED | OF_POINTS <= seen
    for name in seen - OF_POINTS:
        call = every[name]
        robot = dataclasses.replace(
            call.arguments["robot"],
            offsets=ss.JointOffsets(axis_offset=np.full(6, 0.02), slide_offset_y=np.full(6, 0.01)),
        )
        given = {**call.arguments, "robot": robot}
        if name in SERVED:
            call.function(**given)
            continue
        with pytest.raises(ValueError, match="offset") as caught:
            call.function(**given)
        assert "\n" not in str(caught.value), name


def test_paper_and_levels_are_rejected() -> None:
    robot, motion = offset_case(0)
    rejects("formulation: expected", ss.inverse_dynamics, robot, motion, formulation="paper")
    rejects("formulation: expected", ss.ForceKernel, robot, formulation="paper")
    rejects(r"expected \"general\", got 'slender'", ss.ForceKernel, robot, fidelity="slender")
    universal, _ = offset_case(0, "universal")
    rejects("platform_joint", ss.ForceKernel, universal)
