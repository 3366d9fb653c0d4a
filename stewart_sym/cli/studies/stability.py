"""``stewart-sym stability``: every method near degenerate configurations."""

import argparse
from pathlib import Path

from ..options import output, valued, whole
from ..output import results

HELP = "approach every degenerate configuration with every method: tables, CSV, JSON, pictures"
EXAMPLE = "stewart-sym stability -o stability"
MORE = (
    "Errors are against 50-digit arithmetic. With --cases and no -o only the sweep of random cases "
    "near failure is made; it exits with 1 if an answer is wrong with status ok or a good pose is "
    "rejected. Needs a compiler with __float128. The families take about two minutes, a million cases"
    " another."
)

CASES = 1_000_000
"""Random cases of the sweep."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    valued(parser, "cases", whole, f"random cases near failure; with -o {CASES:,}", metavar="N")
    valued(parser, "seed", whole, "of the random cases", 0)
    output(parser, "DIR", "folder to write to", "stability", plots=True, html=True)


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
