"""``stewart-sym view``: a machine in motion as one HTML file."""

import argparse
import csv
import os
import sys
import warnings
from pathlib import Path
from typing import TYPE_CHECKING

from ...io.error_policy import warn
from ...io.progress import Progress
from ..inputs import robot_of, trajectory_of
from ..options import log_options, output, robot_file
from ..output import need_html, reject_inputs, results

if TYPE_CHECKING:
    from ...robot.robot import Robot
    from ...viewer.motion_history import MotionHistory
    from ...viewer.view import Viewer

HELP = "show a machine in motion as one HTML file"
EXAMPLE = "stewart-sym view hexapod.toml trajectory.csv -o machine.html"
MORE = (
    "MOTION is a path of the paper (I, II, III), a CSV file as for `forces`, or the results of `simulate`.\n"
    "The default is the home pose.\n"
    "Without -o, the file is opened in a browser.\n"
    "Limits of legs and motors are compared as in `forces`."
)

_RUN = "run.csv"
_DEFAULT = Path("machine.html")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser, nargs="?")
    parser.add_argument(
        "motion", metavar="MOTION", nargs="?", help="I, II, III, a CSV file, or the folder of a simulation"
    )
    parser.add_argument("--example", action="store_true", help="show the robot of the paper on its Path I")
    log_options(parser)
    output(parser, "FILE.html", "HTML file; - for standard output", str(_DEFAULT))


def run(arguments: argparse.Namespace) -> int:
    from ...io.atomic_write import result_file
    from ...robots import dasgupta1998
    from ...studies.common.report import Report
    from ...viewer.page import BEGINNING
    from ...viewer.view import Viewer

    if arguments.example and arguments.robot is not None:
        raise ValueError("--example: shows the robot of the paper; omit ROBOT.toml")
    if not arguments.example and arguments.robot is None:
        raise ValueError("ROBOT.toml: missing; name a robot file, or use --example")
    path = _DEFAULT if arguments.output is None else arguments.output
    read = [] if arguments.motion is None else [Path(arguments.motion)]
    reject_inputs("-o", path, *([] if arguments.robot is None else [arguments.robot]), *read)
    need_html("-o", path)
    if path == arguments.json:
        raise ValueError(f"--json {arguments.json}: the same file as -o; name another file")
    with (
        results(arguments, read=read) as (take, progress),
        result_file(path, [BEGINNING], arguments.force) as stream,
    ):
        robot = dasgupta1998() if arguments.example else robot_of(arguments.robot)
        shown = Viewer(robot, _motion(robot, arguments, progress))
        progress("writing the page")
        stream.write(shown.html)
        said = [] if str(path) == "-" else [f"{shown.title}", f"Written to {path}"]
        take(Report("\n".join(said), data=_data(shown)))
    for _, line in shown.limits.told:
        warn(line)
    if arguments.output is None and not _opened(path):
        print(f"no screen found; open {path.resolve()} in a browser", file=sys.stderr)
    return 0


def _motion(robot: "Robot", arguments: argparse.Namespace, progress: Progress) -> "MotionHistory":
    from ...dynamics.home_pose import home_pose
    from ...motion.straight_line import PAPER_PATHS
    from ...viewer import motion_history

    name = "I" if arguments.example else arguments.motion
    if name is None:
        return motion_history.at_home(robot, home_pose(robot).t)
    if name in PAPER_PATHS:
        return motion_history.of_path(robot, name)
    path = Path(name)
    if path.is_dir():
        path = path / _RUN
    if not path.exists():
        raise ValueError(
            f"{path}: expected I, II, III, a CSV file, or a folder with {_RUN}; the file does not exist"
        )
    if _is_run(path):
        progress("reading the run")
        return motion_history.of_run_file(robot, path)
    trajectory = trajectory_of(robot, path, arguments, progress)
    progress("computing forces and singular poses")
    return motion_history.of_trajectory(robot, trajectory)


def _is_run(path: Path) -> bool:
    """Return True if a table contains the states and forces of a simulated run."""
    with open(path, encoding="utf-8", errors="replace", newline="") as stream:
        header = next(csv.reader(stream), [])
    return {"omega_x", "F_1", "kinetic_energy"} <= {name.strip() for name in header}


def _data(view: "Viewer") -> dict[str, object]:
    import numpy as np

    shown = view.history
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
        "marked": [
            {"time_s": event.time, "singular": event.singular, "twist": event.at.twist}
            for event in shown.events
        ],
        "units": {"twist": "m/s and rad/s"},
    }


def _legs(view: "Viewer") -> object:
    """Return peaks, limits, standard deviations, and limit status of each leg, as in ``forces``."""
    import numpy as np

    from ...drives.leg_limits import limited_angles
    from ...studies.reports.track import Digest, Part

    shown, found = view.history, view.limits
    sd, there = (None, None) if shown.noise is None else (shown.noise.sd, shown.noise.there)
    status = np.zeros(len(shown.time), dtype=np.int32)
    whole = Part(slice(None), shown.time, found.F, shown.L, shown.L_dot, shown.condition, status)
    digest = Digest(view.robot, shown.time)
    angles = limited_angles(view.robot, shown.motion)
    digest.add(whole._replace(effort=found.motors, sd=sd, there=there, angles=angles))
    return digest.as_json()["legs"]


def _opened(path: Path) -> bool:
    """Open a file in a browser; return False without a screen or a browser."""
    import webbrowser

    screen = sys.platform in ("darwin", "win32") or any(
        os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER")
    )
    return screen and webbrowser.open(path.resolve().as_uri())
