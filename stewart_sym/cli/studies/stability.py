"""Test the kernels near failures against wider arithmetic.

--cases without -o runs only random cases; exit code 1 if a result of a random case with status OK is wrong or
a good pose is rejected.
Requires a compiler with a long double of 64 bits or more.
A million random cases take about five minutes on two cores.

Example: stewart-sym stability -o stability
"""

from pathlib import Path

from ...studies.common.report import Report
from ..command import Arguments, Parser, results, whole

CASES = 1_000_000
"""Number of random cases of the sweep."""


def add_arguments(parser: Parser) -> None:
    parser.valued("cases", whole, f"number of random cases; default with -o: {CASES:,}", metavar="N")
    parser.seed()
    parser.output("DIR", "folder of the results", otherwise="stability", plots=True, html=True)


def run(arguments: Arguments) -> int:
    from ...studies.robustness import study

    cases = CASES if arguments.cases is None else arguments.cases
    random_only = arguments.cases is not None and arguments.output is None
    if not random_only:
        arguments.output = arguments.output or Path("stability")
    with results(arguments, None if random_only else "stability") as (take, progress):
        found = [] if random_only else study.courses(progress)
        swept = study.sweep(cases, arguments.seed, progress)
        report = Report(study.sweep_report(swept), data=swept)
        take(report if random_only else study.full_report(found, swept))
    return 1 if swept["wrong"] or swept["rejected_good"] else 0
