"""Table of travel, speed, and acceleration along and about each axis, as text and as JSON data."""

from typing import Any

import numpy as np

from ...design.axis_travel import AXES, AxisTravelResult
from ...io.arguments import status_text
from ...robot.units import Units
from .text_tables import aligned

_NO_LIMIT = "no limit"


def axis_text(found: AxisTravelResult, units: Units) -> str:
    """Format the table with a header that names its units."""
    header: tuple[str, ...] = ("axis", "travel from", "to", "limit at lower end", "at upper end", "speed")
    header += () if found.acceleration is None else ("acceleration from", "to")
    rows = [_row(found, i, units) for i in range(len(AXES))]
    title = "axis travel: from the home pose, at the tool, along and about the axes of the base frame"
    return "\n".join([f"{title} ({units.length}, {units.angle}, s)", aligned(header, rows)])


def _row(found: AxisTravelResult, i: int, units: Units) -> tuple[str, ...]:
    """Return the cells of one axis."""
    scale = units.meters if i < 3 else units.radians
    name = f"{AXES[i]}, {'along' if i < 3 else 'about'} {'xyz'[i % 3]}"
    ends = tuple(_cell(end / scale, "outside") for end in found.travel[i])
    causes = tuple("" if cause == "none" else status_text(cause) for cause in found.limits[i])
    cells = (name, *ends, *causes, _cell(found.speed[i] / scale, "-"))
    if found.acceleration is None:
        return cells
    return (*cells, *(_cell(end / scale, "not held") for end in found.acceleration[i]))


def _cell(value: float, unknown: str) -> str:
    """Format a number; an infinite number means that no limit is given, NaN is ``unknown``."""
    if np.isnan(value):
        return unknown
    return _NO_LIMIT if np.isinf(value) else f"{float(f'{value:.4g}'):g}"


def axis_data(found: AxisTravelResult) -> dict[str, Any]:
    """Return the data of each axis by its name in SI units; null means no limit or an unknown value."""
    table: dict[str, Any] = {"tool_position_m": found.position}
    for i, name in enumerate(AXES):
        unit = "m" if i < 3 else "rad"
        table[name] = {
            f"travel_{unit}": found.travel[i],
            "limits": found.limits[i],
            f"speed_{unit}_per_s": found.speed[i],
        }
        if found.acceleration is not None:
            table[name][f"acceleration_{unit}_per_s2"] = found.acceleration[i]
    return table
