"""``stewart-sym export``: write a robot as a model of another program."""

import argparse
import contextlib
from pathlib import Path

from ..inputs import robot_of
from ..options import output, robot_file
from ..output import reject_inputs, results

HELP = "write the machine for MuJoCo, Gazebo, Drake, ROS, Pinocchio, or Isaac Sim"
EXAMPLE = "stewart-sym export hexapod.toml --format mjcf -o hexapod.xml"
MORE = (
    "The machine stands at its home pose, the platform free, closed by six spherical joints. Friction, "
    "limits, actuators, shapes and gravity are written where the format has a place for them; the rest is a "
    "note in the file, which import reads and the other program does not. A URDF gets a second file with its "
    "loops, NAME.loops.json."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser)
    parser.add_argument(
        "--format",
        choices=("mjcf", "sdf", "drake", "urdf", "usd"),
        required=True,
        help="mjcf: MuJoCo; sdf: Gazebo; drake: Drake, as SDF with its ball constraints; "
        "urdf: ROS, Pinocchio, Drake; usd: Isaac Sim, as text",
    )
    output(parser, "FILE", "file to write, - for standard output", None)


def run(arguments: argparse.Namespace) -> int:
    from ...exchange.files import BEGINNINGS, export_model, loops_path
    from ...io.atomic_write import result_file
    from ...studies.common.report import Report

    path: Path = arguments.output
    printed = str(path) == "-"
    if printed and arguments.format == "urdf":
        raise ValueError("-o -: expected a file, a URDF is two files")
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
