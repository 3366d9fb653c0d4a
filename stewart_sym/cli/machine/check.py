"""Validate, describe, and draw a robot file.

Prints geometry, masses, limits, drives, and the home pose.
-o writes report.txt, report.json, and a drawing.
Lengths are in the length unit of the file; all other quantities are in SI units.
Frames, signs, and rotation order: .docs/conventions.md of the source.
Exit code: 0, or 2 if the file is not valid.

Example: stewart-sym check hexapod.toml -o hexapod
"""

import contextlib
from pathlib import Path

from ...io.toml_reader import toml_tables
from ...studies.reports.describe import report
from ..inputs import robot_of
from ..options import Arguments, Parser
from ..output import results


def add_arguments(parser: Parser) -> None:
    parser.file("robot")
    parser.output("DIR", "folder of the report and a drawing", otherwise="no files", plots=True)


def run(arguments: Arguments) -> None:
    with results(arguments, "report") as (take, _):
        take(report(robot_of(arguments.robot), _length_unit(arguments.robot)))


def _length_unit(robot: Path) -> str:
    """Return the length unit of a robot file, or m if the file cannot be read twice (a pipe)."""
    with contextlib.suppress(ValueError), toml_tables(str(robot), "robot file") as tables:
        return str(tables.get("length_unit", "m"))
    return "m"
