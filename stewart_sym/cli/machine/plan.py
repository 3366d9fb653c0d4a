"""``stewart-sym plan``: a path through via poses away from singular ones, and the fastest motion along it."""

import argparse
import contextlib
from collections.abc import Iterator, Set
from pathlib import Path
from typing import TYPE_CHECKING

from ...io.error_policy import warn
from ...io.extras import need
from ...io.progress import Progress
from ..inputs import FEW_ROWS, warn_of_doubts
from ..options import output, positive, valued
from ..results import results

if TYPE_CHECKING:
    from ...planning.plan_file import PlanRequest
    from ...planning.plan_path import PlannedPath

HELP = "a path through via poses with a low condition number, and the fastest motion along it"
EXAMPLE = "stewart-sym plan via.toml -o plan"
MORE = (
    "The file of via poses is TOML: schema = 1, robot (a file beside it), and [[via]] with t, theta (roll, "
    "pitch, yaw, of the tool) and optionally free: how far x, y, z (m, base axes) and roll, pitch, yaw (rad, "
    "tool axes) may differ, as in free.yaw = [-0.5, 0.5]; or via_file, a CSV file of poses in order of time. "
    'Optionally objective ("mean" or "peak" of the condition number), price of a longer path, rate (Hz), '
    'formulation, least ("time", "energy" or "peak-force") with duration (s); [limits]: condition, clearance '
    "(m), force (N), speed (m/s), acceleration (m/s^2), jerk (m/s^3) of the legs, platform_speed, "
    "platform_turn_rate; [load]: F_ext, M_ext, platform frame, at the reference point. Writes the trajectory "
    "as `forces` reads it, a report with a certificate that limits hold between the samples too (exit code 1 "
    "where it does not hold), and pictures. SI units."
)
_LEAST = ("time", "energy", "peak-force")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("via", metavar="VIA.toml", type=Path, help="file of via poses, schema 1")
    parser.add_argument(
        "--least", choices=_LEAST, help="what is made least, in place of the file's least; default: time"
    )
    valued(parser, "duration", positive, "of a motion of least energy or peak force", metavar="SECONDS")
    output(parser, "DIR", "folder to write to", Path("plan"), pictures=True, html=True)


def run(arguments: argparse.Namespace) -> int:
    from ...planning.plan_file import read_plan

    need("scipy", "planning")
    with read_plan(arguments.via) as request, _where_stated(arguments, request.stated):
        return _plan(arguments, request)


@contextlib.contextmanager
def _where_stated(arguments: argparse.Namespace, stated: Set[str]) -> Iterator[None]:
    """Let an error about what the file states, and no option, name the file. Limits may be the robot's."""
    try:
        yield
    except ValueError as error:
        key = str(error).partition(":")[0]
        if key in stated - {"limits"} and getattr(arguments, key, None) is None:
            raise ValueError(f"{arguments.via}: {error}") from None
        raise


def _plan(arguments: argparse.Namespace, request: "PlanRequest") -> int:
    import numpy as np

    from ...drives.effort import DriveLimitWarning
    from ...kinematics.log_doubts import metres_doubt
    from ...kinematics.offset_legs import leg_lengths
    from ...planning.certificate import certify_plan
    from ...planning.time_path import need_duration, time_path
    from ...studies.reports import plan

    robot, least = request.robot, arguments.least or request.least
    duration = request.duration if arguments.duration is None else arguments.duration
    need_duration(least, duration)
    if duration is not None:
        plan.need_instants(duration, request.rate)
    warn_of_doubts(robot, request.files[1])
    t, R = (np.array([getattr(pose, name) for pose in request.poses]) for name in ("t", "R"))
    if (doubt := metres_doubt(robot, leg_lengths(robot, R, t))) is not None:
        raise ValueError(request.of_poses(f"via poses: {doubt}"))
    tables = ("trajectory.csv", "path.csv")
    with results(arguments, "report", *tables, read=request.files) as (take, progress):
        planned = _planned(request, progress)
        timed = time_path(
            robot,
            planned.path,
            limits=request.limits,
            formulation=request.formulation,
            progress=progress,
            least=least,
            duration=duration,
        )
        progress("checking the plan")
        found = plan.Plan(robot, planned, timed, certify_plan(timed), request.rate)
        take(plan.report(found))
    for line in [] if found.motors is None else found.motors.summary.exceeded():
        warn(f"drive: {line}", DriveLimitWarning)
    if len(found.times) < FEW_ROWS:
        warn(
            f"{arguments.via}: rate: expected {FEW_ROWS} or more rows in trajectory.csv of a motion of "
            f"{timed.duration:.4g} s, got {len(found.times)} at {request.rate:g} Hz"
        )
    if not found.certificate.holds:
        warn(f"{arguments.via}: the certificate does not hold, see the report")
    return 0 if found.certificate.holds else 1


def _planned(request: "PlanRequest", progress: Progress) -> "PlannedPath":
    """The path; an error names the file of the via poses, and ends with a doubt about their angles."""
    from ...planning.plan_path import plan_path

    try:
        return plan_path(
            request.robot,
            request.poses,
            request.path_limits,
            request.objective,
            request.price,
            request.load,
            progress,
        )
    except ValueError as error:
        doubt = f"; {request.doubt}" if request.doubt else ""
        raise ValueError(request.of_poses(f"{error}{doubt}")) from None
