"""``stewart-sym controller``: kernels on a microcontroller."""

import argparse

from ..inputs import robot_of
from ..options import PAPERS, output, robot_file, valued
from ..output import results

HELP = "run kernels on an emulated microcontroller: forces, instructions, flash, stack"
EXAMPLE = "stewart-sym controller hexapod.toml -o controller"
MORE = (
    "One-pose kernels, general and baked, run on Arm Cortex-M7 (double) and Cortex-M4F (float).\n"
    "Requires arm-none-eabi-gcc with newlib and qemu-system-arm.\n"
    "Exit code: 0, or 2 if a result is wrong. The study takes ten seconds."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser, default=PAPERS, nargs="?")
    valued(parser, "fidelity", str, "fidelity level of `generate`", "general", "LEVEL")
    output(parser, "DIR", "folder of the table and controller.json", "no files")


def run(arguments: argparse.Namespace) -> int:
    from ...robots import dasgupta1998
    from ...studies.microcontroller import measure
    from ...studies.microcontroller.microcontroller_report import full_report

    robot = dasgupta1998() if arguments.robot is None else robot_of(arguments.robot)
    with results(arguments, "controller") as (take, progress):
        found = measure.study(robot, progress, arguments.fidelity)
        take(full_report(found))
    return 0 if all(map(measure.right, found["rows"])) else 2
