"""Whether a path's rates are those of its poses, and its accelerations those of its rates."""

from __future__ import annotations

import numpy as np

from ...io.arguments import instance
from ...io.array_types import Array
from ...kinematics.inverse_kinematics import inverse_kinematics
from ...motion.motion import Motion
from ...robot.robot import Robot
from .path_terms import Path

# Changes are compared over so many steps: short ones tell where rates jump, long ones what is off by little.
_STRETCHES = (16, 512)
# Rates may be off by a share of the largest one, and so many times the noise of what they are rates of.
_OFF, _NOISE = 1e-3, 8.0
# Lengths may be off by a share of the longest way of a leg, their rates jump by a share of the largest.
_OF_WAY, _OF_RATE = 1e-6, 1e-3


def need_motions(path: Path, ends: Array) -> None:
    """Reject a function that gives no motion with accelerations for each of the first and last s, (2,)."""
    found = path(ends)
    instance(found, Motion, "path")
    if found.a is None or found.alpha is None:
        raise ValueError("path: expected motions with accelerations alpha and a, got none")
    if found.shape != (2,):
        raise ValueError(f"path: expected a motion of shape (n,) at s (n,), got {found.shape} at (2,)")


def need_rates(robot: Robot, path: Path, s: Array) -> None:
    """Reject a path whose rates contradict its poses, or jump, by the lengths of legs at many s, (n,).

    Over each step a length changes by the step times a rate between those at its ends, wherever accelerations
    jump: what the trapezoidal rule may be off by is known.
    """
    legs = inverse_kinematics(robot, path(s))
    assert legs.L_ddot is not None
    most = float(np.abs(legs.L_dot).max())
    _need_changes(
        s,
        legs.L,
        legs.L_dot,
        _OF_WAY * most * float(s[-1] - s[0]),
        "expected rates by s that are those of the poses: the length of leg {} changes by {:.4g} m from s = "
        "{:.6g} to {:.6g}, {:.4g} m by its rates",
    )
    _need_changes(
        s,
        legs.L_dot,
        legs.L_ddot,
        _OF_RATE * most,
        "expected rates by s that do not jump, and accelerations that are theirs: the rate of leg {} changes "
        "by {:.4g} m from s = {:.6g} to {:.6g}, {:.4g} m by its accelerations",
    )


def _need_changes(s: Array, x: Array, rate: Array, least: float, text: str) -> None:
    """Reject numbers, (n, 6), that change otherwise than their rates say, by ``least`` or more."""
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
