"""Drives of the legs: their tables, what follows from them, and the mistakes people make in them."""

import copy
import dataclasses
import json
import math
import pickle
from pathlib import Path

import numpy as np
import pytest
from command_line import rejects
from robot_files import PRESS, written

import stewart_sym as ss
from stewart_sym.robot.drive import NUMBERS

SHARED = """\
[legs.drive]
lead = 5
gear = 2.0
rotor_inertia = 4e-5
efficiency = 0.9
screw_coulomb = 30.0
screw_viscous = 200.0
motor_coulomb = 0.02
motor_viscous = 1e-4
stribeck = 10.0
stribeck_speed = 3
smoothing = 0.1
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
drive.back_efficiency = -0.1
"""


def read(text: str, folder: Path) -> ss.Robot:
    path = folder / "robot.toml"
    path.write_text(PRESS + text, encoding="utf-8")
    return ss.Robot.from_toml(path)


def drive(text: str, folder: Path) -> ss.Drive:
    found = read(text, folder).drive
    return found


def test_a_drive_has_the_back_efficiency_of_a_file_without_it(tmp_path: Path) -> None:
    made = ss.Drive(lead=5e-3, efficiency=[0.8, 0.9, 1.0, 0.5, 0.4, 0.9])
    np.testing.assert_allclose(made.back_efficiency, [0.75, 2.0 - 1.0 / 0.9, 1.0, 0.0, -0.5, 2.0 - 1.0 / 0.9])
    of_file = drive("[legs.drive]\nlead = 5\nefficiency = 0.8\n", tmp_path)
    assert of_file == ss.Drive(lead=of_file.lead, efficiency=0.8)
    np.testing.assert_array_equal(ss.Drive(lead=5e-3, back_efficiency=0.7).back_efficiency, 0.7)


def test_numbers_of_a_file_are_in_si_units_and_a_leg_may_have_its_own(tmp_path: Path) -> None:
    found = drive(SHARED + OWN, tmp_path)
    ordinary = [0, 1, 3, 5]
    np.testing.assert_allclose(found.lead[ordinary], 5e-3, rtol=1e-15)
    assert found.lead[2] == pytest.approx(2 * math.pi * 12e-3)
    assert found.lead[4] == -5e-3
    np.testing.assert_array_equal(found.gear, 2.0)
    np.testing.assert_array_equal(found.screw_coulomb, [30, 30, 45, 30, 30, 30])
    np.testing.assert_allclose(found.back_efficiency, [2 - 1 / 0.9] * 4 + [-0.1] + [2 - 1 / 0.9])
    np.testing.assert_allclose(found.speed_limit, 100 * math.pi)
    np.testing.assert_allclose(found.stribeck_speed, 3e-3)
    np.testing.assert_allclose(found.smoothing, 1e-4)
    np.testing.assert_allclose(found.turns[0], 2 * math.pi / 2.5e-3)
    np.testing.assert_allclose(found.reflected_mass[0], 4e-5 * (2 * math.pi / 2.5e-3) ** 2)
    np.testing.assert_allclose(found.momentum[4], -4e-5 * 2 * math.pi / 2.5e-3)


def test_what_is_not_given_is_absent(tmp_path: Path) -> None:
    assert read("", tmp_path).drive is None
    found = drive("[legs.drive]\nlead = 5\n", tmp_path)
    for name, key in NUMBERS.items():
        if name != "lead":
            np.testing.assert_array_equal(getattr(found, name), np.full(6, key.default))


def test_a_drive_goes_through_tables_files_and_units_to_the_bit(tmp_path: Path) -> None:
    robot = read(SHARED + OWN, tmp_path)
    assert ss.Robot.from_dict(json.loads(json.dumps(robot.to_dict()))).drive == robot.drive
    assert ss.Robot.from_toml(written(robot, tmp_path / "again.toml")).drive == robot.drive
    units = ss.Units.of(robot)
    assert units.robot(robot).drive != robot.drive
    assert units.inverse.robot(units.robot(robot)).drive == robot.drive
    for other in (copy.deepcopy(robot), pickle.loads(pickle.dumps(robot)), dataclasses.replace(robot, M=9.0)):
        assert other.drive == robot.drive
        assert not other.drive.lead.flags.writeable


