"""Convert a trajectory file of any format to the standard format.

Input: as for `forces`. Output: time and poses, or leg lengths, with rates and accelerations in SI units.
With a robot, its file supplies the format, poses refer to its tool, and leg lengths become poses.

Example: stewart-sym convert log.csv -o clean.csv --robot hexapod.toml --rate 100
"""

import numpy as np

from ...kinematics.trajectory_writer import BEGINNINGS, csv_lines_of
from ...motion.trajectory import Trajectory, noise_text
from ...studies.common.report import Report
from ..command import Arguments, Parser, results
from ..inputs import robot_of, trajectory_of


def add_arguments(parser: Parser) -> None:
    parser.file("trajectory")
    parser.file("robot", "--robot", help="robot file; default: columns are converted as they are")
    parser.log()
    parser.output("FILE.csv", "CSV file; - for standard output")


def run(arguments: Arguments) -> None:
    with results(arguments, beginnings=BEGINNINGS) as (take, progress):
        robot = None if arguments.robot is None else robot_of(arguments.robot)
        trajectory = trajectory_of(robot, arguments.trajectory, arguments, progress)
        take(_report(trajectory), "".join(csv_lines_of(trajectory, robot)))


def _report(trajectory: Trajectory) -> Report:
    """Create the report: number of rows, times, rate, and noise."""
    time = trajectory.time
    rate = 1.0 / float(np.median(np.diff(time))) if len(time) > 1 else 0.0
    kind = "leg lengths" if trajectory.in_joints else "poses"
    lines = [f"{len(time)} {kind}, {time[0]:.10g} to {time[-1]:.10g} s, {rate:.4g} Hz"]
    noise = trajectory.noise
    data = {"rows": len(time), "start_s": time[0], "end_s": time[-1], "rate_Hz": rate, "content": kind}
    if noise is not None and noise.sigma.any():
        text = noise_text(noise.sigma, trajectory.has_lengths)
        lines.append(f"{text}; the file does not contain it: use the log itself for limits")
        data["noise_std"] = noise.sigma
    return Report("\n".join(lines), data=data)
