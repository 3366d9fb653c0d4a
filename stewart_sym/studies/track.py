"""A trajectory run through the dynamics, as ``forces`` writes it: columns by name and limits exceeded.

Takes a Robot and a Trajectory; reads and writes no file.
"""

import warnings
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..conditioning import condition_number
from ..dynamics import (
    Backend,
    Formulation,
    first_fault,
    inverse_dynamics,
    joint_reactions,
)
from ..faults import SingularPoseWarning
from ..kinematics import LegKinematics, inverse_kinematics
from ..motion import Motion
from ..results import NOT_FINITE, OK, SHORT_LEG, Reactions
from ..robot import Robot
from ..trajectory import Trajectory

Array = NDArray[np.float64]
Columns = dict[str, NDArray[Any]]


def track(
    robot: Robot,
    trajectory: Trajectory,
    formulation: Formulation = "exact",
    backend: Backend = "c",
    reactions: bool = False,
    allow_singular: bool = False,
) -> tuple[Columns, list[str]]:
    """Run a trajectory of n instants.

    Returns columns (n,) in SI units: time, F1..F6, L1..L6, condition_number, status and, with ``reactions``,
    the components of F_s, F_u, F_p, F_c, M_p (about the base point) and M_u leg by leg; and one line for each
    kind of limit that is exceeded.  Raises ValueError, naming file and row, for a pose without an answer;
    ``allow_singular`` leaves nan and a status there and warns instead.
    """
    time, motion = trajectory.time, trajectory.motion
    forces = inverse_dynamics(robot, motion, formulation, backend, on_singular="nan")
    status, more = forces.status, None
    if reactions:
        more = joint_reactions(robot, motion, formulation, backend, on_singular="nan")
        status = np.where(status == OK, more.status, status)
    if status.any():
        _tell(trajectory, *first_fault(status, robot, motion), allow_singular)
    L, L_dot = _lengths_and_rates(robot, motion, ~np.isin(forces.status, (SHORT_LEG, NOT_FINITE)))
    columns: Columns = {"time": time}
    columns |= {f"F{i + 1}": forces.F[:, i] for i in range(6)}
    columns |= {f"L{i + 1}": L[:, i] for i in range(6)}
    columns |= {"condition_number": condition_number(forces.H), "status": status}
    if more is not None:
        columns |= _reaction_columns(more)
    return columns, exceeded(robot, time, forces.F, L, L_dot)


def exceeded(robot: Robot, time: Array, F: Array, L: Array, L_dot: Array) -> list[str]:
    """One line for each limit of the robot that is exceeded, with its first time and leg; arrays (n, 6)."""
    low, high = robot.length_limits.T
    checks = (
        ("force_limit", np.abs(F) > robot.force_limit, F, robot.force_limit, "N"),
        ("speed_limit", np.abs(L_dot) > robot.speed_limit, L_dot, robot.speed_limit, "m/s"),
        ("length_limits", high < L, L, high, "m"),
        ("length_limits", low > L, L, low, "m"),
    )
    return [
        _first(name, beyond, time, values, limit, unit)
        for name, beyond, values, limit, unit in checks
        if np.any(beyond)
    ]


def _first(name: str, beyond: NDArray[np.bool_], time: Array, values: Array, limit: Array, unit: str) -> str:
    i, leg = (int(index) for index in np.argwhere(beyond)[0])
    instants = int(np.count_nonzero(np.any(beyond, axis=-1)))
    return (
        f"{name} exceeded first at {time[i]:g} s by leg {leg + 1}: {values[i, leg]:.6g} {unit}, "
        f"limit {limit[leg]:g} {unit}; at {instants} of {len(time)} instants"
    )


def _tell(trajectory: Trajectory, where: tuple[int, ...], reason: str, allowed: bool) -> None:
    text = f"{trajectory.source}: row {trajectory.rows[where[0]]}: {reason}"
    if not allowed:
        raise ValueError(text)
    warnings.warn(text, SingularPoseWarning, stacklevel=3)


def _lengths_and_rates(robot: Robot, motion: Motion, good: NDArray[np.bool_]) -> tuple[Array, Array]:
    L, L_dot = np.full((2, *motion.shape, 6), np.nan)
    if np.any(good):
        legs: LegKinematics = inverse_kinematics(robot, motion[good])
        L[good], L_dot[good] = legs.L, legs.L_dot
    return L, L_dot


def _reaction_columns(found: Reactions) -> Mapping[str, Array]:
    columns: dict[str, Array] = {}
    for name in ("F_s", "F_u", "F_p", "F_c", "M_p"):
        values = getattr(found, name)
        for leg in range(6):
            columns |= {f"{name}{leg + 1}_{axis}": values[:, leg, j] for j, axis in enumerate("xyz")}
    return columns | {f"M_u{leg + 1}": found.M_u[:, leg] for leg in range(6)}
