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

HELP = "actuator forces along a trajectory"
EXAMPLE = "stewart-sym forces hexapod.toml log.csv -o forces.csv --length-unit mm --angle-unit deg"
MORE = (
    "The trajectory's first line names its columns: time, t_x t_y t_z (m), theta_x theta_y theta_z (rad) or "
    "q_w q_x q_y q_z; optionally v_*, theta_dot_*, a_* and theta_ddot_* together (else a spline is fitted), "
    "F_ext_* and M_ext_* (platform frame). Or, in joint space: time, L_1 to L_6 (m), optionally L_dot_* and "
    "L_ddot_* together. SI units by default. Columns that show rounding or noise are smoothed; F_1_std to "
    "F_6_std are the standard deviations of the forces due to the noise that remains, and what is within three "
    "deviations of its limit is reported as not decided. Moments M_p are taken about the base points. A "
    "robot with a drive has columns torque_1 (N m), motor_speed_1 (rad/s), current_1 (A) and power_1 (W), with "
    "noise torque_1_std and so on, as well."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser)
    parser.add_argument(
        "trajectory", metavar="TRAJECTORY.csv", type=Path, help="times and poses, or leg lengths"
    )
    formulation(parser)
    chosen(parser, "backend", ("c", "numpy", "reference"))
    parser.add_argument("--reactions", action="store_true", help="write the joint reactions as well")
    parser.add_argument(
        "--plot",
        type=Path,
        metavar="FILE.png",
        help="draw the torques of the motors, of a robot with a drive; needs Matplotlib",
    )
    parser.add_argument(
        "--on-singular",
        choices=("raise", "nan"),
        default="raise",
        help="raise: an unsolvable pose is an error; nan: its row has nan and a status; default: raise",
    )
    text = "warn where three standard deviations exceed this share of a leg's peak force"
    valued(parser, "noise-threshold", positive, text, 0.02, "SHARE")
    log_options(parser)
    output(parser, "FILE.csv", "file to write, - for standard output", None, html=True)


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
        progress(f"computing {count} instants", 0.0)
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
            progress(f"computing {count} instants", min(1.0, part.where.stop / count))
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
                lines.insert(1, f"{noise_text(trajectory.noise)}: F_sd is what it leaves")
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
    """Reject a picture of motors that there are not, of another kind, or in place of another file."""
    from ...io.extras import need

    need("matplotlib", "drawing")
    path = arguments.plot
    if robot.drive is None:
        raise ValueError(f"--plot {path}: expected a robot with a drive ([legs.drive])")
    if path.suffix != ".png":
        raise ValueError(f"--plot {path}: expected a file that ends in .png")
    reject_inputs("--plot", path, arguments.robot, arguments.trajectory)
    if path.exists() and not arguments.force:
        raise ValueError(f"--plot {path}: exists; use --force to overwrite")
