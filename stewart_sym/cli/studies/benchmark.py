"""Compare kernel times with CasADi, Pinocchio, and MuJoCo.

All results are compared before the timing.
Packages that are not installed (extra `bench`) are omitted.
The study takes about four minutes on an idle machine.

Example: stewart-sym benchmark -o bench
"""

import argparse
from pathlib import Path

from ..inputs import robot_of
from ..options import PAPERS, flag, output, robot_file
from ..output import need_drawing, results


def add_arguments(parser: argparse.ArgumentParser) -> None:
    flag(parser, "quick", "use fewer rounds and smaller batches")
    robot_file(parser, "--robot", PAPERS)
    output(parser, "DIR", "folder of the results", Path("bench"), html=True)


def run(arguments: argparse.Namespace) -> int:
    from ...studies.benchmark.benchmark import benchmark, full_report

    need_drawing()
    robot = None if arguments.robot is None else robot_of(arguments.robot)
    with results(arguments, "bench") as (take, progress):
        take(full_report(benchmark(robot, arguments.quick, progress)))
    return 0
