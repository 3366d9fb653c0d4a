"""Reader of trajectory files without a robot."""

import os

from stewart_sym.io.array_types import Array
from stewart_sym.io.progress import Progress, silent
from stewart_sym.motion.log_reader import AS_SHOWN, poses_of, trajectory_of
from stewart_sym.motion.log_samples import read_samples
from stewart_sym.motion.trajectory import SmoothingOptions, Trajectory
from stewart_sym.motion.trajectory_format import PLAIN, TrajectoryFormat


def read_log(
    path: str | os.PathLike[str],
    form: TrajectoryFormat = PLAIN,
    smoothing: SmoothingOptions = AS_SHOWN,
    progress: Progress = silent,
) -> Trajectory:
    """Read a file of poses or leg lengths as they are."""
    return trajectory_of(read_samples(os.fspath(path), form), smoothing, progress)


def read_poses(path: str | os.PathLike[str], form: TrajectoryFormat = PLAIN) -> tuple[Array, Array]:
    """Read a file of poses as they are: R and t (m)."""
    return poses_of(read_samples(os.fspath(path), form))
