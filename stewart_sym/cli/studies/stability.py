"""``stewart-sym stability``: test all methods near degenerate configurations."""

import argparse
from pathlib import Path

from ..options import output, valued, whole
from ..output import results

HELP = "test all methods near degenerate configurations against 50-digit arithmetic"
EXAMPLE = "stewart-sym stability -o stability"
MORE = (
    "--cases without -o runs only random cases; exit code 1 if a result with status OK is wrong or a\n"
    "solvable pose is rejected.\n"
    "Requires a compiler with __float128.\n"
    "The families take about two minutes, and a million random cases another minute."
)

CASES = 1_000_000
"""Number of random cases of the sweep."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    valued(parser, "cases", whole, f"number of random cases; default with -o: {CASES:,}", metavar="N")
    valued(parser, "seed", whole, "random seed", 0)
    output(parser, "DIR", "folder of the results", "stability", plots=True, html=True)


def run(arguments: argparse.Namespace) -> int:
    from ...studies.common.report import Report
    from ...studies.robustness import study
    from ...studies.robustness.pictures import pictures
    from ...studies.robustness.sweep.sweep import report, sweep

    if arguments.cases is not None and arguments.output is None:
        with results(arguments) as (take, progress):
            swept = sweep(arguments.cases, arguments.seed, progress)
            take(Report(report(swept), data=swept.figures))
        return 1 if swept.figures["wrong"] or swept.figures["rejected_good"] else 0
    arguments.output = arguments.output or Path("stability")
    with results(arguments, "stability") as (take, progress):
        found = study.study(progress)
        cases = CASES if arguments.cases is None else arguments.cases
        take(study.full_report(*found, sweep(cases, arguments.seed, progress), pictures(*found)))
    return 0
