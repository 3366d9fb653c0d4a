"""Limits of actuators, and welds, of imported models are those of MuJoCo."""

import re
from pathlib import Path

import mujoco
import numpy as np
import pytest
from command_line import rejects
from exported_models import exported, imported
from numpy.typing import NDArray

HUGE = 1e9
"""A control far outside the limits of all actuators."""
ACTUATORS = {
    "two": ("", '<motor joint="#" ctrlrange="-900 900"/><motor joint="#" ctrlrange="-400 400"/>', 1300.0),
    "two against each other": (
        "",
        '<motor joint="#" ctrlrange="-9 1"/><motor joint="#" ctrlrange="-2 40" gear="-1"/>',
        49.0,
    ),
    "negative gear": ("", '<motor joint="#" gear="-100" ctrlrange="-30 90" forcerange="-20 100"/>', 9000.0),
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
def test_a_leg_is_limited_to_the_largest_force_of_its_actuators_in_mujoco(name: str, tmp_path: Path) -> None:
    default, actuators, limit = ACTUATORS[name]
    text = hexapod(default, actuators)
    np.testing.assert_allclose(largest_forces(text), limit, rtol=1e-12)
    np.testing.assert_allclose(imported(text, tmp_path).robot.force_limit, limit, rtol=1e-12)


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


BODIES, SITES = 'body1="platform" body2="load"', 'site1="there" site2="here"'
WELDS = {
    "as drawn": (BODIES, ""),
    "as stated": (f'{BODIES} relpose="0.1 0.2 0.3 1 0 0 1"', ""),
    "sites": (SITES, ""),
    "elsewhere": (f'{BODIES} relpose="0.1 0.2 0.6 1 0 0 1"', "0.3 m"),
    "turned": (f'{BODIES} relpose="0.1 0.2 0.3 1 0 0 0"', "90 deg"),
    "sites turned": ('site1="there" site2="here turned"', "60 deg"),
}
"""Attributes of a weld of a load, and how far it is open in the pose of the file, where it is."""


@pytest.mark.parametrize("name", WELDS)
def test_a_weld_holds_a_load_where_mujoco_holds_it(name: str, tmp_path: Path) -> None:
    weld, gap = WELDS[name]
    text = exported().text.replace("</equality>", f"<weld {weld}/></equality>")
    x, y, z = (float(each) for each in re.findall(r'"platform" pos="(\S+) (\S+) (\S+)"', text)[0])
    load = (
        f'<body name="load" pos="{x + 0.1!r} {y + 0.2!r} {z + 0.3!r}" euler="0 0 {np.pi / 2!r}"><freejoint/>'
        f'<geom size="0.1" mass="7"/><site name="here"/><site name="here turned" euler="{np.pi / 3!r} 0 0"/>'
    )
    there = f'<site name="there" pos="0.1 0.2 0.3" euler="0 0 {np.pi / 2!r}"/>'
    text = text.replace("</worldbody>", f"{load}</body></worldbody>")
    text = text.replace('<site name="tip_1_b"', f'{there}<site name="tip_1_b"')
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    # The weld is the last constraint.
    assert (np.abs(data.efc_pos[-6:]).max() < 1e-9) == (not gap)
    if gap:
        said = f"expected closed loops and welds in the pose of the file, got open by {gap}"
        rejects(said, imported, text, tmp_path)
    else:
        assert imported(text, tmp_path).robot.M == 47.0
