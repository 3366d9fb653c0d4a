"""Steps between samples of leg lengths: impossible steps, and the poses at the end of possible steps.

Each pose is computed from the previous pose, in steps that remain in one assembly mode.
"""

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple, TypeVar

import numpy as np

from ..io.array_types import Array, Flags
from ..io.progress import Progress, tracked
from ..kinematics.conditioning import characteristic_length
from ..kinematics.inverse_kinematics import leg_vectors
from ..kinematics.pose_search import ToSingular, newton, other_side, rates_per_twist, solve, way_to_singular
from ..motion import rotation
from ..motion.sample_times import elapsed
from ..robot.robot import Robot

NO_WAY = (
    "no path from the previous sample in the same assembly mode: the lengths jump, have no pose, "
    "or pass through a pose with singular H"
)
CROSSED = (
    "a singular pose is crossed after the previous sample: the forces are unbounded at this pose, and "
    "the same lengths belong to two motions after it"
)
UNDECIDED = (
    "a singular pose is as near as the noise of the lengths, {:.2g} m; a crossing or a return before it is "
    "inconclusive at this noise"
)
# Smallest part of the path from the previous sample, relative to the path, in which a sample is approached.
_SMALLEST_PART = 2.0**-20
# Distance from the predicted pose, relative to the step, from which a pose may be in another assembly mode.
_ASTRAY = 0.1
# Distance relative to the machine size below which two poses are equal.
_SAME_POSE = 1e-8
# Largest number of samples that are computed at once.
_MANY = 256
# Distance (rad) of singular poses below which the pose on their other side is also computed.
_NEAR = 1.0


class _Pose(NamedTuple):
    """Poses with leading shape (n,), lengths (m), Jacobians J, and the signs of det J."""

    R: Array
    t: Array
    L: Array
    J: Array
    sign: Array


class Legs(NamedTuple):
    """Leg lengths (m), rates (m/s), and accelerations (m/s^2) at n samples, shape (n, 6) each."""

    L: Array
    L_dot: Array
    L_ddot: Array


class _State(NamedTuple):
    """Poses with the twist [v; omega] and the accelerations [a; alpha] of the platform, shape (n, 6)."""

    pose: _Pose
    twist: Array
    rate: Array


class Steps(NamedTuple):
    """States at consecutive samples and the path from each to the nearest singular pose."""

    state: _State
    near: ToSingular


Record = TypeVar("Record", bound=tuple[Any, ...])


def some(record: Record, part: slice) -> Record:
    """Select samples of a (nested) record of arrays."""
    parts = (some(x, part) if isinstance(x, tuple) else x[part] for x in record)
    return type(record)(*parts)


class LostError(ValueError):
    """Raised if the motion cannot be continued to a sample; contains its index and the reason."""

    def __init__(self, sample: int, reason: str) -> None:
        super().__init__(f"L[{sample}]: {reason}")
        self.sample, self.reason = sample, reason


def _joined(poses: Sequence[_Pose]) -> _Pose:
    return _Pose(*(np.concatenate(parts) for parts in zip(*poses, strict=True)))


def walked(robot: Robot, first: _Pose, legs: Legs, steps: Array) -> Iterator[Steps]:
    """Yield the states from the first pose to the first sample without a pose or with another sign of det J.

    Many samples are computed at once if the motion is smooth. Otherwise, samples are computed one after
    another, and their number doubles before the next attempt to compute many at once.
    """
    last, done = _state(robot, first, some(legs, slice(1))), 1
    yield Steps(last, way_to_singular(robot, first.R, first.t))
    many, alone, again = 1, 1, 1
    while done < len(legs.L) and last.pose.sign[0] == first.sign[0]:
        here = slice(done, done + many)
        run = (
            _run(robot, last, some(legs, here), steps[done - 1 : done - 1 + many]) if done >= again else None
        )
        if run is not None and len(run.state.twist):
            many, alone = min(2 * many, _MANY) if len(run.state.twist) == many else 1, 1
        else:
            if run is not None:
                many, alone, again = 1, min(2 * alone, _MANY), done + alone
            state = _next(robot, last, some(legs, slice(done, done + 1)), steps[done - 1 : done])
            if state is None:
                break
            run = Steps(state, way_to_singular(robot, state.pose.R, state.pose.t))
        yield run
        last = some(run.state, slice(-1, None))
        done += len(run.state.twist)


