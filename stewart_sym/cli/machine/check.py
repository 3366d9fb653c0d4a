"""``stewart-sym check``: validate and describe a robot file."""

import argparse
import contextlib
from pathlib import Path

from ..inputs import robot_of
from ..options import output, robot_file
from ..output import results

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
    robot_file(parser)
    output(parser, "DIR", "folder for the report and a picture", "none is written", plots=True)


def run(arguments: argparse.Namespace) -> int:
    from ...studies.reports.describe import report

    with results(arguments, "report") as (take, _):
        take(report(robot_of(arguments.robot), _length_unit(arguments.robot)))
    return 0


def _length_unit(robot: Path) -> str:
    """Unit of lengths in a robot file; m where it cannot be read a second time, as from a pipe."""
    from ...io.toml_reader import toml_tables

    with contextlib.suppress(ValueError), toml_tables(str(robot), "robot file") as tables:
        return str(tables.get("length_unit", "m"))
    return "m"
