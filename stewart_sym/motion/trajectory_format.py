"""Format of trajectory files: names of columns, units, delimiters, and conventions."""

import dataclasses
import itertools
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from ..io.arguments import number_in, option, shown
from .csv_table import DECIMALS, DELIMITERS

LENGTH_UNITS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "in": 0.0254}
ANGLE_UNITS = {"rad": 1.0, "deg": math.pi / 180.0}
TIME_UNITS = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}
UNITS: dict[str, Mapping[str, float]] = {
    "length_unit": LENGTH_UNITS,
    "angle_unit": ANGLE_UNITS,
    "time_unit": TIME_UNITS,
}
"""Units in SI units, by the name of their option."""
EULER_ORDERS = tuple("".join(order) for order in itertools.permutations("xyz"))
MODES = ("absolute", "relative")
"""Coordinates by themselves, or relative to the home pose of the robot."""


class TrajectoryWarning(UserWarning):
    """Implausible or incomplete samples of a trajectory file."""


@dataclass(frozen=True)
class TrajectoryFormat:
    """Format of a trajectory file; None stands for the value in the robot file, or for detection.

    Attributes
    ----------
    columns : dict of str to str
        Header by name, such as ``{"t_z": "Heave"}``. Columns that are not mentioned are found by their names.
    offsets, scales : dict of str to float
        A column is multiplied by its scale, such as -1, then its offset is added, in units of the column.
    length_unit, angle_unit, time_unit : str, optional
        Units of ``UNITS``; by default as in the header or in a row of units, otherwise m, rad, and s.
    delimiter : {"comma", "semicolon", "tab"}, optional
        Mark between columns.
    decimal : {"point", "comma"}, optional
        Decimal mark.
    euler_order : str, optional
        Order in which rotations are multiplied, "zyx" for R = Rz Ry Rx, (38).
    length_mode, pose_mode : {"absolute", "relative"}, optional
        Leg lengths or poses by themselves, or relative to the home pose of the robot.
    row_rate : float, optional
        Rows per second (Hz) of a file without times.
    drop_lines : tuple of int
        Lines of the file that are not used.

    Raises
    ------
    ValueError
        If an attribute is invalid; the message begins with its name.
    """

    columns: Mapping[str, str] = field(default_factory=dict)
    length_unit: str | None = None
    angle_unit: str | None = None
    time_unit: str | None = None
    delimiter: str | None = None
    decimal: str | None = None
    euler_order: str | None = None
    length_mode: str | None = None
    pose_mode: str | None = None
    offsets: Mapping[str, float] = field(default_factory=dict)
    scales: Mapping[str, float] = field(default_factory=dict)
    row_rate: float | None = None
    drop_lines: tuple[int, ...] = ()

    def __post_init__(self) -> None:
        choices: dict[str, Iterable[str]] = {**UNITS, "delimiter": DELIMITERS, "decimal": DECIMALS}
        choices |= {"euler_order": EULER_ORDERS, "length_mode": MODES, "pose_mode": MODES}
        for name, known in choices.items():
            if getattr(self, name) is not None:
                option(getattr(self, name), tuple(known), name)
        for name in ("columns", "offsets", "scales"):
            if not isinstance(getattr(self, name), Mapping):
                raise ValueError(f"{name}: expected a mapping of names, got {shown(getattr(self, name))}")
        if any(not isinstance(each, str) for each in (*self.columns, *self.columns.values())):
            raise ValueError(f"columns: expected a mapping of names to names, got {shown(self.columns)}")
        for name in ("offsets", "scales"):
            for column, value in getattr(self, name).items():
                number_in(value, f"{name}: {column}", "a finite number", -math.inf)
        if self.row_rate is not None:
            number_in(self.row_rate, "row_rate", "a frequency > 0 Hz")

    @property
    def rotation_order(self) -> str:
        """Order of the rotations."""
        return self.euler_order or "zyx"


def std_in_si(
    form: TrajectoryFormat, position: float | None, angle: float | None
) -> tuple[float | None, float | None]:
    """Convert standard deviations from the units of a file to m and rad; None remains None."""
    meters, radians = LENGTH_UNITS[form.length_unit or "m"], ANGLE_UNITS[form.angle_unit or "rad"]
    return position and position * meters, angle and angle * radians


def combined(form: TrajectoryFormat, defaults: TrajectoryFormat) -> TrajectoryFormat:
    """Return a format with the values of ``defaults`` for unspecified attributes and columns."""
    own = {name: value for name, value in vars(form).items() if value}
    for name in ("columns", "offsets", "scales"):
        own[name] = {**getattr(defaults, name), **getattr(form, name)}
    return dataclasses.replace(defaults, **own)


PLAIN = TrajectoryFormat()
"""Format without statements: SI units unless the file states others."""
