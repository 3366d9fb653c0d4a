"""Export to SDF (Gazebo and Drake): a world with a model of links and joints.

Gazebo closes loops with joints, which Drake rejects; Drake has its own constraints for loop closures.
"""

import json
import xml.etree.ElementTree as ET
from collections.abc import Callable

import numpy as np

from ...io.array_types import Array
from ...motion.rotation import rpy_from_rotation
from ..model import WORLD, Body, Joint, Model
from .xml_text import NO_LIMIT, TENSOR, Leaf, added, document, leaves

SPACE = "urn:stewart-sym"
"""XML namespace of contents that the format cannot represent."""
NOTE = "stewart_sym:note"
BALL = "drake:ball_constraint"
"""Element for a loop closure in Drake, in SDF and URDF."""
DRAKE = "http://drake.mit.edu"
"""XML namespace of elements for Drake only."""
_KINDS = {"prismatic": "prismatic", "revolute": "revolute", "universal": "universal", "spherical": "ball"}
_PLUGIN = {"filename": "gz-sim-apply-joint-force-system", "name": "gz::sim::systems::ApplyJointForce"}


def written(model: Model, drake: bool = False) -> tuple[str, None]:
    """Return the content of the file for Gazebo, or for Drake."""
    root = ET.Element("sdf", {"version": "1.9", "xmlns:stewart_sym": SPACE})
    if drake:
        root.set("xmlns:drake", DRAKE)
    world = added(root, "world", name="scene")
    added(world, "gravity", model.gravity)
    light = added(world, "light", name="light", type="directional")
    added(light, "direction", "0.2 0.3 -1")
    inside = added(world, "model", name=_allowed(model.name))
    base = added(inside, "link", name="base")
    add_shapes(base, model.body(WORLD), leaves, _pose, _material)
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
            added(added(inside, "plugin", **_PLUGIN), "joint_name", joint.name)
    if model.note:
        added(inside, NOTE, json.dumps(model.note))
    return document(root), None


def _ball(parent: ET.Element, joint: Joint) -> None:
    """Write a closure as a ball constraint of Drake."""
    ends = {"body_A": joint.parent, "p_AP": joint.parent_point, "body_B": joint.child, "p_BQ": joint.point}
    leaves(parent, BALL, **{f"{BALL}_{key}": value for key, value in ends.items()})


def _allowed(name: str) -> str:
    """Return a valid name of a model, because ``::`` and surrounding ``__`` have a special meaning in SDF."""
    plain = name.replace("::", ":").strip("_")
    return plain or "machine"


def _link(parent: ET.Element, body: Body) -> None:
    """Add a link."""
    link = added(parent, "link", name=body.name)
    _pose(link, body.t, body.R)
    inertial = added(link, "inertial")
    _pose(inertial, body.center, np.eye(3))
    added(inertial, "mass", body.mass)
    leaves(inertial, "inertia", **{key: body.inertia[place] for key, place in TENSOR.items()})
    add_shapes(link, body, leaves, _pose, _material)


def _pose(element: ET.Element, place: Array, R: Array) -> None:
    """Add a pose as position and roll, pitch, yaw."""
    added(element, "pose", np.concatenate([place, rpy_from_rotation(R)]))


def _material(element: ET.Element, body: Body) -> None:
    """Add the color of a body."""
    color = [*body.color, 1.0]
    leaves(element, "material", ambient=color, diffuse=color)


def add_shapes(
    link: ET.Element,
    body: Body,
    leaf: Leaf,
    pose: Callable[[ET.Element, Array, Array], None],
    material: Callable[[ET.Element, Body], None],
) -> None:
    """Add the visuals and collisions of a body, in SDF and URDF."""
    for number, shape in enumerate(body.shapes, 1):
        for tag in ("visual", "collision"):
            # MuJoCo expects names that are unique in the whole URDF file.
            element = added(link, tag, name=f"{tag}_{number}" if leaf is leaves else None)
            pose(element, shape.middle, shape.frame)
            geometry, length = added(element, "geometry"), shape.length or None
            leaf(geometry, "cylinder" if length else "sphere", radius=shape.radius, length=length)
            if tag == "visual":
                material(element, body)


def _joint(parent: ET.Element, model: Model, joint: Joint, drake: bool) -> None:
    """Add a joint."""
    element = added(parent, "joint", name=joint.name, type=_KINDS[joint.kind])
    added(element, "parent", "base" if joint.parent == WORLD else joint.parent)
    added(element, "child", joint.child)
    if joint.point.any():
        _pose(element, joint.point, np.eye(3))
    for number, (axis, local) in enumerate(zip(joint.axes, model.local_axes(joint), strict=True)):
        turned = added(element, "axis2" if number else "axis")
        if number or joint.kind == "prismatic":
            added(turned, "xyz", local)
        else:
            added(turned, "xyz", axis, expressed_in="__model__")
        leaves(turned, "dynamics", damping=joint.damping)
        leaves(turned, "limit", **_limits(joint, drake))


def _limits(joint: Joint, drake: bool) -> dict[str, float | None]:
    """Return the limits of an axis."""
    low, high = joint.travel(NO_LIMIT)
    # Drake adds an actuator to every joint without a limit of the effort.
    none = 0.0 if drake and not joint.driven else None
    effort, speed = (None if np.isinf(limit) else limit for limit in (joint.effort, joint.speed))
    return {"lower": low, "upper": high, "effort": none if effort is None else effort, "velocity": speed}
