"""Joint-space trajectories, section 4.3: the platform's motion from leg lengths over time, by continuation.

Lengths alone do not tell whether the platform crosses a singular pose or turns back at it: both motions have
the same lengths. The rates do: turned back, the platform's velocity jumps. At every sample the poses on both
sides are found, and the one that fits the motion of the sample before is taken; where J's determinant has
changed its sign by then, or does so between the samples, the sample is named.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .checks import finite_array, instance, real_array
from .conditioning import characteristic_length
from .forward import (
    REASONS,
    Guess,
    checked_lengths,
    fault,
    forward_acceleration,
    forward_kinematics,
    forward_velocity,
    jacobian,
    newton,
    other_side,
    solve,
    way_to_singular,
)
from .interpolation import between
from .kinematics import leg_vectors
from .leg_steps import accelerations, jump, step_beyond_rates, times_from_rates
from .motion import Motion
from .passage import crossings
from .results import SINGULAR
from .robot import Robot
from .rotation import (
    cross,
    rotation_from_vector,
    vector_from_rotation,
    vector_rate,
    vector_second_rate,
)
from .trajectory import JointTrajectory, Trajectory

Array = NDArray[np.float64]

NO_WAY = (
    "no way here from the sample before in the same assembly mode: the lengths jump, belong to no pose, "
    "or lead through one where H is singular"
)
CROSSED = (
    "a singular pose is crossed on the way from the sample before: there the forces are without bound, and "
    "from there on the same lengths belong to two motions"
)
JUMPED = "the lengths jump here: no motion with the accelerations of the samples around it makes this step"
OFF_RATES = "the step in lengths from the sample before is not what the rates at both samples make of it"

# A sample is approached in parts no smaller than this share of the way from the one before.
_SMALLEST_PART = 2.0**-20
# A step this share of its length away from where it was foretold may have left the way.
_ASTRAY = 0.1
# Samples that are approached at once.
_LONGEST = 256
# Part of the machine's size below which two poses are taken for one.
_SAME_POSE = 1e-8
# A pose on the other side of the singular poses is looked for when these are nearer than this, rad.
_NEAR = 1.0


class _Pose(NamedTuple):
    """Poses of leading shape (n,), their lengths (n, 6), J there and the sign of J's determinant, (n,)."""

    R: Array
    t: Array
    L: Array
    J: Array
    sign: Array


class _Legs(NamedTuple):
    """What the legs do at n samples: (n, 6) each."""

    L: Array
    L_dot: Array
    L_ddot: Array

    def part(self, where: slice) -> _Legs:
        """Some of the samples."""
        return _Legs(*(x[where] for x in self))


