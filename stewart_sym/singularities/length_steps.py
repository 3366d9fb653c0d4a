"""Steps of leg lengths from sample to sample: those that no motion makes, and the poses that they lead to.

Each pose is found from that of the sample before, in steps that keep to one assembly mode.
"""

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple, TypeVar

import numpy as np

from ..io.array_types import Array, Flags
from ..io.progress import Progress, tracked
from ..io.sample_times import elapsed
from ..kinematics.conditioning import characteristic_length
from ..kinematics.inverse_kinematics import leg_vectors
from ..kinematics.pose_search import ToSingular, jacobian, newton, other_side, solve, way_to_singular
from ..motion import rotation
from ..robot.robot import Robot

NO_WAY = (
    "no way here from the sample before in the same assembly mode: the lengths jump, belong to no pose, "
    "or lead through one where H is singular"
)
CROSSED = (
    "a singular pose is crossed on the way from the sample before: there the forces are without bound, and "
    "from there on the same lengths belong to two motions"
)
UNDECIDED = (
    "a singular pose is as near as the noise of the lengths, {:.2g} m: inconclusive at this noise, since the "
    "platform may cross it or turn back"
)
# A sample is approached in parts no smaller than this share of the way from the one before.
_SMALLEST_PART = 2.0**-20
# A pose farther from its prediction than this share of the step may be of another assembly mode.
_ASTRAY = 0.1
# Part of the machine's size below which two poses are taken for one.
_SAME_POSE = 1e-8
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


class Legs(NamedTuple):
    """What the legs do at n samples: (n, 6) each."""

    L: Array
    L_dot: Array
    L_ddot: Array


class _State(NamedTuple):
    """Poses and the platform's motion there: [v; omega] and [a; alpha], (n, 6)."""

    pose: _Pose
    twist: Array
    rate: Array


class Steps(NamedTuple):
    """States of samples that follow one another, and the way from each to the next singular pose."""

    state: _State
    near: ToSingular


Record = TypeVar("Record", bound=tuple[Any, ...])


def some(record: Record, part: slice) -> Record:
    """The records above at some of their samples."""
    parts = (some(x, part) if isinstance(x, tuple) else x[part] for x in record)
    return type(record)(*parts)


class LostError(ValueError):
    """No motion at a sample: its index and why."""

    def __init__(self, sample: int, reason: str) -> None:
        super().__init__(f"L[{sample}]: {reason}")
        self.sample, self.reason = sample, reason


def _joined(poses: Sequence[_Pose]) -> _Pose:
    return _Pose(*(np.concatenate(parts) for parts in zip(*poses, strict=True)))


def walked(robot: Robot, first: _Pose, legs: Legs, steps: Array) -> Iterator[Steps]:
    """The states from the first pose on, up to the first sample without one or with J's other sign.

    Where all goes smoothly, many samples are found at once; where it does not, one after another, and ever
    more of them before many are tried again.
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
    """The states at the next samples, h s after one another, up to the first that ``_next`` must settle."""
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
    sure = ends.found & clear & _foretold(robot, before, after.pose, h) & (after.pose.sign == last.pose.sign)
    return some(run, slice(len(h) if sure.all() else int(np.argmin(sure))))


def _next(robot: Robot, state: _State, legs: Legs, h: Array) -> _State | None:
    """Return the state at the next sample, h s later, (1,), that fits the one before best, or None."""
    found = _with_other_side(robot, _found(robot, legs.L, *_ahead(state, h)), state, legs, h)
    if not found or not _foretold(robot, state, found[0][1].pose, h).all():
        found += _with_other_side(robot, _approach(robot, state.pose, legs.L), state, legs, h)
    return min(found, key=lambda entry: entry[0])[1] if found else None


def _foretold(robot: Robot, before: _State, after: _Pose, h: Array) -> Flags:
    """Whether poses, (n,), are where the states before them lead."""
    ahead = _ahead(before, h)
    off, step = (
        np.linalg.norm(_apart(robot, (pose.R, pose.t), ahead), axis=-1) for pose in (after, before.pose)
    )
    return np.asarray(off <= _ASTRAY * step + _SAME_POSE * characteristic_length(robot))


def _with_other_side(
    robot: Robot, pose: _Pose | None, before: _State, legs: Legs, h: Array
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
            other = _state(robot, pose_of(robot, mirrored.R, mirrored.t, legs.L), legs)
            found.append((float(_misfit(robot, before, other, h)[0]), other))
    return found


def _misfit(robot: Robot, before: _State, after: _State, h: Array) -> Array:
    """Return by how far poses and rates miss a smooth motion, m, (n,): in the step and in h times the rates.

    Both follow from what changes from one sample to the other by Hermite's rules, to h^5 and h^4.
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
    """Difference of two poses (n, ...) as a twist, (n, 6), m, angles times the platform's size."""
    turn = rotation.vector_from_rotation(other[0] @ np.swapaxes(one[0], -1, -2))
    return np.hstack([other[1] - one[1], characteristic_length(robot) * turn])


