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


HELP = "identify inertial parameters from measured forces, or from a simulated measurement"
EXAMPLE = "stewart-sym identify hexapod.toml --force-std 0.5 -o identified"
MORE = (
    "Without --measured the motion is the best of random Fourier series about the home pose, within "
    "the limits of legs and motors in the robot file, and the table gives the true values as well. SI units."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser)
    parser.add_argument(
        "--measured",
        nargs=2,
        type=Path,
        metavar=("TRAJECTORY.csv", "FORCES.csv"),
        help="the motion, as for forces, and columns time, F_1 to F_6 (N) at the same times, or else current_1 "
        "to current_6 (A), signed as the torque, of a machine whose drives have a torque_constant; of the "
        "options of the trajectory's file --delimiter, --decimal and, where no row of units states it, "
        "--time-unit are the second file's too; of the robot file only geometry, gravity and drives are "
        "used: where these have a rotor_inertia, F_1 to F_6 are forces of the motors (N times torque); --seed, "
        "--samples and --candidates are not used",
    )
    text = "standard deviation of measured forces, N, or of measured currents, A"
    valued(parser, "force-std", positive, text, 1.0)
    noise_options(
        parser,
        "standard deviation of the measured {}, in --{}-unit: only the poses are used, and a smooth motion "
        "is fitted together with the parameters; default: the motion is exact",
        "position",
        "rotation about each axis",
    )
    valued(parser, "seed", whole, "of the random candidates and the simulated noise", 0)
    text = "of the motion, s; default: accelerations of the order of gravity, or for measured poses with "
    valued(parser, "period", finite, f"{text}noise a motion without a period")
    text = "of the Fourier series; default: 5, for measured poses chosen from the data"
    valued(parser, "harmonics", whole, text)
    parser.add_argument(
        "--no-friction",
        action="store_true",
        help="fit measured forces with a model whose joints have no friction",
    )
    parser.add_argument(
        "--enforce-physical",
        action="store_true",
        help="fit measured forces by physically possible bodies, and write their parameters to bodies.csv",
    )
    parser.add_argument(
        "--identical-legs",
        action="store_true",
        help="seek the parameters of one leg for all six, built alike",
    )
    parser.add_argument(
        "--drive-terms",
        metavar="TERM,...",
        help="F_1 to F_6 are forces of the motors (N times torque), as currents always are: seek terms of the "
        "drives as well, some of reflected_mass, coulomb, offset, viscous",
    )
    valued(parser, "samples", whole, "instants of one period", 200)
    valued(parser, "candidates", whole, "random series to try", 50)
    log_form(parser)
    output(parser, "DIR", "folder to write to", None)


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
            f"{poses}: expected poses or leg lengths, got forces F_1 to F_6: "
            "the two files of --measured look swapped"
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
        _shared(arguments) == "legs",
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
            raise ValueError(f"--{option.replace('_', '-')}: is for measured forces, expected --measured")
    if log_format(arguments) != TrajectoryFormat() or arguments.pose_guess is not None:
        raise ValueError(
            "--pose-guess and options of the trajectory's file: are for measured forces, expected --measured"
        )
    robot = robot_of(arguments.robot)
    noise = (arguments.position_std, arguments.angle_std) if _pose_noise(arguments) else (0.0, 0.0)
    names = ("period", "samples", "candidates", "seed")
    options = {name: getattr(arguments, name) for name in names} | {"shared": _shared(arguments)}
    harmonics = 5 if arguments.harmonics is None else arguments.harmonics
    excited = choose_excitation(robot, harmonics=harmonics, progress=progress, **options)
    progress("identifying")
    found = simulate_experiment(robot, excited, arguments.force_std, arguments.seed, *noise)
    return simulated_report(robot, found), found.estimate


def _shared(arguments: argparse.Namespace) -> str | None:
    """Return the argument ``shared`` of the fits."""
    return "legs" if arguments.identical_legs else None


def _pose_noise(arguments: argparse.Namespace) -> bool:
    """Whether the noise of poses is stated: both of it or neither."""
    given = [getattr(arguments, name) is not None for name in ("position_std", "angle_std")]
    if given[0] != given[1]:
        raise ValueError("--position-std: expected --angle-std beside it, and none without it")
    return given[0]
