"""Report of a command, with text, tables, data, and plots, and the function that writes it."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from ...io.output import ResultFolder, json_text, write_file
from ...io.progress import Progress, silent
from .text_tables import csv_lines

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ...viewer.view import Viewer

Table = str | Mapping[str, NDArray[Any]]
"""CSV text, or columns of shape (n,) by name."""

STYLE: Mapping[Any, Any] = {
    "axes.grid": True,
    "grid.alpha": 0.35,
    "grid.linewidth": 0.6,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "legend.frameon": False,
    # Long curves exceed the memory of the renderer in one piece.
    "agg.path.chunksize": 10_000,
}
"""Matplotlib settings of all plots; ``SMALL`` has a smaller font."""
SMALL: Mapping[Any, Any] = {**STYLE, "font.size": 9.0, "axes.axisbelow": True}

_METADATA: dict[str, dict[str, str | None]] = {
    "png": {"Software": "stewart-sym"},
    "svg": {"Date": None, "Creator": None},
}
# These settings make the files reproducible to the byte.
_SVG: dict[Any, Any] = {"svg.hashsalt": "stewart-sym", "svg.fonttype": "none"}


@dataclass(frozen=True)
class Picture:
    """Plot of a report: function that draws it, Matplotlib style, file formats, and resolution."""

    draw: "Callable[[], Figure]"
    style: Mapping[Any, Any] = field(default_factory=lambda: STYLE)
    kinds: tuple[str, ...] = ("png",)
    dpi: int = 160


@dataclass(frozen=True, eq=False)
class Report:
    """Result of a command: text for readers, and tables and plots by file name without suffix.

    ``data`` are numbers for programs, with units in the keys or in a table ``units``. ``views`` are functions
    that create the view of each motion, by title.
    """

    text: str
    tables: Mapping[str, Table] = field(default_factory=dict)
    data: Mapping[str, Any] = field(default_factory=dict)
    figures: Mapping[str, Picture] = field(default_factory=dict)
    views: "Mapping[str, Callable[[], Viewer]]" = field(default_factory=dict)


def write(report: Report, folder: ResultFolder, name: str, progress: Progress = silent) -> None:
    """Write ``name.txt``, ``name.json``, every table as CSV, and every plot into a folder."""
    folder.write(f"{name}.txt", report.text.rstrip("\n") + "\n")
    folder.write(f"{name}.json", json_text(report.data))
    for table, content in report.tables.items():
        folder.write(f"{table}.csv", content if isinstance(content, str) else csv_lines(content))
    for number, (stem, picture) in enumerate(report.figures.items()):
        progress(f"drawing {stem}", number / len(report.figures))
        for kind, data in drawn(picture).items():
            folder.write(f"{stem}.{kind}", data)


def draw(picture: Picture, stem: Path) -> None:
    """Draw a plot, and write it to a path to which the suffixes are added."""
    for kind, data in drawn(picture).items():
        write_file(stem.with_name(f"{stem.name}.{kind}"), data)


def is_own_png(path: Path) -> bool:
    """Return True if a file is a plot of this program."""
    return path.is_file() and b"Software\0stewart-sym" in path.read_bytes()[:200]


def drawn(picture: Picture) -> dict[str, bytes]:
    """Draw a plot, and return the content of its files by suffix."""
    import matplotlib

    files = {kind: BytesIO() for kind in picture.kinds}
    with matplotlib.rc_context({**_SVG, **picture.style}):
        figure = picture.draw()
        for kind, stream in files.items():
            figure.savefig(stream, format=kind, dpi=picture.dpi, metadata=_METADATA[kind])
    return {kind: stream.getvalue() for kind, stream in files.items()}
