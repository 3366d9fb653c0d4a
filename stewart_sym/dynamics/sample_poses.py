"""Poses of a robot for examples, tests, and estimates: one near the home pose, and others around it.

The NumPy kernel selects them from a fixed sequence of candidates with few digits, so that a robot has the
same poses on every computer.
"""

import itertools
import math
from functools import lru_cache
from typing import cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..backend.kernel import MOTION
from ..io.array_types import Array, Flags
from ..kinematics.conditioning import characteristic_length, scaled_condition_number
from ..kinematics.inverse_kinematics import clear_of_joint_singularities, inverse_kinematics
from ..kinematics.mounting_side import platform_side, radius
from ..motion.motion import Motion
from ..results import InverseDynamicsResult
from ..robot.robot import Robot
from .home_pose import home_pose
from .inverse_dynamics import Formulation, inverse_dynamics

GOOD_CONDITION = 50.0
MAX_CONDITION = 1000.0
_DIRECTIONS = np.array([(0, 0, 1), (0, 0, -1), (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0)])
# The rotation of the quaternion (20, 1, -2, 1) / sqrt(406), about 14 degrees, is _SLIGHT_TURN / WHOLE.
_SLIGHT_TURN, WHOLE = np.array([[396, -44, -78], [36, 402, -44], [82, 36, 396]]), 406

# Motion and load of the example, for a machine with a radius of 1 m and a mass of 1 kg.
_OMEGA, _V = np.array([0.3, -0.2, 0.4]), np.array([0.2, 0.3, -0.1])
_ALPHA, _A = np.array([-0.5, 0.4, 0.7]), np.array([0.6, -0.4, 0.5])
_F_EXT, _M_EXT = np.array([1.0, -2.0, 3.0]), np.array([0.5, 0.3, -0.2])

# Changes of the example's pose: rotations as integer quaternions, and shifts relative to the size.
_TURNS = (
    (12, 1, 2, -1),
    (15, -2, 1, 1),
    (9, 0, -1, 1),
    (20, 2, 2, 3),
    (18, -1, -2, -3),
    (11, 1, 0, 1),
    (30, -2, 3, -4),
    (1, 0, 0, 0),
)
_SHIFTS = ((0.1, -0.05, 0.1), (-0.1, 0.08, 0.05), (0.04, 0.12, -0.1), (-0.06, -0.1, -0.04), (0, 0, 0.15))
# Factors of the velocities, accelerations, and loads of these poses relative to the example, in turn.
_PACES = (0.0, 2.0, -1.0, 0.5, 3.0, -2.0, 1.5)
_LOADS = (0.0, -1.0, 2.0, 0.5, -3.0)


@lru_cache(maxsize=16)
def sample(robot: Robot, formulation: str) -> Motion:
    """Return the motion of the example.

    The pose is the home pose, rounded; the platform moves and carries a load of about its weight. If the home
    pose is ill-conditioned or near the universal axis of a leg, another pose is selected: slightly rotated
    from parallel frames, with another axis, distance, or quarter turns. It is the first in a fixed order that
    has a solution, a good condition number, and, if possible, leg lengths within the limits. Raises
    ValueError if there is none.
    """
    if characteristic_length(robot) > 0.0:
        home, condition, clear, within = _checked(robot, _at_home(robot), formulation)
        if home.shape != (0,) and clear[0] and within[0] and condition[0] <= MAX_CONDITION:
            return home[0]
    # NumPy rounds like the C code and needs no compiler.
    poses, condition, clear, within = _checked(robot, _candidates(robot), formulation)
    for also in (within, np.full_like(within, True)):
        for bound in (GOOD_CONDITION, MAX_CONDITION):
            good = np.flatnonzero(clear & also & (condition <= bound))
            if good.size:
                return poses[int(good[0])]
    raise ValueError(
        f"robot {robot.name!r}: no good pose for the example: at all examined poses, H is singular or "
        f"its condition number exceeds {MAX_CONDITION:g}, or a leg is near its universal axis"
    )


def poses(robot: Robot, formulation: str, count: int) -> Motion:
    """Return motions (n,), n <= count: the example, then others around it with other velocities and loads.

    The others have condition numbers up to MAX_CONDITION and legs clear of their universal axes. Poses within
    the length limits precede the others, then poses with good condition numbers. Some are at rest, and others
    move backward or without a load. A robot may have fewer than ``count``. Raises ValueError as ``sample``.
    """
    first = sample(robot, formulation)
    around, condition, clear, within = _checked(robot, _neighbors(robot, first), formulation)
    fit = clear & (condition <= MAX_CONDITION)
    # The sort is stable, so it keeps the order within a rank.
    rank = 2 * ~within + (condition > GOOD_CONDITION)
    order = np.argsort(rank, kind="stable")
    chosen = order[fit[order]][: count - 1]
    return Motion(
        **{
            field: np.stack([getattr(first, field), *(getattr(around, field)[i] for i in chosen)])
            for field in MOTION
        }
    )


def neighbor(robot: Robot, R: Array, t: Array, closeness: int) -> tuple[Array, Array]:
    """Return a pose near R (3, 3), t (3,), rotated by a third of a radian over ``closeness`` and shifted."""
    turn, over = whole_turn(10 * closeness, 1, -1, 1)
    # The sum is explicit, because matrix products round differently on different computers.
    turned = (turn[:, :, None] * R[None]).sum(axis=1) / over
    return turned, t + size_of(robot) * np.array([0.05, -0.05, 0.05]) / closeness


