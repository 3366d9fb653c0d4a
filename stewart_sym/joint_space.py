"""Joint-space trajectories, section 4.3: the platform's motion from leg lengths over time, by continuation.

Stands above ``forward`` and ``trajectory``; knows nothing of forces.  Each sample starts from the one before,
so the platform stays in the assembly mode it starts in, as the real one must.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .checks import finite_array, instance
from .conditioning import characteristic_length
from .forward import (
    REASONS,
    Guess,
    checked_lengths,
    forward_acceleration,
    forward_kinematics,
    forward_velocity,
    jacobian,
    newton,
    solve,
)
from .motion import Motion
from .robot import Robot
from .trajectory import JointTrajectory, Trajectory

Array = NDArray[np.float64]

NO_WAY = (
    "no way here from the sample before in the same assembly mode: the lengths jump, belong to no pose, "
    "or lead through one where H is singular"
)

# A sample is approached in parts no smaller than this share of the way from the one before.
_SMALLEST_PART = 2.0**-20
# A step this share of its length away from where the tangent points may have left the way.
_ASTRAY = 0.1
# Part of the machine's size below which two poses are taken for one.
_SAME_POSE = 1e-8


class _Pose(NamedTuple):
    """A pose with leading shape (1,), its lengths (1, 6), J there and the sign of J's determinant."""

    R: Array
    t: Array
    L: Array
    J: Array
    sign: float


class _LostError(ValueError):
    """No motion at a sample: its index and why."""

    def __init__(self, sample: int, reason: str) -> None:
        super().__init__(f"L[{sample}]: {reason}")
        self.sample, self.reason = sample, reason


def motion_from_lengths(
    robot: Robot,
    L: ArrayLike,
    L_dot: ArrayLike,
    L_ddot: ArrayLike | None = None,
    guess: Guess | None = None,
    F_ext: ArrayLike | None = None,
    M_ext: ArrayLike | None = None,
) -> Motion:
    """Return the platform's motion, of shape (n,), from that of its legs, (n, 6), sample after sample.

    L, L_dot, L_ddot: lengths, rates and accelerations of the legs, m, m/s, m/s^2, in order of time; without
    L_ddot the motion has no accelerations.  guess: pose (R, t) near the first sample; None: as in
    ``forward_kinematics``.  F_ext, M_ext: as in ``Motion``.  The robot's length_limits are not asked for.

    Between samples the legs are taken to move along a straight line in the space of lengths, and the pose
    found is the one to which this leads: a step in pose more than a tenth away from what (5) foretells is
    made in smaller parts.  Raises ``ValueError`` naming the sample where that fails (the lengths jump, belong
    to no pose, or lead through a singular one), and naming the argument for any other bad input.
    """
    instance(robot, Robot, "robot")
    lengths = checked_lengths(L)
    if lengths.ndim != 2 or not len(lengths):
        raise ValueError(f"L: expected shape (n, 6) with n > 0, got {lengths.shape}")
    rates = {"L_dot": finite_array(L_dot, (6,), "L_dot")}
    if L_ddot is not None:
        rates["L_ddot"] = finite_array(L_ddot, (6,), "L_ddot")
    for name, values in rates.items():
        if values.shape != lengths.shape:
            raise ValueError(f"{name}: expected the shape of L, {lengths.shape}, got {values.shape}")
    R, t = _follow(robot, lengths, guess)
    v, omega = forward_velocity(robot, R, t, rates["L_dot"], on_failure="nan")
    a = alpha = None
    if "L_ddot" in rates:
        _refuse_unsettled(v)
        a, alpha = forward_acceleration(robot, R, t, v, omega, rates["L_ddot"], on_failure="nan")
    _refuse_unsettled(v if a is None else a)
    return Motion(R, t, omega, v, alpha, a, F_ext, M_ext)  # type: ignore[arg-type]


def on_platform(robot: Robot, joints: JointTrajectory, guess: Guess | None = None) -> Trajectory:
    """Return a joint-space trajectory as one of the platform; errors name its file and row."""
    try:
        motion = motion_from_lengths(
            robot, joints.L, joints.L_dot, joints.L_ddot, guess, joints.F_ext, joints.M_ext
        )
    except _LostError as error:
        row = joints.rows[error.sample]
        raise ValueError(f"{joints.source}: row {row}: {error.reason}") from None
    return Trajectory(joints.time, motion, joints.source, joints.rows, joints.noise)


def _refuse_unsettled(rate: Array) -> None:
    bad = np.flatnonzero(~np.isfinite(rate).all(axis=-1))
    if bad.size:
        raise _LostError(int(bad[0]), "H is singular or the rates overflow: no velocity or acceleration")


def _follow(robot: Robot, L: Array, guess: Guess | None) -> tuple[Array, Array]:
    """Return R, (n, 3, 3), and t, (n, 3), along lengths (n, 6)."""
    start = forward_kinematics(robot, L[:1], guess, on_failure="nan", limits=False)
    if start.status.any():
        raise _LostError(0, REASONS[int(start.status[0])])
    pose = _pose(robot, start.R, start.t, L[:1])
    R, t = np.empty((len(L), 3, 3)), np.empty((len(L), 3))
    for i in range(len(L)):
        found = _approach(robot, pose, L[i : i + 1]) if i else pose
        if found is None:
            raise _LostError(i, NO_WAY)
        pose = found
        R[i], t[i] = pose.R[0], pose.t[0]
    return R, t


def _approach(robot: Robot, pose: _Pose, target: Array) -> _Pose | None:
    """Return the pose at lengths ``target``, (1, 6), on the way from ``pose``; None if there is no way."""
    origin, done, part = pose.L, 0.0, 1.0
    while done < 1.0:
        # The last part ends at the target itself, not at a rounded sum.
        end = done + part
        found = _step(robot, pose, target if end >= 1.0 else origin + end * (target - origin))
        if found is None:
            part *= 0.5
            if part < _SMALLEST_PART:
                return None
        else:
            pose, done, part = found, end, min(2.0 * part, 1.0 - end)
    return pose


def _step(robot: Robot, pose: _Pose, L: Array) -> _Pose | None:
    """Return the pose at lengths L if it lies where the tangent at ``pose`` points, with J's sign there."""
    foretold, regular = solve(pose.J, L - pose.L)
    R, t, _, _, converged = newton(robot, L, pose.R, pose.t)
    turn = R @ np.swapaxes(pose.R, -1, -2)
    # Beyond a right angle the sine below no longer tells the angle.
    if not (converged.all() and regular.all()) or np.trace(turn[0]) < 1.0:
        return None
    sine = 0.5 * (turn - np.swapaxes(turn, -1, -2))[0]
    made = np.array([*(t - pose.t)[0], sine[2, 1], sine[0, 2], sine[1, 0]])
    size = characteristic_length(robot)
    unit = np.repeat([1.0, size], 3)
    apart = np.linalg.norm((made - foretold[0]) * unit)
    if apart > _ASTRAY * np.linalg.norm(foretold[0] * unit) + _SAME_POSE * size:
        return None
    found = _pose(robot, R, t, L)
    return found if found.sign == pose.sign else None


def _pose(robot: Robot, R: Array, t: Array, L: Array) -> _Pose:
    J = jacobian(robot, R, t)
    return _Pose(R, t, L, J, float(np.linalg.slogdet(J)[0][0]))
