"""Motor torque, speed, current, power, and energy along a motion, compared with the motor limits."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..dynamics.inverse_dynamics import Backend, Formulation, inverse_dynamics
from ..io.arguments import finite_array, instance, real_array, status_text
from ..io.array_types import Array, Flags
from ..io.error_policy import warn
from ..io.frozen import Frozen, read_only
from ..kinematics.inverse_kinematics import inverse_kinematics
from ..kinematics.trajectory_checks import side_change
from ..motion.motion import Motion
from ..motion.sample_times import least_step, time_text
from ..motion.trajectory import Trajectory
from ..results import SingularPoseWarning
from ..robot.drive import Drive
from ..robot.robot import LEGS, Robot
from ..robot.units import Units
from .limit_status import USED_UP, Beyond, Extremes, Sides, amount_text, limit_status, status_codes
from .motor_states import MotorStates, motor_states
from .noise import MotorDeviations, all_deviations, at_replaced


class DriveLimitWarning(UserWarning):
    """Issued if a motion exceeds a motor limit, or may exceed it at the noise of its log."""


@dataclass(frozen=True, eq=False)
class DriveEffortResult(Frozen):
    """Motor torque, speed, current, power, and energy of the six drives along a motion.

    The leading shape ``(...)`` is the shape of the motion.

    Attributes
    ----------
    force : ndarray, shape (..., 6)
        Motor force along the leg (N): torque times ``Drive.transmission_ratio``, positive when it extends the
        leg.
    friction : ndarray, shape (..., 6)
        Part of ``force`` that overcomes friction and transmission losses (N).
    rotor : ndarray, shape (..., 6)
        Part of ``force`` that accelerates the rotors (N).
    torque : ndarray, shape (..., 6)
        Motor torque (N m).
    speed : ndarray, shape (..., 6)
        Motor speed (rad/s).
    current : ndarray, shape (..., 6), optional
        Motor current (A). NaN for motors without a torque constant; None if no motor has one.
    power : ndarray, shape (..., 6)
        Mechanical power at the motor shaft (W), negative when the leg drives the motor.
    electrical_power : ndarray, shape (..., 6)
        Electrical power (W): mechanical power plus the heat of the winding.
    rms_torque : ndarray, shape (6,)
        Root mean square of the torque over the motion (N m).
    peak_torque, peak_speed, peak_current, peak_power : ndarray, shape (6,)
        Largest magnitudes (N m, rad/s, A, W); 0 for an unknown current.
    energy : ndarray, shape (6,), optional
        Electrical energy (J), integrated by the trapezoidal rule; None without times.
    limit_messages : tuple of str
        One line for each limit that is exceeded or inconclusive at the noise of the log: legs, amount, and
        time.
    std : dict of ndarray, optional
        Standard deviations of these attributes by name, due to the noise of a log; None without noise. Values
        for ``rms_torque`` and ``energy`` are upper bounds, because errors may cancel over time.
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
    motion: Motion | Trajectory,
    time: ArrayLike | None = None,
    formulation: Formulation = "exact",
    backend: Backend = "c",
) -> DriveEffortResult:
    """Compute motor torque, speed, current, power, and energy along a motion.

    The motor torque is (F + friction) / N, where F is the actuator force and N is
    ``Drive.transmission_ratio``. F includes the force that accelerates the rotor; friction and efficiency act
    on the remainder.

    Parameters
    ----------
    robot : Robot
        Robot with a drive.
    motion : Motion, Trajectory
        Motion with accelerations and any external wrench, shape (...). A trajectory has its own times; if its
        log is noisy, the result has standard deviations.
    time : array_like, shape (n,), optional
        Increasing times of a motion of shape (n,) (s), required for the energy and for times in warnings. If
        None, all samples have equal weight and warnings give their index.
    formulation : {"exact", "paper"}, optional
        Corrected equations, or the equations as printed, as in ``inverse_dynamics``.
    backend : {"c", "numpy", "reference"}, optional
        Implementation of the dynamics, as in ``inverse_dynamics``.

    Returns
    -------
    DriveEffortResult
        Motor quantities at each sample, their peaks, and messages about limits.

    Raises
    ------
    ValueError
        If the robot has no drive, if the times do not increase, or as in ``inverse_dynamics``.

    Warns
    -----
    DriveLimitWarning
        For each limit that is exceeded or inconclusive at the noise of the log.
    SingularPoseWarning
        If the motion crosses a singular pose between two samples, at which no torque is sufficient.

    See Also
    --------
    motor_forces : Convert measured motor currents to motor forces.
    actuator_requirements : Compute the requirements of several motions for each leg.
    inverse_dynamics : Compute actuator forces.

    Examples
    --------
    >>> import dataclasses
    >>> import stewart_sym as ss
    >>> robot = dataclasses.replace(ss.robots.load("dasgupta1998"), drive=ss.Drive(lead=0.01))
    >>> path, step = ss.PAPER_PATHS["I"]
    >>> time = path.time_grid(step)
    >>> effort = ss.drive_effort(robot, path.sample(time), time=time)
    >>> effort.torque.shape
    (61, 6)
    >>> effort.peak_torque.round(3).tolist()
    [0.907, 1.825, 2.282, 0.982, 0.24, 0.61]
    """
    instance(robot, Robot, "robot")
    if robot.drive is None:
        raise ValueError("robot: expected a drive, got a robot without one ([legs.drive] of its file)")
    trajectory = None
    if isinstance(motion, Trajectory):
        if time is not None:
            raise ValueError("time: expected None with a trajectory, which contains its times")
        trajectory, time = motion, motion.time
        motion = trajectory.motion
    instance(motion, Motion, "motion")
    when = None if time is None else _times(time, motion)
    F = inverse_dynamics(robot, motion, formulation, backend).F
    found = motor_states(robot, robot.drive, motion, F, inverse_kinematics(robot, motion).L_dot)
    weights = np.full(motion.shape, 1.0) if when is None else trapezoids(when)
    summary = Summary(robot, 0.0 if when is None else least_step(when))
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
        warn(f"{text}: torques are unbounded", SingularPoseWarning)


