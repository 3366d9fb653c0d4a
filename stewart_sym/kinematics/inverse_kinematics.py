"""Inverse kinematics of the legs, (1)-(5), (8), and H of (36) with its rate, of the platform's motion."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..backend.c_kernel import call, library, pointers
from ..backend.kernel import robot_numbers
from ..backend.native import CompilerError
from ..generated.interface import STRUCTS
from ..io.arguments import instance
from ..io.array_types import Array, Flags
from ..motion.motion import Motion
from ..motion.rotation import cross
from ..results import OK
from ..robot.offset_chains import SLIDING, columns_of_H
from ..robot.offsets import need_no_offsets
from ..robot.robot import Robot
from .offset_legs import checked_motion, rate_of_H

MIN_JOINT_SINE = 0.3
"""Sine of the angle between a leg and its universal axis from which on the leg is clear of it."""

ROUNDING = 16 * np.finfo(np.float64).eps
"""A leg no longer than this share of the terms it is the sum of is rounding error and nothing else."""


BLOCK = 512
"""Poses whose legs are computed at a time: their numbers stay in the processor's cache. From half as many on
the C computes them, where there is a compiler."""


@dataclass(frozen=True, eq=False)
class InverseKinematicsResult:
    """Kinematics of the six legs; a leading shape ``(...)`` is that of the motion.

    L: lengths, m, (..., 6), (2).
    L_dot: rates, m/s, (..., 6), positive when the leg extends, (5).
    L_ddot: accelerations, m/s^2, (..., 6), (8); None when the motion has no accelerations.
    s: unit vectors from base point to platform point, base frame, (..., 6, 3), (3).
    S: leg vectors, m, base frame, (..., 6, 3), (1).
    """

    L: Array
    L_dot: Array
    L_ddot: Array | None
    s: Array
    S: Array


def inverse_kinematics(robot: Robot, motion: Motion) -> InverseKinematicsResult:
    """Return lengths, rates and directions of the legs.

    The spin of a leg about its own axis has no part in these, so they are the same in both formulations and
    for either base joint. With offset joints L is the length along the line of sliding and s its direction;
    S goes from the base point to the platform point all the same.

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        Motion of the platform, any leading shape.

    Returns
    -------
    InverseKinematicsResult
        Lengths, rates, second rates and directions.

    Raises
    ------
    ValueError
        Naming the leg when one has length zero: no more than 16 rounding units of the largest component of
        the terms of S = q + t - b, (1); and when a result overflows.
    """
    legs = legs_or_overflow(robot, motion)
    _reject_overflow(legs.L, legs.L_dot, legs.L_ddot)
    return legs


def legs_or_overflow(robot: Robot, motion: Motion) -> InverseKinematicsResult:
    """As ``inverse_kinematics``, but with infinities and NaN where a result overflows."""
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    if robot.offsets is not None:
        moving = checked_motion(robot, motion)
        seconds = moving.accelerations
        return InverseKinematicsResult(
            L=moving.at.L[..., 0],
            L_dot=moving.rates[..., SLIDING],
            L_ddot=None if seconds is None else seconds[..., SLIDING],
            s=moving.at.s,
            S=moving.at.P,
        )
    found = _compiled_legs(robot, motion) if math.prod(motion.shape) >= BLOCK // 2 else None
    return (
        InverseKinematicsResult(**found)
        if found
        else InverseKinematicsResult(*_in_blocks(_legs, robot, motion))
    )


_SHAPES = STRUCTS["legs"]


def _compiled_legs(robot: Robot, motion: Motion) -> dict[str, Any] | None:
    """Quantities of all legs by name from the C; None without a compiler and where a pose has a fault."""
    try:
        code = library("legs")
    except CompilerError:
        return None
    wanted = {name: shape for name, shape in _SHAPES.items() if name != "L_ddot" or motion.a is not None}
    found = {name: np.empty((*motion.shape, *shape)) for name, shape in wanted.items()}
    outputs = pointers(map(found.get, _SHAPES))
    status = call(code.stewart_legs_batch, robot_numbers(robot), motion, outputs, None)
    return dict.fromkeys(_SHAPES) | found if status == OK else None


def wrench_matrix(robot: Robot, motion: Motion) -> Array:
    """Return H of (36), (..., 6, 6): column i is [s_i; q_i x s_i], the wrench of a unit force of leg i.

    Rows 0-2 have no unit, rows 3-5 are m. Leg rates are L_dot = H^T [v; omega], of upper parts that turn on a
    screw the motors' rates over N; actuator forces push with the wrench H F.

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        Motion of the platform, any leading shape.

    Returns
    -------
    ndarray
        H, (..., 6, 6).

    Raises
    ------
    ValueError
        As ``inverse_kinematics``.
    """
    if getattr(robot, "offsets", None) is not None:
        return columns_of_H(robot, checked_motion(robot, motion).G)
    L, rows = _in_blocks(_rows_of_H, robot, motion)
    _reject_overflow(L)
    return np.swapaxes(rows, -1, -2)


def wrench_matrix_rate(robot: Robot, motion: Motion) -> Array:
    """Return the time derivative of H along the motion, (..., 6, 6), 1/s and m/s.

    With it L_ddot = H^T [a; alpha] + H_dot^T [v; omega].

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        Motion of the platform, any leading shape.

    Returns
    -------
    ndarray
        Rate of H, (..., 6, 6).

    Raises
    ------
    ValueError
        As ``inverse_kinematics``.
    """
    if getattr(robot, "offsets", None) is not None:
        return rate_of_H(robot, motion)
    L, rows = _in_blocks(_rows_of_H_dot, robot, motion)
    _reject_overflow(L, rows)
    return np.swapaxes(rows, -1, -2)


def leg_vectors(robot: Robot, R: Array, t: Array) -> tuple[Array, Array, Array]:
    """Return q and S of (1), m, base frame, (..., 6, 3), and the lengths of S, m, (..., 6), zero or not."""
    need_no_offsets(robot)
    q = robot.p @ np.swapaxes(R, -1, -2)
    S = q + t[..., None, :] - robot.b
    return q, S, np.sqrt(np.einsum("...i,...i->...", S, S))


def length_rows(q: Array, S: Array, L: Array) -> Array:
    """Rates of the lengths by shift and turn of the platform, (..., 6, 6): H^T, (5).

    A leg of length zero has no direction: its row is 0 and makes the matrix singular.
    """
    s = S / np.where(L > 0.0, L, 1.0)[..., None]
    return np.concatenate([s, cross(q, s)], axis=-1)


def joint_sines(robot: Robot, s: Array) -> Array:
    """Sines of the angles between legs along s, (..., 6, 3), and their universal axes, (..., 6).

    1 with spherical base joints.
    """
    need_no_offsets(robot)
    if robot.base_joint == "spherical":
        return np.ones(s.shape[:-1])
    return np.asarray(np.linalg.norm(cross(robot.k, s), axis=-1))


def tip_velocities(motion: Motion, q: Array) -> Array:
    """Return S_dot of (4), m/s, base frame, (..., 6, 3), of platform points at q (..., 6, 3)."""
    return cross(motion.omega[..., None, :], q) + motion.v[..., None, :]


def clear_of_joint_singularities(robot: Robot, legs: InverseKinematicsResult) -> Flags:
    """Whether all six legs are clear of their universal axes k, (...,); always with spherical base joints.

    Clear: the sine of the angle between k and s is ``MIN_JOINT_SINE`` or more.
    """
    return np.asarray((joint_sines(robot, legs.s) >= MIN_JOINT_SINE).all(axis=-1))


def _in_blocks(made: Callable[[Robot, Motion, int], tuple[Any, ...]], robot: Robot, motion: Motion) -> Any:
    """Arrays made of a motion, of a long one in blocks; ``made`` takes the number of its first pose, too."""
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    with np.errstate(all="ignore"):
        if len(motion.shape) != 1 or motion.shape[0] <= BLOCK:
            return made(robot, motion, 0)
        blocks = [made(robot, motion[i : i + BLOCK], i) for i in range(0, motion.shape[0], BLOCK)]
    return [None if parts[0] is None else np.concatenate(parts) for parts in zip(*blocks, strict=True)]


def _vectors(robot: Robot, motion: Motion, start: int) -> tuple[Array, Array, Array]:
    """``leg_vectors``; ValueError names the first leg of length zero. start: number of the first pose."""
    q, S, L = leg_vectors(robot, motion.R, motion.t)
    reach = np.maximum(np.abs(q).max(axis=-1), np.abs(robot.b).max(axis=-1))
    reach = np.maximum(reach, np.abs(motion.t).max(axis=-1)[..., None])
    short = np.argwhere(ROUNDING * reach >= L)
    if short.size:
        *pose, leg = (int(i) for i in short[0])
        where = f" at motion[{', '.join(str(start + i) for i in pose)}]" if pose else ""
        raise ValueError(f"motion: leg {leg + 1} has length zero{where}")
    return q, S, L


def _rows_of_H(robot: Robot, motion: Motion, start: int) -> tuple[Array, Array]:
    q, S, L = _vectors(robot, motion, start)
    return L, length_rows(q, S, L)


def _rows_of_H_dot(robot: Robot, motion: Motion, start: int) -> tuple[Array, Array]:
    q, S, L = _vectors(robot, motion, start)
    s, q_dot = S / L[..., None], cross(motion.omega[..., None, :], q)
    S_dot = q_dot + motion.v[..., None, :]
    s_dot = (S_dot - _dot(s, S_dot)[..., None] * s) / L[..., None]
    return L, np.concatenate([s_dot, cross(q_dot, s) + cross(q, s_dot)], axis=-1)


def _legs(robot: Robot, motion: Motion, start: int) -> tuple[Array | None, ...]:
    """Fields of ``InverseKinematicsResult``."""
    q, S, L = _vectors(robot, motion, start)
    s = S / L[..., None]
    S_dot = tip_velocities(motion, q)
    L_dot, L_ddot = _dot(s, S_dot), None
    if motion.a is not None and motion.alpha is not None:
        omega, alpha = motion.omega[..., None, :], motion.alpha[..., None, :]
        S_ddot = cross(alpha, q) + cross(omega, cross(omega, q)) + motion.a[..., None, :]
        # L W.W of (8) from the part of S_dot across the leg: |W x S| = L |W|.
        across = S_dot - L_dot[..., None] * s
        L_ddot = _dot(s, S_ddot) + _dot(across, across) / L
    return L, L_dot, L_ddot, s, S


def _dot(x: Array, y: Array) -> Array:
    return np.asarray(np.einsum("...i,...i->...", x, y))


def _reject_overflow(*results: Array | None) -> None:
    if not all(values is None or np.isfinite(values).all() for values in results):
        raise ValueError("motion: the kinematics of its legs overflow")
