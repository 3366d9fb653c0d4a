"""``stewart-sym reproduce``: section 5 of the paper again."""

import argparse
from pathlib import Path

from ..options import no_pictures, output
from ..results import drawing, results_folder
from ..terminal import progress_line

HELP = "compute section 5 of the paper again: tables, CSV, and the pictures of Figs. 4-10"
EXAMPLE = "stewart-sym reproduce -o reproduce"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``reproduce``."""
    output(parser, "DIR", "folder to write to", Path("reproduce"))
    no_pictures(parser)


def run(arguments: argparse.Namespace) -> int:
    """Run ``reproduce``; returns the exit code."""
    from ...io.writing import replaced_file
    from ...studies.common.output import csv_lines
    from ...studies.paper.report import report
    from ...studies.paper.reproduce import reproduce, run_columns

    if arguments.pictures:
        plots = drawing()
    with results_folder(arguments, "report.txt") as folder, progress_line() as progress:
        found = reproduce(progress)
        for (path, formulation), run in found.runs.items():
            with replaced_file(folder / f"path_{path}_{formulation}.csv") as stream:
                stream.writelines(csv_lines(run_columns(run)))
        text = report(found)
        (folder / "report.txt").write_text(text, encoding="utf-8", newline="\n")
        if arguments.pictures:
            plots.draw(found, folder, progress)
        names = sorted(path.name for path in folder.iterdir())
    print(text)
    print(f"Written to {arguments.output}: {', '.join(names)}")
    return 0
