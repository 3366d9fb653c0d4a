"""Conversion of a model to a robot, with messages about all assumptions."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ..dynamics.inverse_dynamics import inverse_dynamics
from ..io.arguments import safe_text
from ..io.array_types import Array
from ..motion.motion import at_rest
from ..motion.rotation import cross
from ..robot.drive import Drive
from ..robot.fields import DEFAULT_GRAVITY
from ..robot.offsets import JointOffsets
from ..robot.robot import Robot
from .leg_from_model import LOWER, OPEN, PLATFORM, UPPER, LegFields, has_offsets, need_mass, with_crosses
from .model import WORLD, Body, Joint, Model
from .model_from_robot import SLIDES
from .topology import Machine, Step, machine_of

_SAID, _SAID_FORCE = 1e-9, 1e-8
"""Smallest reported deviation (relative to a leg, rad), and force relative to the largest force."""
_MOST_OFF = 0.01
"""Largest error of a force that is only reported, relative to the mean load of a leg."""
_SAME_FRAME = 1e-9
_SINGULAR = 1e8
"""Condition number (m and rad) of a pose in which the forces are not determined."""
LEAD = 0.005
"""Lead of a screw (m), assumed if a model has an armature but no screw."""


def robot_of(model: Model) -> tuple[Robot, list[str]]:
    """Return the robot that bodies and joints describe, and a message for each assumption.

    Raises ValueError for other mechanisms, and for other forces at rest than in the model.
    """
    machine, order = _ordered(machine_of(model))
    off = _open_by(machine, model)
    offset = any(has_offsets(machine, leg) for leg in machine.legs)
    legs = [LegFields(machine, leg, i, offset) for i, leg in enumerate(machine.legs, 1)]
    off = max(off, *(leg.off for leg in legs))
    _need_same_base(legs)
    platform = machine.bodies[machine.platform]
    need_mass(platform, "the platform")
    # A different frame is aligned with the base frame, so that the pose in the file is a home pose.
    level = bool(np.abs(platform.R - np.eye(3)).max() < _SAME_FRAME)
    R = np.eye(3) if level else platform.R
    robot = _robot(model, legs, with_crosses(platform, legs, PLATFORM), R)
    frame = f"that of {machine.platform!r}"
    if not level:
        frame = f"the origin of {machine.platform!r}, axes those of the base in the pose in the file"
    who = ", ".join(f"{i} {leg.lower!r} {leg.upper!r}" for i, leg in enumerate(machine.legs, 1))
    lines = [f"axes and loops have errors of up to {off:.2g} rad or of a leg, treated as exact"]
    lines = lines if off > _SAID else []
    lines += [f"legs in the order of {order}: {who}", f"base frame: the world's; platform frame: {frame}"]
    fixed = [repr(name) for name, main in machine.members.items() if main == machine.platform != name]
    lines += [f"platform: {machine.platform!r}, to which are fixed: {', '.join(fixed)}"] if fixed else []
    if model.gravity is None:
        lines.append("gravity: not in the file, (0, 0, -9.81) m/s^2 is taken")
    lines += [_mass_line(machine, model, robot), "home: the pose in the file"]
    lines += [text for name, text in model.assumed.items() if machine.members.get(name) != WORLD]
    lines += [text for leg in legs for text in leg.said]
    if offset:
        lines.append("joint offsets: axes at the base that do not meet are imported with their distances")
    for part in (LOWER, UPPER, PLATFORM):
        if crosses := [each for leg in legs for each in leg.crosses if each.part == part]:
            names = ", ".join(repr(each.name) for each in crosses)
            exact = ", which leaves forces at rest as they are" if all(each.exact for each in crosses) else ""
            rigid = "" if all(each.rigid for each in crosses) else "; in motion they turn as that does"
            lines.append(f"between the axes of joints: {names} count as the {part}{exact}{rigid}")
    lines += _force_lines(machine, model, legs, robot)
    return robot, lines + [f"left out: {each}" for each in _grouped([*model.left_out, *_other_joints(model)])]


def _robot(model: Model, legs: Sequence[LegFields], platform: Body, R: Array) -> Robot:
    """Create the robot; R turns the platform frame of the file into the robot's."""
    found: dict[str, Any] = {
        "name": safe_text(model.name).strip() or "imported",
        "base_joint": legs[0].base_joint,
        "g": np.array(DEFAULT_GRAVITY) if model.gravity is None else model.gravity,
        "M": platform.mass,
        "R_0": R @ platform.center,
        "I_p": R @ platform.inertia @ R.T,
        "home_position": platform.t,
        **{key: [leg.values[key] for leg in legs] for key in legs[0].values},
        "p": [R @ leg.p for leg in legs],
    }
    if legs[0].offset:
        offsets: dict[str, Any] = {key: [leg.offset[key] for leg in legs] for key in legs[0].offset}
        found["offsets"] = JointOffsets(**offsets)
    armature = np.array([leg.leg.slide.joint.armature for leg in legs])
    if armature.any():
        inertia = armature * (LEAD / (2.0 * np.pi)) ** 2
        found["drive"] = Drive(lead=np.full(len(legs), LEAD), rotor_inertia=inertia)
    return Robot(**found)


