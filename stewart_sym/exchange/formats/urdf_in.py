"""Import of URDF, the format of ROS, and of its loops file."""

import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

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
    at_line,
    interval,
    joint_of,
    largest,
    name_of,
    no_limits,
    number,
    numbers,
    tensor,
    turn_limits,
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


def model(root: ET.Element, loops: str | None) -> Model:
    """Convert the contents of both files to a model; raise ValueError with a location on failure."""
    apart = _apart_from_world(root)
    bodies, joints = _tree(root)
    balls = root.findall(BALL)
    if loops is None and not balls:
        raise ValueError(f"loops: missing; add the file NAME.loops.json or elements {BALL}")
    given = {} if loops is None else _loops(loops)
    names = {body.name for body in bodies}
    closures = [_closure(each, i, names, apart) for i, each in enumerate(given.get("closures", ()), 1)]
    if "closures" not in given:
        closures = [_ball(each, i, names, apart) for i, each in enumerate(balls, 1)]
    known = [joint.name for joint in joints]
    armature = toml_reader.checked_table(given.get("armature_kg", {}), "loops: armature_kg: ", known)
    joints = [
        replace(joint, armature=toml_reader.not_negative(armature[joint.name], f"armature_kg: {joint.name}"))
        if joint.name in armature
        else joint
        for joint in joints
    ]
    gravity = toml_reader.vector(given["gravity_m_s2"], "gravity_m_s2") if "gravity_m_s2" in given else None
    left_out = tuple(_left_out(root))
    if loops is None:
        left_out += ("friction of closures, armatures, and the note (the file NAME.loops.json is missing)",)
    moving = (*joints, *closures)
    return Model(root.get("name", ""), gravity, tuple(bodies), moving, given.get("note"), left_out)


def _apart_from_world(root: ET.Element) -> dict[str, str]:
    """Rename a carried link with the name of the world; return the new name by the old name."""
    children = root.findall("joint/child")
    ends = [*root.findall("joint/parent"), *children]
    if WORLD not in (child.get("link") for child in children):
        return {}
    links, name = root.findall("link"), f"link {WORLD}"
    while name in (link.get("name") for link in links):
        name += "'"
    for key, elements in (("name", links), ("link", ends)):
        for each in elements:
            if each.get(key) == WORLD:
                each.set(key, name)
    return {WORLD: name}


def _left_out(root: ET.Element) -> Iterator[str]:
    """Yield contents of the file that a model cannot represent."""
    if root.find("gazebo") is not None:
        yield "section 'gazebo' of the file"
    for each in root.findall("joint"):
        where, dynamics = f"joint {each.get('name')!r}", each.find("dynamics")
        if each.find("mimic") is not None:
            yield f"mimic of {where}"
        if dynamics is not None and number(dynamics.get("friction"), f"{where}: friction", 0.0):
            yield f"friction of {where}"
        limit, kind = each.find("limit"), each.get("type")
        if limit is not None and kind == "prismatic":
            yield from no_limits(limit.attrib, where)
        if limit is not None and kind == "revolute":
            yield from turn_limits(interval(limit.get("lower"), limit.get("upper"), where), where)


def _loops(text: str) -> dict[str, Any]:
    """Check the tables of the loops file."""
    found = toml_reader.checked_table(json_table(text, "loops"), "loops: ", _FILE_KEYS)
    if not isinstance(found.get("closures", []), list):
        raise ValueError("loops: closures: expected a list")
    if not isinstance(found.get("note", {}), dict):
        raise ValueError("loops: note: expected a table")
    return found


def _closure(given: object, number_: int, names: set[str], apart: dict[str, str]) -> Joint:
    """Read a loop closure from the loops file."""
    where = f"loops: closure {number_}: "
    table = toml_reader.checked_table(
        given, where, _CLOSURE_KEYS, ("link_1", "point_1_m", "link_2", "point_2_m")
    )
    kind = option(table.get("type", "spherical"), ("spherical", "fixed"), f"{where}type")
    for key in ("link_1", "link_2"):
        table = {**table, key: apart.get(str(table[key]), table[key])}
        if table[key] not in names:
            raise ValueError(f"{where}{key}: link {table[key]!r}: missing")
    return Joint(
        str(table.get("name", f"closure {number_}")),
        kind,
        table["link_1"],
        table["link_2"],
        toml_reader.vector(table["point_2_m"], f"{where}point_2_m"),
        damping=toml_reader.not_negative(table.get("damping_N_m_s", 0.0), f"{where}damping_N_m_s"),
        cut=True,
        parent_point=toml_reader.vector(table["point_1_m"], f"{where}point_1_m"),
    )


def _ball(given: ET.Element, number_: int, names: set[str], apart: dict[str, str]) -> Joint:
    """Read a ball constraint of Drake, which has no name."""
    where, ends, points = f"{BALL} {number_}", [], []
    for body, point in (("body_A", "p_AP"), ("body_B", "p_BQ")):
        found = {key: given.find(f"{BALL}_{key}") for key in (body, point)}
        name, place = (
            None if each is None else each.get(key)
            for each, key in zip(found.values(), ("name", "value"), strict=True)
        )
        name = apart.get(name or "", name or "")
        if name not in names:
            raise ValueError(f"{where}: link {name!r}: missing")
        ends.append(name)
        points.append(numbers(place, 3, f"{where}: {point}"))
    one, other = ends
    return Joint(
        f"ball_constraint_{number_}", "spherical", one, other, points[1], cut=True, parent_point=points[0]
    )


