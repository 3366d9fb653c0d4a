"""Import of SDF, the format of Gazebo."""

import re
import xml.etree.ElementTree as ET
from dataclasses import replace
from functools import partial

import numpy as np

from ...io.arguments import shown
from ...io.array_types import Array
from ...motion.rotation import rotation_from_quaternion, rotation_from_rpy
from ...robot.fields import LEGS, direction
from ..model import WORLD, Body, Joint, Model, after
from ..notes import json_table
from .sdf_out import BALL, NOTE, SPACE
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
    "universal": "universal",
    "ball": "spherical",
    "fixed": "fixed",
}
# Default of the element <gravity> of a world, m/s^2.
_GRAVITY = "0 0 -9.8"
_IN_LINK = ("pose", "inertial", "visual", "collision", "sensor", "light", "gravity", "must_be_base_link")
_IN_INERTIAL = ("pose", "mass", "inertia")
_IN_JOINT = ("parent", "child", "pose", "axis", "axis2", "sensor")
_IN_AXIS = ("xyz", "dynamics", "limit", "use_parent_model_frame")
_AXES = {"prismatic": 1, "revolute": 1, "universal": 2}
"""Number of axes of a joint by its kind."""
_TRUE = ("true", "True", "TRUE", "1")
_AXES_OF_MODEL, _NAMED_FRAMES = (1, 4), (1, 6)
"""Last versions with axes in the frame of the model, and with the old names of frames.

Up to the second version, poses have ``frame`` and axes may have ``use_parent_model_frame``.
"""


def model(root: ET.Element) -> Model:
    """Convert the elements of a file to a model; raise ValueError with a location on failure."""
    world = root.find("world")
    models = [*root.findall("model"), *root.findall("world/model")]
    for tag in ("include", "world/include"):
        for each in root.findall(tag):
            got = shown(each.findtext("uri", "").strip())
            raise ValueError(f"include{at_line(each)}: expected a model in the file itself, got {got}")
    if len(models) != 1:
        names = ", ".join(repr(each.get("name", "")) for each in models[:LEGS]) or "none"
        raise ValueError(f"expected one model, got {len(models)}: {names}")
    gravity = None if world is None else _value(world, "gravity") or _GRAVITY
    found = _Reader(models[0], _version(root))
    return Model(
        models[0].get("name", ""),
        None if gravity is None else numbers(gravity, 3, "gravity"),
        tuple(found.bodies),
        tuple(found.joints),
        json_table(_note(root, models[0]), NOTE),
        tuple(found.left_out),
        found.assumed,
        unstated=("C_s", "C_u", "drive"),
    )


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


