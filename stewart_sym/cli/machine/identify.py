"""Identify inertial parameters from measured or simulated forces.

Without --measured, the motion is the best of random Fourier series within the limits, and the table
includes the true values; poses are exact unless --position-std and --angle-std are given.
Output: report, trajectory.csv, and parameters. SI units.
Exit code: 0, 1 if the fit is rejected, 2 for an error.

Example: stewart-sym identify hexapod.toml --force-std 0.5 -o identified
"""

from pathlib import Path
from typing import Any

import stewart_sym as ss

from ...identification.measured_files import read_measurement
from ...identification.measured_forces import from_measurement
from ...io.error_policy import warn
from ...io.progress import Progress
from ...studies.common.report import Report
from ...studies.reports.identify import doubts, measured_report, simulated_report
from ..command import Arguments, Parser, finite, positive, results, whole
from ..inputs import log_format, pose_guess, robot_of


def add_arguments(parser: Parser) -> None:
    parser.file("robot")
    text = (
        "files of the motion, as for `forces`, and of time with F_1 to F_6 (N) or current_1 to current_6 (A, "
        "sign of the torque). The robot file provides geometry, gravity, and drives. If a drive has a "
        "rotor_inertia, F_1 to F_6 are motor forces (N times torque)"
    )
    files = ("TRAJECTORY.csv", "FORCES.csv")
    parser.add_argument("--measured", nargs=2, type=Path, metavar=files, help=text)
    text = "standard deviation of the measured forces (N) or currents (A)"
    parser.valued("force-std", positive, text, 1.0)
    parser.seed()
    text = "period of the motion (s); default: from gravity, or none for measured poses with noise"
    parser.valued("period", finite, text)
    text = "number of Fourier harmonics; default: 5, or from the data for measured poses"
    parser.valued("harmonics", whole, text)
    parser.flag("no-friction", "fit a model without joint friction")
    text = "fit physically possible bodies, and write their parameters to bodies.csv"
    parser.flag("enforce-physical", text)
    parser.flag("identical-legs", "fit one common set of parameters for all six legs")
    text = (
        "drive terms to identify: reflected_mass, coulomb, offset, viscous; F_1 to F_6 are then motor forces "
        "(N times torque)"
    )
    parser.valued("drive-terms", lambda text: tuple(text.split(",")), text, metavar="TERM,...")
    parser.valued("samples", whole, "number of samples per period", 200)
    parser.valued("candidates", whole, "number of random Fourier series", 50)
    parser.log_form()
    parser.output("DIR", "folder of the results")


def run(arguments: Arguments) -> int:
    with results(arguments, "report", "trajectory.csv") as (take, progress):
        progress("identifying")
        report, found = (_measured if arguments.measured else _simulated)(arguments, progress)
        take(report)
    for line in doubts(found):
        warn(line)
    return 1 if found.verdict == "rejected" else 0


def _measured(arguments: Arguments, progress: Progress) -> tuple[Report, ss.IdentificationResult]:
    robot, form, force_std = robot_of(arguments.robot), log_format(arguments), arguments.force_std
    std = (arguments.position_std, arguments.angle_std)
    fourier = (arguments.period, None if arguments.period is None else arguments.harmonics)
    options = (form, std, fourier, pose_guess(arguments), progress)
    measured = read_measurement(robot, arguments.measured, force_std, *options)
    model = (not arguments.no_friction, arguments.enforce_physical, arguments.identical_legs)
    found = from_measurement(robot, measured, *model, arguments.drive_terms)
    return measured_report(robot, found, measured.sigma, measured.noise, measured.of_currents), found


def _simulated(arguments: Arguments, progress: Progress) -> tuple[Report, ss.IdentificationResult]:
    measured = ("no_friction", "enforce_physical", "drive_terms", "pose_guess")
    if any(getattr(arguments, name) for name in measured) or log_format(arguments) != ss.TrajectoryFormat():
        text = "--no-friction, --enforce-physical, --drive-terms, and options of the trajectory file"
        raise ValueError(f"{text}: apply to measured forces; add --measured")
    robot = robot_of(arguments.robot)
    if (arguments.position_std is None) != (arguments.angle_std is None):
        raise ValueError("--position-std and --angle-std must be given together")
    names = ("period", "samples", "candidates", "seed", "identical_legs")
    options: dict[str, Any] = {name: getattr(arguments, name) for name in names}
    options["harmonics"] = 5 if arguments.harmonics is None else arguments.harmonics
    excited = ss.choose_excitation(robot, progress=progress, **options)
    std = (arguments.position_std or 0.0, arguments.angle_std or 0.0)
    found = ss.simulate_experiment(robot, excited, arguments.force_std, arguments.seed, *std)
    return simulated_report(robot, found), found.estimate
