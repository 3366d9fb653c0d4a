"""Joint-space trajectories, section 4.3: platform motion from leg lengths over time, by continuation.

Leg lengths alone do not determine whether the platform crosses a singular pose or turns back at it: both
motions have the same lengths. The rates decide, because the platform velocity jumps if the platform turns
back. The continuation computes the poses on both sides at every sample and selects the pose that fits the
motion at the previous sample. It fails at the first sample at or before which the determinant of J changes
its sign. It also fails if the side of the pose is undecided because of the noise.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import deviations, finite_array, instance, real_array
from ..io.array_types import Array
from ..io.error_policy import warn
from ..io.progress import Progress, silent
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
from ..kinematics.trajectory_checks import side_doubt
from ..motion.interpolation import interpolate
from ..motion.log_rates import rate_error, scatter
from ..motion.log_reader import AS_SHOWN
from ..motion.motion import Motion
from ..motion.sample_times import elapsed
from ..motion.trajectory import SmoothingOptions, Trajectory
from ..motion.trajectory_format import PLAIN, TrajectoryFormat
from ..results import SINGULAR
from ..robot.robot import Robot
from . import length_steps
from .length_steps import CROSSED, NO_WAY, UNDECIDED, Legs, LostError, State, at_rest, some, walked
from .path_singularities import singularity_crossings

# Smallest number of samples for an estimate of the noise.
_FEWEST_OF_NOISE = 40
JUMPED = "the lengths jump here: no motion with the accelerations of the neighboring samples makes this step"
OFF_RATES = "the step in lengths from the previous sample contradicts the rates at both samples"


class RatesError(ValueError):
    """Raised if rates contradict the lengths."""


# Largest error of a length in standard deviations of its noise.
_SURE = 5.0
# Number of samples whose rates are computed at once.
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
    """Compute the platform motion from leg lengths and rates, sample by sample.

    The platform follows polynomials of degree 5 with the poses, rates, and accelerations at both ends between
    samples. If all rates are 0, the samples are poses at rest, and the legs move along straight lines in the
    space of lengths.

    Parameters
    ----------
    robot : Robot
        Robot geometry; ``length_limits`` are ignored.
    L : array_like, shape (n, 6)
        Leg lengths (m), in order of time.
    L_dot : array_like, shape (n, 6)
        Leg rates (m/s).
    L_ddot : array_like, shape (n, 6), optional
        Leg accelerations (m/s^2). Without them, the motion has no accelerations.
    guess : tuple of array_like, optional
        Pose (R, t) near the first sample; by default the search starts as in ``forward_kinematics``.
    F_ext : array_like, shape (n, 3), optional
        External force on the platform, as in ``Motion`` (N).
    M_ext : array_like, shape (n, 3), optional
        External moment on the platform, as in ``Motion`` (N m).
    time : array_like, shape (n,), optional
        Increasing sample times (s); by default the steps that fit ``L`` and ``L_dot``.
    length_std : array_like, optional
        Standard deviation of each length (m), broadcastable to (n, 6); by default estimated from rounding and
        scatter of at least 40 samples.
    progress : callable, optional
        Called with a text and the completed fraction of the samples, 0 to 1.

    Returns
    -------
    Motion
        Motion of the platform, shape (n,).

    Raises
    ------
    ValueError
        If an argument is invalid or if rates contradict the lengths beyond noise and rounding. If, at a
        sample named in the message, the lengths jump, contradict the rates, have no pose, or cross a singular
        pose. A crossing that is undecided because of the noise is also an error.

    See Also
    --------
    forward_kinematics : Compute independent poses from leg lengths.
    read_trajectory : Read a log of poses or leg lengths.

    Notes
    -----
    Continuation of the leg lengths follows section 4.3 of the paper. Rates contradict the lengths if they are
    delayed (from 3 % of the travel), scaled (from 8 %), or belong to a different motion (from 30 % over a
    span of at least 8 samples).

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> path, step = ss.PAPER_PATHS["I"]
    >>> time = path.time_grid(10 * step)
    >>> motion = path.sample(time)
    >>> legs = ss.inverse_kinematics(robot, motion)
    >>> rates = dict(L_dot=legs.L_dot, L_ddot=legs.L_ddot, time=time)
    >>> result = ss.motion_from_lengths(robot, legs.L, **rates, guess=(motion.R[0], motion.t[0]))
    >>> np.allclose(result.t, motion.t), np.allclose(result.a, motion.a)
    (True, True)
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
    # The motion copies its arrays, so these copies of the arguments are released before.
    rates.clear()
    del lengths
    return Motion(R=R, t=t, omega=omega, v=v, alpha=alpha, a=a, F_ext=F_ext, M_ext=M_ext)  # type: ignore[arg-type]


