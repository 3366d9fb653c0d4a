"""Joint-space trajectories, section 4.3: the platform's motion from leg lengths over time, by continuation.

From lengths alone it is undecided whether the platform crosses a singular pose or turns back at it: both
motions have the same lengths. The rates decide it: turned back, the platform's velocity jumps. At every
sample the poses on both sides are found, and the one that fits the motion of the sample before is taken;
where J's determinant has changed its sign by then, or does so between the samples, the sample is named.
Where noise of the lengths hides on which side the pose is, it hides what the motion does there: that sample
is named as not decided.
"""

from __future__ import annotations

import itertools
import math
import os
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import deviations, finite_array, instance, real_array
from ..io.array_types import Array
from ..io.progress import Progress, silent
from ..io.sample_times import elapsed
from ..kinematics.forward_kinematics import (
    REASONS,
    Guess,
    checked_lengths,
    fault,
    forward_acceleration,
    forward_kinematics,
    forward_velocity,
)
from ..kinematics.pose_search import newton
from ..kinematics.robot_logs import read_log_of
from ..motion.interpolation import interpolate
from ..motion.log_reader import AS_SHOWN, PLAIN, trajectory_from
from ..motion.logs import TrajectoryFormat
from ..motion.motion import Motion
from ..motion.noise_level import LEAST_SAMPLES, rounding_steps, white_noise
from ..motion.rate_doubts import rate_doubts
from ..motion.trajectory import JointTrajectory, SmoothingOptions, Trajectory
from ..results import SINGULAR
from ..robot.robot import Robot
from . import length_steps
from .length_steps import CROSSED, NO_WAY, UNDECIDED, Legs, LostError, at_rest, pose_of, walked
from .path_singularities import singularity_crossings

JUMPED = "the lengths jump here: no motion with the accelerations of the samples around it makes this step"
OFF_RATES = "the step in lengths from the sample before is not what the rates at both samples make of it"


class RatesError(ValueError):
    """Rates are not those of the lengths."""


# Lengths may be off by this many deviations of their noise.
_SURE = 5.0
# Samples whose rates are found at once.
_PART = 1 << 14


