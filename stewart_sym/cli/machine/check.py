"""``stewart-sym check``: validate and describe a robot file."""

import argparse

from ..inputs import robot_of
from ..options import json_file, robot_file
from ..results import results

HELP = "validate and describe a robot file"
EXAMPLE = "stewart-sym check hexapod.toml"
MORE = (
    "SI units. Base points, fixed axes and gravity are in the base frame, platform points and the "
    "platform's body in the platform frame, whose origin is yours to choose. Lower parts are measured"
    " from the base point, upper parts from the platform point, x along the leg. Frames, signs and "
    "rotation order with a drawing: .docs/conventions.md of the source."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``check``."""
    robot_file(parser)
    json_file(parser)


def run(arguments: argparse.Namespace) -> int:
    """Run ``check``; returns the exit code."""
    from ...studies.reports.describe import report

    with results(arguments) as take:
        take(report(robot_of(arguments.robot)))
    return 0
