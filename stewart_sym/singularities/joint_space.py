"""Joint-space trajectories, section 4.3: the platform's motion from leg lengths over time, by continuation.

Lengths alone do not tell whether the platform crosses a singular pose or turns back at it: both motions
have the same lengths. The rates do: turned back, the platform's velocity jumps. At every sample the poses
on both sides are found, and the one that fits the motion of the sample before is taken; where J's
determinant has changed its sign by then, or does so between the samples, the sample is named. Where noise
of the lengths hides on which side the pose is, it hides what the motion does there: that sample is named as
not decided.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..io.arguments import finite_array, instance, real_array
from ..kinematics.conditioning import characteristic_length
from ..kinematics.forward import (
    REASONS,
    Guess,
    ToSingular,
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
from ..kinematics.inverse import leg_vectors
from ..kinematics.leg_steps import accelerations, jump, step_beyond_rates, times_from_rates
from ..motion.interpolation import between
from ..motion.motion import Motion
from ..motion.rotation import (
    cross,
    rotation_from_vector,
    vector_from_rotation,
    vector_rate,
    vector_second_rate,
)
from ..motion.smoothing import LEAST_SAMPLES, rounding_steps, white_noise
from ..motion.trajectory import JointTrajectory, Trajectory
from ..results import SINGULAR
from ..robot.robot import Robot
from .along_path import crossings

Array = NDArray[np.float64]

NO_WAY = (
    "no way here from the sample before in the same assembly mode: the lengths jump, belong to no pose, "
    "or lead through one where H is singular"
)
CROSSED = (
    "a singular pose is crossed on the way from the sample before: there the forces are without bound, and "
    "from there on the same lengths belong to two motions"
)
UNDECIDED = (
    "a singular pose is as near as the noise of the lengths, {:.2g} m: not decided at this noise whether the "
    "platform crosses it or turns back"
)
JUMPED = "the lengths jump here: no motion with the accelerations of the samples around it makes this step"
OFF_RATES = "the step in lengths from the sample before is not what the rates at both samples make of it"

# A sample is approached in parts no smaller than this share of the way from the one before.
_SMALLEST_PART = 2.0**-20
# A step this share of its length away from where it was foretold may have left the way.
_ASTRAY = 0.1
# Part of the machine's size below which two poses are taken for one.
_SAME_POSE = 1e-8
# Lengths may be off by this many deviations of their noise.
_SURE = 5.0
# Samples whose rates are found at once.
_PART = 1 << 14
# Samples found at once at most.
_MANY = 256
# A pose on the other side of the singular poses is looked for when these are nearer than this, rad.
_NEAR = 1.0


class _Pose(NamedTuple):
    """Poses with leading shape (n,), their lengths, (n, 6), J there and the sign of its determinant."""

    R: Array
    t: Array
    L: Array
    J: Array
    sign: Array

    def at(self, part: slice) -> _Pose:
        """Some of the poses."""
        return _Pose(*(x[part] for x in self))


class _Legs(NamedTuple):
    """What the legs do at n samples: (n, 6) each."""

    L: Array
    L_dot: Array
    L_ddot: Array

    def at(self, part: slice) -> _Legs:
        """Some of the samples."""
        return _Legs(*(x[part] for x in self))


class _State(NamedTuple):
    """Poses and the platform's motion there: [v; omega] and [a; alpha], (n, 6)."""

    pose: _Pose
    twist: Array
    rate: Array

    def at(self, part: slice) -> _State:
        """Some of the states."""
        return _State(self.pose.at(part), self.twist[part], self.rate[part])


