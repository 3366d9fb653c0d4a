"""Import of URDF, the format of ROS, and of its loops file."""

import xml.etree.ElementTree as ET
from collections.abc import Mapping
from dataclasses import replace
from functools import partial

import numpy as np

from ...io import toml_reader
from ...io.arguments import option
from ...io.array_types import Array
from ...motion.rotation import rotation_from_rpy
from ...robot.fields import direction
from ..model import WORLD, Body, Joint, Model, after
from ..notes import json_table
from .sdf_out import BALL
from .xml_text import (
    CONTACTS,
    at_line,
    ball_constraint,
    joint_of,
    name_of,
    number,
    numbers,
    others,
    tensor,
    with_properties,
)

_KINDS = {
    "prismatic": "prismatic",
    "revolute": "revolute",
    "continuous": "revolute",
    "fixed": "fixed",
    "floating": "free",
}
_ZERO = (0.0, 0.0, 0.0)
_FILE_KEYS = ("generator", "gravity_m_s2", "closures", "armature_kg", "note")
_CLOSURE_KEYS = ("name", "type", "link_1", "point_1_m", "link_2", "point_2_m", "damping_N_m_s")
_IN_JOINT = ("origin", "parent", "child", "axis", "dynamics", "limit", "calibration")
_IN_ROBOT = ("link", "joint", "material", "transmission", BALL)
_NO_LOOPS = "friction of closures, armatures, and the note (the file NAME.loops.json is missing)"


def model(root: ET.Element, loops: str | None) -> Model:
    """Convert the contents of both files to a model; raise ValueError with a location on failure."""
    left_out = others(root, _IN_ROBOT, "the file")
    bodies, joints = _tree(root, left_out)
    balls = root.findall(BALL)
    if loops is None and not balls:
        raise ValueError(f"loops: missing; add the file NAME.loops.json or elements {BALL}")
    table = toml_reader.checked_table(json_table(loops, "loops") or {}, "loops: ", _FILE_KEYS)
    if not isinstance(table.get("closures", []), list):
        raise ValueError("loops: closures: expected a list")
    names = {body.name for body in bodies}
    stated = enumerate(table.get("closures", ()), 1)
    closures = [_closure(each, f"loops: closure {i}: ", names) for i, each in stated]
    if "closures" not in table:
        closures = [ball_constraint(partial(_of_ball, each), i, names) for i, each in enumerate(balls, 1)]
    known = [joint.name for joint in joints]
    armature = toml_reader.checked_table(table.get("armature_kg", {}), "loops: armature_kg: ", known)
    for i, joint in enumerate(joints):
        if joint.name in armature:
            size = toml_reader.not_negative(armature[joint.name], f"armature_kg: {joint.name}")
            joints[i] = replace(joint, armature=size)
    gravity = toml_reader.vector(table["gravity_m_s2"], "gravity_m_s2") if "gravity_m_s2" in table else None
    left_out += [_NO_LOOPS] if loops is None else []
    left_out += [CONTACTS] if root.find("link/collision") is not None else []
    moving = (*joints, *closures)
    return Model(root.get("name", ""), gravity, tuple(bodies), moving, table.get("note"), tuple(left_out))


def _closure(given: object, where: str, names: set[str]) -> Joint:
    """Read a loop closure from the loops file."""
    needed = ("link_1", "point_1_m", "link_2", "point_2_m")
    table = toml_reader.checked_table(given, where, _CLOSURE_KEYS, needed)
    kind = option(table.get("type", "spherical"), ("spherical", "fixed"), f"{where}type")
    one, other = (_known(table[key], f"{where}{key}", names) for key in ("link_1", "link_2"))
    points = [toml_reader.vector(table[key], f"{where}{key}") for key in ("point_1_m", "point_2_m")]
    damping = toml_reader.not_negative(table.get("damping_N_m_s", 0.0), f"{where}damping_N_m_s")
    name = str(table.get("name", where))
    return Joint(name, kind, one, other, points[1], damping=damping, cut=True, parent_point=points[0])


def _of_ball(ball: ET.Element, key: str) -> str | None:
    """Return the name or the value of an element of a ball constraint."""
    return _given(ball, f"{BALL}_{key}/{'name' if key.startswith('body') else 'value'}")


def _known(link: object, where: str, names: set[str]) -> str:
    """Return the name of a link; raise ValueError if it is missing."""
    if link not in names:
        raise ValueError(f"{where}: link {link or ''!r}: missing")
    return str(link)


