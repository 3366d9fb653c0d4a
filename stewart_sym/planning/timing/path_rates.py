"""Consistency checks of the poses, velocities, and accelerations of a path."""

from __future__ import annotations

import numpy as np

from ...io.arguments import instance
from ...io.array_types import Array
from ...kinematics.inverse_kinematics import inverse_kinematics
from ...motion.motion import Motion
from ...robot.robot import Robot
from .path_terms import Path

# Numbers of steps of the comparisons: short ones detect discontinuities, long ones small errors.
_STRETCHES = (16, 512)
# Tolerance of a rate relative to the largest one, and as a multiple of the noise of its integral.
_OFF, _NOISE = 1e-3, 8.0
# Tolerance of a length relative to the longest way of a leg, and of a jump relative to the largest rate.
_OF_WAY, _OF_RATE = 1e-6, 1e-3


def need_motions(path: Path, ends: Array) -> None:
    """Raise ValueError unless a path returns motions with accelerations at two s, shape (2,)."""
    found = path(ends)
    instance(found, Motion, "path")
    if found.a is None or found.alpha is None:
        raise ValueError("path: expected motions with accelerations alpha and a, got none")
    if found.shape != (2,):
        raise ValueError(f"path: expected a motion of shape (n,) at s (n,), got {found.shape} at (2,)")


def need_rates(robot: Robot, path: Path, s: Array) -> None:
    """Raise ValueError if the leg rates of a path contradict the leg lengths, or jump, at s, shape (n,).

    Over each step a length changes by the step times a rate between its values at both ends, even if the
    accelerations jump. The error of the trapezoidal rule is therefore bounded.
    """
    legs = inverse_kinematics(robot, path(s))
    assert legs.L_ddot is not None
    most = float(np.abs(legs.L_dot).max())
    _need_changes(
        s,
        legs.L,
        legs.L_dot,
        _OF_WAY * most * float(s[-1] - s[0]),
        "expected velocities equal to the derivatives of the poses by s: the length of leg {} changes by "
        "{:.4g} m from s = {:.6g} to {:.6g}, but by {:.4g} m according to the velocities",
    )
    _need_changes(
        s,
        legs.L_dot,
        legs.L_ddot,
        _OF_RATE * most,
        "expected continuous velocities, and accelerations equal to their derivatives by s: the rate of leg "
        "{} changes by {:.4g} m from s = {:.6g} to {:.6g}, but by {:.4g} m according to the accelerations",
    )


def _need_changes(s: Array, x: Array, rate: Array, least: float, text: str) -> None:
    """Raise ValueError if values, shape (n, 6), differ from the integrals of their rates."""
    step = np.diff(s)[:, None]
    said = np.cumsum(0.5 * step * (rate[1:] + rate[:-1]), axis=0)
    room = np.cumsum(step * (0.5 * np.abs(np.diff(rate, axis=0)) + _OFF * np.abs(rate).max()), axis=0)
    off = x[1:] - said
    noise = np.median(np.abs(np.diff(off, n=2, axis=0)), axis=0)
    for k in _STRETCHES:
        beyond = np.abs(off[k:] - off[:-k]) - (room[k:] - room[:-k]) - _NOISE * noise - least
        if beyond.max(initial=0.0) > 0.0:
            i, leg = np.unravel_index(int(np.argmax(beyond)), beyond.shape)
            changed, by_rate = (float(each[i + k, leg] - each[i, leg]) for each in (x[1:], said))
            raise ValueError("path: " + text.format(leg + 1, changed, s[i + 1], s[i + k + 1], by_rate))
