"""Broken and foreign models: each gives one line that says what is no Stewart platform, and where."""

import itertools
import re
import warnings
from collections.abc import Callable
from pathlib import Path

import pytest
from command_line import rejects
from exported_models import HEXAPOD

import stewart_sym as ss

BOB = '<body name="bob"><joint name="swing"/><inertial mass="1" pos="0 0 1" diaginertia="1 1 1"/></body>'

INCLUDE = '<include><uri>model://x</uri></include><link name="base">'
TIP_3 = 'name="tip_3" site1="tip_3_a" site2="tip_3_b"'
UPPER_3 = 'name="tip_3" body1="upper_3" '
HEAVY = '<inertial><mass value="{}"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
WELDED = {
    "mjcf": (
        '<site name="tip_1_b"',
        '<body name="tool"><inertial mass="{}" pos="0 0 1" diaginertia="1 1 1"/></body>',
    ),
    "sdf": (
        '<link name="lower_1">',
        '<link name="tool"><inertial><mass>{}</mass></inertial></link><joint name="weld" type="fixed">'
        "<parent>platform</parent><child>tool</child></joint>",
    ),
    "urdf": (
        '<link name="lower_1">',
        f'<link name="tool">{HEAVY}</link><joint name="weld" type="fixed"><parent link="platform"/>'
        '<child link="tool"/></joint>',
    ),
}
"""Where a tool that is fixed to the platform is put, and the tool without the number of its mass."""

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


def with_tool(form: str, mass: str) -> Change:
    place, tool = WELDED[form]
    return to(place, tool.format(mass) + place)


NO_LEG_6 = both(
    without('<body name="lower_6"', "</body>\n  </body>\n"),
    without('<connect name="tip_6"', "/>"),
    without('<motor name="leg_6"', "/>"),
)
OF_MJCF: dict[str, tuple[Change, str]] = {
    "empty": (instead(""), "the file is empty"),
    "no XML": (instead("<mujoco><a></mujoco>"), "got no valid XML: mismatched tag: line 1"),
    "one pendulum": (
        instead(f"<mujoco><worldbody>{BOB}</worldbody></mujoco>"),
        "got 1: joint 'swing' to body 'bob', where it ends (at line 1)",
    ),
    "five legs": (NO_LEG_6, "expected six legs from the base and nothing else, got 5"),
    "leg to the base": (
        to(TIP_3, UPPER_3 + "anchor='0 0 0'"),
        "to joint 'tip_3', which leads back to the base",
    ),
    "open loop": (to('"platform" pos="-0.0', '"platform" pos="0.1'), "joints 'tip_1', 'tip_2'"),
    "five closures": (
        without('<connect name="tip_6"', "/>"),
        "to body 'upper_6', where it ends; add a joint or a loop closure from body 'upper_6' to the platform",
    ),
    "no slide": (to('"leg_2" type="slide"', '"leg_2" type="hinge"'), "revolute 'leg_2'"),
    "oblique slide": (
        to('"leg_2" type="slide" axis="1.0 0.0', '"leg_2" type="slide" axis="1.0 0.1'),
        "leg 2: joint 'leg_2': expected sliding along the line between the ends, got 5.71 deg off",
    ),
    "oblique axes": (to('axis="0.0 1.0 0.0"', 'axis="0.3 1.0 0.0"'), "leg 1: joint 'base_1_1': expected"),
    **{
        f"no {flag}": (
            to("<option ", f'<option><flag {flag}="disable"/></option><option '),
            f"option: flag: {flag}: expected enable, since it closes loops, got disable",
        )
        for flag in ("equality", "constraint")
    },
}
OF_URDF: dict[str, tuple[Change, str]] = {
    "cross": (
        to('<link name="base_1_cross_1" />', f'<link name="base_1_cross_1">{HEAVY.format(-1)}</link>'),
        "leg 1: body 'base_1_cross_1': expected a mass >= 0, got -1",
    ),
    "planar": (to('type="prismatic"', 'type="planar"'), "joint 'leg_1': expected type .* got 'planar'"),
    "floating": (
        to('type="prismatic"', 'type="floating"'),
        "joint 'leg_1': expected a free joint to the base alone",
    ),
    "not expanded": (
        to('<link name="lower_1"', '<xacro:include filename="x"/><link name="lower_1"'),
        "xacro:include at line",
    ),
    "carried by none": (without('<joint name="leg_3"', "</joint>"), "got 'world', 'upper_3'"),
    "no axis": (
        to('xyz="1.0 0.0 0.0" />\n  <dyn', 'xyz="0 0 0" />\n  <dyn'),
        "joint 'leg_1': xyz: expected a non-zero direction",
    ),
}
OF_SDF: dict[str, tuple[Change, str]] = {
    **{
        kind: (to('type="prismatic"', f'type="{kind}"'), f"joint 'leg_1': expected type .* got '{kind}'")
        for kind in ("screw", "gearbox", "revolute2")
    },
    "no frame": (to('expressed_in="__model__"', 'expressed_in="x"'), "joint 'base_1': xyz: frame 'x'"),
    "no base": (
        without('<joint name="fixed_base"', "</joint>"),
        "world: expected a fixed joint to the base, got none; add a fixed joint from the world to 'base'",
    ),
    "circle": (
        to('lower_1">\n    <pose>', 'lower_1"><pose relative_to="lower_1">'),
        "frame 'lower_1': expected poses that depend on no circle",
    ),
    "no ball": (without('<joint name="tip_3"', "</joint>"), "joint 'base_3' to body 'upper_3', where"),
    "another's include": (to('<link name="base">', INCLUDE), "include at line 10: expected a model"),
}
TABLES = {"mjcf": OF_MJCF, "sdf": OF_SDF, "urdf": OF_URDF}
BROKEN: dict[str, tuple[str, Change, str]] = {
    "USD": ("usd", to("x", "x"), "expected MJCF, SDF, or URDF, got USD, which is exported"),
    **{name: (form, *row) for form, rows in TABLES.items() for name, row in rows.items()},
    **{
        f"tool of {mass} kg, {form}": (
            form,
            with_tool(form, mass),
            f"body 'tool': expected a mass > 0, got {mass}",
        )
        for form, mass in itertools.product(WELDED, ("0",))
    },
}


