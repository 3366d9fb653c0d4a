"""Export to SDF (Gazebo and Drake): a world with a model of links and joints.

Gazebo closes loops with joints, which Drake rejects; Drake has its own constraints for loop closures.
"""

import json
import xml.etree.ElementTree as ET

import numpy as np

from ...io.array_types import Array
from ...motion.rotation import rpy_from_rotation
from ..model import WORLD, Body, Joint, Model, Shape
from .xml_text import NO_LIMIT, TENSOR, added, document

SPACE = "urn:stewart-sym"
"""XML namespace of contents that the format cannot represent."""
NOTE = "stewart_sym:note"
BALL = "drake:ball_constraint"
"""Element for a loop closure in Drake, in SDF and URDF."""
DRAKE = "http://drake.mit.edu"
"""XML namespace of elements for Drake only."""
_KINDS = {"prismatic": "prismatic", "revolute": "revolute", "universal": "universal", "spherical": "ball"}
_PLUGIN = {"filename": "gz-sim-apply-joint-force-system", "name": "gz::sim::systems::ApplyJointForce"}


def written(model: Model) -> tuple[str, None]:
    """Write the file for Gazebo."""
    return _document(model, False), None


def written_for_drake(model: Model) -> tuple[str, None]:
    """Write the file for Drake."""
    return _document(model, True), None


def _document(model: Model, drake: bool) -> str:
    """Return the content of the file."""
    root = ET.Element("sdf", {"version": "1.9", "xmlns:stewart_sym": SPACE})
    if drake:
        root.set("xmlns:drake", DRAKE)
    world = added(root, "world", name="scene")
    added(world, "gravity", model.gravity)
    light = added(world, "light", name="light", type="directional")
    added(light, "direction", "0.2 0.3 -1")
    inside = added(world, "model", name=_allowed(model.name))
    base = added(inside, "link", name="base")
    _shapes(base, model.body(WORLD))
    fixed = added(inside, "joint", name="fixed_base", type="fixed")
    added(fixed, "parent", "world")
    added(fixed, "child", "base")
    for body in model.bodies:
        if body.name != WORLD:
            _link(inside, body)
    for joint in model.joints:
        if drake and joint.cut:
            _ball(inside, joint)
        elif joint.kind != "free":
            _joint(inside, model, joint, drake)
    for joint in model.joints:
        if joint.driven and not drake:
            plugin = added(inside, "plugin", **_PLUGIN)
            added(plugin, "joint_name", joint.name)
    if model.note:
        added(inside, NOTE, json.dumps(model.note))
    return document(root)


def _ball(parent: ET.Element, joint: Joint) -> None:
    """Write a closure as a ball constraint of Drake."""
    ball = added(parent, BALL)
    added(ball, f"{BALL}_body_A", joint.parent)
    added(ball, f"{BALL}_p_AP", joint.parent_point)
    added(ball, f"{BALL}_body_B", joint.child)
    added(ball, f"{BALL}_p_BQ", joint.point)


def _allowed(name: str) -> str:
    """Return a valid name of a model, because ``::`` and surrounding ``__`` have a special meaning in SDF."""
    plain = name.replace("::", ":").strip("_")
    return plain or "machine"


def _link(parent: ET.Element, body: Body) -> None:
    """Add a link."""
    link = added(parent, "link", name=body.name)
    added(link, "pose", _pose(body.t, body.R))
    inertial = added(link, "inertial")
    added(inertial, "pose", _pose(body.center, np.eye(3)))
    added(inertial, "mass", body.mass)
    inertia = added(inertial, "inertia")
    for key, place in TENSOR.items():
        added(inertia, key, body.inertia[place])
    _shapes(link, body)


def _pose(place: Array, R: Array) -> Array:
    """Return a pose as position and roll, pitch, yaw."""
    return np.concatenate([place, rpy_from_rotation(R)])


def _joint(parent: ET.Element, model: Model, joint: Joint, drake: bool) -> None:
    """Add a joint."""
    element = added(parent, "joint", name=joint.name, type=_KINDS[joint.kind])
    added(element, "parent", "base" if joint.parent == WORLD else joint.parent)
    added(element, "child", joint.child)
    if joint.point.any():
        added(element, "pose", _pose(joint.point, np.eye(3)))
    for number, (axis, local) in enumerate(zip(joint.axes, model.local_axes(joint), strict=True)):
        turned = added(element, "axis2" if number else "axis")
        if number or joint.kind == "prismatic":
            added(turned, "xyz", local)
        else:
            added(turned, "xyz", axis, expressed_in="__model__")
        dynamics = added(turned, "dynamics")
        added(dynamics, "damping", joint.damping)
        _limits(turned, joint, drake)


def _limits(axis: ET.Element, joint: Joint, drake: bool) -> None:
    """Add the limits of an axis."""
    limit = added(axis, "limit")
    low, high = joint.travel(NO_LIMIT)
    added(limit, "lower", low)
    added(limit, "upper", high)
    if np.isfinite(joint.effort):
        added(limit, "effort", joint.effort)
    elif drake and not joint.driven:
        # Drake adds an actuator to every joint without this limit.
        added(limit, "effort", 0.0)
    if np.isfinite(joint.speed):
        added(limit, "velocity", joint.speed)


def _shapes(link: ET.Element, body: Body) -> None:
    """Add the visuals and collisions of a body."""
    color = [*body.color, 1.0]
    for number, shape in enumerate(body.shapes, 1):
        for tag in ("visual", "collision"):
            element = added(link, tag, name=f"{tag}_{number}")
            added(element, "pose", _pose(shape.middle, shape.frame))
            _geometry(element, shape)
            if tag == "visual":
                material = added(element, "material")
                added(material, "ambient", color)
                added(material, "diffuse", color)


def _geometry(element: ET.Element, shape: Shape) -> None:
    """Add the geometry of a shape."""
    geometry = added(element, "geometry")
    kind = added(geometry, "cylinder" if shape.length else "sphere")
    added(kind, "radius", shape.radius)
    if shape.length:
        added(kind, "length", shape.length)
