"""``stewart-sym controller``: kernels on a microcontroller."""

import argparse

from ..inputs import robot_of
from ..options import PAPERS, output, robot_file, valued
from ..output import results

HELP = "kernels for a machine on a microcontroller, under emulation: forces, instructions, flash, stack"
EXAMPLE = "stewart-sym controller hexapod.toml -o controller"
MORE = (
    "Writes one-pose kernels, general and with the machine's numbers folded in, cross-compiles them for Arm "
    "Cortex-M7 (double) and Cortex-M4F (float) and runs them under QEMU: forces against 50-digit ones, "
    "statuses of invalid calls, executed instructions, stack; flash, and which library functions the "
    "objects need; of a robot with a drive the motors' torques as well. Needs arm-none-eabi-gcc with newlib "
    "and qemu-system-arm (Debian: gcc-arm-none-eabi, libnewlib-arm-none-eabi, qemu-system-arm). Exit code 2 "
    "where anything is not right. Takes some ten seconds."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser, default=PAPERS, nargs="?")
    valued(parser, "fidelity", str, "a level of `generate`", "general", "LEVEL")
    output(parser, "DIR", "folder for the table and controller.json", "none written")


def run(arguments: argparse.Namespace) -> int:
    from ...robots import dasgupta1998
    from ...studies.microcontroller import measure
    from ...studies.microcontroller.microcontroller_report import full_report

    robot = dasgupta1998() if arguments.robot is None else robot_of(arguments.robot)
    with results(arguments, "controller") as (take, progress):
        found = measure.study(robot, progress, arguments.fidelity)
        take(full_report(found))
    return 0 if all(map(measure.right, found["rows"])) else 2
