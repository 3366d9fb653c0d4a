"""Notes in exported files: fields of the robot in JSON that the format omits or represents inexactly.

If the model contradicts a note, for example after an edit by hand, the model has priority.
"""

import json
from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Any

import numpy as np

from ..io.error_policy import errors_of
from ..io.json_text import json_text
from ..motion.trajectory_format import TrajectoryFormat
from ..robot.drive import Drive, drive_of_tables, drive_tables
from ..robot.fields import LEGS, LegTables
from ..robot.offsets import JointOffsets
from ..robot.robot import Robot
from ..robot.schema_2 import format_table
from .model import Model
from .offset_legs import noted_offsets, restored_offsets, same_offsets

_ROUNDING = 1e-9
_FIELDS = tuple(field.name for field in fields(Robot))
_SILENT = (
    *(
        "name",
        "suppressed_warnings",
        "home_position",
        "tool",
        "trajectory_format",
        "joint_angle_limit",
    ),
    *("lower_length", "upper_length", "length_unit", "angle_unit"),
)
"""Fields that are independent of bodies and joints, so that the note has priority."""
_LIMITS = ("length_limits", "force_limit", "speed_limit", "joint_angle_limit")
_UNSTATED = {"C_u": 0.0, "C_p": 0.0, "C_s": 0.0, "force_limit": np.inf, "speed_limit": np.inf}
"""Fields that some formats cannot represent, with their values without a note."""


def json_table(text: str | None, where: str) -> dict[str, Any]:
    """Return a table in JSON; empty without a text."""
    if text is None:
        return {}
    try:
        found = json.loads(text)
    except (ValueError, RecursionError):
        raise ValueError(f"{where}: expected JSON") from None
    if not isinstance(found, dict):
        raise ValueError(f"{where}: expected a table")
    return found


def differences(robot: Robot, other: Robot) -> dict[str, Any]:
    """Return the fields of a robot that differ from another robot."""
    found = {}
    for name in _FIELDS:
        one, two = getattr(robot, name), getattr(other, name)
        arrays = isinstance(one, np.ndarray) and isinstance(two, np.ndarray)
        same = np.array_equal(one, two) if arrays else type(one) is type(two) and one == two
        if not same:
            found[name] = one
    return found


def noted(found: Mapping[str, Any]) -> dict[str, Any]:
    """Convert fields to plain values, with null for missing limits."""
    given = dict(found)
    if isinstance(drive := given.get("drive"), Drive):
        given["drive"] = drive_tables(drive)
    if isinstance(form := given.get("trajectory_format"), TrajectoryFormat):
        given["trajectory_format"] = format_table(form)
    if isinstance(offsets := given.get("offsets"), JointOffsets):
        given["offsets"] = noted_offsets(offsets)
    plain: dict[str, Any] = json.loads(json_text(given))
    return plain


def with_notes(robot: Robot, model: Model) -> tuple[Robot, list[str]]:
    """Return the robot with the fields in the notes, unless the model contradicts them, and messages."""
    taken, said = {}, []
    for name, noted in model.notes.items():
        if name not in _FIELDS:
            raise ValueError(f"notes: {name!r}: expected a field of a robot")
        taken[name] = noted = _restored(name, noted)
        found = getattr(robot, name)
        if isinstance(noted, Drive) and found is None and model.armatures:
            found = replace(noted, rotor_inertia=np.zeros(LEGS))
        near = same_offsets(robot, noted) if isinstance(noted, JointOffsets) else _near(found, noted)
        if isinstance(found, Drive) and not near:
            # A model contains only the armature of a drive.
            taken[name] = replace(noted, rotor_inertia=found.reflected_mass / noted.transmission_ratio**2)
            said.append(
                "drive: the model and the note have different armatures: rotor_inertia follows the model"
            )
        elif name not in _SILENT and not near and not _unstated(name, found):
            del taken[name]
            said.append(f"{name}: the model contradicts the note; the model is used")
    if taken.get("home_position", robot.home_position) is None:
        for name in [name for name in taken if _requires_home(taken[name], name)]:
            del taken[name]
            said.append(
                f"{name}: requires a home position, which the model does not have; the note is ignored"
            )
    with errors_of("notes: "):
        return replace(robot, **taken), said


def _requires_home(value: Any, name: str) -> bool:
    """Return True for a field whose value refers to the home pose."""
    if name == "trajectory_format":
        return "relative" in (value.length_mode, value.pose_mode)
    return name == "joint_angle_limit" and bool(np.any(value != np.inf))


def _restored(name: str, noted: Any) -> Any:
    """Convert the value of a note to the value of a field; missing limits become infinite."""
    if name in _LIMITS:
        given = np.array(noted, dtype=np.float64)
        return np.where(np.isnan(given), np.inf, given)
    if name == "drive":
        if not isinstance(noted, list) or len(noted) != LEGS:
            raise ValueError("notes: drive: expected a list of six tables")
        legs = LegTables.of({}, [{"drive": table} for table in noted], "notes: ")
        return drive_of_tables(legs, float, False)
    if name == "offsets":
        return restored_offsets(noted)
    if name == "trajectory_format":
        with errors_of("notes: trajectory_format: "):
            return TrajectoryFormat(**noted)
    return tuple(noted) if name == "suppressed_warnings" and isinstance(noted, list) else noted


def _near(found: Any, noted: Any) -> bool:
    """Return True if a value equals the value of a note up to rounding."""
    if isinstance(found, Drive) and isinstance(noted, Drive):
        found, noted = found.reflected_mass, noted.reflected_mass
    try:
        given = np.asarray(noted, dtype=np.float64)
    except (TypeError, ValueError):
        return False
    if np.shape(found) != given.shape:
        return False
    found = np.asarray(found)
    finite = np.isfinite(found)
    largest = np.abs(found[finite]).max(initial=0.0)
    return bool(np.allclose(found, given, rtol=0.0, atol=_ROUNDING * largest, equal_nan=True))


def _unstated(name: str, found: Any) -> bool:
    """Return True if a field has its value for a format that cannot represent it."""
    if name == "drive":
        return found is None
    if name == "length_limits":
        return bool(np.all(found == np.array([0.0, np.inf])))
    return name in _UNSTATED and bool(np.all(found == _UNSTATED[name]))
