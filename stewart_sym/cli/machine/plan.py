"""Plan a well-conditioned path through via poses and an optimal motion along it.

The keys of the file of via poses are on page "Files" of the documentation.
Output: trajectory.csv for `forces`, a report with the certificate of the limits, and drawings.
Exit code: 0, 1 if the certificate is not valid, 2 for an error.
The report has the units of the robot file; tables have SI units.

Example: stewart-sym plan via.toml -o plan
"""

from typing import Any

import numpy as np

import stewart_sym as ss

from ...io.error_policy import errors_of, warn
from ...kinematics.inverse_kinematics import leg_lengths
from ...kinematics.trajectory_checks import meters_doubt
from ...planning.path_parameterization import need_duration
from ...planning.plan_file import PlanRequest, read_plan
from ...studies.reports import plan
from ..command import Arguments, Parser, positive, results
from ..inputs import FEW_ROWS, warn_of_doubts


def add_arguments(parser: Parser) -> None:
    parser.file("via")
    text = "objective, overrides the key of the file; default: time"
    parser.add_argument("--minimize", choices=("time", "energy", "peak_force"), help=text)
    parser.valued("duration", positive, "duration (s), for energy and peak force", metavar="SECONDS")
    parser.output("DIR", "folder of the results", "plan", plots=True, html=True)


def run(arguments: Arguments) -> int:
    with read_plan(arguments.via) as request:
        return _plan(arguments, request)


def _plan(arguments: Arguments, request: PlanRequest) -> int:
    robot, least = request.robot, arguments.minimize or request.minimize
    duration = request.duration if arguments.duration is None else arguments.duration
    with errors_of("" if arguments.minimize or arguments.duration else f"{arguments.via}: "):
        need_duration(least, duration)
        if duration is not None:
            plan.need_samples(duration, request.rate)
    warn_of_doubts(robot, request.files[1])
    t, R = (np.array([getattr(pose, name) for pose in request.poses]) for name in ("t", "R"))
    if (doubt := meters_doubt(robot, leg_lengths(robot, R, t))) is not None:
        raise ValueError(request.of_poses(f"via poses: {doubt}"))
    with results(arguments, "report", "trajectory.csv", "path.csv", read=request.files) as (take, progress):
        cost = (request.objective, request.smoothness_weight, request.load)
        try:
            planned = ss.plan_path(robot, request.poses, request.path_limits, *cost, progress)
        except ValueError as error:
            raise ValueError(request.of_poses(str(error))) from None
        options: dict[str, Any] = {"limits": request.limits, "formulation": request.formulation}
        options |= {"minimize": least, "duration": duration}
        timed = ss.parameterize_path(robot, planned.path, **options, progress=progress)
        progress("checking the plan")
        with errors_of(f"{arguments.via}: "):
            plan.need_samples(timed.duration, request.rate)
        found = plan.Plan(robot, planned, timed, ss.certify_plan(timed), request.rate)
        take(plan.report(found))
    for line in [] if found.motors is None else found.motors.exceeded():
        warn(f"drive: {line}", ss.DriveLimitWarning)
    if len(found.times) < FEW_ROWS:
        warn(
            f"{arguments.via}: rate: expected {FEW_ROWS} or more rows in trajectory.csv of a motion of "
            f"{timed.duration:.4g} s, got {len(found.times)} at {request.rate:g} Hz"
        )
    if not found.certificate.is_valid:
        warn(f"{arguments.via}: the certificate is not valid; see the report")
    return 0 if found.certificate.is_valid else 1
