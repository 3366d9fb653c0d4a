"""Plan files: robot, via poses, and limits in TOML; the via poses may be in a separate CSV file."""

import contextlib
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..backend.kernel import FORMULATIONS
from ..design.pose_limits import PoseLimits, need_clearance
from ..dynamics.inverse_dynamics import Formulation
from ..io import toml_reader
from ..io.arguments import option, whole_number
from ..io.array_types import Array
from ..io.error_policy import errors_of, warn
from ..kinematics.robot_logs import read_poses_of
from ..kinematics.trajectory_checks import turn_doubt
from ..motion.rotation import rotation_about_axes
from ..motion.trajectory_format import TrajectoryWarning
from ..robot.robot import Robot
from .path_parameterization import MINIMIZE, Minimize
from .plan_path import OBJECTIVES, PRICE, Objective, need_poses
from .pose_path import COORDINATES, ViaPose
from .timing.path_terms import PathLimits, leg_limits

SCHEMA = 1
RATE = 100.0
"""Default sampling rate of the trajectory (Hz)."""

_TOP_KEYS = (
    *("schema", "robot", "formulation", "objective", "smoothness_weight", "rate", "minimize", "duration"),
    *("limits", "load", "via", "via_file"),
)
_POSE_LIMITS = ("max_condition", "min_clearance")
_LEG_LIMITS = ("force", "speed", "acceleration", "jerk")
_LIMIT_KEYS = (*_POSE_LIMITS, *_LEG_LIMITS, "platform_speed", "platform_turn_rate")
_LOAD_KEYS = ("F_ext", "M_ext")
_VIA_KEYS = ("t", "theta", "tolerance")


@dataclass(frozen=True, eq=False)
class PlanRequest:
    """Contents of a plan file, with the names and units of ``plan_path`` and ``parameterize_path``.

    Attributes
    ----------
    rate : float
        Sampling rate of the trajectory (Hz).
    files : tuple of Path
        Files from which the plan was read: the plan, the robot, and the via poses if they are in a separate
        file.
    doubt : str
        Warning about the via poses, or an empty string.
    """

    robot: Robot
    poses: tuple[ViaPose, ...]
    path_limits: PoseLimits
    limits: PathLimits
    objective: Objective
    smoothness_weight: float
    load: Array
    formulation: Formulation
    rate: float
    minimize: Minimize
    duration: float | None
    files: tuple[Path, ...]
    doubt: str = ""

    def of_poses(self, text: str) -> str:
        """Add the file and the doubt of the via poses to a message; in a TOML file, keys replace numbers."""
        return _of_poses(f"{text}; {self.doubt}" if self.doubt else text, self.files)


@contextlib.contextmanager
def read_plan(path: str | os.PathLike[str]) -> Iterator[PlanRequest]:
    """Read a file of via poses.

    Parameters
    ----------
    path : str or path-like
        TOML file, schema 1. Relative file names in it refer to its folder.

    Yields
    ------
    PlanRequest
        Validated plan. Errors in the block that name a key of the file are extended by its line number.

    Raises
    ------
    ValueError
        If this file or a file named in it cannot be read or violates its schema. The message is one line,
        ``file: key: expected value (at line n)``.
    """
    source = os.fsdecode(path)
    with toml_reader.toml_tables(source, "file of via poses") as d:
        yield _request(d, source)


