"""Broken and foreign models: each gives one line that says what is no Stewart platform, and where."""

import re
import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import stewart_sym as ss

HEXAPOD = Path(__file__).parents[2] / ".docs" / "examples" / "hexapod.toml"
ARM = (
    '<mujoco><worldbody><body name="a"><joint/><geom size=".1"/>'
    '<body name="b" pos="0 0 1"><joint axis="0 1 0"/><geom size=".1"/></body></body></worldbody></mujoco>'
)
BOMB = '<!DOCTYPE mujoco [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]><mujoco>&b;</mujoco>'
FILE = '<!DOCTYPE mujoco [<!ENTITY a SYSTEM "file:///etc/passwd">]><mujoco>&a;</mujoco>'
BARGE = '<body name="barge"><freejoint/><inertial mass="1" pos="0 0 0" diaginertia="1 1 1"/>'
BOB = '<body name="bob"><joint name="swing"/><inertial mass="1" pos="0 0 1" diaginertia="1 1 1"/></body>'

Change = Callable[[str], str]


def to(old: str, new: str) -> Change:
    """The first place of a text becomes another, and must be there."""

    def change(text: str) -> str:
        assert re.search(old, text), old
        return re.sub(old, lambda _: new, text, count=1)

    return change


def without(start: str, end: str) -> Change:
    return to(f"{start}(?s:.*?){end}", "")


def both(*changes: Change) -> Change:
    def change(text: str) -> str:
        for each in changes:
            text = each(text)
        return text

    return change


def instead(text: str) -> Change:
    return lambda _: text


NO_LEG_6 = both(
    without('<body name="lower_6"', "</body>\n  </body>\n"),
    without('<connect name="tip_6"', "/>"),
    without('<motor name="leg_6"', "/>"),
)
BALL_AT_1 = both(
    without('<joint name="base_1_1"', "/>"),
    to('"base_1_2" type="hinge" axis="0.0 1.0 0.0"', '"base_1_2" type="ball"'),
)
BROKEN: dict[str, tuple[str, Change, str]] = {
    "empty": ("mjcf", instead(""), "not valid XML"),
    "no XML": ("mjcf", instead("hello"), "not valid XML"),
    "entities": ("mjcf", instead(BOMB), "document type declaration"),
    "file of another": ("mjcf", instead(FILE), "document type declaration"),
    "depth": ("mjcf", instead("<a>" * 5000), "nested too deeply"),
    "HTML": ("mjcf", instead("<html/>"), "expected MJCF, SDF or URDF"),
    "USD": ("usd", to("x", "x"), "not valid XML"),
    "include": ("mjcf", to("<worldbody>", "<worldbody><include file='x.xml'/>"), "expected a flat model"),
    "nothing": ("mjcf", instead("<mujoco/>"), "no joint at the base"),
    "arm": ("mjcf", instead(ARM), "got 1 that ends without one"),
    "five legs": ("mjcf", NO_LEG_6, "got 5 to 'platform'"),
    "no closures": ("mjcf", without("<equality>", "</equality>"), "got 6 that ends without one"),
    "open loop": ("mjcf", to('"platform" pos="-0.0', '"platform" pos="0.1'), "leg 1: joint 'tip_1'"),
    "no slide": ("mjcf", to('"leg_2" type="slide"', '"leg_2" type="hinge"'), "leg 2: expected a universal"),
    "two slides": ("mjcf", to('<joint name="base_1_1"', '<joint type="slide"/><joint name="b"'), "leg 1"),
    "oblique slide": (
        "mjcf",
        to('"leg_2" type="slide" axis="1.0 0.0', '"leg_2" type="slide" axis="1.0 0.1'),
        "leg 2: joint 'leg_2': expected sliding along the line between the ends, got 5.71 deg off",
    ),
    "oblique axes": (
        "mjcf",
        to('axis="0.0 1.0 0.0"', 'axis="0.3 1.0 0.0"'),
        "leg 1: joint 'base_1_1': expected",
    ),
    "offset axes": ("mjcf", to('name="base_1_2"', 'name="base_1_2" pos="0 0 0.05"'), "axes that meet"),
    "one ball": ("mjcf", BALL_AT_1, "expected a spherical joint at the base as leg 1 has"),
    "number": ("mjcf", to('mass="3.0"', 'mass="3.0 kg"'), "'lower_1': inertial: mass: expected a number"),
    "not finite": ("mjcf", to('mass="3.0"', 'mass="nan"'), "expected a number"),
    "negative": ("mjcf", to('mass="3.0"', 'mass="-3.0"'), "leg 1: body 'lower_1': expected a mass > 0"),
    "no mass": ("mjcf", without('<inertial mass="40', "/>"), "the platform: body 'platform'"),
    "no site": ("mjcf", to('"tip_4_a" site2', '"tip_9" site2'), "connect 'tip_4': site 'tip_9': missing"),
    "free base": (
        "mjcf",
        both(to("<worldbody>", f"<worldbody>{BARGE}"), to("</worldbody>", "</body></worldbody>")),
        "joint 'free'",
    ),
    "pendulum": ("mjcf", to('<freejoint name="free" />', f"<freejoint />{BOB}"), "joint 'swing'"),
    "names": ("mjcf", to('name="lower_2"', 'name="lower_1"'), "expected one body of that name, got 2"),
    "limits": ("mjcf", to('range="0.55 0.95"', 'range="0.9 0.5"'), "leg 1: joint 'leg_1': expected limits"),
    "class": ("mjcf", to('<joint name="base_1_1"', '<joint class="x" name="b"'), "class 'x': missing"),
    "notes": ("mjcf", to("{&quot;", "[&quot;"), "custom: text 'stewart_sym': expected JSON"),
    "unknown note": ("mjcf", to("{&quot;k", "{&quot;spring"), "notes: 'spring'"),
    "screw": ("sdf", to('type="prismatic"', 'type="screw"'), "joint 'leg_1': expected type"),
    "no link": ("sdf", to("<parent>lower_1<", "<parent>lower_9<"), "joint 'leg_1': link 'lower_9': missing"),
    "two models": ("sdf", to("</world>", "<model name='m'/></world>"), "expected one model, got 2"),
    "no frame": ("sdf", to('expressed_in="__model__"', 'expressed_in="x"'), "frame 'x': missing"),
    "circle": (
        "sdf",
        to('lower_1">\n    <pose>', 'lower_1"><pose relative_to="lower_1">'),
        "expected poses that depend on no circle",
    ),
    "static": ("sdf", to('<link name="base">', '<static>1</static><link name="base">'), "static"),
    "two roots": ("urdf", to('<link name="base">', '<link name="x"/><link name="base">'), "got 'world', 'x'"),
    "no axis": ("urdf", to('xyz="1.0 0.0 0.0" />\n  <dyn', 'xyz="0 0 0" />\n  <dyn'), "joint 'leg_1': axis"),
}


