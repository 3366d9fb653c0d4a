"""Export to USD text with UsdPhysics schemas (Isaac Sim and Omniverse).

UsdPhysics has no universal joint: it becomes two revolute joints with a small body in between. The
articulation is a tree from the base through leg 1 to the platform; the loop closures of the other legs are
joints outside of the articulation.
"""

import json
from collections.abc import Sequence
from typing import Any

import numpy as np

from ...io.array_types import Array
from ...motion.rotation import quaternion_from_rotation
from ..model import WORLD, Body, Joint, Model, Shape, frame_along, in_single_axes
from .xml_text import spelled

_ROOT, _BASE = "machine", "base"
HEADER = f"""#usda 1.0
(
    doc = "Written by stewart-sym export"
    defaultPrim = "{_ROOT}"
    kilogramsPerUnit = 1
    metersPerUnit = 1
    upAxis = "Z"
)

"""
"""First lines of every file."""
_CROSS_MASS, _CROSS_INERTIA = 0.1, 1e-3
"""Mass and inertia of the body between two axes, relative to the lower part; its mass remains at rest."""
_KINDS = {
    "prismatic": "PhysicsPrismaticJoint",
    "revolute": "PhysicsRevoluteJoint",
    "spherical": "PhysicsSphericalJoint",
}
_PER_DEGREE = np.pi / 180.0


def written(model: Model) -> tuple[str, None]:
    """Return the content of the file."""
    tree = in_single_axes(model, ("universal",), _cross)
    first = next(joint for joint in tree.joints if joint.cut)
    inside = [_scene(model), _parts(), *(_body(body) for body in tree.bodies)]
    for joint in tree.joints:
        if joint.kind != "free":
            inside.append(_joint(tree, joint, loop=joint.cut and joint is not first))
    held = [f"rel physics:body1 = </{_ROOT}/{_BASE}>"]
    inside.append(_prim("PhysicsFixedJoint", "fixed_base", lines=held))
    about = [f"doc = {json.dumps(model.name, ensure_ascii=False)}"]
    root = _prim("Xform", _ROOT, ("PhysicsArticulationRootAPI",), [], inside, about)
    return HEADER + "\n".join(root) + "\n", None


def _prim(
    kind: str,
    name: str,
    schemas: Sequence[str] = (),
    lines: Sequence[str] = (),
    inside: Sequence[list[str]] = (),
    about: Sequence[str] = (),
) -> list[str]:
    """Return the lines of a prim with applied schemas, attribute lines, child prims, and other metadata."""
    if schemas:
        about = [*about, f"prepend apiSchemas = [{', '.join(json.dumps(each) for each in schemas)}]"]
    head = ["(", *(f"    {line}" for line in about), ")"] if about else []
    body = [f"    {line}" for line in [*lines, *(line for child in inside for line in child)]]
    return [f'def {kind} "{name}"', *head, "{", *body, "}"]


def _cross(joint: Joint, body: Body) -> Body:
    """Create the body between two axes."""
    moment = _CROSS_INERTIA * float(np.trace(body.inertia))
    return Body("", mass=_CROSS_MASS * body.mass, inertia=moment * np.eye(3))


def _scene(model: Model) -> list[str]:
    """Create the physics scene with gravity."""
    gravity = np.zeros(3) if model.gravity is None else model.gravity
    size = float(np.linalg.norm(gravity))
    direction = gravity / size if size else gravity
    lines = [
        f"vector3f physics:gravityDirection = {_tuple(direction)}",
        f"float physics:gravityMagnitude = {spelled(size)}",
    ]
    return _prim("PhysicsScene", "physics", lines=lines)


def _parts() -> list[str]:
    """Create a collision group: parts collide only with other objects of a scene."""
    lines = [
        f"rel collection:colliders:includes = </{_ROOT}>",
        f"rel physics:filteredGroups = </{_ROOT}/parts>",
    ]
    return _prim("PhysicsCollisionGroup", "parts", ("CollectionAPI:colliders",), lines)


