"""``stewart-sym control``: controllers that differ in their model."""

import argparse
import warnings
from pathlib import Path

from ..inputs import robot_of
from ..options import no_pictures, output, positive
from ..results import drawing, results_folder
from ..terminal import progress_line

HELP = "track the paper's paths with controllers that differ in their model: table, CSV, JSON, pictures"
EXAMPLE = "stewart-sym control -o control --path II"
MORE = (
    "The plant is `exact`; forces are held between samples. Computed torque by `exact`, by `paper` "
    "and by the platform alone (massless legs), and PD with gravity compensation: the same gains, the"
    " same start a little off the path. Without --robot: the paper's machine, as printed and with "
    "friction that counts. Takes about half a minute."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``control``."""
    output(parser, "DIR", "folder to write to", Path("control"))
    parser.add_argument("--path", choices=("I", "II"), help="track this path alone; default: both")
    parser.add_argument(
        "--robot", metavar="ROBOT.toml", type=Path, help="robot file, schema 1; default: the paper's machine"
    )
    parser.add_argument(
        "--rate", metavar="HZ", type=positive, default=1000.0, help="of the controllers, Hz; default: 1000"
    )
    no_pictures(parser)


def run(arguments: argparse.Namespace) -> int:
    """Run ``control``; returns the exit code."""
    import json

    from ...io.writing import replaced_file
    from ...studies.common.output import csv_lines
    from ...studies.control import control
    from ...studies.control import report as control_report
    from ...studies.reports import run

    if arguments.pictures:
        drawing()
    machines = control.papers_machines()
    if arguments.robot is not None:
        machines = {"robot": robot_of(arguments.robot)}
    paths = control.TRACKED if arguments.path is None else (arguments.path,)
    settings = control.Settings(rate=arguments.rate)
    with (
        results_folder(arguments, "control.txt", "control.csv", "control.json") as folder,
        progress_line() as progress,
    ):
        studies = {
            label: control.track_paths(robot, paths, settings, progress) for label, robot in machines.items()
        }
        text = control_report.report(studies)
        figures = json.dumps(control_report.as_json(studies), indent=1) + "\n"
        texts = {"txt": text + "\n", "csv": control_report.csv_rows(studies), "json": figures}
        for kind, content in texts.items():
            (folder / f"control.{kind}").write_text(content, encoding="utf-8", newline="\n")
        for number, (label, study) in enumerate(studies.items()):
            suffix = f"_{label}" if number else ""
            for path, runs in study.runs.items():
                with replaced_file(folder / f"path_{path}{suffix}.csv") as stream:
                    stream.writelines(csv_lines(control_report.run_columns(runs)))
            if arguments.pictures:
                progress("drawing")
                run.save(control_report.figure(study), folder / f"control{suffix}.png")
        names = sorted(path.name for path in folder.iterdir())
    print(text)
    print(f"Written to {arguments.output}: {', '.join(names)}")
    for study in studies.values():
        for line in study.exceeded:
            warnings.warn(line, stacklevel=2)
    return 0
