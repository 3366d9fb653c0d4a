"""Export to URDF (ROS), with a second file for contents that URDF cannot represent, such as loop closures.

URDF joints have one axis only: a universal joint becomes two joints with a massless link in between.
"""

import xml.etree.ElementTree as ET
from typing import Any

import numpy as np

from ...io.array_types import Array
from ...io.output import json_text
from ...motion.rotation import rpy_from_rotation
from ..model import WORLD, Body, Joint, Model, in_single_axes
from .sdf_out import BALL, DRAKE, add_shapes
from .xml_text import NO_LIMIT, TENSOR, added, document

ROOT = "base"
"""Name of the link that is fixed to the world."""
GENERATOR = "stewart-sym export"
_KINDS = {"prismatic": "prismatic", "revolute": "continuous", "free": "floating"}


def written(model: Model) -> tuple[str, str]:
    """Return the content of the model file and of the loops file."""
    tree = in_single_axes(model, ("universal", "spherical"), lambda joint, body: Body(""))
    root = ET.Element("robot", {"name": model.name, "xmlns:drake": DRAKE})
    # Simulators recognize a fixed base by this name.
    added(root, "link", name=WORLD)
    held = added(root, "joint", name="fixed_base", type="fixed")
    added(held, "parent", link=WORLD)
    added(held, "child", link=ROOT)
    for body in tree.bodies:
        _link(root, body)
    for joint in tree.joints:
        if not joint.cut:
            _joint(root, tree, joint)
    for joint in tree.joints:
        if joint.driven:
            _transmission(root, joint)
    for joint in tree.joints:
        if joint.cut:
            _ball(root, joint)
    return document(root), json_text(_loops(model))


def _ball(root: ET.Element, joint: Joint) -> None:
    """Write a closure as a ball constraint of Drake, which other programs ignore."""
    ball = added(root, BALL)
    added(ball, f"{BALL}_body_A", name=_name(joint.parent))
    added(ball, f"{BALL}_p_AP", value=joint.parent_point)
    added(ball, f"{BALL}_body_B", name=_name(joint.child))
    added(ball, f"{BALL}_p_BQ", value=joint.point)


def _loops(model: Model) -> dict[str, Any]:
    """Return loop closures and other contents that the format cannot represent."""
    closures = [
        {
            "name": joint.name,
            "type": joint.kind,
            "link_1": joint.parent,
            "point_1_m": joint.parent_point,
            "link_2": joint.child,
            "point_2_m": joint.point,
            "damping_N_m_s": joint.damping,
        }
        for joint in model.joints
        if joint.cut
    ]
    return {
        "generator": GENERATOR,
        "gravity_m_s2": model.gravity,
        "closures": closures,
        "armature_kg": {joint.name: joint.armature for joint in model.joints if joint.armature},
        "note": model.note,
    }


def _link(root: ET.Element, body: Body) -> None:
    """Add a link."""
    link = added(root, "link", name=_name(body.name))
    if body.mass:
        inertial = added(link, "inertial")
        _origin(inertial, body.center, np.eye(3))
        added(inertial, "mass", value=body.mass)
        added(inertial, "inertia", **{key: body.inertia[place] for key, place in TENSOR.items()})
    add_shapes(link, body, added, _origin, _material)


def _origin(element: ET.Element, place: Array, R: Array) -> None:
    """Add a pose as position and roll, pitch, yaw."""
    added(element, "origin", xyz=place, rpy=rpy_from_rotation(R))


def _material(element: ET.Element, body: Body) -> None:
    """Add the color of a body."""
    added(added(element, "material", name=body.name.partition("_")[0]), "color", rgba=[*body.color, 1.0])


def _joint(root: ET.Element, model: Model, joint: Joint) -> None:
    """Add a joint."""
    element = added(root, "joint", name=joint.name, type=_KINDS[joint.kind])
    added(element, "parent", link=_name(joint.parent))
    added(element, "child", link=_name(joint.child))
    R, turned = model.body(joint.parent).R, model.body(joint.child).R
    _origin(element, model.origin(joint), np.eye(3) if np.array_equal(R, turned) else R.T @ turned)
    for axis in model.local_axes(joint):
        added(element, "axis", xyz=axis)
    if joint.kind != "free":
        added(element, "dynamics", damping=joint.damping, friction=0.0)
    if joint.kind == "prismatic":
        low, high = joint.travel(NO_LIMIT)
        effort, speed = min(joint.effort, NO_LIMIT), min(joint.speed, NO_LIMIT)
        added(element, "limit", lower=low, upper=high, effort=effort, velocity=speed)


def _transmission(root: ET.Element, joint: Joint) -> None:
    """Add a force actuator to a joint, in the form that the controllers of ROS expect."""
    element = added(root, "transmission", name=f"{joint.name}_transmission")
    added(element, "type", "transmission_interface/SimpleTransmission")
    driven = added(element, "joint", name=joint.name)
    added(driven, "hardwareInterface", "hardware_interface/EffortJointInterface")
    actuator = added(element, "actuator", name=f"{joint.name}_actuator")
    added(actuator, "mechanicalReduction", "1")


def _name(body: str) -> str:
    """Return the name of the link of a body."""
    return ROOT if body == WORLD else body
