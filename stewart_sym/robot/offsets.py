"""Offset joints of the legs: axes that miss each other, a platform joint of two axes, the joint's cross."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, fields
from typing import Any

import numpy as np

from ..io import tables
from ..io.array_types import Array
from ..io.frozen import Frozen
from .fields import LEGS, LegTables, direction

PLATFORM_JOINTS = ("spherical", "universal")


@dataclass(frozen=True, eq=False)
class Offsets(Frozen):
    """By how much the axes and the line of sliding of each leg miss each other.  SI units; read-only.

    A number may be given for an array (6,): that of all legs.

    From the base point the fixed axis k, the moving axis y at a right angle to it, and the line of sliding
    along s at a right angle to y. o = y x k points from the fixed axis towards the platform; z = s x y. The
    end of the leg lies at S = cross o + along y + across z + L s from the base point. Frame D of the lower
    part has its origin where o meets the moving axis, frame U of the upper part at the end of the leg. Zeros
    are the ordinary leg.

    With spherical platform joints, U has the axes of D. With universal ones, x_U = s and z_U = x_U x y_U. The
    axis y_U is the unit vector along k_P x s, with k_P = R platform_axis.

    Attributes
    ----------
    cross : ndarray, optional
        From the fixed to the moving axis, along their common normal o, m, (6,).
    along, across : ndarray, optional
        From where o meets the moving axis to the line of sliding, along y and along z, m, (6,).
    platform_joint : str, optional
        ``"spherical"``, or ``"universal"`` for a joint of two axes on a leg whose upper part turns about s in
        the lower one: the first axis is on the upper part at a right angle to s, the second on the platform.
    platform_axis : ndarray, optional
        Unit vectors along the second axes, platform frame, (6, 3); zeros with spherical joints.
    wrist : ndarray, optional
        From the first to the second axis of a universal platform joint along their common normal, positive
        away from the base, m, (6,).
    cross_mass : ndarray, optional
        Mass of the body between fixed and moving axis, kg, (6,).
    cross_center : ndarray, optional
        Its centre of mass from the base point along o, y and k, m, (6, 3).
    cross_inertia : ndarray, optional
        Its inertia about the line along k through its centre of mass, kg m^2, (6,).

    Raises
    ------
    ValueError
        Naming the field.
    """

    cross: Array = field(default_factory=lambda: np.zeros(LEGS))
    along: Array = field(default_factory=lambda: np.zeros(LEGS))
    across: Array = field(default_factory=lambda: np.zeros(LEGS))
    platform_joint: str = "spherical"
    platform_axis: Array = field(default_factory=lambda: np.zeros((LEGS, 3)))
    wrist: Array = field(default_factory=lambda: np.zeros(LEGS))
    cross_mass: Array = field(default_factory=lambda: np.zeros(LEGS))
    cross_center: Array = field(default_factory=lambda: np.zeros((LEGS, 3)))
    cross_inertia: Array = field(default_factory=lambda: np.zeros(LEGS))

    def __post_init__(self) -> None:
        tables.choice(self.platform_joint, PLATFORM_JOINTS, "platform_joint")
        found = {name: _six(getattr(self, name), shape, name) for name, shape in SHAPES.items()}
        for name in ("cross_mass", "cross_inertia"):
            for i in range(LEGS):
                tables.not_negative(found[name][i], f"{name}: leg {i + 1}")
        if self.platform_joint == "universal":
            axes = found["platform_axis"]
            found["platform_axis"] = np.array(
                [direction(axes[i], f"platform_axis: leg {i + 1}") for i in range(LEGS)]
            )
        elif found["platform_axis"].any() or found["wrist"].any():
            raise ValueError(
                'platform_joint: expected "universal" beside platform_axis and wrist, got "spherical"'
            )
        self._set(found)

    @property
    def spins(self) -> bool:
        """Whether the upper parts turn about s in the lower ones."""
        return self.platform_joint == "universal"

    @property
    def nothing(self) -> bool:
        """Whether the legs are ordinary ones."""
        return not self.spins and not any(getattr(self, name).any() for name in SHAPES)


def _six(value: Any, shape: tuple[int, ...], name: str) -> Array:
    """Numbers of each leg, checked; one number may stand for those of all."""
    alone = isinstance(value, int | float) and not isinstance(value, bool) and shape == (LEGS,)
    return tables.numbers([value] * LEGS if alone else value, shape, name)


SHAPES: dict[str, tuple[int, ...]] = {
    each.name: (LEGS, 3) if each.name in ("platform_axis", "cross_center") else (LEGS,)
    for each in fields(Offsets)
    if each.name != "platform_joint"
}
"""Arrays of ``Offsets``, with their shapes."""


def need_no_offsets(robot: Any) -> None:
    """Reject, by ValueError, a robot with offset joints: what is computed is of legs whose axes meet."""
    offsets = getattr(robot, "offsets", None)
    if offsets is not None and not offsets.nothing:
        raise ValueError("robot: offsets: expected none, offset joints are not supported here")


# Tables of a robot file of schema 2

LENGTHS = ("cross", "along", "across", "wrist")
OFFSET_KEYS = (*LENGTHS, "platform_joint", "platform_axis")
CROSS_KEYS = ("mass", "center_of_mass", "inertia")
TABLES = {"offsets": OFFSET_KEYS, "cross": CROSS_KEYS}
"""Keys of both tables."""


def offsets_of_tables(legs: LegTables, metres: Callable[[Any], Any]) -> Offsets | None:
    """The offsets of a robot file; None where no leg states any. metres: from lengths of the file."""
    if not any(name in table for name in TABLES for table in legs.tables):
        return None
    joints, crosses = (legs.inner(name, keys) for name, keys in TABLES.items())
    for table, prefix in zip(joints.tables[1:], joints.prefixes[1:], strict=True):
        if "platform_joint" in table:
            raise ValueError(f"{prefix}platform_joint: expected it in legs.offsets, for all legs")
    of_all, none = joints.prefixes[0], np.zeros(3)
    joint = joints.tables[0].get("platform_joint", "spherical")
    joint = tables.choice(joint, PLATFORM_JOINTS, f"{of_all}platform_joint")
    found = {name: metres(joints.each(name, tables.number, 0.0)) for name in LENGTHS}
    if joint == "universal":
        for i in range(LEGS):
            if "platform_axis" not in joints.of_leg(i):
                lacks = f'missing, and leg.{i + 1} has none, with platform_joint "universal"'
                raise ValueError(f"{of_all}platform_axis: {lacks}")
        found["platform_axis"] = joints.each("platform_axis", direction, none)
    else:
        for table, prefix in zip(joints.tables, joints.prefixes, strict=True):
            for key in table.keys() & {"platform_axis", "wrist"}:
                expected = 'expected none unless legs.offsets.platform_joint is "universal"'
                raise ValueError(f"{prefix}{key}: {expected}")
    return Offsets(
        **found,
        platform_joint=joint,
        cross_mass=crosses.each("mass", tables.not_negative, 0.0),
        cross_center=metres(crosses.each("center_of_mass", tables.vector, none)),
        cross_inertia=crosses.each("inertia", tables.not_negative, 0.0),
    )


def offset_tables(offsets: Offsets) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    """What ``legs`` and each leg have, SI units; ``offsets_of_tables`` undoes it to the bit."""
    shared = {"offsets": {"platform_joint": offsets.platform_joint}}
    names = LENGTHS if offsets.spins else LENGTHS[:-1]
    legs = []
    for i in range(LEGS):
        own: dict[str, Any] = {name: float(getattr(offsets, name)[i]) for name in names}
        if offsets.spins:
            own["platform_axis"] = offsets.platform_axis[i].tolist()
        cross = {
            "mass": float(offsets.cross_mass[i]),
            "center_of_mass": offsets.cross_center[i].tolist(),
            "inertia": float(offsets.cross_inertia[i]),
        }
        legs.append({"offsets": own, "cross": cross})
    return shared, legs
