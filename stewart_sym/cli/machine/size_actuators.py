"""``stewart-sym size-actuators``: required force, speed, power, and stroke of each actuator."""

import argparse
import dataclasses
from pathlib import Path

from ...io.error_policy import warn
from ..inputs import robot_of, trajectory_of
from ..options import finite, formulation, log_options, output, positive, robot_file, valued
from ..output import results

HELP = "compute the force, speed, power, and stroke that motions require of each leg"
EXAMPLE = "stewart-sym size-actuators hexapod.toml trajectory.csv -o size --margin 0.3"
MORE = (
    "All trajectories count together; columns as for `forces`.\n"
    "The report lists peaks, quantiles over time, and largest values with a margin, also for motors.\n"
    "It names limits that are exceeded, lack the margin, or are undecided due to noise. SI units, degrees."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser)
    parser.add_argument(
        "trajectories",
        metavar="TRAJECTORY.csv",
        nargs="+",
        type=Path,
        help="CSV files of times and poses or leg lengths",
    )
    text = "fraction by which each limit should exceed the required value"
    valued(parser, "margin", finite, text, 0.25, "FRACTION")
    parser.add_argument(
        "--quantile",
        dest="quantiles",
        action="append",
        type=positive,
        metavar="FRACTION",
        help="fraction of the time (at most 1) for which the listed value is sufficient; may be repeated; "
        "default: 0.5, 0.9, 0.99, and 1",
    )
    formulation(parser)
    log_options(parser)
    output(parser, "DIR", "folder of the results", Path("size"), plots=True, html=True)


# A larger margin was probably meant as a percentage.
_MOST_MARGIN = 5.0


def run(arguments: argparse.Namespace) -> int:
    from ...design.actuator_requirements import QUANTILES, actuator_requirements, checked_quantiles
    from ...design.limit_margins import compared
    from ...studies.design.actuator_report import doubt, report, views

    quantiles = arguments.quantiles or QUANTILES
    checked_quantiles(quantiles, "--quantile")
    if arguments.margin > _MOST_MARGIN:
        fraction = f"{arguments.margin:g} means {100.0 * arguments.margin:g} %"
        warn(f"--margin: {fraction}; use 0.25 for 25 %")
    robot = robot_of(arguments.robot)
    with results(arguments, "report", "needs.csv") as (take, progress):
        read = [trajectory_of(robot, path, arguments, progress) for path in arguments.trajectories]
        needs = actuator_requirements(
            robot, read, arguments.margin, quantiles, arguments.formulation, progress
        )
        names = [path.name for path in arguments.trajectories]
        found = report(robot, names, needs)
        take(dataclasses.replace(found, views=views(robot, names, read)))
    unknown = doubt(needs)
    if unknown is not None:
        warn(unknown)
    over, unsure, short, perhaps = compared(robot, needs)
    lines = over + unsure + short + perhaps
    if lines:
        told = f"limits exceeded: {len(over)}, limits without the margin: {len(short)}"
        told += f", inconclusive: {len(unsure)}" if unsure else ""
        told += f", margin inconclusive: {len(perhaps)}" if perhaps else ""
        warn(f"{arguments.robot}: {told}; {lines[0]}")
    return 0
