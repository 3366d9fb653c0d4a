"""Compute the force, speed, power, and stroke that motions require of each leg.

All trajectories are evaluated together; columns as for `forces`.
The report lists peaks, quantiles over time, and largest values with a margin, also for motors.
It names limits that are exceeded, exceeded with the margin, or inconclusive due to noise.
The report has the units of the robot file; the table has SI units.

Example: stewart-sym size-actuators hexapod.toml trajectory.csv -o size --margin 0.3
"""

from dataclasses import replace
from functools import partial

import stewart_sym as ss

from ...design.actuator_requirements import QUANTILES, actuator_requirements
from ...io.error_policy import warn
from ...studies.design.actuator_report import doubts, report
from ..command import Arguments, Parser, finite, positive, results
from ..inputs import robot_of, trajectory_of

_MOST_MARGIN = 5.0
"""Margin above which a percentage was probably meant."""


def add_arguments(parser: Parser) -> None:
    parser.file("robot")
    parser.file("trajectory", "trajectories", nargs="+")
    text = "fraction by which each limit should exceed the required value"
    parser.valued("margin", finite, text, 0.25, "FRACTION")
    text = (
        "fraction of the time (at most 1) for which the listed value is sufficient; may be repeated; "
        "default: 0.5, 0.9, 0.99, and 1"
    )
    parser.add_argument("--quantile", action="append", type=positive, metavar="FRACTION", help=text)
    parser.formulation()
    parser.log()
    parser.output("DIR", "folder of the results", "size", plots=True, html=True)


def run(arguments: Arguments) -> None:
    margin, quantiles = arguments.margin, arguments.quantile or QUANTILES
    if margin > _MOST_MARGIN:
        warn(f"--margin: {margin:g} means {100.0 * margin:g} %; use 0.25 for 25 %")
    robot = robot_of(arguments.robot)
    with results(arguments, "report", "needs.csv") as (take, progress):
        read = [trajectory_of(robot, path, arguments, progress) for path in arguments.trajectories]
        needs = actuator_requirements(robot, read, margin, quantiles, arguments.formulation, progress)
        names = [path.name for path in arguments.trajectories]
        views = {
            f"motion {i}: {name}": partial(ss.view, robot, read[i - 1]) for i, name in enumerate(names, 1)
        }
        take(replace(report(robot, names, needs), views=views))
    for text in doubts(robot, needs, arguments.robot):
        warn(text)