class _Reader:
    """Reader of the bodies and joints of one model."""

    def __init__(self, element: ET.Element, version: tuple[int, ...]) -> None:
        """Read all bodies and joints."""
        for tag in ("model", "include"):
            for each in element.findall(tag):
                got = shown(each.get("name") or each.findtext("uri", "").strip())
                raise ValueError(f"{tag}{at_line(each)}: expected a model without models in it, got {got}")
        self.element, self.version = element, version
        where = f"model {element.get('name', '')!r}"
        if element.get("placement_frame") or self._frame(element, where) not in ("", WORLD):
            raise ValueError(
                f"{where}: expected one that its own frame places in the world, got another frame"
            )
        self.named = {
            name_of(each, "model"): each
            for tag in ("link", "frame", "joint")
            for each in element.findall(tag)
        }
        self.found: dict[str, tuple[Array, Array]] = {
            "__model__": self._own(element, "model"),
            WORLD: _still(),
        }
        self.left_out: list[str] = []
        self.assumed: dict[str, str] = {}
        self.bodies = [Body(WORLD), *(self._body(each) for each in element.findall("link"))]
        self.placed = {body.name: body for body in self.bodies}
        if _is_true(element.findtext("static")):
            raise ValueError(f"{where}: static: expected a model that moves, got a static one")
        self.joints = [self._joint(each) for each in element.findall("joint")]
        for i, each in enumerate(element.findall(BALL), 1):
            self.joints.append(ball_constraint(partial(_of_ball, each), i, self.placed))
        self.left_out += [CONTACTS] if element.find("link/collision") is not None else []

    def _own(self, element: ET.Element, where: str) -> tuple[Array, Array]:
        """Return orientation and position in the pose of an element."""
        pose = element.find("pose")
        if pose is None or not (pose.text or "").strip():
            return _still()
        unit = np.pi / 180.0 if pose.get("degrees") in ("true", "1") else 1.0
        if pose.get("rotation_format", "euler_rpy") == "quat_xyzw":
            values = numbers(pose.text, 7, f"{where}: pose")
            return rotation_from_quaternion(values[[6, 3, 4, 5]]), values[:3]
        values = numbers(pose.text, 6, f"{where}: pose")
        return rotation_from_rpy(unit * values[3:]), values[:3]

    def _pose(self, name: str, seen: tuple[str, ...] = ()) -> tuple[Array, Array]:
        """Return orientation and position of a link, joint, or frame in the world frame."""
        if name in self.found:
            return self.found[name]
        if name not in self.named:
            where = f"{self.named[seen[-1]].tag} {seen[-1]!r}: " if seen else ""
            raise ValueError(f"{where}frame {name!r}: missing")
        if name in seen or len(seen) > 100:
            raise ValueError(f"frame {name!r}: expected poses that depend on no circle, got one")
        element = self.named[name]
        R, t = self._own(element, f"{element.tag} {name!r}")
        R, t = after(self._pose(self._relative(element), (*seen, name)), R, t)
        self.found[name] = R, t
        return R, t

    def _frame(self, element: ET.Element, where: str) -> str:
        """Return the frame of the pose of an element, or an empty string without one."""
        pose = element.find("pose")
        if pose is None:
            return ""
        if pose.get("frame") and self.version > _NAMED_FRAMES:
            raise ValueError(
                f"{where}: pose: expected relative_to, as frame is called since SDF 1.7, got frame"
            )
        return pose.get("relative_to") or pose.get("frame") or ""

    def _relative(self, element: ET.Element) -> str:
        """Return the frame of the pose of an element, with the default for its type."""
        stated = self._frame(element, f"{element.tag} {element.get('name')!r}")
        if stated:
            return stated
        if element.tag == "joint":
            return _text(element, "child")
        return element.get("attached_to") or "__model__" if element.tag == "frame" else "__model__"

    def _body(self, link: ET.Element) -> Body:
        """Create the body of a link."""
        name = link.attrib["name"]
        where, (R, t) = f"link {name!r}", self._pose(name)
        self.left_out += others(link, _IN_LINK, where)
        if _value(link, "gravity") in ("false", "0"):
            self.left_out.append(f"that {where} has no weight")
        given = link.find("inertial")
        if given is None:
            given = ET.Element("inertial")
        where = f"{where}: inertial"
        self.left_out += others(given, _IN_INERTIAL, where)
        if self._frame(given, where):
            raise ValueError(f"{where}: pose: expected one in the frame of the link, got another frame")
        self._assume(given, name, where)
        turn, center = self._own(given, where)
        mass = number(_value(given, "mass"), f"{where}: mass", 1.0)
        inertia = tensor(lambda key: _value(given, f"inertia/{key}"), where, (1.0, 0.0))
        return Body(name, R, t, mass, center, turn @ inertia @ turn.T)

    def _assume(self, given: ET.Element, name: str, where: str) -> None:
        """Record default values for missing values of an inertial."""
        paths = {"mass": "mass", **{key: f"inertia/{key}" for key in ("ixx", "iyy", "izz")}}
        missing = ", ".join(key for key, path in paths.items() if _value(given, path) is None)
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
        joint = joint_of(element, _KINDS)
        where = f"joint {joint.name!r}"
        parent, child = (self._link(_text(element, end), where) for end in ("parent", "child"))
        place = self.placed[child].local(self._pose(joint.name)[1])
        joint = replace(joint, parent=parent, child=child, point=place)
        self.left_out += others(element, _IN_JOINT, where)
        tags = {"prismatic": ("axis",), "revolute": ("axis",), "universal": ("axis", "axis2")}.get(
            joint.kind, ()
        )
        turned = [self._axis(joint, element.find(tag), where) for tag in tags]
        if len({each.damping for each in turned}) > 1:
            got = ", ".join(f"{each.damping:g}" for each in turned)
            raise ValueError(f"{where}: expected the same damping about both axes, got {got}")
        return replace(turned[0], axes=np.concatenate([each.axes for each in turned])) if turned else joint

    def _link(self, name: str, where: str) -> str:
        """Return the link that a frame is fixed to, because joints may refer to frames since SDF 1.7."""
        seen = []
        while name not in self.placed:
            seen.append(name)
            element = self.named.get(name)
            if (
                self.version <= _NAMED_FRAMES
                or seen.count(name) > 1
                or (element is None and name != "__model__")
            ):
                raise ValueError(f"{where}: link {seen[0]!r}: missing")
            if element is None:
                links = self.element.findall("link")
                name = self.element.get("canonical_link") or links[0].attrib["name"]
            elif element.tag == "joint":
                name = _text(element, "child")
            else:
                name = element.get("attached_to") or "__model__"
        return name

    def _expressed_in(self, axis: ET.Element, where: str) -> str:
        """Return the frame of an axis, or an empty string for the frame of its joint."""
        xyz, of_model = axis.find("xyz"), _value(axis, "use_parent_model_frame")
        if xyz is not None and xyz.get("expressed_in"):
            return xyz.get("expressed_in", "")
        if of_model is None:
            return "__model__" if self.version <= _AXES_OF_MODEL else ""
        if self.version > _NAMED_FRAMES:
            raise ValueError(
                f"{where}: axis: expected expressed_in, as SDF has it since 1.7, got use_parent_model_frame"
            )
        return "__model__" if _is_true(of_model) else ""

    def _axis(self, joint: Joint, axis: ET.Element | None, where: str) -> Joint:
        """Return the joint with one axis, its damping, and its limits."""
        if axis is None:
            raise ValueError(f"{where}: expected an axis for each turn, got none")
        frame = self._expressed_in(axis, where)
        local = numbers(_value(axis, "xyz"), 3, f"{where}: xyz", (0.0, 0.0, 1.0))
        if frame and frame not in self.named and frame not in self.found:
            raise ValueError(f"{where}: xyz: frame {frame!r}: missing")
        R, _ = self._pose(frame or joint.name)
        self.left_out += others(axis, _IN_AXIS, where)
        joint = replace(joint, axes=(R @ direction(local, f"{where}: xyz"))[None])
        return with_properties(joint, partial(_value, axis), self.left_out)


def _value(element: ET.Element, path: str = ".") -> str | None:
    """Return the text of an element, or None if it is missing or empty and has its default."""
    text = (element.text if path == "." else element.findtext(path)) or ""
    return text if text.strip() else None


def _of_ball(ball: ET.Element, key: str) -> str | None:
    """Return the text of an element of a ball constraint."""
    return _value(ball, f"{BALL}_{key}")


def _is_true(text: str | None) -> bool:
    """Return True for a text that means true."""
    return (text or "").strip() in _TRUE


def _still() -> tuple[Array, Array]:
    """Return the identity pose."""
    return np.eye(3), np.zeros(3)


def _text(element: ET.Element, tag: str) -> str:
    """Return the text of a child element; raise ValueError if it is missing."""
    found = (element.findtext(tag) or "").strip()
    if not found:
        raise ValueError(f"joint {element.get('name')!r}: {tag}: missing")
    return found
