"""``stewart-sym workspace``: how large the set of poses within the limits is, and what bounds it."""

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

HELP = "how far a machine reaches: volume of its workspace with an error, what bounds it, and slices"
EXAMPLE = "stewart-sym workspace hexapod.toml --max-condition 20 -o workspace"
MORE = (
    "Limits of the robot file count: leg lengths, joint angles, and forces that hold the machine at rest. "
    "Positions are those of the robot file's tool, by default the reference point. "
    "Positions at one orientation, rotations at one position, or both; the volume of rotations is the "
    "integral of cos(theta_y) over roll, pitch and yaw, rad^3, of 8 pi^2 in all. The error is three standard "
    "deviations. m, rad and N."
)

_IGNORED = ("lengths", "joint-angles", "forces")
_TRIPLE = ("X", "Y", "Z")
_RANGES = ("X", "X", "Y", "Y", "Z", "Z")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser)
    text = "what varies: positions (constant orientation), rotations, or both"
    chosen(parser, "kind", ("constant_orientation", "orientation", "six_dof"), text)
    for name, nargs, metavar, text in (
        ("position", 3, _TRIPLE, "position of the tool in the middle pose (m); default: the home pose"),
        ("rpy", 3, _TRIPLE, "its roll, pitch and yaw, rad; default: parallel to the base"),
        (
            "position-bounds",
            6,
            _RANGES,
            "least and greatest t_x, t_y, t_z, m; default: where the longest legs reach",
        ),
        ("rpy-bounds", 6, _RANGES, "least and greatest roll, pitch and yaw, rad; default: all rotations"),
        (
            "load",
            6,
            ("FX", "FY", "FZ", "MX", "MY", "MZ"),
            "load on the tool at rest (N and N m), platform frame",
        ),
    ):
        parser.add_argument(f"--{name}", nargs=nargs, type=finite, metavar=metavar, help=text)
    text = "largest scaled condition number of H; leaves out what lies beyond a singular pose as well"
    valued(parser, "max-condition", positive, text, metavar="NUMBER")
    valued(parser, "min-clearance", positive, "least distance of the legs' center lines, m", metavar="M")
    parser.add_argument(
        "--ignore",
        action="append",
        choices=_IGNORED,
        default=[],
        help="limits of the robot file to leave out",
    )
    valued(parser, "samples", whole, "how many to examine", 1_000_000, "N")
    valued(parser, "seed", whole, "of the random poses", 0, "N")
    text = "run on a Dask scheduler, as tcp://host:8786, or local: a worker on each core; the same bits"
    valued(parser, "scheduler", str, text, metavar="ADDRESS")
    output(parser, "DIR", "folder to write to", Path("workspace"), plots=True)


def run(arguments: argparse.Namespace) -> int:
    import numpy as np

    from ...design.pose_limits import PoseExaminer, PoseLimits, at_reference
    from ...design.workspace import workspace
    from ...studies.design.workspace_report import report, slices

    robot = robot_of(arguments.robot)
    limits = PoseLimits(
        lengths="lengths" not in arguments.ignore,
        joint_angles="joint-angles" not in arguments.ignore,
        forces="forces" not in arguments.ignore,
        condition=arguments.max_condition or math.inf,
        clearance=arguments.min_clearance or 0.0,
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
            warn(f"the pose in the middle breaks a limit, {what}")
        take(report(robot, limits, found, slices(robot, limits, found, progress)))
    return 0


def _broken(examiner: "PoseExaminer", found: "WorkspaceResult") -> str:
    """Which limit the pose in the middle breaks, and what is known of it."""
    from ...design.pose_limits import CONDITION, LENGTH, REASONS
    from ...kinematics.offset_legs import leg_lengths
    from ...motion.rotation import rotation_from_rpy

    R = rotation_from_rpy(found.rpy[None])
    t = found.position - R @ found.tool
    code = int(examiner.broken_limits(R, t)[0])
    if code == LENGTH:
        L = leg_lengths(examiner.robot, R, t)
        legs = f"its legs are {L.min():.4g} to {L.max():.4g} m long"
        return f"{legs}: expected one within the limits, --position in meters"
    number, most = float(examiner.conditions(R, t)[0]), examiner.limits.condition
    if code == CONDITION and number > most:
        return f"{REASONS[code]}: expected at most {most:g}, got {number:.4g}"
    beyond = ": det H has another sign than at the home pose" if code == CONDITION else ""
    return f"{REASONS[code]}{beyond}"


def _pairs(numbers: list[float] | None) -> list[list[float]] | None:
    return None if numbers is None else [numbers[i : i + 2] for i in (0, 2, 4)]