class _State(NamedTuple):
    """Poses and the platform's motion there: [v; omega] and [a; alpha], (n, 6)."""

    pose: _Pose
    twist: Array
    rate: Array

    def part(self, where: slice) -> _State:
        """Some of the samples."""
        return _State(_Pose(*(x[where] for x in self.pose)), self.twist[where], self.rate[where])

    def then(self, other: _State) -> _State:
        """These samples and others after them."""
        pose = (np.concatenate(pair) for pair in zip(self.pose, other.pose, strict=True))
        return _State(_Pose(*pose), *(np.concatenate(pair) for pair in zip(self[1:], other[1:], strict=True)))


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
    time: ArrayLike | None = None,
) -> Motion:
    """Return the platform's motion, of shape (n,), from that of its legs, (n, 6), sample after sample.

    L, L_dot, L_ddot: lengths, rates and accelerations of the legs, m, m/s, m/s^2, in order of time; without
    L_ddot the motion has no accelerations.  guess: pose (R, t) near the first sample; None: as in
    ``forward_kinematics``.  F_ext, M_ext: as in ``Motion``.  time: of the samples, s, (n,), increasing; None:
    the steps that fit L and L_dot.  The robot's length_limits are not asked for.

    Between samples the platform moves as poses, rates and accelerations at both ends say (polynomials of
    degree 5).  Where all rates are 0, the samples are poses at rest, and between them the legs move along a
    straight line in the space of lengths.  Raises ``ValueError`` naming the sample where the lengths jump,
    differ from what the rates say, belong to no pose, or lead through a singular one, and naming the argument
    for any other bad input.
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
    when = _checked_times(time, len(lengths)) if time is not None else None
    R, t = _follow(robot, when, lengths, rates["L_dot"], rates.get("L_ddot"), guess)
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
            robot, joints.L, joints.L_dot, joints.L_ddot, guess, joints.F_ext, joints.M_ext, joints.time
        )
    except _LostError as error:
        row = joints.rows[error.sample]
        raise ValueError(f"{joints.source}: row {row}: {error.reason}") from None
    return Trajectory(joints.time, motion, joints.source, joints.rows, joints.noise)


def _checked_times(time: ArrayLike, count: int) -> Array:
    when = real_array(time, "time", "increasing times")
    if when.shape != (count,) or not np.all(np.isfinite(when)) or np.any(np.diff(when) <= 0.0):
        raise ValueError(f"time: expected {count} finite times, increasing, of shape ({count},)")
    return when


def _refuse_unsettled(rate: Array) -> None:
    bad = np.flatnonzero(~np.isfinite(rate).all(axis=-1))
    if bad.size:
        raise _LostError(int(bad[0]), "H is singular or the rates overflow: no velocity or acceleration")


def _follow(
    robot: Robot, time: Array | None, L: Array, L_dot: Array, L_ddot: Array | None, guess: Guess | None
) -> tuple[Array, Array]:
    """Return R, (n, 3, 3), and t, (n, 3), along lengths (n, 6)."""
    start = forward_kinematics(robot, L[:1], guess, on_failure="nan", limits=False)
    if start.status.any():
        raise _LostError(0, fault(robot, L[0], int(start.status[0]), guess is not None))
    first = _pose(robot, start.R, start.t, L[:1])
    if time is None:
        time = times_from_rates(L, L_dot)
    if len(L) < 2 or time is None or not np.any(L_dot):
        return _at_rest(robot, first, L)
    rates = accelerations(time, L, L_dot) if L_ddot is None else L_ddot
    for sample, reason in ((jump(L), JUMPED), (step_beyond_rates(time, L, L_dot, rates), OFF_RATES)):
        if sample is not None:
            raise _LostError(sample, reason)
    legs = _Legs(L, L_dot, rates)
    state = _state(robot, first, legs.part(slice(0, 1)))
    track, lost, stretch = [_Track(first.R, first.t, state.twist, state.rate)], "", 1
    known = 1
    while known < len(L) and not lost:
        ahead = slice(known, known + stretch)
        h = time[ahead] - time[known - 1]
        found = _evident(robot, state, legs.part(ahead), h)
        stretch = min(2 * stretch, _LONGEST) if len(found.twist) == len(h) else max(1, len(found.twist))
        if not len(found.twist):
            one = _next(robot, state, legs.part(slice(known, known + 1)), h[:1])
            if one is None or one.pose.sign[0] != first.sign[0]:
                lost = NO_WAY if one is None else CROSSED
                break
            found = one
        track.append(_Track(found.pose.R, found.pose.t, found.twist, found.rate))
        known += len(found.twist)
        state = found.part(slice(-1, None))
    followed = _Track(*(np.concatenate(parts) for parts in zip(*track, strict=True)))
    del track
    _refuse_crossings(robot, time[:known], followed)
    if lost:
        raise _LostError(known, lost)
    return followed.R, followed.t


class _Track(NamedTuple):
    """Poses and the platform's motion along samples, as of ``_State``."""

    R: Array
    t: Array
    twist: Array
    rate: Array


def _joined(poses: list[_Pose]) -> tuple[Array, Array]:
    return np.concatenate([pose.R for pose in poses]), np.concatenate([pose.t for pose in poses])


