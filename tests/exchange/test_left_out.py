"""What other programs' models may have beside bodies and joints: taken, or said to be left out."""

from pathlib import Path

import numpy as np
import pytest
from exported_models import exported, written

import stewart_sym as ss

PLATFORM = '<body name="platform"'
JOINT = '<joint name="leg_1" type="slide"'
LEFT_OUT = {
    "shell": (
        "mjcf",
        ('<inertial mass="40.0"', '<geom name="x" size="0.1" mass="40" shellinertia="true"/><replaced '),
        "that body 'platform': geom 'x' is a shell",
    ),
    "weight taken off": ("mjcf", (PLATFORM, f'{PLATFORM} gravcomp="1"'), "gravcomp of body 'platform'"),
    "medium": ("mjcf", ("<option ", '<option density="1.2" '), "density of the medium around the machine"),
    "spring": ("mjcf", (JOINT, f'{JOINT} stiffness="9"'), "stiffness of joint 'leg_1'"),
    "one side": (
        "mjcf",
        ('ctrlrange="-500.0 500.0" forcerange="-500.0 500.0"', 'gear="50" ctrlrange="-10 12"'),
        "the limit of 500 N in one direction of actuator 'leg_1': 600 N, the other's, is force_limit",
    ),
    "servo": (
        "mjcf",
        ('<motor name="leg_1" joint="leg_1"', '<position joint="leg_1"'),
        "gain, bias and dynamics of actuator of joint 'leg_1': force_limit is what limits their forces",
    ),
    "tendon": (
        "mjcf",
        ('<motor name="leg_1" joint="leg_1"', '<motor tendon="rope"/><motor name="leg_1" joint="leg_1"'),
        "actuator of tendon 'rope', which is no joint's",
    ),
    "computed inertia": (
        "sdf",
        ("<inertial>", '<inertial auto="true">'),
        "auto of link 'lower_1': the mass and inertia that its inertial states are taken",
    ),
    "no weight": (
        "sdf",
        ('<link name="platform">', '<link name="platform"><gravity>false</gravity>'),
        "that link 'platform' has no weight",
    ),
    "added mass": (
        "sdf",
        ("<mass>40.0</mass>", "<mass>40.0</mass><fluid_added_mass><xx>1</xx></fluid_added_mass>"),
        "fluid_added_mass of link 'platform'",
    ),
    "spring of a slide": (
        "sdf",
        ("<damping>20.0</damping>", "<damping>20.0</damping><spring_stiffness>7</spring_stiffness>"),
        "spring_stiffness of joint 'leg_1'",
    ),
    "mimic in SDF": (
        "sdf",
        ("<dynamics>\n      <damping>20.0", '<mimic joint="leg_2"/><dynamics>\n      <damping>20.0'),
        "mimic of joint 'leg_1'",
    ),
    "mimic": (
        "urdf",
        ('<parent link="lower_1"', '<mimic joint="leg_2"/><parent link="lower_1"'),
        "mimic of joint 'leg_1'",
    ),
    "friction": (
        "urdf",
        ('damping="20.0" friction="0.0"', 'damping="20.0" friction="2"'),
        "friction of joint 'leg_1'",
    ),
}


def imported(folder: Path, form: str, *change: str) -> ss.ImportedModel:
    """The exported hexapod after a change of its text, in one place."""
    file = exported(form)
    assert change[0] in file.text
    return ss.import_model(written(ss.ModelFile(file.text.replace(*change, 1), file.loops), folder / "model"))


@pytest.mark.parametrize("name", LEFT_OUT)
def test_what_has_no_place_in_a_robot_is_said_to_be_left_out(name: str, tmp_path: Path) -> None:
    form, change, said = LEFT_OUT[name]
    lines = [line for line in imported(tmp_path, form, *change).assumptions if line.startswith("left out: ")]
    assert len(lines) == 1
    assert lines[0].startswith(f"left out: {said}")


@pytest.mark.parametrize(
    ("part", "said"),
    [
        ("<mass>40.0</mass>", "mass: not in the file, SDF's default is taken (1 kg)"),
        ("<izz>1.6</izz>", "izz: not in the file, SDF's default is taken (1 kg m^2)"),
    ],
)
def test_what_an_inertial_of_sdf_does_not_state_is_said(part: str, said: str, tmp_path: Path) -> None:
    found = imported(tmp_path, "sdf", part, "")
    assert f"link 'platform': inertial: {said}" in found.assumptions
    assert 1.0 in (found.robot.M, found.robot.I_p[2, 2])


def test_a_link_of_sdf_without_an_inertial_has_the_mass_that_drake_gives_it(tmp_path: Path) -> None:
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import MultibodyPlant

    tool = '<link name="tool"><pose>0 0 1 0 0 0</pose></link><joint name="weld" type="fixed">'
    tool += "<parent>platform</parent><child>tool</child></joint>"
    change = '<link name="lower_1">', tool + '<link name="lower_1">'
    found = imported(tmp_path, "sdf", *change)
    plant = MultibodyPlant(0.0)
    Parser(plant).AddModelsFromString(exported("sdf").text.replace(*change, 1), "sdf")
    assert found.robot.M == 40.0 + plant.GetBodyByName("tool").default_mass() == 41.0
    said = "mass, ixx, iyy, izz: not in the file, SDF's default is taken (1 kg, 1 kg m^2)"
    assert f"link 'tool': inertial: {said}" in found.assumptions


def test_an_inertia_that_no_body_has_is_warned_of(tmp_path: Path) -> None:
    with pytest.warns(
        ss.PhysicalityWarning, match=r"model: platform: inertia: .*\[platform-inertia\]"
    ) as caught:
        imported(tmp_path, "urdf", 'ixx="0.9"', 'ixx="-0.9"')
    assert len(caught) == 1
    assert caught[0].filename == __file__


def test_shapes_outside_the_groups_that_count_have_no_mass(tmp_path: Path) -> None:
    geoms = '<geom size="0.1" mass="4" group="1"/><geom size="0.2" mass="9" group="3"/>'
    counting = '<compiler inertiagrouprange="0 1" inertiafromgeom="true" '
    text = exported().text.replace("<compiler ", counting).replace("<inertial ", f"{geoms}<inertial ")
    robot = ss.import_model(written(ss.ModelFile(text, None), tmp_path / "model")).robot
    np.testing.assert_allclose([robot.M, *robot.m_d, *robot.m_u], 4.0)


def test_gravity_that_is_switched_off_is_none(tmp_path: Path) -> None:
    change = "<option ", '<option><flag gravity="disable"/></option><option '
    assert not imported(tmp_path, "mjcf", *change).robot.g.any()
