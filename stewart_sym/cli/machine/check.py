"""``stewart-sym check``: validate and describe a robot file."""

import argparse
import contextlib
from pathlib import Path

from ..inputs import robot_of
from ..options import output, robot_file
from ..output import results

HELP = "validate, describe, and draw a robot file"
EXAMPLE = "stewart-sym check hexapod.toml -o hexapod"
MORE = (
    "Prints geometry, masses, limits, drives, and the home pose.\n"
    "-o writes report.txt, report.json, and a drawing.\n"
    "Lengths are in the length unit of the file; all other quantities are in SI units.\n"
    "Frames, signs, and rotation order: .docs/conventions.md of the source.\n"
    "Exit code: 0, or 2 if the file is not valid."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser)
    output(parser, "DIR", "folder of the report and a drawing", "no files", plots=True)


def run(arguments: argparse.Namespace) -> int:
    from ...studies.reports.describe import report

    with results(arguments, "report") as (take, _):
        take(report(robot_of(arguments.robot), _length_unit(arguments.robot)))
    return 0


def _length_unit(robot: Path) -> str:
    """Return the length unit of a robot file, or m if the file cannot be read twice (a pipe)."""
    from ...io.toml_reader import toml_tables

    with contextlib.suppress(ValueError), toml_tables(str(robot), "robot file") as tables:
        return str(tables.get("length_unit", "m"))
    return "m"
