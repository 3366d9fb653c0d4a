"""Find singular poses along a path and their unconstrained twists.

Between samples of a trajectory, the path is the quintic through poses, rates, and accelerations.
Output: report, table of the path, and drawings.
The report has the units of the robot file; the table has SI units.

Example: stewart-sym singularities hexapod.toml trajectory.csv -o singularities
"""

from pathlib import Path

import stewart_sym as ss

from ...kinematics.mounting_side import path_for
from ...motion.interpolation import Path as MotionPath
from ...studies.reports import singularities
from ..command import Arguments, Parser, results
from ..inputs import robot_of, trajectory_of


def add_arguments(parser: Parser) -> None:
    parser.file("robot")
    text = "I, II, or III (paths of the paper), or a CSV file as for `forces`"
    parser.add_argument("path", metavar="PATH", help=text)
    parser.formulation()
    parser.log()
    parser.output("DIR", "folder of the results", "singularities", plots=True)


def run(arguments: Arguments) -> None:
    robot = robot_of(arguments.robot)
    name, file = arguments.path, Path(arguments.path)
    read = [] if name in ss.PAPER_PATHS else [file]
    with results(arguments, "report", "path.csv", read=read) as (take, progress):
        path: MotionPath
        if name in ss.PAPER_PATHS:
            line = path_for(robot, name).path
            path, times = line.sample, line.breakpoints()
        else:
            if not file.exists():
                raise ValueError(f"{name}: expected I, II, III, or a CSV file; the file does not exist")
            trajectory = trajectory_of(robot, file, arguments, progress)
            path, times = ss.interpolate(trajectory), trajectory.time
        progress("looking for singular poses")
        found = singularities.Examination(robot, file.name, path, times, arguments.formulation)
        take(singularities.full_report(found))
