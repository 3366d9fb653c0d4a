"""Draw time per pose over the error of model and rounding.

chart.png, chart.svg, and chart.csv contain all fidelity levels and implementations.
The study takes about a minute.

Example: stewart-sym chart enough.toml -o chart
"""

import stewart_sym as ss

from ..command import Arguments, Parser, results
from ..inputs import warn_of_doubts


def add_arguments(parser: Parser) -> None:
    text = "scene file of `choose-fidelity`; default: the robot of the paper on Paths I, II, and III"
    parser.file("scene", nargs="?", help=text)
    parser.output("DIR", "folder of the results", "chart", plots=True)


def run(arguments: Arguments) -> None:
    from ...studies.accuracy.budget import Budget, papers_motions, read_budget
    from ...studies.accuracy.cost import ROUNDS, cost
    from ...studies.accuracy.cost_plot import full_report

    scene = Budget(ss.robots.dasgupta1998(), papers_motions(), 1.0)
    if arguments.scene is not None:
        scene = read_budget(arguments.scene)
        warn_of_doubts(scene.robot, arguments.scene)
    with results(arguments, "chart", read=scene.files) as (take, progress):
        take(full_report(cost(scene.robot, scene.motions, True, ROUNDS, progress)))
