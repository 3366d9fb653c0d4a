"""Table of travel, speed, and acceleration along and about each axis, as text and as JSON data."""

from typing import Any

from ...design.axis_travel import AXES, AxisTravelResult
from ...io.array_types import Array
from ...robot.units import Units
from .text_tables import aligned

_TITLE = "axis travel: from the home pose, at the tool, along and about the axes of the base frame"


def axis_text(found: AxisTravelResult, units: Units) -> str:
    """Format the table with a header that names its units."""
    header = ["axis", "travel from", "to", "limit at lower end", "at upper end", "speed"]
    rows = []
    for i, name in enumerate(AXES):
        scale, way = (units.meters, "along") if i < 3 else (units.radians, "about")
        causes = ["" if cause == "none" else cause.replace("_", " ") for cause in found.limits[i]]
        row = [f"{name}, {way} {'xyz'[i % 3]}", *_cells(found.travel[i] / scale, "outside"), *causes]
        row += _cells(found.speed[i : i + 1] / scale, "-")
        if found.acceleration is not None:
            row += _cells(found.acceleration[i] / scale, "not held")
        rows.append(row)
    header += [] if found.acceleration is None else ["acceleration from", "to"]
    return f"{_TITLE} ({units.length}, {units.angle}, s)\n{aligned(header, rows)}"


def _cells(values: Array, unknown: str) -> list[str]:
    """Format numbers; an infinite number means that no limit is given, NaN is ``unknown``."""
    names = {"nan": unknown, "inf": "no limit", "-inf": "no limit"}
    texts = [f"{float(f'{value:.4g}'):g}" for value in values]
    return [names.get(text, text) for text in texts]


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
