"""``stewart-sym benchmark``: execution times of the kernels and of the baselines."""

import argparse
from pathlib import Path

from ..inputs import robot_of
from ..options import PAPERS, output, robot_file
from ..output import need_drawing, results

HELP = "compare kernel times with CasADi, Drake, Pinocchio, MuJoCo, JAX, and the processor limit"
EXAMPLE = "stewart-sym benchmark -o bench"
MORE = (
    "All results are compared before the timing.\n"
    "Packages that are not installed (extra `bench`) are omitted.\n"
    "The study takes about four minutes on an idle machine."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--quick", action="store_true", help="use fewer rounds and smaller batches")
    robot_file(parser, "--robot", PAPERS)
    output(parser, "DIR", "folder of the results", Path("bench"), html=True)


def run(arguments: argparse.Namespace) -> int:
    from ...studies.benchmark.bench import bench
    from ...studies.benchmark.plot import full_report

    need_drawing()
    robot = None if arguments.robot is None else robot_of(arguments.robot)
    with results(arguments, "bench") as (take, progress):
        take(full_report(bench(robot, arguments.quick, progress)))
    return 0
