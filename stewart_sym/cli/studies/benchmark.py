"""Measure the time per pose of every kernel.

All results are compared with the vector reference before the timing.
The study takes about two minutes on an idle machine.

Example: stewart-sym benchmark -o bench
"""

from ...io.error_policy import need
from ..command import Arguments, Parser, results
from ..inputs import robot_of


def add_arguments(parser: Parser) -> None:
    parser.flag("quick", "use fewer rounds and smaller batches")
    parser.file("robot", "--robot", help="robot file; default: the robot of the paper")
    parser.output("DIR", "folder of the results", "bench", html=True)


def run(arguments: Arguments) -> None:
    from ...studies.benchmark.benchmark import benchmark, full_report

    need("matplotlib", "drawing")
    robot = None if arguments.robot is None else robot_of(arguments.robot)
    with results(arguments, "bench") as (take, progress):
        take(full_report(benchmark(robot, arguments.quick, progress)))
