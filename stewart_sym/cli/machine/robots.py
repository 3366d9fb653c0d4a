"""List, print, or copy the robots of the package.

Each file cites its source and marks its assumptions.
In Python: ss.robots.NAME().

Example: stewart-sym robots --show tsai2000 -o tsai2000.toml
"""

import stewart_sym as ss

from ...io.arguments import option
from ...studies.common.report import Report
from ...studies.common.text_tables import aligned
from ..command import Arguments, Parser, results


def add_arguments(parser: Parser) -> None:
    parser.valued("show", str, "name of the robot whose file is printed", metavar="NAME")
    parser.output("ROBOT.toml", "copy of the file of --show", otherwise="standard output")


def run(arguments: Arguments) -> None:
    name = arguments.show
    if name is not None:
        copy = ss.robots.text(option(name, ss.robots.NAMES, "--show"))
        with results(arguments, beginnings=[copy]) as (take, _):
            take(Report("" if arguments.output else copy, data={"name": name, "text": copy}), copy)
        return
    if arguments.output is not None:
        raise ValueError("-o: requires the name of a robot; add --show NAME")
    robots = {name: ss.robots.load(name) for name in ss.robots.NAMES}
    rows = [[name, robot.name, f"{robot.M:.4g}"] for name, robot in robots.items()]
    data = {name: {"name": robot.name, "platform_mass_kg": robot.M} for name, robot in robots.items()}
    with results(arguments) as (take, _):
        take(Report(aligned(["name", "machine", "platform, kg"], rows, left=2), data={"robots": data}))
