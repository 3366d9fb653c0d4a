"""Motor torque, speed, current, power, and energy along a motion, compared with the motor limits."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..dynamics.inverse_dynamics import Backend, Formulation, inverse_dynamics
from ..io.arguments import finite_array, instance
from ..io.array_types import Array, Frozen, read_only
from ..io.error_policy import warn
from ..kinematics.inverse_kinematics import inverse_kinematics
from ..kinematics.trajectory_checks import side_change
from ..motion.motion import Motion
from ..motion.sample_times import least_step, time_text
from ..motion.trajectory import Trajectory
from ..results import SingularPoseWarning
from ..robot.robot import LEGS, Robot
from .limits import MOTOR_LIMITS, PEAKS, LimitTracker, times_of, trapezoids
from .motor_states import motor_states
from .noise import Deviations, all_deviations, at_replaced

_NOISY = ("torque", "speed", "current", "power", "electrical_power", "torque_rise", "torque_fall")
"""Quantities with standard deviations at every sample."""


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
    when = None if time is None else times_of(motion, time, least=2)
    F = inverse_dynamics(robot, motion, formulation, backend).F
    found = motor_states(robot, robot.drive, motion, F, inverse_kinematics(robot, motion).L_dot)
    values = {name: None if x is None else x.reshape(-1, LEGS) for name, x in found._asdict().items()}
    weights = np.ones(math.prod(motion.shape)) if when is None else trapezoids(when)
    limits = LimitTracker(robot, when, weights=weights)
    sd = there = None
    if trajectory is not None and trajectory.noise is not None:
        sd = all_deviations(robot, trajectory, formulation, backend)
        there = at_replaced(trajectory, trajectory.time)
    limits.add(slice(None), values, sd, there)
    lines = tuple(limits.exceeded())
    for line in lines:
        warn(line, DriveLimitWarning)
    if when is not None:
        _warn_of_crossing(robot, motion, when)
    return DriveEffortResult(
        **found._asdict(),
        rms_torque=limits.rms_torque,
        **{f"peak_{name}": limits.peaks(MOTOR_LIMITS[name])[0] for name in PEAKS},
        energy=None if when is None else limits.energy,
        limit_messages=lines,
        std=None if sd is None else _deviations(sd, limits),
    )


def _warn_of_crossing(robot: Robot, motion: Motion, when: Array) -> None:
    at = side_change(robot, motion)
    if at is not None:
        between = " and ".join(time_text(time, least_step(when)) for time in when[at : at + 2])
        text = f"motion: crosses a singular pose between {between} s, where det H changes its sign"
        warn(f"{text}: torques are unbounded", SingularPoseWarning)


def _deviations(sd: Deviations, limits: LimitTracker) -> dict[str, Array]:
    found = {name: sd[name] for name in _NOISY if name in sd}
    found |= {f"peak_{name}": values for name, values in limits.peak_sd.items()}
    rms = limits.rms_torque_sd
    found |= {"energy": limits.energy_sd} | ({} if rms is None else {"rms_torque": rms})
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
