"""What a motion takes of the motors: torque, speed, current, power and energy, beside their limits."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..dynamics.inverse import Backend, Formulation, inverse_dynamics
from ..io.arguments import finite_array, instance, real_array
from ..io.array_types import Array
from ..io.frozen import Frozen
from ..io.instants import least_step, time_text
from ..kinematics.inverse import inverse_kinematics
from ..motion.motion import Motion
from ..reference import newton_euler, offset_joints
from ..robot.drive import Drive
from ..robot.offset_chains import joint_motion, motor_motion
from ..robot.robot import LEGS, Robot
from .friction import friction_force

# A motion planned at a limit exceeds it by its own rounding, no more than this share of it.
_USED_UP = 1e-6


class DriveLimitWarning(UserWarning):
    """A motion takes more of a motor than its limits allow."""


@dataclass(frozen=True, eq=False)
class DriveEffort(Frozen):
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
    electrical : ndarray
        power and the heat of the winding, W, (..., 6).
    rms_torque : ndarray
        Root mean square over the motion, N m, (6,).
    peak_torque, peak_speed, peak_current, peak_power : ndarray
        Largest sizes, N m, rad/s, A and W, (6,); 0 of a current that is not known.
    energy : ndarray, optional
        Electrical, J, (6,), by the trapezoidal rule; None without times.
    exceeded : tuple
        A line for each limit that is exceeded: by which legs, by how much and when.
    """

    force: Array
    friction: Array
    rotor: Array
    torque: Array
    speed: Array
    current: Array | None
    power: Array
    electrical: Array
    rms_torque: Array
    peak_torque: Array
    peak_speed: Array
    peak_current: Array
    peak_power: Array
    energy: Array | None
    exceeded: tuple[str, ...]


def drive_effort(
    robot: Robot,
    motion: Motion,
    time: ArrayLike | None = None,
    formulation: Formulation = "exact",
    backend: Backend = "c",
) -> DriveEffort:
    """Torque, speed, current, power and energy of the motors along a motion; warns of limits exceeded.

    With N its turn per length the motor's torque is (F + friction) / N. F turns the rotor too; what is left
    of it passes through the screw, where efficiency and friction act.

    Parameters
    ----------
    robot : Robot
        The machine, with a drive.
    motion : Motion
        With accelerations and any load, (...).
    time : array_like, optional
        Of the instants, s, rising, (n,), for a motion of shape (n,): the energy, weights of the root mean
        square, and times in warnings. None: every instant counts the same, and warnings number them.
    formulation : {"exact", "paper"}, optional
        As for ``inverse_dynamics``.
    backend : {"c", "numpy", "reference"}, optional
        As for ``inverse_dynamics``.

    Returns
    -------
    DriveEffort
        Its arrays are described there.

    Raises
    ------
    ValueError
        For a robot without a drive, for times that do not rise, and as ``inverse_dynamics``.
    """
    instance(robot, Robot, "robot")
    if robot.drive is None:
        raise ValueError("robot: expected a drive, got a robot without one ([legs.drive] of its file)")
    instance(motion, Motion, "motion")
    when = None if time is None else _times(time, motion)
    F = inverse_dynamics(robot, motion, formulation, backend).F
    found = at_instants(robot, robot.drive, motion, F, inverse_kinematics(robot, motion).L_dot)
    weights = np.full(motion.shape, 1.0) if when is None else trapezoids(when)
    summary = Summary(robot.drive, 0.0 if when is None else least_step(when))
    summary.add(found, weights, when)
    lines = tuple(summary.exceeded())
    for line in lines:
        warnings.warn(line, DriveLimitWarning, stacklevel=2)
    return DriveEffort(
        **found._asdict(),
        rms_torque=summary.rms_torque,
        **{f"peak_{name}": summary.peaks[name] for name in PEAKS},
        energy=None if when is None else summary.energy,
        exceeded=lines,
    )


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
    return np.asarray(robot.drive.turns * robot.drive.torque_constant * given)


class Instants(NamedTuple):
    """Fields of ``DriveEffort`` that are given at every instant, (..., 6)."""

    force: Array
    friction: Array
    rotor: Array
    torque: Array
    speed: Array
    current: Array | None
    power: Array
    electrical: Array


def at_instants(robot: Robot, drive: Drive, motion: Motion, F: Array, L_dot: Array) -> Instants:
    """What each instant takes, from forces of ``inverse_dynamics``, N, and rates of length, m/s, (..., 6).

    NaN where these are.
    """
    with np.errstate(all="ignore"):
        if robot.offsets is None:
            rotor = newton_euler.rotor_force(robot, motion)
        else:
            rotor = offset_joints.rotor_force(robot, motion)
            L_dot = motor_rates(robot, drive, motion, L_dot)
    friction = friction_force(drive, F - rotor, L_dot)
    return _instants(drive, F + friction, friction, rotor, L_dot)


