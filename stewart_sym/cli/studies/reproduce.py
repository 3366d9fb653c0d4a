"""``stewart-sym reproduce``: section 5 of the paper again."""

import argparse
from pathlib import Path

from ..options import html_file, json_file, no_pictures, output
from ..results import need_drawing, results
from ..terminal import progress_line

HELP = "compute section 5 of the paper again: tables, CSV, and the pictures of Figs. 4-10"
EXAMPLE = "stewart-sym reproduce -o reproduce"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``reproduce``."""
    output(parser, "DIR", "folder to write to", Path("reproduce"))
    no_pictures(parser)
    html_file(parser)
    json_file(parser)


def run(arguments: argparse.Namespace) -> int:
    """Run ``reproduce``; returns the exit code."""
    from ...studies.paper.report import full_report
    from ...studies.paper.reproduce import reproduce

    need_drawing(arguments)
    with results(arguments, "report") as take, progress_line() as progress:
        take(full_report(reproduce(progress)), progress)
    return 0
