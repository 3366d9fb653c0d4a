"""What is exported comes back: the same robot, and from that the same bytes; what others write is read."""

import dataclasses
import itertools
import json
import re
import xml.etree.ElementTree as ET
from pathlib import Path

import mujoco
import numpy as np
import pytest
from command_line import rejects
from exported_models import HEXAPOD, written
from machines import offset_case, random_robot, upside_down_in_millimeters
from sweeps import slow_but

import stewart_sym as ss

FORMATS = ("mjcf", "sdf", "drake", "urdf")
NOT_POSSIBLE = ("I_p", "I_d0", "I_u0")
pytestmark = [
    pytest.mark.filterwarnings("error:.*differ from the note"),
    pytest.mark.filterwarnings("ignore:.*(noted only|left out)"),
    pytest.mark.filterwarnings("ignore::stewart_sym.robot.robot.RobotWarning"),
]


MOTOR = {"torque_constant": 0.6, "resistance": 0.8, "rated_torque": 3.0, "torque_limit": 9.0}
LOSSES = {"efficiency": 0.9, "backdrive_efficiency": 0.8, "motor_coulomb": 0.1, "screw_coulomb": 40.0}
GEARED = ss.Drive(
    lead=-0.01, gear_ratio=2.0, rotor_inertia=3e-4, regularization_speed=1e-3, **MOTOR, **LOSSES
)


def robots() -> dict[str, ss.Robot]:
    """Machines of all kinds, one with every field that no format has a place for."""
    found = {name: ss.robots.load(name) for name in ss.robots.NAMES}
    found |= {f"random {i}": random_robot(np.random.default_rng(i), kind) for i, kind in enumerate(KINDS)}
    found["upside down, mm"] = upside_down_in_millimeters()
    hexapod = ss.Robot.from_toml(HEXAPOD)
    limits = {
        "speed_limit": np.linspace(0.1, 0.6, 6),
        "force_limit": np.array([1.0, 2.0, 3.0, 4.0, 5.0, np.inf]),
    }
    poses = {
        "home_position": np.array([0.01, 0.02, 0.7]),
        "tool": np.array([0.0, 0.0, 0.3]),
        "trajectory_format": ss.TrajectoryFormat(
            length_mode="relative", columns={"t_z": "Heave"}, euler_order="xyz"
        ),
    }
    kept = {"suppressed_warnings": ("mass", "home")}
    drive = ss.Drive(lead=np.linspace(0.004, 0.01, 6), rotor_inertia=2e-5, efficiency=0.9, torque_limit=3.0)
    rest = {"g": np.array([1.0, -2.0, 9.0]), "drive": drive}
    angles = {"home_position": np.array([0.0, 0.0, 0.65]), "joint_angle_limit": np.full((6, 2), 0.7)}
    return found | {
        "hexapod": hexapod,
        "joint angles": dataclasses.replace(hexapod, **angles),
        "motion simulator": dataclasses.replace(hexapod, **angles, drive=GEARED),
        "all": dataclasses.replace(hexapod, **limits, **poses, **kept, **rest),
    }


KINDS = ("universal", "spherical")
ROBOTS = robots()


def without_notes(file: ss.ExportedModel) -> ss.ExportedModel:
    note = r"<custom>.*?</custom>|<stewart_sym:note>.*?</stewart_sym:note>"
    text = re.sub(note, "", file.text, flags=re.DOTALL)
    loops = file.loop_closures
    loops = None if loops is None else json.dumps({**json.loads(loops), "note": None})
    return ss.ExportedModel(text, loops)


def differences(robot: ss.Robot, other: ss.Robot) -> set[str]:
    """Fields of two robots that differ, without the units of reports, which are SI units after an import."""
    pairs = (
        (each.name, getattr(robot, each.name), getattr(other, each.name))
        for each in dataclasses.fields(robot)
        if each.name not in ("length_unit", "angle_unit")
    )
    return {
        name
        for name, one, two in pairs
        if not (np.array_equal(one, two) if isinstance(one, np.ndarray) else one == two)
    }


PARTICULAR = ("random 1", "all")
# Those with something particular in all formats, the others in one each.
PAIRS = list(itertools.product(PARTICULAR, FORMATS))
PAIRS += zip(sorted(ROBOTS.keys() - PARTICULAR), itertools.cycle(FORMATS))


@pytest.mark.parametrize(("name", "form"), slow_but(PARTICULAR, sorted(PAIRS), lambda pair: pair[0]))
def test_a_robot_comes_back_and_is_exported_to_the_same_bytes(name: str, form: str, tmp_path: Path) -> None:
    robot = ROBOTS[name]
    file = ss.export_model(robot, form)
    found = ss.import_model(written(file, tmp_path / "model"))
    again = found.robot
    changed = differences(again, robot)
    # Simulators read no tensor that bodies can't have: those of these two machines are the nearest ones.
    expected = set(NOT_POSSIBLE) if name in ("dasgupta1998", "unal") and form != "urdf" else set()
    assert changed == expected
    assert ss.export_model(again, form) == file


