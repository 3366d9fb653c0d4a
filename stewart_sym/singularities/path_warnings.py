"""Warnings about singular poses on the path of a log, also between its rows, with unbounded forces."""

import math
from collections.abc import Sequence

import numpy as np

from ..io.array_types import Array, Flags
from ..kinematics.conditioning import characteristic_length, moments_over
from ..kinematics.inverse_kinematics import leg_vectors, wrench_matrix
from ..kinematics.trajectory_checks import side_change
from ..motion.interpolation import interpolate
from ..motion.motion import Motion
from ..motion.trajectory import Trajectory
from ..robot.robot import LEGS, Robot
from ..robot.units import Units
from .path_singularities import SingularityCrossing, singularity_crossings
from .singular_poses import SingularityResult

_BLOCK_STEPS = 16


def crossing_warning(robot: Robot, log: Trajectory) -> str | None:
    """Return a warning text about the singular poses that a log's path crosses, or None."""
    if robot.offsets is not None:
        return row_warning(robot, log)
    found: list[SingularityCrossing] = []
    for part in _near_singular_parts(robot, log):
        some = Trajectory(log.time[part], log.at(part), log.source)
        found += singularity_crossings(robot, interpolate(some), some.time)
    if not found:
        return None
    first = found[0]
    after = int(np.searchsorted(log.time, first.time, side="right"))
    rows = [log.rows[min(max(i, 0), len(log.rows) - 1)] for i in (after - 1, after)]
    others = ", ".join(f"{other.time:.9f}" for other in found[1:4])
    more = f"; {len(found) - 1} more, at {others}{' ...' if len(found) > 4 else ''} s" if others else ""
    of = " of the reference point" if robot.tool.any() else ""
    return (
        f"{log.source}: the path crosses a singular pose at {first.time:.9f} s, between lines "
        f"{rows[0]} and {rows[1]}: "
        f"det H goes from {sign_text(first.sign_before)} to {sign_text(first.sign_after)}, "
        f"scaled condition number {float(first.singularity.condition_number):.3g}, "
        "leg forces grow without bound; "
        f"unconstrained twist{of} {twist_text(first.singularity, Units.of(robot))}{more}"
    )


def _near_singular_parts(robot: Robot, log: Trajectory) -> list[slice]:
    """Return the runs of rows among which all singular poses of a path are."""
    count, motion = len(log.time), log.given_motion
    if count < 2:
        return []
    if motion is not None:
        speed, turning = (np.linalg.norm(rate, axis=-1) for rate in (motion.v, motion.omega))
    else:
        assert log.coordinates is not None
        turning = np.abs(log.coordinates[1, :, 3:]).sum(axis=-1)
        speed = np.linalg.norm(log.coordinates[1, :, :3], axis=-1) + np.linalg.norm(robot.tool) * turning
    paths = [np.maximum(rate[1:], rate[:-1]) * np.diff(log.time) for rate in (speed, turning)]
    steps = np.arange(count - 1)
    # Most blocks of steps are far from singular poses, so that few single steps are examined.
    for size in (_BLOCK_STEPS, 1):
        starts = steps[::size]
        blocks = np.minimum(starts[:, None] + np.arange(size), count - 2)
        middles = log.at(np.minimum(starts + size // 2, count - 1))
        near = _may_be_singular(robot, middles, *(path[blocks].sum(axis=-1) for path in paths))
        steps = np.unique(blocks[near])
    runs = np.split(steps, np.flatnonzero(np.diff(steps) > 1) + 1) if len(steps) else []
    return [slice(int(run[0]), int(run[-1]) + 2) for run in runs]


def _may_be_singular(robot: Robot, motion: Motion, moved: Array, turned: Array) -> Flags:
    """Return True for poses (n,) with a singular pose within a path (m) and a turn (rad), (n,).

    The smallest singular value of H changes by at most the norm of the change of H.
    """
    arm, size = float(np.linalg.norm(robot.p, axis=-1).max()), characteristic_length(robot) or 1.0
    shortest = leg_vectors(robot, motion.R, motion.t)[2].min(axis=-1)
    tips = moved + arm * turned
    with np.errstate(divide="ignore"):
        direction = np.where(tips < shortest, tips / np.maximum(shortest - tips, 0.0), np.inf)
    change = np.hypot(direction, arm * (turned + direction) / size) * math.sqrt(LEGS)
    H = moments_over(wrench_matrix(robot, motion), size)
    return ~np.asarray(np.linalg.svd(H, compute_uv=False)[:, -1] > change)


def row_warning(robot: Robot, log: Trajectory, places: str = "lines") -> str | None:
    """Return a warning text from the signs of det H at the rows, or None.

    ``places`` is the noun for the row numbers.
    """
    i = side_change(robot, log.motion)
    if i is None:
        return None
    rows = f"{places} {log.rows[i]} and {log.rows[i + 1]}"
    return (
        f"{log.source}: the path crosses a singular pose between {rows}, where det H changes its sign: "
        "leg forces grow without bound"
    )


def twist_text(at: SingularityResult, units: Units) -> str:
    """Return the unconstrained twist [v; omega] as text."""
    v, omega = triple_text(at.twist[:3] / units.meters), triple_text(at.twist[3:] / units.radians)
    return f"v = {v} {units.length}/s, omega = {omega} {units.angle}/s"


def sign_text(side: int) -> str:
    """Return the sign of det H as text."""
    return "-" if side < 0 else "+"


def triple_text(values: Sequence[float] | Array) -> str:
    """Return numbers with six decimals as text, without -0."""
    return "(" + ", ".join(f"{round(float(value), 6) + 0.0:.6f}" for value in values) + ")"