class _Run(NamedTuple):
    """States of samples that follow one another, and the way from each to the next singular pose."""

    state: _State
    near: ToSingular

    def first(self, count: int) -> _Run:
        """The first of them."""
        return _Run(self.state.at(slice(count)), ToSingular(*(x[:count] for x in self.near)))


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
    sigma: ArrayLike | None = None,
) -> Motion:
    """Return the platform's motion, of shape (n,), from that of its legs, (n, 6), sample after sample.

    Between samples the platform moves as poses, rates and accelerations at both ends say (polynomials of
    degree 5). Where all rates are 0, the samples are poses at rest, and between them the legs move along a
    straight line in the space of lengths.

    Parameters
    ----------
    robot : Robot
        The machine.
    L, L_dot, L_ddot : array_like, optional
        Lengths, rates and accelerations of the legs, m, m/s, m/s^2, in order of time; without L_ddot the
        motion has no accelerations.
    guess : Guess, optional
        Pose (R, t) near the first sample; None: as in ``forward_kinematics``.
    F_ext, M_ext : array_like, optional
        As in ``Motion``.
    time : array_like, optional
        Of the samples, s, (n,), increasing; None: the steps that fit L and L_dot.
    sigma : array_like, optional
        Standard deviation of each length, m, broadcasts to (n, 6); None: what rounding or scatter of the
        numbers show, from 40 samples on. The robot's length_limits are not asked for.

    Returns
    -------
    Motion
        Motion of shape (n,).

    Raises
    ------
    ValueError
        Naming the sample where the lengths jump, differ from what the rates say, belong to no pose, or lead
        through a singular one or so near one that this is not decided at their noise, and naming the argument
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
    deviations = None if sigma is None else _checked_deviations(sigma, lengths.shape)
    R, t = _follow(robot, when, lengths, rates["L_dot"], rates.get("L_ddot"), guess, deviations)
    v, omega = _in_parts(lambda i: forward_velocity(robot, R[i], t[i], rates["L_dot"][i], "nan"), len(t))
    a = alpha = None
    if "L_ddot" in rates:
        _reject_unsettled(v)
        a, alpha = _in_parts(
            lambda i: forward_acceleration(robot, R[i], t[i], v[i], omega[i], rates["L_ddot"][i], "nan"),
            len(t),
        )
    _reject_unsettled(v if a is None else a)
    # Copies of the arguments would be in memory beside those of the motion.
    rates.clear()
    del lengths
    return Motion(R, t, omega, v, alpha, a, F_ext, M_ext)  # type: ignore[arg-type]


def on_platform(robot: Robot, joints: JointTrajectory, guess: Guess | None = None) -> Trajectory:
    """Return a joint-space trajectory as one of the platform; errors name its file and row."""
    try:
        motion = motion_from_lengths(
            robot,
            joints.L,
            joints.L_dot,
            joints.L_ddot,
            guess,
            joints.F_ext,
            joints.M_ext,
            joints.time,
            None if joints.noise is None else np.sqrt(joints.noise.variances(joints.time)),
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


def _checked_deviations(sigma: ArrayLike, shape: tuple[int, ...]) -> Array:
    expected = f"standard deviations >= 0 m that broadcast to {shape}"
    values = real_array(sigma, "sigma", expected)
    if not np.all(np.isfinite(values) & (values >= 0.0)):
        raise ValueError(f"sigma: expected {expected}, got {values[~(values >= 0.0)].min(initial=np.nan):g}")
    try:
        return np.broadcast_to(values, shape)
    except ValueError:
        raise ValueError(f"sigma: expected {expected}, got shape {values.shape}") from None


def _in_parts(function: Callable[[slice], tuple[Array, Array]], count: int) -> tuple[Array, Array]:
    """Two vectors at each of many samples, (n, 3), without all that makes them in memory at once."""
    found = np.empty((2, count, 3))
    # None is much smaller than the others: few poses take NumPy's kinematics, whose last bits are other ones.
    starts = [i * _PART for i in range(max(1, count // _PART))]
    for start, end in itertools.pairwise([*starts, count]):
        part = slice(start, end)
        found[0, part], found[1, part] = function(part)
    return found[0], found[1]


def _reject_unsettled(rate: Array) -> None:
    bad = np.flatnonzero(~np.isfinite(rate).all(axis=-1))
    if bad.size:
        raise _LostError(int(bad[0]), "H is singular or the rates overflow: no velocity or acceleration")


def _follow(
    robot: Robot,
    time: Array | None,
    L: Array,
    L_dot: Array,
    L_ddot: Array | None,
    guess: Guess | None,
    sigma: Array | None,
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
    noise = _noise(time, L) if sigma is None else sigma
    R, t, twist, rate = (np.empty((len(L), *shape)) for shape in ((3, 3), (3,), (6,), (6,)))
    done, decided, sign, noisy = 0, len(L), first.sign[0], bool(noise.any())
    for run in _walk(robot, first, _Legs(L, L_dot, rates), np.diff(time)):
        here = slice(done, done + len(run.state.twist))
        R[here], t[here], twist[here], rate[here] = run.state.pose.R, run.state.pose.t, *run.state[1:]
        undecided = np.flatnonzero(_may_be_singular(run.near, noise[here]))
        if noisy and undecided.size:
            decided = min(decided, max(1, done + int(undecided[0])))
        done, sign = here.stop, run.state.pose.sign[-1]
        if decided < done:
            break
    decided = min(decided, done)
    same = decided - int(decided == done and sign != first.sign[0])
    _reject_crossings(robot, time[:same], R[:same], t[:same], twist[:same], rate[:same])
    if same < decided:
        raise _LostError(same, CROSSED)
    if decided < len(L):
        last = slice(decided - 1, decided)
        miss = newton(robot, L[decided : decided + 1], R[last], t[last]).residual[0]
        most = _SURE * float(noise[decided].max())
        near = decided < done or miss <= most
        raise _LostError(decided, UNDECIDED.format(most / _SURE) if near and most > 0.0 else NO_WAY)
    return R, t


def _noise(time: Array, L: Array) -> Array:
    """Standard deviation of each length, (n, 6), as the numbers show it."""
    if len(L) < LEAST_SAMPLES:
        return np.zeros(L.shape)
    shown_noise = np.maximum(rounding_steps(L) / math.sqrt(12.0), white_noise(time, L))
    return np.broadcast_to(shown_noise, L.shape)


def _may_be_singular(near: ToSingular, sigma: Array) -> NDArray[np.bool_]:
    """Whether noise of lengths, (n, 6), could carry poses through a singular one."""
    return np.asarray(near.lengths <= _SURE * np.linalg.norm(near.legs * sigma, axis=-1))


def _joined(poses: Sequence[_Pose]) -> _Pose:
    return _Pose(*(np.concatenate(parts) for parts in zip(*poses, strict=True)))


def _reject_crossings(robot: Robot, time: Array, R: Array, t: Array, twist: Array, rate: Array) -> None:
    """Name the first sample before which J's determinant changes its sign, between samples too."""
    bad = np.flatnonzero(~np.isfinite(twist + rate).all(axis=-1))
    known = int(bad[0]) if bad.size else len(twist)
    if known > 1:
        arrays = (R, t, twist[:, 3:], twist[:, :3], rate[:, 3:], rate[:, :3])
        motion = Motion.unchecked(*(x[:known] for x in arrays))
        found = crossings(robot, between(Trajectory(time[:known], motion, "L", range(known))), time[:known])
        if found:
            raise _LostError(int(np.searchsorted(time[:known], found[0].time)), CROSSED)
    if bad.size:
        raise _LostError(known, REASONS[SINGULAR])


