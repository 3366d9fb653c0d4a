"""``stewart-sym benchmark``: times of the kernels and of the baselines."""

import argparse
from pathlib import Path

from ..inputs import robot_of
from ..options import PAPERS, output, robot_file
from ..output import need_drawing, results

HELP = "time the kernels beside CasADi, Drake, Pinocchio, MuJoCo, JAX and the processor's limit"
EXAMPLE = "stewart-sym benchmark -o bench"
MORE = (
    "Results are compared before anything is timed. Whichever of CasADi, Drake, Pinocchio, MuJoCo and JAX "
    "(extra bench) is not installed is left out. Takes three minutes or four on an otherwise idle machine."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--quick", action="store_true", help="fewer rounds and smaller batches")
    robot_file(parser, "--robot", PAPERS)
    output(parser, "DIR", "folder to write to", Path("bench"), html=True)


def run(arguments: argparse.Namespace) -> int:
    from ...studies.benchmark.bench import bench
    from ...studies.benchmark.plot import full_report

    need_drawing()
    robot = None if arguments.robot is None else robot_of(arguments.robot)
    with results(arguments, "bench") as (take, progress):
        take(full_report(bench(robot, arguments.quick, progress)))
    return 0
