"""Leg lengths, leg rates, and motor torques as formulas on numbers of any kind: arrays or CasADi symbols.

Vectors are lists of three numbers, and R is a list of nine numbers, row by row. The robot must not have
offset joints.
"""

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any, NamedTuple

from ..robot.robot import LEGS, Robot

Vector = list[Any]


class Functions(NamedTuple):
    """Functions of one kind of numbers; ``where(test, yes, no)`` selects one of two numbers."""

    sqrt: Callable[[Any], Any]
    absolute: Callable[[Any], Any]
    exp: Callable[[Any], Any]
    where: Callable[[Any, Any, Any], Any]


class LegMotion(NamedTuple):
    """Motion of one leg: platform point q (m), unit vector s, length L (m), (1)-(3), and rates (4), (5)."""

    q: Vector
    s: Vector
    L: Any
    S_dot: Vector
    L_dot: Any


def leg_motions(on: Functions, robot: Robot, motion: SimpleNamespace) -> list[LegMotion]:
    """Compute the motion of all legs from R, t, omega, and v."""
    return [_leg_motion(on, b, p, motion) for b, p in zip(robot.b.tolist(), robot.p.tolist(), strict=True)]


def _leg_motion(on: Functions, b: Vector, p: Vector, motion: SimpleNamespace) -> LegMotion:
    q = [_dot(motion.R[3 * i : 3 * i + 3], p) for i in range(3)]
    S = [q[i] + motion.t[i] - b[i] for i in range(3)]
    L = on.sqrt(_dot(S, S))
    s = [component / L for component in S]
    S_dot = _sum(motion.v, _cross(motion.omega, q))
    return LegMotion(q, s, L, S_dot, _dot(s, S_dot))


def motor_torques(on: Functions, robot: Robot, motion: SimpleNamespace, F: Vector) -> Vector:
    """Compute the motor torques (N m) of a robot with a drive from its motion and its forces (N)."""
    legs = leg_motions(on, robot, motion)
    return [_motor_torque(on, robot, i, F[i], legs[i], motion) for i in range(LEGS)]


def _motor_torque(
    on: Functions, robot: Robot, i: int, F: Any, leg: LegMotion, motion: SimpleNamespace
) -> Any:
    drive = robot.drive
    assert drive is not None
    rate, N = leg.L_dot, float(drive.transmission_ratio[i])
    screw = F - _rotor_force(robot, i, leg, motion) if drive.rotor_inertia[i] else F
    sign = on.where(rate > 0.0, 1.0 + 0.0 * rate, on.where(rate < 0.0, -1.0 + 0.0 * rate, 0.0 * rate))
    within = float(drive.regularization_speed[i])
    if within > 0.0:
        x = on.where(on.absolute(rate) < within, rate / within, sign)
        sign = 0.5 * x * (3.0 - x * x)
    driving, driven = 1.0 / float(drive.efficiency[i]) - 1.0, 1.0 - float(drive.backdrive_efficiency[i])
    size = on.absolute(screw)
    dry = float(drive.screw_coulomb[i]) + abs(N) * float(drive.motor_coulomb[i])
    dry = dry + on.where(screw * sign > 0.0, driving * size, driven * size)
    if drive.stribeck_force[i]:
        ratio = rate / float(drive.stribeck_speed[i])
        dry = dry + float(drive.stribeck_force[i]) * on.exp(-(ratio * ratio))
    viscous = float(drive.screw_viscous[i]) + N * N * float(drive.motor_viscous[i])
    return (F + sign * dry + viscous * rate) / N


def _rotor_force(robot: Robot, i: int, leg: LegMotion, motion: SimpleNamespace) -> Any:
    """Compute the part of a force that accelerates the rotor, from L_ddot, (8), and the spin acceleration."""
    swung = _sum(_cross(motion.alpha, leg.q), _cross(motion.omega, _cross(motion.omega, leg.q)))
    S_ddot = _sum(motion.a, swung)
    across = [velocity - leg.L_dot * s for velocity, s in zip(leg.S_dot, leg.s, strict=True)]
    L_ddot = _dot(leg.s, S_ddot) + _dot(across, across) / leg.L
    momentum, force = float(robot.rotor_momentum[i]), float(robot.reflected_mass[i]) * L_ddot
    if momentum == 0.0:
        return force
    k, s_dot = robot.k[i].tolist(), [component / leg.L for component in across]
    # The spin of a leg is (k.s) (y.s_dot) / y.y with y = k x s.
    y, y_dot = _cross(k, leg.s), _cross(k, s_dot)
    square, along, turning = _dot(y, y), _dot(k, leg.s), _dot(y, s_dot)
    turning_dot = (_dot(y, S_ddot) - 2.0 * leg.L_dot * turning) / leg.L
    spin_dot = (_dot(k, s_dot) * turning + along * turning_dot) / square
    return force + momentum * (spin_dot - 2.0 * along * turning * _dot(y, y_dot) / (square * square))


def _dot(x: Vector, y: Vector) -> Any:
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]


def _sum(x: Vector, y: Vector) -> Vector:
    return [x[i] + y[i] for i in range(3)]


def _cross(x: Vector, y: Vector) -> Vector:
    return [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]
