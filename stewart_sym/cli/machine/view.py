"""Show a machine in motion as one HTML file.

MOTION is a path of the paper (I, II, III), a CSV file as for `forces`, or the results of `simulate`.
The default is the home pose.
Without -o, the file is opened in a browser.
Limits of legs and motors are compared as in `forces`.

Example: stewart-sym view hexapod.toml trajectory.csv -o machine.html
"""

import argparse
import csv
import os
import sys
import warnings
import webbrowser
from pathlib import Path

import numpy as np

import stewart_sym as ss

from ...drives.leg_limits import limited_angles
from ...dynamics.home_pose import home_pose
from ...io.atomic_write import write_file
from ...io.error_policy import warn
from ...io.progress import Progress
from ...studies.common.report import Report
from ...studies.reports.track import Digest, Part
from ...viewer import motion_history
from ...viewer.motion_history import MotionHistory
from ...viewer.page import BEGINNING
from ..inputs import robot_of, trajectory_of
from ..options import flag, log_options, output, robot_file
from ..output import need_html, results

_RUN = "run.csv"
_DEFAULT = Path("machine.html")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser, nargs="?")
    text = "I, II, III, a CSV file, or the folder of a simulation"
    parser.add_argument("motion", metavar="MOTION", nargs="?", help=text)
    flag(parser, "example", "show the robot of the paper on its Path I")
    log_options(parser)
    output(parser, "FILE.html", "HTML file; - for standard output", str(_DEFAULT))


def run(arguments: argparse.Namespace) -> int:
    if arguments.example == (arguments.robot is not None):
        raise ValueError("ROBOT.toml: expected either a robot file or --example, the robot of the paper")
    shown_at_once = arguments.output is None
    path = arguments.output = arguments.output or _DEFAULT
    need_html("-o", path)
    read = [] if arguments.motion is None else [Path(arguments.motion)]
    with results(arguments, read=read, beginnings=[BEGINNING]) as (take, progress):
        robot = ss.robots.dasgupta1998() if arguments.example else robot_of(arguments.robot)
        shown = ss.Viewer(robot, _motion(robot, arguments, progress))
        progress("writing the page")
        write_file(path, shown.html)
        take(Report(shown.title, data=_data(shown)))
    for _, line in shown.limits.told:
        warn(line)
    if shown_at_once and not _opened(path):
        print(f"no screen found; open {path.resolve()} in a browser", file=sys.stderr)
    return 0


def _motion(robot: ss.Robot, arguments: argparse.Namespace, progress: Progress) -> MotionHistory:
    name = "I" if arguments.example else arguments.motion
    if name is None:
        return motion_history.at_home(robot, home_pose(robot).t)
    if name in ss.PAPER_PATHS:
        return motion_history.of_path(robot, name)
    path = Path(name, _RUN) if Path(name).is_dir() else Path(name)
    if not path.exists():
        raise ValueError(f"{path}: no such file; expected I, II, III, a CSV file, or a folder with {_RUN}")
    if _is_run(path):
        progress("reading the run")
        return motion_history.of_run_file(robot, path)
    trajectory = trajectory_of(robot, path, arguments, progress)
    progress("computing forces and singular instants")
    return motion_history.of_trajectory(robot, trajectory)


def _is_run(path: Path) -> bool:
    """Return True if a table contains the states and forces of a simulated run."""
    with open(path, encoding="utf-8", errors="replace", newline="") as stream:
        header = next(csv.reader(stream), [])
    return {"omega_x", "F_1", "kinetic_energy"} <= {name.strip() for name in header}


def _data(view: ss.Viewer) -> dict[str, object]:
    shown = view.instants
    # NumPy warns of legs without a finite force at any sample.
    with warnings.catch_warnings(action="ignore", category=RuntimeWarning):
        peaks = {name: np.nanmax(np.abs(F), axis=0) for name, F in shown.forces.items()}
    return {
        "motion": shown.name,
        "samples": len(shown.time),
        "start_s": shown.time[0],
        "end_s": shown.time[-1],
        "scaled_condition_number_peak": shown.condition.max(),
        "peak_force_N": peaks,
        "legs": _legs(view),
        "warnings": [line for _, line in view.limits.told],
        "marked": [{"time_s": e.time, "singular": e.singular, "twist": e.at.twist} for e in shown.events],
        "units": {"twist": "m/s and rad/s"},
    }


def _legs(view: ss.Viewer) -> object:
    """Return peaks, limits, standard deviations, and limit status of each leg, as in ``forces``."""
    shown, found = view.instants, view.limits
    sd, there = (None, None) if shown.noise is None else (shown.noise.sd, shown.noise.there)
    status = np.zeros(len(shown.time), dtype=np.int32)
    whole = Part(slice(None), shown.time, found.F, shown.L, shown.L_dot, shown.condition, status)
    digest = Digest(view.robot, shown.time)
    angles = limited_angles(view.robot, shown.motion)
    digest.add(whole._replace(effort=found.motors, sd=sd, there=there, angles=angles))
    return digest.as_json()["legs"]


def _opened(path: Path) -> bool:
    """Open a file in a browser; return False without a screen or a browser."""
    screen = sys.platform in ("darwin", "win32") or any(
        os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER")
    )
    return screen and webbrowser.open(path.resolve().as_uri())
