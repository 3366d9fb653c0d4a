"""Steps between samples of leg lengths: impossible steps, and the poses at the end of possible steps.

Each pose is computed from the previous pose, in steps that remain in one assembly mode.
"""

from collections.abc import Iterator
from typing import Any, NamedTuple, TypeVar

import numpy as np
from scipy.interpolate import make_interp_spline

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


class Legs(NamedTuple):
    """Leg lengths (m), rates (m/s), and accelerations (m/s^2) at n samples, shape (n, 6) each."""

    L: Array
    L_dot: Array
    L_ddot: Array


class State(NamedTuple):
    """Poses (n, ...), signs of det J, shape (n,), twists [v; omega], and accelerations [a; alpha], (n, 6)."""

    R: Array
    t: Array
    sign: Array
    twist: Array
    rate: Array


Record = TypeVar("Record", bound=tuple[Any, ...])


def some(record: Record, part: slice) -> Record:
    """Select samples of a record of arrays."""
    return type(record)(*(x[part] for x in record))


class LostError(ValueError):
    """Raised if the motion cannot be continued to a sample; contains its index and the reason."""

    def __init__(self, sample: int, reason: str) -> None:
        super().__init__(f"L[{sample}]: {reason}")
        self.sample, self.reason = sample, reason


def walked(
    robot: Robot, first: tuple[Array, Array], legs: Legs, steps: Array
) -> Iterator[tuple[State, ToSingular]]:
    """Yield the states from the first pose to the first sample without a pose or with another sign of det J.

    Each state is returned with the path to the nearest singular pose. Many samples are computed at once while
    the motion is smooth.
    """
    last, done, many = _state(robot, *first, some(legs, slice(1))), 1, 1
    side = last.sign[0]
    yield last, way_to_singular(robot, *first)
    while done < len(legs.L) and last.sign[0] == side:
        here = slice(done, done + many)
        states, near = _run(robot, last, some(legs, here), steps[done - 1 : done - 1 + many])
        many = min(2 * many, _MANY) if len(states.t) == many else 1
        if not len(states.t):
            ends = some(legs, slice(done - 1, done)).L, some(legs, slice(done, done + 1))
            found = _next(robot, last, *ends, steps[done - 1 : done])
            if found is None:
                break
            states, near = found, way_to_singular(robot, found.R, found.t)
        yield states, near
        last = some(states, slice(-1, None))
        done += len(states.t)


def _run(robot: Robot, last: State, legs: Legs, h: Array) -> tuple[State, ToSingular]:
    """Return the states at the next samples up to the first that requires ``_next``; time steps h (s)."""
    R, t = (np.repeat(x, len(h), axis=0) for x in (last.R, last.t))
    ends = newton(robot, legs.L, R, t)
    after = _state(robot, ends.R, ends.t, legs)
    before = State(*(np.concatenate([x, y[:-1]]) for x, y in zip(last, after, strict=True)))
    near = way_to_singular(robot, ends.R, ends.t)
    way = np.abs(near.way)
    clear = (way >= _NEAR * characteristic_length(robot)) | (_misfit(robot, before, after, h) < _ASTRAY * way)
    sure = ends.converged & clear & _foretold(robot, before, after, h) & (after.sign == last.sign)
    certain = slice(len(h) if sure.all() else int(np.argmin(sure)))
    return some(after, certain), some(near, certain)


def _next(robot: Robot, state: State, L: Array, legs: Legs, h: Array) -> State | None:
    """Return the best state at the next sample, h (s) later, shape (1,), from lengths L, or None."""
    end = newton(robot, legs.L, *_ahead(state, h))
    poses = [(end.R, end.t)] if end.converged.all() else []
    found = _with_other_side(robot, poses, state, legs, h)
    if not found or not _foretold(robot, state, found[0][1], h).all():
        approached = _approach(robot, (state.R, state.t), L, legs.L)
        found += _with_other_side(robot, [approached] if approached else [], state, legs, h)
    return min(found, key=lambda entry: entry[0])[1] if found else None


