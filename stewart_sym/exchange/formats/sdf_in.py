"""Import of SDF, the format of Gazebo, to which the importer of URDF converts its elements."""

import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Collection, Iterator
from dataclasses import replace

import numpy as np

from ...io.arguments import shown
from ...io.array_types import Array
from ...motion.rotation import rotation_from_quaternion, rotation_from_rpy
from ...robot.fields import LEGS, direction
from ..model import WORLD, Body, Joint, Model
from ..notes import json_table
from .sdf_out import BALL, NOTE, SPACE
from .xml_text import CONTACTS, NO_LIMIT, TENSOR, at_line, name_of, numbers, others, turn_limits

_KINDS = {
    "prismatic": "prismatic",
    "revolute": "revolute",
    "continuous": "revolute",
    "universal": "universal",
    "ball": "spherical",
    "fixed": "fixed",
    "floating": "free",
}
# Default of the element <gravity> of a world, m/s^2.
_GRAVITY = "0 0 -9.8"
_IN_LINK = ("pose", "inertial", "visual", "collision", "sensor", "light", "gravity", "must_be_base_link")
_IN_INERTIAL = ("pose", "mass", "inertia")
_IN_JOINT = ("parent", "child", "pose", "axis", "axis2", "sensor")
_IN_AXIS = ("xyz", "dynamics", "limit", "use_parent_model_frame")
_AXES = {"prismatic": ("axis",), "revolute": ("axis",), "universal": ("axis", "axis2")}
"""Elements with the axes of a joint by its kind."""
_TRUE = ("true", "True", "TRUE", "1")
_AXES_OF_MODEL, _NAMED_FRAMES = (1, 4), (1, 6)
"""Last versions with axes in the frame of the model, and with the old names of frames.

Up to the second version, poses have ``frame`` and axes may have ``use_parent_model_frame``.
"""
_MODEL = "__model__"

Pose = tuple[Array, Array]
"""Orientation, shape (3, 3), and position, shape (3,)."""


def model(root: ET.Element) -> Model:
    """Convert the elements of a file to a model; raise ValueError with a location on failure."""
    world = root.find("world")
    models = [*root.findall("model"), *root.findall("world/model")]
    for inside in (root, world, *models):
        for each in () if inside is None else inside:
            if each.tag == "include" or (each.tag == "model" and inside in models):
                got = shown(each.get("name") or each.findtext("uri", "").strip())
                raise ValueError(f"{each.tag}{at_line(each)}: expected a model in the file itself, got {got}")
    if len(models) != 1:
        names = ", ".join(repr(each.get("name", "")) for each in models[:LEGS]) or "none"
        raise ValueError(f"expected one model, got {len(models)}: {names}")
    gravity = None if world is None else _value(world, "gravity") or _GRAVITY
    found = Reader(models[0], _version(root))
    return Model(
        models[0].get("name", ""),
        None if gravity is None else numbers(gravity, 3, "gravity"),
        tuple(found.bodies),
        (*found.joints, *ball_constraints(models[0], found.placed)),
        json_table(_note(root, models[0]), NOTE),
        tuple(found.left_out),
        found.assumed,
    )


def ball_constraints(element: ET.Element, links: Collection[str]) -> Iterator[Joint]:
    """Yield the loop closures by the ball constraints of Drake, which have no names."""
    for i, ball in enumerate(element.findall(BALL), 1):
        where = f"ball_constraint {i}"
        one, other = (_value(ball, f"{BALL}_body_{end}") or "" for end in "AB")
        for link in (one, other):
            if link not in links:
                raise ValueError(f"{where}: link {link!r}: missing")
        texts = ((key, _value(ball, f"{BALL}_p_{key}")) for key in ("AP", "BQ"))
        here, there = (numbers(text, 3, f"{where}: p_{key}") for key, text in texts)
        yield Joint(f"ball_constraint_{i}", "spherical", one, other, there, cut=True, parent_point=here)


