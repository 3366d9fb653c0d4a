"""``stewart-sym import``: write a robot file from a model of another program."""

import argparse
from pathlib import Path

from ..inputs import warn_of_doubts
from ..options import output
from ..output import results

HELP = "write a robot file from a model in MJCF, SDF, or URDF"
EXAMPLE = "stewart-sym import hexapod.xml -o imported.toml"
MORE = (
    "Base, platform, and legs are recognized from the joints between the bodies.\n"
    "The terminal and comments in the robot file list the findings and assumptions.\n"
    "Loops of a URDF file are read from NAME.loops.json or its drake:ball_constraint elements."
)

_BEGINNING = "# Imported by stewart-sym"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("model", metavar="MODEL", type=Path, help="model in MJCF, SDF, or URDF")
    output(parser, "ROBOT.toml", "robot file; - for standard output", None)


def run(arguments: argparse.Namespace) -> int:
    from ...exchange.files import import_model
    from ...io.arguments import safe_text
    from ...io.atomic_write import result_file
    from ...io.toml_text import toml_text
    from ...studies.common.report import Report

    path: Path = arguments.output
    found = import_model(arguments.model)
    tables = found.robot.to_dict()
    lines = [f"{_BEGINNING} from {safe_text(arguments.model.name)}."]
    lines += [f"# {safe_text(line)}" for line in found.assumptions]
    with results(arguments) as (take, _), result_file(path, [_BEGINNING], arguments.force) as stream:
        stream.write("\n".join(lines) + "\n" + toml_text(tables))
        warn_of_doubts(found.robot, path)
        said = "" if str(path) == "-" else "\n".join([*found.assumptions, f"Written to {path}"])
        take(Report(said, data={"assumptions": found.assumptions, "robot": tables}))
    return 0
