"""``stewart-sym singularities``: singular poses along a path."""

import argparse
from pathlib import Path

from ..inputs import robot_of, trajectory_of
from ..options import formulation, log_options, output, robot_file
from ..output import results

HELP = "find singular poses along a path and their unconstrained twists"
EXAMPLE = "stewart-sym singularities hexapod.toml trajectory.csv -o singularities"
MORE = (
    "Between samples of a trajectory, the path is the quintic through poses, rates, and accelerations.\n"
    "Output: report, tables of events and of the path, and drawings. SI units."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser)
    parser.add_argument(
        "path", metavar="PATH", help="I, II, or III (paths of the paper), or a CSV file as for `forces`"
    )
    formulation(parser)
    log_options(parser)
    output(parser, "DIR", "folder of the results", Path("singularities"), plots=True)


def run(arguments: argparse.Namespace) -> int:
    from ...kinematics.mounting import path_for
    from ...motion.interpolation import Path as MotionPath
    from ...motion.interpolation import interpolate
    from ...motion.straight_line import PAPER_PATHS
    from ...studies.reports import singularities
    from ...studies.reports.singularities_plot import pictures

    robot = robot_of(arguments.robot)
    name = arguments.path
    read = [] if name in PAPER_PATHS else [Path(name)]
    tables = ("events.csv", "path.csv")
    with results(arguments, "report", *tables, read=read) as (take, progress):
        if name in PAPER_PATHS:
            if arguments.pose_guess is not None:
                raise ValueError("--pose-guess: the trajectory contains poses; omit the option")
            line = path_for(robot, name).path
            path: MotionPath = line.sample
            times = line.breakpoints()
        else:
            if not Path(name).exists():
                raise ValueError(f"{name}: expected I, II, III, or a CSV file; the file does not exist")
            trajectory = trajectory_of(robot, Path(name), arguments, progress)
            path, times, name = interpolate(trajectory), trajectory.time, Path(name).name
        progress("looking for singular poses")
        found = singularities.examine(robot, name, path, times, arguments.formulation)
        take(singularities.full_report(found, pictures(found)))
    return 0
