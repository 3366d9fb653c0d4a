"""``stewart-sym simulate``: simulate the motion of a machine under its actuator forces."""

import argparse
import dataclasses
from pathlib import Path

from ...io.error_policy import warn
from ...io.extras import need
from ..inputs import warn_of_doubts
from ..options import output
from ..output import results

HELP = "simulate the motion of a machine under its actuator forces"
EXAMPLE = "stewart-sym simulate swing.toml -o swing"
MORE = (
    'All keys of the scene are on page "Files" of the documentation.\n'
    "Actuation: constant forces, springs, or computed torque along a path.\n"
    "A run stops at a limit of leg length, speed, force, or joint angle.\n"
    "Output: summary.txt, run.csv, and drawings. SI units."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("scene", metavar="SCENE.toml", type=Path, help="scene file, schema 1")
    parser.add_argument(
        "--energy-drift",
        action="store_true",
        help="compare the energy drift of both formulations, without friction and damping (springs only)",
    )
    output(parser, "DIR", "folder of the results", Path("simulation"), plots=True, html=True)


def run(arguments: argparse.Namespace) -> int:
    from ...simulation.actuator_models import LegSprings
    from ...simulation.scene import read_scene
    from ...studies.reports import run
    from ...studies.reports.energy_drift import energy_drift
    from ...studies.reports.scene_checks import start_doubts
    from ...viewer.motion_history import of_run
    from ...viewer.view import Viewer

    need("scipy", "simulation")
    scene = read_scene(arguments.scene)
    warn_of_doubts(scene.robot, arguments.scene)
    for doubt in start_doubts(scene):
        warn(f"{arguments.scene}: {doubt}")
    if arguments.energy_drift and not isinstance(scene.law, LegSprings):
        raise ValueError("--energy-drift: the actuation of the scene is not springs; change the scene")
    with results(arguments, "summary", "run.csv", read=scene.files) as (take, progress):
        done = scene.run(lambda share: progress("simulating", share))
        if done.stop.reason != "completed" and done.stop.time == 0.0:
            why = f"the run stops at its start, nothing was written: {done.stop.message}"
            raise ValueError(f"{arguments.scene}: {why}; start within the limits")
        drifts = None
        if arguments.energy_drift and isinstance(scene.law, LegSprings):
            progress("comparing the formulations")
            drifts = energy_drift(scene.law, scene.state, scene.duration, scene.rtol, scene.stop_conditions)
        report = run.report(scene.robot, done, scene.law, drifts or {})
        views = {"run": lambda: Viewer(scene.robot, of_run(scene.robot, done))}
        take(dataclasses.replace(report, views=views))
    return 0
