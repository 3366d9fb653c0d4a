"""Output of results to the terminal, a folder, or a JSON or HTML file, without overwriting inputs or other
files.
"""

import argparse
import contextlib
import dataclasses
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path

from ..io.arguments import safe_text
from ..io.atomic_write import ResultFolder, must_be_replaceable, write_file
from ..io.extras import need
from ..io.json_text import json_text
from ..io.progress import Progress
from ..studies.common.report import Report, write
from ..viewer.page import BEGINNING as HTML_BEGINNING
from .terminal import PROGRAM, progress_line

Taker = Callable[..., None]
"""Function that writes a report, and the content of a single file if there is one, to their destinations."""


@contextlib.contextmanager
def results(
    arguments: argparse.Namespace,
    stem: str | None = None,
    *tables: str,
    read: Iterable[Path] = (),
    beginnings: Sequence[str] = (),
) -> Iterator[tuple[Taker, Progress]]:
    """Return a function that writes the report of a subcommand and a function that displays its progress.

    A folder ``arguments.output`` contains ``stem.txt``, ``stem.json``, and the files ``tables``. A single
    file ``arguments.output``, which the block writes, begins with one of ``beginnings``. ``read`` are input
    files that are not arguments. The text is printed if the block ends without an error and standard output
    is not the file. Files that cannot be written or replaced are errors before the block.
    """
    made_by = {"generator": f"{PROGRAM} {arguments.subcommand}"}
    inputs, output = [*_paths(arguments), *read], getattr(arguments, "output", None)
    folder = None
    if stem is not None and output is not None:
        if getattr(arguments, "plots", False):
            need_drawing(", or use --no-plots")
        folder = ResultFolder(output, arguments.force, inputs, (f"{stem}.txt", f"{stem}.json", *tables))
    _check_files(arguments, inputs, beginnings, json_text(made_by))
    lines: list[str] = []

    def take(report: Report, content: str | None = None) -> None:
        if content is not None and output is not None:
            write_file(output, content)
        figures = report.figures if getattr(arguments, "plots", True) else {}
        report = dataclasses.replace(report, data={**made_by, **report.data}, figures=figures)
        if report.text:
            lines.append(report.text.rstrip("\n"))
        if folder is not None and stem is not None:
            write(report, folder, stem, progress)
            lines.append(f"Written to {output}: {', '.join(sorted(folder.names))}")
        lines.extend(_written(arguments, report, progress))

    with progress_line() as progress:
        yield take, progress
    if beginnings and str(output) == "-":
        lines.clear()
    elif beginnings and output is not None:
        lines.append(f"Written to {output}")
    if str(arguments.json) != "-":
        for text in lines:
            print(*map(safe_text, text.split("\n")), sep="\n")


def _check_files(
    arguments: argparse.Namespace, inputs: Iterable[Path], beginnings: Sequence[str], generator: str
) -> None:
    """Raise ValueError for single files that cannot be written or replaced; ``generator`` begins JSON."""
    output, page = (getattr(arguments, name, None) for name in ("output", "html"))
    paths = [path for path in (output, page, arguments.json) if path is not None]
    if len({*paths}) < len(paths):
        raise ValueError("-o, --html, --json: two results have the same file; name another file")
    if beginnings and output is not None:
        need_own_file(output, beginnings, arguments.force, inputs)
    if page is not None:
        need_html("--html", page)
        need_own_file(page, [HTML_BEGINNING], arguments.force, inputs)
    if arguments.json is not None:
        beginning = generator.removesuffix("\n}\n") + ","
        need_own_file(arguments.json, [beginning], arguments.force, inputs)


def _written(arguments: argparse.Namespace, report: Report, progress: Progress) -> list[str]:
    """Write the HTML and JSON files of a report; return the lines about them."""
    page = getattr(arguments, "html", None)
    if page is not None:
        from ..studies.common.html_page import html_page

        write_file(page, html_page(report.data["generator"], report, progress))
    if arguments.json is not None:
        write_file(arguments.json, json_text(report.data))
    return [] if page is None else [f"Written to {page}"]


def _paths(arguments: argparse.Namespace) -> Iterator[Path]:
    """Yield the input files among the arguments."""
    for name, value in vars(arguments).items():
        if name not in ("output", "json", "html"):
            yield from (
                each for each in (value if isinstance(value, list) else [value]) if isinstance(each, Path)
            )


def need_own_file(path: Path, beginnings: Sequence[str], force: bool, inputs: Iterable[Path]) -> None:
    """Raise ValueError if a file cannot be written or must not be replaced; ``-`` is standard output."""
    if str(path) != "-":
        found = path.read_bytes() if path.is_file() else b""
        is_ours = not found or found.startswith(tuple(map(str.encode, beginnings)))
        must_be_replaceable(path, is_ours, force, inputs)


def need_html(option: str, target: Path) -> None:
    """Raise ValueError if the file name has a suffix other than .html or .htm."""
    if target.suffix.lower() not in ("", ".html", ".htm"):
        raise ValueError(f"{option} {target}: the file name must end in .html")


def need_drawing(otherwise: str = "") -> None:
    """Raise ImportError if a plotting package is missing; ``otherwise`` is an alternative without it."""
    for package in ("matplotlib", "textalloc"):
        need(package, "drawing", otherwise)
