"""Export to MJCF (MuJoCo): universal joints as two hinges, loop closures as ``connect`` constraints."""

import json
import xml.etree.ElementTree as ET

import numpy as np

from ...motion.rotation import quaternion_from_rotation
from ..model import WORLD, Body, Joint, Model, Shape
from .xml_text import added, document

NOTE = "stewart_sym"
"""Name of the custom text with the robot file."""
TIMESTEP = 0.0005
"""Time step in the file (s): half the time constant of loop closures, for stability in MuJoCo."""
_TIME_CONSTANT = 2.0 * TIMESTEP
_STIFFEST = 0.9999
"""Largest impedance of a constraint in MuJoCo."""
_KINDS = {"prismatic": "slide", "revolute": "hinge", "universal": "hinge", "spherical": "ball"}
_TENSOR = ([0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2])


def written(model: Model) -> tuple[str, None]:
    """Return the content of the file."""
    root = ET.Element("mujoco", model=model.name)
    added(root, "compiler", angle="radian", autolimits="true")
    added(root, "option", timestep=TIMESTEP, gravity=model.gravity, integrator="implicitfast")
    if model.note:
        custom = added(root, "custom")
        added(custom, "text", name=NOTE, data=json.dumps(model.note))
    _defaults(root)
    _scenery(root)
    world = added(root, "worldbody")
    added(world, "light", directional="true", castshadow="false", dir="0.4 0.6 -1")
    _inside(world, model, model.body(WORLD))
    equality = added(root, "equality")
    for joint in model.joints:
        if joint.cut:
            added(equality, "connect", name=joint.name, site1=f"{joint.name}_a", site2=f"{joint.name}_b")
    actuators = added(root, "actuator")
    for joint in model.joints:
        if joint.driven:
            force = np.array([-joint.effort, joint.effort]) if np.isfinite(joint.effort) else None
            added(actuators, "motor", name=joint.name, joint=joint.name, ctrlrange=force, forcerange=force)
    return document(root), None


def _scenery(root: ET.Element) -> None:
    """Add a light sky and a headlight."""
    visual = added(root, "visual")
    added(visual, "headlight", ambient="0.3 0.3 0.3", diffuse="0.5 0.5 0.5")
    sky = {"type": "skybox", "builtin": "gradient", "rgb1": "0.9 0.93 0.96", "rgb2": "0.6 0.67 0.75"}
    added(added(root, "asset"), "texture", **sky, width="64", height="384")


def _defaults(root: ET.Element) -> None:
    """Set the defaults: shapes collide with other objects only, and loop closures are stiff."""
    default = added(root, "default")
    added(default, "geom", contype="1", conaffinity="0", density="0")
    stiff = [_STIFFEST, _STIFFEST, 0.001, 0.5, 2]
    added(default, "equality", solref=[_TIME_CONSTANT, 1.0], solimp=stiff)
    added(default, "site", size=0.001, group="4")


def _inside(parent: ET.Element, model: Model, body: Body) -> None:
    """Add the contents of a body: shapes, sites of loop closures, and the bodies that it carries."""
    for shape in body.shapes:
        _shape(parent, shape, [*body.color, 1.0])
    for joint in model.joints:
        if joint.cut:
            ends = ((joint.parent, joint.parent_point, "a"), (joint.child, joint.point, "b"))
            for end, point, mark in ends:
                if end == body.name:
                    added(parent, "site", name=f"{joint.name}_{mark}", pos=point)
    for each in model.bodies:
        carrier = model.carrier(each)
        if carrier is not None and carrier.parent == body.name:
            _body(parent, model, body, each, carrier)


def _body(parent: ET.Element, model: Model, carrier: Body, body: Body, joint: Joint) -> None:
    """Add a body with its joint and inertia."""
    turn = carrier.R.T @ body.R
    quaternion = None if np.array_equal(body.R, carrier.R) else quaternion_from_rotation(turn)
    element = added(parent, "body", name=body.name, pos=model.origin(joint), quat=quaternion)
    _joint(element, model, joint)
    added(element, "inertial", mass=body.mass, pos=body.center, fullinertia=body.inertia[_TENSOR])
    _inside(element, model, body)


def _joint(element: ET.Element, model: Model, joint: Joint) -> None:
    """Add the elements of a joint."""
    if joint.kind == "free":
        added(element, "freejoint", name=joint.name)
        return
    axes = model.local_axes(joint)
    several = len(axes) > 1
    for number, axis in enumerate(axes if len(axes) else [None], 1):
        added(
            element,
            "joint",
            name=f"{joint.name}_{number}" if several else joint.name,
            type=_KINDS[joint.kind],
            pos=joint.point if joint.point.any() else None,
            axis=axis,
            damping=joint.damping or None,
            armature=joint.armature or None,
            ref=joint.position or None,
            range=np.array(joint.limits) if joint.limited else None,
        )


def _shape(parent: ET.Element, shape: Shape, color: list[float]) -> None:
    """Add a shape."""
    if shape.length:
        ends = np.concatenate([shape.start, shape.end])
        added(parent, "geom", type="cylinder", size=shape.radius, fromto=ends, rgba=color)
    else:
        added(parent, "geom", type="sphere", size=shape.radius, pos=shape.start, rgba=color)