def _body(body: Body) -> list[str]:
    """Create the prim of a body."""
    shapes = [_shape(shape, number, body.color) for number, shape in enumerate(body.shapes, 1)]
    if body.name == WORLD:
        # The mass of the fixed base has no effect, but without it the mass would be computed from the shapes.
        schemas, lines = ("PhysicsRigidBodyAPI", "PhysicsMassAPI"), ["float physics:mass = 1.0"]
        return _prim("Xform", _BASE, schemas, lines, shapes)
    moments, axes = np.linalg.eigh(body.inertia)
    axes[:, 2] *= np.sign(np.linalg.det(axes))
    lines = [
        *_placed(body.t, body.R),
        f"float physics:mass = {spelled(body.mass)}",
        f"point3f physics:centerOfMass = {_tuple(body.center)}",
        f"float3 physics:diagonalInertia = {_tuple(moments)}",
        f"quatf physics:principalAxes = {_quaternion(axes)}",
    ]
    return _prim("Xform", body.name, ("PhysicsRigidBodyAPI", "PhysicsMassAPI"), lines, shapes)


def _shape(shape: Shape, number: int, color: tuple[float, ...]) -> list[str]:
    """Create the prim of a shape."""
    lines = [
        f"double radius = {spelled(shape.radius)}",
        f"color3f[] primvars:displayColor = [{_tuple(color)}]",
        *_placed(shape.middle, shape.frame),
    ]
    if shape.length:
        lines += [f"double height = {spelled(shape.length)}", 'uniform token axis = "Z"']
    kind = "Cylinder" if shape.length else "Sphere"
    return _prim(kind, f"{kind.lower()}_{number}", ("PhysicsCollisionAPI",), lines)


def _joint(model: Model, joint: Joint, loop: bool) -> list[str]:
    """Create the prim of a joint."""
    parent, child = model.body(joint.parent), model.body(joint.child)
    place = child.placed(joint.point)
    frame = np.roll(frame_along(joint.axes[0]), 1, axis=-1) if len(joint.axes) else child.R
    sides = [(parent, parent.local(place)), (child, joint.point)]
    if joint.cut:
        sides[0] = parent, joint.parent_point
    if joint.kind == "prismatic":
        sides[0] = parent, parent.local(place - joint.position * joint.axes[0])
    lines, schemas = [], []
    for number, (body, point) in enumerate(sides):
        name = _BASE if body.name == WORLD else body.name
        lines.append(f"rel physics:body{number} = </{_ROOT}/{name}>")
        lines.append(f"point3f physics:localPos{number} = {_tuple(point)}")
        lines.append(f"quatf physics:localRot{number} = {_quaternion(body.R.T @ frame)}")
    if loop:
        lines.append("bool physics:excludeFromArticulation = true")
    if len(joint.axes):
        lines.append('uniform token physics:axis = "X"')
    if joint.kind == "prismatic" and joint.limited:
        for name, limit in zip(("lower", "upper"), joint.limits, strict=True):
            lines.append(f"float physics:{name}Limit = {spelled(limit)}")
    kind = {"prismatic": "linear", "revolute": "angular"}.get(joint.kind)
    if kind is not None and (joint.driven or joint.damping):
        schemas.append(f"PhysicsDriveAPI:{kind}")
        damping = joint.damping * (_PER_DEGREE if kind == "angular" else 1.0)
        lines.append(f"float drive:{kind}:physics:damping = {spelled(damping)}")
        if np.isfinite(joint.effort):
            lines.append(f"float drive:{kind}:physics:maxForce = {spelled(joint.effort)}")
    if joint.armature:
        lines.append(f"float physxJoint:armature = {spelled(joint.armature)}")
    return _prim(_KINDS[joint.kind], joint.name, tuple(schemas), lines)


def _placed(place: Array, R: Array) -> list[str]:
    """Return the attributes of a pose."""
    return [
        f"double3 xformOp:translate = {_tuple(place)}",
        f"quatd xformOp:orient = {_quaternion(R)}",
        'uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:orient"]',
    ]


def _quaternion(R: Array) -> str:
    """Return a rotation as a quaternion in USD text."""
    return _tuple(quaternion_from_rotation(R))


def _tuple(values: Any) -> str:
    """Return numbers as a tuple in USD text."""
    return f"({', '.join(spelled(value) for value in np.ravel(values))})"
