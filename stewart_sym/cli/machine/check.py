"""``stewart-sym check``: validate and describe a robot file."""

import argparse

from ..inputs import length_unit, robot_of
from ..options import json_file, no_pictures, output, robot_file
from ..results import need_drawing, results

HELP = "validate, describe and draw a robot file"
EXAMPLE = "stewart-sym check hexapod.toml -o hexapod"
MORE = (
    "Prints what the machine was understood to be; with -o also writes it to a folder, with a picture. "
    "Lengths are in the file's length_unit, all else and the JSON file in SI units. "
    "Base points, fixed axes and gravity are in the base frame, platform points and the "
    "platform's body in the platform frame, whose origin is yours to choose. Lower parts are measured"
    " from the base point, upper parts from the platform point, x along the leg. Frames, signs and "
    "rotation order with a drawing: .docs/conventions.md of the source."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``check``."""
    robot_file(parser)
    output(parser, "DIR", "folder for the report and a picture", "none is written")
    no_pictures(parser)
    json_file(parser)


def run(arguments: argparse.Namespace) -> int:
    """Run ``check``; returns the exit code."""
    from ...studies.reports.describe import report

    drawn = arguments.pictures and arguments.output is not None
    if drawn:
        need_drawing(arguments)
    with results(arguments, "report") as take:
        take(report(robot_of(arguments.robot), drawn, length_unit(arguments.robot)))
    return 0