BAD = {
    # what is written, and the message without the file: key, what was expected, line
    "[legs.drive]\nefficiency = 0.9\n": ("legs.drive.lead: missing, and radius as well (at line 18)"),
    "[legs.drive]\nlead = 0\n": "legs.drive.lead: expected a number other than 0, got 0 (at line 19)",
    "[legs.drive]\nlead = '5'\n": "legs.drive.lead: expected a finite number, got '5' (at line 19)",
    "[legs.drive]\nlead = 5\nradius = 9\n": (
        "legs.drive.radius: expected lead or radius, got both (at line 20)"
    ),
    "[legs.drive]\nradius = -9\n": "legs.drive.radius: expected a number > 0, got -9 (at line 19)",
    "[legs.drive]\nlead = 5\ngear = 0\n": "legs.drive.gear: expected a number > 0, got 0 (at line 20)",
    "[legs.drive]\nlead = 5\nefficiency = 90\n": (
        "legs.drive.efficiency: expected a number > 0 and <= 1, got 90 (at line 20)"
    ),
    "[legs.drive]\nlead = 5\nback_efficiency = 1.5\n": (
        "legs.drive.back_efficiency: expected a number <= 1, got 1.5 (at line 20)"
    ),
    "[legs.drive]\nlead = 5\n[leg.2.drive]\nrotor_inertia = -1e-5\n": (
        "leg.2.drive.rotor_inertia: expected a number >= 0, got -1e-05 (at line 21)"
    ),
    "[legs.drive]\nlead = 5\nfriction = 3\n": "legs.drive.friction: unknown key, ",
    "[legs.drive]\nlead = 5\ninertia = 3\n": (
        'legs.drive.inertia: unknown key, did you mean "rotor_inertia"? (at line 20)'
    ),
    "[legs.drive]\nlead = 5\nstribeck = 3\n": (
        "legs.drive.stribeck: expected a stribeck_speed > 0 beside it (at line 20)"
    ),
    "[legs.drive]\nlead = 5\ncurrent_limit = 3\n": (
        "legs.drive.current_limit: expected a torque_constant > 0 beside it (at line 20)"
    ),
    "[legs.drive]\nlead = 5\ntorque_limit = 2\n[leg.2.drive]\nrated_torque = 3\n": (
        "leg.2.drive.rated_torque: expected at most the torque_limit, 2 N m, got 3 (at line 22)"
    ),
    "[legs.drive]\nlead = 5\ncurrent_limit = inf\n": (
        "legs.drive.current_limit: expected a finite number, got inf (no limit is a key left out, "
    ),
    "[legs.drive]\nlead = 1e-120\n": (
        "legs.drive.lead: expected a lead with which the rotor's inertia is a finite mass (at line 19)"
    ),
    "[legs.drive]\nlead = 1e400\n": (
        "legs.drive.lead: expected a finite number, got inf (no limit is a key left out, and a double holds "
    ),
    "[leg.2]\ndrive = []\n": "leg.2.drive: expected a table, got [] (at line 19)",
    "[[legs.drive]]\nlead = 5\n": "legs.drive: expected a table, got [{'lead': 5}] (at line 18)",
    "[leg.3.drive]\nlead = 5\n": (
        "leg.3.drive: expected a drive of every leg, or a table legs.drive with keys; missing for legs "
        "1, 2, 4, 5, 6 (at line 18)"
    ),
    "[legs.drive]\n": (
        "legs.drive: expected a drive of every leg, or a table legs.drive with keys; missing for all legs "
        "(at line 18)"
    ),
    "[leg.7.drive]\nlead = 5\n": "leg.7: unknown key, expected one of 1, 2, 3, 4, 5, 6 (at line 18)",
}


@pytest.mark.parametrize("text", BAD)
def test_a_bad_drive_gives_one_line_with_key_and_line(text: str, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"\A[^\n]*\Z") as error:
        read(text, tmp_path)
    assert str(error.value).startswith(f"{tmp_path / 'robot.toml'}: {BAD[text]}"), error.value
    assert "at line" in str(error.value)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('"press"', '""', "name: expected text that is not blank, got '' (at line 2)"),
        ("radius = 600", "radius = 1e400", "base.radius: expected "),
    ],
)
def test_blank_names_and_numbers_beyond_a_double_are_said_to_be_so(
    old: str, new: str, message: str, tmp_path: Path
) -> None:
    path = tmp_path / "robot.toml"
    path.write_text(PRESS.replace(old, new, 1))
    with pytest.raises(ValueError, match=r"\A[^\n]*\(at line \d+\)\Z") as error:
        ss.Robot.from_toml(path)
    assert str(error.value).startswith(f"{path}: {message}")
    assert "1e400" not in new or "a double holds up to 1.8e+308" in str(error.value)


def test_fields_are_checked_by_name() -> None:
    for field, value, words in (
        ("efficiency", 0.0, "efficiency: expected a number > 0 and <= 1, got 0"),
        ("torque_limit", [1.0, 2.0], r"torque_limit: expected one number or six, got \[1.0, 2.0\]"),
        ("smoothing", [0, 0, 0, math.nan, 0, 0], "smoothing: leg 4: expected a finite number"),
        ("stribeck", 1.0, "stribeck: leg 1: expected a stribeck_speed"),
    ):
        rejects(words, ss.Drive, lead=5e-3, **{field: value})
    with pytest.raises(ValueError, match="robot: drive: expected a Drive or None, got 3"):
        dataclasses.replace(ss.robots.dasgupta1998(), drive=3)