@pytest.fixture(scope="module")
def exported() -> dict[str, ss.ExportedModel]:
    robot = ss.Robot.from_toml(HEXAPOD)
    with warnings.catch_warnings(record=True, action="always") as caught:
        found = {name: ss.export_model(robot, name) for name in ("mjcf", "sdf", "urdf", "usd")}
    friction, place = "friction of spherical joints (C_s)", "has no place in the format"
    lines = [
        f"mjcf: {friction} {place}: noted only, for import",
        f"mjcf: speed_limit {place}: noted only, for import",
        f"sdf: {friction} {place}: noted only, for import",
        f"usd: {friction} {place}: left out",
        f"usd: speed_limit {place}: left out",
    ]
    effect = r"(; forces differ by up to \S+ N, \S+ % of the largest, in motions about the home pose)?"
    assert [re.sub(rf"{effect}\Z", "", str(each.message)) for each in caught] == lines
    return found


@pytest.mark.parametrize("name", BROKEN)
def test_a_broken_model_gives_one_line_that_says_what_and_where(
    name: str, exported: dict[str, ss.ExportedModel], tmp_path: Path
) -> None:
    form, change, said = BROKEN[name]
    path = tmp_path / "model.xml"
    path.write_text(change(exported[form].text), encoding="utf-8")
    (tmp_path / "model.loops.json").write_text(exported["urdf"].loop_closures or "", encoding="utf-8")
    with pytest.raises(ValueError, match=r"model\.xml: ") as caught:
        ss.import_model(path)
    text = str(caught.value)
    assert said in text or re.search(said, text)
    assert "\n" not in text
    assert text.startswith(f"{path}: ")


LOOPS: dict[str, tuple[Change, str]] = {
    "no JSON": (instead("{"), "loops: expected JSON"),
    "unknown key": (to("gravity_m_s2", "gravity"), "unknown key"),
    "no link": (to('"upper_3"', '"upper_9"'), "loops: closure 3: link_1: link 'upper_9': missing"),
    "damping": (to('"damping_N_m_s": 0.02', '"damping_N_m_s": -1'), "expected a number >= 0"),
}


@pytest.mark.parametrize("name", LOOPS)
def test_broken_loops_of_urdf_are_one_line(
    name: str, exported: dict[str, ss.ExportedModel], tmp_path: Path
) -> None:
    change, said = LOOPS[name]
    path = tmp_path / "model.urdf"
    path.write_text(exported["urdf"].text, encoding="utf-8")
    (tmp_path / "model.loops.json").write_text(change(exported["urdf"].loop_closures or ""), encoding="utf-8")
    rejects(re.escape(said), ss.import_model, path)


def test_a_urdf_without_its_loops_says_where_they_are_looked_for(
    exported: dict[str, ss.ExportedModel], tmp_path: Path
) -> None:
    path = tmp_path / "model.urdf"
    balls = "<drake:ball_constraint>.*</drake:ball_constraint>"
    path.write_text(re.sub(balls, "", exported["urdf"].text, flags=re.DOTALL), encoding="utf-8")
    said = r"model\.urdf: loops: missing; add the file NAME\.loops\.json or elements drake:ball_constraint"
    rejects(said, ss.import_model, path)


@pytest.mark.parametrize("form", ["mjcf", "sdf", "urdf"])
def test_a_note_against_the_bodies_is_ignored_with_one_warning(
    form: str, exported: dict[str, ss.ExportedModel], tmp_path: Path
) -> None:
    path = tmp_path / "model.xml"
    text, count = re.subn(r'(mass="|<mass>|<mass value=")40\.0', r"\g<1>41.0", exported[form].text)
    assert count == 1
    path.write_text(text, encoding="utf-8")
    (tmp_path / "model.loops.json").write_text(exported["urdf"].loop_closures or "", encoding="utf-8")
    with pytest.warns(
        UserWarning, match=r"bodies and joints differ from the note \(platform.body.mass\)"
    ) as caught:
        found = ss.import_model(path)
    assert len(caught) == 1
    assert found.robot.M == 41.0
