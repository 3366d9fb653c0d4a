"""SDF and URDF of other programs: omitted contents, defaults, frames of axes in old versions of SDF."""

import re
from pathlib import Path

import numpy as np
import pytest
from command_line import rejects
from exported_models import exported, imported, written
from numpy.typing import NDArray

import stewart_sym as ss

LEFT_OUT = {
    "limits of one axis": (
        "sdf",
        ("<lower>-1e+16</lower>", "<lower>-0.05</lower>"),
        "limits -0.05 to inf rad of joint 'base_1'",
    ),
    "a shortest length alone": (
        "sdf",
        ("<upper>0.19899430161622755</upper>", ""),
        "shortest length 0.55 m of leg 1, without a longest one",
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


def test_a_longest_length_alone_is_imported(tmp_path: Path) -> None:
    found = altered(tmp_path, "sdf", "<lower>-0.20100569838377236</lower>", "").robot
    np.testing.assert_allclose(found.length_limits[:2], [[0.0, 0.95], [0.55, 0.95]], rtol=1e-12)


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


@pytest.mark.parametrize("gravity", ["", "<gravity/>"])
def test_a_world_of_sdf_has_its_default_gravity_without_one(gravity: str, tmp_path: Path) -> None:
    text = re.sub("<gravity>.*</gravity>", gravity, exported("sdf").text)
    (tmp_path / "model.sdf").write_text(re.sub("<stewart_sym.*?</stewart_sym[^>]*>", "", text, flags=re.S))
    np.testing.assert_array_equal(ss.import_model(tmp_path / "model.sdf").robot.g, [0.0, 0.0, -9.8])
