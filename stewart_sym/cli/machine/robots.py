"""``stewart-sym robots``: machines that come with the package."""

import argparse

from ..options import output
from ..output import results

HELP = "list, show or copy the machines that come with the package"
EXAMPLE = "stewart-sym robots --show tsai2000 -o tsai2000.toml"
MORE = "Each file cites its source and says what is assumed. In Python: ss.robots.NAME()."


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--show", metavar="NAME", help="print the robot file of this machine")
    output(parser, "ROBOT.toml", "with --show: file to write a copy to", "standard output")


def run(arguments: argparse.Namespace) -> int:
    from ...io.arguments import option
    from ...io.atomic_write import result_file
    from ...robots import NAMES, load, text
    from ...studies.common.output import aligned
    from ...studies.common.report import Report

    if arguments.show is None:
        if arguments.output is not None:
            raise ValueError("-o: is for a copy of one machine, expected --show NAME")
        robots = {name: load(name) for name in NAMES}
        rows = [[name, robot.name, f"{robot.M:.4g}"] for name, robot in robots.items()]
        data = {name: {"name": robot.name, "platform_mass_kg": robot.M} for name, robot in robots.items()}
        with results(arguments) as (take, _):
            take(Report(aligned(["name", "machine", "platform, kg"], rows, left=2), data={"robots": data}))
        return 0
    option(arguments.show, NAMES, "--show")
    copy = text(arguments.show)
    shown = {"name": arguments.show, "text": copy}
    with results(arguments) as (take, _):
        if arguments.output is None:
            take(Report(copy, data=shown))
        else:
            with result_file(arguments.output, [copy], arguments.force) as stream:
                stream.write(copy)
            take(Report(f"Written to {arguments.output}", data=shown))
    return 0
