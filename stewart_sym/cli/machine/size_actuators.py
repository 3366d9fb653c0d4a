"""Compute the force, speed, power, and stroke that motions require of each leg.

All trajectories count together; columns as for `forces`.
The report lists peaks, quantiles over time, and largest values with a margin, also for motors.
It names limits that are exceeded, lack the margin, or are undecided due to noise. SI units, degrees.

Example: stewart-sym size-actuators hexapod.toml trajectory.csv -o size --margin 0.3
"""

import argparse
import dataclasses
from pathlib import Path

from ...design.actuator_requirements import QUANTILES, actuator_requirements
from ...design.limit_margins import compared
from ...io.error_policy import warn
from ...studies.design.actuator_report import doubt, report, views
from ..inputs import robot_of, trajectory_of
from ..options import finite, formulation, log_options, output, positive, robot_file, trajectory_files, valued
from ..output import results

_MOST_MARGIN = 5.0
"""Margin above which a percentage was probably meant."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser)
    trajectory_files(parser, "trajectories", nargs="+")
    text = "fraction by which each limit should exceed the required value"
    valued(parser, "margin", finite, text, 0.25, "FRACTION")
    text = (
        "fraction of the time (at most 1) for which the listed value is sufficient; may be repeated; "
        "default: 0.5, 0.9, 0.99, and 1"
    )
    parser.add_argument("--quantile", action="append", type=positive, metavar="FRACTION", help=text)
    formulation(parser)
    log_options(parser)
    output(parser, "DIR", "folder of the results", Path("size"), plots=True, html=True)


def run(arguments: argparse.Namespace) -> int:
    margin, quantiles = arguments.margin, arguments.quantile or QUANTILES
    if margin > _MOST_MARGIN:
        warn(f"--margin: {margin:g} means {100.0 * margin:g} %; use 0.25 for 25 %")
    robot = robot_of(arguments.robot)
    with results(arguments, "report", "needs.csv") as (take, progress):
        read = [trajectory_of(robot, path, arguments, progress) for path in arguments.trajectories]
        needs = actuator_requirements(robot, read, margin, quantiles, arguments.formulation, progress)
        names = [path.name for path in arguments.trajectories]
        take(dataclasses.replace(report(robot, names, needs), views=views(robot, names, read)))
    unknown = doubt(needs)
    if unknown is not None:
        warn(unknown)
    over, unsure, short, perhaps = compared(robot, needs)
    lines = over + unsure + short + perhaps
    if lines:
        told = f"limits exceeded: {len(over)}, limits without the margin: {len(short)}"
        told += f", not decided: {len(unsure)}" if unsure else ""
        told += f", margin not decided: {len(perhaps)}" if perhaps else ""
        warn(f"{arguments.robot}: {told}; {lines[0]}")
    return 0
