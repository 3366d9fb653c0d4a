"""``stewart-sym robots``: robots of the package."""

import argparse

from ..options import output
from ..output import results

HELP = "list, print, or copy the robots of the package"
EXAMPLE = "stewart-sym robots --show tsai2000 -o tsai2000.toml"
MORE = "Each file cites its source and marks its assumptions.\nIn Python: ss.robots.NAME()."


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--show", metavar="NAME", help="name of the robot whose file is printed")
    output(parser, "ROBOT.toml", "copy of the file of --show", "standard output")


def run(arguments: argparse.Namespace) -> int:
    from ...io.arguments import option
    from ...io.atomic_write import result_file
    from ...robots import NAMES, load, text
    from ...studies.common.output import aligned
    from ...studies.common.report import Report

    if arguments.show is None:
        if arguments.output is not None:
            raise ValueError("-o: requires the name of a robot; add --show NAME")
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