def _state(robot: Robot, pose: _Pose, legs: Legs) -> _State:
    """The platform's motion at a pose from that of its legs, (5), (8); not finite where J is singular."""
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
    return pose_of(robot, end.R, end.t, L) if end.found.all() else None


def at_rest(robot: Robot, pose: _Pose, L: Array, progress: Progress) -> tuple[Array, Array]:
    """Poses without rates: each is approached from the one before along a straight line of lengths."""
    poses = [pose]
    for i in tracked(progress, range(1, len(L)), lambda _: f"finding {len(L)} poses"):
        found = _approach(robot, poses[-1], L[i : i + 1])
        if found is None:
            raise LostError(i, NO_WAY)
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


def pose_of(robot: Robot, R: Array, t: Array, L: Array) -> _Pose:
    """A pose with its Jacobian and the sign of its determinant."""
    J = jacobian(robot, R, t)
    return _Pose(R, t, L, J, np.linalg.slogdet(J)[0])


# A jump exceeds this many times what accelerations in its surroundings move in a step.
_JUMP = 10.0
# Samples on either side of a jump that tell these accelerations.
_SURROUNDINGS = 12
# Accelerations between samples may exceed those at the samples by this factor.
_BETWEEN = 4.0
# Share of the steps that follow their rates as well as rounding or noise lets all of them.
_MOST = 0.9
# A step in time follows from lengths where rates exceed this share of their median.
_MOVING = 0.01
# Cosine of the angle between changes and rates below which no noise has turned them.
_AGAINST = -0.5


def times_from_rates(L: Array, L_dot: Array) -> Array | None:
    """Return times from 0, s, (n,), at which lengths, (n, 6), change as their rates say; None at rest.

    The trapezoidal rule tells each step; where the legs all but rest, it is the median of the others.
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
    """Whether lengths, (n, 6), go the other way than their rates, whatever the times."""
    change, mean = np.diff(L, axis=0), 0.5 * (L_dot[1:] + L_dot[:-1])
    return float(np.sum(change * mean)) < _AGAINST * float(np.linalg.norm(change) * np.linalg.norm(mean))


def accelerations(time: Array, L: Array, L_dot: Array) -> Array:
    """Return L_ddot, m/s^2, (n, 6), of the polynomials of degree 5 through each sample and its neighbors.

    At the first and the last sample the polynomial is of degree 3.
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
        # Offsets are measured by the step after the sample, which keeps the equations' terms alike.
        x, unit = step / h[1:], h[1:]
        value = L[other] - L[1:-1] - step * L_dot[1:-1]
        sides += [(x**power, value), (power * x ** (power - 1), (L_dot[other] - L_dot[1:-1]) * unit)]
    matrix, wanted = (np.stack([side[i] for side in sides], axis=1) for i in (0, 1))
    found[1:-1] = 2.0 * np.linalg.solve(matrix, wanted)[:, 0] / h[1:] ** 2
    return found


def jump(time: Array, L: Array) -> int | None:
    """Return the sample at which lengths, (n, 6), jump as no motion sampled often enough does, or None.

    Accelerations around a jump change sign and are ten times as large as all in their surroundings, and so
    is what they move in the steps there. After a longer step only the latter is, of noise after a shorter
    one only the former are.
    """
    h = np.diff(elapsed(time))[:, None]
    if len(h) < 5:
        return None
    bent = 2.0 * np.diff(np.diff(L, axis=0) / h, axis=0) / (h[1:] + h[:-1])
    steps = np.abs(np.diff(L, axis=0))
    resolution = float(np.min(steps[steps > 0.0], initial=np.inf))
    floor = 4.0 * resolution if np.isfinite(resolution) else 0.0
    # Entry i belongs to sample i + 1; a jump from sample i + 1 to i + 2 shows in entries i and i + 1.
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
    """The smaller of the sizes of each and the next, (n - 1, 6), where they change sign, else 0."""
    turned = second[:-1] * second[1:] < 0.0
    return np.where(turned, np.minimum(np.abs(second[:-1]), np.abs(second[1:])), 0.0)


def step_beyond_rates(time: Array, L: Array, L_dot: Array, L_ddot: Array) -> int | None:
    """Return the first sample, or None, that the rates do not reach from the one before.

    With accelerations of at most A between samples, a step differs from that of the mean rate by h^2 A / 4.
    """
    h = np.diff(elapsed(time))[:, None]
    off = np.max(np.abs(np.diff(L, axis=0) - 0.5 * h * (L_dot[1:] + L_dot[:-1])), axis=-1)
    most = max(float(np.max(np.abs(L_ddot))), float(np.max(np.abs(np.diff(L_dot, axis=0) / h))))
    noise = min(float(np.quantile(off, _MOST)), float(np.max(np.abs(np.diff(L, axis=0)))))
    bad = np.flatnonzero(off > _BETWEEN * (0.25 * h[:, 0] ** 2 * most) + _JUMP * noise)
    return int(bad[0]) + 1 if bad.size else None