# From one sample to the next


def _walk(robot: Robot, first: _Pose, legs: _Legs, steps: Array) -> Iterator[_Run]:
    """The states from the first pose on, up to the first sample without one or with J's other sign.

    Where all goes smoothly, many samples are found at once; where it does not, one after another, and ever
    more of them before many are tried again.
    """
    last, done = _state(robot, first, legs.at(slice(1))), 1
    yield _Run(last, way_to_singular(robot, first.R, first.t))
    many, alone, again = 1, 1, 1
    while done < len(legs.L) and last.pose.sign[0] == first.sign[0]:
        here = slice(done, done + many)
        run = _run(robot, last, legs.at(here), steps[done - 1 : done - 1 + many]) if done >= again else None
        if run is not None and len(run.state.twist):
            many, alone = min(2 * many, _MANY) if len(run.state.twist) == many else 1, 1
        else:
            if run is not None:
                many, alone, again = 1, min(2 * alone, _MANY), done + alone
            state = _next(robot, last, legs.at(slice(done, done + 1)), steps[done - 1 : done])
            if state is None:
                break
            run = _Run(state, way_to_singular(robot, state.pose.R, state.pose.t))
        yield run
        last = run.state.at(slice(-1, None))
        done += len(run.state.twist)


def _run(robot: Robot, last: _State, legs: _Legs, h: Array) -> _Run:
    """The states at the next samples, h s after one another, up to the first that ``_next`` must settle."""
    R, t = (np.repeat(x, len(h), axis=0) for x in (last.pose.R, last.pose.t))
    ends = newton(robot, legs.L, R, t)
    after = _state(robot, _pose(robot, ends.R, ends.t, legs.L), legs)
    poses = _joined([last.pose, after.pose.at(slice(-1))])
    before = _State(
        poses, *(np.concatenate([x[0], x[1][:-1]]) for x in zip(last[1:], after[1:], strict=True))
    )
    run = _Run(after, way_to_singular(robot, ends.R, ends.t))
    near = np.abs(run.near.way)
    clear = (near >= _NEAR * characteristic_length(robot)) | (
        _misfit(robot, before, after, h) < _ASTRAY * near
    )
    sure = ends.found & clear & _foretold(robot, before, after.pose, h) & (after.pose.sign == last.pose.sign)
    return run.first(len(h) if sure.all() else int(np.argmin(sure)))


