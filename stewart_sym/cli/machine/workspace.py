"""``stewart-sym workspace``: volume of the set of poses within all limits, and its limiting constraints."""

import argparse
import math
from pathlib import Path
from typing import TYPE_CHECKING

from ...io.error_policy import warn
from ..inputs import robot_of
from ..options import chosen, finite, output, positive, robot_file, valued, whole
from ..output import results

if TYPE_CHECKING:
    from ...design.pose_limits import PoseExaminer
    from ...design.workspace import WorkspaceResult

HELP = "compute the volume, limiting constraints, and slices of a workspace"
EXAMPLE = "stewart-sym workspace hexapod.toml --max-condition 20 -o workspace"
MORE = (
    "Limits: leg lengths, joint angles, and actuator forces at rest, from the robot file.\n"
    "The volume of rotations is the integral of cos(theta_y) over roll, pitch, and yaw (rad^3).\n"
    "The error is three standard deviations. Positions refer to the tool."
)

_IGNORED = ("lengths", "joint_angles", "forces")
_TRIPLE = ("X", "Y", "Z")
_RANGES = ("X", "X", "Y", "Y", "Z", "Z")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser)
    text = "coordinates that vary: positions, rotations, or both"
    chosen(parser, "kind", ("constant_orientation", "orientation", "six_dof"), text)
    for name, nargs, metavar, text in (
        ("position", 3, _TRIPLE, "position of the tool in the center pose (m); default: the home pose"),
        ("rpy", 3, _TRIPLE, "roll, pitch, and yaw of the center pose (rad); default: 0 0 0"),
        (
            "position-bounds",
            6,
            _RANGES,
            "lower and upper bounds of t_x, t_y, t_z (m); default: reach of the legs",
        ),
        (
            "rpy-bounds",
            6,
            _RANGES,
            "lower and upper bounds of roll, pitch, yaw (rad); default: all rotations",
        ),
        (
            "load",
            6,
            ("FX", "FY", "FZ", "MX", "MY", "MZ"),
            "load on the tool at rest (N and N m, platform frame)",
        ),
    ):
        parser.add_argument(f"--{name}", nargs=nargs, type=finite, metavar=metavar, help=text)
    text = "largest scaled condition number of H; excludes also all poses beyond a singular pose"
    valued(parser, "max-condition", positive, text, metavar="NUMBER")
    valued(parser, "min-clearance", positive, "smallest distance between leg center lines (m)", metavar="M")
    parser.add_argument(
        "--ignore",
        action="append",
        choices=_IGNORED,
        default=[],
        help="limits of the robot file to ignore; may be repeated",
    )
    valued(parser, "samples", whole, "number of random poses", 1_000_000, "N")
    valued(parser, "seed", whole, "random seed", 0, "N")
    text = "address of a Dask scheduler (tcp://host:8786), or local: one worker per core; identical results"
    valued(parser, "scheduler", str, text, metavar="ADDRESS")
    output(parser, "DIR", "folder of the results", Path("workspace"), plots=True)


def run(arguments: argparse.Namespace) -> int:
    import numpy as np

    from ...design.pose_limits import PoseExaminer, PoseLimits, at_reference
    from ...design.workspace import workspace
    from ...studies.design.workspace_report import report, slices

    robot = robot_of(arguments.robot)
    limits = PoseLimits(
        lengths="lengths" not in arguments.ignore,
        joint_angles="joint_angles" not in arguments.ignore,
        forces="forces" not in arguments.ignore,
        max_condition=arguments.max_condition or math.inf,
        min_clearance=arguments.min_clearance or 0.0,
        load=np.array(arguments.load or [0.0] * 6),
    )
    with results(arguments, "report", "slices.csv") as (take, progress):
        found = workspace(
            robot,
            arguments.kind,
            limits,
            position=arguments.position,
            rpy=arguments.rpy or (0.0, 0.0, 0.0),
            position_bounds=_pairs(arguments.position_bounds),
            rpy_bounds=_pairs(arguments.rpy_bounds),
            samples=arguments.samples,
            seed=arguments.seed,
            scheduler=arguments.scheduler,
            progress=progress,
        )
        if found.distance_to_limit == 0.0:
            what = _broken(PoseExaminer(robot, at_reference(robot, limits)), found)
            warn(f"center pose: violates a limit, {what}")
        take(report(robot, limits, found, slices(robot, limits, found, progress)))
    return 0


def _broken(examiner: "PoseExaminer", found: "WorkspaceResult") -> str:
    """Describe the limit that the center pose violates."""
    from ...design.pose_limits import CONDITION, LENGTH, REASONS
    from ...io.arguments import status_text
    from ...kinematics.offset_legs import leg_lengths
    from ...motion.rotation import rotation_from_rpy

    R = rotation_from_rpy(found.rpy[None])
    t = found.position - R @ found.tool
    code = int(examiner.broken_limits(R, t)[0])
    if code == LENGTH:
        L = leg_lengths(examiner.robot, R, t)
        legs = f"its legs are {L.min():.4g} to {L.max():.4g} m long"
        return f"{legs}: change --position (m)"
    number, most = float(examiner.conditions(R, t)[0]), examiner.limits.max_condition
    if code == CONDITION and number > most:
        return f"{status_text(REASONS[code])}: expected at most {most:g}, got {number:.4g}"
    beyond = ": det H has another sign than at the home pose" if code == CONDITION else ""
    return f"{status_text(REASONS[code])}{beyond}"


def _pairs(numbers: list[float] | None) -> list[list[float]] | None:
    return None if numbers is None else [numbers[i : i + 2] for i in (0, 2, 4)]
