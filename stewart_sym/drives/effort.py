"""What a motion takes of the motors: torque, speed, current, power and energy, beside their limits."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..dynamics.inverse_dynamics import Backend, Formulation, inverse_dynamics
from ..io.arguments import finite_array, instance, real_array, status_text
from ..io.array_types import Array, Flags
from ..io.error_policy import SingularPoseWarning, warn
from ..io.frozen import Frozen, read_only
from ..io.sample_times import least_step, time_text
from ..kinematics.inverse_kinematics import inverse_kinematics
from ..kinematics.trajectory_checks import side_change
from ..motion.motion import Motion
from ..motion.trajectory import PoseLog, Trajectory
from ..robot.drive import Drive
from ..robot.robot import LEGS, Robot
from .limit_status import USED_UP, Beyond, Extremes, Sides, amount_text, limit_status, status_codes
from .motor_states import MotorStates, motor_states
from .noise import MotorDeviations, all_deviations, at_replaced


class DriveLimitWarning(UserWarning):
    """A motion takes more of a motor than its limits allow, or may do so by the noise of its log."""


@dataclass(frozen=True, eq=False)
class DriveEffortResult(Frozen):
    """What a motion takes of six motors; (...) is the motion's shape, SI units.

    Attributes
    ----------
    force : ndarray
        N times torque: the motor's effort as a force along the leg, N, (..., 6), positive when it extends.
    friction : ndarray
        Part of it that friction and efficiency take, N, (..., 6).
    rotor : ndarray
        Part of it that turns the rotors, N, (..., 6).
    torque : ndarray
        Of the motors, N m, (..., 6).
    speed : ndarray
        Of the motors, rad/s, (..., 6).
    current : ndarray, optional
        A, (..., 6); NaN of a motor without a torque_constant, None where none has one.
    power : ndarray
        Mechanical, at the motor's shaft, W, (..., 6); negative where the leg drives the motor.
    electrical_power : ndarray
        power and the heat of the winding, W, (..., 6).
    rms_torque : ndarray
        Root mean square over the motion, N m, (6,).
    peak_torque, peak_speed, peak_current, peak_power : ndarray
        Largest sizes, N m, rad/s, A and W, (6,); 0 of a current that is not known.
    energy : ndarray, optional
        Electrical, J, (6,), by the trapezoidal rule; None without times.
    limit_messages : tuple
        A line for each limit that is exceeded, or not decided at the noise of a log: by which legs, by how
        much and when.
    std : dict, optional
        Standard deviations by noise of a log, arrays by the names of the fields above; those of rms_torque
        and energy, whose errors at different times need not cancel, at most so large. None without noise.
    """

    force: Array
    friction: Array
    rotor: Array
    torque: Array
    speed: Array
    current: Array | None
    power: Array
    electrical_power: Array
    rms_torque: Array
    peak_torque: Array
    peak_speed: Array
    peak_current: Array
    peak_power: Array
    energy: Array | None
    limit_messages: tuple[str, ...]
    std: Mapping[str, Array] | None = None


def drive_effort(
    robot: Robot,
    motion: Motion | Trajectory | PoseLog,
    time: ArrayLike | None = None,
    formulation: Formulation = "exact",
    backend: Backend = "c",
) -> DriveEffortResult:
    """Torque, speed, current, power and energy of the motors along a motion.

    Warns of limits exceeded, and of a singular pose between two instants, where no torque suffices.

    With N its turn per length the motor's torque is (F + friction) / N. F turns the rotor too; what is left
    of it passes through the screw, where efficiency and friction act.

    Parameters
    ----------
    robot : Robot
        The machine, with a drive.
    motion : Motion, Trajectory or PoseLog
        With accelerations and any load, (...). A trajectory has its own times, and noise of its log makes
        deviations.
    time : array_like, optional
        Of the instants, s, rising, (n,), for a motion of shape (n,): the energy, weights of the root mean
        square, and times in warnings. None: every instant counts the same, and warnings number them.
    formulation : {"exact", "paper"}, optional
        As for ``inverse_dynamics``.
    backend : {"c", "numpy", "reference"}, optional
        As for ``inverse_dynamics``.

    Returns
    -------
    DriveEffortResult
        Its arrays are described there.

    Raises
    ------
    ValueError
        For a robot without a drive, for times that do not rise, and as ``inverse_dynamics``.
    """
    instance(robot, Robot, "robot")
    if robot.drive is None:
        raise ValueError("robot: expected a drive, got a robot without one ([legs.drive] of its file)")
    trajectory = None
    if isinstance(motion, Trajectory | PoseLog):
        if time is not None:
            raise ValueError("time: expected None with a trajectory, which contains its times")
        trajectory, time = motion, motion.time
        motion = trajectory.motion
    instance(motion, Motion, "motion")
    when = None if time is None else _times(time, motion)
    F = inverse_dynamics(robot, motion, formulation, backend).F
    found = motor_states(robot, robot.drive, motion, F, inverse_kinematics(robot, motion).L_dot)
    weights = np.full(motion.shape, 1.0) if when is None else trapezoids(when)
    summary = Summary(robot.drive, 0.0 if when is None else least_step(when))
    sd = there = None
    if trajectory is not None and trajectory.noise is not None:
        sd = all_deviations(robot, trajectory, formulation, backend).motors
        there = at_replaced(trajectory, trajectory.time)
    summary.add(found, weights, when, sd, there)
    lines = tuple(summary.exceeded())
    for line in lines:
        warn(line, DriveLimitWarning)
    if when is not None:
        _warn_of_crossing(robot, motion, when)
    return DriveEffortResult(
        **found._asdict(),
        rms_torque=summary.rms_torque,
        **{f"peak_{name}": summary.peaks[name] for name in PEAKS},
        energy=None if when is None else summary.energy,
        limit_messages=lines,
        std=None if sd is None else _deviations(sd, summary),
    )


def _warn_of_crossing(robot: Robot, motion: Motion, when: Array) -> None:
    at = side_change(robot, motion)
    if at is not None:
        between = " and ".join(time_text(time, least_step(when)) for time in when[at : at + 2])
        text = f"motion: crosses a singular pose between {between} s, where det H changes its sign"
        warn(f"{text}: torques grow without bound", SingularPoseWarning)


def _deviations(sd: MotorDeviations, summary: Summary) -> dict[str, Array]:
    found = {name: values for name, values in sd._asdict().items() if values is not None}
    found |= {f"peak_{name}": values for name, values in summary.peak_sd.items()}
    rms = summary.rms_torque_sd
    found |= {"energy": summary.energy_sd} | ({} if rms is None else {"rms_torque": rms})
    return {name: read_only(values) for name, values in found.items()}


def motor_forces(robot: Robot, current: ArrayLike) -> Array:
    """Forces of the motors along the legs from their measured currents: N times torque.

    Parameters
    ----------
    robot : Robot
        The machine, with a drive whose torque_constant is given.
    current : array_like
        A, (..., 6), signed as the torque is.

    Returns
    -------
    ndarray
        Forces, N, (..., 6), positive when they extend the leg.

    Raises
    ------
    ValueError
        For a robot without such a drive, and for currents of another shape.
    """
    instance(robot, Robot, "robot")
    if robot.drive is None or not np.all(robot.drive.torque_constant > 0.0):
        raise ValueError("robot: expected a drive with a torque_constant of every leg")
    given = finite_array(current, (LEGS,), "current")
    return np.asarray(robot.drive.transmission_ratio * robot.drive.torque_constant * given)


def trapezoids(time: Array) -> Array:
    """How long each instant, s, (n,), stands for under the trapezoidal rule, s, (n,)."""
    half = 0.5 * np.diff(time)
    return np.asarray(np.concatenate([half, [0.0]]) + np.concatenate([[0.0], half]))


def _times(time: ArrayLike, motion: Motion) -> Array:
    when = real_array(time, "time", "times of shape (n,)")
    if motion.shape != when.shape or when.ndim != 1 or len(when) < 2:
        raise ValueError(
            f"time: expected one for each of two instants or more, {motion.shape}, got shape {when.shape}"
        )
    if not np.isfinite(when).all():
        i = int(np.flatnonzero(~np.isfinite(when))[0])
        raise ValueError(f"time: expected finite times, got {when[i]} at index {i}")
    if np.any(late := np.diff(when) <= 0.0):
        i = int(np.flatnonzero(late)[0]) + 1
        raise ValueError(f"time: expected times that rise, got {when[i]} at index {i} after {when[i - 1]}")
    return when


# Peaks and limits

PEAKS = {"torque": "N m", "speed": "rad/s", "current": "A", "power": "W"}
"""Quantities of which each motor has a limit, and their units."""


class Summary:
    """Peaks, root mean squares and energy of a run of instants, part after part."""

    def __init__(self, drive: Drive, step: float) -> None:
        """Begin a run; step: least time between instants, s, 0 where they have no times."""
        self.drive, self.step = drive, step
        self.extremes = {name: Extremes() for name in PEAKS}
        self.energy, self.squares, self.span, self.count = np.zeros(LEGS), np.zeros(LEGS), 0.0, 0
        # Of errors at single instants that all add up: how they go together is not known.
        self.energy_sd, self._square_sd, self.noisy = np.zeros(LEGS), np.zeros(LEGS), False

    def add(
        self,
        part: MotorStates,
        weights: Array,
        time: Array | None,
        sd: MotorDeviations | None = None,
        there: Flags | None = None,
    ) -> None:
        """Take in instants (..., 6) that stand for weights, s, (...), at times, s, (n,), if they have any.

        sd: deviations by noise. there: instants, (n,), at which they are those of replaced rows.
        """
        if not part.torque.size:
            return
        flat = MotorStates(*(None if x is None else x.reshape(-1, LEGS) for x in part))  # type: ignore[arg-type]
        good = np.isfinite(flat.torque)
        each = weights.ravel()[:, None] * good
        self.energy = self.energy + np.sum(each * np.where(good, flat.electrical_power, 0.0), axis=0)
        self.squares = self.squares + np.sum(each * np.where(good, flat.torque, 0.0) ** 2, axis=0)
        self.span += float(weights.sum())
        if sd is not None:
            self.noisy = True
            counted = each > 0.0
            self.energy_sd = self.energy_sd + np.sum(
                each * np.where(counted, sd.electrical_power, 0.0), axis=0
            )
            self._square_sd = self._square_sd + np.sum(each * np.where(counted, sd.torque, 0.0) ** 2, axis=0)

        def when(instants: list[int]) -> list[str]:
            if time is None:
                return [f"instant {self.count + i}" for i in instants]
            return [f"{time_text(time[i], self.step)} s" for i in instants]

        for name, extremes in self.extremes.items():
            values = getattr(flat, name)
            if values is not None:
                extremes.add(np.abs(values), when, _sides(self.drive, sd, name), there)
        self.count += len(flat.torque)

    @property
    def peaks(self) -> dict[str, Array]:
        """Largest sizes by the names of ``PEAKS``, (6,)."""
        return {name: extremes.peaks for name, extremes in self.extremes.items()}

    @property
    def peak_sd(self) -> dict[str, Array]:
        """Their deviations by noise, (6,), of those that have them."""
        found = {name: extremes.peak_sd for name, extremes in self.extremes.items()}
        return {name: sd for name, sd in found.items() if sd is not None}

    @property
    def rms_torque(self) -> Array:
        """Root mean squares, N m, (6,)."""
        return np.asarray(np.sqrt(self.squares / self.span)) if self.span > 0.0 else np.zeros(LEGS)

    @property
    def rms_torque_sd(self) -> Array | None:
        """Their deviations by noise, at most, N m, (6,); None without."""
        if not self.noisy:
            return None
        return np.asarray(np.sqrt(self._square_sd / self.span)) if self.span > 0.0 else np.zeros(LEGS)

    def exceeded(self, share: float = USED_UP) -> list[str]:
        """One line for each limit and verdict: which legs, the worst, how much and when.

        share: of a limit, by which it must be exceeded.
        """
        return [line for _, line in self.told(share)]

    def told(self, share: float = USED_UP) -> Iterator[tuple[str, str]]:
        """Verdicts and the lines of ``exceeded``."""
        rms = Extremes()
        rms.add(self.rms_torque[None], lambda _: [""], _row(self.rms_torque_sd))
        # Legs have a speed_limit too.
        limits = [(f"drive.{name}_limit", name, unit, self.extremes[name]) for name, unit in PEAKS.items()]
        limits += [("drive.rated_torque", "root mean square of torque", "N m", rms)]
        for name, what, unit, extremes in limits:
            limit = getattr(self.drive, name.removeprefix("drive."))
            for beyond in extremes.beyond(limit * (1.0 + share)):
                yield beyond.verdict, _line(name, what, unit, beyond, limit)

    def verdicts(self, name: str) -> list[str]:
        """Of each leg's limit of one of ``PEAKS``, or of "rated_torque"."""
        if name == "rated_torque":
            limits = self.drive.rated_torque * (1.0 + USED_UP)
            return limit_status(self.rms_torque[None], limits, _row(self.rms_torque_sd))
        return self.extremes[name].verdicts(getattr(self.drive, f"{name}_limit") * (1.0 + USED_UP))


