"""Identify inertial parameters from measured or simulated forces.

Without --measured, the motion is the best of random Fourier series within the limits, and the table
includes the true values.
Output: report, trajectory.csv, and parameters. SI units.
Exit code: 0, 1 if the fit is rejected, 2 for an error.

Example: stewart-sym identify hexapod.toml --force-std 0.5 -o identified
"""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

import stewart_sym as ss

from ...drives.noise import at_replaced
from ...identification.measured_forces import from_measurement, noise_of_log
from ...io.error_policy import warn
from ...io.progress import Progress
from ...kinematics.robot_logs import log_of, samples_of
from ...motion.log_samples import FORCES, components_of, possible_units, read_samples
from ...motion.trajectory import Trajectory
from ...robot.robot import LEGS
from ...studies.common.report import Report
from ...studies.reports.identify import doubts, measured_report, simulated_report
from ..command import Arguments, Parser, finite, positive, results, whole
from ..inputs import log_format, poses_of, robot_of, stated_noise


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
    text = "standard deviation of the measured {} (--{}-unit); default: estimated, or exact in simulations"
    parser.noise(text, "positions or leg lengths", "rotations about each axis")
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
    robot = robot_of(arguments.robot)
    poses, forces = arguments.measured
    form = log_format(arguments)
    leg_columns = [each for name in FORCES for each in components_of(name)]
    of_forces = {name: form.columns[name] for name in leg_columns if name in form.columns}
    of_poses = {name: header for name, header in form.columns.items() if name not in of_forces}
    samples = samples_of(robot, poses, replace(form, columns=of_poses))
    std = stated_noise(arguments, samples.file_format)
    in_joints = "L" in samples.vectors
    if in_joints and std[1] is not None:
        raise ValueError("--angle-std: the trajectory contains leg lengths; state --position-std alone")
    if not in_joints:
        _need_both(arguments)
    log = log_of(robot, samples, ss.SmoothingOptions(*std), progress)
    # Rates of the file are used as they are, unless the noise of the poses is stated.
    if noisy := std[0] is not None or (log.noise is not None and not {"v", "L_dot"} & set(samples.vectors)):
        # The fit smooths the values with its own model of the noise.
        log = _measured_rows(log, log_of(robot, samples, ss.SmoothingOptions(enabled=False)))
    trajectory = poses_of(robot, log, arguments, progress)
    # The file of the forces may have other units, times, and delimiters than the motion.
    clock = {name: header for name, header in samples.file_format.columns.items() if name == "time"}
    defaults = ss.TrajectoryFormat(clock, time_unit=form.time_unit, row_rate=samples.file_format.row_rate)
    measured = read_samples(str(forces), ss.TrajectoryFormat(of_forces), defaults, forces=True)
    time = np.arange(float(len(measured.lines))) if measured.time is None else measured.time
    if samples.start and measured.start:
        time = time + (measured.start - samples.start)
    ((kind, F),) = measured.vectors.items()
    sigma = np.asarray(arguments.force_std)
    if kind == "current":
        F, sigma = ss.motor_forces(robot, F), np.abs(ss.motor_forces(robot, np.full(LEGS, sigma)))
    harmonics = arguments.harmonics if arguments.period is not None else None
    noise = noise_of_log(robot, trajectory, std, arguments.period, harmonics) if noisy else None
    model = (not arguments.no_friction, arguments.enforce_physical, arguments.identical_legs)
    units = possible_units(measured, kind)
    options = (measured.lines, noise, *model, arguments.drive_terms, units)
    found = from_measurement(robot, trajectory, time, F, sigma, str(forces), *options)
    return measured_report(robot, found, sigma, noise, kind == "current"), found


def _need_both(arguments: Arguments) -> None:
    """Raise ValueError unless both standard deviations of poses are given, or none."""
    if (arguments.position_std is None) != (arguments.angle_std is None):
        raise ValueError("--position-std and --angle-std must be given together")


def _measured_rows(smooth: Trajectory, measured: Trajectory) -> Trajectory:
    """Return a smooth trajectory with the measured values, except at rows that the reader did not use."""
    assert smooth.coordinates is not None
    assert measured.coordinates is not None
    unused = at_replaced(smooth, smooth.time)[:, None]
    values = np.where(unused, smooth.coordinates[0], measured.coordinates[0])
    return replace(smooth, coordinates=np.stack([values, *smooth.coordinates[1:]]))


def _simulated(arguments: Arguments, progress: Progress) -> tuple[Report, ss.IdentificationResult]:
    given = [name for name in ("no_friction", "enforce_physical", "drive_terms") if getattr(arguments, name)]
    if given:
        raise ValueError(f"{given[0]}: applies to measured forces; add --measured")
    if log_format(arguments) != ss.TrajectoryFormat() or arguments.pose_guess is not None:
        of_files = "--pose-guess and options of the trajectory file"
        raise ValueError(f"{of_files}: apply to measured forces; add --measured")
    _need_both(arguments)
    robot = robot_of(arguments.robot)
    names = ("period", "samples", "candidates", "seed", "identical_legs")
    options: dict[str, Any] = {name: getattr(arguments, name) for name in names}
    options["harmonics"] = 5 if arguments.harmonics is None else arguments.harmonics
    excited = ss.choose_excitation(robot, progress=progress, **options)
    progress("identifying")
    std = (arguments.position_std or 0.0, arguments.angle_std or 0.0)
    found = ss.simulate_experiment(robot, excited, arguments.force_std, arguments.seed, *std)
    return simulated_report(robot, found), found.estimate
