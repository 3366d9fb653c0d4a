"""Models that others write: other frames and cuts, what is left out, axes in old versions of SDF."""

import re
from pathlib import Path

import numpy as np
import pytest
from command_line import rejects
from exported_models import HEXAPOD, exported, imported, written
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
    np.testing.assert_allclose(robot.home_position, [0.0, 0.0, HEIGHT] + PLATFORM[5], atol=1e-12)
    L = np.linalg.norm(robot.home_position + robot.p - robot.b, axis=-1)
    np.testing.assert_allclose(robot.length_limits, np.stack([L - 0.1, L + 0.2], axis=-1))
    np.testing.assert_array_equal(robot.force_limit, 500.0)
    np.testing.assert_array_equal(robot.g, [0.0, 0.0, 9.81])
    np.testing.assert_array_equal([robot.C_u, robot.C_p], [np.full(6, 0.4), np.full(6, 7.0)])
    np.testing.assert_allclose(robot.C_s, [0.0, 0.0, 0.0, 0.0, 0.0, 0.3])


def test_a_machine_turned_in_its_file_has_its_home_there(foreign: ss.ImportedModel, tmp_path: Path) -> None:
    turned = model().replace('<body name="floor">', '<body name="floor" euler="0 0 90">')
    found = imported(turned, tmp_path)
    assert "axes those of the base in the pose in the file" in "".join(found.assumptions)
    robot, R = foreign.robot, np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    for name in ("b", "p", "home_position", "R_0"):
        np.testing.assert_allclose(getattr(found.robot, name), getattr(robot, name) @ R.T, atol=1e-12)
    np.testing.assert_allclose(found.robot.I_p, R @ robot.I_p @ R.T, atol=1e-12)
    F = [
        ss.inverse_dynamics(
            each,
            ss.Motion(
                R=np.eye(3), t=each.home_position, omega=(zero := np.zeros(3)), v=zero, alpha=zero, a=zero
            ),
        ).F
        for each in (robot, found.robot)
    ]
    np.testing.assert_allclose(F[1], F[0], rtol=1e-9)


def test_what_is_fixed_to_the_platform_is_part_of_it(foreign: ss.ImportedModel) -> None:
    robot = foreign.robot
    assert robot.M == 40.0
    np.testing.assert_allclose(robot.R_0, [0.0, 0.0, 0.0875], atol=1e-12)
    arms = 30.0 * 0.0375**2 + 10.0 * 0.1125**2
    np.testing.assert_allclose(robot.I_p, np.diag([1.0 + 1.0 + arms, 2.0 + 1.0 + arms, 3.5]), atol=1e-12)


LEFT_OUT = {
    "limits of one axis": (
        "sdf",
        ("<lower>-1e+16</lower>", "<lower>-0.05</lower>"),
        "limits -0.05 to inf rad of joint 'base_1'",
    ),
    "for Gazebo": (
        "urdf",
        ("</robot>", '<gazebo reference="leg_1"><springStiffness>5</springStiffness></gazebo></robot>'),
        "gazebo of the file",
    ),
    "computed inertia": (
        "sdf",
        ("<inertial>", '<inertial auto="true">'),
        "auto of link 'lower_1': the mass and inertia that its inertial states are taken",
    ),
    "mimic": (
        "urdf",
        ('<parent link="lower_1"', '<mimic joint="leg_2"/><parent link="lower_1"'),
        "mimic of joint 'leg_1'",
    ),
}


def altered(folder: Path, form: str, *change: str) -> ss.ImportedModel:
    """The exported hexapod after a change of its text, in one place."""
    file = exported(form)
    assert change[0] in file.text
    return ss.import_model(
        written(ss.ExportedModel(file.text.replace(*change, 1), file.loop_closures), folder / "model")
    )


@pytest.mark.parametrize("name", LEFT_OUT)
def test_what_has_no_place_in_a_robot_is_said_to_be_left_out(name: str, tmp_path: Path) -> None:
    form, change, said = LEFT_OUT[name]
    found = altered(tmp_path, form, *change).assumptions
    assert any(line.startswith(f"left out: {said}") for line in found), found


def test_what_an_inertial_of_sdf_does_not_state_is_said(tmp_path: Path) -> None:
    part, said = "<mass>40.0</mass>", "mass: not in the file, SDF's default is taken (1 kg)"
    found = altered(tmp_path, "sdf", part, "")
    assert f"link 'platform': inertial: {said}" in found.assumptions
    assert 1.0 in (found.robot.M, found.robot.I_p[2, 2])


ALL = {"stiffness", "frictionloss", "contacts"}
SPRINGS = 'axis="0 1 0" stiffness="0 9" frictionloss="2"'


@pytest.mark.parametrize(
    ("flags", "values", "left_out"),
    [
        ('damper="disable"', {"C_u": 0.0, "C_p": 0.0}, ALL),
        ('spring="disable"', {"C_u": 0.4, "C_p": 7.0}, ALL - {"stiffness"}),
        ('limit="disable"', {"length_limits": [0.0, np.inf]}, ALL | {"range"}),
        ('clampctrl="disable"', {"force_limit": np.inf}, ALL),
    ],
)
def test_what_a_flag_switches_off_is_not_read(
    flags: str, values: dict[str, object], left_out: set[str], tmp_path: Path
) -> None:
    changes = ('axis="0 1 0"', SPRINGS), ("<worldbody>", f"<option><flag {flags}/></option><worldbody>")
    found = imported(changed(model(), *changes), tmp_path)
    for name, value in values.items():
        field = getattr(found.robot, name)
        np.testing.assert_array_equal(field, np.broadcast_to(value, field.shape))
    assert set(re.findall(r"left out: (\w+)", "\n".join(found.assumptions))) == left_out