def _next(robot: Robot, state: _State, legs: _Legs, h: Array) -> _State | None:
    """Return the state at the next sample, h s later, (1,), that fits the one before best, or None."""
    found = _with_other_side(robot, _found(robot, legs.L, *_ahead(state, h)), state, legs, h)
    if not found or not _foretold(robot, state, found[0][1].pose, h).all():
        found += _with_other_side(robot, _approach(robot, state.pose, legs.L), state, legs, h)
    return min(found, key=lambda entry: entry[0])[1] if found else None


def _foretold(robot: Robot, before: _State, after: _Pose, h: Array) -> NDArray[np.bool_]:
    """Whether poses, (n,), are where the states before them lead."""
    ahead = _ahead(before, h)
    off, step = (
        np.linalg.norm(_apart(robot, (pose.R, pose.t), ahead), axis=-1) for pose in (after, before.pose)
    )
    return np.asarray(off <= _ASTRAY * step + _SAME_POSE * characteristic_length(robot))


def _with_other_side(
    robot: Robot, pose: _Pose | None, before: _State, legs: _Legs, h: Array
) -> list[tuple[float, _State]]:
    """Return a pose and that on the other side of the next singular one: misfit to ``before``, state."""
    if pose is None:
        return []
    state = _state(robot, pose, legs)
    found = [(float(_misfit(robot, before, state, h)[0]), state)]
    way = abs(float(way_to_singular(robot, pose.R, pose.t).way[0]))
    # As far away as this, the pose on the other side cannot fit better.
    if way < _NEAR * characteristic_length(robot) and not found[0][0] < _ASTRAY * way:
        mirrored = other_side(robot, legs.L, pose.R, pose.t)
        if mirrored.found.all():
            other = _state(robot, _pose(robot, mirrored.R, mirrored.t, legs.L), legs)
            found.append((float(_misfit(robot, before, other, h)[0]), other))
    return found


def _misfit(robot: Robot, before: _State, after: _State, h: Array) -> Array:
    """Return by how far poses and rates miss a smooth motion, m, (n,): in the step and in h times the rates.

    Both follow from what changes from one sample to the other by Hermite's rules, to h^5 and h^4.
    """
    h = h[:, None]
    turn = vector_from_rotation(after.pose.R @ np.swapaxes(before.pose.R, -1, -2))
    with np.errstate(invalid="ignore"):
        omega, alpha = after.twist[:, 3:], after.rate[:, 3:]
        twist = np.hstack([after.twist[:, :3], vector_rate(turn, omega)])
        rate = np.hstack([after.rate[:, :3], vector_second_rate(turn, omega, alpha)])
        made = np.hstack([after.pose.t - before.pose.t, turn])
        step = made - 0.5 * h * (before.twist + twist) - h**2 / 12.0 * (before.rate - rate)
        change = twist - before.twist - 0.5 * h * (before.rate + rate)
        unit = np.repeat([1.0, characteristic_length(robot)], 3)
        miss = np.linalg.norm(np.hstack([step * unit, h * change * unit]), axis=-1)
    return np.where(np.isfinite(miss), miss, np.inf)


def _ahead(state: _State, h: Array) -> tuple[Array, Array]:
    step = h[:, None] * state.twist + 0.5 * h[:, None] ** 2 * state.rate
    turn = step[:, 3:] / np.maximum(1.0, np.linalg.norm(step[:, 3:], axis=-1, keepdims=True))
    return rotation_from_vector(turn) @ state.pose.R, state.pose.t + step[:, :3]


def _apart(robot: Robot, one: tuple[Array, Array], other: tuple[Array, Array]) -> Array:
    """Difference of two poses (n, ...) as a twist, (n, 6), m, angles times the platform's size."""
    turn = vector_from_rotation(other[0] @ np.swapaxes(one[0], -1, -2))
    return np.hstack([other[1] - one[1], characteristic_length(robot) * turn])


def _state(robot: Robot, pose: _Pose, legs: _Legs) -> _State:
    """The platform's motion at a pose from that of its legs, (5), (8); not finite where J is singular."""
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
    return _joined(poses)[:2]


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
