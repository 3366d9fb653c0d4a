"""``stewart-sym control``: controllers that differ in their model."""

import argparse
from pathlib import Path

from ...io.error_policy import warn
from ..inputs import robot_of
from ..options import PAPERS, output, positive, robot_file, valued
from ..output import results

HELP = "compare controllers with different models on the paths of the paper"
EXAMPLE = "stewart-sym control -o control --path II"
MORE = (
    "The plant is `exact`. Models: `exact`, `paper`, the platform alone, and gravity compensation.\n"
    "Default: the robot of the paper, as printed and with larger friction. The study takes half a minute."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--path", choices=("I", "II"), help="path of the paper; default: both")
    robot_file(parser, "--robot", PAPERS)
    valued(parser, "rate", positive, "sampling rate of the controllers (Hz)", 1000.0, "HZ")
    output(parser, "DIR", "folder of the results", Path("control"), plots=True)


def run(arguments: argparse.Namespace) -> int:
    from ...studies.control import control
    from ...studies.control.report import full_report

    machines = control.papers_machines()
    if arguments.robot is not None:
        machines = {"robot": robot_of(arguments.robot)}
    paths = control.TRACKED if arguments.path is None else (arguments.path,)
    settings = control.Settings(rate=arguments.rate)
    with results(arguments, "control", "control.csv") as (take, progress):
        studies = {
            label: control.track_paths(robot, paths, settings, progress) for label, robot in machines.items()
        }
        take(full_report(studies))
    for study in studies.values():
        for line in study.exceeded:
            warn(line)
    return 0