def on_platform(
    robot: Robot, joints: Trajectory, guess: Guess | None = None, progress: Progress = silent
) -> Trajectory:
    """Return a log with poses, computed if it contains leg lengths; errors contain its file and line."""
    if not joints.in_joints:
        if guess is not None:
            raise ValueError(f"pose guess: {joints.source} contains poses; omit the guess")
        return joints
    L, L_dot, L_ddot = joints.lengths
    std = None if joints.noise is None else np.sqrt(joints.noise.covariances(joints.time)[..., 0])
    given = (joints.F_ext, joints.M_ext, joints.time, std, progress)
    try:
        motion = motion_from_lengths(robot, L, L_dot, L_ddot, guess, *given)
    except RatesError as error:
        raise ValueError(f"{joints.source}: {error}") from None
    except LostError as error:
        row = joints.rows[error.sample]
        raise ValueError(f"{joints.source}: line {row}: {error.reason}") from None
    if guess is not None and (doubt := side_doubt(robot, motion)) is not None:
        warn(f"pose guess: {doubt}")
    return replace(joints, given_motion=motion)


def read_trajectory(
    robot: Robot,
    path: str | os.PathLike[str],
    file_format: TrajectoryFormat | None = None,
    smoothing: SmoothingOptions = AS_SHOWN,
    guess: Guess | None = None,
) -> Trajectory:
    """Read a log of poses or leg lengths as a motion of the robot's reference point.

    Poses and loads in the file refer to the robot's ``tool``, as in every subcommand.

    Parameters
    ----------
    robot : Robot
        Robot whose tool, rotation order, and length mode apply to its logs.
    path : path-like
        CSV file with one row per sample. Its columns are ``time`` and a pose (``t_x`` to ``t_z`` with
        ``theta_x`` to ``theta_z`` or ``q_w`` to ``q_z``) or leg lengths (``L_1`` to ``L_6``). All first and
        second derivatives and loads are optional.
    file_format : TrajectoryFormat, optional
        Column names, units, and conventions of the file. Properties that neither it nor the header states
        are those of the robot's ``trajectory_format``, otherwise SI units.
    smoothing : SmoothingOptions, optional
        Known properties of the noise; by default estimated.
    guess : tuple of array_like, optional
        Pose (R, t) near the first sample of a log of leg lengths, as in ``forward_kinematics``.

    Returns
    -------
    Trajectory
        Times (s), motion of the reference point, and noise of the log.

    Raises
    ------
    ValueError
        If the file or an argument is invalid. The message has one line with the file and the row or column.

    Warns
    -----
    TrajectoryWarning
        If numbers contradict each other or do not fit the robot, for example because of noise, outliers,
        delayed rates, or another unit.

    See Also
    --------
    motion_from_lengths : Compute the platform motion from arrays of leg lengths.
    interpolate : Interpolate the result between its samples.
    resample : Resample the result at a constant rate.

    Examples
    --------
    >>> import pathlib
    >>> import tempfile
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> path, step = ss.PAPER_PATHS["I"]
    >>> time = path.time_grid(10 * step)
    >>> legs = ss.inverse_kinematics(robot, path.sample(time))
    >>> rows = np.column_stack([time, legs.L, legs.L_dot, legs.L_ddot])
    >>> names = [f"{name}_{leg}" for name in ("L", "L_dot", "L_ddot") for leg in range(1, 7)]
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = pathlib.Path(folder) / "log.csv"
    ...     np.savetxt(file, rows, delimiter=",", header=",".join(["time", *names]), comments="")
    ...     log = ss.read_trajectory(robot, file)
    >>> np.allclose(log.motion.t, path.sample(time).t)
    True
    """
    instance(robot, Robot, "robot")
    instance(smoothing, SmoothingOptions, "smoothing")
    file_format = PLAIN if file_format is None else file_format
    instance(file_format, TrajectoryFormat, "file_format")
    return on_platform(robot, read_log_of(robot, path, file_format, smoothing), guess)


