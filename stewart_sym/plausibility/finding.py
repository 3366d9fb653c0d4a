"""Finding about a robot, with quantities in the units of its file."""

from typing import NamedTuple

from ..robot.robot import Robot
from ..robot.units import Units


class Finding(NamedTuple):
    """Finding about a robot: name, as in ``suppressed_warnings``, and text with the likely cause."""

    name: str
    text: str


def finding(name: str, text: str, cause: str) -> Finding:
    """Return a finding from its text and the likely cause."""
    return Finding(name, f"{text}; likely cause: {cause}")


def in_file(robot: Robot, value: float, unit: str = "m") -> str:
    """Format a quantity of an SI unit, such as m/s, in the units of the robot file."""
    factor, name = Units.of(robot).of_unit(unit)
    return f"{float(f'{factor * value:.4g}'):.10g} {name}"


def smaller_unit(robot: Robot) -> str:
    """Return the probable unit of lengths that are too large."""
    return "millimeters" if robot.length_unit == "m" else "a smaller unit"
