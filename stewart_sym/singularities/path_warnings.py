"""Warnings about singular poses on the path of a log, also between its rows, with unbounded forces."""

import math
from collections.abc import Sequence

import numpy as np

from ..io.array_types import Array
from ..kinematics.conditioning import characteristic_length, moments_over
from ..kinematics.inverse_kinematics import leg_vectors, wrench_matrix
from ..kinematics.trajectory_checks import side_change
from ..motion.interpolation import interpolate
from ..motion.rotation import vector_from_rotation
from ..motion.trajectory import Trajectory
from ..robot.robot import LEGS, Robot
from ..robot.units import Units
from .path_singularities import singularity_crossings
from .singular_poses import SingularityResult

_BLOCK_ROWS = 16


def crossing_warning(robot: Robot, log: Trajectory) -> str | None:
    """Return a warning text about the singular poses that a log's path crosses, or None."""
    if robot.offsets is not None:
        return row_warning(robot, log)
    part = _near_singular_part(robot, log) if len(log.time) > 1 else slice(0)
    some = Trajectory(log.time[part], log.at(part), log.source)
    found = singularity_crossings(robot, interpolate(some), some.time) if len(some.time) else ()
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


def _near_singular_part(robot: Robot, log: Trajectory) -> slice:
    """Return the rows among which all singular poses of a path are.

    The smallest singular value of H changes by at most the norm of the change of H, which the path length
    from the middle of a block of rows bounds.
    """
    count, time, motion = len(log.time), log.time, log.given_motion
    if motion is not None:
        speed, turning = (np.linalg.norm(rate, axis=-1) for rate in (motion.v, motion.omega))
        shift = np.linalg.norm(np.diff(motion.t, axis=0), axis=-1)
        turn = np.linalg.norm(vector_from_rotation(motion.R[1:] @ motion.R[:-1].swapaxes(-1, -2)), axis=-1)
    else:
        assert log.coordinates is not None
        tool, (places, rates, _) = np.linalg.norm(robot.tool), log.coordinates
        turning, turn = np.abs(rates[:, 3:]).sum(axis=-1), np.abs(np.diff(places[:, 3:], axis=0)).sum(axis=-1)
        speed = np.linalg.norm(rates[:, :3], axis=-1) + tool * turning
        shift = np.linalg.norm(np.diff(places[:, :3], axis=0), axis=-1) + tool * turn
    starts = np.arange(0, count - 1, _BLOCK_ROWS)
    # The steps count as well, because rows may be at rest.
    paths = (
        np.maximum(rate[1:], rate[:-1]) * np.diff(time) + step
        for rate, step in ((speed, shift), (turning, turn))
    )
    moved, turned = (np.add.reduceat(path, starts) for path in paths)
    middles = log.at(np.minimum(starts + _BLOCK_ROWS // 2, count - 1))
    arm, size = float(np.linalg.norm(robot.p, axis=-1).max()), characteristic_length(robot) or 1.0
    shortest = leg_vectors(robot, middles.R, middles.t)[2].min(axis=-1)
    tips = moved + arm * turned
    with np.errstate(divide="ignore"):
        direction = np.where(tips < shortest, tips / np.maximum(shortest - tips, 0.0), np.inf)
    change = np.hypot(direction, arm * (turned + direction) / size) * math.sqrt(LEGS)
    H = moments_over(wrench_matrix(robot, middles), size)
    near = np.flatnonzero(~(np.linalg.svd(H, compute_uv=False)[:, -1] > change))
    return slice(starts[near[0]], starts[near[-1]] + _BLOCK_ROWS + 1) if near.size else slice(0)


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