def _foretold(robot: Robot, before: State, after: State, h: Array) -> Flags:
    """Return True for poses, shape (n,), close to the prediction from the previous states."""
    ahead = _ahead(before, h)
    off, step = (
        np.linalg.norm(_apart(robot, (state.R, state.t), ahead), axis=-1) for state in (after, before)
    )
    return np.asarray(off <= _ASTRAY * step + _SAME_POSE * characteristic_length(robot))


def _with_other_side(
    robot: Robot, poses: list[tuple[Array, Array]], before: State, legs: Legs, h: Array
) -> list[tuple[float, State]]:
    """Return poses and the poses beyond the nearest singular poses, each with its misfit to ``before``."""
    found = []
    for R, t in poses:
        state = _state(robot, R, t, legs)
        misfit = float(_misfit(robot, before, state, h)[0])
        found.append((misfit, state))
        way = abs(float(way_to_singular(robot, R, t).way[0]))
        # A pose on the other side at this distance cannot fit better.
        if way < _NEAR * characteristic_length(robot) and not misfit < _ASTRAY * way:
            mirrored = other_side(robot, legs.L, R, t)
            if mirrored.converged.all():
                other = _state(robot, mirrored.R, mirrored.t, legs)
                found.append((float(_misfit(robot, before, other, h)[0]), other))
    return found


def _misfit(robot: Robot, before: State, after: State, h: Array) -> Array:
    """Return the deviation from a smooth motion (m), shape (n,).

    It combines the deviation of the step and h times the deviation of the change of rates. Hermite
    interpolation between the samples gives both, with errors of order h^5 and h^4.
    """
    h = h[:, None]
    # Twice the vector of the quaternion from one pose to the other is a rotation vector for small angles.
    e = rotation.quaternion_from_rotation(after.R @ np.swapaxes(before.R, -1, -2))
    with np.errstate(invalid="ignore"):
        e_dot, e_ddot = rotation.quaternion_rates(e, after.twist[:, 3:], after.rate[:, 3:])
        twist = np.hstack([after.twist[:, :3], 2.0 * e_dot[:, 1:]])
        rate = np.hstack([after.rate[:, :3], 2.0 * e_ddot[:, 1:]])
        made = np.hstack([after.t - before.t, 2.0 * e[:, 1:]])
        step = made - 0.5 * h * (before.twist + twist) - h**2 / 12.0 * (before.rate - rate)
        change = twist - before.twist - 0.5 * h * (before.rate + rate)
        unit = np.repeat([1.0, characteristic_length(robot)], 3)
        miss = np.linalg.norm(np.hstack([step * unit, h * change * unit]), axis=-1)
    return np.where(np.isfinite(miss), miss, np.inf)


def _ahead(state: State, h: Array) -> tuple[Array, Array]:
    step = h[:, None] * state.twist + 0.5 * h[:, None] ** 2 * state.rate
    turn = step[:, 3:] / np.maximum(1.0, np.linalg.norm(step[:, 3:], axis=-1, keepdims=True))
    return rotation.rotation_from_vector(turn) @ state.R, state.t + step[:, :3]


def _apart(robot: Robot, one: tuple[Array, Array], other: tuple[Array, Array]) -> Array:
    """Return the difference of poses (n, ...) as a twist (m), shape (n, 6); angles times platform size."""
    turn = rotation.vector_from_rotation(other[0] @ np.swapaxes(one[0], -1, -2))
    return np.hstack([other[1] - one[1], characteristic_length(robot) * turn])


def _state(robot: Robot, R: Array, t: Array, legs: Legs) -> State:
    """Compute the platform motion from the leg motion, (5) and (8); not finite if J is singular."""
    q, S, L = leg_vectors(robot, R, t)
    J = rates_per_twist(robot, R, t)
    with np.errstate(all="ignore"):
        twist, regular = solve(J, legs.L_dot)
        omega = twist[:, None, 3:]
        S_dot = twist[:, None, :3] + rotation.cross(omega, q)
        s = S / L[..., None]
        centripetal = np.sum(s * rotation.cross(omega, rotation.cross(omega, q)), axis=-1)
        across = (np.sum(S_dot**2, axis=-1) - legs.L_dot**2) / L
        rate, _ = solve(J, legs.L_ddot - centripetal - across)
    finite = (np.where(regular[:, None], x, np.nan) for x in (twist, rate))
    return State(R, t, np.linalg.slogdet(J)[0], *finite)