def _run(robot: Robot, last: _State, legs: Legs, h: Array) -> Steps:
    """Return the states at the next samples up to the first that requires ``_next``; time steps h (s)."""
    R, t = (np.repeat(x, len(h), axis=0) for x in (last.pose.R, last.pose.t))
    ends = newton(robot, legs.L, R, t)
    after = _state(robot, pose_of(robot, ends.R, ends.t, legs.L), legs)
    poses = _joined([last.pose, some(after.pose, slice(-1))])
    before = _State(
        poses, *(np.concatenate([x[0], x[1][:-1]]) for x in zip(last[1:], after[1:], strict=True))
    )
    run = Steps(after, way_to_singular(robot, ends.R, ends.t))
    near = np.abs(run.near.way)
    clear = (near >= _NEAR * characteristic_length(robot)) | (
        _misfit(robot, before, after, h) < _ASTRAY * near
    )
    sure = (
        ends.converged & clear & _foretold(robot, before, after.pose, h) & (after.pose.sign == last.pose.sign)
    )
    return some(run, slice(len(h) if sure.all() else int(np.argmin(sure))))


def _next(robot: Robot, state: _State, legs: Legs, h: Array) -> _State | None:
    """Return the best state at the next sample, h (s) later, shape (1,), or None."""
    found = _with_other_side(robot, _found(robot, legs.L, *_ahead(state, h)), state, legs, h)
    if not found or not _foretold(robot, state, found[0][1].pose, h).all():
        found += _with_other_side(robot, _approach(robot, state.pose, legs.L), state, legs, h)
    return min(found, key=lambda entry: entry[0])[1] if found else None


def _foretold(robot: Robot, before: _State, after: _Pose, h: Array) -> Flags:
    """Return True for poses, shape (n,), close to the prediction from the previous states."""
    ahead = _ahead(before, h)
    off, step = (
        np.linalg.norm(_apart(robot, (pose.R, pose.t), ahead), axis=-1) for pose in (after, before.pose)
    )
    return np.asarray(off <= _ASTRAY * step + _SAME_POSE * characteristic_length(robot))


def _with_other_side(
    robot: Robot, pose: _Pose | None, before: _State, legs: Legs, h: Array
) -> list[tuple[float, _State]]:
    """Return a pose and the pose beyond the nearest singular pose, each with its misfit to ``before``."""
    if pose is None:
        return []
    state = _state(robot, pose, legs)
    found = [(float(_misfit(robot, before, state, h)[0]), state)]
    way = abs(float(way_to_singular(robot, pose.R, pose.t).way[0]))
    # A pose on the other side at this distance cannot fit better.
    if way < _NEAR * characteristic_length(robot) and not found[0][0] < _ASTRAY * way:
        mirrored = other_side(robot, legs.L, pose.R, pose.t)
        if mirrored.converged.all():
            other = _state(robot, pose_of(robot, mirrored.R, mirrored.t, legs.L), legs)
            found.append((float(_misfit(robot, before, other, h)[0]), other))
    return found


def _misfit(robot: Robot, before: _State, after: _State, h: Array) -> Array:
    """Return the deviation from a smooth motion (m), shape (n,).

    It combines the deviation of the step and h times the deviation of the change of rates. Hermite
    interpolation between the samples gives both, with errors of order h^5 and h^4.
    """
    h = h[:, None]
    turn = rotation.vector_from_rotation(after.pose.R @ np.swapaxes(before.pose.R, -1, -2))
    with np.errstate(invalid="ignore"):
        omega, alpha = after.twist[:, 3:], after.rate[:, 3:]
        twist = np.hstack([after.twist[:, :3], rotation.vector_rate(turn, omega)])
        rate = np.hstack([after.rate[:, :3], rotation.vector_second_rate(turn, omega, alpha)])
        made = np.hstack([after.pose.t - before.pose.t, turn])
        step = made - 0.5 * h * (before.twist + twist) - h**2 / 12.0 * (before.rate - rate)
        change = twist - before.twist - 0.5 * h * (before.rate + rate)
        unit = np.repeat([1.0, characteristic_length(robot)], 3)
        miss = np.linalg.norm(np.hstack([step * unit, h * change * unit]), axis=-1)
    return np.where(np.isfinite(miss), miss, np.inf)


def _ahead(state: _State, h: Array) -> tuple[Array, Array]:
    step = h[:, None] * state.twist + 0.5 * h[:, None] ** 2 * state.rate
    turn = step[:, 3:] / np.maximum(1.0, np.linalg.norm(step[:, 3:], axis=-1, keepdims=True))
    return rotation.rotation_from_vector(turn) @ state.pose.R, state.pose.t + step[:, :3]