@pytest.fixture(scope="module")
def exported() -> dict[str, ss.ModelFile]:
    robot = ss.Robot.from_toml(HEXAPOD)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        found = {name: ss.export_model(robot, name) for name in ("mjcf", "sdf", "urdf", "usd")}
    said = ": expected no friction in these spherical joints, C_s is "
    lines = [f"mjcf{said}noted only", f"sdf{said}noted only", f"usd{said}left out"]
    assert [str(each.message) for each in caught] == lines
    return found


@pytest.mark.parametrize("name", BROKEN)
def test_a_broken_model_gives_one_line_that_says_what_and_where(
    name: str, exported: dict[str, ss.ModelFile], tmp_path: Path
) -> None:
    form, change, said = BROKEN[name]
    path = tmp_path / "model.xml"
    path.write_text(change(exported[form].text), encoding="utf-8")
    (tmp_path / "model.loops.json").write_text(exported["urdf"].loops or "", encoding="utf-8")
    with pytest.raises(ValueError, match=r"model\.xml: ") as caught:
        ss.import_model(path)
    text = str(caught.value)
    assert said in text
    assert "\n" not in text
    assert text.startswith(f"{path}: ")


LOOPS: dict[str, tuple[Change, str]] = {
    "no JSON": (instead("{"), "loops: expected JSON"),
    "a list": (instead("[]"), "loops: expected a table"),
    "unknown key": (to("gravity_m_s2", "gravity"), "unknown key"),
    "no link": (to('"upper_3"', '"upper_9"'), "loops: closure 3: link_1: link 'upper_9': missing"),
    "no point": (to("point_1_m", "point"), "unknown key"),
    "kind": (to('"spherical"', '"hinge"'), "loops: closure 1: type"),
    "damping": (to('"damping_N_m_s": 0.02', '"damping_N_m_s": -1'), "expected a number >= 0"),
}


@pytest.mark.parametrize("name", LOOPS)
def test_broken_loops_of_a_urdf_give_one_line(
    name: str, exported: dict[str, ss.ModelFile], tmp_path: Path
) -> None:
    change, said = LOOPS[name]
    path = tmp_path / "model.urdf"
    path.write_text(exported["urdf"].text, encoding="utf-8")
    (tmp_path / "model.loops.json").write_text(change(exported["urdf"].loops or ""), encoding="utf-8")
    with pytest.raises(ValueError, match=re.escape(said)) as caught:
        ss.import_model(path)
    assert "\n" not in str(caught.value)


def test_a_urdf_without_its_loops_says_where_they_are_looked_for(
    exported: dict[str, ss.ModelFile], tmp_path: Path
) -> None:
    path = tmp_path / "model.urdf"
    path.write_text(exported["urdf"].text, encoding="utf-8")
    with pytest.raises(
        ValueError, match=r"model\.urdf: expected its loops in .* NAME\.loops\.json, got none"
    ):
        ss.import_model(path)


def test_a_note_that_the_model_contradicts_is_not_taken(
    exported: dict[str, ss.ModelFile], tmp_path: Path
) -> None:
    robot = ss.Robot.from_toml(HEXAPOD)
    path = tmp_path / "model.xml"
    text = exported["mjcf"].text
    start = text.index("{&quot;k&quot;: [[")
    path.write_text(text[:start] + text[start:].replace("[[-0.17", "[[-0.27", 1), encoding="utf-8")
    found = ss.import_model(path)
    assert "k: the model says otherwise than the note, the model is taken" in found.assumptions
    np.testing.assert_allclose(found.robot.k, robot.k, rtol=0, atol=1e-12)
