"""Fields of one leg of a robot from the bodies and joints of a model."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ..io.array_types import Array
from ..io.error_policy import errors_of
from ..motion import rotation
from .crosses import LOWER, UPPER, Cross, crosses_of, with_crosses
from .model import Body, Joint
from .offset_legs import OffsetLines
from .topology import Leg, Machine, Step

OPEN = 1e-3
"""Largest gap of a loop relative to a leg, and smallest offset or angle (rad) that is not taken as zero."""
_APART = 5e-3
"""Largest distance of axes from their common point, relative to a leg, and error of directions (rad)."""
_ROUNDING = 1e-9


def need_mass(body: Body, what: str) -> None:
    """Raise ValueError unless the mass of a body is > 0."""
    if not body.mass > 0.0:
        raise ValueError(f"{what}: body {body.name!r}: expected a mass > 0, got {body.mass:g}")


def common_point(machine: Machine, steps: Sequence[Step]) -> tuple[Array, float]:
    """Return the intersection of joint axes in the world frame, (3,), and its largest distance from one."""
    if len(steps) == 1:
        return machine.place(steps[0]), 0.0
    points = np.array([machine.place(step) for step in steps for _ in step.axes])
    axes = np.array([axis for step in steps for axis in step.axes])
    if not np.all(np.isfinite(points @ points.T)):
        raise ValueError(f"joint {steps[0].joint.name!r}: expected points whose squares are finite")
    across = np.eye(3) - axes[:, :, None] * axes[:, None, :]

    def off(point: Array) -> float:
        return float(np.linalg.norm(np.einsum("nij,nj->ni", across, point - points), axis=-1).max())

    right = np.einsum("nij,nj->i", across, points)
    meeting = np.linalg.lstsq(across.sum(axis=0), right, rcond=None)[0]
    return meeting, off(meeting)


def offset_lines(machine: Machine, leg: Leg) -> OffsetLines | None:
    """Return the axes of a leg if it has joint offsets: perpendicular axes that do not meet, else None."""
    if [len(step.axes) for step in leg.base] != [1, 1]:
        return None
    lines = _lines(machine, leg)
    s = _slide(leg, lines)
    if max(abs(lines.k @ lines.y), abs(lines.y @ s)) > OPEN:
        return None
    length = float(s @ (lines.tip - lines.A))
    # Axes at the platform that do not meet move the end of the leg.
    least = OPEN * length + common_point(machine, leg.tip)[1]
    return lines if max(map(abs, lines.offsets(s).values())) > least > 0.0 else None


def _lines(machine: Machine, leg: Leg) -> OffsetLines:
    """Return both axes at the base and the end of the sliding axis."""
    points = np.array([machine.place(step) for step in leg.base])
    axes = np.array([step.axes[0] for step in leg.base])
    return OffsetLines.of(points, axes, common_point(machine, leg.tip)[0])


def _slide(leg: Leg, lines: OffsetLines) -> Array:
    """Return the direction of the sliding axis away from the base, shape (3,)."""
    (s,) = leg.slide.axes
    return np.asarray(-s if s @ (lines.tip - lines.A) < 0.0 else s)


class LegFields:
    """Fields of one leg of a robot, with messages about assumptions.

    ``values`` and ``offset`` contain fields of the robot, ``off`` is the largest deviation that is treated as
    exact (relative to the leg and in rad), ``farthest`` the largest distance of axes from their intersection
    (m) with its place. ``sign`` is 1 if the coordinate of the slide increases with the leg length, else -1.
    """

    def __init__(self, machine: Machine, leg: Leg, number: int, offset: bool) -> None:
        """Compute all fields."""
        self.machine, self.leg, self.number = machine, leg, number
        self.said: list[str] = []
        self.off = 0.0
        self.farthest = (0.0, f"leg {number}")
        self.lower, self.upper = machine.bodies[leg.lower], machine.bodies[leg.upper]
        for body in (self.lower, self.upper):
            need_mass(body, f"leg {number}")
        with errors_of(f"leg {number}: "):
            self._place(offset)
            k = self._axis()
            self.base_joint = "spherical" if k is None else "universal"
            self.sign = self._sign(leg.slide)
            self.frame = self._frame(k)
            self.crosses = self._crosses(k)
            self.lower = with_crosses(self.lower, self.crosses, LOWER)
            self.upper = with_crosses(self.upper, self.crosses, UPPER)
            self.values = self._values(k)
        self.offset: dict[str, Any] = {}
        if self.lines is not None:
            cross = machine.bodies[leg.crosses[0][0]]
            lengths = self.lines.offsets(self.s).items()
            found = {key: each if abs(each) > _ROUNDING * self.L else 0.0 for key, each in lengths}
            self.offset = found | self.lines.cross(cross)

    def _place(self, offset: bool) -> None:
        """Compute the points at both ends, length, and direction of the leg."""
        self.tip, tip_apart = common_point(self.machine, self.leg.tip)
        self.lines = None
        if offset:
            if [len(step.axes) for step in self.leg.base] != [1, 1]:
                raise ValueError("expected two revolute joints at the base, since other legs have offsets")
            self.lines = _lines(self.machine, self.leg)
            self.b, self.foot, base_apart = self.lines.b, self.lines.A, 0.0
        else:
            self.b, base_apart = common_point(self.machine, self.leg.base)
            self.foot = self.b
        S = self.tip - self.foot
        L = float(np.linalg.norm(S))
        if not L > 0.0:
            raise ValueError("expected a leg with a length, got 0 m")
        self.s = S / L if self.lines is None else _slide(self.leg, self.lines)
        self.L = float(self.s @ S)
        self.p = self._own(self.machine.bodies[self.machine.platform], self.tip)
        self._need_meeting(self.leg.base, base_apart)
        self._need_meeting(self.leg.tip, tip_apart)

    def _own(self, body: Body, point: Array) -> Array:
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
        got = f"{2.0 * off:.3g} m between them"
        self._near(off / self.L, _APART, where, "axes that meet", got)
        self.farthest = max(self.farthest, (off, f"leg {self.number}: {where}"))
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

    def _crosses(self, k: Array | None) -> list[Cross]:
        """Assign the bodies between axes to parts, except the body between offset axes."""
        leg = self.leg if self.lines is None else replace(self.leg, crosses=((), self.leg.crosses[1]))
        return list(crosses_of(self.machine, leg, np.array([self.b, self.tip]), k))

    def _values(self, k: Array | None) -> dict[str, Any]:
        """Return the fields of the robot."""
        slide = self.leg.slide.joint
        return {
            "b": self.b,
            "p": self.p,
            "k": np.zeros(3) if k is None else k,
            **self._part(self.lower, self.foot, "d"),
            **self._part(self.upper, self.tip, "u"),
            "C_u": self._damping(self.leg.base),
            "C_p": slide.damping,
            "C_s": self._damping(self.leg.tip),
            "length_limits": self._limits(slide),
            "force_limit": slide.effort,
            "speed_limit": slide.speed,
        }

    def _part(self, body: Body, end: Array, part: str) -> dict[str, Any]:
        """Return mass, center of mass, and inertia of a part ("d" lower, "u" upper) in its frame."""
        Q = body.R.T @ self.frame
        center, inertia = Q.T @ (body.center - self._own(body, end)), Q.T @ body.inertia @ Q
        inertia = 0.5 * (inertia + inertia.T)
        if self.base_joint == "spherical":
            center, inertia = self._round(center, inertia)
        return {f"m_{part}": body.mass, f"r_{part}0": center, f"I_{part}0": inertia}

    def _round(self, center: Array, inertia: Array) -> tuple[Array, Array]:
        """Replace a body that is nearly a body of revolution by an exact one."""
        moments = np.diag(inertia)
        if moments[1] != moments[2]:
            moments = np.array([moments[0], *(2 * [0.5 * (moments[1] + moments[2])])])
        line, whole = np.array([center[0], 0.0, 0.0]), np.diag(moments)
        apart, different = np.abs(center - line).max() / self.L, np.abs(inertia - whole).max() / moments.max()
        off = float(max(apart, different))
        if off > OPEN:
            return center, inertia
        self.off = max(self.off, off)
        return line, whole

    def _damping(self, steps: Sequence[Step]) -> float:
        """Return the damping of the joints at one end, which have one common value."""
        found = [step.joint.damping for step in steps]
        if max(found) - min(found) > _ROUNDING * max(found):
            names = ", ".join(repr(step.joint.name) for step in steps)
            self.said.append(f"leg {self.number}: joints {names}: the mean of their damping is taken")
            return float(np.mean(found))
        return found[0]

    def _limits(self, joint: Joint) -> tuple[float, float]:
        """Return the length limits of the leg (m)."""
        if not joint.limited:
            return 0.0, np.inf
        if not joint.limits[0] < joint.limits[1]:
            got = f"{joint.limits[0]:g} to {joint.limits[1]:g}"
            raise ValueError(f"joint {joint.name!r}: expected limits from low to high, got {got}")
        zero = self.L - self.sign * joint.position
        if abs(zero) < _ROUNDING * self.L:
            zero = 0.0
        low, high = sorted(zero + self.sign * limit for limit in joint.limits)
        return max(0.0, low), high
