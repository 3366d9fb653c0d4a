"""Budgets: permitted error and time for the motions of a machine, read from a TOML file."""

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from ...dynamics.inverse_dynamics import first_fault
from ...io import toml_reader
from ...io.arguments import shown, whole_number
from ...io.error_policy import warn
from ...kinematics.mounting_side import path_for
from ...motion.motion import Motion
from ...motion.straight_line import PAPER_PATHS
from ...motion.trajectory import Trajectory
from ...reference.newton_euler import inverse_dynamics
from ...results import SingularPoseWarning
from ...robot.robot import Robot
from ...singularities.joint_space import read_trajectory
from ...singularities.path_warnings import crossing_warning

SCHEMA = 1
MARGIN = 3.0
"""Default of ``margin``, because errors between the poses may exceed the errors at the poses."""

_KEYS = ("schema", "robot", "motions", "tolerance", "margin", "rate")


@dataclass(frozen=True, eq=False)
class Budget:
    """Requirements of a kernel for motions of shape (n,) with a solution at every pose.

    ``tolerance`` is the permitted error of the forces as a fraction of the peak force of a motion. A kernel
    is acceptable if its error times ``margin`` is within the tolerance. ``rate`` is the required rate of
    single poses on one core (Hz), None for no requirement. ``files`` are the files that were read.
    """

    robot: Robot
    motions: Mapping[str, Motion]
    tolerance: float
    margin: float = MARGIN
    rate: float | None = None
    files: tuple[Path, ...] = ()


def read_budget(path: str | os.PathLike[str]) -> Budget:
    """Read a scene file of ``choose-fidelity`` (TOML, schema 1) with file names relative to its folder."""
    source = os.fspath(path)
    file = f"{source}: "
    with toml_reader.toml_tables(source, "scene of choose-fidelity") as d:
        top = toml_reader.checked_table(d, file, _KEYS, _KEYS[:4])
        whole_number(top["schema"], f"{file}schema", SCHEMA, str(SCHEMA), SCHEMA)
        motions, expected = top["motions"], f"one or more of {', '.join(PAPER_PATHS)} or CSV files"
        if not isinstance(motions, list) or not motions:
            raise ValueError(f"{file}motions: expected a list of {expected}, got {shown(motions)}")
        names = [toml_reader.one_line(name, f"{file}motions") for name in motions]
        tolerance = toml_reader.positive(top["tolerance"], f"{file}tolerance")
        margin = toml_reader.number(top.get("margin", MARGIN), f"{file}margin")
        if margin < 1.0:
            raise ValueError(f"{file}margin: expected a number >= 1, got {margin:g}")
        rate = toml_reader.positive(top["rate"], f"{file}rate") if "rate" in top else None
        robot_file = toml_reader.file_beside(top["robot"], source, "robot")
        own = [name for name in names if name not in PAPER_PATHS]
        logs = {name: toml_reader.file_beside(name, source, "motions") for name in own}
        robot = Robot.from_toml(robot_file)
        read = {name: _motion(robot, name, logs.get(name), f"{file}motions: ") for name in names}
        return Budget(robot, read, tolerance, margin, rate, (Path(source), robot_file, *logs.values()))


def papers_motions() -> dict[str, Motion]:
    """Return Paths I, II, and III of the paper with its time steps, by name."""
    return {name: path.sample(path.time_grid(dtau)) for name, (path, dtau) in PAPER_PATHS.items()}


def _motion(robot: Robot, name: str, log: Path | None, prefix: str) -> Motion:
    if log is None:
        path, dtau = path_for(robot, name)
        times = path.time_grid(dtau)
        found = Trajectory(times, path.sample(times), f"{prefix}path {name}", range(len(times)))
    else:
        found = read_trajectory(robot, log)
    status = inverse_dynamics(robot, found.motion).status
    if status.any():
        first, reason = first_fault(status, robot, found.motion)
        where = f"{'sample' if log is None else 'line'} {found.rows[first[0]]}"
        raise ValueError(f"{found.source}: {where}: {reason}")
    crossed = crossing_warning(robot, found)
    if crossed is not None:
        warn(f"{crossed}; the peak force and all relative errors depend on the samples", SingularPoseWarning)
    return found.motion
