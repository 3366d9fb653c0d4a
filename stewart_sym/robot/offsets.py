"""Offset joints of the legs: axes that do not intersect, universal platform joints, and crosses."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, fields
from typing import Any

import numpy as np

from ..io import toml_reader
from ..io.arguments import option
from ..io.array_types import Array, Frozen
from .fields import LEGS, LegTables, direction

PLATFORM_JOINTS = ("spherical", "universal")


@dataclass(frozen=True, eq=False)
class JointOffsets(Frozen):
    """Distances between the axes and the sliding axis of each leg, and properties of the joints.

    One number may be given for an array of shape (6,) if all legs have the same value. Arrays are read-only.

    The axes from the base point are the fixed axis k, the moving axis y perpendicular to k, and the sliding
    axis s perpendicular to y. The vector o = y x k points from the fixed axis toward the platform, and z = s
    x y. The end of the leg is at S = axis_offset o + slide_offset_y y + slide_offset_z z + L s from the base
    point. Frame D of the lower part has its origin at the intersection of o and the moving axis, frame U of
    the upper part at the end of the leg. Zeros describe a leg without offsets.

    With spherical platform joints, the axes of U and D are identical. With universal platform joints, x_U =
    s, z_U = x_U x y_U, and y_U is the unit vector along k_P x s, with k_P = R platform_axis.

    Attributes
    ----------
    axis_offset : ndarray, shape (6,), optional
        Distance (m) from the fixed to the moving axis along their common normal o.
    slide_offset_y, slide_offset_z : ndarray, shape (6,), optional
        Distances (m) along y and z from the intersection of o and the moving axis to the sliding axis.
    platform_joint : {"spherical", "universal"}, optional
        Type of the platform joints. "universal" is a joint with two axes on a leg whose upper part rotates
        about s in the lower part. The first axis is fixed to the upper part, perpendicular to s; the second
        axis is fixed to the platform.
    platform_axis : ndarray, shape (6, 3), optional
        Unit vectors along the second axes, platform frame; zeros for spherical platform joints.
    wrist_offset : ndarray, shape (6,), optional
        Distance (m) from the first to the second axis of a universal platform joint along their common
        normal, positive away from the base.
    cross_mass : ndarray, shape (6,), optional
        Mass (kg) of the body between the fixed and the moving axis.
    cross_center : ndarray, shape (6, 3), optional
        Center of mass (m) of this body relative to the base point, along o, y, and k.
    cross_inertia : ndarray, shape (6,), optional
        Inertia (kg m^2) of this body about the line along k through its center of mass.

    Raises
    ------
    ValueError
        If a value violates a rule; the message names the field.
    """

    axis_offset: Array = field(default_factory=lambda: np.zeros(LEGS))
    slide_offset_y: Array = field(default_factory=lambda: np.zeros(LEGS))
    slide_offset_z: Array = field(default_factory=lambda: np.zeros(LEGS))
    platform_joint: str = "spherical"
    platform_axis: Array = field(default_factory=lambda: np.zeros((LEGS, 3)))
    wrist_offset: Array = field(default_factory=lambda: np.zeros(LEGS))
    cross_mass: Array = field(default_factory=lambda: np.zeros(LEGS))
    cross_center: Array = field(default_factory=lambda: np.zeros((LEGS, 3)))
    cross_inertia: Array = field(default_factory=lambda: np.zeros(LEGS))

    def __post_init__(self) -> None:
        option(self.platform_joint, PLATFORM_JOINTS, "platform_joint")
        found = {name: _six(getattr(self, name), shape, name) for name, shape in SHAPES.items()}
        for name in ("cross_mass", "cross_inertia"):
            for i in range(LEGS):
                toml_reader.not_negative(found[name][i], f"{name}: leg {i + 1}")
        if self.platform_joint == "universal":
            axes = found["platform_axis"]
            found["platform_axis"] = np.array(
                [direction(axes[i], f"platform_axis: leg {i + 1}") for i in range(LEGS)]
            )
        elif found["platform_axis"].any() or found["wrist_offset"].any():
            raise ValueError(
                'platform_joint: platform_axis and wrist_offset require "universal", got "spherical"'
            )
        self._set(found)

    @property
    def has_spinning_parts(self) -> bool:
        """True if the upper parts rotate about s in the lower parts."""
        return self.platform_joint == "universal"

    @property
    def is_zero(self) -> bool:
        """True if the legs have no offsets."""
        return not self.has_spinning_parts and not any(getattr(self, name).any() for name in SHAPES)


def _six(value: Any, shape: tuple[int, ...], name: str) -> Array:
    """Return the checked numbers of each leg; one number may represent all legs."""
    alone = isinstance(value, int | float) and not isinstance(value, bool) and shape == (LEGS,)
    return toml_reader.numbers([value] * LEGS if alone else value, name, shape)


SHAPES: dict[str, tuple[int, ...]] = {
    each.name: (LEGS, 3) if each.name in ("platform_axis", "cross_center") else (LEGS,)
    for each in fields(JointOffsets)
    if each.name != "platform_joint"
}
"""Shapes of the arrays in ``JointOffsets``."""


def need_no_offsets(robot: Any) -> None:
    """Raise ValueError for a robot with offset joints, which the calling function does not support."""
    offsets = getattr(robot, "offsets", None)
    if offsets is not None and not offsets.is_zero:
        text = "expected none, because this function does not support offset joints"
        raise ValueError(f"robot: offsets: {text}; delete offsets and cross of the legs to neglect them")


# Tables of a robot file of schema 2

LENGTHS = ("axis_offset", "slide_offset_y", "slide_offset_z", "wrist_offset")
OFFSET_KEYS = (*LENGTHS, "platform_joint", "platform_axis")
CROSS_KEYS = ("mass", "center_of_mass", "inertia")
TABLES = {"offsets": OFFSET_KEYS, "cross": CROSS_KEYS}
"""Keys of the two tables."""


def offsets_of_tables(legs: LegTables, meters: Callable[[Any], Any]) -> JointOffsets | None:
    """Return the offsets of a robot file, or None if no leg has offsets.

    ``meters`` converts lengths of the file.
    """
    if not any(name in table for name in TABLES for table in legs.tables):
        return None
    joints, crosses = (legs.inner(name, keys) for name, keys in TABLES.items())
    for table, prefix in zip(joints.tables[1:], joints.prefixes[1:], strict=True):
        if "platform_joint" in table:
            raise ValueError(f"{prefix}platform_joint: expected it in legs.offsets, for all legs")
    of_all, none = joints.prefixes[0], np.zeros(3)
    joint = joints.tables[0].get("platform_joint", "spherical")
    joint = option(joint, PLATFORM_JOINTS, f"{of_all}platform_joint")
    found = {name: meters(joints.each(name, toml_reader.number, 0.0)) for name in LENGTHS}
    if joint == "universal":
        for i in range(LEGS):
            if "platform_axis" not in joints.of_leg(i):
                lacks = f'missing, and leg.{i + 1} has none, with platform_joint "universal"'
                raise ValueError(f"{of_all}platform_axis: {lacks}")
        found["platform_axis"] = joints.each("platform_axis", direction, none)
    else:
        for table, prefix in zip(joints.tables, joints.prefixes, strict=True):
            for key in table.keys() & {"platform_axis", "wrist_offset"}:
                expected = 'expected none unless legs.offsets.platform_joint is "universal"'
                raise ValueError(f"{prefix}{key}: {expected}")
    return JointOffsets(
        **found,
        platform_joint=joint,
        cross_mass=crosses.each("mass", toml_reader.not_negative, 0.0),
        cross_center=meters(crosses.each("center_of_mass", toml_reader.vector, none)),
        cross_inertia=crosses.each("inertia", toml_reader.not_negative, 0.0),
    )


def offset_tables(offsets: JointOffsets) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    """Return the tables of all legs and of each leg in SI units, the inverse of ``offsets_of_tables``."""
    shared = {"offsets": {"platform_joint": offsets.platform_joint}}
    names = LENGTHS if offsets.has_spinning_parts else LENGTHS[:-1]
    legs = []
    for i in range(LEGS):
        own: dict[str, Any] = {name: float(getattr(offsets, name)[i]) for name in names}
        if offsets.has_spinning_parts:
            own["platform_axis"] = offsets.platform_axis[i].tolist()
        cross = {
            "mass": float(offsets.cross_mass[i]),
            "center_of_mass": offsets.cross_center[i].tolist(),
            "inertia": float(offsets.cross_inertia[i]),
        }
        legs.append({"offsets": own, "cross": cross})
    return shared, legs
