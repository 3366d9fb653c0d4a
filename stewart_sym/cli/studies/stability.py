"""Test all methods near degenerate configurations against 50-digit arithmetic.

--cases without -o runs only random cases; exit code 1 if a result with status OK is wrong or a
solvable pose is rejected.
Requires a compiler with __float128.
The families take about two minutes, and a million random cases another minute.

Example: stewart-sym stability -o stability
"""

import argparse
from pathlib import Path

from ...studies.common.report import Report
from ..options import output, seed, valued, whole
from ..output import results

CASES = 1_000_000
"""Number of random cases of the sweep."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    valued(parser, "cases", whole, f"number of random cases; default with -o: {CASES:,}", metavar="N")
    seed(parser)
    output(parser, "DIR", "folder of the results", "stability", plots=True, html=True)


def run(arguments: argparse.Namespace) -> int:
    from ...studies.robustness import study
    from ...studies.robustness.pictures import pictures
    from ...studies.robustness.sweep.sweep import report, sweep

    if arguments.cases is not None and arguments.output is None:
        with results(arguments) as (take, progress):
            swept = sweep(arguments.cases, arguments.seed, progress)
            take(Report(report(swept), data=swept.figures))
        return 1 if swept.figures["wrong"] or swept.figures["rejected_good"] else 0
    arguments.output = arguments.output or Path("stability")
    cases = CASES if arguments.cases is None else arguments.cases
    with results(arguments, "stability") as (take, progress):
        found = study.study(progress)
        take(study.full_report(*found, sweep(cases, arguments.seed, progress), pictures(*found)))
    return 0
