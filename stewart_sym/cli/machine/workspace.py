"""Compute the volume, limiting constraints, and slices of a workspace.

Limits: leg lengths, joint angles, and actuator forces at rest, from the robot file.
The volume of rotations is the integral of cos(theta_y) over roll, pitch, and yaw (rad^3).
The error is three standard deviations. Positions refer to the tool.

Example: stewart-sym workspace hexapod.toml --max-condition 20 -o workspace
"""

import math

import numpy as np

import stewart_sym as ss

from ...io.error_policy import warn
from ...studies.design.workspace_report import center_doubt, report, slices
from ..command import Arguments, Parser, finite, positive, results, whole
from ..inputs import robot_of

_IGNORED = ("lengths", "joint_angles", "forces")
_VECTORS = {
    "position": ("X Y Z", "position of the tool in the center pose (m); default: the home pose"),
    "rpy": ("X Y Z", "roll, pitch, and yaw of the center pose (rad); default: 0 0 0"),
    "position-bounds": ("X X Y Y Z Z", "lower and upper bounds of t_x, t_y, t_z (m); default: leg reach"),
    "rpy-bounds": ("X X Y Y Z Z", "lower and upper bounds of roll, pitch, yaw (rad); default: all rotations"),
    "load": ("FX FY FZ MX MY MZ", "load on the tool at rest (N and N m, platform frame)"),
}
"""Placeholders and help of the options with several numbers."""


def add_arguments(parser: Parser) -> None:
    parser.file("robot")
    text = "coordinates that vary: positions, rotations, or both"
    parser.chosen("kind", ("constant_orientation", "orientation", "six_dof"), text)
    for name, (names, text) in _VECTORS.items():
        metavar = tuple(names.split())
        parser.add_argument(f"--{name}", nargs=len(metavar), type=finite, metavar=metavar, help=text)
    text = "largest scaled condition number of H; excludes also all poses beyond a singular pose"
    parser.valued("max-condition", positive, text, metavar="NUMBER")
    parser.valued("min-clearance", positive, "smallest distance between leg center lines (m)", metavar="M")
    text = "limits of the robot file to ignore; may be repeated"
    parser.add_argument("--ignore", action="append", choices=_IGNORED, default=[], help=text)
    parser.valued("samples", whole, "number of random poses", 1_000_000, "N")
    parser.seed()
    text = "address of a Dask scheduler (tcp://host:8786), or local: one worker per core; identical results"
    parser.valued("scheduler", str, text, metavar="ADDRESS")
    parser.output("DIR", "folder of the results", "workspace", plots=True)


def run(arguments: Arguments) -> None:
    robot = robot_of(arguments.robot)
    limits = ss.PoseLimits(
        **{name: name not in arguments.ignore for name in _IGNORED},
        max_condition=arguments.max_condition or math.inf,
        min_clearance=arguments.min_clearance or 0.0,
        load=np.array(arguments.load or [0.0] * 6),
    )
    options = {name: getattr(arguments, name) for name in ("position", "samples", "seed", "scheduler")}
    options["rpy"] = arguments.rpy or (0.0, 0.0, 0.0)
    for name in ("position_bounds", "rpy_bounds"):
        given = getattr(arguments, name)
        options[name] = None if given is None else np.reshape(given, (3, 2)).tolist()
    with results(arguments, "report", "slices.csv") as (take, progress):
        found = ss.workspace(robot, arguments.kind, limits, **options, progress=progress)
        if found.distance_to_limit == 0.0:
            warn(f"center pose: violates a limit, {center_doubt(robot, limits, found)}")
        take(report(robot, limits, found, slices(robot, limits, found, progress)))