def _version(root: ET.Element) -> tuple[int, ...]:
    """Return the version of the format, which determines the frames of poses and axes."""
    text = root.get("version", "")
    if not re.fullmatch(r"1\.\d{1,4}(\.\d+)*", text):
        got = shown(text) if text else "none"
        raise ValueError(f"sdf: version: expected one such as 1.9, got {got}")
    return tuple(int(word) for word in text.split(".")[:2])


def _note(root: ET.Element, model: ET.Element) -> str | None:
    """Return the text of the note, for any prefix of their namespace."""
    names = [key.partition(":")[2] for each in root.iter() for key in each.attrib if each.get(key) == SPACE]
    found = (model.findtext(f"{name}:note" if name else "note") for name in names)
    return next((text for text in found if text is not None), None)


class Reader:
    """Reader of the bodies and joints of one model."""

    def __init__(self, element: ET.Element, version: tuple[int, ...]) -> None:
        """Read all bodies and joints."""
        self.element, self.version = element, version
        where = f"model {element.get('name', '')!r}"
        if element.get("placement_frame") or self._frame(element, where) not in ("", WORLD):
            raise ValueError(
                f"{where}: expected one that its own frame places in the world, got another frame"
            )
        if _is_true(element.findtext("static")):
            raise ValueError(f"{where}: static: expected a model that moves, got a static one")
        # Links have priority, because a joint of URDF may have the name of a link.
        self.named = {
            name_of(each, "model"): each
            for tag in ("joint", "frame", "link")
            for each in element.findall(tag)
        }
        self.found: dict[str, Pose] = {_MODEL: self._own(element, "model"), WORLD: (np.eye(3), np.zeros(3))}
        self.left_out: list[str] = []
        self.assumed: dict[str, str] = {}
        self.bodies = [Body(WORLD), *(self._body(each) for each in element.findall("link"))]
        self.placed = {body.name: body for body in self.bodies}
        self.joints = [self._joint(each) for each in element.findall("joint")]
        self.left_out += [CONTACTS] if element.find("link/collision") is not None else []

    def _own(self, element: ET.Element, where: str) -> Pose:
        """Return orientation and position in the pose of an element."""
        pose = element.find("pose")
        if pose is None or not (pose.text or "").strip():
            return np.eye(3), np.zeros(3)
        unit = np.pi / 180.0 if pose.get("degrees") in ("true", "1") else 1.0
        if pose.get("rotation_format", "euler_rpy") == "quat_xyzw":
            values = numbers(pose.text, 7, f"{where}: pose")
            return rotation_from_quaternion(values[[6, 3, 4, 5]]), values[:3]
        values = numbers(pose.text, 6, f"{where}: pose")
        return rotation_from_rpy(unit * values[3:]), values[:3]

    def _pose(self, name: str, seen: tuple[str, ...] = ()) -> Pose:
        """Return orientation and position of a link, joint, or frame in the world frame."""
        if name not in self.found:
            if name not in self.named:
                where = f"{self.named[seen[-1]].tag} {seen[-1]!r}: " if seen else ""
                raise ValueError(f"{where}frame {name!r}: missing")
            if name in seen:
                raise ValueError(f"frame {name!r}: expected poses that depend on no circle, got one")
            self.found[name] = self._placed(self.named[name], (*seen, name))
        return self.found[name]

    def _placed(self, element: ET.Element, seen: tuple[str, ...] = ()) -> Pose:
        """Return orientation and position of an element in the world frame."""
        where = f"{element.tag} {element.get('name')!r}"
        frame = self._frame(element, where)
        if not frame and element.tag == "joint":
            frame = _text(element, "child")
        R, t = self._pose(frame or element.get("attached_to") or _MODEL, seen)
        turn, place = self._own(element, where)
        return R @ turn, t + R @ place

    def _frame(self, element: ET.Element, where: str) -> str:
        """Return the stated frame of the pose of an element, or an empty string without one."""
        pose = element.find("pose")
        if pose is None:
            return ""
        if pose.get("frame") and self.version > _NAMED_FRAMES:
            raise ValueError(
                f"{where}: pose: expected relative_to, as frame is called since SDF 1.7, got frame"
            )
        return pose.get("relative_to") or pose.get("frame") or ""

    def _body(self, link: ET.Element) -> Body:
        """Create the body of a link."""
        name = link.attrib["name"]
        where, (R, t) = f"link {name!r}", self._pose(name)
        self.left_out += others(link, _IN_LINK, where)
        if _value(link, "gravity") in ("false", "0"):
            self.left_out.append(f"that {where} has no weight")
        given = link.find("inertial")
        given = ET.Element("inertial") if given is None else given
        where = f"{where}: inertial"
        self.left_out += others(given, _IN_INERTIAL, where)
        if self._frame(given, where):
            raise ValueError(f"{where}: pose: expected one in the frame of the link, got another frame")
        self._assume(given, name, where)
        turn, center = self._own(given, where)
        (mass,) = numbers(_value(given, "mass"), 1, f"{where}: mass", [1.0])
        inertia = np.zeros((3, 3))
        for key, (i, j) in TENSOR.items():
            text = _value(given, f"inertia/{key}")
            inertia[i, j] = inertia[j, i] = numbers(text, 1, f"{where}: {key}", [float(i == j)])[0]
        return Body(name, R, t, float(mass), center, turn @ inertia @ turn.T)

    def _assume(self, given: ET.Element, name: str, where: str) -> None:
        """Record default values for missing values of an inertial."""
        paths = ("mass", "inertia/ixx", "inertia/iyy", "inertia/izz")
        missing = ", ".join(path.rpartition("/")[2] for path in paths if _value(given, path) is None)
        auto = _is_true(given.get("auto"))
        if missing and auto:
            remedy = "write what gz sdf -p --expand-auto-inertials prints"
            raise ValueError(f"{where}: expected mass and inertia, got auto, which is not computed; {remedy}")
        if missing:
            text = f"{missing}: not in the file, SDF's default is taken (1 kg, 1 kg m^2)"
            self.assumed[name] = f"{where}: {text}"
        if auto:
            self.left_out.append(
                f"auto of link {name!r}: the mass and inertia that its inertial states are taken"
            )

    def _joint(self, element: ET.Element) -> Joint:
        """Create a joint."""
        name, kind = name_of(element, "joint"), element.get("type", "")
        where = f"joint {name!r}"
        if kind not in _KINDS:
            raise ValueError(f"{where}: expected type {', '.join(_KINDS)}, got {kind!r}")
        parent, child = (self._link(_text(element, end), where) for end in ("parent", "child"))
        place = self.placed[child].local(self._placed(element)[1])
        joint = Joint(name, _KINDS[kind], parent, child, place)
        self.left_out += others(element, _IN_JOINT, where)
        turned = [self._axis(joint, element, tag, where) for tag in _AXES.get(joint.kind, ())]
        if len({each.damping for each in turned}) > 1:
            got = ", ".join(f"{each.damping:g}" for each in turned)
            raise ValueError(f"{where}: expected the same damping about both axes, got {got}")
        return replace(turned[0], axes=np.concatenate([each.axes for each in turned])) if turned else joint

    def _link(self, name: str, where: str) -> str:
        """Return the link that a frame is fixed to, because joints may refer to frames since SDF 1.7."""
        first, seen = name, set()
        while name not in self.placed:
            element = self.named.get(name)
            unknown = element is None and name != _MODEL
            if self.version <= _NAMED_FRAMES or name in seen or unknown:
                raise ValueError(f"{where}: link {first!r}: missing")
            seen.add(name)
            if element is None:
                name = self.element.get("canonical_link") or self.bodies[1].name
            elif element.tag == "joint":
                name = _text(element, "child")
            else:
                name = element.get("attached_to") or _MODEL
        return name

    def _axis(self, joint: Joint, element: ET.Element, tag: str, where: str) -> Joint:
        """Return the joint with one of its axes, and the damping, limits, and spring at this axis."""
        axis = element.find(tag)
        if axis is None:
            raise ValueError(f"{where}: expected an axis for each turn, got none")
        frame = self._expressed_in(axis, where)
        local = numbers(_value(axis, "xyz"), 3, f"{where}: xyz", (0.0, 0.0, 1.0))
        if frame and frame not in self.named and frame not in self.found:
            raise ValueError(f"{where}: xyz: frame {frame!r}: missing")
        R, _ = self._pose(frame) if frame else self._placed(element)
        self.left_out += others(axis, _IN_AXIS, where)
        return self._with_properties(replace(joint, axes=(R @ direction(local, f"{where}: xyz"))[None]), axis)

    def _expressed_in(self, axis: ET.Element, where: str) -> str:
        """Return the frame of an axis, or an empty string for the frame of its joint."""
        xyz, of_model = axis.find("xyz"), _value(axis, "use_parent_model_frame")
        if xyz is not None and xyz.get("expressed_in"):
            return xyz.get("expressed_in", "")
        if of_model is None:
            return _MODEL if self.version <= _AXES_OF_MODEL else ""
        if self.version > _NAMED_FRAMES:
            raise ValueError(
                f"{where}: axis: expected expressed_in, as SDF has it since 1.7, got use_parent_model_frame"
            )
        return _MODEL if _is_true(of_model) else ""

    def _with_properties(self, joint: Joint, axis: ET.Element) -> Joint:
        """Return a joint with damping, limits, and spring at its axis, and record its other properties."""
        where = f"joint {joint.name!r}"

        def value(path: str, default: float) -> float:
            place = f"{where}: {path.partition('/')[2]}"
            return float(numbers(_value(axis, path), 1, place, [default], finite=False)[0])

        friction, spring = value("dynamics/friction", 0.0), value("dynamics/spring_stiffness", 0.0)
        found = (("friction", friction), ("spring_stiffness", spring))
        self.left_out += [f"{key} {size:g} of {where}" for key, size in found if size]
        low, high = (value(f"limit/{key}", sign * np.inf) for key, sign in (("lower", -1.0), ("upper", 1.0)))
        low, high = (each if abs(each) < NO_LIMIT else math.copysign(math.inf, each) for each in (low, high))
        turn = spring * value("dynamics/spring_reference", 0.0) * joint.axes[0]
        joint = replace(joint, damping=value("dynamics/damping", 0.0))
        if joint.kind != "prismatic":
            self.left_out += turn_limits((low, high), where)
            return replace(joint, load=np.append(np.zeros(3), turn))
        drive = {key: value(f"limit/{key}", NO_LIMIT) for key in ("effort", "velocity")}
        none = [key for key, size in drive.items() if size == 0.0]
        self.left_out += [f"limit {key} 0, taken as none, of {where}" for key in none]
        effort, speed = (size if 0.0 < size < NO_LIMIT else math.inf for size in drive.values())
        load = np.append(turn, np.zeros(3))
        return replace(joint, limits=(low, high), effort=effort, speed=speed, load=load)


def _value(element: ET.Element, path: str = ".") -> str | None:
    """Return the text of an element, or None if it is missing or empty and has its default."""
    text = (element.text if path == "." else element.findtext(path)) or ""
    return text if text.strip() else None


def _is_true(text: str | None) -> bool:
    """Return True for a text that means true."""
    return (text or "").strip() in _TRUE


def _text(element: ET.Element, tag: str) -> str:
    """Return the text of a child element; raise ValueError if it is missing."""
    found = (element.findtext(tag) or "").strip()
    if not found:
        raise ValueError(f"joint {element.get('name')!r}: {tag}: missing")
    return found
