"""``stewart-sym simulate``: let a machine move under its legs' forces: a table, a summary and pictures."""

import argparse
import dataclasses
from pathlib import Path

from ...io.error_policy import warn
from ...io.extras import need
from ..inputs import warn_of_doubts
from ..options import output
from ..output import results

HELP = "let a machine move under its legs' forces: a table, a summary and pictures"
EXAMPLE = "stewart-sym simulate swing.toml -o swing"
MORE = (
    "The scene is a TOML file: schema = 1, robot (a file beside it), duration (s), and optionally "
    'formulation, output_step (s), method, rtol, start ("path": at the beginning of the path that is '
    'tracked, instead of [state]), on_force_limit ("stop", or "saturate": forces are clipped). [state]: t, '
    "theta (roll, pitch, yaw), v, omega. [load]: F_ext, M_ext, platform frame. [stop_conditions]: max_condition, "
    'min_length, min_joint_sine. [actuation]: type = "constant_force" with forces; "spring" with stiffness, damping, '
    'rest_length (without it they balance the weight at the start); "computed_torque" by computed torque with path '
    "(I, II, III or a CSV file as for `forces`), gains k_p and k_d, model, rate (Hz). SI units. A run stops "
    "where a leg reaches a limit of length, speed, force or joint angle, which is an error at the start."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("scene", metavar="SCENE.toml", type=Path, help="scene file, schema 1")
    parser.add_argument(
        "--energy-drift",
        action="store_true",
        help="compare the energy in both formulations, without friction and dampers (springs only)",
    )
    output(parser, "DIR", "folder to write to", Path("simulation"), plots=True, html=True)


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
        raise ValueError("energy drift: expected a scene whose legs are springs")
    with results(arguments, "summary", "run.csv", read=scene.files) as (take, progress):
        done = scene.run(lambda share: progress("simulating", share))
        if done.stop.kind != "duration" and done.stop.time == 0.0:
            why = f"the run stops at its start, nothing was written: {done.stop.text}"
            raise ValueError(f"{arguments.scene}: {why}; start within the limits")
        drifts = None
        if arguments.energy_drift and isinstance(scene.law, LegSprings):
            progress("comparing the formulations")
            drifts = energy_drift(scene.law, scene.state, scene.duration, scene.rtol, scene.thresholds)
        report = run.report(scene.robot, done, scene.law, drifts or {})
        views = {"run": lambda: Viewer(scene.robot, of_run(scene.robot, done))}
        take(dataclasses.replace(report, views=views))
    return 0
