"""Axes and poses in old versions of SDF have the frames that Drake, whose parser is SDF's own, gives them."""

import re
from pathlib import Path

import numpy as np
import pytest
from exported_models import exported, imported
from numpy.typing import NDArray

MODEL, JOINT = (f"<use_parent_model_frame>{flag}</use_parent_model_frame>" for flag in ("true", "0"))
FRAME = '<frame name="f"><pose>0.3 -0.2 0.1 0.2 0.3 0.7</pose></frame>'
OF_MODEL, OF_JOINT = '<xyz expressed_in="__model__">', "<xyz>"


def newest() -> str:
    """The hexapod, turned in its world; axes are in the frame of the model and, the others, of the joint."""
    others = r"<(visual|collision|stewart_sym:notes|plugin)\b.*?</\1>\s*"
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
    "1.6, axes": ("1.6", newest, ((OF_MODEL, f"{MODEL}<xyz>"),)),
    "1.5, axes": ("1.5", newest, ((OF_JOINT, f"{JOINT}<xyz>"), (OF_MODEL, f"{MODEL}<xyz>"))),
    "1.4, axes": ("1.4", newest, ((OF_JOINT, f"{JOINT}<xyz>"), (OF_MODEL, "<xyz>"))),
    "1.3, axes": ("1.3", newest, ((OF_JOINT, f"{JOINT}<xyz>"), (OF_MODEL, f"{MODEL}<xyz>"))),
    "1.6, poses": ("1.6", in_frames, (("relative_to=", "frame="),)),
    "1.5, poses": ("1.5", in_frames, (("relative_to=", "frame="),)),
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
    S = found.home + found.p - found.b
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
        (
            ("<inertial>\n     <pose>", '<inertial><pose relative_to="base">'),
            "'lower_1': inertial: pose: expected",
        ),
        (
            ('<model name="hexapod">', '<model name="hexapod" placement_frame="base">'),
            "model 'hexapod': expected",
        ),
        (("<pose>1 2 3", '<pose relative_to="x">1 2 3'), "model 'hexapod': expected one that its own frame"),
        (
            ('version="1.9"', 'version="new"'),
            "sdf: version: expected numbers with a point between, got 'new'",
        ),
    ],
)
def test_other_frames_are_rejected(change: tuple[str, str], said: str, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=re.escape(said)):
        imported(changed(newest(), change), tmp_path)