def _deviations(sd: MotorDeviations, summary: Summary) -> dict[str, Array]:
    found = {name: values for name, values in sd._asdict().items() if values is not None}
    found |= {f"peak_{name}": values for name, values in summary.peak_sd.items()}
    rms = summary.rms_torque_sd
    found |= {"energy": summary.energy_sd} | ({} if rms is None else {"rms_torque": rms})
    return {name: read_only(values) for name, values in found.items()}


def motor_forces(robot: Robot, current: ArrayLike) -> Array:
    """Convert measured motor currents to motor forces along the legs.

    Parameters
    ----------
    robot : Robot
        Robot with a drive; every motor has a torque constant.
    current : array_like, shape (..., 6)
        Motor currents (A), with the sign of the torque.

    Returns
    -------
    ndarray, shape (..., 6)
        Motor forces (N), positive when they extend the leg: current times torque constant times
        ``Drive.transmission_ratio``.

    Raises
    ------
    ValueError
        If the robot has no such drive or ``current`` has another shape.

    See Also
    --------
    drive_effort : Compute the motor currents of a motion.
    identify : Identify parameters from measured forces.

    Examples
    --------
    >>> import dataclasses
    >>> import stewart_sym as ss
    >>> drive = ss.Drive(lead=0.01, torque_constant=0.2)
    >>> robot = dataclasses.replace(ss.robots.load("dasgupta1998"), drive=drive)
    >>> ss.motor_forces(robot, [1.0, 1.0, 1.0, 1.0, 1.0, 1.0]).round(2).tolist()
    [125.66, 125.66, 125.66, 125.66, 125.66, 125.66]
    """
    instance(robot, Robot, "robot")
    if robot.drive is None or not np.all(robot.drive.torque_constant > 0.0):
        raise ValueError("robot: expected a drive with a torque_constant for every leg")
    given = finite_array(current, (LEGS,), "current")
    return np.asarray(robot.drive.transmission_ratio * robot.drive.torque_constant * given)