def at_rest(robot: Robot, first: tuple[Array, Array], L: Array, progress: Progress) -> tuple[Array, Array]:
    """Compute poses without rates, each from the previous pose along a straight line of lengths."""
    poses = [first]
    for i in tracked(progress, range(1, len(L)), lambda _: f"finding {len(L)} poses"):
        found = _approach(robot, poses[-1], L[i - 1 : i], L[i : i + 1])
        if found is None:
            raise LostError(i, NO_WAY)
        poses.append(found)
    R, t = (np.concatenate(parts) for parts in zip(*poses, strict=True))
    return R, t


def _approach(
    robot: Robot, pose: tuple[Array, Array], origin: Array, target: Array
) -> tuple[Array, Array] | None:
    """Return the pose at lengths ``target``, shape (1, 6), by continuation from ``origin``, or None."""
    now, done, part = origin, 0.0, 1.0
    while done < 1.0:
        # The last part ends exactly at the target instead of at a rounded sum.
        end = done + part
        goal = target if end >= 1.0 else origin + end * (target - origin)
        found = _step(robot, pose, now, goal)
        if found is None:
            part *= 0.5
            if part < _SMALLEST_PART:
                return None
        else:
            pose, now, done, part = found, goal, end, min(2.0 * part, 1.0 - end)
    return pose


def _step(robot: Robot, pose: tuple[Array, Array], now: Array, L: Array) -> tuple[Array, Array] | None:
    """Return the pose at lengths L if it is near its prediction with the same sign of det J, else None."""
    J, end = rates_per_twist(robot, *pose), newton(robot, L, *pose)
    foretold, regular = solve(J, L - now)
    signs = [np.linalg.slogdet(matrix)[0][0] for matrix in (J, rates_per_twist(robot, end.R, end.t))]
    if not end.converged.all() or not regular.all() or signs[0] != signs[1]:
        return None
    made = _apart(robot, pose, (end.R, end.t))[0]
    size = characteristic_length(robot)
    step = foretold[0] * np.repeat([1.0, size], 3)
    near = np.linalg.norm(made - step) <= _ASTRAY * np.linalg.norm(step) + _SAME_POSE * size
    return (end.R, end.t) if near else None


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


def accelerations(time: Array, L_dot: Array) -> Array:
    """Return L_ddot (m/s^2), shape (n, 6), of a spline of degree 5 through the rates."""
    since = elapsed(time)
    return np.asarray(make_interp_spline(since, L_dot, k=min(5, len(since) - 1))(since, 1))


def jump(time: Array, L: Array) -> int | None:
    """Return the first sample at which lengths, shape (n, 6), jump more than a sampled motion can, or None.

    Accelerations around a jump change their sign. They are ten times larger than all accelerations of the
    neighboring samples, and so is the resulting change of length per step. After a longer time step only this
    change is large. Noise after a shorter time step makes only the accelerations large.
    """
    from scipy.ndimage import maximum_filter

    h = np.diff(elapsed(time))[:, None]
    if len(h) < 6:
        return None
    bent = 2.0 * np.diff(np.diff(L, axis=0) / h, axis=0) / (h[1:] + h[:-1])
    steps = np.abs(np.diff(L, axis=0))
    resolution = float(np.min(steps[steps > 0.0], initial=np.inf))
    floor = 4.0 * resolution if np.isfinite(resolution) else 0.0
    # Entry i belongs to sample i + 1; a jump from sample i + 1 to i + 2 affects entries i and i + 1.
    offsets = np.arange(-_SURROUNDINGS - 1, _SURROUNDINGS + 2)
    neighbors = (offsets < -1) | (offsets > 2)
    jumps = np.full(len(bent) - 1, True)
    for second, least in ((bent * h[1:] * h[:-1], floor), (bent, 0.0)):
        size = np.abs(second)
        turned = second[:-1] * second[1:] < 0.0
        both = np.where(turned, np.minimum(size[:-1], size[1:]), 0.0).max(axis=-1)
        around = maximum_filter(size.max(axis=-1), footprint=neighbors, mode="constant")[:-1]
        jumps &= both > np.maximum(_JUMP * around, least)
    return int(np.argmax(jumps)) + 2 if jumps.any() else None


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
