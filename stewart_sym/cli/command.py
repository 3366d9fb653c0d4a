"""Parser of a subcommand with the options common to several subcommands, and the output of its results."""

import argparse
import contextlib
import dataclasses
import difflib
import itertools
import math
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any, NoReturn

from ..io.arguments import safe_text
from ..io.error_policy import need
from ..io.output import ResultFolder, json_text, must_be_replaceable, write_file
from ..io.progress import Progress
from ..motion.trajectory_format import ANGLE_UNITS, EULER_ORDERS, LENGTH_UNITS, MODES, TIME_UNITS
from ..studies.common.report import Report, write
from ..viewer.page import BEGINNING as HTML_BEGINNING
from .terminal import PROGRAM, one_line, progress_line

Arguments = argparse.Namespace
Group = argparse._ArgumentGroup

_FILES = {
    "robot": ("ROBOT.toml", "robot file"),
    "scene": ("SCENE.toml", "scene file, schema 1"),
    "trajectory": ("TRAJECTORY.csv", "CSV file of times and poses or leg lengths"),
    "via": ("VIA.toml", "file of via poses, schema 1"),
    "model": ("MODEL", "model in MJCF, SDF, or URDF"),
}
"""Placeholder and help of each kind of input file."""

_OF_ROBOT, _ZERO = "from the robot file", "absolute or the home pose"
_OF_FILE = "from the header or the robot file, otherwise {}"
LOG_FORM = {
    "length-unit": ("unit of length", _OF_FILE.format("m"), tuple(LENGTH_UNITS)),
    "angle-unit": ("unit of angle", _OF_FILE.format("rad"), tuple(ANGLE_UNITS)),
    "time-unit": ("unit of time", _OF_FILE.format("s"), tuple(TIME_UNITS)),
    "delimiter": ("delimiter", "detected", ("comma", "semicolon", "tab")),
    "decimal": ("decimal mark", "detected", ("point", "comma")),
    "euler-order": ("order of the rotations, zyx: R = Rz Ry Rx", f"{_OF_ROBOT} or zyx", EULER_ORDERS),
    "length-mode": (f"zero of the leg lengths, {_ZERO}", f"{_OF_ROBOT} or absolute", MODES),
    "pose-mode": (f"zero of the poses, {_ZERO}", f"{_OF_ROBOT} or absolute", MODES),
}
"""Meaning, default, and values of each option that describes a trajectory file."""


def folder_name(text: str) -> Path:
    """Parse the name of a folder; reject ``-``, because several files cannot go to standard output."""
    if text == "-":
        raise argparse.ArgumentTypeError("expected a folder, got - for standard output")
    return Path(text)


def html_name(text: str) -> Path:
    """Parse the name of an HTML file; reject other suffixes, because inputs have them."""
    if Path(text).suffix.lower() not in ("", ".html", ".htm"):
        raise argparse.ArgumentTypeError(f"expected a file name that ends in .html, got {text!r}")
    return Path(text)


def _number(kind: type, allowed: Callable[[float], bool], expected: str) -> Callable[[str], Any]:
    """Return a parser of numbers that are allowed."""

    def parsed(text: str) -> Any:
        with contextlib.suppress(ValueError):
            number = kind(text)
            if allowed(number):
                return number
        raise argparse.ArgumentTypeError(f"expected {expected}, got {text!r}")

    return parsed


finite = _number(float, math.isfinite, "a finite number")
positive = _number(float, lambda x: 0.0 < x < math.inf, "a number > 0")
whole = _number(int, lambda n: n >= 0, "a whole number >= 0")


def _column_names(text: str) -> dict[str, str]:
    """Parse pairs NAME=HEADER, separated by commas."""
    pairs = [[part.strip() for part in pair.partition("=")] for pair in text.split(",")]
    names = {name: header for name, _, header in pairs}
    if not all(map(all, pairs)) or len(names) < len(pairs):
        raise argparse.ArgumentTypeError(f"expected NAME=HEADER,NAME=HEADER,..., got {text!r}")
    return names


def _lines(text: str) -> tuple[int, ...]:
    """Parse line numbers such as 1498,1503-1510."""
    found: list[int] = []
    for part in text.split(","):
        match = re.fullmatch(r"(\d+)(?:-(\d+))?", part.strip())
        if match is None or int(match[2] or match[1]) < int(match[1]):
            raise argparse.ArgumentTypeError(f"expected line numbers such as 1498,1503-1510, got {text!r}")
        found += range(int(match[1]), int(match[2] or match[1]) + 1)
    return tuple(found)


