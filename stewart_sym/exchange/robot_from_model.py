"""Conversion of a model to a robot, with messages about all assumptions."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ..io.arguments import safe_text
from ..io.array_types import Array
from ..io.error_policy import errors_of
from ..motion import rotation
from ..robot.drive import Drive
from ..robot.fields import DEFAULT_GRAVITY
from ..robot.offsets import JointOffsets
from ..robot.robot import Robot
from .crosses import LOWER, PLATFORM, UPPER, Cross, crosses_of, largest_error, lines_of, with_crosses
from .model import WORLD, Body, Joint, Model, same_frame
from .model_from_robot import SLIDES
from .notes import with_notes
from .offset_legs import OffsetLines
from .topology import Leg, Machine, Step, machine_of

_CLOSED = "that is closed in the pose of the file"
_OPEN = 1e-3
"""Largest distance of joints from their nominal points, relative to a leg, and of directions (rad)."""
_SAID = 1e-9
"""Smallest deviation that is reported."""
_ROUNDING = 1e-9
_MOST_OFF = 0.01
"""Largest error of a force that is only reported, relative to the mean load of a leg."""
_SAME_MASS = 1e-12
_LEAD = 0.005
"""Lead of a screw (m), assumed if a model has an armature but no screw."""


def robot_of(model: Model) -> tuple[Robot, tuple[str, ...]]:
    """Return the robot and one message for each assumption; raise ValueError for other mechanisms."""
    said: list[str] = []
    machine, order = _ordered(machine_of(model), model, said)
    # Axes that do not intersect are an error unless a note contains joint offsets.
    offset = "offsets" in model.notes
    open_by = _open_by(machine, model)
    legs = [_Leg(machine, leg, i, said, offset) for i, leg in enumerate(machine.legs, 1)]
    kinds = [leg.base_joint for leg in legs]
    usual = max(kinds, key=kinds.count)
    for leg in legs:
        if leg.base_joint != usual:
            where = f"leg {leg.number}: joint {leg.leg.base[0].joint.name!r}"
            expected = f"expected a {usual} joint at the base as leg {kinds.index(usual) + 1} has"
            raise ValueError(f"{where}: {expected}, got a {leg.base_joint} one")
    off = max(open_by, *(leg.off for leg in legs))
    if off > _SAID:
        said.insert(0, f"axes and loops have errors of up to {off:.2g} rad or of a leg, treated as exact")
    platform = machine.bodies[machine.platform]
    _need_mass(platform, "the platform")
    crosses = [each for leg in legs for each in leg.crosses]
    platform = with_crosses(platform, crosses, PLATFORM)
    # A different platform frame is aligned with the base frame, so that the pose in the file is a home pose.
    level = same_frame(platform.R, np.eye(3))
    R = np.eye(3) if level else platform.R
    frame = f"that of {machine.platform!r}"
    if not level:
        frame = f"the origin of {machine.platform!r}, axes those of the base in the pose in the file"
    who = ", ".join(f"{i} {leg.lower!r} {leg.upper!r}" for i, leg in enumerate(machine.legs, 1))
    lines = [f"legs in the order of {order}: {who}", f"base frame: the world's; platform frame: {frame}"]
    lines += _platform_line(model, machine)
    if model.gravity is None:
        lines.append("gravity: not in the file, (0, 0, -9.81) m/s^2 is taken")
    found: dict[str, Any] = {
        "name": safe_text(model.name).strip() or "imported",
        "base_joint": kinds[0],
        "g": np.array(DEFAULT_GRAVITY) if model.gravity is None else model.gravity,
        "M": platform.mass,
        "R_0": R @ platform.center,
        "I_p": R @ platform.inertia @ R.T,
        "home_position": platform.t,
        **{key: [leg.values[key] for leg in legs] for key in legs[0].values},
        "p": [R @ leg.p for leg in legs],
    }
    if offset:
        offsets: dict[str, Any] = {key: [leg.offset[key] for leg in legs] for key in legs[0].offset}
        found["offsets"] = JointOffsets(**offsets)
    drive = _drive(legs)
    robot = Robot(**found, drive=drive)
    lines.append(_mass_kept(machine, model, robot))
    said += _crosses_said(legs, platform, robot)
    robot, kept = with_notes(robot, model)
    if drive is not None and robot.drive is drive:
        said.append(f"armatures of the slides: rotors behind screws with a lead of {_LEAD:g} m")
    if robot.home_position is not None:
        lines.append("home: the pose in the file")
    lines += [text for name, text in model.assumed.items() if machine.members[name] != WORLD]
    left_out = [f"left out: {text}" for text in _grouped([*model.left_out, *_beside_slides(model)])]
    return robot, tuple(lines + said + left_out + kept)


def _mass_kept(machine: Machine, model: Model, robot: Robot) -> str:
    """Compare the moving mass in the file with the robot; raise ValueError if it differs."""
    moving = sum(body.mass for body in model.bodies if machine.members[body.name] != WORLD)
    crosses = 0.0 if robot.offsets is None else float(robot.offsets.cross_mass.sum())
    kept = robot.M + float(robot.m_d.sum()) + float(robot.m_u.sum()) + crosses
    if abs(kept - moving) > _SAME_MASS * moving:
        got = f"expected {moving:.13g} kg as in the file, got {kept:.13g} kg"
        raise ValueError(f"mass of the bodies that move: {got}")
    return f"mass of the bodies that move: {moving:.7g} kg in the file, {kept:.7g} kg imported"


def _platform_line(model: Model, machine: Machine) -> list[str]:
    """Write a message about the choice of the platform among bodies that are fixed together."""
    masses = {body.name: body.mass for body in model.bodies if machine.members[body.name] == machine.platform}
    if len(masses) < 2:
        return []
    heavier = [repr(name) for name, mass in masses.items() if mass > masses[machine.platform]]
    reason = "the heaviest of the bodies that are fixed together"
    if heavier:
        reason = f"to which the legs are attached; heavier, but only fixed to it: {', '.join(heavier)}"
    return [f"platform: {machine.platform!r}, {reason}"]


def _crosses_said(legs: Sequence["_Leg"], platform: Body, robot: Robot) -> Iterator[str]:
    """Write messages about the bodies between axes; raise ValueError if their effect is large."""
    crosses = [leg.crosses for leg in legs]
    # Without gravity in the file, the effect in motion is estimated with the gravity of the earth.
    g = robot.g if robot.g.any() else np.asarray(DEFAULT_GRAVITY)
    s, p = np.array([leg.s for leg in legs]), np.array([platform.R @ leg.p for leg in legs])
    error = largest_error(crosses, p, s, g)
    mass = robot.M + float(robot.m_d.sum()) + float(robot.m_u.sum())
    limit = _MOST_OFF * float(np.linalg.norm(g)) * mass / len(legs)
    if error > limit:
        every = [each for of_leg in crosses for each in of_leg]
        worst = max(every, key=lambda each: each.body.mass * each.lost)
        raise ValueError(
            f"body {worst.body.name!r}: expected its center of mass at the intersection of the axes, got "
            f"{1e3 * worst.lost:.3g} mm off, which changes forces by up to {error:.3g} N (limit {limit:.3g} "
            f"N, {100.0 * _MOST_OFF:g} % of the weight per leg); move its center of mass, or reduce its mass"
        )
    return lines_of(crosses, error)


def _open_by(machine: Machine, model: Model) -> float:
    """Compute the largest relative and angular (rad) error of welds and loops; reject large errors."""
    ends = [(machine.place(leg.base[0]), machine.place(leg.tip[-1])) for leg in machine.legs]
    length, off = float(np.median([np.linalg.norm(tip - base) for base, tip in ends])), 0.0
    far: dict[str, list[tuple[str, str]]] = {}
    for joint in model.joints:
        if joint.cut:
            gap, angle = machine.gap(joint), joint.position if joint.kind == "fixed" else 0.0
            off = max(off, gap / length, angle)
            if max(gap / length, angle) > _OPEN:
                by = f"{gap:.3g} m" if gap > _OPEN * length else f"{np.degrees(angle):.3g} deg"
                far.setdefault("weld" if joint.kind == "fixed" else "loop", []).append((repr(joint.name), by))
    for what, found in far.items():
        names, by = (", ".join(words) for words in zip(*found, strict=True))
        if len(found) == 1:
            raise ValueError(f"joint {names}: expected a {what} {_CLOSED}, got one open by {by}")
        expected = f"expected {what}s that are closed in the pose of the file"
        raise ValueError(f"joints {names}: {expected}, got ones open by {by}")
    return off


def _beside_slides(model: Model) -> Iterator[str]:
    """Yield properties of joints other than prismatic ones that a robot cannot represent."""
    for joint in model.joints:
        if joint.kind != "prismatic" and joint.armature:
            yield f"armature {joint.armature:g} of joint {joint.name!r}"
        if joint.kind == "free" and joint.damping:
            yield f"damping {joint.damping:g} of joint {joint.name!r}"


def _grouped(left_out: Sequence[str]) -> Iterator[str]:
    """Combine equal messages about several joints."""
    joints: dict[str, list[str]] = {}
    for text in dict.fromkeys(left_out):
        what, found, name = text.partition(" of joint ")
        joints.setdefault(what if found else text, []).append(name)
    for what, names in joints.items():
        yield what + (f" of joint{'s' if len(names) > 1 else ''} {', '.join(names)}" if any(names) else "")


def _ordered(machine: Machine, model: Model, said: list[str]) -> tuple[Machine, str]:
    """Return the machine with its legs in the order of the notes, and the source of the order."""
    names = [leg.slide.joint.name for leg in machine.legs]
    if not model.notes or tuple(names) == SLIDES:
        return machine, "the file"
    if sorted(names) != list(SLIDES):
        said.append("notes: legs in the order of the file, because its prismatic joints have other names")
        return machine, "the file"
    return replace(machine, legs=tuple(machine.legs[names.index(name)] for name in SLIDES)), "the notes"


def _drive(legs: Sequence["_Leg"]) -> Drive | None:
    """Return drives whose rotors have the armatures of the prismatic joints; None without armatures."""
    armature = np.array([leg.leg.slide.joint.armature for leg in legs])
    if not armature.any():
        return None
    return Drive(lead=np.full(len(legs), _LEAD), rotor_inertia=armature * (_LEAD / (2.0 * np.pi)) ** 2)


def _need_mass(body: Body, what: str) -> None:
    """Raise ValueError unless the mass of a body is > 0."""
    if not body.mass > 0.0:
        raise ValueError(f"{what}: body {body.name!r}: expected a mass > 0, got {body.mass:g}")


class _Leg:
    """Fields of one leg of a robot; messages about assumptions are appended to ``said``."""

    def __init__(self, machine: Machine, leg: Leg, number: int, said: list[str], offset: bool) -> None:
        """Compute all fields."""
        self.machine, self.leg, self.number, self.said = machine, leg, number, said
        self.lower, self.upper = machine.bodies[leg.lower], machine.bodies[leg.upper]
        for body in (self.lower, self.upper):
            _need_mass(body, f"leg {number}")
        self.off = 0.0
        self.apart: list[tuple[float, Sequence[Step]]] = []
        self.tip = self._common(leg.tip)
        self.lines = self._lines() if offset else None
        self.b = self._common(leg.base) if self.lines is None else self.lines.b
        self.foot = self.b if self.lines is None else self.lines.A
        self.L, self.s = self._sliding()
        self.p = self._platform_point()
        self._need_meeting()
        k = self._axis()
        self.base_joint = "spherical" if k is None else "universal"
        self.sign = self._sign(leg.slide)
        self.frame = self._frame(k)
        self.crosses = self._crosses(k)
        self.lower = with_crosses(self.lower, self.crosses, LOWER)
        self.upper = with_crosses(self.upper, self.crosses, UPPER)
        self.values = {
            "b": self.b,
            "p": self.p,
            "k": np.zeros(3) if k is None else k,
            **self._part(self.lower, leg.base, "d"),
            **self._part(self.upper, leg.tip, "u"),
            "C_u": self._damping(leg.base),
            "C_p": leg.slide.joint.damping,
            "C_s": self._damping(leg.tip),
            "length_limits": self._limits(leg.slide.joint),
            "force_limit": leg.slide.joint.effort,
            "speed_limit": leg.slide.joint.speed,
        }
        self.offset: dict[str, Any] = {}
        if self.lines is not None:
            cross = machine.bodies[leg.crosses[0][0]]
            self.offset = self.lines.offsets(self.s) | self.lines.cross(cross)

    def _lines(self) -> OffsetLines:
        """Return both axes at the base and the end of the sliding axis."""
        base = self.leg.base
        if [len(step.axes) for step in base] != [1, 1]:
            raise self._error("expected two revolute joints at the base, since the notes state offsets")
        points = np.array([self.machine.place(step) for step in base])
        return OffsetLines.of(points, np.array([step.axes[0] for step in base]), self.tip)

    def _sliding(self) -> tuple[float, Array]:
        """Return the leg length, from the foot or along the sliding axis, and the direction, shape (3,)."""
        S = self.tip - self.foot
        L = float(np.linalg.norm(S))
        if self.lines is not None:
            (s,) = self.leg.slide.axes
            s = -s if s @ S < 0.0 else s
            L = float(s @ S)
        if not L > 0.0:
            raise self._error("expected a leg with a length, got 0 m")
        return L, s if self.lines is not None else S / L

    def _error(self, text: str) -> ValueError:
        """Create an error with the number of the leg."""
        return ValueError(f"leg {self.number}: {text}")

    def _common(self, steps: Sequence[Step]) -> Array:
        """Return the intersection of joint axes, shape (3,), in the world frame."""
        if len(steps) == 1:
            return self.machine.place(steps[0])
        points = np.array([self.machine.place(step) for step in steps for _ in step.axes])
        axes = np.array([axis for step in steps for axis in step.axes])
        if not np.all(np.isfinite(points @ points.T)):
            raise self._error("expected points whose squares are finite")
        across = np.eye(3) - axes[:, :, None] * axes[:, None, :]

        def off(point: Array) -> float:
            return float(np.linalg.norm(np.einsum("nij,nj->ni", across, point - points), axis=-1).max())

        meeting = points[0] if off(points[0]) < _ROUNDING * np.abs(points).max(initial=1e-3) else None
        if meeting is None:
            right = np.einsum("nij,nj->i", across, points)
            meeting = np.linalg.lstsq(across.sum(axis=0), right, rcond=None)[0]
        self.apart.append((off(meeting), steps))
        return np.asarray(meeting)

    def _near(self, off: float, limit: float, where: str, expected: str, got: str) -> None:
        """Reject a large deviation, and record a small one."""
        if off > limit * _OPEN:
            raise self._error(f"{where}: expected {expected}, got {got}")
        self.off = max(self.off, off / limit)

    def _need_meeting(self) -> None:
        """Reject axes that do not intersect in the pose of the file, and parallel successive axes."""
        for off, steps in self.apart:
            where = f"joints {' and '.join(repr(step.joint.name) for step in steps)}"
            # The assumed intersection is in the middle between the two axes.
            self._near(off, self.L, where, "axes that meet", f"{2.0 * off:.3g} m between them")
            axes = np.concatenate([step.axes for step in steps])
            if np.linalg.norm(rotation.cross(axes[1:], axes[:-1]), axis=-1).min() < _OPEN:
                raise self._error(
                    f"{where}: expected each axis at an angle to the next one, got parallel ones"
                )

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
            self._near(abs(float(cosine)), 1.0, where, what, got)
        return np.asarray(axes[0])

    def _sign(self, slide: Step) -> float:
        """Return 1 if the joint coordinate increases with the leg length, otherwise -1."""
        (axis,) = slide.axes
        along = float(axis @ self.s)
        off = float(np.linalg.norm(axis - along * self.s))
        expected = "sliding along the line between the ends"
        got = f"{np.degrees(np.arcsin(min(1.0, off))):.3g} deg off"
        self._near(off, 1.0, f"joint {slide.joint.name!r}", expected, got)
        return 1.0 if along > 0.0 else -1.0

    def _frame(self, k: Array | None) -> Array:
        """Return frame D with axes in columns, (3, 3); only x is defined for spherical joints."""
        if k is None:
            own = self.lower.R
            if np.abs(own[:, 0] - self.s).max() < _ROUNDING:
                return own
            k = np.eye(3)[np.argmin(np.abs(self.s))]
        y = rotation.cross(k, self.s) if self.lines is None else self.lines.y
        sine = float(np.linalg.norm(y))
        if sine < _OPEN:
            raise self._error("fixed axis along the leg in the pose of the file; use another pose")
        y = y / sine
        return np.stack([self.s, y, rotation.cross(self.s, y)], axis=-1)

    def _part(self, body: Body, ends: Sequence[Step], part: str) -> dict[str, Any]:
        """Return mass, center of mass, and inertia of a part ("d" lower, "u" upper) in its frame."""
        step = ends[-1] if part == "d" else ends[0]
        origin = self.machine.point(step, body.name) if len(ends) == 1 else None
        if origin is None:
            origin = body.local(self.foot if part == "d" else self.tip)
            origin = np.where(np.abs(origin) < _ROUNDING * self.L, 0.0, origin)
        Q = body.R.T @ self.frame
        center, inertia = body.center - origin, body.inertia
        if not same_frame(Q, np.eye(3)):
            center, inertia = Q.T @ center, Q.T @ inertia @ Q
            inertia = 0.5 * (inertia + inertia.T)
        if part == "d" and self.lines is not None:
            return {"m_d": body.mass, "r_d0": center, "I_d0": inertia}
        if self.base_joint == "spherical":
            center, inertia = self._round(center, inertia)
        return {f"m_{part}": body.mass, f"r_{part}0": center, f"I_{part}0": inertia}

    def _round(self, center: Array, inertia: Array) -> tuple[Array, Array]:
        """Replace a body that is nearly a body of revolution by an exact one."""
        moments = np.diag(inertia)
        if moments[1] != moments[2]:
            moments = np.array([moments[0], *(2 * [0.5 * (moments[1] + moments[2])])])
        line, whole = np.array([center[0], 0.0, 0.0]), np.diag(moments)
        off = max(
            float(np.abs(center - line).max()) / self.L, float(np.abs(inertia - whole).max() / moments.max())
        )
        if off > _OPEN:
            return center, inertia
        self.off = max(self.off, off)
        return line, whole

    def _platform_point(self) -> Array:
        """Compute the intersection of the axes at the platform, shape (3,), in the platform frame."""
        if len(self.leg.tip) == 1:
            return self.machine.point(self.leg.tip[0], self.machine.platform)
        p = self.machine.bodies[self.machine.platform].local(self.tip)
        return np.where(np.abs(p) < _ROUNDING * self.L, 0.0, p)

    def _crosses(self, k: Array | None) -> list[Cross]:
        """Assign the bodies between axes to parts, except the body between offset axes."""
        leg = self.leg if self.lines is None else replace(self.leg, crosses=((), self.leg.crosses[1]))
        with errors_of(f"leg {self.number}: "):
            return list(crosses_of(self.machine, leg, np.array([self.b, self.tip]), k))

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
            raise self._error(f"joint {joint.name!r}: expected limits from low to high, got {got}")
        zero = self.L - self.sign * joint.position
        if abs(zero) < _ROUNDING * self.L:
            zero = 0.0
        low, high = sorted(zero + self.sign * limit for limit in joint.limits)
        return max(0.0, low), high
