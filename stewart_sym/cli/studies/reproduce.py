"""``stewart-sym reproduce``: section 5 of the paper again."""

import argparse
from pathlib import Path

from ..options import output
from ..output import results

HELP = "compute section 5 of the paper again: tables, CSV, and the pictures of Figs. 4-10"
EXAMPLE = "stewart-sym reproduce -o reproduce"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    output(parser, "DIR", "folder to write to", Path("reproduce"), plots=True, html=True)


def run(arguments: argparse.Namespace) -> int:
    from ...studies.paper.paper_report import full_report
    from ...studies.paper.reproduce import reproduce

    with results(arguments, "report") as (take, progress):
        take(full_report(reproduce(progress)))
    return 0
