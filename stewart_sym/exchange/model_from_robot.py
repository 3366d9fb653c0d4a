"""Conversion of a robot in its home pose to bodies and joints, with one loop closure per leg."""

from dataclasses import replace
from typing import Any

import numpy as np

from ..io.array_types import Array
from ..io.error_policy import warn
from ..motion.motion import at_rest
from ..plausibility.level_poses import level_home
from ..robot.bodies import tensors_of_bodies
from ..robot.fields import LEGS, legs_text
from ..robot.offset_chains import chains
from ..robot.offset_positions import Chains
from ..robot.offsets import JointOffsets
from ..robot.robot import Robot, RobotWarning, impossible_inertias, inertia_fault
from .model import WORLD, Body, Joint, Model, Shape, frame_along

_LEAST_SINE = 1e-6
_ROUNDING = 1e-9
_LOWER, _UPPER, _POINT, _PLATE, _RIM = 0.03, 0.02, 0.035, 0.03, 1.1
"""Drawing sizes relative to a leg (radii, plate thickness), and plate radius relative to the joints."""
_PART = 0.55
"""Drawn length of a part of unknown length, relative to the longest leg or to 1.4 times the leg."""
_REACH = 1.4
SLIDES = tuple(f"leg_{i}" for i in range(1, LEGS + 1))
"""Names of the actuated joints, by which notes are assigned to legs."""
_LEAST = 1e-9
"""Mass and inertia of a massless cross relative to the lower part, because simulators require some."""
_FAULTY, _THIN = 1e-2, 1e-6
"""Smallest ratio of second moments, for impossible bodies and for bodies without thickness."""


def model_of(robot: Robot) -> Model:
    """Convert the robot in its home pose, or in a level pose with legs near half of their stroke."""
    t, offsets = level_home(robot), robot.offsets
    feet, start = robot.b, np.zeros((LEGS, 3))
    if offsets is None:
        S = t + robot.p - robot.b
        L = np.linalg.norm(S, axis=-1)
        frames = _leg_frames(robot, S / L[:, None])
    else:
        at = _chains_at(robot, t)
        L, frames, feet = at.L[:, 0], at.U, robot.b + at.A
        start[:, 1:] = np.column_stack([offsets.slide_offset_y, offsets.slide_offset_z])
    bodies = [Body(WORLD, shapes=_plate(robot.b, float(L.mean())))]
    joints: list[Joint] = []
    for i, (frame, length) in enumerate(zip(frames, L, strict=True)):
        base, actuator = _leg_joints(robot, i, frame, float(length))
        if offsets is not None:
            bodies.append(_cross(robot, offsets, i, at, _short(_LOWER * float(length))))
        bodies += _parts(robot, i, frame, float(length), feet[i], start[i])
        joints += [*([base] if offsets is None else _base_joints(robot, i, at)), actuator]
    shapes = _plate(robot.p, float(L.mean()))
    bodies.append(Body("platform", np.eye(3), t, robot.M, robot.R_0, robot.I_p, shapes))
    joints.append(Joint("free", "free", WORLD, "platform"))
    closures = [
        Joint(f"tip_{i}", "spherical", f"upper_{i}", "platform", p, damping=damping, cut=True)
        for i, (p, damping) in enumerate(zip(robot.p, robot.C_s.tolist(), strict=True), 1)
    ]
    return Model(robot.name, robot.g, tuple(bodies), (*joints, *closures))


def possible(robot: Robot, reader: str) -> Robot:
    """Return the robot with the nearest possible inertias, which ``reader`` requires.

    Raises ValueError for an impossible inertia whose warning is not suppressed.
    """
    faults = impossible_inertias(robot)
    for name, text in faults:
        if name not in robot.suppressed_warnings:
            raise ValueError(
                f'{text}: {reader} rejects it; correct it, or add "{name}" to suppress_warnings of the robot '
                "file to export the nearest possible tensor"
            )
        warn(
            f"{text}: {reader} rejects it; the nearest possible tensor is exported [{name}]",
            RobotWarning,
        )
    return robot_of_bodies(robot)


def robot_of_bodies(robot: Robot) -> Robot:
    """Return the robot with the nearest inertias of bodies with positive extent in all directions."""
    platform = _of_body(robot.I_p)
    lower, upper = (np.array([_of_body(tensor) for tensor in each]) for each in (robot.I_d0, robot.I_u0))
    return replace(robot, I_p=platform, I_d0=lower, I_u0=upper)


def _of_body(inertia: Array) -> Array:
    """Return the nearest possible tensor, shape (3, 3), with a larger margin for an impossible one."""
    return tensors_of_bodies(inertia, _FAULTY if inertia_fault(inertia) else _THIN)


def _leg_frames(robot: Robot, s: Array) -> Array:
    """Return the leg frames, shape (6, 3, 3), x along s, y along the second universal joint axis."""
    if robot.base_joint == "spherical":
        return np.array([np.roll(frame_along(each), 1, axis=-1) for each in s])
    y = np.cross(robot.k, s)
    sine = np.linalg.norm(y, axis=-1, keepdims=True)
    bad = [i for i in range(LEGS) if sine[i] < _LEAST_SINE]
    if bad:
        raise ValueError(f"{legs_text(bad)}: fixed axis along the leg at home; change axes or home pose")
    y = y / sine
    return np.stack([s, y, np.cross(s, y)], axis=-1)


