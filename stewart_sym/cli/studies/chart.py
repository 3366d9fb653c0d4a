"""Draw time per pose over the error of model and rounding.

chart.png, chart.svg, and chart.csv contain all fidelity levels and implementations.
The study takes about a minute.

Example: stewart-sym chart enough.toml -o chart
"""

from pathlib import Path

import stewart_sym as ss

from ..command import Arguments, Parser, results
from ..inputs import warn_of_doubts


def add_arguments(parser: Parser) -> None:
    text = "scene file of `choose-fidelity`; default: the robot of the paper on Paths I, II, and III"
    parser.file("scene", nargs="?", help=text)
    parser.output("DIR", "folder of the results", "chart", plots=True)


def run(arguments: Arguments) -> None:
    from ...studies.accuracy.budget import papers_motions, read_budget
    from ...studies.accuracy.cost import ROUNDS, cost
    from ...studies.accuracy.cost_plot import full_report

    robot, motions = ss.robots.dasgupta1998(), papers_motions()
    read: tuple[Path, ...] = ()
    if arguments.scene is not None:
        scene = read_budget(arguments.scene)
        robot, motions, read = scene.robot, dict(scene.motions), scene.files
        warn_of_doubts(robot, arguments.scene)
    with results(arguments, "chart", read=read) as (take, progress):
        take(full_report(cost(robot, motions, True, ROUNDS, progress)))
