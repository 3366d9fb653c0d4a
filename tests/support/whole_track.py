"""A trajectory run through the dynamics with all of its columns kept."""

from typing import Any, NamedTuple

import numpy as np

from stewart_sym.drives.leg_limits import replaced_rows
from stewart_sym.motion.trajectory import PoseLog, Trajectory
from stewart_sym.robot.robot import Robot
from stewart_sym.studies.reports.track import NOISE_THRESHOLD, Columns, Digest, in_parts


class Track(NamedTuple):
    """Columns (n,) by name, a line for each doubt, and a summary."""

    columns: Columns
    doubts: list[str]
    summary: str


def track(
    robot: Robot, trajectory: Trajectory | PoseLog, noise_share: float = NOISE_THRESHOLD, **options: Any
) -> Track:
    """Run a trajectory of n instants; options: of ``in_parts``."""
    digest, columns = Digest(robot, trajectory.time, replaced_rows(trajectory)), []
    for part in in_parts(robot, trajectory, **options):
        digest.add(part)
        columns.append(part.columns)
    joined = {name: np.concatenate([each[name] for each in columns]) for name in columns[0]}
    return Track(joined, digest.doubts(noise_share), digest.summary())
