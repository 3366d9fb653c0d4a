"""Simulate the motion of a machine under its actuator forces.

All keys of the scene are on page "Files" of the documentation.
Actuation: constant forces, springs, or computed torque along a path.
A run stops at a limit of leg length, speed, force, or joint angle.
Output: summary.txt, run.csv, and drawings.
Text and drawings have the units of the robot file; run.csv has SI units.

Example: stewart-sym simulate swing.toml -o swing
"""

import dataclasses

import stewart_sym as ss

from ...io.error_policy import warn
from ...simulation.scene import read_scene
from ...simulation.scene_checks import start_doubts
from ...studies.reports.simulation_report import report
from ..command import Arguments, Parser, results
from ..inputs import warn_of_doubts


def add_arguments(parser: Parser) -> None:
    parser.file("scene")
    parser.output("DIR", "folder of the results", "simulation", plots=True, html=True)


def run(arguments: Arguments) -> None:
    scene = read_scene(arguments.scene)
    warn_of_doubts(scene.robot, scene.files[1])
    for doubt in start_doubts(scene):
        warn(f"{arguments.scene}: {doubt}")
    with results(arguments, "summary", "run.csv", read=scene.files) as (take, progress):
        done = scene.run(lambda share: progress("simulating", share))
        if done.stop.reason != "completed" and done.stop.time == 0.0:
            why = f"the run stops at its start, nothing was written: {done.stop.message}"
            raise ValueError(f"{arguments.scene}: {why}; start within the limits")
        views = {"run": lambda: ss.view(scene.robot, done)}
        take(dataclasses.replace(report(scene.robot, done, scene.law, scene.reference), views=views))
