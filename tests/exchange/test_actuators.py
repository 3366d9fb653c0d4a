"""Actuators of a model limit the forces of its legs to what MuJoCo itself makes of them."""

import re
from pathlib import Path

import mujoco
import numpy as np
import pytest
from exported_models import exported, imported
from numpy.typing import NDArray

HUGE = 1e9
"""A control far outside the limits of all actuators."""
ACTUATORS = {
    "default of another element": ('<general gear="7" ctrlrange="-5 5"/>', '<motor joint="#"/>', 35.0),
    "default of the plain element": ('<motor gear="7" ctrlrange="-5 5"/>', '<general joint="#"/>', 35.0),
    "defaults together": ('<general gear="7"/><motor ctrlrange="-6 6"/>', '<motor joint="#"/>', 42.0),
    "the last default": (
        '<general gear="7"/><position kp="3" gear="2" ctrlrange="-6 6"/><motor/>',
        '<general joint="#"/>',
        12.0,
    ),
    "default gain of a motor": ('<general gainprm="50" ctrlrange="-6 6"/>', '<motor joint="#"/>', 6.0),
    "default gain": ('<adhesion gain="50" ctrlrange="0 6"/>', '<general joint="#"/>', 300.0),
    "default flag": (
        '<velocity ctrllimited="false"/><adhesion gain="2" ctrlrange="0 6"/><motor/>',
        '<general joint="#"/>',
        6.0,
    ),
    "default of a class": (
        '<motor ctrlrange="-5 5"/><default class="strong"><position gear="3"/></default>',
        '<motor joint="#" class="strong"/>',
        15.0,
    ),
    "two": ("", '<motor joint="#" ctrlrange="-900 900"/><motor joint="#" ctrlrange="-400 400"/>', 1300.0),
    "two against each other": (
        "",
        '<motor joint="#" ctrlrange="-9 1"/><motor joint="#" ctrlrange="-2 40" gear="-1"/>',
        49.0,
    ),
    "negative gain": (
        "",
        '<general joint="#" gainprm="-50" ctrlrange="-10 90" forcerange="-6000 300"/>',
        4500.0,
    ),
    "negative gain, force": (
        "",
        '<general joint="#" gainprm="-50" ctrlrange="-10 90" forcerange="-600 4000"/>',
        600.0,
    ),
    "negative gear": ("", '<motor joint="#" gear="-100" ctrlrange="-30 90" forcerange="-20 100"/>', 9000.0),
    "ranges apart": ("", '<motor joint="#" ctrlrange="30 90" forcerange="-20 20"/>', 20.0),
    "in the parent": ("", '<motor jointinparent="#" ctrlrange="-800 800"/>', 800.0),
}


def hexapod(default: str, actuators: str, slide: str = "") -> str:
    """The exported hexapod with other actuators, # for the joint, and attributes of its slides."""
    text = exported().text
    six = "".join(actuators.replace("#", f"leg_{i}") for i in range(1, 7))
    text = re.sub("<actuator>.*</actuator>", f"<actuator>{six}</actuator>", text, flags=re.DOTALL)
    text = text.replace("<default>", f"<default>{default}", 1)
    return text.replace('type="slide"', f'type="slide" {slide}')


def largest_forces(text: str) -> NDArray[np.float64]:
    """Largest forces of the slides in MuJoCo, (6,), the controls of each leg far outside on every side."""
    model = mujoco.MjModel.from_xml_string(text)
    data, slides = mujoco.MjData(model), [model.joint(f"leg_{i}").dofadr[0] for i in range(1, 7)]
    each = model.nu // 6
    found = np.zeros(6)
    for signs in np.ndindex(*(2,) * each):
        data.ctrl[:] = np.tile(HUGE * (2.0 * np.array(signs) - 1.0), 6)
        mujoco.mj_forward(model, data)
        found = np.maximum(found, np.abs(data.qfrc_actuator[slides]))
    return found


@pytest.mark.parametrize("name", ACTUATORS)
def test_a_leg_is_limited_to_the_largest_force_that_its_actuators_have_in_mujoco(
    name: str, tmp_path: Path
) -> None:
    default, actuators, limit = ACTUATORS[name]
    text = hexapod(default, actuators)
    np.testing.assert_allclose(largest_forces(text), limit, rtol=1e-12)
    np.testing.assert_allclose(imported(text, tmp_path).robot.force_limit, limit, rtol=1e-12)


