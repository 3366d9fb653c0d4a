"""Write a commented robot file from a few numbers.

Joints are in pairs around three axes; legs are a tube and a rod.
Comments in the file mark every assumption.
On a terminal, the command prompts for missing numbers.

Example: stewart-sym new -o robot.toml --base-radius 0.6 --platform-radius 0.3 --height 0.7
  --platform-mass 40 --leg-mass 4 --stroke 0.3
"""

import argparse
import sys
import tomllib

import stewart_sym as ss

from ...robot.draft import Draft
from ...studies.common.report import Report
from ...studies.reports.robot_report import report
from ..command import Arguments, Parser, finite, positive, results
from ..inputs import warn_of_doubts

_NUMBERS = {
    "base_radius": "radius of the circle of the base joints ({})",
    "platform_radius": "radius of the circle of the platform joints ({})",
    "height": "height of the platform joints above the base joints at home ({})",
    "platform_mass": "mass of the platform with payload (kg)",
    "leg_mass": "mass of a leg (kg)",
    "stroke": "stroke, longest minus shortest leg length ({})",
}
"""Meanings of the numbers, with a placeholder for the unit of length."""
_ANGLES = {
    "base_angle": "angle between the base joints of a pair (deg)",
    "platform_angle": "angle between the platform joints of a pair (deg)",
}


def add_arguments(parser: Parser) -> None:
    parser.valued("name", str, "name of the machine", "robot")
    parser.chosen("length-unit", ("m", "cm", "mm", "in"), "unit of all lengths")
    for name, text in _NUMBERS.items():
        parser.valued(name.replace("_", "-"), positive, text.format("unit: --length-unit"), metavar="X")
    parser.flag("z-down", "let the z axis point down; default: up")
    for name, text in _ANGLES.items():
        parser.valued(name.replace("_", "-"), finite, text, 20.0, "DEG")
    parser.output("ROBOT.toml", "robot file; - for standard output")


def run(arguments: Arguments) -> None:
    for name in _NUMBERS:
        if getattr(arguments, name) is None:
            setattr(arguments, name, _asked(name, _NUMBERS[name].format(arguments.length_unit)))
    numbers = {name: getattr(arguments, name) for name in (*_NUMBERS, *_ANGLES)}
    text = Draft(arguments.name, arguments.length_unit, **numbers, z_down=arguments.z_down).text()
    with results(arguments, beginnings=[text]) as (take, _):
        robot = ss.Robot.from_dict(tomllib.loads(text))
        warn_of_doubts(robot, arguments.output)
        take(Report("", data=report(robot).data), text)


def _asked(name: str, question: str) -> float:
    """Read a number > 0 from the terminal."""
    if not sys.stdin.isatty():
        raise ValueError(f"{name}: missing; not a terminal, use --{' --'.join(_NUMBERS).replace('_', '-')}")
    while True:
        print(f"{question}: ", end="", file=sys.stderr, flush=True)
        line = sys.stdin.readline()
        if not line:
            raise ValueError(f"{name}: missing; standard input has ended")
        try:
            return float(positive(line.strip()))
        except argparse.ArgumentTypeError as error:
            print(error, file=sys.stderr)