def of_motor_forces(robot: Robot, drive: Drive, motion: Motion, force: Array, L_dot: Array) -> Instants:
    """What each instant of a run takes whose forces are those of the motors, N times torque, N, (..., 6).

    Such are the forces of a simulation. Friction and rotors' parts are not told apart: NaN.
    """
    unknown = np.full(np.shape(force), np.nan)
    return _instants(drive, force, unknown, unknown, motor_rates(robot, drive, motion, L_dot))


def _instants(drive: Drive, force: Array, friction: Array, rotor: Array, L_dot: Array) -> Instants:
    torque = force / drive.turns
    speed = drive.turns * L_dot
    power = electrical = torque * speed
    current = None
    if np.any(drive.torque_constant):
        known = drive.torque_constant > 0.0
        current = torque / np.where(known, drive.torque_constant, np.nan)
        electrical = power + np.where(known, np.asarray(drive.resistance) * current**2, 0.0)
    return Instants(force, friction, rotor, torque, speed, current, power, electrical)


def motor_rates(robot: Robot, drive: Drive, motion: Motion, L_dot: Array) -> Array:
    """Rates of the motors over their ``turns``, m/s, (..., 6): L_dot but for U-C-U legs.

    Of these the motor sees the turning of the upper part as well.
    """
    if robot.offsets is None:
        return L_dot
    return motor_motion(robot, joint_motion(robot, motion).rates) / np.asarray(drive.turns)


def trapezoids(time: Array) -> Array:
    """How long each instant, s, (n,), stands for under the trapezoidal rule, s, (n,)."""
    half = 0.5 * np.diff(time)
    return np.asarray(np.concatenate([half, [0.0]]) + np.concatenate([[0.0], half]))


def _times(time: ArrayLike, motion: Motion) -> Array:
    when = real_array(time, "time", "times of shape (n,)")
    if motion.shape != when.shape or when.ndim != 1 or len(when) < 2:
        raise ValueError(f"time: expected one for each instant, {motion.shape}, got shape {when.shape}")
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
        self.peaks = {name: np.zeros(LEGS) for name in PEAKS}
        self.when: dict[str, list[str]] = {name: [""] * LEGS for name in PEAKS}
        self.energy, self.squares, self.span, self.count = np.zeros(LEGS), np.zeros(LEGS), 0.0, 0

    def add(self, part: Instants, weights: Array, time: Array | None) -> None:
        """Take in instants (..., 6) that stand for weights, s, (...), at times, s, (n,), if they have any."""
        if not part.torque.size:
            return
        flat = Instants(*(None if x is None else x.reshape(-1, LEGS) for x in part))  # type: ignore[arg-type]
        good = np.isfinite(flat.torque)
        each = weights.ravel()[:, None] * good
        self.energy = self.energy + np.sum(each * np.where(good, flat.electrical, 0.0), axis=0)
        self.squares = self.squares + np.sum(each * np.where(good, flat.torque, 0.0) ** 2, axis=0)
        self.span += float(weights.sum())
        for name in PEAKS if flat.current is not None else [name for name in PEAKS if name != "current"]:
            sizes = np.nan_to_num(np.abs(getattr(flat, name)), nan=-1.0)
            for leg, i in enumerate(np.argmax(sizes, axis=0).tolist()):
                if sizes[i, leg] > self.peaks[name][leg] or not self.when[name][leg]:
                    self.peaks[name][leg] = max(sizes[i, leg], 0.0)
                    at = self.count + i
                    self.when[name][leg] = (
                        f"instant {at}" if time is None else f"{time_text(time[i], self.step)} s"
                    )
        self.count += len(flat.torque)

    @property
    def rms_torque(self) -> Array:
        """Root mean squares, N m, (6,)."""
        return np.asarray(np.sqrt(self.squares / self.span)) if self.span > 0.0 else np.zeros(LEGS)

    def exceeded(self, share: float = _USED_UP) -> list[str]:
        """One line for each limit exceeded by more than a share: which legs, the worst, how much and when."""
        more = 1.0 + share
        found = [
            _line(name, self.peaks[name], getattr(self.drive, f"{name}_limit"), more, unit, self.when[name])
            for name, unit in PEAKS.items()
        ]
        rms = _line("rated_torque", self.rms_torque, self.drive.rated_torque, more, "N m", None)
        return [line for line in (*found, rms) if line]


def _line(name: str, values: Array, limits: Array, more: float, unit: str, when: list[str] | None) -> str:
    over = np.flatnonzero(values > limits * more).tolist()
    if not over:
        return ""
    worst = max(over, key=lambda leg: float(values[leg] / limits[leg]))
    # Legs have a speed_limit too.
    limit = f"drive.{name}" if when is None else f"drive.{name}_limit"
    legs = f"leg{'s' if len(over) > 1 else ''} {', '.join(str(leg + 1) for leg in over)}"
    what = "root mean square of torque" if when is None else name
    at = "" if when is None else f" at {when[worst]}"
    most = "" if len(over) == 1 else f"worst leg {worst + 1}: "
    worst_one = f"{most}{what} {values[worst]:.4g} {unit}{at}"
    return f"{limit} exceeded by {legs}: {worst_one}, limit {limits[worst]:g} {unit}"
