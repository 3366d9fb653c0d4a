"""Extreme motions for the self-test of the forces, in which only a few terms act.

The platform is at rest, in free fall, or it moves or accelerates along one axis. In free fall the platform
loads no leg, so that changes of leg constants exceed the rounding errors.
"""

import itertools
import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from ..dynamics.sample_poses import GOOD_CONDITION, MAX_CONDITION, WHOLE, significant, size_of, whole_turn
from ..io.array_types import Array
from ..kinematics.conditioning import characteristic_length, scaled_condition_number
from ..kinematics.inverse_kinematics import clear_of_joint_singularities, inverse_kinematics, wrench_matrix
from ..motion.motion import Motion, at_rest
from ..robot.robot import Robot
from .interpreter import NEAR_JOINT_SINGULAR

_NEAR = 3
"""Number of motions with a leg near the singularity of its universal joint."""

_TRIES = 200
_TURNS = ((9, 1, 2, -1), (11, -2, 1, 1), (7, 0, -2, 1), (12, 3, 1, -2), (8, -1, -1, -2), (10, 2, -1, 3))


def extreme_motions(robot: Robot, first: Motion, near: bool) -> list[Motion]:
    """Return about 22 motions around ``first``, and _NEAR more near joint singularities if ``near`` is True.

    Random numbers have a fixed seed and few digits, so that equal robots have equal motions everywhere.
    """
    draw = np.random.RandomState(1998)
    kinds = list(_kinds(robot))
    places = itertools.cycle(_regular(robot, first, draw, len(kinds)))
    found = [_moving(*next(places), kind) for kind in kinds]
    if near:
        beside = itertools.islice(_near_singular(robot, first, draw), _NEAR)
        found += [_moving(*place, kind) for place, kind in zip(beside, kinds[1::7], strict=False)]
    return found


def _kinds(robot: Robot) -> Iterator[dict[str, Any]]:
    """Yield rates and accelerations (SI, three digits)."""
    size, g = size_of(robot), robot.g
    pace = float(significant(math.sqrt(float(np.linalg.norm(g)) / size), 2)) or 1.0
    yield {}
    yield {"a": g}
    for axis in range(6):
        yield _along(("alpha", "a"), 1e3 * pace**2, size, axis)
        yield _along(("omega", "v"), 1e2 * pace, size, axis, (axis + 1) % 6) | {"a": g}
        yield _along(("omega", "v"), 0.6 * pace, size, axis) | {"a": g}
        yield _along(("omega", "v"), 1.5 * pace, size, axis, (axis + 2) % 6) | {"a": g}


def _along(names: tuple[str, str], amount: float, size: float, *axes: int) -> dict[str, Any]:
    """Return rates about the first three axes, and rates times the machine size along the others."""
    turn, shift = (np.isin(np.arange(first, first + 3), axes) for first in (0, 3))
    return {names[0]: significant(amount * turn, 3), names[1]: significant(amount * size * shift, 3)}


def _moving(R: Array, t: Array, kind: dict[str, Any]) -> Motion:
    rates = {name: kind.get(name, np.zeros(3)) for name in ("omega", "v", "alpha", "a", "F_ext", "M_ext")}
    return Motion._unchecked(R=R, t=t, **rates)


def _turned(first: Motion, turn: tuple[int, int, int, int]) -> Array:
    """Return a rotation of ``first`` by an integer quaternion."""
    matrix, over = whole_turn(*turn)
    return (matrix @ np.rint(first.R * WHOLE)) / (over * WHOLE)


def _regular(robot: Robot, first: Motion, draw: Any, count: int) -> list[tuple[Array, Array]]:
    """Return well-conditioned poses around ``first``, clear of joint singularities; ``first`` if none is."""
    size, center = size_of(robot), robot.p.mean(axis=0)
    tried = []
    for i in range(_TRIES):
        R = _turned(first, _TURNS[i % len(_TURNS)])
        shift = size * draw.randint(-16, 17, 3) / 40.0
        tried.append((R, significant(first.t + (first.R - R) @ center + shift, 6)))
    motion = at_rest(np.array([R for R, _ in tried]), np.array([t for _, t in tried]))
    condition = _condition(robot, motion)
    good = clear_of_joint_singularities(robot, inverse_kinematics(robot, motion))
    good &= condition <= GOOD_CONDITION
    return [tried[i] for i in np.flatnonzero(good)[:count]] or [(first.R, first.t)]


def _near_singular(robot: Robot, first: Motion, draw: Any) -> Iterator[tuple[Array, Array]]:
    """Yield solvable poses with a leg near the fixed axis of its universal joint."""
    size = size_of(robot)
    for i in range(_TRIES):
        R = _turned(first, _TURNS[i % len(_TURNS)])
        leg, end = int(draw.randint(6)), 2.0 * draw.randint(2) - 1.0
        k = end * robot.k[leg] / np.linalg.norm(robot.k[leg])
        across = np.cross(k, draw.randint(-50, 51, 3) + np.array([0.1, 0.2, 0.3]))
        s = k + 0.4 * NEAR_JOINT_SINGULAR * across / np.linalg.norm(across)
        t = significant(robot.b[leg] + size * draw.randint(6, 30) / 10.0 * s - R @ robot.p[leg], 12)
        motion = at_rest(R, t)
        if _condition(robot, motion) <= MAX_CONDITION:
            yield R, t


def _condition(robot: Robot, motion: Motion) -> Array:
    with np.errstate(all="ignore"):
        H = wrench_matrix(robot, motion)
    return np.asarray(scaled_condition_number(H, characteristic_length(robot)))
