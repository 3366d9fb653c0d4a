"""Robot as bodies and joints: the common representation of all formats.

Poses are in the world frame, in the configuration of the model in its file.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ..io.array_types import Array
from ..motion import rotation
from ..robot import bodies

WORLD = "world"
"""Name of the fixed body."""

BETWEEN = ", joint "
"""Part of the names of massless bodies between successive joints of one body, before a number."""

_COLORS = {"lower": (0.35, 0.4, 0.47), "upper": (0.75, 0.78, 0.8), "platform": (0.2, 0.45, 0.7)}
_GRAY = (0.5, 0.5, 0.5)
_ROUNDING = 4e-16
_SHORT = 1e-12


@dataclass(frozen=True, eq=False)
class Shape:
    """Cylinder from start to end, (3,), in the body frame (m); a sphere if the two points are equal."""

    radius: float
    start: Array
    end: Array

    @property
    def length(self) -> float:
        """Length of the cylinder (m); 0 for a sphere."""
        return float(np.linalg.norm(self.end - self.start))

    @property
    def middle(self) -> Array:
        """Center of the shape, shape (3,)."""
        return 0.5 * (self.start + self.end)

    @property
    def frame(self) -> Array:
        """Axes in columns, shape (3, 3), in the body frame; the third one is the axis of the cylinder."""
        return frame_along(self.end - self.start) if self.length else np.eye(3)


@dataclass(frozen=True, eq=False)
class Body:
    """Rigid body in the configuration of the model.

    The orientation R and the origin t (m) are in the world frame. A body that only connects joints has the
    mass 0 kg. The center of mass (m) and the inertia about it (kg m^2) are in the body frame.
    """

    name: str
    R: Array = field(default_factory=lambda: np.eye(3))
    t: Array = field(default_factory=lambda: np.zeros(3))
    mass: float = 0.0
    center: Array = field(default_factory=lambda: np.zeros(3))
    inertia: Array = field(default_factory=lambda: np.zeros((3, 3)))
    shapes: tuple[Shape, ...] = ()

    @property
    def color(self) -> tuple[float, float, float]:
        """Red, green, and blue of its shapes, 0 to 1."""
        return _COLORS.get(self.name.partition("_")[0], _GRAY)

    @property
    def solid(self) -> bodies.Body:
        """Mass, center of mass, and inertia in the world frame."""
        return bodies.Body(self.mass, self.placed(self.center), self.R @ self.inertia @ self.R.T)

    def with_solids(self, solids: Sequence[bodies.Body]) -> "Body":
        """Return the body with the mass, center of mass, and inertia of solids in the world frame."""
        whole = bodies.joined(list(solids))
        inertia = self.R.T @ whole.inertia @ self.R
        center = self.local(whole.center_of_mass)
        return replace(self, mass=whole.mass, center=center, inertia=0.5 * (inertia + inertia.T))

    def placed(self, point: Array) -> Array:
        """Convert a point from the body frame to the world frame, shape (3,)."""
        return np.asarray(self.t + self.R @ point)

    def local(self, point: Array) -> Array:
        """Convert a point from the world frame to the body frame, shape (3,)."""
        return np.asarray(self.R.T @ (point - self.t))


@dataclass(frozen=True, eq=False)
class Joint:
    """Joint between two bodies, or closure of a loop if ``cut``. Units are m, N, kg, rad, and s.

    A joint of the kind revolute or prismatic has one axis, and a universal joint has two. Other kinds are
    spherical, fixed, and free. The directions ``axes``, (n, 3), are in the world frame, from parent to
    child. The joint point is in the frame of the child, and for a cut also in the frame of the parent.

    The coordinate ``position`` belongs to the configuration of the model; for a fixed cut it is its angular
    error. ``effort`` and ``speed`` are limits of the drive, and ``armature`` is its inertia at the joint.
    ``load`` is the force and moment on the child at the joint point, world axes, (6,), by springs and other
    effects that a robot cannot represent.
    """

    name: str
    kind: str
    parent: str
    child: str
    point: Array = field(default_factory=lambda: np.zeros(3))
    axes: Array = field(default_factory=lambda: np.zeros((0, 3)))
    damping: float = 0.0
    armature: float = 0.0
    position: float = 0.0
    limits: tuple[float, float] = (-np.inf, np.inf)
    effort: float = np.inf
    speed: float = np.inf
    cut: bool = False
    parent_point: Array = field(default_factory=lambda: np.zeros(3))
    driven: bool = False
    load: Array = field(default_factory=lambda: np.zeros(6))

    @property
    def limited(self) -> bool:
        """True if the coordinate has a lower and an upper limit."""
        return bool(np.all(np.isfinite(self.limits)))

    def travel(self, unlimited: float) -> tuple[float, float]:
        """Return the limits relative to the current configuration, or -unlimited and unlimited."""
        if not self.limited:
            return -unlimited, unlimited
        low, high = self.limits
        return low - self.position, high - self.position


@dataclass(frozen=True, eq=False)
class Model:
    """Bodies, including the world, and joints of a robot; each body follows its carrier.

    The gravity (m/s^2) is None if the file does not contain it. ``note`` contains the tables of the exported
    robot file, and ``left_out`` the contents that a model cannot represent. The keys of ``assumed`` are
    names of bodies, or other keys for the whole file.
    """

    name: str
    gravity: Array | None
    bodies: tuple[Body, ...]
    joints: tuple[Joint, ...]
    note: Mapping[str, Any] | None = None
    left_out: tuple[str, ...] = ()
    assumed: Mapping[str, str] = field(default_factory=dict)

    def body(self, name: str) -> Body:
        """Return the body with a name; raise ValueError if there is none."""
        for body in self.bodies:
            if body.name == name:
                return body
        raise ValueError(f"body {name!r}: missing")

    def carrier(self, body: Body) -> Joint | None:
        """Return the joint of the tree (not a loop closure) that carries a body."""
        return next((joint for joint in self.joints if joint.child == body.name and not joint.cut), None)

    def origin(self, joint: Joint) -> Array:
        """Return the origin of the child of a joint in the frame of its parent, shape (3,).

        The origin of a prismatic joint is exactly on its axis if the difference is a rounding error.
        """
        parent, child = self.body(joint.parent), self.body(joint.child)
        place = child.t if parent.name == WORLD else parent.local(child.t)
        along = joint.position * self.local_axes(joint)[0] if joint.kind == "prismatic" else np.zeros(3)
        return place if np.abs(place - along).max() > _SHORT * np.abs(place).max() else along

    def local_axes(self, joint: Joint) -> Array:
        """Return the axes of a joint in the frame of its child, shape (n, 3), with exact zeros and ones."""
        found = joint.axes @ self.body(joint.child).R
        whole = np.round(found)
        return np.where(np.abs(found - whole) < _ROUNDING, whole, found) + 0.0


def in_single_axes(model: Model, kinds: tuple[str, ...], cross: Callable[[Joint, Body], Body]) -> Model:
    """Replace joints of some kinds by revolute joints with small bodies in between.

    The function ``cross`` creates such a body, with the axes of the world frame, from the joint and the body
    that it carries. The first two axes of a spherical joint are perpendicular to the x axis of the child.
    """
    split = {
        joint.child: _split(joint, model.body(joint.child), cross)
        for joint in model.joints
        if joint.kind in kinds and not joint.cut
    }
    parts, joints = [], []
    for body in model.bodies:
        parts += [each for each, _ in split[body.name]] if body.name in split else [body]
    for joint in model.joints:
        whole = joint.cut or joint.child not in split
        joints += [joint] if whole else [each for _, each in split[joint.child]]
    return replace(model, bodies=tuple(parts), joints=tuple(joints))


def _split(joint: Joint, body: Body, cross: Callable[[Joint, Body], Body]) -> list[tuple[Body, Joint]]:
    """Return the bodies of a joint, its own body last, each with the revolute joint that carries it."""
    axes = body.R.T[[1, 2, 0]] if joint.kind == "spherical" else joint.axes
    found, parent = [], joint.parent
    for number, axis in enumerate(axes, 1):
        last = number == len(axes)
        small = replace(cross(joint, body), name=f"{joint.name}_cross_{number}", t=body.placed(joint.point))
        child = body if last else small
        point = joint.point if last else np.zeros(3)
        single = replace(
            joint, name=f"{joint.name}_{number}", kind="revolute", parent=parent, child=child.name
        )
        found.append((child, replace(single, point=point, axes=axis[None])))
        parent = child.name
    return found


def frame_along(axis: Array) -> Array:
    """Return a frame with the axes in columns, shape (3, 3), whose third axis has a given direction."""
    z = axis / np.linalg.norm(axis)
    x = rotation.cross(np.eye(3)[np.argmin(np.abs(z))], z)
    x = x / np.linalg.norm(x)
    return np.stack([x, rotation.cross(z, x), z], axis=-1)