@pytest.mark.parametrize(("form", "moved"), [("mjcf", "lower_3"), ("sdf", "base_3"), ("urdf", "base_3_1")])
def test_notes_are_of_the_leg_they_name_in_files_of_any_order(form: str, moved: str, tmp_path: Path) -> None:
    """As another program writes it: leg 3 first, and prefixes of XML namespaces of its own."""
    robot = dataclasses.replace(ROBOTS["motion simulator"], C_s=np.arange(6.0))
    file = ss.export_model(robot, form)
    root = ET.fromstring(file.text)
    (parent,) = (each for each in root.iter() if any(child.get("name") == moved for child in each))
    element = next(child for child in parent if child.get("name") == moved)
    parent.remove(element)
    parent.insert(next(i for i, child in enumerate(parent) if child.tag == element.tag), element)
    changed = ET.tostring(root, encoding="unicode")
    assert form != "sdf" or "<ns0:note>" in changed
    path = written(ss.ExportedModel(changed, file.loop_closures), tmp_path / "model")
    found = ss.import_model(path)
    assert found.assumptions[0].startswith("legs in the order of their names: 1 'lower_1' 'upper_1', 2 ")
    assert differences(found.robot, robot) == set()


def test_notes_come_back_from_a_model_as_mujoco_itself_writes_it(tmp_path: Path) -> None:
    robot = ROBOTS["motion simulator"]
    mujoco.mj_saveLastXML(
        str(tmp_path / "saved.xml"), mujoco.MjModel.from_xml_string(ss.export_model(robot, "mjcf").text)
    )
    found = ss.import_model(tmp_path / "saved.xml").robot
    np.testing.assert_array_equal(found.C_s, robot.C_s)
    np.testing.assert_array_equal(found.force_limit, robot.force_limit)
    np.testing.assert_array_equal(found.drive.efficiency, robot.drive.efficiency)


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("name", ["tsai2000", "random 1"])
def test_bodies_and_joints_alone_are_the_robot_to_rounding(name: str, form: str, tmp_path: Path) -> None:
    robot = ROBOTS[name]
    again = ss.import_model(written(without_notes(ss.export_model(robot, form)), tmp_path / "model")).robot
    unstated = {"mjcf": {"C_s", "speed_limit"}, "sdf": {"C_s"}, "drake": {"C_s"}, "urdf": set()}[form]
    unstated |= {"lower_length", "upper_length"}
    unstated |= {"C_u"} if form in ("sdf", "drake") and robot.base_joint == "spherical" else set()
    for field in differences(again, robot) - unstated - {"home_position"}:
        value = np.asarray(getattr(robot, field))
        np.testing.assert_allclose(
            getattr(again, field), value, rtol=0, atol=1e-12 * max(1.0, np.abs(value).max()), err_msg=field
        )


def test_armatures_alone_become_rotors_that_resist_as_much(tmp_path: Path) -> None:
    robot = ROBOTS["all"]
    found = ss.import_model(written(without_notes(ss.export_model(robot, "mjcf")), tmp_path / "model"))
    np.testing.assert_allclose(found.robot.drive.reflected_mass, robot.drive.reflected_mass, rtol=1e-12)
    assert any("lead of 0.005 m" in line for line in found.assumptions)
    noted = ss.import_model(written(ss.export_model(robot, "mjcf"), tmp_path / "noted"))
    assert not any("lead" in line for line in noted.assumptions)


OFFSETS = {
    "example": ss.Robot.from_toml(HEXAPOD.with_name("offset-joints.toml")),
    "random": offset_case(0)[0],
}


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("name", slow_but(["random"], OFFSETS))
def test_offset_joints_come_back_and_go_out_to_the_same_bytes(name: str, form: str, tmp_path: Path) -> None:
    robot = OFFSETS[name]
    file = ss.export_model(robot, form)
    found = ss.import_model(written(file, tmp_path / "model"))
    assert differences(found.robot, robot) == {"offsets"}
    for each in dataclasses.fields(ss.JointOffsets):
        np.testing.assert_array_equal(
            getattr(found.robot.offsets, each.name), getattr(robot.offsets, each.name)
        )
    assert ss.export_model(found.robot, form) == file


@pytest.mark.parametrize("form", [*FORMATS, "usd"])
def test_legs_whose_upper_parts_turn_are_rejected_by_the_formats_name(form: str) -> None:
    robot, _ = offset_case(0, "universal")
    rejects(rf'\A{form}: offsets.platform_joint: expected "spherical"', ss.export_model, robot, form)