def trapezoids(time: Array) -> Array:
    """Return the weight of each sample in the trapezoidal rule (s), for times of shape (n,)."""
    half = 0.5 * np.diff(time)
    return np.asarray(np.concatenate([half, [0.0]]) + np.concatenate([[0.0], half]))


def _times(time: ArrayLike, motion: Motion) -> Array:
    when = real_array(time, "time", "times of shape (n,)")
    if motion.shape != when.shape or when.ndim != 1 or len(when) < 2:
        raise ValueError(
            f"time: expected one value for each of at least two samples, {motion.shape}, got {when.shape}"
        )
    if not np.isfinite(when).all():
        i = int(np.flatnonzero(~np.isfinite(when))[0])
        raise ValueError(f"time: expected finite times, got {when[i]} at index {i}")
    if np.any(late := np.diff(when) <= 0.0):
        i = int(np.flatnonzero(late)[0]) + 1
        raise ValueError(f"time: expected increasing times, got {when[i]} at index {i} after {when[i - 1]}")
    return when


# Peaks and limits

PEAKS = {"torque": "N m", "speed": "rad/s", "current": "A", "power": "W"}
"""Quantities with a motor limit, and their units."""


class Summary:
    """Peaks, root mean squares, and energy of a sequence of samples that is processed in parts."""

    def __init__(self, robot: Robot, step: float) -> None:
        """Start a sequence for a robot with a drive; ``step`` is the smallest time step (s), or 0."""
        assert robot.drive is not None
        self.drive, self.step, self.units = robot.drive, step, Units.of(robot)
        self.extremes = {name: Extremes() for name in PEAKS}
        self.energy, self.squares, self.span, self.count = np.zeros(LEGS), np.zeros(LEGS), 0.0, 0
        # Upper bounds: errors of all samples are added, because their correlation is unknown.
        self.energy_sd, self._square_sd, self.noisy = np.zeros(LEGS), np.zeros(LEGS), False

    def add(
        self,
        part: MotorStates,
        weights: Array,
        time: Array | None,
        sd: MotorDeviations | None = None,
        there: Flags | None = None,
    ) -> None:
        """Add samples of shape (..., 6) with weights (s), shape (...), and optional times (s), shape (n,).

        ``sd`` contains standard deviations. ``there`` marks samples at replaced rows of a log.
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

        def when(samples: list[int]) -> list[str]:
            if time is None:
                return [f"sample {self.count + i}" for i in samples]
            return [f"{time_text(time[i], self.step)} s" for i in samples]

        for name, extremes in self.extremes.items():
            values = getattr(flat, name)
            if values is not None:
                extremes.add(np.abs(values), when, _sides(self.drive, sd, name), there)
        self.count += len(flat.torque)

    @property
    def peaks(self) -> dict[str, Array]:
        """Largest magnitudes by quantity, shape (6,) each."""
        return {name: extremes.peaks for name, extremes in self.extremes.items()}

    @property
    def peak_sd(self) -> dict[str, Array]:
        """Standard deviations of the peaks by quantity, shape (6,) each."""
        found = {name: extremes.peak_sd for name, extremes in self.extremes.items()}
        return {name: sd for name, sd in found.items() if sd is not None}

    @property
    def rms_torque(self) -> Array:
        """Root mean square torque (N m), shape (6,)."""
        return np.asarray(np.sqrt(self.squares / self.span)) if self.span > 0.0 else np.zeros(LEGS)

    @property
    def rms_torque_sd(self) -> Array | None:
        """Upper bound of the standard deviation of ``rms_torque`` (N m), or None without noise."""
        if not self.noisy:
            return None
        return np.asarray(np.sqrt(self._square_sd / self.span)) if self.span > 0.0 else np.zeros(LEGS)

    def exceeded(self, share: float = USED_UP) -> list[str]:
        """Return one line for each exceeded or inconclusive limit: legs, worst value, and time.

        ``share`` is the fraction of the limit by which it must be exceeded.
        """
        return [line for _, line in self.told(share)]

    def told(self, share: float = USED_UP) -> Iterator[tuple[str, str]]:
        """Yield the status and the line of each exceeded or inconclusive limit, as in ``exceeded``."""
        rms = Extremes()
        rms.add(self.rms_torque[None], lambda _: [""], _row(self.rms_torque_sd))
        # The prefix distinguishes drive.speed_limit from the speed limit of the legs.
        limits = [(f"drive.{name}_limit", name, unit, self.extremes[name]) for name, unit in PEAKS.items()]
        limits += [("drive.rated_torque", "root mean square of torque", "N m", rms)]
        for name, what, unit, extremes in limits:
            limit = getattr(self.drive, name.removeprefix("drive."))
            for beyond in extremes.beyond(limit * (1.0 + share)):
                yield beyond.verdict, _line(name, what, self.units.of_unit(unit), beyond, limit)

    def all_verdicts(self) -> list[list[str]]:
        """Return the status of each leg for all limits of the drive."""
        limits = {name: getattr(self.drive, f"{name}_limit") for name in PEAKS}
        limits["rated_torque"] = self.drive.rated_torque
        return [self.verdicts(name) for name, limit in limits.items() if np.isfinite(limit).any()]

    def verdicts(self, name: str) -> list[str]:
        """Return the status of each leg for one of ``PEAKS`` or for "rated_torque"."""
        if name == "rated_torque":
            limits = self.drive.rated_torque * (1.0 + USED_UP)
            return limit_status(self.rms_torque[None], limits, _row(self.rms_torque_sd))
        return self.extremes[name].verdicts(getattr(self.drive, f"{name}_limit") * (1.0 + USED_UP))


def motor_codes(
    drive: Drive, part: MotorStates, sd: MotorDeviations | None = None, there: Flags | None = None
) -> dict[str, NDArray[np.uint8]]:
    """Return the limit codes of each sample by quantity, shape (n, 6) each.

    Arguments are the same as for ``Summary.add``; ``status_codes`` defines the codes.
    """
    found = {}
    for name in PEAKS:
        values = getattr(part, name)
        if values is not None:
            limits = getattr(drive, f"{name}_limit") * (1.0 + USED_UP)
            found[name] = status_codes(np.abs(values), limits, _sides(drive, sd, name), there)
    return found


def _sides(drive: Drive, sd: MotorDeviations | None, name: str) -> Array | Sides | None:
    """Return the standard deviations of magnitudes, as an (up, down) pair if the two differ."""
    if sd is None or name not in ("torque", "current"):
        return None if sd is None else np.asarray(getattr(sd, name))
    with np.errstate(divide="ignore", invalid="ignore"):
        unit = np.asarray(drive.torque_constant) if name == "current" else np.ones(LEGS)
        return sd.torque_rise / unit, sd.torque_fall / unit


def _row(values: Array | None) -> Array | None:
    return None if values is None else values[None]


def _line(name: str, what: str, unit: tuple[float, str], beyond: Beyond, limits: Array) -> str:
    """Return the text about a limit; ``unit`` is the factor from the SI unit, and the name of the unit."""
    at, (scale, per) = f" at {beyond.when}" if beyond.when else "", unit
    sd = None if beyond.sd is None else scale * beyond.sd
    value = f"{amount_text(scale * beyond.size, sd)} {per}{at}"
    return (
        f"{name} {status_text(beyond.verdict)} by {beyond.legs_text}: {beyond.worst_text}{what} {value}, "
        f"limit {scale * limits[beyond.worst]:g} {per}{beyond.needed_noise(limits[beyond.worst])}"
    )
