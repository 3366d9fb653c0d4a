"""``stewart-sym import``: make a robot file of a model of another program."""

import argparse
from pathlib import Path

from ..inputs import warn_of_doubts
from ..options import output
from ..output import results

HELP = "make a robot file of a model in MJCF, SDF or URDF"
EXAMPLE = "stewart-sym import hexapod.xml -o imported.toml"
MORE = (
    "Base, platform and legs are found by how bodies are joined; what was found and what had to be assumed "
    "is printed and stands in the robot file as comments. The loops of a URDF are read from NAME.loops.json, "
    "or from its drake:ball_constraint elements."
)

_BEGINNING = "# Imported by stewart-sym"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("model", metavar="MODEL", type=Path, help="model in MJCF, SDF or URDF")
    output(parser, "ROBOT.toml", "file to write, - for standard output", None)


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
