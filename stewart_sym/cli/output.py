"""Output of results to the terminal, a folder, or a JSON or HTML file, without overwriting inputs or other
files.
"""

import argparse
import contextlib
import dataclasses
import itertools
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

from ..io.arguments import safe_text
from ..io.extras import need
from ..io.progress import Progress
from ..studies.common.not_finite import in_figures, in_text, note_not_finite
from ..studies.common.report import Report, write
from .terminal import PROGRAM, progress_line

Taker = Callable[[Report], None]
"""Function that writes a report to its destinations."""


@contextlib.contextmanager
def results(
    arguments: argparse.Namespace, stem: str | None = None, *tables: str, read: Iterable[Path] = ()
) -> Iterator[tuple[Taker, Progress]]:
    """Return a function that writes the report of a subcommand and a function that displays its progress.

    Files are put in place and the text is printed only if the block ends without an error.

    Parameters
    ----------
    arguments : argparse.Namespace
        Arguments of the subcommand.
    stem : str or None
        Name of the text file and the JSON file in the folder ``arguments.output``, without suffix. None
        writes no folder.
    *tables : str
        Names of other files in the folder, so that a conflict is reported before the computation.
    read : iterable of Path
        Input files that are not arguments themselves.

    Yields
    ------
    Taker
        Function that writes a report.
    Progress
        Function that displays the progress.

    Raises
    ------
    ValueError
        If an output file is an input, or was written or changed by another program.
    ImportError
        If plots are requested and the extra with the plotting packages is not installed.
    OSError
        If a file or folder cannot be written.
    """
    from ..io.atomic_write import result_file, result_folder
    from ..io.json_text import json_text

    inputs, lines = [*_paths(arguments), *read], []
    made_by = {"generator": f"{PROGRAM} {arguments.subcommand}"}
    output: Path | None = getattr(arguments, "output", None)
    drawn = stem is not None and output is not None and getattr(arguments, "plots", False)
    if drawn:
        need_drawing(", or use --no-plots")
    with contextlib.ExitStack() as stack:
        stream = folder = page = None
        target: Path | None = getattr(arguments, "html", None)
        if stem is None and output is not None:
            reject_inputs("-o", output, *inputs)
        if target is not None:
            from ..viewer.page import BEGINNING

            reject_inputs("--html", target, *inputs)
            _need_another("--html", target, arguments.json, output)
            need_html("--html", target)
            page = stack.enter_context(result_file(target, [BEGINNING], arguments.force))
        if arguments.json is not None:
            _need_another("--json", arguments.json, output)
            reject_inputs("--json", arguments.json, *inputs)
            if arguments.json.suffix in (".toml", ".csv"):
                text = "expected a JSON file, got an input; put inputs before --json"
                raise ValueError(f"--json {arguments.json}: {text}")
            beginning = json_text(made_by).removesuffix("\n}\n") + ","
            stream = stack.enter_context(result_file(arguments.json, [beginning], arguments.force))
        if stem is not None and output is not None:
            names = (f"{stem}.txt", f"{stem}.json", *tables)
            folder = stack.enter_context(result_folder(output, arguments.force, inputs, names))
        progress = stack.enter_context(progress_line())

        def take(report: Report) -> None:
            figures = report.figures if getattr(arguments, "plots", True) else {}
            report = dataclasses.replace(report, data={**made_by, **report.data}, figures=figures)
            if report.text:
                lines.append(report.text.rstrip("\n"))
            texts = [report.text, *(each for each in report.tables.values() if isinstance(each, str))]
            if in_figures(report.data) or any(map(in_text, texts)):
                note_not_finite()
            if folder is not None and stem is not None:
                write(report, folder, stem, progress)
                written = sorted(path.name for path in folder.iterdir())
                lines.append(f"Written to {output}: {', '.join(written)}")
            if page is not None:
                from ..studies.common.html_page import html_page

                page.write(html_page(made_by["generator"], report, progress))
                lines.append(f"Written to {target}")
            if stream is not None:
                stream.write(json_text(report.data))

        yield take, progress
    if str(arguments.json) != "-":
        for text in lines:
            print(*map(safe_text, text.split("\n")), sep="\n")


def _need_another(option: str, path: Path, *others: Path | None) -> None:
    """Raise ValueError if another result is written to the same file."""
    if path in others:
        raise ValueError(f"{option} {path}: another result has the same file; name another file")


def need_html(option: str, target: Path) -> None:
    """Raise ValueError if the file name has a suffix other than .html or .htm."""
    if target.suffix.lower() not in ("", ".html", ".htm"):
        raise ValueError(f"{option} {target}: the file name must end in .html")


def _paths(arguments: argparse.Namespace) -> list[Path]:
    """Return the input files among the arguments."""
    values = {
        name: value for name, value in vars(arguments).items() if name not in ("output", "json", "html")
    }
    given = (value if isinstance(value, list) else [value] for value in values.values())
    return [path for path in itertools.chain(*given) if isinstance(path, Path)]


def reject_inputs(option: str, output: Path, *inputs: Path) -> None:
    """Raise ValueError if the output file ``output`` of ``option`` is one of the inputs."""
    for path in inputs:
        if output.exists() and path.exists() and output.samefile(path):
            raise ValueError(f"{option} {output}: the file is an input; name another file")


def need_drawing(otherwise: str = "") -> None:
    """Raise ImportError with the name of the extra and the alternative ``otherwise`` if a plotting package is
    missing.
    """
    for package in ("matplotlib", "textalloc"):
        need(package, "drawing", otherwise)
