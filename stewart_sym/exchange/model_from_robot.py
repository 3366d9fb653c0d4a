"""A robot as bodies and joints, at its home pose: six legs, the platform free, six closures at its points."""

from dataclasses import replace
from typing import Any

import numpy as np

from ..io.array_types import Array
from ..io.error_policy import warn
from ..plausibility.level_poses import level_home
from ..robot.bodies import tensors_of_bodies
from ..robot.fields import LEGS, legs_text
from ..robot.offset_positions import Chains
from ..robot.robot import Robot, RobotWarning, impossible_inertias, inertia_fault
from .model import WORLD, Body, Joint, Model, Shape, frame_along
from .offset_legs import base_joints, chains_at, cross_of, noted_offsets

_LEAST_SINE = 1e-6
_ROUNDING = 1e-9
_LOWER, _UPPER, _POINT, _PLATE, _RIM = 0.03, 0.02, 0.035, 0.03, 1.1
"""As drawn: radii of parts and points, thickness of plates, over a leg; radius of plates over the joints'."""
_PART = 0.55
"""Drawn length of a part where none is stated, over the longest leg, or over 1.4 times the leg at home."""
_REACH = 1.4
SLIDES = tuple(f"leg_{i}" for i in range(1, LEGS + 1))
"""Names of the actuators' joints, by which notes are found again."""
_FAULTY, _THIN = 1e-2, 1e-6
"""Least second moment of mass over the largest, of impossible bodies and of those without a thickness."""


def model_of(robot: Robot) -> Model:
    """The machine at its home pose, or at the level one where legs are near the middle of their lengths.

    Raises ValueError where a leg lies along its fixed axis there, or its offsets do not reach the pose.
    """
    t = level_home(robot)
    at = None if robot.offsets is None else chains_at(robot, t)
    S = t + robot.p - robot.b
    L = np.linalg.norm(S, axis=-1) if at is None else at.L[:, 0]
    frames = _leg_frames(robot, S / L[:, None]) if at is None else at.U
    bodies = [Body(WORLD, shapes=_plate(robot.b, float(L.mean())))]
    joints: list[Joint] = []
    for i, (frame, length) in enumerate(zip(frames, L, strict=True)):
        lower, upper = _parts(robot, i, frame, float(length), at)
        base, actuator = _leg_joints(robot, i, frame, float(length))
        if at is not None and robot.offsets is not None:
            bodies.append(cross_of(robot, robot.offsets, i, at, _short(_LOWER * float(length))))
        bodies += [lower, upper]
        joints += [*([base] if at is None else base_joints(robot, i, at)), actuator]
    shapes = _plate(robot.p, float(L.mean()))
    bodies.append(Body("platform", np.eye(3), t, robot.M, robot.R_0, robot.I_p, shapes))
    joints.append(Joint("free", "free", WORLD, "platform"))
    closures = [
        Joint(f"tip_{i}", "spherical", f"upper_{i}", "platform", p, damping=damping, cut=True)
        for i, (p, damping) in enumerate(zip(robot.p, robot.C_s.tolist(), strict=True), 1)
    ]
    # Readers take axes that miss each other for offsets where a note says that they are meant to.
    notes = {} if robot.offsets is None else {"offsets": noted_offsets(robot.offsets)}
    return Model(robot.name, robot.g, tuple(bodies), (*joints, *closures), notes)


def possible(robot: Robot, reader: str) -> Robot:
    """The robot with inertias that bodies can have, which ``reader`` needs.

    Raises ValueError that names the part whose inertia no body can have, unless the robot accepts it by
    ``accept``; the tensor is then the nearest possible one, and a warning says so.
    """
    faults = impossible_inertias(robot)
    for name, text in faults:
        if name not in robot.suppressed_warnings:
            raise ValueError(
                f"{text}: {reader} rejects it; correct it, or write the nearest possible tensor with "
                f'suppress_warnings = ["{name}"] in the robot file'
            )
        warn(
            f"{text}: {reader} rejects it, the nearest possible tensor is written [{name}]",
            RobotWarning,
        )
    return robot_of_bodies(robot)


def robot_of_bodies(robot: Robot) -> Robot:
    """The robot with tensors near its own that bodies with an extent in all directions have."""
    platform = _of_body(robot.I_p)
    lower, upper = (np.array([_of_body(tensor) for tensor in each]) for each in (robot.I_d0, robot.I_u0))
    return replace(robot, I_p=platform, I_d0=lower, I_u0=upper)


def _of_body(inertia: Array) -> Array:
    """A tensor, (3, 3): what no body has is changed by more than a rod without thickness."""
    return tensors_of_bodies(inertia, _FAULTY if inertia_fault(inertia) else _THIN)


def _leg_frames(robot: Robot, s: Array) -> Array:
    """Frames of the legs, (6, 3, 3), x along s; y along the universal joint's second axis."""
    if robot.base_joint == "spherical":
        return np.array([np.roll(frame_along(each), 1, axis=-1) for each in s])
    y = np.cross(robot.k, s)
    sine = np.linalg.norm(y, axis=-1, keepdims=True)
    bad = [i for i in range(LEGS) if sine[i] < _LEAST_SINE]
    if bad:
        raise ValueError(f"{legs_text(bad)}: fixed axis along the leg at home; change axes or home pose")
    y = y / sine
    return np.stack([s, y, np.cross(s, y)], axis=-1)


def _parts(robot: Robot, i: int, frame: Array, length: float, at: Chains | None) -> tuple[Body, Body]:
    longest, start = robot.length_limits[i, 1], np.zeros(3)
    part = _short(_PART * (longest if np.isfinite(longest) else _REACH * length))
    up, down = (
        np.array([float(stated[i]) or part, 0.0, 0.0]) for stated in (robot.lower_length, robot.upper_length)
    )
    if at is not None and robot.offsets is not None:
        start = np.array([0.0, robot.offsets.slide_offset_y[i], robot.offsets.slide_offset_z[i]])
    shape = Shape(_short(_LOWER * length), start, start + up)
    foot = robot.b[i] if at is None else robot.b[i] + at.A[i]
    inertia = float(robot.m_d[i]), robot.r_d0[i], robot.I_d0[i]
    lower = Body(f"lower_{i + 1}", frame, foot, *inertia, (shape,))
    shape = Shape(_short(_UPPER * length), -down, np.zeros(3))
    tip = lower.placed(start + np.array([length, 0.0, 0.0]))
    inertia = float(robot.m_u[i]), robot.r_u0[i], robot.I_u0[i]
    return lower, Body(f"upper_{i + 1}", frame, tip, *inertia, (shape,))


def _leg_joints(robot: Robot, i: int, frame: Array, length: float) -> tuple[Joint, Joint]:
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


def _plate(points: Array, length: float) -> tuple[Shape, ...]:
    """A round plate through the joint points, (6, 3), and a ball at each."""
    middle = points.mean(axis=0)
    normal = np.linalg.svd(points - middle)[2][2]
    half = 0.5 * _PLATE * length * normal
    rim = _RIM * float(np.linalg.norm(points - middle, axis=-1).max())
    balls = tuple(Shape(_short(_POINT * length), point, point) for point in points)
    # Coordinates that are rounding compared with the plate are zero.
    ends = (
        np.where(np.abs(end) < _ROUNDING * rim, 0.0, _short(end)) for end in (middle - half, middle + half)
    )
    return (Shape(_short(rim), *ends), *balls)


def _short(values: Any) -> Any:
    """Numbers with four digits: of drawings."""
    return np.vectorize(lambda value: float(f"{value:.4g}"), otypes=[float])(values)[()]