def _need_same_base(legs: Sequence[LegFields]) -> None:
    """Raise ValueError unless all legs have the same kind of joint at the base."""
    kinds = [leg.base_joint for leg in legs]
    usual = max(kinds, key=kinds.count)
    for leg in legs:
        if leg.base_joint != usual:
            where = f"leg {leg.number}: joint {leg.leg.base[0].joint.name!r}"
            expected = f"expected a {usual} joint at the base as leg {kinds.index(usual) + 1} has"
            raise ValueError(f"{where}: {expected}, got a {leg.base_joint} one")


def _mass_line(machine: Machine, model: Model, robot: Robot) -> str:
    """Compare the moving mass in the file with the robot."""
    moving = sum(body.mass for body in model.bodies if machine.members[body.name] != WORLD)
    crosses = 0.0 if robot.offsets is None else float(robot.offsets.cross_mass.sum())
    kept = robot.M + float(robot.m_d.sum()) + float(robot.m_u.sum()) + crosses
    return f"mass of the bodies that move: {moving:.7g} kg in the file, {kept:.7g} kg imported"


def _force_lines(machine: Machine, model: Model, legs: Sequence[LegFields], robot: Robot) -> Iterator[str]:
    """Compare the forces at rest with the equilibrium of the model; raise ValueError for a large error."""
    # Without gravity in the file, the effect in motion is estimated with the gravity of the earth.
    g = robot.g if robot.g.any() else np.asarray(DEFAULT_GRAVITY)
    pose = at_rest(np.eye(3), machine.bodies[machine.platform].t)
    signs = np.array([leg.sign for leg in legs])
    try:
        exact = signs * _slide_forces(machine, model.joints, g)
    except np.linalg.LinAlgError:
        yield "forces at rest: not compared with the file, because its pose is singular"
        return
    F = inverse_dynamics(replace(robot, g=g), pose, backend="numpy").F
    error, largest = float(np.abs(F - exact).max()), float(np.abs(exact).max())
    mass = robot.M + float(robot.m_d.sum()) + float(robot.m_u.sum())
    limit = _MOST_OFF * float(np.linalg.norm(g)) * mass / len(legs)
    _, cause = max(leg.farthest for leg in legs)
    if error > limit:
        by = f"which changes forces by up to {error:.3g} N (limit {limit:.3g} N, 1 % of the weight per leg)"
        raise ValueError(f"{cause}, {by}; move or reduce the mass, or let the axes meet")
    if error > _SAID_FORCE * largest:
        yield f"{cause}: forces at rest in the pose of the file are off by up to {error:.3g} N"
    if any(joint.load.any() for joint in model.joints):
        loaded = signs * _slide_forces(machine, model.joints, g, loaded=True) - exact
        size = float(np.abs(loaded).max())
        yield f"left out: springs and other loads of joints, {size:.3g} N of force in the pose of the file"


