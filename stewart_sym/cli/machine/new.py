"""``stewart-sym new``: write a robot file from a few numbers, given as options or asked for."""

import argparse
import sys
import tomllib

from ..inputs import warn_of_doubts
from ..options import chosen, finite, output, positive, valued
from ..output import results

HELP = "write a commented robot file from a few numbers"
EXAMPLE = (
    "stewart-sym new -o robot.toml --base-radius 0.6 --platform-radius 0.3 --height 0.7 "
    "--platform-mass 40 --leg-mass 4 --stroke 0.3"
)
MORE = (
    "Joints in pairs round three axes, a plate on top, legs of a tube and a rod: a beginning; what is "
    "assumed is marked. On a terminal, numbers that are not given are asked for."
)

_NUMBERS = {
    "base_radius": "radius of the base joints' circle",
    "platform_radius": "radius of the platform joints' circle",
    "height": "height of the platform's joints above the base's at home",
    "platform_mass": "mass of the platform with payload, kg",
    "leg_mass": "mass of a leg, kg",
    "stroke": "stroke: longest less shortest leg",
}
_ANGLES = {
    "base_angle": "angle between the base joints of a pair, deg",
    "platform_angle": "angle between the platform joints of a pair, deg",
}
_ANGLE = 20.0


def add_arguments(parser: argparse.ArgumentParser) -> None:
    valued(parser, "name", str, "of the machine", "robot")
    chosen(parser, "length-unit", ("m", "cm", "mm", "in"), "of all lengths")
    for name, text in _NUMBERS.items():
        unit = "" if text.endswith("kg") else ", in --length-unit"
        parser.add_argument(_option(name), type=positive, metavar="X", help=f"{text}{unit}")
    parser.add_argument("--z-down", action="store_true", help="z points down; default: up")
    for name, text in _ANGLES.items():
        valued(parser, name.replace("_", "-"), finite, text, _ANGLE, "DEG")
    output(parser, "ROBOT.toml", "file to write, - for standard output", None)


def run(arguments: argparse.Namespace) -> int:
    from ...io.atomic_write import result_file
    from ...robot.draft import Draft
    from ...robot.robot import Robot
    from ...studies.common.report import Report
    from ...studies.reports.describe import report

    numbers = _numbers(arguments)
    try:
        draft = Draft(arguments.name, arguments.length_unit, **numbers, z_down=arguments.z_down)
    except ValueError as error:
        name, _, rest = str(error).partition(":")
        raise ValueError(f"{_option(name)}:{rest}") from None
    text = draft.text()
    with results(arguments) as (take, _), result_file(arguments.output, [text], arguments.force) as stream:
        stream.write(text)
        robot = Robot.from_dict(tomllib.loads(text))
        warn_of_doubts(robot, arguments.output)
        said = "" if str(arguments.output) == "-" else f"Written to {arguments.output}"
        take(Report(said, data=report(robot).data))
    return 0


def _numbers(arguments: argparse.Namespace) -> dict[str, float]:
    """Numbers as given, or asked for on a terminal."""
    found = {name: getattr(arguments, name) for name in (*_NUMBERS, *_ANGLES)}
    missing = [name for name in _NUMBERS if found[name] is None]
    if missing and not sys.stdin.isatty():
        raise ValueError(f"{_option(missing[0])}: missing, and standard input is no terminal to ask on")
    for name in missing:
        found[name] = _asked(name, arguments.length_unit)
    return found


def _asked(name: str, unit: str) -> float:
    """A number > 0 from the terminal."""
    question = _NUMBERS[name] + ("" if _NUMBERS[name].endswith("kg") else f", {unit}")
    while True:
        print(f"{question}: ", end="", file=sys.stderr, flush=True)
        line = sys.stdin.readline()
        if not line:
            raise ValueError(f"{_option(name)}: missing, the answers ended")
        try:
            return positive(line.strip())
        except argparse.ArgumentTypeError as error:
            print(error, file=sys.stderr)


def _option(name: str) -> str:
    return f"--{name.replace('_', '-')}"