def _apart(robot: Robot, one: tuple[Array, Array], other: tuple[Array, Array]) -> Array:
    """Return the difference of poses (n, ...) as a twist (m), shape (n, 6); angles times platform size."""
    turn = rotation.vector_from_rotation(other[0] @ np.swapaxes(one[0], -1, -2))
    return np.hstack([other[1] - one[1], characteristic_length(robot) * turn])


def _state(robot: Robot, pose: _Pose, legs: Legs) -> _State:
    """Compute the platform motion from the leg motion, (5) and (8); not finite if J is singular."""
    q, S, L = leg_vectors(robot, pose.R, pose.t)
    with np.errstate(all="ignore"):
        twist, regular = solve(pose.J, legs.L_dot)
        omega = twist[:, None, 3:]
        S_dot = twist[:, None, :3] + rotation.cross(omega, q)
        s = S / L[..., None]
        centripetal = np.sum(s * rotation.cross(omega, rotation.cross(omega, q)), axis=-1)
        across = (np.sum(S_dot**2, axis=-1) - legs.L_dot**2) / L
        rate, _ = solve(pose.J, legs.L_ddot - centripetal - across)
    return _State(pose, *(np.where(regular[:, None], x, np.nan) for x in (twist, rate)))


def _found(robot: Robot, L: Array, R: Array, t: Array) -> _Pose | None:
    end = newton(robot, L, R, t)
    return pose_of(robot, end.R, end.t, L) if end.converged.all() else None


def at_rest(robot: Robot, pose: _Pose, L: Array, progress: Progress) -> tuple[Array, Array]:
    """Compute poses without rates, each from the previous pose along a straight line of lengths."""
    poses = [pose]
    for i in tracked(progress, range(1, len(L)), lambda _: f"finding {len(L)} poses"):
        found = _approach(robot, poses[-1], L[i : i + 1])
        if found is None:
            raise LostError(i, NO_WAY)
        poses.append(found)
    return _joined(poses)[:2]


def _approach(robot: Robot, pose: _Pose, target: Array) -> _Pose | None:
    """Return the pose at lengths ``target``, shape (1, 6), by continuation, or None if it fails."""
    origin, done, part = pose.L, 0.0, 1.0
    while done < 1.0:
        # The last part ends exactly at the target instead of at a rounded sum.
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
    """Return the pose at lengths L if it is near its prediction with the same sign of det J, else None."""
    foretold, regular = solve(pose.J, L - pose.L)
    found = _found(robot, L, pose.R, pose.t)
    if found is None or not regular.all() or found.sign[0] != pose.sign[0]:
        return None
    made = _apart(robot, (pose.R, pose.t), (found.R, found.t))[0]
    size = characteristic_length(robot)
    step = foretold[0] * np.repeat([1.0, size], 3)
    near = np.linalg.norm(made - step) <= _ASTRAY * np.linalg.norm(step) + _SAME_POSE * size
    return found if near else None


def pose_of(robot: Robot, R: Array, t: Array, L: Array) -> _Pose:
    """Return a pose with its Jacobian and the sign of its determinant."""
    J = rates_per_twist(robot, R, t)
    return _Pose(R, t, L, J, np.linalg.slogdet(J)[0])


# Size of a jump relative to the change by the accelerations of the neighboring samples.
_JUMP = 10.0
# Number of samples on each side of a jump that determine these accelerations.
_SURROUNDINGS = 12
# Largest factor by which accelerations between samples exceed the accelerations at the samples.
_BETWEEN = 4.0
# Fraction of the steps that agree with their rates except for rounding and noise.
_MOST = 0.9
# Rates, relative to their median, above which the lengths determine the time step.
_MOVING = 0.01
# Cosine of the angle between changes and rates below which noise is no explanation.
_AGAINST = -0.5


def times_from_rates(L: Array, L_dot: Array) -> Array | None:
    """Return times from 0 (s), shape (n,), that fit lengths (n, 6) to their rates; None for legs at rest.

    The trapezoidal rule determines each step. If the legs almost rest, the step is the median of the others.
    """
    change, mean = np.diff(L, axis=0), 0.5 * (L_dot[1:] + L_dot[:-1])
    square = np.sum(mean**2, axis=-1)
    if not np.any(square):
        return None
    own = np.sum(change * mean, axis=-1)
    moving = square > _MOVING**2 * np.median(square)
    usual = float(np.median(own[moving] / square[moving]))
    weight = _MOVING**2 * float(np.median(square[moving]))
    step = (own + weight * usual) / (square + weight)
    if usual <= 0.0:
        return None
    return np.concatenate([[0.0], np.cumsum(np.where(step > 0.0, step, usual))])