def _request(d: Mapping[str, Any], source: str) -> PlanRequest:
    """Convert the tables of a plan file to a plan."""
    file = f"{source}: "
    top = toml_reader.checked_table(d, file, _TOP_KEYS, ("schema", "robot"))
    whole_number(top["schema"], f"{file}schema", SCHEMA, str(SCHEMA), SCHEMA)
    if ("via" in top) == ("via_file" in top):
        raise ValueError(f"{file}via: expected either via poses or via_file")
    options: dict[str, Any] = {
        key: option(top.get(key, known[0]), known, file + key)
        for key, known in (("formulation", FORMULATIONS), ("objective", OBJECTIVES), ("minimize", MINIMIZE))
    }
    options["smoothness_weight"] = toml_reader.not_negative(
        top.get("smoothness_weight", PRICE), f"{file}smoothness_weight"
    )
    options["rate"] = toml_reader.positive(top.get("rate", RATE), f"{file}rate")
    options["duration"] = (
        toml_reader.positive(top["duration"], f"{file}duration") if "duration" in top else None
    )
    path_limits, limits = _limits(top.get("limits", {}), f"{file}limits.")
    load = _load(top.get("load", {}), f"{file}load.")
    files = [Path(source), toml_reader.file_beside(top["robot"], source, "robot")]
    given = _via_tables(top["via"], f"{file}via") if "via" in top else None
    if given is None:
        files.append(toml_reader.file_beside(top["via_file"], source, "via_file"))
    robot = Robot.from_toml(files[1])
    with errors_of(f"{file}limits."):
        need_clearance(robot, path_limits.min_clearance)
    doubt = ""
    if given is None:
        read = read_poses_of(robot, files[2])
        poses = tuple(ViaPose(*pose) for pose in zip(*read, strict=True))
    else:
        doubt = _angle_doubt(given)
        if doubt:
            warn(f"{source}: via: {doubt}", TrajectoryWarning)
        order = robot.trajectory_format.rotation_order
        poses = tuple(ViaPose(rotation_about_axes(theta, order), t, *box) for t, theta, box in given)
    try:
        need_poses(poses)
    except ValueError as error:
        raise ValueError(_of_poses(str(error), files)) from None
    return PlanRequest(
        robot,
        poses,
        path_limits,
        limits,
        load=load,
        files=tuple(files),
        doubt=doubt,
        **options,
    )


def _of_poses(text: str, files: Sequence[Path]) -> str:
    """Add the file of the via poses to a message."""
    apart = len(files) > 2
    return f"{files[-1]}: {text}" if apart else f"{files[0]}: {text.replace('via pose ', 'via ', 1)}"


def _limits(value: object, prefix: str) -> tuple[PoseLimits, PathLimits]:
    """Convert the table ``limits``."""
    table = toml_reader.checked_table(value, prefix, _LIMIT_KEYS)
    found: dict[str, Any] = {}
    for key, given in table.items():
        check = leg_limits if key in _LEG_LIMITS else toml_reader.positive
        found[key] = check(given, prefix + key)
    own = {key: found.pop(key) for key in _POSE_LIMITS if key in found}
    with errors_of(prefix):
        return PoseLimits(**own), PathLimits(**found)


def _load(value: object, prefix: str) -> Array:
    """Return the load [F_ext; M_ext], shape (6,)."""
    table = toml_reader.checked_table(value, prefix, _LOAD_KEYS)
    parts = [toml_reader.vector(table.get(key, [0.0, 0.0, 0.0]), prefix + key) for key in _LOAD_KEYS]
    return np.concatenate(parts)


def _via_tables(value: object, where: str) -> list[tuple[Array, Array, tuple[Array, Array]]]:
    """Return t, theta, and the tolerance bounds of each via pose."""
    if not isinstance(value, list) or len(value) < 2:
        count = len(value) if isinstance(value, list) else "no list"
        raise ValueError(f"{where}: expected at least 2 via poses, got {count}")
    found = []
    for i, entry in enumerate(value):
        prefix = f"{where} {i + 1}: "
        table = toml_reader.checked_table(entry, prefix, _VIA_KEYS, ("t", "theta"))
        t, theta = (toml_reader.vector(table[key], prefix + key) for key in ("t", "theta"))
        found.append((t, theta, _box(table.get("tolerance", {}), f"{prefix}tolerance.")))
    return found


def _angle_doubt(given: Sequence[tuple[Array, Array, tuple[Array, Array]]]) -> str:
    """Return a warning about implausible rotations relative to the level pose, or an empty string."""
    theta = [theta + shift[3:] for _, theta, box in given for shift in box]
    doubt = turn_doubt(np.array([np.zeros(3), *theta]))
    return "" if doubt is None else f"{doubt}: are angles in degrees? Radians are expected"


def _box(value: object, prefix: str) -> tuple[Array, Array]:
    """Return the lower and upper tolerances, shape (6,) each."""
    low, high = np.zeros(6), np.zeros(6)
    for key, given in toml_reader.checked_table(value, prefix, COORDINATES).items():
        i = COORDINATES.index(key)
        low[i], high[i] = toml_reader.numbers(given, prefix + key, (2,))
        if not low[i] <= 0.0 <= high[i]:
            raise ValueError(f"{prefix}{key}: expected [low, high] with low <= 0 <= high, got {given}")
    return low, high