@pytest.mark.parametrize(("controls", "limit"), [("-900 300", 500.0), ("-100 900", 700.0), ("-9 9", 9.0)])
def test_a_joints_own_limits_hold_what_its_actuators_have_on_each_side(
    controls: str, limit: float, tmp_path: Path
) -> None:
    text = hexapod("", f'<motor joint="#" ctrlrange="{controls}"/>', 'actuatorfrcrange="-500 700"')
    np.testing.assert_allclose(largest_forces(text), limit, rtol=1e-12)
    np.testing.assert_allclose(imported(text, tmp_path).robot.force_limit, limit, rtol=1e-12)


def test_the_smaller_limit_of_several_actuators_is_said_to_be_left_out(tmp_path: Path) -> None:
    motors = (
        '<motor name="a #" joint="#" ctrlrange="-900 800"/><motor name="b #" joint="#" ctrlrange="-50 50"/>'
    )
    said = imported(hexapod("", motors), tmp_path).assumptions
    who = ", ".join(f"actuator 'a leg_{i}' and actuator 'b leg_{i}'" for i in range(1, 7))
    least = f"the limit of 850 N in one direction of {who}: 950 N, the other's, is force_limit"
    assert f"left out: {least}" in said


def test_actuators_without_a_name_are_called_by_their_joints(tmp_path: Path) -> None:
    said = imported(hexapod("", '<motor joint="#" ctrlrange="-9 8"/>'), tmp_path).assumptions
    who = ", ".join(f"actuator of joint 'leg_{i}'" for i in range(1, 7))
    assert f"left out: the limit of 8 N in one direction of {who}: 9 N, the other's, is force_limit" in said


@pytest.mark.parametrize(
    "attributes",
    ['biastype="affine"', 'gaintype="affine"', 'dyntype="integrator"', 'ctrllimited="false"'],
)
def test_actuators_without_limits_of_what_they_push_with_are_limited_by_their_forces_alone(
    attributes: str, tmp_path: Path
) -> None:
    default = f'<general {attributes} gear="7" ctrlrange="-5 5"/>'
    assert np.all(imported(hexapod(default, '<general joint="#"/>'), tmp_path).robot.force_limit == np.inf)
    limited = imported(hexapod(default, '<general joint="#" forcerange="-9 9"/>'), tmp_path)
    np.testing.assert_array_equal(limited.robot.force_limit, 63.0)
    servo = '<position joint="#" ctrlrange="-5 5" forcerange="-80 80"/>'
    np.testing.assert_array_equal(imported(hexapod("", servo), tmp_path).robot.force_limit, 80.0)


def test_sections_of_defaults_count_together(tmp_path: Path) -> None:
    sections = '<motor gear="3"/></default><default><motor ctrlrange="-9 9"/></default><default>'
    text = hexapod(sections, '<motor joint="#"/>')
    np.testing.assert_allclose(largest_forces(text), 27.0, rtol=1e-12)
    np.testing.assert_allclose(imported(text, tmp_path).robot.force_limit, 27.0, rtol=1e-12)


def test_damping_and_armatures_of_actuators_are_those_of_their_slides(tmp_path: Path) -> None:
    motors = '<motor joint="#" gear="-3" damping="4" armature="2"/><motor joint="#" armature="5"/>'
    of_actuators = hexapod("", motors)
    of_slides = hexapod("", '<motor joint="#"/>', 'armature="23"').replace(
        'damping="20.0" ', 'damping="56.0" '
    )
    found, expected = (imported(text, tmp_path).robot for text in (of_actuators, of_slides))
    np.testing.assert_allclose(found.C_p, 56.0)
    np.testing.assert_allclose(found.drive.reflected_mass, 23.0)
    np.testing.assert_allclose(found.drive.reflected_mass, expected.drive.reflected_mass)
    accelerations = []
    for text in (of_actuators, of_slides):
        model = mujoco.MjModel.from_xml_string(text)
        data = mujoco.MjData(model)
        data.qvel[:] = 0.01
        mujoco.mj_forward(model, data)
        accelerations.append(data.qacc)
    np.testing.assert_allclose(accelerations[0], accelerations[1], rtol=1e-6)
