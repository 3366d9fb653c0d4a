"""Note in exported files: the whole robot file, which is valid if the bodies and joints have not changed."""

import dataclasses
import json
from collections.abc import Collection
from typing import Any

import numpy as np

from ..motion.trajectory_format import TrajectoryFormat
from ..robot import fields
from ..robot.drive import Drive
from ..robot.offsets import SHAPES, JointOffsets
from ..robot.robot import Robot

_SAME = 1e-5
"""Largest difference that is no change, relative to the largest value: programs write six digits."""
_COMPARED = (
    *("base_joint", "b", "p", "k", "M", "R_0", "I_p", "m_d", "r_d0", "I_d0", "m_u", "r_u0", "I_u0", "g"),
    *("C_u", "C_p", "C_s", "length_limits", "force_limit", "speed_limit", "drive", "offsets"),
)
"""Fields of a robot that follow from bodies and joints."""


def json_table(text: str | None, where: str) -> dict[str, Any] | None:
    """Return a table in JSON, or None without a text."""
    if text is None:
        return None
    try:
        found = json.loads(text)
    except (ValueError, RecursionError):
        raise ValueError(f"{where}: expected JSON") from None
    if not isinstance(found, dict):
        raise ValueError(f"{where}: expected a table")
    return found


def changed_fields(robot: Robot, other: Robot, unstated: Collection[str]) -> list[str]:
    """Return the fields from bodies and joints that differ; ``unstated`` ones are not compared."""
    return [
        name
        for name in _COMPARED
        if name not in unstated and not _near(_plain(getattr(robot, name)), _plain(getattr(other, name)))
    ]


def noted_alone(noted: Robot, robot: Robot, changed: Collection[str]) -> list[str]:
    """Return the other fields of the noted robot that differ from the robot of bodies and joints."""
    return [
        field.name
        for field in dataclasses.fields(Robot)
        if field.name not in (*changed, "name", "suppressed_warnings", "length_unit", "angle_unit")
        and not _same(*(getattr(each, field.name) for each in (noted, robot)))
    ]


def _same(one: Any, other: Any) -> bool:
    """Return True if two values are equal; a model contains only the rotors of a drive."""
    if isinstance(one, Drive | TrajectoryFormat):
        return bool(one == other)
    return _near(_plain(one), _plain(other))


def key_of(name: str) -> str:
    """Return the key of a field in a robot file, such as ``platform.body.mass``."""
    if name in fields.LEG_FIELDS:
        return f"legs.{fields.LEG_FIELDS[name][0]}"
    return fields.FIELDS[name][0].replace("platform.", "platform.body.") if name in fields.FIELDS else name


def _plain(value: Any) -> Any:
    """Return offsets and drives as numbers; a drive follows from armatures alone."""
    if isinstance(value, JointOffsets):
        return np.concatenate([np.ravel(getattr(value, name)) for name in SHAPES])
    return value.reflected_mass if isinstance(value, Drive) else value


def _near(one: Any, other: Any) -> bool:
    """Return True if two values are equal up to rounding."""
    if one is None or other is None:
        return one is other
    if isinstance(one, str):
        return bool(one == other)
    one, other = np.asarray(one), np.asarray(other)
    if one.shape != other.shape:
        return False
    largest = max(np.abs(each[np.isfinite(each)]).max(initial=0.0) for each in (one, other))
    return bool(np.allclose(one, other, rtol=0.0, atol=_SAME * largest))
