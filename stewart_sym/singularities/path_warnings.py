"""Warnings about singular poses on the path of a log, also between its rows, with unbounded forces."""

from collections.abc import Sequence

import numpy as np

from ..io.array_types import Array
from ..kinematics.trajectory_checks import side_change
from ..motion.interpolation import interpolate
from ..motion.trajectory import Trajectory
from ..robot.robot import Robot
from ..robot.units import Units
from .path_singularities import SingularityCrossing, near_singular, singularity_crossings, step_bounds
from .singular_poses import SingularityResult


def crossing_warning(robot: Robot, log: Trajectory) -> str | None:
    """Return a warning text about the singular poses that a log's path crosses, or None."""
    if robot.offsets is not None:
        return row_warning(robot, log)
    found: list[SingularityCrossing] = []
    for run in _near_singular_runs(robot, log) if len(log.time) > 1 else []:
        some = Trajectory(log.time[run], log.at(run), log.source)
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


def _near_singular_runs(robot: Robot, log: Trajectory) -> list[slice]:
    """Return the runs of rows among which all singular poses of a path are."""
    if log.given_motion is not None:
        steps = step_bounds(log.given_motion, log.time)
    else:
        assert log.coordinates is not None
        places, rates, _ = log.coordinates
        speeds, chords = (
            np.stack([np.linalg.norm(each[:, :3], axis=-1), np.abs(each[:, 3:]).sum(axis=-1)])
            for each in (rates, np.diff(places, axis=0))
        )
        steps = np.maximum(speeds[:, 1:], speeds[:, :-1]) * np.diff(log.time) + chords
        steps[0] += np.linalg.norm(robot.tool) * steps[1]
    return near_singular(robot, steps, log.at)


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