class Parser(argparse.ArgumentParser):
    """Parser whose errors are one line that names the help, and a similar name of a word."""

    def __init__(self, **options: Any) -> None:
        """Read -1e-3 as a number, not as an option."""
        super().__init__(formatter_class=argparse.RawDescriptionHelpFormatter, **options)
        self._negative_number_matcher = re.compile(r"-(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$")

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> tuple[Any, list[str]]:
        """Reject unknown names of options first, because a required one may be misspelled."""
        known = self._option_string_actions
        for word in itertools.takewhile("--".__ne__, args):
            name = word.partition("=")[0]
            if name.startswith("--") and not any(each.startswith(name) for each in known):
                self.error(f"unrecognized arguments: {name}{hint(name, known)}")
        return super().parse_known_args(args, namespace)

    def error(self, message: str) -> NoReturn:
        """Exit with code 2."""
        self.exit(2, f"{PROGRAM}: error: {one_line(message)} (see {self.prog} --help)\n")

    def file(self, kind: str, name: str = "", **more: Any) -> None:
        """Add an input file, a positional argument unless ``name`` is the name of an option."""
        metavar, text = _FILES[kind]
        self.add_argument(name or kind, **{"metavar": metavar, "type": Path, "help": text, **more})

    def flag(self, name: str, text: str) -> None:
        """Add an option without a value."""
        self.add_argument(f"--{name}", action="store_true", help=text)

    def valued(
        self,
        name: str,
        kind: Callable[[str], Any],
        text: str,
        default: Any = None,
        metavar: str | None = None,
        group: Group | None = None,
    ) -> None:
        """Add an option with a value, and append its default, if any, to the help."""
        if default is not None:
            text += f"; default: {default:g}" if isinstance(default, float) else f"; default: {default}"
        (group or self).add_argument(f"--{name}", type=kind, default=default, metavar=metavar, help=text)

    def chosen(self, name: str, choices: Sequence[str], text: str) -> None:
        """Add an option whose value is one of ``choices``; the first one is the default."""
        text += f"; default: {choices[0]}"
        self.add_argument(f"--{name}", choices=choices, default=choices[0], help=text)

    def seed(self) -> None:
        """Add ``--seed``."""
        self.valued("seed", whole, "random seed", 0, "N")

    def formulation(self) -> None:
        """Add ``--formulation``."""
        self.chosen("formulation", ("exact", "paper"), "equations: exact (corrected), or paper (as printed)")

    def output(
        self,
        metavar: str,
        text: str,
        default: str | None = None,
        otherwise: str | None = None,
        plots: bool = False,
        html: bool = False,
    ) -> None:
        """Add ``-o`` and related options; without ``default`` and ``otherwise``, ``-o`` is required."""
        shown = default or otherwise
        self.add_argument(
            *("-o", "--output"),
            metavar=metavar,
            type={"DIR": folder_name, "FILE.html": html_name}.get(metavar, Path),
            required=shown is None,
            default=default and Path(default),
            help=f"{text}; default: {shown}" if shown else text,
        )
        if plots:
            text = "write tables and CSV files only, without Matplotlib"
            self.add_argument("--no-plots", dest="plots", action="store_false", help=text)
        if html:
            self.valued("html", html_name, "HTML file of text, tables, figures, and motions", metavar="FILE")
        self.json()

    def json(self) -> None:
        """Add ``--json``, and ``--force``, which applies to all written files."""
        text = (
            "JSON file of all numbers; units are in the keys or under `units`, non-finite numbers are null; "
            "without FILE or with -, standard output instead of the text"
        )
        self.add_argument("--json", metavar="FILE", nargs="?", type=Path, const=Path("-"), help=text)
        self.flag("force", "replace also files of other programs and edited files, except inputs")

    def log_form(self) -> Group:
        """Add the options for columns, units, and noise of a trajectory file, and for the pose guess."""
        group = self.add_argument_group("trajectory file")
        names = ("t_x", "t_y", "t_z", "theta_x", "theta_y", "theta_z")
        text = "pose near the first leg lengths (m and rad); default: above the base, nearly parallel to it"
        group.add_argument("--pose-guess", nargs=6, type=finite, metavar=names, help=text)
        text = "names of the columns in the header, as in time=ms,t_x=X; others are found by their names"
        group.add_argument("--columns", type=_column_names, default={}, metavar="NAME=HEADER,...", help=text)
        for name, (what, default, choices) in LOG_FORM.items():
            group.add_argument(f"--{name}", choices=choices, help=f"{what}; default: {default}")
        text = "rows per second (Hz) of a file without a column of times"
        self.valued("row-rate", positive, text, metavar="HZ", group=group)
        text = "lines of the file that are not used, as in 1498,1503-1510"
        self.valued("drop-lines", _lines, text, None, "LINES", group)
        noisy = {"position": "positions or leg lengths (--length-unit)", "angle": "angles (--angle-unit)"}
        for name, what in noisy.items():
            text = f"standard deviation of the measured {what}; default: estimated"
            self.valued(f"{name}-std", positive, text, metavar="STD", group=group)
        return group

    def log(self) -> None:
        """Add the options for reading the file of a trajectory."""
        group = self.log_form()
        text = "sampling rate of the resampled log (Hz); default: no resampling"
        self.valued("rate", positive, text, metavar="HZ", group=group)
        text = "frequency at half amplitude of the smoothing filter (Hz); default: the most likely"
        self.valued("cutoff", positive, text, metavar="HZ", group=group)
        text = "interpolate the samples without smoothing"
        group.add_argument("--no-smoothing", dest="smoothing", action="store_false", help=text)


