"""Import of URDF, the format of ROS, and of its loops file: its elements become elements of SDF."""

import xml.etree.ElementTree as ET
from collections.abc import Collection
from dataclasses import replace

from ...io import toml_reader
from ...io.arguments import option
from ..model import WORLD, Joint, Model
from ..notes import json_table
from .sdf_in import Reader, ball_constraints
from .sdf_out import BALL
from .xml_text import TENSOR, added, at_line, name_of, others

_FILE_KEYS = ("generator", "gravity_m_s2", "closures", "armature_kg", "note")
_CLOSURE_KEYS = ("name", "type", "link_1", "point_1_m", "link_2", "point_2_m", "damping_N_m_s")
_IN_JOINT = ("origin", "parent", "child", "axis", "dynamics", "limit", "calibration")
_IN_ROBOT = ("link", "joint", "material", "transmission", BALL)
_NO_LOOPS = "friction of closures, armatures, and the note (the file NAME.loops.json is missing)"
_VERSION = (1, 9)
"""Version of SDF to which the elements are converted."""


def model(root: ET.Element, loops: str | None) -> Model:
    """Convert the contents of both files to a model; raise ValueError with a location on failure."""
    left_out = others(root, _IN_ROBOT, "the file")
    if loops is None and root.find(BALL) is None:
        raise ValueError(f"loops: missing; add the file NAME.loops.json or elements {BALL}")
    found = Reader(_as_sdf(root, left_out), _VERSION)
    table = toml_reader.checked_table(json_table(loops, "loops") or {}, "loops: ", _FILE_KEYS)
    armature = table.get("armature_kg", {})
    toml_reader.checked_table(armature, "loops: armature_kg: ", [joint.name for joint in found.joints])
    sizes = {name: toml_reader.not_negative(size, f"armature_kg: {name}") for name, size in armature.items()}
    joints = [replace(joint, armature=sizes.get(joint.name, 0.0)) for joint in found.joints]
    gravity = toml_reader.vector(table["gravity_m_s2"], "gravity_m_s2") if "gravity_m_s2" in table else None
    left_out += [*found.left_out, *([_NO_LOOPS] if loops is None else [])]
    if not isinstance(table.get("closures", []), list):
        raise ValueError("loops: closures: expected a list")
    stated = enumerate(table.get("closures", ()), 1)
    closures = [_closure(each, f"loops: closure {i}: ", found.placed) for i, each in stated]
    if "closures" not in table:
        closures = list(ball_constraints(found.element, found.placed))
    return Model(
        root.get("name", ""),
        gravity,
        tuple(found.bodies),
        (*joints, *closures),
        table.get("note"),
        tuple(left_out),
    )


def _closure(given: object, where: str, links: Collection[str]) -> Joint:
    """Read a loop closure from the loops file."""
    needed = ("link_1", "point_1_m", "link_2", "point_2_m")
    table = toml_reader.checked_table(given, where, _CLOSURE_KEYS, needed)
    kind = option(table.get("type", "spherical"), ("spherical", "fixed"), f"{where}type")
    one, other = (_known(table[key], f"{where}{key}", links) for key in ("link_1", "link_2"))
    points = [toml_reader.vector(table[key], f"{where}{key}") for key in ("point_1_m", "point_2_m")]
    damping = toml_reader.not_negative(table.get("damping_N_m_s", 0.0), f"{where}damping_N_m_s")
    name = str(table.get("name", where))
    return Joint(name, kind, one, other, points[1], damping=damping, cut=True, parent_point=points[0])


def _known(link: object, where: str, links: Collection[str]) -> str:
    """Return the name of a link; raise ValueError if it is missing."""
    if link not in links:
        raise ValueError(f"{where}: link {link or ''!r}: missing")
    return str(link)


def _as_sdf(root: ET.Element, left_out: list[str]) -> ET.Element:
    """Return the model in SDF with the same links, joints, and ball constraints; the root link is fixed."""
    for each in root.iter():
        if each.tag.startswith("xacro:"):
            raise ValueError(f"{each.tag}{at_line(each)}: xacro is not expanded; run xacro on the file first")
    links = {name_of(each, "robot"): each for each in root.findall("link")}
    carried: dict[str, ET.Element] = {}
    for each in root.findall("joint"):
        where = f"joint {name_of(each, 'robot')!r}"
        _known(_given(each, "parent/link"), f"{where}: parent", links)
        child = _known(_given(each, "child/link"), f"{where}: child", links)
        if child in carried:
            got = f"{carried[child].get('name')!r} and {each.get('name')!r}"
            raise ValueError(f"link {child!r}: expected one joint that carries it, got {got}")
        carried[child] = each
    roots = [name for name in links if name not in carried]
    if len(roots) != 1:
        got = ", ".join(map(repr, roots)) or "none"
        remedy = "; join them by fixed joints" if roots else ""
        raise ValueError(f"links without a parent joint: expected one, got {got}{remedy}")
    model = ET.Element("model", name=root.get("name", ""))
    if roots[0] != WORLD:
        fixed = added(model, "joint", name="base, fixed", type="fixed")
        added(fixed, "parent", WORLD)
        added(fixed, "child", roots[0])
    for name, link in links.items():
        if name != WORLD or name not in roots:
            _link(model, link, carried.get(name))
    for each in root.findall("joint"):
        _joint(model, each, left_out)
    for each in root.findall(BALL):
        ball = added(model, BALL)
        for end in each:
            added(ball, end.tag, end.get("name") or end.get("value"))
    return model


def _link(model: ET.Element, link: ET.Element, joint: ET.Element | None) -> None:
    """Add a link, which is at the origin of the joint that carries it; without an inertial it is massless."""
    element = added(model, "link", name=link.get("name"))
    if joint is not None:
        added(element, "pose", _origin(joint), relative_to=_given(joint, "parent/link"))
    if link.find("collision") is not None:
        added(element, "collision")
    given, inertial = link.find("inertial"), added(element, "inertial")
    if given is not None:
        added(inertial, "pose", _origin(given))
    inertia = added(inertial, "inertia")
    for key in ("mass", *TENSOR):
        text = "0" if given is None else _given(given, "mass/value" if key == "mass" else f"inertia/{key}")
        if not (text or "").strip():
            raise ValueError(f"link {link.get('name')!r}: inertial: {key}: expected a number, got nothing")
        added(inertial if key == "mass" else inertia, key, text)


def _joint(model: ET.Element, joint: ET.Element, left_out: list[str]) -> None:
    """Add a joint; the limits of a continuous joint do not apply."""
    name, kind = joint.get("name"), joint.get("type", "")
    element = added(model, "joint", name=name, type=kind)
    left_out += others(joint, _IN_JOINT, f"joint {name!r}")
    for end in ("parent", "child"):
        added(element, end, _given(joint, f"{end}/link"))
    axis = added(element, "axis")
    added(axis, "xyz", _given(joint, "axis/xyz") or "1 0 0")
    for tag in ("dynamics", "limit"):
        given = joint.find(tag)
        if given is not None and (tag, kind) != ("limit", "continuous"):
            inside = added(axis, tag)
            for key, value in given.items():
                added(inside, key, value)


def _origin(element: ET.Element) -> str:
    """Return position and roll, pitch, yaw of an element as text."""
    return " ".join(_given(element, f"origin/{key}") or "0 0 0" for key in ("xyz", "rpy"))


def _given(element: ET.Element, path: str) -> str | None:
    """Return an attribute of a child element at ``tag/attribute``, or None."""
    tag, _, key = path.partition("/")
    found = element.find(tag)
    return None if found is None else found.get(key)
