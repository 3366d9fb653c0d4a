"""A machine as bodies and joints: what every format is written from and read into.

Poses are those in which the model stands in its file, in the world frame.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ..io.array_types import Array
from ..motion import rotation

WORLD = "world"
"""Name of what does not move."""

BETWEEN = ", joint "
"""In names of the bodies without mass between two joints that a file gives one body, before a number."""

_COLORS = {"lower": (0.35, 0.4, 0.47), "upper": (0.75, 0.78, 0.8), "platform": (0.2, 0.45, 0.7)}
_GRAY = (0.5, 0.5, 0.5)
_ROUNDING = 4e-16
_SAME = 1e-9
_SHORT = 1e-12


@dataclass(frozen=True, eq=False)
class Shape:
    """A cylinder from start to end, (3,), m, body frame; a sphere where both are one point."""

    radius: float
    start: Array
    end: Array

    @property
    def length(self) -> float:
        """Length of the cylinder, m; 0 of a sphere."""
        return float(np.linalg.norm(self.end - self.start))

    @property
    def middle(self) -> Array:
        """Middle of the shape, (3,)."""
        return 0.5 * (self.start + self.end)

    @property
    def frame(self) -> Array:
        """Axes, (3, 3), in columns, in the body frame; the third one along the cylinder."""
        return frame_along(self.end - self.start) if self.length else np.eye(3)


@dataclass(frozen=True, eq=False)
class Body:
    """A rigid body.

    R, t: axes in columns, (3, 3), and origin, (3,). mass: kg, 0 of what only joins others. center, inertia:
    center of mass, m, and inertia about it, kg m^2, body frame.
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
        """Red, green and blue of its shapes, 0 to 1."""
        return _COLORS.get(self.name.partition("_")[0], _GRAY)

    def placed(self, point: Array) -> Array:
        """A point of the body frame in the world frame, (3,)."""
        return np.asarray(self.t + self.R @ point)

    def local(self, point: Array) -> Array:
        """A point of the world frame in the body frame, (3,)."""
        return np.asarray(self.R.T @ (point - self.t))


@dataclass(frozen=True, eq=False)
class Joint:
    """A joint, or a closure of a loop if ``cut``.

    kind: ``revolute`` or ``prismatic`` with one axis, ``universal`` with two, ``spherical``, ``fixed``,
    ``free``.
    point: in the child's frame, (3,), m. parent_point: of a cut, in the parent's. axes: directions, world
    frame, (n, 3), those nearer the parent first. damping: N m s or N s/m. armature: kg or kg m^2, inertia of
    the drive as seen by the joint. position: coordinate in which the model stands, of a fixed
    cut the angle by which it is open, rad. limits: of it.
    effort, speed: limits of the drive, N or N m, m/s or rad/s. driven: whether it has a drive.
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

    @property
    def limited(self) -> bool:
        """Whether the coordinate has limits on both sides."""
        return bool(np.all(np.isfinite(self.limits)))

    def travel(self, unlimited: float) -> tuple[float, float]:
        """Limits counted from where the model stands; -unlimited and unlimited where there are none."""
        if not self.limited:
            return -unlimited, unlimited
        low, high = self.limits
        return low - self.position, high - self.position


@dataclass(frozen=True, eq=False)
class Model:
    """A machine: bodies, the world among them, and joints, each body after what carries it.

    gravity: m/s^2, (3,), None where the file has none. notes: fields of a robot by name that the format
    has no place for, or that it gives less exactly. left_out: what of the file has no place in a model.
    assumed: by the body's name, what is taken where the file states nothing.
    armatures: whether the format has a place for those of joints, so that none stated is none.
    """

    name: str
    gravity: Array | None
    bodies: tuple[Body, ...]
    joints: tuple[Joint, ...]
    notes: Mapping[str, Any] = field(default_factory=dict)
    left_out: tuple[str, ...] = ()
    assumed: Mapping[str, str] = field(default_factory=dict)
    armatures: bool = False

    def body(self, name: str) -> Body:
        """The body of a name; ValueError where there is none."""
        for body in self.bodies:
            if body.name == name:
                return body
        raise ValueError(f"body {name!r}: missing")

    def carrier(self, body: Body) -> Joint | None:
        """The joint of the tree, no closure, that carries a body."""
        return next((joint for joint in self.joints if joint.child == body.name and not joint.cut), None)

    def origin(self, joint: Joint) -> Array:
        """Origin of a joint's child in its parent's frame, (3,); of a slide on its axis but for rounding."""
        parent, child = self.body(joint.parent), self.body(joint.child)
        place = child.t if parent.name == WORLD else parent.local(child.t)
        along = joint.position * self.local_axes(joint)[0] if joint.kind == "prismatic" else np.zeros(3)
        return place if np.abs(place - along).max() > _SHORT * np.abs(place).max() else along

    def local_axes(self, joint: Joint) -> Array:
        """Axes of a joint in its child's frame, (n, 3), without the rounding of zeros and ones."""
        found = joint.axes @ self.body(joint.child).R
        whole = np.round(found)
        return np.where(np.abs(found - whole) < _ROUNDING, whole, found) + 0.0


def in_single_axes(model: Model, kinds: tuple[str, ...], cross: Callable[[Joint, Body], Body]) -> Model:
    """The model with joints of some kinds replaced by revolute ones and small bodies between them.

    cross: makes such a body, with axes of the world, from the joint and the body that it carries. A spherical
    joint turns about axes across the child's x axis first.
    """
    split = {
        joint.child: _split(joint, model.body(joint.child), cross)
        for joint in model.joints
        if joint.kind in kinds and not joint.cut
    }
    bodies, joints = [], []
    for body in model.bodies:
        bodies += [each for each, _ in split[body.name]] if body.name in split else [body]
    for joint in model.joints:
        whole = joint.cut or joint.child not in split
        joints += [joint] if whole else [each for _, each in split[joint.child]]
    return replace(model, bodies=tuple(bodies), joints=tuple(joints))


def _split(joint: Joint, body: Body, cross: Callable[[Joint, Body], Body]) -> list[tuple[Body, Joint]]:
    """Bodies, the joint's own last, each with the revolute joint that carries it."""
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
    """A frame, (3, 3), axes in columns, whose third axis has the direction of a vector, (3,)."""
    z = axis / np.linalg.norm(axis)
    x = rotation.cross(np.eye(3)[np.argmin(np.abs(z))], z)
    x = x / np.linalg.norm(x)
    return np.stack([x, rotation.cross(z, x), z], axis=-1)


def after(outer: tuple[Array, Array], R: Array, t: Array) -> tuple[Array, Array]:
    """Orientation and position in the world, from those in a frame that stands there as ``outer`` says."""
    if np.array_equal(outer[0], np.eye(3)):
        return R, t + outer[1]
    return outer[0] @ R, outer[1] + outer[0] @ t


def same_frame(one: Array, other: Array) -> bool:
    """Whether two frames differ by rounding alone."""
    return bool(np.abs(one - other).max() < _SAME)