def motion_from_lengths(
    robot: Robot,
    L: ArrayLike,
    L_dot: ArrayLike,
    L_ddot: ArrayLike | None = None,
    guess: Guess | None = None,
    F_ext: ArrayLike | None = None,
    M_ext: ArrayLike | None = None,
    time: ArrayLike | None = None,
    length_std: ArrayLike | None = None,
    progress: Progress = silent,
) -> Motion:
    """Return the platform's motion, of shape (n,), from that of its legs, (n, 6), sample after sample.

    Between samples the platform moves as poses, rates and accelerations at both ends say (polynomials of
    degree 5). Where all rates are 0, the samples are poses at rest, and between them the legs move along a
    straight line in the space of lengths.

    Parameters
    ----------
    robot : Robot
        The machine; its length_limits do not count.
    L, L_dot : array_like
        Lengths of the legs and their rates, m and m/s, in order of time.
    L_ddot : array_like, optional
        Their accelerations, m/s^2; without, the motion has none.
    guess : Guess, optional
        Pose (R, t) near the first sample; None: as in ``forward_kinematics``.
    F_ext, M_ext : array_like, optional
        As in ``Motion``.
    time : array_like, optional
        Of the samples, s, (n,), increasing; None: the steps that fit L and L_dot.
    length_std : array_like, optional
        Standard deviation of each length, m, broadcasts to (n, 6); None: what rounding or scatter of the
        numbers show, from 40 samples on.
    progress : Progress, optional
        Called with what is being done and the share of the samples that is done, 0 to 1.

    Returns
    -------
    Motion
        Motion of shape (n,).

    Raises
    ------
    ValueError
        Naming the legs whose rates say other changes, beyond noise and rounding: by a delay (from 3 % of how
        far the legs move), a factor (from 8 %) or because they are of another motion (from 30 % over some
        stretch of samples, of which there are at least 8); naming the sample where the lengths jump, differ
        from what the rates say, belong to no pose, or lead through a singular one or so near one that this is
        not decided at their noise; and naming the argument for any other bad input.
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
    when = None if time is None else real_array(time, "time", "increasing times")
    if when is not None:
        n, finite = len(lengths), bool(np.isfinite(when).all())
        if when.shape != (n,) or not finite or np.any(np.diff(when) <= 0.0):
            raise ValueError(f"time: expected {n} finite times, increasing, of shape ({n},)")
    noise = (
        None
        if length_std is None
        else deviations(length_std, "length_std", lengths.shape, f">= 0 m that broadcast to {lengths.shape}")
    )
    R, t = _follow(robot, when, lengths, rates["L_dot"], rates.get("L_ddot"), guess, noise, progress)
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
    return Motion(R=R, t=t, omega=omega, v=v, alpha=alpha, a=a, F_ext=F_ext, M_ext=M_ext)  # type: ignore[arg-type]


def on_platform(
    robot: Robot, joints: JointTrajectory, guess: Guess | None = None, progress: Progress = silent
) -> Trajectory:
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
            progress,
        )
    except RatesError as error:
        raise ValueError(f"{joints.source}: {error}") from None
    except LostError as error:
        row = joints.rows[error.sample]
        raise ValueError(f"{joints.source}: line {row}: {error.reason}") from None
    return Trajectory(joints.time, motion, joints.source, joints.rows, joints.noise)


def read_trajectory(
    robot: Robot,
    path: str | os.PathLike[str],
    file_format: TrajectoryFormat | None = None,
    smoothing: SmoothingOptions = AS_SHOWN,
    guess: Guess | None = None,
) -> Trajectory:
    """Read a log of the robot, poses or leg lengths, as the motion of its reference point.

    Poses and loads are those of the robot's ``tool``, as in every subcommand. Warns of numbers that do not go
    with each other or with the robot: noise, wrong rows, late rates, other units.

    Parameters
    ----------
    robot : Robot
        The machine, with the tool, the order of rotations and the kind of lengths of its logs.
    path : path-like
        CSV file, a row per instant: ``time`` and either ``t_x`` to ``t_z`` with ``theta_x`` to ``theta_z`` or
        ``q_w`` to ``q_z``, or ``L_1`` to ``L_6``; optionally all rates and second rates, and loads.
    file_format : TrajectoryFormat, optional
        Names, units and marks of the file, None: SI units; an ``euler_order`` or ``lengths`` of None is the
        robot's.
    smoothing : SmoothingOptions, optional
        What is known of the noise.
    guess : tuple, optional
        Of leg lengths: R and t near the first pose, as for ``forward_kinematics``.

    Returns
    -------
    Trajectory
        Times, the motion of the reference point, and the noise of the log.

    Raises
    ------
    ValueError
        Of one line that names the file and the row or column.
    """
    instance(robot, Robot, "robot")
    instance(smoothing, SmoothingOptions, "smoothing")
    file_format = PLAIN if file_format is None else file_format
    instance(file_format, TrajectoryFormat, "file_format")
    log = read_log_of(robot, path, file_format, smoothing)
    if isinstance(log, JointTrajectory):
        return on_platform(robot, log, guess)
    if guess is not None:
        raise ValueError(f"guess: is for leg lengths, {log.source} is of poses")
    return trajectory_from(log)


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
        raise LostError(int(bad[0]), "H is singular or the rates overflow: no velocity or acceleration")


def _follow(
    robot: Robot,
    time: Array | None,
    L: Array,
    L_dot: Array,
    L_ddot: Array | None,
    guess: Guess | None,
    sigma: Array | None,
    progress: Progress,
) -> tuple[Array, Array]:
    """Return R, (n, 3, 3), and t, (n, 3), along lengths (n, 6)."""
    start = forward_kinematics(robot, L[:1], guess, on_failure="nan", check_limits=False)
    if start.status.any():
        raise LostError(0, fault(robot, L[0], int(start.status[0]), guess is not None))
    first = pose_of(robot, start.R, start.t, L[:1])
    leap = length_steps.jump(np.arange(float(len(L))) if time is None else time, L)
    if time is None:
        time = length_steps.times_from_rates(L, L_dot)
        if time is None and length_steps.against_rates(L, L_dot):
            raise RatesError("L_dot: the lengths change against their rates: are signs opposite?")
    if len(L) < 2 or time is None or not np.any(L_dot):
        return at_rest(robot, first, L, progress)
    rates = length_steps.accelerations(time, L, L_dot) if L_ddot is None else L_ddot
    off = length_steps.step_beyond_rates(time, L, L_dot, rates)
    for sample, reason in ((leap, JUMPED), (off, OFF_RATES)):
        if sample is not None:
            raise LostError(sample, reason)
    _reject_other_rates(time, L, L_dot, L_ddot)
    if robot.offsets is not None:
        # Singular poses of legs with offsets are not foretold: each sample is approached from the last.
        return at_rest(robot, first, L, progress)
    noise = _noise(time, L) if sigma is None else sigma
    R, t, twist, rate = (np.empty((len(L), *shape)) for shape in ((3, 3), (3,), (6,), (6,)))
    done, decided, sign, noisy = 0, len(L), first.sign[0], bool(noise.any())
    for run in walked(robot, first, Legs(L, L_dot, rates), np.diff(elapsed(time))):
        progress(f"finding {len(L)} poses", done / len(L))
        here = slice(done, done + len(run.state.twist))
        R[here], t[here], twist[here], rate[here] = run.state.pose.R, run.state.pose.t, *run.state[1:]
        # Where noise of the lengths could carry poses through a singular one.
        open_ = _SURE * np.linalg.norm(run.near.legs * noise[here], axis=-1)
        undecided = np.flatnonzero(run.near.lengths <= open_)
        if noisy and undecided.size:
            decided = min(decided, max(1, done + int(undecided[0])))
        done, sign = here.stop, run.state.pose.sign[-1]
        if decided < done:
            break
    decided = min(decided, done)
    same = decided - int(decided == done and sign != first.sign[0])
    _reject_crossings(robot, time[:same], R[:same], t[:same], twist[:same], rate[:same])
    if same < decided:
        raise LostError(same, CROSSED)
    if decided < len(L):
        last = slice(decided - 1, decided)
        miss = newton(robot, L[decided : decided + 1], R[last], t[last]).residual[0]
        most = _SURE * float(noise[decided].max())
        near = decided < done or miss <= most
        raise LostError(decided, UNDECIDED.format(most / _SURE) if near and most > 0.0 else NO_WAY)
    return R, t


def _reject_other_rates(time: Array, L: Array, L_dot: Array, L_ddot: Array | None) -> None:
    """Reject rates and accelerations of another motion than that of the numbers that they are rates of."""
    columns = {"L": L, "L_dot": L_dot} | ({} if L_ddot is None else {"L_ddot": L_ddot})
    if not any(rates.any() for rates in [*columns.values()][1:]):  # poses at rest
        return
    legs = [[f"{name}_{leg}" for leg in range(1, 7)] for name in columns]
    for i, doubt in rate_doubts(time, [*columns.values()], legs):
        raise RatesError(f"{[*columns][i + 1]}: {doubt}")


def _noise(time: Array, L: Array) -> Array:
    """Standard deviation of each length, (n, 6), as the numbers show it."""
    if len(L) < LEAST_SAMPLES:
        return np.zeros(L.shape)
    shown_noise = np.maximum(rounding_steps(L) / math.sqrt(12.0), white_noise(time, L))
    return np.broadcast_to(shown_noise, L.shape)


def _reject_crossings(robot: Robot, time: Array, R: Array, t: Array, twist: Array, rate: Array) -> None:
    """Name the first sample before which J's determinant changes its sign, between samples too."""
    bad = np.flatnonzero(~np.isfinite(twist + rate).all(axis=-1))
    known = int(bad[0]) if bad.size else len(twist)
    if known > 1:
        arrays = (R, t, twist[:, 3:], twist[:, :3], rate[:, 3:], rate[:, :3])
        motion = Motion._unchecked(*(x[:known] for x in arrays))
        found = singularity_crossings(
            robot, interpolate(Trajectory(time[:known], motion, "L", range(known))), time[:known]
        )
        if found:
            raise LostError(int(np.searchsorted(time[:known], found[0].time)), CROSSED)
    if bad.size:
        raise LostError(known, REASONS[SINGULAR])
