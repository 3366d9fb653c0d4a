"""``stewart-sym bench``: times of the kernels and of the baselines."""

import argparse
from pathlib import Path

from ..inputs import robot_of
from ..options import output
from ..results import results_folder
from ..terminal import progress_line

HELP = "time the kernels beside CasADi, Pinocchio, MuJoCo and the processor's limit: tables, JSON, pictures"
EXAMPLE = "stewart-sym bench -o bench"
MORE = (
    "Answers are compared before anything is timed. Of CasADi, Pinocchio and MuJoCo, the extra bench,"
    " what is not installed is left out. Takes a minute or two on an otherwise idle machine."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``bench``."""
    output(parser, "DIR", "folder to write to", Path("bench"))
    parser.add_argument("--quick", action="store_true", help="fewer rounds and smaller batches")
    parser.add_argument(
        "--robot", metavar="ROBOT.toml", type=Path, help="robot file, schema 1; default: the paper's machine"
    )


def run(arguments: argparse.Namespace) -> int:
    """Run ``bench``; returns the exit code."""
    import json

    from ...studies.benchmark import bench, plot

    robot = None if arguments.robot is None else robot_of(arguments.robot)
    with results_folder(arguments, "bench.txt", "bench.json") as folder:
        with progress_line() as progress:
            found = bench.bench(robot, arguments.quick, progress)
            progress("drawing")
            plot.draw(found, folder)
        text = plot.report(found)
        (folder / "bench.txt").write_text(text, encoding="utf-8", newline="\n")
        figures = json.dumps(found.as_json(), indent=1) + "\n"
        (folder / "bench.json").write_text(figures, encoding="utf-8", newline="\n")
        names = sorted(path.name for path in folder.iterdir())
    print(text)
    print(f"Written to {arguments.output}: {', '.join(names)}")
    return 0
