"""Reproduce section 5 of the paper: tables, CSV files, and Figs. 4-10.

Example: stewart-sym reproduce -o reproduce
"""

import argparse
from pathlib import Path

from ..options import output
from ..output import results


def add_arguments(parser: argparse.ArgumentParser) -> None:
    output(parser, "DIR", "folder of the results", Path("reproduce"), plots=True, html=True)


def run(arguments: argparse.Namespace) -> int:
    from ...studies.paper.paper_report import full_report
    from ...studies.paper.reproduce import reproduce

    with results(arguments, "report") as (take, progress):
        take(full_report(reproduce(progress)))
    return 0
