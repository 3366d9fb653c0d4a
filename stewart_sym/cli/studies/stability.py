"""``stewart-sym stability``: every method near degenerate configurations."""

import argparse
import dataclasses
from pathlib import Path

from ..options import no_pictures, output, whole
from ..results import drawing, results_folder
from ..terminal import progress_line

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
    """Arguments of ``stability``."""
    output(parser, "DIR", "folder to write to", "stability")
    parser.add_argument(
        "--cases", metavar="N", type=whole, help=f"random cases near failure; with -o {CASES:,}"
    )
    parser.add_argument("--seed", type=whole, default=0, help="of the random cases; default: 0")
    no_pictures(parser)


def run(arguments: argparse.Namespace) -> int:
    """Run ``stability``; returns the exit code."""
    import json

    from ...io.writing import replaced_file
    from ...studies.common.output import csv_lines
    from ...studies.robustness.sweep.sweep import report, sweep

    if arguments.cases is not None and arguments.output is None:
        with progress_line() as progress:
            swept = sweep(arguments.cases, arguments.seed, progress)
        print(report(swept))
        return 1 if swept.wrong or swept.rejected_good else 0
    if arguments.pictures:
        drawing()
    from ...studies.robustness import study

    output = arguments.output = arguments.output or Path("stability")
    with results_folder(arguments, "stability.txt", "stability.json") as folder, progress_line() as progress:
        found = study.study(progress)
        cases = CASES if arguments.cases is None else arguments.cases
        found = dataclasses.replace(found, sweep=sweep(cases, arguments.seed, progress))
        for family in found.families:
            with replaced_file(folder / f"{family.name}.csv") as stream:
                stream.writelines(csv_lines(family.columns()))
        text = study.report(found)
        (folder / "stability.txt").write_text(text + "\n", encoding="utf-8", newline="\n")
        figures = json.dumps(study.as_json(found), indent=1, allow_nan=False) + "\n"
        (folder / "stability.json").write_text(figures, encoding="utf-8", newline="\n")
        if arguments.pictures:
            from ...studies.robustness import pictures

            progress("drawing")
            pictures.draw(found, folder)
        names = sorted(path.name for path in folder.iterdir())
    print(text)
    print(f"Written to {output}: {', '.join(names)}")
    return 0
