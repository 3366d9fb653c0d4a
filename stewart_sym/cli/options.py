"""Options common to several subcommands, and the types of their values."""

import argparse
import contextlib
import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

_FILES = {
    "robot": ("ROBOT.toml", "robot file"),
    "scene": ("SCENE.toml", "scene file, schema 1"),
    "trajectory": ("TRAJECTORY.csv", "CSV file of times and poses or leg lengths"),
    "via": ("VIA.toml", "file of via poses, schema 1"),
    "model": ("MODEL", "model in MJCF, SDF, or URDF"),
}
"""Placeholder and help of each kind of input file."""


def input_file(parser: argparse.ArgumentParser, kind: str, name: str = "", **more: Any) -> None:
    """Add an input file, a positional argument unless ``name`` is the name of an option."""
    metavar, text = _FILES[kind]
    parser.add_argument(name or kind, **{"metavar": metavar, "type": Path, "help": text, **more})


def output(
    parser: argparse.ArgumentParser,
    metavar: str,
    what: str,
    default: Path | str | None,
    plots: bool = False,
    html: bool = False,
) -> None:
    """Add ``-o``, ``--json``, and ``--force``, and on request ``--no-plots`` and ``--html``.

    ``default`` is a path, a description of the default behavior, or None if the option is required.
    """
    text = what if default is None else f"{what}; default: {default}"
    path = default if isinstance(default, Path) else None
    kind = folder_name if metavar == "DIR" else path_name
    required = default is None
    parser.add_argument(
        "-o", "--output", metavar=metavar, type=kind, required=required, default=path, help=text
    )
    if plots:
        text = "write tables and CSV files only, without Matplotlib"
        parser.add_argument("--no-plots", dest="plots", action="store_false", help=text)
    if html:
        valued(parser, "html", path_name, "HTML file of text, tables, figures, and motions", metavar="FILE")
    json_file(parser)


def json_file(parser: argparse.ArgumentParser) -> None:
    """Add ``--json``, and ``--force``, which applies to all written files."""
    text = (
        "JSON file of all numbers; units are in the keys or under `units`, non-finite numbers are null; "
        "without FILE or with -, standard output instead of the text"
    )
    parser.add_argument("--json", metavar="FILE", nargs="?", type=path_name, const=Path("-"), help=text)
    flag(parser, "force", "replace also files of other programs and edited files, except inputs")


def flag(parser: argparse._ActionsContainer, name: str, text: str) -> None:
    """Add an option without a value."""
    parser.add_argument(f"--{name}", action="store_true", help=text)


def seed(parser: argparse._ActionsContainer) -> None:
    """Add ``--seed``."""
    valued(parser, "seed", whole, "random seed", 0, "N")


def valued(
    parser: argparse._ActionsContainer,
    name: str,
    kind: Callable[[str], Any],
    text: str,
    default: Any = None,
    metavar: str | None = None,
) -> None:
    """Add an option with a value, and append its default, if any, to the help."""
    said = f"{text}; default: {f'{default:g}' if isinstance(default, float) else default}"
    said = text if default is None else said
    parser.add_argument(f"--{name}", type=kind, default=default, metavar=metavar, help=said)


def chosen(parser: argparse._ActionsContainer, name: str, choices: Sequence[str], text: str = "") -> None:
    """Add an option whose value is one of ``choices``; the first one is the default."""
    said = "; ".join(filter(None, (text, f"default: {choices[0]}")))
    parser.add_argument(f"--{name}", choices=choices, default=choices[0], help=said)


def path_name(text: str) -> Path:
    """Parse the name of a file or folder."""
    if not text.strip():
        raise argparse.ArgumentTypeError("expected a name, got nothing")
    return Path(text)


def folder_name(text: str) -> Path:
    """Parse the name of a folder; reject ``-``, because several files cannot go to standard output."""
    if text == "-":
        raise argparse.ArgumentTypeError("expected a folder, got - for standard output")
    return path_name(text)


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


def log_options(parser: argparse.ArgumentParser) -> None:
    """Add the options for reading the file of a trajectory."""
    group = log_form(parser)
    text = "sampling rate of the resampled log (Hz); default: no resampling"
    valued(group, "rate", positive, text, metavar="HZ")
    text = "standard deviation of the {} of the log (--{}-unit); default: estimated"
    noise_options(group, text, "positions or leg lengths", "angles")
    text = "frequency at half amplitude of the smoothing filter (Hz); default: the most likely"
    valued(group, "cutoff", positive, text, metavar="HZ")
    text = "interpolate the samples without smoothing"
    group.add_argument("--no-smoothing", dest="smoothing", action="store_false", help=text)


def noise_options(parser: argparse._ActionsContainer, text: str, position: str, angle: str) -> None:
    """Add ``--position-std`` and ``--angle-std``.

    ``text`` is a help template with placeholders for the quantity and its unit.
    """
    for name, kind, what in (("position", "length", position), ("angle", "angle", angle)):
        valued(parser, f"{name}-std", positive, text.format(what, kind), metavar="STD")


LOG_FORM = {
    "length-unit": ("unit of length", "the unit row below the header, otherwise m", ("m", "cm", "mm", "in")),
    "angle-unit": ("unit of angle", "the unit row below the header, otherwise rad", ("rad", "deg")),
    "time-unit": ("unit of time", "the unit row below the header, otherwise s", ("s", "ms", "us")),
    "delimiter": ("delimiter", "detected", ("comma", "semicolon", "tab")),
    "decimal": ("decimal mark", "detected", ("point", "comma")),
    "euler-order": (
        "order of the rotation product",
        "from the robot file, otherwise zyx (R = Rz Ry Rx)",
        ("xyz", "xzy", "yxz", "yzx", "zxy", "zyx"),
    ),
    "length-mode": (
        "zero of the leg lengths, absolute or the home pose",
        "from the robot file or absolute",
        ("absolute", "relative"),
    ),
}
"""Meaning, default, and values of each option that describes a trajectory file."""


def log_form(parser: argparse.ArgumentParser) -> argparse._ArgumentGroup:
    """Add the options for columns, units, and delimiters of a trajectory file, and for the initial pose
    guess.
    """
    group = parser.add_argument_group("trajectory file")
    names = ("t_x", "t_y", "t_z", "theta_x", "theta_y", "theta_z")
    text = "pose near the first leg lengths (m and rad); default: above the base, nearly parallel to it"
    group.add_argument("--pose-guess", nargs=6, type=finite, metavar=names, help=text)
    text = "names of the columns in the header, as in time=ms,t_x=X; all other columns are ignored"
    group.add_argument("--columns", type=column_names, default={}, metavar="NAME=HEADER,...", help=text)
    for name, (what, default, choices) in LOG_FORM.items():
        group.add_argument(f"--{name}", choices=choices, help=f"{what}; default: {default}")
    return group


def column_names(text: str) -> dict[str, str]:
    """Parse pairs NAME=HEADER, separated by commas."""
    pairs = [[part.strip() for part in pair.partition("=")] for pair in text.split(",")]
    names = {name: header for name, _, header in pairs}
    if not all(map(all, pairs)) or len(names) < len(pairs):
        raise argparse.ArgumentTypeError(f"expected NAME=HEADER,NAME=HEADER,..., got {text!r}")
    return names


def formulation(parser: argparse.ArgumentParser) -> None:
    """Add ``--formulation``."""
    chosen(parser, "formulation", ("exact", "paper"), "equations: exact (corrected), or paper (as printed)")