def _tree(root: ET.Element, left_out: list[str]) -> tuple[list[Body], list[Joint]]:
    """Return bodies, each after its carrier, and joints; the root link is the world or fixed to it."""
    for each in root.iter():
        if each.tag.startswith("xacro:"):
            raise ValueError(f"{each.tag}{at_line(each)}: xacro is not expanded; run xacro on the file first")
    links = {name_of(each, "robot"): each for each in root.findall("link")}
    carried: dict[str, ET.Element] = {}
    for each in root.findall("joint"):
        where = f"joint {name_of(each, 'robot')!r}"
        for end in ("parent", "child"):
            _known(_end(each, end), f"{where}: {end}", set(links))
        child = _end(each, "child")
        if child in carried:
            got = f"{carried[child].get('name')!r} and {each.get('name')!r}"
            raise ValueError(f"link {child!r}: expected one joint that carries it, got {got}")
        carried[child] = each
    roots = [name for name in links if name not in carried]
    if len(roots) != 1:
        got = ", ".join(map(repr, roots)) or "none"
        remedy = "; join them by fixed joints" if roots else ""
        raise ValueError(f"links without a parent joint: expected one, got {got}{remedy}")
    body = _body(links[roots[0]], np.eye(3), np.zeros(3))
    bodies, found = {body.name: body}, {}
    waiting = list(carried.values())
    while ready := [each for each in waiting if _end(each, "parent") in bodies]:
        for each in ready:
            body, joint = _carried(each, links, bodies[_end(each, "parent")], left_out)
            bodies[body.name], found[joint.child] = body, joint
        waiting = [each for each in waiting if each not in ready]
    if waiting:
        raise ValueError(f"joint {waiting[0].get('name')!r}: expected a tree, got a circle")
    joints = [found[_end(each, "child")] for each in root.findall("joint")]
    if roots[0] == WORLD:
        return list(bodies.values()), joints
    return [Body(WORLD), *bodies.values()], [Joint("base, fixed", "fixed", WORLD, roots[0]), *joints]


def _carried(
    element: ET.Element, links: Mapping[str, ET.Element], parent: Body, left_out: list[str]
) -> tuple[Body, Joint]:
    """Return a link with the joint that carries it."""
    joint = joint_of(element, _KINDS)
    where, child = f"joint {joint.name!r}", _end(element, "child")
    left_out += others(element, _IN_JOINT, where)
    R, t = after((parent.R, parent.t), *_origin(element, where))
    joint = replace(joint, parent=parent.name, child=child)
    body = _body(links[child], R, t)
    if joint.kind in ("fixed", "free"):
        return body, joint
    local = numbers(_given(element, "axis/xyz"), 3, f"{where}: axis", (1.0, 0.0, 0.0))
    joint = replace(joint, axes=(R @ direction(local, f"{where}: axis"))[None])
    if element.get("type") == "continuous" and (limit := element.find("limit")) is not None:
        element.remove(limit)
    return body, with_properties(joint, partial(_given, element), left_out)


def _given(element: ET.Element, path: str) -> str | None:
    """Return an attribute of a child element at ``tag/attribute``, or None."""
    tag, _, key = path.partition("/")
    found = element.find(tag)
    return None if found is None else found.get(key)


def _body(link: ET.Element, R: Array, t: Array) -> Body:
    """Return the body of a link."""
    name = link.attrib["name"]
    given = link.find("inertial")
    if given is None:
        return Body(name, R, t)
    where = f"link {name!r}: inertial"
    turn, center = _origin(given, where)
    found = tensor(lambda key: _given(given, f"inertia/{key}"), where)
    mass = number(_given(given, "mass/value"), f"{where}: mass")
    return Body(name, R, t, mass, center, turn @ found @ turn.T)


def _origin(element: ET.Element, where: str) -> tuple[Array, Array]:
    """Return orientation, shape (3, 3), and position, shape (3,), of an element."""
    angles = numbers(_given(element, "origin/rpy"), 3, f"{where}: rpy", _ZERO)
    return rotation_from_rpy(angles), numbers(_given(element, "origin/xyz"), 3, f"{where}: xyz", _ZERO)


def _end(joint: ET.Element, end: str) -> str:
    """Return the name of the parent or child link of a joint."""
    return _given(joint, f"{end}/link") or ""