def _tree(root: ET.Element) -> tuple[list[Body], list[Joint]]:
    """Return bodies, each after its carrier, and joints; the root link is the world or fixed to it."""
    for each in root.iter():
        if each.tag.startswith("xacro:"):
            where = f"{each.tag}{at_line(each)}"
            raise ValueError(f"{where}: xacro is not expanded; run xacro on the file first")
    links = {name_of(each, "robot"): each for each in root.findall("link")}
    carried: dict[str, ET.Element] = {}
    for each in root.findall("joint"):
        name = name_of(each, "robot")
        for end in ("parent", "child"):
            if _end(each, end) not in links:
                what = f"link {_end(each, end)!r}" if _end(each, end) else "its link"
                raise ValueError(f"joint {name!r}: {end}: {what}: missing")
        child = _end(each, "child")
        if child in carried:
            got = f"{carried[child].get('name')!r} and {name!r}"
            raise ValueError(f"link {child!r}: expected one joint that carries it, got {got}")
        carried[child] = each
    roots = [name for name in links if name not in carried]
    if len(roots) != 1:
        got = ", ".join(map(repr, roots)) or "none"
        raise ValueError(f"links without a parent joint: expected one, got {got}")
    (root_name,) = roots
    placed = {root_name: _body(links[root_name], np.eye(3), np.zeros(3))}
    bodies, joints = list(placed.values()), []
    if root_name != WORLD:
        bodies.insert(0, Body(WORLD))
        joints.append(Joint(f"{root_name}, fixed", "fixed", WORLD, root_name))
    waiting = list(carried.values())
    while waiting:
        ready = [each for each in waiting if _end(each, "parent") in placed]
        if not ready:
            raise ValueError(f"joint {waiting[0].get('name')!r}: expected a tree, got a circle")
        for each in ready:
            body, joint = _carried(each, links, placed[_end(each, "parent")])
            placed[body.name] = body
            bodies.append(body)
            joints.append(joint)
        waiting = [each for each in waiting if each not in ready]
    order = [each.get("name") for each in root.findall("joint")]
    return bodies, sorted(joints, key=lambda joint: order.index(joint.name) if joint.name in order else -1)


def _carried(element: ET.Element, links: dict[str, ET.Element], parent: Body) -> tuple[Body, Joint]:
    """Return a link with the joint that carries it."""
    name, kind, where = joint_of(element, _KINDS)
    turn, place = _origin(element, where)
    R, t = after((parent.R, parent.t), turn, place)
    child = _end(element, "child")
    body = _body(links[child], R, t)
    dynamics = element.find("dynamics")
    damping = 0.0 if dynamics is None else number(dynamics.get("damping"), f"{where}: damping", 0.0)
    joint = Joint(name, _KINDS[kind], parent.name, child, damping=damping)
    if joint.kind in ("fixed", "free"):
        return body, joint
    axis = element.find("axis")
    local = numbers(None if axis is None else axis.get("xyz"), 3, f"{where}: axis", (1.0, 0.0, 0.0))
    limit = element.find("limit")
    joint = replace(joint, axes=(R @ direction(local, f"{where}: axis"))[None])
    if limit is None or kind != "prismatic":
        return body, joint
    return body, replace(
        joint,
        limits=interval(limit.get("lower"), limit.get("upper"), where),
        effort=largest(limit.get("effort"), f"{where}: effort"),
        speed=largest(limit.get("velocity"), f"{where}: velocity"),
    )


def _body(link: ET.Element, R: Array, t: Array) -> Body:
    """Return the body of a link."""
    name = link.attrib["name"]
    given = link.find("inertial")
    if given is None:
        return Body(name, R, t)
    where = f"link {name!r}: inertial"
    turn, center = _origin(given, where)
    mass, inertia = given.find("mass"), given.find("inertia")
    found = tensor(ET.Element("none").get if inertia is None else inertia.get, where)
    heavy = number(None if mass is None else mass.get("value"), f"{where}: mass")
    return Body(name, R, t, heavy, center, turn @ found @ turn.T)


def _origin(element: ET.Element, where: str) -> tuple[Array, Array]:
    """Return orientation, shape (3, 3), and position, shape (3,), of an element."""
    origin = element.find("origin")
    if origin is None:
        return np.eye(3), np.zeros(3)
    angles = numbers(origin.get("rpy"), 3, f"{where}: rpy", _ZERO)
    R = rotation_from_rpy(angles) if angles.any() else np.eye(3)
    return R, numbers(origin.get("xyz"), 3, f"{where}: xyz", _ZERO)


def _end(joint: ET.Element, end: str) -> str:
    """Return the name of the parent or child link of a joint."""
    found = joint.find(end)
    return "" if found is None else found.get("link", "")