@contextlib.contextmanager
def results(
    arguments: Arguments,
    stem: str | None = None,
    *tables: str,
    read: Iterable[Path] = (),
    beginnings: Sequence[str] = (),
) -> Iterator[tuple[Callable[..., None], Progress]]:
    """Return a function that writes the report of a subcommand and a function that displays its progress.

    A folder ``arguments.output`` contains ``stem.txt``, ``stem.json``, and the files ``tables``; a single
    file begins with one of ``beginnings``. ``read`` are input files that are not arguments. Files that cannot
    be written or replaced are errors before the block. The text is printed after a block without an error.
    """
    made_by = {"generator": f"{PROGRAM} {arguments.subcommand}"}
    output, page = (getattr(arguments, name, None) for name in ("output", "html"))
    plots, inputs = getattr(arguments, "plots", True), [*read]
    for name, value in vars(arguments).items():
        if name not in ("output", "json", "html"):
            values = value if isinstance(value, list) else [value]
            inputs += [each for each in values if isinstance(each, Path)]
    folder = None
    if stem is not None and output is not None:
        if getattr(arguments, "plots", False):
            need("matplotlib", "drawing", ", or use --no-plots")
        folder = ResultFolder(output, arguments.force, inputs, (f"{stem}.txt", f"{stem}.json", *tables))
    paths = [path for path in (output, page, arguments.json) if path is not None]
    if len({*paths}) < len(paths):
        raise ValueError("-o, --html, --json: two results have the same file; name another file")
    json_beginning = json_text(made_by).removesuffix("\n}\n") + ","
    for path, texts in (output, beginnings), (page, [HTML_BEGINNING]), (arguments.json, [json_beginning]):
        if path is not None and texts:
            need_own_file(path, texts, arguments.force, inputs)
    lines: list[str] = []

    def take(report: Report, content: str | None = None) -> None:
        if content is not None and output is not None:
            write_file(output, content)
        figures = report.figures if plots else {}
        report = dataclasses.replace(report, data={**made_by, **report.data}, figures=figures)
        if report.text:
            lines.append(report.text.rstrip("\n"))
        if folder is not None and stem is not None:
            write(report, folder, stem, progress)
            lines.append(f"Written to {output}: {', '.join(sorted(folder.names))}")
        if page is not None:
            from ..studies.common.html_page import html_page

            write_file(page, html_page(made_by["generator"], report, progress))
            lines.append(f"Written to {page}")
        if arguments.json is not None:
            write_file(arguments.json, json_text(report.data))

    with progress_line() as progress:
        yield take, progress
    if beginnings and str(output) == "-":
        lines.clear()
    elif beginnings and output is not None:
        lines.append(f"Written to {output}")
    if str(arguments.json) != "-":
        for text in lines:
            print(*map(safe_text, text.split("\n")), sep="\n")


def need_own_file(path: Path, beginnings: Sequence[str], force: bool, inputs: Iterable[Path]) -> None:
    """Raise ValueError if a file cannot be written or must not be replaced; ``-`` is standard output."""
    if str(path) != "-":
        found = path.read_bytes() if path.is_file() else b""
        is_ours = not found or found.startswith(tuple(map(str.encode, beginnings)))
        must_be_replaceable(path, is_ours, force, inputs)


def hint(text: str, names: Iterable[str]) -> str:
    """Return a hint with the name closest to an unknown one."""
    near = difflib.get_close_matches(text, names, n=1)
    return f", did you mean {near[0]}?" if near else ""
