"""Writer of trajectory files in the standard format: SI units, one row per sample."""

import csv
import io
import os
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from ..io.arguments import instance
from ..io.array_types import Array
from ..io.output import write_file
from ..motion.motion import Motion
from ..motion.rotation import (
    angle_rates,
    angles_from_rotation,
    distance_from_lock,
    quaternion_from_rotation,
)
from ..motion.trajectory import Trajectory
from ..robot.robot import Robot

Columns = dict[str, Array]
"""Columns of shape (n,) by name."""

BEGINNINGS = ("time,t_x,", "time,L_1,")
"""Beginnings of the files."""

_PLAIN = 0.05
"""Smallest distance from gimbal lock at which angles are written (rad)."""
_ROWS = 4096


def write_trajectory(
    trajectory: Trajectory, path: str | os.PathLike[str], robot: Robot | None = None
) -> None:
    """Write a trajectory as a CSV file in the standard format, which every subcommand reads.

    Parameters
    ----------
    trajectory : Trajectory
        Poses or leg lengths over time.
    path : path-like
        CSV file, which is replaced if it exists.
    robot : Robot, optional
        Robot whose tool and rotation order define the poses. By default, poses of the reference point with
        R = Rz Ry Rx.

    Raises
    ------
    OSError
        If the file cannot be written.
    ValueError
        If an argument has another type.

    See Also
    --------
    read_trajectory : Read a trajectory file.

    Notes
    -----
    The columns are ``time`` (s); ``t_x`` to ``t_z`` (m), ``theta_x`` to ``theta_z`` (rad), and their first
    and second derivatives, or ``L_1`` to ``L_6`` (m) and theirs; and loads ``F_ext_*`` (N) and ``M_ext_*``
    (N m), if any. Near gimbal lock, quaternions without rates are written.

    Examples
    --------
    >>> import pathlib
    >>> import tempfile
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> path, step = ss.PAPER_PATHS["I"]
    >>> time = path.time_grid(10 * step)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = pathlib.Path(folder) / "path.csv"
    ...     ss.write_trajectory(ss.Trajectory(time, path.sample(time)), file)
    ...     again = ss.read_trajectory(robot, file)
    >>> bool(abs(again.motion.a - path.sample(time).a).max() < 1e-12)
    True
    """
    instance(trajectory, Trajectory, "trajectory")
    write_file(Path(os.fsdecode(path)), csv_lines_of(trajectory, robot))


def csv_lines_of(trajectory: Trajectory, robot: Robot | None = None) -> Iterator[str]:
    """Yield the text of a trajectory file in blocks of lines, header first, with all digits."""
    if trajectory.in_joints:
        columns: Columns = {"time": trajectory.time}
        for name, values in zip(("L", "L_dot", "L_ddot"), trajectory.lengths, strict=True):
            columns |= {f"{name}_{leg}": column for leg, column in enumerate(values.T, 1)}
        for name in ("F_ext", "M_ext"):
            columns |= _of_axes(name, getattr(trajectory, name))
    else:
        columns = trajectory_columns(robot, trajectory.time, trajectory.motion)
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(columns)
    for start in range(0, len(trajectory.time), _ROWS):
        rows = [column[start : start + _ROWS].tolist() for column in columns.values()]
        writer.writerows(zip(*rows, strict=True))
        yield stream.getvalue()
        stream.seek(0)
        stream.truncate()


def trajectory_columns(robot: Robot | None, time: Array, motion: Motion) -> Columns:
    """Return poses of the tool of the robot, rates if the motion has accelerations, and the load at the tool.

    Angles are in the rotation order of the robot. Near gimbal lock, quaternions without rates are returned.
    """
    order = "zyx" if robot is None else robot.trajectory_format.rotation_order
    at_tool = motion if robot is None or not robot.tool.any() else motion.at_point(robot.tool)
    theta = np.unwrap(angles_from_rotation(at_tool.R, order), axis=0)
    columns: Columns = {"time": time, **_of_axes("t", at_tool.t)}
    if distance_from_lock(theta, order).min() < _PLAIN:
        q = quaternion_from_rotation(at_tool.R)
        columns |= {f"q_{name}": column for name, column in zip("wxyz", q.T, strict=True)}
    else:
        columns |= _of_axes("theta", theta) | _rates(at_tool, theta, order)
    return columns | _of_axes("F_ext", at_tool.F_ext) | _of_axes("M_ext", at_tool.M_ext)


def _rates(motion: Motion, theta: Array, order: str) -> Columns:
    """Return the columns of all first and second derivatives; none for a motion without accelerations."""
    if motion.alpha is None or motion.a is None:
        return {}
    theta_dot, theta_ddot = angle_rates(theta, motion.omega, motion.alpha, order)
    rates = {"v": motion.v, "theta_dot": theta_dot, "a": motion.a, "theta_ddot": theta_ddot}
    return {name: column for key, values in rates.items() for name, column in _of_axes(key, values).items()}


def _of_axes(name: str, values: Array | None) -> Columns:
    """Return the columns ``name_x`` to ``name_z`` of an array of shape (n, 3); none for None."""
    if values is None:
        return {}
    return {f"{name}_{axis}": column for axis, column in zip("xyz", values.T, strict=True)}
