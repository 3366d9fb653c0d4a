"""Write a robot for MuJoCo, Gazebo, Drake, ROS, Pinocchio, or Isaac Sim.

The model is at the home pose, with a free platform and six spherical loop closures.
Quantities without a place in the format are stored in a note, which only `import` reads.
Loops of a URDF file are written to NAME.loops.json.

Example: stewart-sym export hexapod.toml --format mjcf -o hexapod.xml
"""

from pathlib import Path

import stewart_sym as ss

from ...exchange.files import BEGINNINGS, loops_path
from ...io.error_policy import errors_of
from ...io.output import write_file
from ...studies.common.report import Report
from ..command import Arguments, Parser, need_own_file, results
from ..inputs import robot_of


def add_arguments(parser: Parser) -> None:
    parser.file("robot")
    text = (
        "format; mjcf: MuJoCo; sdf: Gazebo; drake: Drake (SDF with ball constraints); urdf: ROS, Pinocchio, "
        "Drake; usd: Isaac Sim, as text"
    )
    formats = ("mjcf", "sdf", "drake", "urdf", "usd")
    parser.add_argument("--format", choices=formats, required=True, help=text)
    parser.output("FILE", "model file; - for standard output")


def run(arguments: Arguments) -> None:
    path: Path = arguments.output
    if str(path) == "-" and arguments.format == "urdf":
        raise ValueError("-o -: a URDF model consists of two files; name a file")
    with results(arguments, beginnings=BEGINNINGS) as (take, _):
        if arguments.format == "urdf":
            need_own_file(loops_path(path), BEGINNINGS, arguments.force, [arguments.robot])
        robot = robot_of(arguments.robot)
        with errors_of(f"{arguments.robot}: "):
            file = ss.export_model(robot, arguments.format)
        files, text = [str(path)], ""
        if file.loop_closures is not None:
            write_file(loops_path(path), file.loop_closures)
            files.append(str(loops_path(path)))
            text = f"Written to {files[-1]}"
        take(Report(text, data={"format": arguments.format, "files": files}), file.text)
