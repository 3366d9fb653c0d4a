"""``stewart-sym chart``: charts of cost and accuracy."""

import argparse
from pathlib import Path

from ..inputs import warn_of_doubts
from ..options import output
from ..output import results

HELP = "draw time per pose over the error of model and rounding"
EXAMPLE = "stewart-sym chart enough.toml -o chart"
MORE = (
    "chart.png: all fidelity levels and implementations.\n"
    "scales.png: rounding errors over size and mass of the machine.\n"
    "bounds.png: rounding errors and their bounds.\n"
    "Each chart is also written as SVG and CSV. The study takes about a minute."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "scene",
        metavar="SCENE.toml",
        type=Path,
        nargs="?",
        help="scene file of `choose-fidelity`; default: the robot of the paper on Paths I, II, and III",
    )
    output(parser, "DIR", "folder of the results", Path("chart"), plots=True)


def run(arguments: argparse.Namespace) -> int:
    from ...robots import dasgupta1998
    from ...studies.accuracy.budget import papers_motions, read_budget
    from ...studies.accuracy.charts import full_report
    from ...studies.accuracy.cost import ROUNDS, cost

    robot, motions = dasgupta1998(), papers_motions()
    read: tuple[Path, ...] = ()
    if arguments.scene is not None:
        scene = read_budget(arguments.scene)
        robot, motions, read = scene.robot, dict(scene.motions), scene.files
        warn_of_doubts(robot, arguments.scene)
    with results(arguments, "chart", read=read) as (take, progress):
        found = cost(robot, motions, True, ROUNDS, progress)
        take(full_report(found, robot, progress))
    return 0
