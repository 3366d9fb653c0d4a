"""``stewart-sym chart``: cost and accuracy as pictures."""

import argparse
from pathlib import Path

from ..inputs import warn_of_doubts
from ..options import output
from ..output import results

HELP = "draw time per pose over error, of the model and of rounding: pictures, CSV, JSON, table"
EXAMPLE = "stewart-sym chart enough.toml -o chart"
MORE = (
    "chart.png: every fidelity and implementation is a point; scales.png: rounding over size and mass"
    " of machines like this one; bounds.png: rounding and its bound. Each as SVG and CSV, too. The "
    "scene is one of `choose-fidelity`; without it: the paper's machine on its Paths I, II and III. Takes "
    "about a minute."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("scene", metavar="SCENE.toml", type=Path, nargs="?", help="scene file, schema 1")
    output(parser, "DIR", "folder to write to", Path("chart"), plots=True)


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
