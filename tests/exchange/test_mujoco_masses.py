"""Masses, centres of mass and inertias of imported models are those that MuJoCo computes of the same file."""

import re
from pathlib import Path

import mujoco
import numpy as np
import pytest
from exported_models import exported, imported

LINE = 'fromto="0 0 0 0.1 0.05 0.02"'
BOX = 'type="box" size="0.02 0.05 0.03"'
TURNS = {
    **{f"zaxis {z}": f'zaxis="{z}"' for z in ("0.2 0.1 1", "1 0 0", "0 -1 0", "1 2 -3", "0 0 2", "0 0 -1")},
    "xyaxes": 'xyaxes="1 2 3 -1 2 5"',
    "axisangle": 'axisangle="1 2 3 0.9"',
    "euler": 'euler="0.2 0.4 0.6"',
    "quat": 'quat="10 20 30 5"',
}
SHAPES = {
    **{
        f"box, sizes {size}": f'type="box" {LINE} size="{size}"'
        for size in ("0.01", "0.01 0.03", "0.01 0.03 0.02")
    },
    "box, negative second size": f'type="box" {LINE} size="0.01 -1"',
    "ellipsoid, one size": f'type="ellipsoid" {LINE} size="0.01"',
    "ellipsoid, two sizes": f'type="ellipsoid" {LINE} size="0.01 0.03"',
    "cylinder, two sizes": f'type="cylinder" {LINE} size="0.01 0.3"',
    "capsule, two sizes": f'type="capsule" {LINE} size="0.01 0.3"',
    "sphere, three sizes": 'size="0.02 0.3 0.4"',
    "cylinder, three sizes": 'type="cylinder" size="0.02 0.3 0.4"',
}
DEFAULTS = {
    "a radius alone": ('size="0.02 0.1"', f'type="capsule" {LINE}'),
    "the first size alone": ('size="0.02 0.1"', 'type="cylinder" size="0.03"'),
    "two of three sizes": ('size="0.02 0.1 0.3"', 'type="box" size="0.03 0.04"'),
    "ends": (LINE, f'{BOX} euler="0.5 0 0"'),
    "quat for euler": ('euler="0 0.5 0"', f'{BOX} quat="1 0 0 2"'),
    "euler for quat": ('quat="1 0 0 2"', f'{BOX} euler="0 0.5 0"'),
    "zaxis for axisangle": ('axisangle="1 0 0 0.5"', f'{BOX} zaxis="1 1 0"'),
    "axisangle for xyaxes": ('xyaxes="0 1 0 0 0 1"', f'{BOX} axisangle="1 0 0 0.5"'),
}


def need_same_platform(folder: Path, text: str) -> None:
    robot = imported(text, folder).robot
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    top = model.body("platform").id
    parts = [i for i in range(model.nbody) if model.body_rootid[i] == model.body_rootid[top]]
    mass = model.body_mass[parts]
    center = mass @ data.xipos[parts] / mass.sum()
    inertia = np.zeros((3, 3))
    for i, m in zip(parts, mass, strict=True):
        r, axes = data.xipos[i] - center, data.ximat[i].reshape(3, 3)
        inertia += axes @ np.diag(model.body_inertia[i]) @ axes.T + m * (r @ r * np.eye(3) - np.outer(r, r))
    np.testing.assert_allclose(robot.M, mass.sum(), rtol=1e-12)
    np.testing.assert_allclose(robot.R_0, center - data.body("platform").xpos, rtol=0, atol=1e-12)
    np.testing.assert_allclose(robot.I_p, inertia, rtol=0, atol=1e-12 * np.abs(inertia).max())


def with_platform(content: str, default: str = "") -> str:
    """The exported hexapod with other content of its platform, whose geoms have defaults of their own."""
    text = exported().text
    own = f'<default class="own"><geom density="1000" {default}/></default></default>'
    text = text.replace("</default>", own, 1)
    start = text.index('<body name="platform"')
    inside = re.sub("<inertial .*?/>|<geom .*?/>", "", text[start:])
    free, content = '<freejoint name="free" />', content.replace("<geom ", '<geom class="own" ')
    return text[:start] + inside.replace(free, free + content, 1)


@pytest.mark.parametrize("turn", TURNS.values(), ids=TURNS)
def test_orientations_are_those_of_mujoco(turn: str, tmp_path: Path) -> None:
    inertial = '<inertial mass="3" pos="0.1 0.2 0.3" diaginertia="0.16 0.08 0.13" {}/>'
    content = (
        f"{inertial.format(turn)}"
        f'<body pos="0.3 0.1 0.2" {turn}>{inertial.format("")}</body>'
        '<body><inertial mass="0" pos="1 1 1" diaginertia="0 0 0"/></body>'
        f'<body pos="0 0.1 0.2"><geom {BOX} {turn}/>'
        f'<frame pos="0.1 0 0" {turn}><geom {BOX} pos="0.1 0.2 0.3" euler="0.5 0 0"/></frame></body>'
    )
    need_same_platform(tmp_path, with_platform(content))


@pytest.mark.parametrize("shape", SHAPES.values(), ids=SHAPES)
def test_sizes_of_shapes_are_those_of_mujoco(shape: str, tmp_path: Path) -> None:
    need_same_platform(tmp_path, with_platform(f"<geom {shape}/>"))


@pytest.mark.parametrize(("default", "shape"), DEFAULTS.values(), ids=DEFAULTS)
def test_shapes_take_from_their_class_what_they_take_in_mujoco(
    default: str, shape: str, tmp_path: Path
) -> None:
    need_same_platform(tmp_path, with_platform(f"<geom {shape}/>", default))


@pytest.mark.parametrize(
    ("geom", "said"),
    [
        ('size="0.1" mass="-1"', "mass: expected a number >= 0, got -1"),
        ('size="0.1" density="-1"', "density: expected a number >= 0, got -1"),
        ('type="box" size="0.1 -0.2 0.3"', "size: expected sizes > 0, got '0.1 -0.2 0.3'"),
        ('type="box" size="0.1 0.2"', "size: expected 3 numbers, got '0.1 0.2'"),
        ('size="0.1 0.2 0.3 0.4"', "size: expected a number, got '0.1 0.2 0.3 0.4'"),
        (f'size="0.1" {LINE}', "fromto: expected a type with two ends, got a sphere"),
        ('type="capsule" size="0.1" fromto="1 2 3 1 2 3"', "fromto: expected a non-zero direction"),
    ],
)
def test_shapes_that_mujoco_rejects_are_rejected(geom: str, said: str, tmp_path: Path) -> None:
    text = with_platform(f'<geom name="x" {geom}/>')
    with pytest.raises(ValueError, match=r"XML Error|Error:"):
        mujoco.MjModel.from_xml_string(text)
    with pytest.raises(ValueError, match=re.escape(f"body 'platform': geom 'x': {said}")):
        imported(text, tmp_path)
