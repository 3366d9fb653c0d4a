"""Inverse kinematics of the legs, (1)-(5), (8), and H of (36) with its rate, of the platform's motion."""

import functools
import math
from collections.abc import Sequence
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


BLOCK = 2048
"""Poses whose legs are computed at a time: their numbers stay in the processor's second cache. From so many
on the C computes them, where there is a compiler."""


@dataclass(frozen=True, eq=False)
class LegKinematics:
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


def inverse_kinematics(robot: Robot, motion: Motion) -> LegKinematics:
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
    LegKinematics
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


def legs_or_overflow(robot: Robot, motion: Motion) -> LegKinematics:
    """As ``inverse_kinematics``, but with infinities and NaN where a result overflows."""
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    if robot.offsets is not None:
        moving = checked_motion(robot, motion)
        seconds = moving.accelerations
        return LegKinematics(
            L=moving.at.L[..., 0],
            L_dot=moving.rates[..., SLIDING],
            L_ddot=None if seconds is None else seconds[..., SLIDING],
            s=moving.at.s,
            S=moving.at.P,
        )
    found = _compiled_legs(robot, motion) if math.prod(motion.shape) >= BLOCK else None
    return LegKinematics(**(found or _legs(robot, motion, tuple(_SHAPES))))


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
    legs = _legs(robot, motion, ("L", "q", "s"))
    _reject_overflow(legs["L"])
    return _columns(legs["s"], cross(legs["q"], legs["s"]))


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
    legs = _legs(robot, motion, ("L", "L_dot", "q", "s", "S_dot"))
    q, s = legs["q"], legs["s"]
    with np.errstate(all="ignore"):
        s_dot = (legs["S_dot"] - legs["L_dot"][..., None] * s) / legs["L"][..., None]
        q_dot = cross(motion.omega[..., None, :], q)
        H_dot = _columns(s_dot, cross(q_dot, s) + cross(q, s_dot))
    _reject_overflow(legs["L"], H_dot)
    return H_dot


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


def clear_of_joint_singularities(robot: Robot, legs: LegKinematics) -> Flags:
    """Whether all six legs are clear of their universal axes k, (...,); always with spherical base joints.

    Clear: the sine of the angle between k and s is ``MIN_JOINT_SINE`` or more.
    """
    return np.asarray((joint_sines(robot, legs.s) >= MIN_JOINT_SINE).all(axis=-1))


def _legs(robot: Robot, motion: Motion, wanted: Sequence[str]) -> dict[str, Any]:
    """Quantities of all legs by name: L, L_dot, L_ddot (..., 6), None without accelerations; q, S, s, S_dot
    (..., 6, 3).

    Computed for blocks of poses, component by component: ten times as fast as on arrays whose last axis has
    three numbers.
    """
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    need_no_offsets(robot)
    count = math.prod(motion.shape)
    flat = {
        name: array.reshape(count, 9 if name == "R" else 3)
        for name in ("R", "t", "omega", "v", "alpha", "a")
        if (array := getattr(motion, name)) is not None
    }
    shapes = {name: (6,) if name.startswith("L") else (6, 3) for name in wanted}
    if motion.a is None:
        shapes.pop("L_ddot", None)
    found = {name: np.empty((count, *shape)) for name, shape in shapes.items()}
    for start in range(0, count, BLOCK):
        part = slice(start, start + BLOCK)
        with np.errstate(all="ignore"):
            block = _block(robot, {name: array[part].T.copy() for name, array in flat.items()})
        _reject_short(block["L"][0], ROUNDING * block["reach"][0], motion.shape, start)
        for name, array in found.items():
            # As rows of six or eighteen numbers: copies of long rows are the fast ones.
            rows = np.stack(block[name], axis=1).reshape(array[0].size, -1)
            array.reshape(count, -1)[part] = rows.T
    arrays: dict[str, Any] = {
        name: array.reshape(*motion.shape, *shapes[name]) for name, array in found.items()
    }
    return dict.fromkeys(wanted) | arrays


def _block(robot: Robot, at: dict[str, Array]) -> dict[str, list[Array]]:
    """``_legs`` of n poses, component by component, (6, n); ``at``: components first, (3, n) or (9, n)."""
    R, t = at["R"], at["t"]
    (p_x, p_y, p_z), b = (column[:, None] for column in robot.p.T), robot.b.T[:, :, None]
    q = [R[3 * i] * p_x + R[3 * i + 1] * p_y + R[3 * i + 2] * p_z for i in range(3)]
    S = [q[i] + t[i] - b[i] for i in range(3)]
    reach = functools.reduce(np.maximum, (np.abs(x) for terms in (q, t, b) for x in terms))
    L = np.sqrt(_dot(S, S))
    s = [x / L for x in S]
    S_dot = [x + v for x, v in zip(_cross(at["omega"], q), at["v"], strict=True)]
    L_dot = _dot(s, S_dot)
    found = {"q": q, "S": S, "L": [L], "reach": [reach], "s": s, "S_dot": S_dot, "L_dot": [L_dot]}
    if "a" in at:
        turned = _cross(at["omega"], _cross(at["omega"], q))
        own = _cross(at["alpha"], q)
        S_ddot = [x + y + a for x, y, a in zip(own, turned, at["a"], strict=True)]
        # L W.W of (8) from the part of S_dot across the leg: |W x S| = L |W|.
        across = [x - L_dot * y for x, y in zip(S_dot, s, strict=True)]
        found["L_ddot"] = [_dot(s, S_ddot) + _dot(across, across) / L]
    return found


def _cross(x: Sequence[Array] | Array, y: Sequence[Array] | Array) -> list[Array]:
    return [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]


def _dot(x: Sequence[Array], y: Sequence[Array]) -> Array:
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]


def _columns(force: Array, moment: Array) -> Array:
    return np.swapaxes(np.concatenate([force, moment], axis=-1), -1, -2)


def _reject_short(L: Array, rounding: Array, shape: tuple[int, ...], start: int) -> None:
    """Name the first leg, (6, n), of length zero; ``start``: number of the first pose of ``shape``."""
    short = np.argwhere((rounding >= L).T)
    if short.size:
        pose, leg = (int(i) for i in short[0])
        where = ", ".join(str(int(i)) for i in np.unravel_index(start + pose, shape)) if shape else ""
        raise ValueError(f"motion: leg {leg + 1} has length zero{f' at motion[{where}]' if where else ''}")


def _reject_overflow(*results: Array | None) -> None:
    if not all(values is None or np.isfinite(values).all() for values in results):
        raise ValueError("motion: the kinematics of its legs overflow")