def motor_codes(
    drive: Drive, part: MotorStates, sd: MotorDeviations | None = None, there: Flags | None = None
) -> dict[str, NDArray[np.uint8]]:
    """``status_codes`` at instants by the names of ``PEAKS``, (n, 6); arguments as of ``Summary.add``."""
    found = {}
    for name in PEAKS:
        values = getattr(part, name)
        if values is not None:
            limits = getattr(drive, f"{name}_limit") * (1.0 + USED_UP)
            found[name] = status_codes(np.abs(values), limits, _sides(drive, sd, name), there)
    return found


def _sides(drive: Drive, sd: MotorDeviations | None, name: str) -> Array | Sides | None:
    """Deviations of sizes, upward and downward where these differ."""
    if sd is None or name not in ("torque", "current"):
        return None if sd is None else np.asarray(getattr(sd, name))
    with np.errstate(divide="ignore", invalid="ignore"):
        unit = np.asarray(drive.torque_constant) if name == "current" else np.ones(LEGS)
        return sd.torque_rise / unit, sd.torque_fall / unit


def _row(values: Array | None) -> Array | None:
    return None if values is None else values[None]


def _line(name: str, what: str, unit: str, beyond: Beyond, limits: Array) -> str:
    at = f" at {beyond.when}" if beyond.when else ""
    value = f"{amount_text(beyond.size, beyond.sd)} {unit}{at}"
    return (
        f"{name} {status_text(beyond.verdict)} by {beyond.legs_text}: {beyond.worst_text}{what} {value}, "
        f"limit {limits[beyond.worst]:g} {unit}"
    )
