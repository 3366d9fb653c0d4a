"""Fields of one leg of a robot from the bodies and joints of a model."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ..io.array_types import Array
from ..io.error_policy import errors_of
from ..motion import rotation
from ..robot import bodies
from .model import Body
from .topology import Leg, Machine, Step

OPEN = 1e-3
"""Largest gap of a loop relative to a leg, and smallest offset or angle (rad) that is not taken as zero."""
LOWER, UPPER, PLATFORM = "lower part", "upper part", "platform"
_APART = 5e-3
"""Largest distance of axes from their common point, relative to a leg, and error of directions (rad)."""
_ROUNDING = 1e-9


@dataclass(frozen=True, eq=False)
class OffsetLines:
    """Both axes at the base and the sliding axis of a leg, in the world frame, shape (3,) each.

    The common normal o of both axes begins at the base point b and meets the moving axis at A. The
    directions of the fixed and of the moving axis are k and y. The sliding axis ends at ``tip`` with the
    direction s away from the base.
    """

    b: Array
    A: Array
    k: Array
    y: Array
    tip: Array
    s: Array

    def offsets(self) -> dict[str, float]:
        """Compute the offset lengths."""
        r, o = self.tip - self.A, np.cross(self.y, self.k)
        return {
            "axis_offset": float((self.A - self.b) @ o),
            "slide_offset_y": float(r @ self.y),
            "slide_offset_z": float(r @ np.cross(self.s, self.y)),
        }

    def cross(self, body: Body) -> dict[str, Any]:
        """Return mass, center of mass (from the base point along o, y, k), and inertia of a cross."""
        frame = np.stack([np.cross(self.y, self.k), self.y, self.k], axis=-1)
        mass, center, inertia = body.solid
        center = (center - self.b) @ frame if mass else np.zeros(3)
        return {"cross_mass": mass, "cross_center": center, "cross_inertia": float(self.k @ inertia @ self.k)}


def offset_lines(machine: Machine, leg: Leg) -> OffsetLines:
    """Return the lines of a leg with two revolute joints at the base."""
    if [len(step.axes) for step in leg.base] != [1, 1]:
        raise ValueError("expected two revolute joints at the base, since other legs have offsets")
    first, second = (machine.place(step) for step in leg.base)
    k, y = (step.axes[0] for step in leg.base)
    tip, between = common_point(machine, leg.tip)[0], second - first
    b, A = first + (between @ k) * k, second - (between @ y) * y
    y = -y if np.cross(y, k) @ (tip - b) < 0.0 else y
    (s,) = leg.slide.axes
    return OffsetLines(b, A, k, y, tip, -s if s @ (tip - A) < 0.0 else s)


def has_offsets(machine: Machine, leg: Leg) -> bool:
    """Return True for perpendicular axes at the base that do not meet."""
    if [len(step.axes) for step in leg.base] != [1, 1]:
        return False
    lines = offset_lines(machine, leg)
    if max(abs(lines.k @ lines.y), abs(lines.y @ lines.s)) > OPEN:
        return False
    # Axes at the platform that do not meet move the end of the leg.
    least = OPEN * float(lines.s @ (lines.tip - lines.A)) + common_point(machine, leg.tip)[1]
    return max(map(abs, lines.offsets().values())) > least > 0.0


def common_point(machine: Machine, steps: Sequence[Step]) -> tuple[Array, float]:
    """Return the intersection of joint axes in the world frame, (3,), and its largest distance from one."""
    if len(steps) == 1:
        return machine.place(steps[0]), 0.0
    points = np.array([machine.place(step) for step in steps for _ in step.axes])
    axes = np.array([axis for step in steps for axis in step.axes])
    across = np.eye(3) - axes[:, :, None] * axes[:, None, :]
    right = np.einsum("nij,nj->i", across, points)
    meeting = np.linalg.lstsq(across.sum(axis=0), right, rcond=None)[0]
    off = np.einsum("nij,nj->ni", across, meeting - points)
    return meeting, float(np.linalg.norm(off, axis=-1).max())


def need_mass(body: Body, what: str) -> None:
    """Raise ValueError unless the mass of a body is > 0."""
    if not body.mass > 0.0:
        raise ValueError(f"{what}: body {body.name!r}: expected a mass > 0, got {body.mass:g}")


class Cross(NamedTuple):
    """Body between the axes of a joint, which is added to a part.

    exact: True if forces at rest do not change. rigid: True if it rotates like the part, or has no inertia.
    """

    name: str
    part: str
    solid: bodies.Body
    exact: bool
    rigid: bool


class LegFields:
    """Fields of one leg of a robot, with messages about assumptions.

    ``values`` and ``offset`` contain fields of the robot. ``off`` is the largest deviation that is treated as
    exact (relative to the leg and in rad). ``farthest`` is the largest distance (m) of axes or of a body from
    an intersection of axes, with its place. ``sign`` is 1 if the coordinate of the slide increases with the
    leg length, else -1. ``crosses`` contains the bodies between axes, as the parts to which they are added.
    """

    def __init__(self, machine: Machine, leg: Leg, number: int, offset: bool) -> None:
        """Compute all fields."""
        self.machine, self.leg, self.number = machine, leg, number
        self.said: list[str] = []
        self.off = 0.0
        self.farthest = (0.0, f"leg {number}")
        self.crosses: list[Cross] = []
        self.offset: dict[str, Any] = {}
        lower, upper = machine.bodies[leg.lower], machine.bodies[leg.upper]
        for body in (lower, upper):
            need_mass(body, f"leg {number}")
        with errors_of(f"leg {number}: "):
            self._place(offset)
            k = self._axis()
            self.base_joint = "spherical" if k is None else "universal"
            self.sign = self._sign(leg.slide)
            self.frame = self._frame(k)
            self._take_crosses(k)
            self.values = {
                "b": self.b,
                "p": self.p,
                "k": np.zeros(3) if k is None else k,
                **self._part(with_crosses(lower, [self], LOWER), self.foot, "d"),
                **self._part(with_crosses(upper, [self], UPPER), self.tip, "u"),
                "C_u": self._damping(leg.base),
                "C_p": leg.slide.joint.damping,
                "C_s": self._damping(leg.tip),
                "length_limits": self._limits(leg.slide),
                "force_limit": leg.slide.joint.effort,
                "speed_limit": leg.slide.joint.speed,
            }

    def _place(self, offset: bool) -> None:
        """Compute the points at both ends, length, and direction of the leg."""
        self.tip, tip_apart = common_point(self.machine, self.leg.tip)
        self.lines = offset_lines(self.machine, self.leg) if offset else None
        if self.lines is None:
            self.b, base_apart = common_point(self.machine, self.leg.base)
            self.foot = self.b
        else:
            self.b, self.foot, base_apart = self.lines.b, self.lines.A, 0.0
        S = self.tip - self.foot
        length = float(np.linalg.norm(S))
        if not length > 0.0:
            raise ValueError("expected a leg with a length, got 0 m")
        self.s = S / length if self.lines is None else self.lines.s
        self.L = float(self.s @ S)
        self.p = self._local(self.machine.bodies[self.machine.platform], self.tip)
        self._need_meeting(self.leg.base, base_apart)
        self._need_meeting(self.leg.tip, tip_apart)

    def _local(self, body: Body, point: Array) -> Array:
        """Return a point in the frame of a body, with exact zeros for rounding errors."""
        found = body.local(point)
        return np.where(np.abs(found) < _ROUNDING * self.L, 0.0, found)

    def _near(self, off: float, limit: float, where: str, expected: str, got: str) -> None:
        """Reject a large deviation, and record a small one."""
        if off > limit:
            raise ValueError(f"{where}: expected {expected}, got {got}")
        self.off = max(self.off, off)

    def _need_meeting(self, steps: Sequence[Step], off: float) -> None:
        """Reject axes that do not intersect in the pose of the file, and parallel successive axes."""
        if len(steps) == 1:
            return
        where = f"joints {' and '.join(repr(step.joint.name) for step in steps)}"
        # The assumed intersection is in the middle between the two axes.
        self._near(off / self.L, _APART, where, "axes that meet", f"{2.0 * off:.3g} m between them")
        self.farthest = max(
            self.farthest, (off, f"leg {self.number}: {where}: axes {2e3 * off:.3g} mm apart")
        )
        axes = np.concatenate([step.axes for step in steps])
        if np.linalg.norm(rotation.cross(axes[1:], axes[:-1]), axis=-1).min() < OPEN:
            raise ValueError(f"{where}: expected each axis at an angle to the next one, got parallel ones")

    def _axis(self) -> Array | None:
        """Return the fixed axis of a universal joint, shape (3,), or None for a spherical joint."""
        axes = [axis for step in self.leg.base for axis in step.axes]
        if len(axes) != 2:
            return None
        where = f"joint {self.leg.base[0].joint.name!r}"
        for cosine, what in (
            (axes[0] @ axes[1], "axes at right angles"),
            (axes[1] @ self.s, "a second axis at right angles to the leg"),
        ):
            got = f"{np.degrees(np.arccos(min(1.0, abs(cosine)))):.7g} deg"
            self._near(abs(float(cosine)), _APART, where, what, got)
        return np.asarray(axes[0])

    def _sign(self, slide: Step) -> float:
        """Return 1 if the joint coordinate increases with the leg length, otherwise -1."""
        (axis,) = slide.axes
        along = float(axis @ self.s)
        off = float(np.linalg.norm(axis - along * self.s))
        expected = "sliding along the line between the ends"
        got = f"{np.degrees(np.arcsin(min(1.0, off))):.3g} deg off"
        self._near(off, _APART, f"joint {slide.joint.name!r}", expected, got)
        return 1.0 if along > 0.0 else -1.0

    def _frame(self, k: Array | None) -> Array:
        """Return frame D with axes in columns, (3, 3); only x is defined for spherical joints."""
        if k is None:
            k = np.eye(3)[np.argmin(np.abs(self.s))]
        y = rotation.cross(k, self.s) if self.lines is None else self.lines.y
        sine = float(np.linalg.norm(y))
        if sine < OPEN:
            raise ValueError("fixed axis along the leg in the pose of the file; use another pose")
        y = y / sine
        return np.stack([self.s, y, rotation.cross(self.s, y)], axis=-1)

    def _take_crosses(self, k: Array | None) -> None:
        """Assign the bodies between axes to parts; the body between offset axes has its own fields."""
        at_base, at_tip = self.leg.crosses
        if self.lines is not None:
            lengths = self.lines.offsets().items()
            found = {key: each if abs(each) > _ROUNDING * self.L else 0.0 for key, each in lengths}
            self.offset = found | self.lines.cross(self.machine.bodies[at_base[0]])
            at_base = ()
        for steps, names in ((self.leg.base, at_base), (self.leg.tip, at_tip)):
            axes = [step.axes for step in steps]
            for number, name in enumerate(names, 1):
                body = self.machine.bodies[name]
                if body.mass < 0.0:
                    raise ValueError(f"body {name!r}: expected a mass >= 0, got {body.mass:g}")
                if body.mass or body.inertia.any():
                    before, behind = np.concatenate(axes[:number]), np.concatenate(axes[number:])
                    self._take(body, before, behind, steps is self.leg.base, k)

    def _take(self, body: Body, before: Array, behind: Array, base: bool, k: Array | None) -> None:
        """Assign a body between the axes before and behind it, shape (n, 3), to the part that moves like it.

        The body shares one axis with the part, on which its mass remains; elsewhere it is moved to the
        intersection of the axes.
        """
        part = LOWER if base else UPPER if len(before) == 1 else PLATFORM
        axis, point = (before[0] if part == UPPER else behind[0]), self.b if base else self.tip
        mass, center, inertia = body.solid
        arm = center - point
        # A leg between spherical joints does not rotate about its own line.
        shared = k is not None and len(behind if base else before) == 1
        kept = (arm @ axis) * axis if part == PLATFORM or shared else np.zeros(3)
        lost = arm - kept
        if base and len(before) == 1:
            lost = lost - (lost @ before[0]) * before[0]
        off = float(np.linalg.norm(lost))
        place = f"body {body.name!r}: center of mass {1e3 * off:.3g} mm off the intersection of the axes"
        self.farthest = max(self.farthest, (off, place))
        if base and k is not None:
            # Such a body rotates about the fixed axis only.
            inertia = (k @ inertia @ k) * (np.eye(3) - np.outer(axis, axis))
        elif k is None and part != PLATFORM:
            inertia = np.trace(inertia) / 3.0 * np.eye(3)
        rigid = (part == LOWER and k is not None) or not body.inertia.any()
        exact = off <= _ROUNDING * self.L
        self.crosses.append(Cross(body.name, part, bodies.Body(mass, point + kept, inertia), exact, rigid))

    def _part(self, body: Body, end: Array, part: str) -> dict[str, Any]:
        """Return mass, center of mass, and inertia of a part ("d" lower, "u" upper) in its frame."""
        Q = body.R.T @ self.frame
        center, inertia = Q.T @ (body.center - self._local(body, end)), Q.T @ body.inertia @ Q
        inertia = 0.5 * (inertia + inertia.T)
        if self.base_joint == "spherical":
            # A nearly exact body of revolution becomes an exact one; a robot rejects others.
            middle = 0.5 * (inertia[1, 1] + inertia[2, 2])
            line, whole = np.array([center[0], 0.0, 0.0]), np.diag([inertia[0, 0], middle, middle])
            apart, different = np.abs(center - line).max() / self.L, np.abs(inertia - whole).max()
            off = float(max(apart, different / np.diag(inertia).max()))
            if off <= OPEN:
                self.off, center, inertia = max(self.off, off), line, whole
        return {f"m_{part}": body.mass, f"r_{part}0": center, f"I_{part}0": inertia}

    def _damping(self, steps: Sequence[Step]) -> float:
        """Return the damping of the joints at one end, which have one common value."""
        found = [step.joint.damping for step in steps]
        if max(found) - min(found) > _ROUNDING * max(found):
            names = ", ".join(repr(step.joint.name) for step in steps)
            self.said.append(f"leg {self.number}: joints {names}: the mean of their damping is taken")
            return float(np.mean(found))
        return found[0]

    def _limits(self, slide: Step) -> tuple[float, float]:
        """Return the length limits of the leg (m)."""
        joint = slide.joint
        if not joint.limits[0] < joint.limits[1]:
            got = f"{joint.limits[0]:g} to {joint.limits[1]:g}"
            raise ValueError(f"joint {joint.name!r}: expected limits from low to high, got {got}")
        zero = self.L - self.sign * joint.position
        if abs(zero) < _ROUNDING * self.L:
            zero = 0.0
        low, high = sorted(zero + self.sign * limit for limit in joint.limits)
        if np.isinf(high) and low > 0.0:
            self.said.append(
                f"left out: shortest length {low:.4g} m of leg {self.number}, without a longest one"
            )
        return (0.0, high) if np.isinf(high) else (max(0.0, low), high)


def with_crosses(body: Body, legs: Sequence[LegFields], part: str) -> Body:
    """Add the bodies between axes that are assigned to a part to its mass, center of mass, and inertia."""
    taken = [each.solid for leg in legs for each in leg.crosses if each.part == part]
    return body.with_solids([body.solid, *taken]) if taken else body