def significant(values: ArrayLike, digits: int) -> Array:
    """Round values (...) to a number of significant decimal digits."""
    given = np.asarray(values, dtype=np.float64)
    return np.array([float(f"{value:.{digits - 1}e}") for value in given.flat]).reshape(given.shape)


def rounded(numbers: ArrayLike, kind: type) -> Array:
    """Round numbers to a precision and return them as doubles; infinity if they overflow."""
    with np.errstate(over="ignore"):
        return np.asarray(numbers, dtype=kind).astype(np.float64)


def _checked(robot: Robot, motions: Motion, formulation: str) -> tuple[Motion, Array, Flags, Flags]:
    """Return the poses with a solution, condition numbers, and masks: clear of joint axes, within limits."""
    status = _forces(robot, motions, formulation).status
    solved = motions[np.flatnonzero(status == 0)]
    if solved.shape == (0,):
        return solved, np.empty(0), np.empty(0, dtype=np.bool_), np.empty(0, dtype=np.bool_)
    condition = scaled_condition_number(_forces(robot, solved, formulation).H, characteristic_length(robot))
    legs = inverse_kinematics(robot, solved)
    within = np.clip(legs.L, *robot.length_limits.T) == legs.L
    return solved, condition, clear_of_joint_singularities(robot, legs), within.all(axis=-1)


def _forces(robot: Robot, motion: Motion, formulation: str) -> InverseDynamicsResult:
    return inverse_dynamics(robot, motion, cast(Formulation, formulation), "numpy", "nan")


def _at_home(robot: Robot) -> Motion:
    """Return the motion at the home pose, (1,), in numbers of few digits."""
    off = home_pose(robot).t + robot.p.mean(axis=0) - robot.b.mean(axis=0)
    return _motion(robot, np.eye(3)[None], off[None], np.ones(1), np.ones(1))


def _candidates(robot: Robot) -> Motion:
    """Return motions around the base, (n,), in numbers of few digits, the most likely poses first."""
    size = size_of(robot)
    distances = [1.1 * size * 1.15**n for n in sorted(range(-8, 11), key=abs)]
    # The side of the platform is first, the opposite side last.
    directions = _DIRECTIONS[
        np.argsort(-np.round(_DIRECTIONS @ platform_side(robot).direction, 6), kind="stable")
    ]
    places = list(itertools.product(_quarter_turns(), directions, distances))
    R = np.array([_SLIGHT_TURN / WHOLE @ turn for turn, _, _ in places])
    off = np.array([distance * direction for _, direction, distance in places])
    return _motion(robot, R, off, np.ones(1), np.ones(1))


def _neighbors(robot: Robot, first: Motion) -> Motion:
    """Return motions around the example, (n,), in numbers of few digits; some are at rest."""
    # Integers are exact, so that R does not depend on the computer.
    turned = np.rint(first.R * WHOLE)
    center = first.t + first.R @ robot.p.mean(axis=0) - robot.b.mean(axis=0)
    turns = itertools.starmap(whole_turn, _TURNS * len(_SHIFTS))
    R = np.array([(turn @ turned) / (over * WHOLE) for turn, over in turns])
    off = center + size_of(robot) * np.resize(_SHIFTS, (len(R), 3))
    return _motion(robot, R, off, np.resize(_PACES, len(R)), np.resize(_LOADS, len(R)))


def _motion(robot: Robot, R: Array, off: Array, pace: Array, load: Array) -> Motion:
    """Return motions with rotations R (n, 3, 3) and the center of the platform points at ``off`` (n, 3).

    ``off`` is relative to the center of the base points (m). ``pace`` multiplies the velocities and
    accelerations of the example and ``load`` its load, with shape (n,) or (1,).
    """
    size = size_of(robot)
    t = robot.b.mean(axis=0) + off - R @ robot.p.mean(axis=0)

    def times(factors: Array, vector: Array) -> Array:
        # Adding zero changes -0.0 to 0.0.
        return significant(factors[:, None] * vector, 3) + 0.0

    return Motion(
        R=R,
        t=np.round(t, 3 - math.floor(math.log10(size))) + 0.0,
        omega=times(pace, _OMEGA),
        v=times(pace, size * _V),
        alpha=times(pace, _ALPHA),
        a=times(pace, size * _A),
        F_ext=times(load, robot.M * _F_EXT),
        M_ext=times(load, robot.M * size * _M_EXT),
    )


def whole_turn(w: int, x: int, y: int, z: int) -> tuple[NDArray[np.int64], int]:
    """Return the rotation of an integer quaternion as an integer matrix and its divisor."""
    over = w * w + x * x + y * y + z * z
    turn = [
        [over - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), over - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), over - 2 * (x * x + y * y)],
    ]
    return np.array(turn), over


def _quarter_turns() -> list[Array]:
    """Return the 24 rotations that permute the axes, the identity first."""
    every = [
        np.eye(3)[list(order)] * np.array(signs)[:, None]
        for order in itertools.permutations(range(3))
        for signs in itertools.product((1.0, -1.0), repeat=3)
    ]
    return [turn for turn in every if np.linalg.det(turn) > 0.0]


def size_of(robot: Robot) -> float:
    """Return the radius of the machine (m) to two digits; ValueError for points whose squares overflow."""
    size = max(radius(robot.b), radius(robot.p))
    if not math.isfinite(size):
        raise ValueError("robot: expected base and platform points whose squares are finite")
    return float(significant(size, 2)) or 1.0
