"""Export to USD text with UsdPhysics schemas (Isaac Sim and Omniverse).

UsdPhysics has no universal joint: it becomes two revolute joints with a small body in between. The
articulation is a tree from the base through leg 1 to the platform; the loop closures of the other legs are
joints outside of the articulation.
"""

import json
from collections.abc import Iterator
from dataclasses import dataclass, field
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


@dataclass(frozen=True)
class _Prim:
    """Prim with kind, name, applied schemas, attribute lines, and child prims."""

    kind: str
    name: str
    schemas: tuple[str, ...] = ()
    lines: list[str] = field(default_factory=list)
    inside: list["_Prim"] = field(default_factory=list)
    about: tuple[str, ...] = ()

    def text(self, indent: int = 0) -> Iterator[str]:
        """Yield the lines of the prim."""
        pad = "    " * indent
        yield f'{pad}def {self.kind} "{self.name}"'
        about = [*self.about]
        if self.schemas:
            about.append(f"prepend apiSchemas = [{', '.join(json.dumps(each) for each in self.schemas)}]")
        if about:
            yield f"{pad}("
            yield from (f"{pad}    {line}" for line in about)
            yield f"{pad})"
        yield f"{pad}{{"
        yield from (f"{pad}    {line}" for line in self.lines)
        for each in self.inside:
            yield from each.text(indent + 1)
        yield f"{pad}}}"


def written(model: Model) -> tuple[str, None]:
    """Return the content of the file."""
    tree = in_single_axes(model, ("universal",), _cross)
    name = json.dumps(model.name, ensure_ascii=False)
    root = _Prim("Xform", _ROOT, ("PhysicsArticulationRootAPI",), about=(f"doc = {name}",))
    first = next(joint for joint in tree.joints if joint.cut)
    root.inside.append(_scene(model))
    root.inside.append(_parts())
    for body in tree.bodies:
        root.inside.append(_body(body))
    for joint in tree.joints:
        if joint.kind != "free":
            root.inside.append(_joint(tree, joint, loop=joint.cut and joint is not first))
    held = [f"rel physics:body1 = </{_ROOT}/{_BASE}>"]
    root.inside.append(_Prim("PhysicsFixedJoint", "fixed_base", lines=held))
    return HEADER + "\n".join(root.text()) + "\n", None


def _cross(joint: Joint, body: Body) -> Body:
    """Create the body between two axes."""
    moment = _CROSS_INERTIA * float(np.trace(body.inertia))
    return Body("", mass=_CROSS_MASS * body.mass, inertia=moment * np.eye(3))


def _scene(model: Model) -> _Prim:
    """Create the physics scene with gravity."""
    gravity = np.zeros(3) if model.gravity is None else model.gravity
    size = float(np.linalg.norm(gravity))
    direction = gravity / size if size else gravity
    lines = [
        f"vector3f physics:gravityDirection = {_tuple(direction)}",
        f"float physics:gravityMagnitude = {spelled(size)}",
    ]
    return _Prim("PhysicsScene", "physics", lines=lines)


def _parts() -> _Prim:
    """Create a collision group: parts collide only with other objects of a scene."""
    lines = [
        f"rel collection:colliders:includes = </{_ROOT}>",
        f"rel physics:filteredGroups = </{_ROOT}/parts>",
    ]
    return _Prim("PhysicsCollisionGroup", "parts", ("CollectionAPI:colliders",), lines)


def _body(body: Body) -> _Prim:
    """Create the prim of a body."""
    shapes = [_shape(shape, number, body.color) for number, shape in enumerate(body.shapes, 1)]
    if body.name == WORLD:
        # The mass of the fixed base has no effect, but without it the mass would be computed from the shapes.
        schemas, lines = ("PhysicsRigidBodyAPI", "PhysicsMassAPI"), ["float physics:mass = 1.0"]
        return _Prim("Xform", _BASE, schemas, lines, shapes)
    moments, axes = np.linalg.eigh(body.inertia)
    axes[:, 2] *= np.sign(np.linalg.det(axes))
    lines = [
        *_placed(body.t, body.R),
        f"float physics:mass = {spelled(body.mass)}",
        f"point3f physics:centerOfMass = {_tuple(body.center)}",
        f"float3 physics:diagonalInertia = {_tuple(moments)}",
        f"quatf physics:principalAxes = {_quaternion(axes)}",
    ]
    return _Prim("Xform", body.name, ("PhysicsRigidBodyAPI", "PhysicsMassAPI"), lines, shapes)


def _shape(shape: Shape, number: int, color: tuple[float, ...]) -> _Prim:
    """Create the prim of a shape."""
    lines = [
        f"double radius = {spelled(shape.radius)}",
        f"color3f[] primvars:displayColor = [{_tuple(color)}]",
        *_placed(shape.middle, shape.frame),
    ]
    if shape.length:
        lines += [f"double height = {spelled(shape.length)}", 'uniform token axis = "Z"']
    kind = "Cylinder" if shape.length else "Sphere"
    return _Prim(kind, f"{kind.lower()}_{number}", ("PhysicsCollisionAPI",), lines)


def _joint(model: Model, joint: Joint, loop: bool) -> _Prim:
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
    return _Prim(_KINDS[joint.kind], joint.name, tuple(schemas), lines)


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