def _refuse_crossings(robot: Robot, time: Array, track: _Track) -> None:
    """Name the first sample before which J's determinant changes its sign, between samples too."""
    bad = np.flatnonzero(~np.isfinite(track.twist + track.rate).all(axis=-1))
    known = int(bad[0]) if bad.size else len(time)
    if known > 1:
        R, t, twist, rate = (x[:known] for x in track)
        motion = Motion(R, t, twist[:, 3:], twist[:, :3], rate[:, 3:], rate[:, :3])
        path = between(Trajectory(time[:known], motion, "L", range(known)))
        found = crossings(robot, path, time[:known])
        if found:
            raise _LostError(int(np.searchsorted(time[:known], found[0].time)), CROSSED)
    if bad.size:
        raise _LostError(known, REASONS[SINGULAR])


# From one sample to the next


def _evident(robot: Robot, state: _State, legs: _Legs, h: Array) -> _State:
    """Return the states at the first of the next samples, h s later, (n,), at which only one is in question.

    They are those that ``_next`` finds one after another: from where each is foretold by the one before.
    """
    size = characteristic_length(robot)
    with np.errstate(all="ignore"):
        far = newton(robot, legs.L, *_ahead(state, h))
        before = state.then(_state(robot, _pose(robot, far.R, far.t, legs.L), legs)).part(slice(0, -1))
        steps = np.diff(h, prepend=0.0)
        ahead = _ahead(before, steps)
        near = newton(robot, legs.L, *ahead)
        found = _state(robot, _pose(robot, near.R, near.t, legs.L), legs)
        pose = near.R, near.t
        made = _length(_apart(robot, (before.pose.R, before.pose.t), ahead))
        way = np.abs(way_to_singular(robot, *pose)[0])
        good = near.found & (_length(_apart(robot, pose, (far.R, far.t))) <= _SAME_POSE * size)
        good &= _length(_apart(robot, pose, ahead)) <= _ASTRAY * made + _SAME_POSE * size
        good &= (way >= _NEAR * size) | (_misfit(robot, before, found, steps) < _ASTRAY * way)
        good &= found.pose.sign == state.pose.sign
    return found.part(slice(0, int(np.argmin([*good, False]))))


def _next(robot: Robot, state: _State, legs: _Legs, h: Array) -> _State | None:
    """Return the state at the next sample, h s later, (1,), that fits the one before best, or None."""
    ahead = _ahead(state, h)
    found = _with_other_side(robot, _found(robot, legs.L, *ahead), state, legs, h)
    step = _length(_apart(robot, (state.pose.R, state.pose.t), ahead))
    if not found or _length(_apart(robot, (found[0][1].pose.R, found[0][1].pose.t), ahead)) > (
        _ASTRAY * step + _SAME_POSE * characteristic_length(robot)
    ):
        found += _with_other_side(robot, _approach(robot, state.pose, legs.L), state, legs, h)
    return min(found, key=lambda entry: entry[0])[1] if found else None


def _with_other_side(
    robot: Robot, pose: _Pose | None, before: _State, legs: _Legs, h: Array
) -> list[tuple[float, _State]]:
    """Return a pose and that on the other side of the next singular one: misfit to ``before``, state."""
    if pose is None:
        return []
    state = _state(robot, pose, legs)
    found = [(float(_misfit(robot, before, state, h)[0]), state)]
    way = abs(float(way_to_singular(robot, pose.R, pose.t)[0][0]))
    # As far away as this, the pose on the other side cannot fit better.
    if way < _NEAR * characteristic_length(robot) and not found[0][0] < _ASTRAY * way:
        mirrored = other_side(robot, legs.L, pose.R, pose.t)
        if mirrored.found.all():
            other = _state(robot, _pose(robot, mirrored.R, mirrored.t, legs.L), legs)
            found.append((float(_misfit(robot, before, other, h)[0]), other))
    return found


