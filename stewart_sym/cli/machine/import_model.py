"""Write a robot file from a model in MJCF, SDF, or URDF.

Base, platform, and legs are recognized from the joints between the bodies.
The terminal and comments in the robot file list the findings and assumptions.
MuJoCo compiles MJCF: pip install "stewart-sym[exchange]".
Loops of a URDF file are read from NAME.loops.json or its drake:ball_constraint elements.

Example: stewart-sym import hexapod.xml -o imported.toml
"""

import stewart_sym as ss

from ...io.arguments import safe_text
from ...io.output import toml_text
from ...studies.common.report import Report
from ..command import Arguments, Parser, results
from ..inputs import warn_of_doubts

_BEGINNING = "# Imported by stewart-sym"


def add_arguments(parser: Parser) -> None:
    parser.file("model")
    parser.output("ROBOT.toml", "robot file; - for standard output")


def run(arguments: Arguments) -> None:
    with results(arguments, beginnings=[_BEGINNING]) as (take, _):
        found = ss.import_model(arguments.model)
        tables = found.robot.to_dict()
        lines = [f"{_BEGINNING} from {safe_text(arguments.model.name)}."]
        lines += [f"# {safe_text(line)}" for line in found.assumptions]
        text = "\n".join(lines) + "\n" + toml_text(tables)
        warn_of_doubts(found.robot, arguments.output)
        data = {"assumptions": found.assumptions, "robot": tables}
        take(Report("\n".join(found.assumptions), data=data), text)
