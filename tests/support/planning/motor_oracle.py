"""Motors along a plan on a grid 100 times finer, from both sides of every node and turning point.

Friction of the drives is written anew; its sign is taken a little way off, on the side in question.
"""

from typing import NamedTuple

import numpy as np

from stewart_sym.dynamics.inverse_dynamics import inverse_dynamics
from stewart_sym.kinematics.inverse_kinematics import inverse_kinematics
from stewart_sym.planning.path_parameterization import TimedPath
from stewart_sym.planning.timing.path_terms import traveled
from stewart_sym.reference.newton_euler import rotor_force

FINER = 100
_BISECTIONS = 40
_ASIDE = 1e-3


class Fine(NamedTuple):
    """Largest force, N, torque, N m, and power, W, of each leg, (6,), and share of any limit that is used."""

    force: np.ndarray
    torque: np.ndarray
    power: np.ndarray
    used: np.ndarray


def fine_motors(plan: TimedPath) -> Fine:
    """Evaluate a plan's motors at all shares k / 100 of its cells and at rest.

    Both ends of the cells are included, and both sides of the points where legs turn back.
    """
    cells = len(plan.profile.times) - 1
    share = np.tile(np.linspace(0.0, 1.0, FINER + 1), (cells, 1))
    aside = share.copy()
    aside[:, 0], aside[:, -1] = _ASIDE, 1.0 - _ASIDE
    rate = _leg_rates(plan, aside, np.broadcast_to(np.arange(cells)[:, None], aside.shape))
    i, k, leg = np.nonzero(rate[:, :-1] * rate[:, 1:] < 0.0)
    low, high = aside[i, k], aside[i, k + 1]
    below = np.sign(rate[i, k, leg])
    for _ in range(_BISECTIONS):
        middle = 0.5 * (low + high)
        ahead = _leg_rates(plan, middle, i)[np.arange(len(leg)), leg] * below > 0.0
        low, high = np.where(ahead, middle, low), np.where(ahead, high, middle)
    cell = np.concatenate([np.repeat(np.arange(cells), FINER + 1), i, i])
    share, aside = (np.concatenate([each.ravel(), low, high]) for each in (share, aside))
    slope = _leg_rates(plan, aside, cell)
    still = np.abs(slope) < 1e-12 * np.abs(slope).max()
    moving = _at(plan, *_places(plan, share, cell), np.where(still, 0.0, np.sign(slope)))
    rest = _at(plan, plan.profile.nodes.s[[0, -1]], np.zeros(2), np.zeros(2), np.zeros((2, 6)))
    return Fine(*(np.maximum(*each) for each in zip(moving, rest, strict=True)))


def _places(plan: TimedPath, share: np.ndarray, cell: np.ndarray) -> tuple[np.ndarray, ...]:
    """s, s'^2 and s'' at shares of cells: s'' is linear in s."""
    phase = plan.profile.phase
    h = np.diff(phase.s)[cell] * share
    slope = (phase.last - phase.first)[cell] / np.diff(phase.s)[cell]
    second = phase.first[cell] + slope * h
    square = phase.x[cell] + (phase.first[cell] + second) * h
    s = np.where(share == 1.0, phase.s[cell + 1], phase.s[cell] + h)
    if plan.profile.ease is None:
        return s, np.maximum(square, 0.0), second
    place = plan.profile.ease(s, np.sqrt(np.maximum(square, 0.0)), second)
    return place.s, place.rate**2, place.second


def _leg_rates(plan: TimedPath, share: np.ndarray, cell: np.ndarray) -> np.ndarray:
    """Derivatives of the lengths by s at shares of cells."""
    s = _places(plan, share.ravel(), cell.ravel())[0]
    return inverse_kinematics(plan.robot, plan.path(s)).L_dot.reshape(*share.shape, 6)


def _at(plan: TimedPath, s: np.ndarray, square: np.ndarray, second: np.ndarray, sign: np.ndarray) -> Fine:
    """Largest values at places whose legs move with signs, (n, 6)."""
    robot, drive = plan.robot, plan.robot.drive
    motion = traveled(plan.path(s), np.sqrt(square), second)
    F, L_dot = inverse_dynamics(robot, motion, plan.formulation).F, inverse_kinematics(robot, motion).L_dot
    within = np.broadcast_to(drive.regularization_speed, (6,))
    x = np.clip(L_dot / np.where(within > 0.0, within, 1.0), -1.0, 1.0)
    sign = np.where(within > 0.0, 0.5 * x * (3.0 - x**2), sign)
    turns = 2.0 * np.pi / drive.lead
    rotor = rotor_force(robot, motion)
    through = F - rotor
    slow = np.exp(-((L_dot / np.where(drive.stribeck_force > 0.0, drive.stribeck_speed, 1.0)) ** 2))
    loss = drive.screw_coulomb + np.abs(turns) * drive.motor_coulomb + drive.stribeck_force * slow
    of_load = np.where(through * sign > 0.0, 1.0 / drive.efficiency - 1.0, 1.0 - drive.backdrive_efficiency)
    loss = loss + np.abs(through) * of_load
    effort = F + sign * loss + (drive.screw_viscous + turns**2 * drive.motor_viscous) * L_dot
    torque, power = effort / turns, effort * L_dot
    used = [
        np.abs(F) / robot.force_limit,
        np.abs(torque) / drive.torque_limit,
        np.abs(power) / drive.power_limit,
        np.abs(L_dot) / robot.speed_limit,
        np.abs(L_dot * turns) / drive.speed_limit,
    ]
    if np.all(drive.torque_constant > 0.0):
        used.append(np.abs(torque / drive.torque_constant) / drive.current_limit)
    peaks = (np.abs(each).max(axis=0) for each in (F, torque, power))
    return Fine(*peaks, np.concatenate(used, axis=-1).max())