def _misfit(robot: Robot, before: _State, after: _State, h: Array) -> Array:
    """Return by how far poses and rates miss a smooth motion, m, (n,): in steps and in h times the rates.

    Both follow from what changes from one sample to the other by Hermite's rules, to h^5 and h^4.
    """
    h = h[:, None]
    turn = vector_from_rotation(after.pose.R @ np.swapaxes(before.pose.R, -1, -2))
    omega, alpha = after.twist[:, 3:], after.rate[:, 3:]
    twist = np.hstack([after.twist[:, :3], vector_rate(turn, omega)])
    rate = np.hstack([after.rate[:, :3], vector_second_rate(turn, omega, alpha)])
    made = np.hstack([after.pose.t - before.pose.t, turn])
    step = made - 0.5 * h * (before.twist + twist) - h**2 / 12.0 * (before.rate - rate)
    change = twist - before.twist - 0.5 * h * (before.rate + rate)
    unit = np.repeat([1.0, characteristic_length(robot)], 3)
    miss = np.hypot(_length(step * unit), _length(h * change * unit))
    return np.where(np.isfinite(miss), miss, np.inf)


def _ahead(state: _State, h: Array) -> tuple[Array, Array]:
    step = h[:, None] * state.twist + 0.5 * h[:, None] ** 2 * state.rate
    turn = step[:, 3:] / np.maximum(1.0, _length(step[:, 3:]))[:, None]
    return rotation_from_vector(turn) @ state.pose.R, state.pose.t + step[:, :3]


def _apart(robot: Robot, one: tuple[Array, Array], other: tuple[Array, Array]) -> Array:
    """Difference of poses as twists, (n, 6), m, angles times the platform's size."""
    turn = vector_from_rotation(other[0] @ np.swapaxes(one[0], -1, -2))
    return np.hstack([other[1] - one[1], characteristic_length(robot) * turn])


def _length(vector: Array) -> Array:
    return np.asarray(np.linalg.norm(vector, axis=-1))


def _state(robot: Robot, pose: _Pose, legs: _Legs) -> _State:
    """The platform's motion at poses from that of its legs, (5), (8); not finite where J is singular."""
    q, S, L = leg_vectors(robot, pose.R, pose.t)
    with np.errstate(all="ignore"):
        twist, regular = solve(pose.J, legs.L_dot)
        omega = twist[:, None, 3:]
        S_dot = twist[:, None, :3] + cross(omega, q)
        s = S / L[..., None]
        centripetal = np.sum(s * cross(omega, cross(omega, q)), axis=-1)
        across = (np.sum(S_dot**2, axis=-1) - legs.L_dot**2) / L
        rate, _ = solve(pose.J, legs.L_ddot - centripetal - across)
    return _State(pose, *(np.where(regular[:, None], x, np.nan) for x in (twist, rate)))


def _found(robot: Robot, L: Array, R: Array, t: Array) -> _Pose | None:
    end = newton(robot, L, R, t)
    return _pose(robot, end.R, end.t, L) if end.found.all() else None


def _at_rest(robot: Robot, pose: _Pose, L: Array) -> tuple[Array, Array]:
    """Poses without rates: each is approached from the one before along a straight line of lengths."""
    poses = [pose]
    for i in range(1, len(L)):
        found = _approach(robot, poses[-1], L[i : i + 1])
        if found is None:
            raise _LostError(i, NO_WAY)
        poses.append(found)
    return _joined(poses)


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
    found = _found(robot, L, pose.R, pose.t)
    if found is None or not regular.all() or found.sign[0] != pose.sign[0]:
        return None
    made = _apart(robot, (pose.R, pose.t), (found.R, found.t))[0]
    size = characteristic_length(robot)
    step = foretold[0] * np.repeat([1.0, size], 3)
    near = np.linalg.norm(made - step) <= _ASTRAY * np.linalg.norm(step) + _SAME_POSE * size
    return found if near else None


def _pose(robot: Robot, R: Array, t: Array, L: Array) -> _Pose:
    J = jacobian(robot, R, t)
    return _Pose(R, t, L, J, np.linalg.slogdet(J)[0])