def _in_parts(function: Callable[..., tuple[Array, Array]], count: int) -> tuple[Array, Array]:
    """Evaluate two vectors, shape (n, 3), in parts of the samples to limit memory."""
    # The parts have equal sizes, because NumPy computes small ones with other last bits than the C code.
    parts = [function(part) for part in np.array_split(np.arange(count), max(1, count // _PART))]
    first, second = (np.concatenate(each) for each in zip(*parts, strict=True))
    return first, second


def _reject_unsettled(rate: Array) -> None:
    bad = np.flatnonzero(~np.isfinite(rate).all(axis=-1))
    if bad.size:
        raise LostError(
            int(bad[0]), "H is singular or the rates overflow: velocity and acceleration are undefined"
        )


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
    """Return R, shape (n, 3, 3), and t (m), shape (n, 3), along lengths (n, 6)."""
    start = forward_kinematics(robot, L[:1], guess, on_failure="nan", check_limits=False)
    if start.status.any():
        raise LostError(0, fault(robot, L[0], int(start.status[0]), guess is not None))
    first = (start.R, start.t)
    leap = length_steps.jump(np.arange(float(len(L))) if time is None else time, L)
    if time is None:
        time = length_steps.times_from_rates(L, L_dot)
        if time is None and length_steps.against_rates(L, L_dot):
            raise RatesError("L_dot: the lengths change against their rates: are signs opposite?")
    if len(L) < 2 or time is None or not np.any(L_dot):
        return at_rest(robot, first, L, progress)
    rates = length_steps.accelerations(time, L_dot) if L_ddot is None else L_ddot
    off = length_steps.step_beyond_rates(time, L, L_dot, rates)
    for sample, reason in ((leap, JUMPED), (off, OFF_RATES)):
        if sample is not None:
            raise LostError(sample, reason)
    contradiction, _ = rate_error(time, np.stack([L, L_dot, np.zeros(L.shape) if L_ddot is None else L_ddot]))
    if contradiction:
        raise RatesError(f"L_dot: {contradiction}")
    if robot.offsets is not None:
        # Singular poses of legs with offsets are not predicted, so each sample starts at the previous one.
        return at_rest(robot, first, L, progress)
    if sigma is None:
        sigma = scatter(L) if len(L) >= _FEWEST_OF_NOISE else np.zeros(6)
    noise = np.broadcast_to(sigma, L.shape)
    parts: list[State] = []
    done, decided, noisy = 0, len(L), bool(noise.any())
    for part, near in walked(robot, first, Legs(L, L_dot, rates), np.diff(elapsed(time))):
        progress(f"finding {len(L)} poses", done / len(L))
        parts.append(part)
        # Samples at which the noise of the lengths could move poses across a singular pose.
        open_ = _SURE * np.linalg.norm(near.legs * noise[done : done + len(part.t)], axis=-1)
        undecided = np.flatnonzero(near.lengths <= open_)
        if noisy and undecided.size:
            decided = min(decided, max(1, done + int(undecided[0])))
        done += len(part.t)
        if decided < done:
            break
    states = State(*(np.concatenate(each) for each in zip(*parts, strict=True)))
    decided = min(decided, done)
    same = decided - int(decided == done and states.sign[-1] != states.sign[0])
    _reject_crossings(robot, time[:same], some(states, slice(same)))
    if same < decided:
        raise LostError(same, CROSSED)
    if decided < len(L):
        last = some(states, slice(decided - 1, decided))
        miss = newton(robot, L[decided : decided + 1], last.R, last.t).residual[0]
        most = _SURE * float(noise[decided].max())
        noisy = most > 0.0 and (decided < done or miss <= most)
        raise LostError(decided, UNDECIDED.format(most / _SURE) if noisy else NO_WAY)
    return states.R, states.t


def _reject_crossings(robot: Robot, time: Array, states: State) -> None:
    """Raise LostError for the first sample at or before which the determinant of J changes its sign."""
    bad = np.flatnonzero(~np.isfinite(states.twist + states.rate).all(axis=-1))
    known = int(bad[0]) if bad.size else len(time)
    if known > 1:
        R, t, _, twist, rate = some(states, slice(known))
        motion = Motion._unchecked(R, t, twist[:, 3:], twist[:, :3], rate[:, 3:], rate[:, :3])
        path = interpolate(Trajectory(time[:known], motion, "L", range(known)))
        found = singularity_crossings(robot, path, time[:known])
        if found:
            raise LostError(int(np.searchsorted(time[:known], found[0].time)), CROSSED)
    if bad.size:
        raise LostError(known, REASONS[SINGULAR])
