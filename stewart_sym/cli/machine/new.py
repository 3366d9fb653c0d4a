"""``stewart-sym new``: write a robot file from a few numbers, entered as options or on the terminal."""

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
    "Joints are in pairs around three axes; legs are a tube and a rod.\n"
    "Comments in the file mark every assumption.\n"
    "On a terminal, the command prompts for missing numbers."
)

_NUMBERS = {
    "base_radius": "radius of the circle of the base joints",
    "platform_radius": "radius of the circle of the platform joints",
    "height": "height of the platform joints above the base joints at home",
    "platform_mass": "mass of the platform with payload (kg)",
    "leg_mass": "mass of a leg (kg)",
    "stroke": "stroke, longest minus shortest leg length",
}
_ANGLES = {
    "base_angle": "angle between the base joints of a pair (deg)",
    "platform_angle": "angle between the platform joints of a pair (deg)",
}
_ANGLE = 20.0


def add_arguments(parser: argparse.ArgumentParser) -> None:
    valued(parser, "name", str, "name of the machine", "robot")
    chosen(parser, "length-unit", ("m", "cm", "mm", "in"), "unit of all lengths")
    for name, text in _NUMBERS.items():
        unit = "" if text.endswith("(kg)") else " (unit: --length-unit)"
        parser.add_argument(_option(name), type=positive, metavar="X", help=f"{text}{unit}")
    parser.add_argument("--z-down", action="store_true", help="let the z axis point down; default: up")
    for name, text in _ANGLES.items():
        valued(parser, name.replace("_", "-"), finite, text, _ANGLE, "DEG")
    output(parser, "ROBOT.toml", "robot file; - for standard output", None)


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
    """Return the numbers from the options, and prompt for missing ones on a terminal."""
    found = {name: getattr(arguments, name) for name in (*_NUMBERS, *_ANGLES)}
    missing = [name for name in _NUMBERS if found[name] is None]
    if missing and not sys.stdin.isatty():
        raise ValueError(f"{_option(missing[0])}: missing; standard input is not a terminal")
    for name in missing:
        found[name] = _asked(name, arguments.length_unit)
    return found


def _asked(name: str, unit: str) -> float:
    """Read a number > 0 from the terminal."""
    question = _NUMBERS[name] + ("" if _NUMBERS[name].endswith("(kg)") else f" ({unit})")
    while True:
        print(f"{question}: ", end="", file=sys.stderr, flush=True)
        line = sys.stdin.readline()
        if not line:
            raise ValueError(f"{_option(name)}: missing; standard input has ended")
        try:
            return positive(line.strip())
        except argparse.ArgumentTypeError as error:
            print(error, file=sys.stderr)


def _option(name: str) -> str:
    return f"--{name.replace('_', '-')}"
