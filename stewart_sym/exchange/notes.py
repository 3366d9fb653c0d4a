"""Note in exported files: the whole robot file, which is valid if the bodies and joints have not changed."""

import json
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from ..robot.robot import Robot

_SAME = 1e-5
"""Largest difference that is no change, relative to the largest value: programs write six digits."""
_ROUNDING = 1e-12
_NOT_COMPARED = ("name", "home_position")


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


def changed_keys(robot: Robot, other: Robot) -> list[str]:
    """Return the keys of the robot file with different values, such as ``platform.body.mass``."""
    one, two = (dict(_values(each.to_dict())) for each in (robot, other))
    keys = [key for key in one | two if key not in _NOT_COMPARED]
    return [key for key in keys if not _same(one.get(key), two.get(key))]


def _values(table: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Yield the keys and values in nested tables."""
    for key, value in table.items():
        if isinstance(value, Mapping):
            yield from _values(value, f"{prefix}{key}.")
        else:
            yield f"{prefix}{key}", value


def _same(one: Any, other: Any) -> bool:
    """Return True if two values are equal up to rounding."""
    if one is None or other is None or isinstance(one, str):
        return bool(one == other)
    one, other = np.asarray(one), np.asarray(other)
    largest = max(np.abs(each[np.isfinite(each)]).max(initial=0.0) for each in (one, other))
    return one.shape == other.shape and bool(
        np.allclose(one, other, rtol=0.0, atol=_SAME * largest + _ROUNDING)
    )
