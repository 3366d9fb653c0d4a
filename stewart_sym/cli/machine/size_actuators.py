"""``stewart-sym size-actuators``: what motions and their loads need of every actuator and joint."""

import argparse
import dataclasses
from pathlib import Path

from ...io.error_policy import warn
from ..inputs import robot_of, trajectory_of
from ..options import finite, formulation, log_options, output, positive, robot_file, valued
from ..output import results

HELP = "which force, speed, power, stroke and joint angles motions need of every leg, beside its limits"
EXAMPLE = "stewart-sym size-actuators hexapod.toml trajectory.csv -o size --margin 0.3"
MORE = (
    "Trajectories as for forces, with their loads; all of them count together. Peaks, what is not exceeded "
    "for shares of the time, and the largest of each with a margin; limits of the robot file that are "
    "exceeded, or kept without the margin, are named. Of a robot with drives: torque, speed and power of the "
    "motors as well. With noise in a log, needs have standard deviations, and limits within three of them, "
    "without or with the margin, are reported as not decided. SI units, degrees."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser)
    parser.add_argument(
        "trajectories", metavar="TRAJECTORY.csv", nargs="+", type=Path, help="times and poses, or leg lengths"
    )
    valued(parser, "margin", finite, "share that a limit should exceed the need by", 0.25, "SHARE")
    parser.add_argument(
        "--quantile",
        dest="quantiles",
        action="append",
        type=positive,
        metavar="SHARE",
        help="share of the time, 1 at most, for which sizes are not exceeded; may be repeated; "
        "default: 0.5, 0.9, 0.99 and 1",
    )
    formulation(parser)
    log_options(parser)
    output(parser, "DIR", "folder to write to", Path("size"), plots=True, html=True)


# A margin beyond it was meant in per cent.
_MOST_MARGIN = 5.0


def run(arguments: argparse.Namespace) -> int:
    from ...design.actuator_requirements import QUANTILES, actuator_requirements, checked_quantiles
    from ...design.limit_margins import compared
    from ...studies.design.actuator_report import doubt, report, views

    quantiles = arguments.quantiles or QUANTILES
    checked_quantiles(quantiles, "--quantile")
    if arguments.margin > _MOST_MARGIN:
        share = f"{arguments.margin:g} is a share, {100.0 * arguments.margin:g} %"
        warn(f"--margin: {share}: expected 0.25 for 25 %")
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
        told += f", not decided: {len(unsure)}" if unsure else ""
        told += f", margin not decided: {len(perhaps)}" if perhaps else ""
        warn(f"{arguments.robot}: {told}; {lines[0]}")
    return 0
