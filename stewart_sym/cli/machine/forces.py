"""``stewart-sym forces``: actuator forces along a trajectory."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from ...io.error_policy import SingularPoseWarning, warn
from ..inputs import robot_of, trajectory_of
from ..options import chosen, formulation, log_options, output, positive, robot_file, valued
from ..output import reject_inputs, results

if TYPE_CHECKING:
    from ...robot.robot import Robot

HELP = "compute the actuator forces along a trajectory"
EXAMPLE = "stewart-sym forces hexapod.toml log.csv -o forces.csv --length-unit mm --angle-unit deg"
MORE = (
    "Input: time, t_x t_y t_z, and theta_x theta_y theta_z or q_w q_x q_y q_z; or time and L_1 to L_6.\n"
    "Optional: rates, accelerations, F_ext_*, M_ext_*. Default units: SI.\n"
    "Noisy columns are smoothed; F_1_std to F_6_std are the standard deviations of the forces.\n"
    "A drive adds motor columns."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser)
    parser.add_argument(
        "trajectory", metavar="TRAJECTORY.csv", type=Path, help="CSV file of times and poses or leg lengths"
    )
    formulation(parser)
    chosen(parser, "backend", ("c", "numpy", "reference"), "implementation")
    parser.add_argument("--reactions", action="store_true", help="add columns of the joint reactions")
    parser.add_argument(
        "--plot",
        type=Path,
        metavar="FILE.png",
        help="drawing of the motor torques, for a robot with a drive; requires Matplotlib",
    )
    chosen(parser, "on-singular", ("raise", "nan"), "treatment of unsolvable poses: an error, or rows of nan")
    text = "fraction of the peak force of a leg that three standard deviations may reach without a warning"
    valued(parser, "noise-threshold", positive, text, 0.02, "FRACTION")
    log_options(parser)
    output(parser, "FILE.csv", "CSV file; - for standard output", None, html=True)


def run(arguments: argparse.Namespace) -> int:
    from ...drives.leg_limits import replaced_rows
    from ...io.atomic_write import result_file
    from ...motion.log_rates import noise_text
    from ...singularities.path_warnings import crossing_warning
    from ...studies.common.output import csv_lines
    from ...studies.common.report import Picture, Report, draw
    from ...studies.reports.track import Digest, header_lines, in_parts
    from ...viewer.motion_history import of_trajectory
    from ...viewer.view import Viewer

    robot = robot_of(arguments.robot)
    if arguments.plot is not None:
        _need_plot(arguments, robot)
    with (
        results(arguments) as (take, progress),
        result_file(arguments.output, header_lines(), arguments.force) as stream,
    ):
        trajectory = trajectory_of(robot, arguments.trajectory, arguments, progress)
        digest = Digest(robot, trajectory.time, replaced_rows(trajectory))
        count = len(trajectory.time)
        progress(f"computing {count} samples", 0.0)
        for part in in_parts(
            robot,
            trajectory,
            arguments.formulation,
            arguments.backend,
            arguments.reactions,
            arguments.on_singular == "nan",
        ):
            stream.writelines(csv_lines(part.columns, header=part.where.start == 0))
            digest.add(part)
            progress(f"computing {count} samples", min(1.0, part.where.stop / count))
        progress("looking for singular poses")
        crossed = crossing_warning(robot, trajectory)
        if crossed is not None:
            warn(crossed, SingularPoseWarning)
        lines = []
        if str(arguments.output) != "-":
            lines = [digest.summary(), f"Written to {arguments.output}"]
            if arguments.plot is not None:
                lines.append(f"Drawn as {arguments.plot}")
            if trajectory.noise is not None and trajectory.noise.sigma.any():
                lines.insert(1, f"{noise_text(trajectory.noise)}; F_std is the remaining standard deviation")
        tables, figures = {}, {}
        if digest.drive is not None:
            tables["motors"] = digest.drive.csv()
            if arguments.plot is not None:
                figures["motor_torque"] = Picture(digest.drive.figure)
                draw(figures["motor_torque"], arguments.plot.with_suffix(""))
        doubts = digest.doubts(arguments.noise_threshold)
        views = {"motion": lambda: Viewer(robot, of_trajectory(robot, trajectory))}
        data = {**digest.as_json(), "warnings": doubts}
        take(Report("\n".join(lines), tables, data, figures, views))
    for line in doubts:
        warn(line)
    return 0


def _need_plot(arguments: argparse.Namespace, robot: "Robot") -> None:
    """Reject ``--plot`` for a robot without drives, for other formats than PNG, or over an existing file."""
    from ...io.extras import need

    need("matplotlib", "drawing")
    path = arguments.plot
    if robot.drive is None:
        raise ValueError(f"--plot {path}: the robot has no drive; add [legs.drive]")
    if path.suffix != ".png":
        raise ValueError(f"--plot {path}: the file name must end in .png")
    reject_inputs("--plot", path, arguments.robot, arguments.trajectory)
    if path.exists() and not arguments.force:
        raise ValueError(f"--plot {path}: the file exists; use --force to overwrite it")
