"""Travel, speed, and acceleration along and about each axis from the home pose, as on a data sheet."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from ..drives.friction import friction_force
from ..drives.motor_states import motor_rates, rotor_force
from ..dynamics.home_pose import home_pose
from ..dynamics.inverse_dynamics import inverse_dynamics
from ..io.arguments import instance
from ..io.array_types import Array, Frozen
from ..kinematics.inverse_kinematics import inverse_kinematics
from ..motion.motion import Motion
from ..motion.rotation import rotation_from_vector
from ..robot.robot import Robot
from .pose_limits import CONDITION, INSIDE, REASONS, PoseExaminer, PoseLimits, at_reference

AXES = ("surge", "sway", "heave", "roll", "pitch", "yaw")
"""Names of the axes: along x, y, z and about x, y, z of the base frame, through the tool."""

# Number of poses at which each direction is tested before the first violated limit is located.
_SAMPLES = 2000
# Search distance without upper length limits, relative to the longest leg at home.
_FAR = 20.0
# Acceleration (m/s^2, rad/s^2) above which the limits are not effective.
_MOST_ACCELERATION = 1e12
_UNITS, _ZERO = np.eye(6), np.zeros(6)


@dataclass(frozen=True, eq=False)
class AxisTravelResult(Frozen):
    """Travel, speed, and acceleration of the tool along and about each axis of the base frame.

    The rows are ``AXES``: surge, sway, heave (m) and roll, pitch, yaw (rad). Column 0 is the negative, column
    1 the positive direction. Infinite values mean that no limit of the robot applies.

    Attributes
    ----------
    position : ndarray, shape (3,)
        Position of the tool at the home pose (m), base frame.
    travel : ndarray, shape (6, 2)
        Displacements (m, rad) to the first violated limit, while the other coordinates remain at home; NaN if
        the home pose violates a limit.
    limits : tuple of tuple of str
        Names of the limits that end the travel: a limit of ``PoseLimits``, "singularity", or "none".
    speed : ndarray, shape (6,)
        Largest speeds at the home pose (m/s, rad/s) within the speed limits of the legs and motors.
    acceleration : ndarray, shape (6, 2), or None
        Extreme accelerations from rest at the home pose (m/s^2, rad/s^2) under gravity, within the limits of
        force, motor torque, and motor current; NaN if the limits do not suffice to hold the platform. None if
        the robot file contains no masses.
    """

    position: Array
    travel: Array
    limits: tuple[tuple[str, str], ...]
    speed: Array
    acceleration: Array | None


def axis_travel(robot: Robot, limits: PoseLimits | None = None) -> AxisTravelResult:
    """Compute the travel, speed, and acceleration along and about each axis from the home pose.

    The axes are parallel to the base frame and pass through the tool.

    Parameters
    ----------
    robot : Robot
        Robot with limits.
    limits : PoseLimits, optional
        Limits of the travel, with a load at the tool that acts also on the accelerations; by default the
        limits of the robot. Travel always ends at singular poses.

    Returns
    -------
    AxisTravelResult
        One row per axis.

    Raises
    ------
    ValueError
        If an argument is invalid or the home pose has no solution.

    See Also
    --------
    workspace : Compute the volume of all poses within the limits.
    capability_polytope : Accelerations in every direction.

    Notes
    -----
    Each direction is tested at 2000 poses, and the first violated limit is located by a root search. A
    violation that ends before the next of these poses is not found.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> result = ss.axis_travel(ss.robots.load("rubin_camera"))
    >>> (1e3 * result.travel[2]).round(2).tolist(), result.limits[2]
    ([-17.1, 17.35], ('leg_length', 'leg_length'))
    """
    instance(robot, Robot, "robot")
    limits = PoseLimits() if limits is None else limits
    instance(limits, PoseLimits, "limits")
    position = home_pose(robot).t + robot.tool
    # A finite limit of the condition number makes the examiner compare the sign of det H with home.
    most = min(limits.max_condition, sys.float_info.max)
    examiner = PoseExaminer(robot, at_reference(robot, replace(limits, max_condition=most)))
    ends = [_travel(examiner, position, axis) for axis in _UNITS]
    return AxisTravelResult(
        position=position,
        travel=np.array([[end for end, _ in both] for both in ends]),
        limits=tuple((both[0][1], both[1][1]) for both in ends),
        speed=_speeds(robot, position),
        acceleration=None if robot.missing_bodies else _accelerations(robot, limits, position),
    )


# Travel


def _travel(examiner: PoseExaminer, position: Array, axis: Array) -> list[tuple[float, str]]:
    """Return the displacement to the first violated limit, and its name, in both directions of an axis."""

    def codes(distance: Array) -> NDArray[np.int8]:
        twist = distance[:, None] * axis
        R = rotation_from_vector(twist[:, 3:])
        return examiner.broken_limits(R, position + twist[:, :3] - R @ examiner.robot.tool)

    farthest = math.pi if axis[3:].any() else _farthest(examiner, position)
    found = []
    for sign in (-1.0, 1.0):
        samples = sign * np.linspace(0.0, farthest, _SAMPLES)
        broken = codes(samples)
        outside = np.flatnonzero(broken != INSIDE)
        if not outside.size:
            found.append((sign * math.inf, "none"))
        elif outside[0] == 0:
            found.append((math.nan, _name(examiner, broken[0])))
        else:
            end, code = _boundary(codes, *samples[outside[0] - 1 : outside[0] + 1])
            found.append((end, _name(examiner, code)))
    return found


def _name(examiner: PoseExaminer, code: int) -> str:
    """Return the name of a violated limit; without a limit of the condition number, the pose is singular."""
    singular = code == CONDITION and examiner.limits.max_condition == sys.float_info.max
    return "singularity" if singular else REASONS[code]


def _boundary(codes: Callable[[Array], NDArray[np.int8]], inside: float, outside: float) -> tuple[float, int]:
    """Locate the first violated limit between a pose within the limits and a pose beyond them."""

    def side(distance: float) -> float:
        return 1.0 if codes(np.array([distance]))[0] == INSIDE else -1.0

    tolerance = 1e-10 * abs(outside)
    end = float(brentq(side, inside, outside, xtol=tolerance))
    beyond = codes(np.array([end + 2.0 * math.copysign(tolerance, outside), outside]))
    return end, int(beyond[0] or beyond[1])


def _farthest(examiner: PoseExaminer, position: Array) -> float:
    """Return the distance (m) from home up to which violated limits are searched."""
    robot = examiner.robot
    legs = inverse_kinematics(robot, _at_tool(robot, position)).L
    longest = robot.length_limits[:, 1]
    if examiner.limits.lengths and np.isfinite(longest).any():
        return float(np.min(legs + longest))
    return _FAR * float(legs.max())


# Speed and acceleration at the home pose


def _at_tool(
    robot: Robot,
    position: Array,
    twist: Array | None = None,
    acceleration: Array | None = None,
    load: Array | None = None,
) -> Motion:
    """Return the motion of the reference point at home for twists and accelerations of the tool, (..., 6)."""
    zero = np.zeros(6)
    V, A = (zero if given is None else given for given in (twist, acceleration))
    wrench = zero if load is None else load
    motion = Motion(
        R=np.eye(3),
        t=position,
        omega=V[..., 3:],
        v=V[..., :3],
        alpha=A[..., 3:],
        a=A[..., :3],
        F_ext=wrench[:3],
        M_ext=wrench[3:],
    )
    return motion.at_point(-robot.tool)


def _speeds(robot: Robot, position: Array) -> Array:
    """Return the largest speeds along and about each axis, (6,), within the speed limits."""
    motion = _at_tool(robot, position, twist=_UNITS)
    L_dot = inverse_kinematics(robot, motion).L_dot
    with np.errstate(divide="ignore"):
        speed = np.min(robot.speed_limit / np.abs(L_dot), axis=-1)
        if robot.drive is not None:
            rates = robot.drive.transmission_ratio * motor_rates(robot, robot.drive, motion, L_dot)
            speed = np.minimum(speed, np.min(robot.drive.speed_limit / np.abs(rates), axis=-1))
    return np.asarray(speed)


def _accelerations(robot: Robot, limits: PoseLimits, position: Array) -> Array:
    """Return the extreme accelerations from rest along and about each axis, (6, 2)."""
    motions = _at_tool(robot, position, acceleration=np.vstack([_ZERO, _UNITS]), load=limits.load)
    F = inverse_dynamics(robot, motions, backend="numpy", on_singular="nan").F
    rates = inverse_kinematics(robot, _at_tool(robot, position, twist=_UNITS)).L_dot
    rotors = np.zeros_like(F) if robot.drive is None else rotor_force(robot, motions)
    found = np.empty((6, 2))
    for (axis, column), _ in np.ndenumerate(found):
        sign = (-1.0, 1.0)[column]
        # Forces of legs and rotors are linear in the acceleration: F = F_0 + a F_1.
        forces, rotor = (np.stack([x[0], sign * (x[axis + 1] - x[0])]) for x in (F, rotors))
        found[axis, column] = sign * _largest(robot, forces, rotor, np.sign(sign * rates[axis]))
    return found


def _largest(robot: Robot, forces: Array, rotor: Array, side: Array) -> float:
    """Return the largest acceleration >= 0 within all limits; NaN if none is, infinity without limits.

    ``forces`` and ``rotor`` are the constant and the linear term (N), (2, 6). ``side`` contains the signs of
    the leg rates, (6,), because the friction of the drives opposes them.
    """
    drive, most = robot.drive, np.full(6, np.inf)
    if drive is not None:
        constant = np.where(drive.torque_constant > 0.0, drive.torque_constant, np.inf)
        torque = np.minimum(drive.torque_limit, drive.current_limit * constant)
        most = np.abs(drive.transmission_ratio) * torque

    def excess(acceleration: float) -> float:
        F = forces[0] + acceleration * forces[1]
        used = np.abs(F) / robot.force_limit
        if drive is not None:
            screw = F - rotor[0] - acceleration * rotor[1]
            # Friction opposes the beginning motion, also if its sign is regularized.
            friction = friction_force(drive, screw, _ZERO, side)
            used = np.maximum(used, np.abs(F + friction) / most)
        return float(used.max()) - 1.0

    if not excess(0.0) <= 0.0:
        return math.nan
    farthest = 1.0
    while excess(farthest) < 0.0:
        farthest *= 2.0
        if farthest > _MOST_ACCELERATION:
            return math.inf
    return float(brentq(excess, 0.0, farthest, xtol=1e-12 * farthest))
