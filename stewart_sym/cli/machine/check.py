"""Validate, describe, and draw a robot file.

Prints geometry, masses, limits, drives, the home pose, and the travel, speed, and acceleration of each axis.
-o writes report.txt, report.json, and a drawing.
Lengths and angles have the units of the file; all other quantities have SI units.
Frames, signs, and rotation order: .docs/conventions.md of the source.
Exit code: 0, or 2 if the file is not valid.

Example: stewart-sym check hexapod.toml -o hexapod
"""

from ...studies.reports.robot_report import report
from ..command import Arguments, Parser, results
from ..inputs import robot_of


def add_arguments(parser: Parser) -> None:
    parser.file("robot")
    parser.output("DIR", "folder of the report and a drawing", otherwise="no files", plots=True)


def run(arguments: Arguments) -> None:
    with results(arguments, "report") as (take, _):
        take(report(robot_of(arguments.robot)))
