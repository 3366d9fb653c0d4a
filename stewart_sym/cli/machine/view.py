"""Show a machine in motion as one HTML file.

MOTION is a path of the paper (I, II, III), a CSV file as for `forces`, or the folder of `simulate` or `plan`.
The default is the home pose. Without -o, the file is opened in a browser.
Limits of legs and motors are compared as in `forces`.

Example: stewart-sym view hexapod.toml trajectory.csv -o machine.html
"""

import sys
import webbrowser
from pathlib import Path

import stewart_sym as ss

from ...io.error_policy import warn
from ...io.progress import Progress
from ...studies.common.report import Report
from ...studies.reports.force_report import view_data
from ...viewer.motion_history import is_run_file, read_run
from ...viewer.page import BEGINNING
from ..command import Arguments, Parser, results
from ..inputs import robot_of, trajectory_of

_FILES = ("run.csv", "trajectory.csv")
_DEFAULT = Path("machine.html")


def add_arguments(parser: Parser) -> None:
    parser.file("robot", nargs="?")
    text = "I, II, III, a CSV file, or the folder of a simulation or plan"
    parser.add_argument("motion", metavar="MOTION", nargs="?", help=text)
    parser.flag("example", "show the robot of the paper on its Path I")
    parser.log()
    parser.output("FILE.html", "HTML file; - for standard output", otherwise=str(_DEFAULT))


def run(arguments: Arguments) -> None:
    if arguments.example == (arguments.robot is not None):
        raise ValueError("ROBOT.toml: expected either a robot file or --example, the robot of the paper")
    shown_at_once = arguments.output is None
    path = arguments.output = arguments.output or _DEFAULT
    read = [] if arguments.motion is None else [Path(arguments.motion)]
    with results(arguments, read=read, beginnings=[BEGINNING]) as (take, progress):
        robot = ss.robots.dasgupta1998() if arguments.example else robot_of(arguments.robot)
        shown = _viewer(robot, arguments, progress)
        progress("writing the page")
        take(Report(shown.title, data=view_data(shown)), shown.html)
    for _, line in shown.limits.told:
        warn(line)
    if shown_at_once and not webbrowser.open(path.resolve().as_uri()):
        print(f"no browser found; open {path.resolve()} in a browser", file=sys.stderr)


def _viewer(robot: ss.Robot, arguments: Arguments, progress: Progress) -> ss.Viewer:
    name = "I" if arguments.example else arguments.motion
    if name is None or name in ss.PAPER_PATHS:
        return ss.view(robot, name)
    path = next((file for each in _FILES if (file := Path(name, each)).exists()), Path(name))
    if path.is_dir() or not path.exists():
        raise ValueError(f"{path}: expected I, II, III, a CSV file, or the folder of simulate or plan")
    if is_run_file(path):
        progress("reading the run")
        return ss.view(robot, read_run(robot, path))
    trajectory = trajectory_of(robot, path, arguments, progress)
    progress("computing forces and singular poses")
    return ss.view(robot, trajectory)
