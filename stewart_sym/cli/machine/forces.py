"""Compute the actuator forces along a trajectory.

Input: time, t_x t_y t_z, and theta_x theta_y theta_z or q_w q_x q_y q_z; or time and L_1 to L_6.
Optional: rates, accelerations, F_ext_*, M_ext_*. Default units: SI.
Noisy columns are smoothed; F_1_std to F_6_std are the standard deviations of the forces.
A drive adds motor columns.

Example: stewart-sym forces hexapod.toml log.csv -o forces.csv --length-unit mm --angle-unit deg
"""

from pathlib import Path

import stewart_sym as ss

from ...io.error_policy import need, warn
from ...io.output import must_be_replaceable, write_file
from ...singularities.path_warnings import crossing_warning
from ...studies.common.report import SMALL, Picture, Report, draw, is_own_png
from ...studies.reports.force_report import HEADERS, NOISE_THRESHOLD, ForceReport
from ..command import Arguments, Parser, positive, results
from ..inputs import robot_of, trajectory_of


def add_arguments(parser: Parser) -> None:
    parser.file("robot")
    parser.file("trajectory")
    parser.formulation()
    parser.chosen("backend", ("c", "numpy", "reference"), "implementation")
    parser.flag("reactions", "add columns of the joint reactions")
    text = "plot of the forces, and with a drive of the motor torques, with the limits; requires Matplotlib"
    parser.valued("plot", Path, text, metavar="FILE.png")
    parser.chosen("on-singular", ("raise", "nan"), "treatment of unsolvable poses: an error, or rows of nan")
    text = "fraction of the peak force of a leg that three standard deviations may reach without a warning"
    parser.valued("noise-threshold", positive, text, NOISE_THRESHOLD, "FRACTION")
    parser.log()
    parser.output("FILE.csv", "CSV file; - for standard output", html=True)


def run(arguments: Arguments) -> None:
    robot = robot_of(arguments.robot)
    if arguments.plot is not None:
        need("matplotlib", "drawing")
        if arguments.plot.suffix != ".png":
            raise ValueError(f"--plot {arguments.plot}: the file name must end in .png")
        inputs = [arguments.robot, arguments.trajectory]
        must_be_replaceable(arguments.plot, is_own_png(arguments.plot), arguments.force, inputs)
    with results(arguments, beginnings=HEADERS) as (take, progress):
        trajectory = trajectory_of(robot, arguments.trajectory, arguments, progress)
        how = (arguments.formulation, arguments.backend, arguments.reactions, arguments.on_singular == "nan")
        found = ForceReport(robot, trajectory, *how)
        write_file(arguments.output, found.rows(progress))
        progress("looking for singular poses")
        crossed = crossing_warning(robot, trajectory)
        lines = ["no force is sufficient: the path crosses a singular pose"] if crossed else []
        lines.append(found.summary())
        figures = {} if arguments.plot is None else {"forces": Picture(found.figure, SMALL)}
        for picture in figures.values():
            draw(picture, arguments.plot.with_suffix(""))
            lines.append(f"Drawn as {arguments.plot}")
        doubts = [*([crossed] if crossed else []), *found.doubts(arguments.noise_threshold)]
        views = {"motion": lambda: ss.view(robot, trajectory)}
        data = {**found.as_json(), "warnings": doubts}
        take(Report("\n".join(lines), data=data, figures=figures, views=views))
    for line in doubts:
        warn(line)
