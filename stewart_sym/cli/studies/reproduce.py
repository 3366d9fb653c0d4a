"""Reproduce section 5 of the paper: tables, CSV files, and Figs. 4-10.

Example: stewart-sym reproduce -o reproduce
"""

from ..command import Arguments, Parser, results


def add_arguments(parser: Parser) -> None:
    parser.output("DIR", "folder of the results", "reproduce", plots=True, html=True)


def run(arguments: Arguments) -> None:
    from ...studies.paper.paper_report import full_report
    from ...studies.paper.reproduce import reproduce

    with results(arguments, "report") as (take, progress):
        take(full_report(reproduce(progress)))