def against_rates(L: Array, L_dot: Array) -> bool:
    """Return True if lengths, shape (n, 6), change opposite to their rates, for any times."""
    change, mean = np.diff(L, axis=0), 0.5 * (L_dot[1:] + L_dot[:-1])
    return float(np.sum(change * mean)) < _AGAINST * float(np.linalg.norm(change) * np.linalg.norm(mean))


def accelerations(time: Array, L: Array, L_dot: Array) -> Array:
    """Return L_ddot (m/s^2), shape (n, 6), of polynomials of degree 5 through each sample and its neighbors.

    At the first and the last sample the degree of the polynomial is 3.
    """
    h = np.diff(elapsed(time))[:, None]
    change, first, last = np.diff(L, axis=0) / h, L_dot[:-1], L_dot[1:]
    found = np.empty_like(L)
    found[:-1] = (6.0 * change - 4.0 * first - 2.0 * last) / h
    found[-1] = (-6.0 * change[-1] + 2.0 * first[-1] + 4.0 * last[-1]) / h[-1]
    if len(L) < 3:
        return found
    power = np.arange(2, 6)
    sides = []
    for step, other in ((-h[:-1], slice(None, -2)), (h[1:], slice(2, None))):
        # The step after the sample is the unit of time, so that all terms have similar sizes.
        x, unit = step / h[1:], h[1:]
        value = L[other] - L[1:-1] - step * L_dot[1:-1]
        sides += [(x**power, value), (power * x ** (power - 1), (L_dot[other] - L_dot[1:-1]) * unit)]
    matrix, wanted = (np.stack([side[i] for side in sides], axis=1) for i in (0, 1))
    found[1:-1] = 2.0 * np.linalg.solve(matrix, wanted)[:, 0] / h[1:] ** 2
    return found


def jump(time: Array, L: Array) -> int | None:
    """Return the first sample at which lengths, shape (n, 6), jump more than a sampled motion can, or None.

    Accelerations around a jump change their sign. They are ten times larger than all accelerations of the
    neighboring samples, and so is the resulting change of length per step. After a longer time step only this
    change is large. Noise after a shorter time step makes only the accelerations large.
    """
    h = np.diff(elapsed(time))[:, None]
    if len(h) < 5:
        return None
    bent = 2.0 * np.diff(np.diff(L, axis=0) / h, axis=0) / (h[1:] + h[:-1])
    steps = np.abs(np.diff(L, axis=0))
    resolution = float(np.min(steps[steps > 0.0], initial=np.inf))
    floor = 4.0 * resolution if np.isfinite(resolution) else 0.0
    # Entry i belongs to sample i + 1; a jump from sample i + 1 to i + 2 affects entries i and i + 1.
    seconds = (bent * h[1:] * h[:-1], bent)
    sizes = [np.max(_of_both(second), axis=-1) for second in seconds]
    largest = [np.max(np.abs(second), axis=-1) for second in seconds]
    for i in np.flatnonzero(sizes[0] > floor):
        low, high = max(i - _SURROUNDINGS, 0), i + 2 + _SURROUNDINGS
        around = [np.concatenate([most[low : max(i - 1, 0)], most[i + 3 : high]]) for most in largest]
        if around[0].size and all(
            size[i] > _JUMP * np.max(near) for size, near in zip(sizes, around, strict=True)
        ):
            return int(i + 2)
    return None


def _of_both(second: Array) -> Array:
    """Return the smaller magnitude of each entry and the next if the sign changes, else 0."""
    turned = second[:-1] * second[1:] < 0.0
    return np.where(turned, np.minimum(np.abs(second[:-1]), np.abs(second[1:])), 0.0)


def step_beyond_rates(time: Array, L: Array, L_dot: Array, L_ddot: Array) -> int | None:
    """Return the first sample that contradicts the rates since the previous sample, or None.

    With accelerations of at most A between samples, a step differs by at most h^2 A / 4 from the step of the
    mean rate.
    """
    h = np.diff(elapsed(time))[:, None]
    off = np.max(np.abs(np.diff(L, axis=0) - 0.5 * h * (L_dot[1:] + L_dot[:-1])), axis=-1)
    most = max(float(np.max(np.abs(L_ddot))), float(np.max(np.abs(np.diff(L_dot, axis=0) / h))))
    noise = min(float(np.quantile(off, _MOST)), float(np.max(np.abs(np.diff(L, axis=0)))))
    bad = np.flatnonzero(off > _BETWEEN * (0.25 * h[:, 0] ** 2 * most) + _JUMP * noise)
    return int(bad[0]) + 1 if bad.size else None