def _slide_forces(machine: Machine, joints: Sequence[Joint], g: Array, loaded: bool = False) -> Array:
    """Compute the forces at rest in the pose of the file, along the slides from base to platform (N), (6,).

    With ``loaded``, the loads of the joints act, too. Raises LinAlgError in a singular pose.
    """
    platform, zero = machine.bodies[machine.platform], np.zeros(3)
    work = _wrench(platform.mass * g, zero, platform.placed(platform.center))
    rates = []
    for leg in machine.legs:
        steps = (*leg.base, leg.slide, *leg.tip)
        each = [_twists(machine, step) for step in steps]
        columns = np.hstack(each)
        if np.linalg.cond(columns) > _SINGULAR:
            raise np.linalg.LinAlgError("singular pose")
        # Rates of the joints per twist of the platform; the spin of a leg between spherical joints is free.
        split = np.split(np.linalg.pinv(columns), np.cumsum([len(twists.T) for twists in each])[:-1])
        rates.append(split[len(leg.base)][0])
        twist = np.zeros((6, 6))
        for step, twists, rate in zip(steps, each, split, strict=True):
            twist = twist + twists @ rate
            body = machine.bodies[step.reached]
            if step.reached != machine.platform:
                work += _wrench(body.mass * g, zero, body.placed(body.center)) @ twist
            if loaded:
                load = _wrench(step.joint.load[:3], step.joint.load[3:], machine.place(step)) @ twists @ rate
                work += load if step.forward else -load
    if loaded:
        for joint in joints:
            if joint.kind == "free":
                point = machine.placed[joint.child].placed(joint.point)
                work += _wrench(joint.load[:3], joint.load[3:], point)
    if np.linalg.cond(rates) > _SINGULAR:
        raise np.linalg.LinAlgError("singular pose")
    return np.asarray(np.linalg.solve(np.array(rates).T, -work), dtype=np.float64)


def _twists(machine: Machine, step: Step) -> Array:
    """Return the twists of a joint for unit rates, shape (6, n).

    A twist is the velocity of the point of a body at the origin, and the angular velocity.
    """
    axes = step.axes if len(step.axes) else np.eye(3)
    if step.joint.kind == "prismatic":
        return np.vstack([axes.T, np.zeros((3, 1))])
    return np.vstack([cross(machine.place(step), axes).T, axes.T])


def _wrench(force: Array, moment: Array, point: Array) -> Array:
    """Return force and moment about the origin, shape (6,), of a force and a moment at a point."""
    return np.concatenate([force, moment + cross(point, force)])


def _open_by(machine: Machine, model: Model) -> float:
    """Compute the largest relative and angular (rad) error of welds and loops; reject large errors."""
    ends = [(machine.place(leg.base[0]), machine.place(leg.tip[-1])) for leg in machine.legs]
    length = float(np.median([np.linalg.norm(tip - base) for base, tip in ends]))
    cuts = [joint for joint in model.joints if joint.cut]
    gaps = np.array([machine.gap(joint) for joint in cuts])
    angles = np.array([joint.position for joint in cuts])
    off = np.maximum(gaps / length, angles)
    if far := np.flatnonzero(off > OPEN).tolist():
        names = ", ".join(repr(cuts[i].name) for i in far)
        turns = np.degrees(angles)
        by = (f"{gaps[i]:.3g} m" if gaps[i] > OPEN * length else f"{turns[i]:.3g} deg" for i in far)
        expected = "expected closed loops and welds in the pose of the file"
        raise ValueError(f"joints {names}: {expected}, got open by {', '.join(by)}")
    return float(np.max(off, initial=0.0))


def _other_joints(model: Model) -> Iterator[str]:
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


def _ordered(machine: Machine) -> tuple[Machine, str]:
    """Return the machine with the legs in the order of exported names, else of the file, and the order."""
    names = [leg.slide.joint.name for leg in machine.legs]
    if tuple(names) == SLIDES or sorted(names) != list(SLIDES):
        return machine, "the file"
    legs = tuple(machine.legs[names.index(name)] for name in SLIDES)
    return replace(machine, legs=legs), "their names"