def _parts(robot: Robot, i: int, frame: Array, length: float, foot: Array, start: Array) -> tuple[Body, Body]:
    """Create the lower and the upper part of a leg, whose sliding axis begins at ``start`` in its frame."""
    longest = robot.length_limits[i, 1]
    part = _short(_PART * (longest if np.isfinite(longest) else _REACH * length))
    up, down = (
        np.array([float(stated[i]) or part, 0.0, 0.0]) for stated in (robot.lower_length, robot.upper_length)
    )
    shape = Shape(_short(_LOWER * length), start, start + up)
    inertia = float(robot.m_d[i]), robot.r_d0[i], robot.I_d0[i]
    lower = Body(f"lower_{i + 1}", frame, foot, *inertia, (shape,))
    shape = Shape(_short(_UPPER * length), -down, np.zeros(3))
    tip = lower.placed(start + np.array([length, 0.0, 0.0]))
    inertia = float(robot.m_u[i]), robot.r_u0[i], robot.I_u0[i]
    return lower, Body(f"upper_{i + 1}", frame, tip, *inertia, (shape,))


def _leg_joints(robot: Robot, i: int, frame: Array, length: float) -> tuple[Joint, Joint]:
    """Create the base joint and the actuated joint of a leg."""
    universal = robot.base_joint == "universal"
    axes = np.stack([robot.k[i], frame[:, 1]]) if universal else np.zeros((0, 3))
    base = Joint(
        f"base_{i + 1}", robot.base_joint, WORLD, f"lower_{i + 1}", axes=axes, damping=float(robot.C_u[i])
    )
    low, high = (float(limit) for limit in robot.length_limits[i])
    actuator = Joint(
        SLIDES[i],
        "prismatic",
        f"lower_{i + 1}",
        f"upper_{i + 1}",
        axes=frame[:, :1].T,
        damping=float(robot.C_p[i]),
        armature=0.0 if robot.drive is None else float(robot.drive.reflected_mass[i]),
        position=length,
        limits=(low, high),
        effort=float(robot.force_limit[i]),
        speed=float(robot.speed_limit[i]),
        driven=True,
    )
    return base, actuator


def _chains_at(robot: Robot, t: Array) -> Chains:
    """Return the leg chains with the platform at rest at t, (3,); raise ValueError out of reach."""
    with np.errstate(all="ignore"):
        at = chains(robot, at_rest(np.eye(3), t))
    lost = [i for i in range(LEGS) if not np.isfinite(at.U[i]).all()]
    if lost:
        raise ValueError(f"{legs_text(lost)}: expected a home pose that their offsets reach, got none")
    return at


def _cross(robot: Robot, offsets: JointOffsets, i: int, at: Chains, radius: float) -> Body:
    """Return the body between both axes of leg i, with the frame o, y, k at the base point.

    It rotates about k only, so its inertia about k is used for all axes. A massless body gets a billionth of
    the mass of the lower part on the axis.
    """
    frame = np.stack([at.o[i], at.y[i], robot.k[i]], axis=-1)
    mass, inertia = float(offsets.cross_mass[i]), float(offsets.cross_inertia[i])
    reach = np.array([float(offsets.axis_offset[i]), 0.0, 0.0])
    return Body(
        f"cross_{i + 1}",
        frame,
        robot.b[i],
        mass or _LEAST * float(robot.m_d[i]),
        offsets.cross_center[i] if mass else np.zeros(3),
        (inertia or _LEAST * float(np.trace(robot.I_d0[i]))) * np.eye(3),
        (Shape(radius, np.zeros(3), reach),),
    )


def _base_joints(robot: Robot, i: int, at: Chains) -> tuple[Joint, Joint]:
    """Create the joints of a leg with offsets about the fixed axis and about the moving axis."""
    cross, lower, damping = f"cross_{i + 1}", f"lower_{i + 1}", float(robot.C_u[i])
    first = Joint(f"base_{i + 1}_1", "revolute", WORLD, cross, axes=robot.k[i][None], damping=damping)
    second = Joint(f"base_{i + 1}_2", "revolute", cross, lower, axes=at.y[i][None], damping=damping)
    return first, second


def _plate(points: Array, length: float) -> tuple[Shape, ...]:
    """Return a round plate through the joint points, shape (6, 3), and a ball at each point."""
    middle = points.mean(axis=0)
    normal = np.linalg.svd(points - middle)[2][2]
    half = 0.5 * _PLATE * length * normal
    rim = _RIM * float(np.linalg.norm(points - middle, axis=-1).max())
    balls = tuple(Shape(_short(_POINT * length), point, point) for point in points)
    # Coordinates that are rounding errors relative to the plate become zero.
    ends = (
        np.where(np.abs(end) < _ROUNDING * rim, 0.0, _short(end)) for end in (middle - half, middle + half)
    )
    return (Shape(_short(rim), *ends), *balls)


def _short(values: Any) -> Any:
    """Round numbers of drawings to four digits."""
    return np.vectorize(lambda value: float(f"{value:.4g}"), otypes=[float])(values)[()]
