"""``stewart-sym export``: write a robot as a model of another program."""

import argparse
import contextlib
from pathlib import Path

from ..inputs import robot_of
from ..options import output, robot_file
from ..output import reject_inputs, results

HELP = "write a robot for MuJoCo, Gazebo, Drake, ROS, Pinocchio, or Isaac Sim"
EXAMPLE = "stewart-sym export hexapod.toml --format mjcf -o hexapod.xml"
MORE = (
    "The model is at the home pose, with a free platform and six spherical loop closures.\n"
    "Quantities without a place in the format are stored in a note, which only `import` reads.\n"
    "Loops of a URDF file are written to NAME.loops.json."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser)
    parser.add_argument(
        "--format",
        choices=("mjcf", "sdf", "drake", "urdf", "usd"),
        required=True,
        help="format; mjcf: MuJoCo; sdf: Gazebo; drake: Drake (SDF with ball constraints); "
        "urdf: ROS, Pinocchio, Drake; usd: Isaac Sim, as text",
    )
    output(parser, "FILE", "model file; - for standard output", None)


def run(arguments: argparse.Namespace) -> int:
    from ...exchange.files import BEGINNINGS, export_model, loops_path
    from ...io.atomic_write import result_file
    from ...studies.common.report import Report

    path: Path = arguments.output
    printed = str(path) == "-"
    if printed and arguments.format == "urdf":
        raise ValueError("-o -: a URDF model consists of two files; name a file")
    with results(arguments) as (take, _), contextlib.ExitStack() as stack:
        if arguments.format == "urdf":
            reject_inputs("-o", loops_path(path), arguments.robot)
        try:
            file = export_model(robot_of(arguments.robot), arguments.format)
        except ValueError as error:
            text = str(error)
            where = "" if text.startswith(str(arguments.robot)) else f"{arguments.robot}: "
            raise ValueError(f"{where}{text}") from None
        texts = {path: file.text} | (
            {} if file.loop_closures is None else {loops_path(path): file.loop_closures}
        )
        for name, text in texts.items():
            stack.enter_context(result_file(name, BEGINNINGS, arguments.force)).write(text)
        written = [str(name) for name in texts]
        said = "" if printed else f"Written to {', '.join(written)}"
        take(Report(said, data={"format": arguments.format, "files": written}))
    return 0
