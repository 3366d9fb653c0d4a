"""``stewart-sym identify``: inertial parameters from forces."""

import argparse
import dataclasses
from pathlib import Path
from typing import TYPE_CHECKING, cast

from ...io.error_policy import warn
from ...io.extras import need
from ...io.progress import Progress
from ..inputs import log_format, poses_of, robot_of, stated_noise
from ..options import finite, log_form, noise_options, output, positive, robot_file, valued, whole
from ..output import results

if TYPE_CHECKING:
    from ...identification.estimates import IdentificationResult
    from ...motion.trajectory import Trajectory
    from ...studies.common.report import Report


HELP = "identify inertial parameters from measured or simulated forces"
EXAMPLE = "stewart-sym identify hexapod.toml --force-std 0.5 -o identified"
MORE = (
    "Without --measured, the motion is the best of random Fourier series within the limits, and the table\n"
    "includes the true values.\n"
    "Output: report, trajectory.csv, and parameters. SI units.\n"
    "Exit code: 0, 1 if the fit is rejected, 2 for an error."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser)
    parser.add_argument(
        "--measured",
        nargs=2,
        type=Path,
        metavar=("TRAJECTORY.csv", "FORCES.csv"),
        help="files of the motion, as for `forces`, and of time with F_1 to F_6 (N) or current_1 to "
        "current_6 (A, sign of the torque). The robot file provides geometry, gravity, and drives. "
        "If a drive has a rotor_inertia, F_1 to F_6 are motor forces (N times torque)",
    )
    text = "standard deviation of the measured forces (N) or currents (A)"
    valued(parser, "force-std", positive, text, 1.0)
    noise_options(
        parser,
        "standard deviation of the measured {} (--{}-unit): fit a smooth motion to the poses; default: exact",
        "positions",
        "rotations about each axis",
    )
    valued(parser, "seed", whole, "random seed", 0)
    text = "period of the motion (s); default: from gravity, or none for measured poses with noise"
    valued(parser, "period", finite, text)
    text = "number of Fourier harmonics; default: 5, or from the data for measured poses"
    valued(parser, "harmonics", whole, text)
    parser.add_argument("--no-friction", action="store_true", help="fit a model without joint friction")
    parser.add_argument(
        "--enforce-physical",
        action="store_true",
        help="fit physically possible bodies, and write their parameters to bodies.csv",
    )
    parser.add_argument(
        "--identical-legs", action="store_true", help="fit one common set of parameters for all six legs"
    )
    parser.add_argument(
        "--drive-terms",
        metavar="TERM,...",
        help="drive terms to identify: reflected_mass, coulomb, offset, viscous; F_1 to F_6 are then motor "
        "forces (N times torque)",
    )
    valued(parser, "samples", whole, "number of samples per period", 200)
    valued(parser, "candidates", whole, "number of random Fourier series", 50)
    log_form(parser)
    output(parser, "DIR", "folder of the results", None)


def run(arguments: argparse.Namespace) -> int:
    from ...studies.reports.identify import doubts

    with results(arguments, "report", "trajectory.csv") as (take, progress):
        progress("identifying")
        report, found = (_measured if arguments.measured else _simulated)(arguments, progress)
        take(report)
    for line in doubts(found):
        warn(line)
    return 1 if found.verdict == "rejected" else 0


def _measured(arguments: argparse.Namespace, progress: Progress) -> "tuple[Report, IdentificationResult]":
    import numpy as np

    from ...drives.effort import motor_forces
    from ...identification.drive_terms import need_terms
    from ...identification.physical import POSSIBLE
    from ...kinematics.robot_logs import trajectory_for
    from ...motion.log_reader import CURRENTS, FORCES, read_leg_columns
    from ...motion.logs import HeaderError
    from ...motion.smooth_motion import WITHOUT_PERIOD, PoseNoise
    from ...motion.trajectory import SmoothingOptions
    from ...robot.robot import LEGS
    from ...studies.reports.identify import from_measurement, measured_report

    terms = None if arguments.drive_terms is None else tuple(arguments.drive_terms.split(","))
    if terms is not None:
        need_terms(terms, "--drive-terms")
    if arguments.enforce_physical:
        need("scipy", POSSIBLE)
    noisy = _pose_noise(arguments)
    if noisy and arguments.period is None:
        need("scipy", WITHOUT_PERIOD)
    robot = robot_of(arguments.robot)
    poses, forces = arguments.measured
    form = log_format(arguments, poses)
    try:
        # The fit has its own noise: what is stated is compared with the log alone.
        smoothing = SmoothingOptions(*stated_noise(arguments, form), enabled=False, repair=True)
        log = trajectory_for(robot, poses, log_format(arguments), smoothing)
    except HeaderError as error:
        if not set(FORCES) <= set(error.header):
            raise
        raise ValueError(
            f"{poses}: expected poses or leg lengths, got forces F_1 to F_6; exchange the files of --measured"
        ) from None
    trajectory = cast("Trajectory", poses_of(robot, log, arguments, progress))
    of_forces = dataclasses.replace(log_format(arguments), columns={})
    time, F, columns, lines = read_leg_columns(forces, of_forces, (FORCES, CURRENTS))
    sigma = np.asarray(arguments.force_std)
    if columns == CURRENTS:
        F, sigma = motor_forces(robot, F), np.abs(motor_forces(robot, np.full(LEGS, arguments.force_std)))
    noise = None
    if noisy:
        series = (arguments.period, arguments.harmonics if arguments.period is not None else None)
        noise = PoseNoise(
            trajectory.time, *cast("tuple[float, float]", stated_noise(arguments, form)), *series
        )
    model = (not arguments.no_friction, arguments.enforce_physical)
    found = from_measurement(
        robot,
        trajectory,
        time,
        F,
        sigma,
        str(forces),
        noise,
        *model,
        form,
        arguments.identical_legs,
        terms,
        lines,
    )
    return measured_report(robot, found, sigma, noise, columns == CURRENTS), found


def _simulated(arguments: argparse.Namespace, progress: Progress) -> "tuple[Report, IdentificationResult]":
    from ...identification.estimation import simulate_experiment
    from ...identification.excitation import choose_excitation
    from ...motion.logs import TrajectoryFormat
    from ...studies.reports.identify import simulated_report

    for option in ("no_friction", "enforce_physical", "drive_terms"):
        if getattr(arguments, option):
            raise ValueError(f"--{option.replace('_', '-')}: applies to measured forces; add --measured")
    if log_format(arguments) != TrajectoryFormat() or arguments.pose_guess is not None:
        raise ValueError(
            "--pose-guess and options of the trajectory file: apply to measured forces; add --measured"
        )
    robot = robot_of(arguments.robot)
    noise = (arguments.position_std, arguments.angle_std) if _pose_noise(arguments) else (0.0, 0.0)
    names = ("period", "samples", "candidates", "seed", "identical_legs")
    options = {name: getattr(arguments, name) for name in names}
    harmonics = 5 if arguments.harmonics is None else arguments.harmonics
    excited = choose_excitation(robot, harmonics=harmonics, progress=progress, **options)
    progress("identifying")
    found = simulate_experiment(robot, excited, arguments.force_std, arguments.seed, *noise)
    return simulated_report(robot, found), found.estimate


def _pose_noise(arguments: argparse.Namespace) -> bool:
    """Return True if the options state the noise of poses."""
    given = [getattr(arguments, name) is not None for name in ("position_std", "angle_std")]
    if given[0] != given[1]:
        raise ValueError("--position-std and --angle-std must be given together")
    return given[0]