MODEL, JOINT = (f"<use_parent_model_frame>{flag}</use_parent_model_frame>" for flag in ("true", "0"))
FRAME = '<frame name="f"><pose>0.3 -0.2 0.1 0.2 0.3 0.7</pose></frame>'
OF_MODEL, OF_JOINT = '<xyz expressed_in="__model__">', "<xyz>"


def newest() -> str:
    """The hexapod, turned in its world; axes are in the frame of the model and, the others, of the joint."""
    others = r"<(visual|collision|stewart_sym:note|plugin)\b.*?</\1>\s*"
    text = re.sub(others, "", exported("sdf").text, flags=re.DOTALL)
    return text.replace('<model name="hexapod">', '<model name="hexapod"><pose>1 2 3 0.1 0.2 0.3</pose>')


def in_frames() -> str:
    """The same with poses in a frame, and tips in the frames of upper parts."""
    text = newest().replace("<link", f"{FRAME}<link", 1).replace(OF_MODEL, '<xyz expressed_in="f">')
    text = re.sub(r'(<link name="\w+">\s*)<pose>', r'\1<pose relative_to="f">', text)
    tip = r"(<parent>(upper_\d)</parent>\s*<child>platform</child>\s*)<pose>.*?</pose>"
    return re.sub(tip, r'\1<pose relative_to="\2">0 0 0 0 0 0</pose>', text)


def changed(text: str, *changes: tuple[str, str]) -> str:
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return text


OLD = {
    "1.5, axes": ("1.5", newest, ((OF_JOINT, f"{JOINT}<xyz>"), (OF_MODEL, f"{MODEL}<xyz>"))),
    "1.3, axes": ("1.3", newest, ((OF_JOINT, f"{JOINT}<xyz>"), (OF_MODEL, f"{MODEL}<xyz>"))),
    "1.6, poses": ("1.6", in_frames, (("relative_to=", "frame="),)),
}


def axes_in_drake(text: str) -> NDArray[np.float64]:
    """Axes of the legs in the world, (6, 3, 3): both at the base and the slide's."""
    # Not at the top: Drake takes half a second, in every process that collects tests.
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import MultibodyPlant

    plant = MultibodyPlant(0.0)
    # Drake has no loops.
    tree = re.sub(r'<joint name="tip_\d".*?</joint>', "", text, flags=re.DOTALL)
    Parser(plant).AddModelsFromString(tree, "sdf")
    plant.Finalize()
    context = plant.CreateDefaultContext()

    def turned(name: str) -> NDArray[np.float64]:
        frame = plant.GetJointByName(name).frame_on_parent()
        return np.array(frame.CalcPoseInWorld(context).rotation().matrix())

    slides = [turned(f"leg_{i}") @ plant.GetJointByName(f"leg_{i}").translation_axis() for i in range(1, 7)]
    return np.array([[*turned(f"base_{i}").T[:2], slide] for i, slide in enumerate(slides, 1)])


@pytest.mark.parametrize("name", OLD)
def test_an_old_version_is_the_machine_that_drake_takes_it_for(name: str, tmp_path: Path) -> None:
    number, source, changes = OLD[name]
    new = source()
    old = changed(new, ('version="1.9"', f'version="{number}"'), *changes)
    axes = axes_in_drake(old)
    np.testing.assert_allclose(axes, axes_in_drake(new), rtol=0, atol=1e-12)
    found, expected = (imported(text, tmp_path).robot for text in (old, new))
    assert found.to_dict() == expected.to_dict()
    np.testing.assert_allclose(np.einsum("ij,ij->i", found.k, axes[:, 0]), 1.0, rtol=1e-12)
    S = found.home_position + found.p - found.b
    L = np.linalg.norm(S, axis=-1)
    np.testing.assert_allclose(np.einsum("ij,ij->i", S, axes[:, 2]) / L, 1.0, rtol=1e-12)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ((OF_MODEL, f"{MODEL}<xyz>"), "joint 'base_1': axis: expected expressed_in, as SDF has it since 1.7"),
        (
            ('"lower_1">\n    <pose>', '"lower_1"><pose frame="base">'),
            "link 'lower_1': pose: expected relative_to",
        ),
        (("<pose>1 2 3", '<pose relative_to="x">1 2 3'), "model 'hexapod': expected one that its own frame"),
        (('version="1.9"', 'version="2.0"'), "sdf: version: expected one such as 1.9, got '2.0'"),
    ],
)
def test_other_frames_are_rejected(change: tuple[str, str], said: str, tmp_path: Path) -> None:
    rejects(re.escape(said), imported, changed(newest(), change), tmp_path)


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
    mine, theirs = (dict(each.to_dict()["leg"], **{"1": None}) for each in (found, robot))
    assert mine == theirs


def test_a_link_of_sdf_without_an_inertial_has_the_mass_that_drake_gives_it(tmp_path: Path) -> None:
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import MultibodyPlant

    tool = '<link name="tool"><pose>0 0 1 0 0 0</pose></link><joint name="weld" type="fixed">'
    tool += "<parent>platform</parent><child>tool</child></joint>"
    change = '<link name="lower_1">', tool + '<link name="lower_1">'
    found = altered(tmp_path, "sdf", *change)
    plant = MultibodyPlant(0.0)
    Parser(plant).AddModelsFromString(exported("sdf").text.replace(*change, 1), "sdf")
    assert found.robot.M == 40.0 + plant.GetBodyByName("tool").default_mass() == 41.0
    said = "mass, ixx, iyy, izz: not in the file, SDF's default is taken (1 kg, 1 kg m^2)"
    assert f"link 'tool': inertial: {said}" in found.assumptions
