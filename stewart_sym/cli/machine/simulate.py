"""``stewart-sym simulate``: let a machine move under its legs' forces: a table, a summary and pictures."""

import argparse
import warnings
from pathlib import Path

from ...io.extras import need
from ..inputs import warn_of_doubts
from ..options import no_pictures, output
from ..results import drawing, results_folder
from ..terminal import progress_line, shares

HELP = "let a machine move under its legs' forces: a table, a summary and pictures"
EXAMPLE = "stewart-sym simulate swing.toml -o swing"
MORE = (
    "The scene is a TOML file: schema = 1, robot (a file beside it), duration (s), and if you like "
    "formulation, output_step (s), method, rtol. [state]: t, theta (roll, pitch, yaw), v, omega. "
    "[load]: F_ext, M_ext, platform frame. [thresholds]: max_condition, min_length, min_joint_sine. "
    '[legs]: law = "forces" with forces; "springs" with stiffness, damping, rest_length (without it '
    'they balance the weight at the start); "tracking" by computed torque with path (I, II, III or a '
    "CSV file as for `forces`), gains k_p and k_d, model, rate (Hz). SI units. A run stops where a "
    "leg reaches a limit."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``simulate``."""
    parser.add_argument("scene", metavar="SCENE.toml", type=Path, help="scene file, schema 1")
    output(parser, "DIR", "folder to write to", Path("simulation"))
    parser.add_argument(
        "--energy-drift",
        action="store_true",
        help="compare the energy in both formulations, without friction and dampers (springs only)",
    )
    no_pictures(parser)


def run(arguments: argparse.Namespace) -> int:
    """Run ``simulate``; returns the exit code."""
    from ...io.writing import replaced_file
    from ...simulation.scene import read_scene
    from ...studies.common.output import csv_lines
    from ...studies.reports import energy_drift, run

    need("scipy", "simulation")
    if arguments.pictures:
        drawing()
    scene = read_scene(arguments.scene)
    warn_of_doubts(scene.robot, arguments.scene)
    springs = energy_drift.springs_of(scene) if arguments.energy_drift else None
    with (
        results_folder(arguments, "summary.txt", "run.csv", read=scene.files) as folder,
        progress_line() as progress,
    ):
        done = scene.run(shares(progress, "simulating"))
        tables = {"run": run.run_columns(done)}
        text = run.summary(done, scene.law)
        drifts = {}
        if springs is not None:
            progress("comparing the formulations")
            drifts = energy_drift.energy_drift(
                springs, scene.state, scene.duration, scene.rtol, scene.thresholds
            )
            tables |= {f"energy_drift_{name}": drift.columns() for name, drift in drifts.items()}
            text += "\n" + energy_drift.summary(drifts)
        for name, columns in tables.items():
            with replaced_file(folder / f"{name}.csv") as stream:
                stream.writelines(csv_lines(columns))
        (folder / "summary.txt").write_text(text + "\n", encoding="utf-8", newline="\n")
        if arguments.pictures:
            progress("drawing")
            pictures = {"run": run.figure(done)} | (
                {"energy_drift": energy_drift.figure(drifts)} if drifts else {}
            )
            for name, picture in pictures.items():
                if picture is None:
                    warnings.warn(f"{name}.png: not drawn, the run ended where it began", stacklevel=2)
                else:
                    run.save(picture, folder / f"{name}.png")
        names = sorted(path.name for path in folder.iterdir())
    print(text)
    print(f"Written to {arguments.output}: {', '.join(names)}")
    return 0
