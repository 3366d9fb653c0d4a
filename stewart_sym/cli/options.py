"""Options common to several subcommands, and the types of their values."""

import argparse
import contextlib
import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

PAPERS = "the robot of the paper"


def robot_file(parser: argparse.ArgumentParser, name: str = "robot", default: str = "", **more: Any) -> None:
    """Add the robot file; ``default`` is a description."""
    text = f"robot file; default: {default}" if default else "robot file"
    parser.add_argument(name, metavar="ROBOT.toml", type=Path, help=text, **more)


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
    parser.add_argument(
        "-o", "--output", metavar=metavar, type=kind, required=default is None, default=path, help=text
    )
    if plots:
        text = "write tables and CSV files only, without Matplotlib"
        parser.add_argument("--no-plots", dest="plots", action="store_false", help=text)
    if html:
        text = "HTML file of text, tables, figures, and motions; requires no network"
        parser.add_argument("--html", metavar="FILE", type=path_name, help=text)
    json_file(parser)


def json_file(parser: argparse.ArgumentParser) -> None:
    """Add ``--json``, and ``--force``, which applies to all written files."""
    parser.add_argument(
        "--json",
        metavar="FILE",
        nargs="?",
        type=path_name,
        const=Path("-"),
        help="JSON file of all numbers; units are in the keys or under `units`, non-finite numbers are null; "
        "without FILE or with -, standard output instead of the text",
    )
    parser.add_argument(
        "--force",
        action="store_true",
        help="replace also files of other programs and edited files, except inputs",
    )


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


def finite(text: str) -> float:
    """Parse a finite number."""
    with contextlib.suppress(ValueError):
        number = float(text)
        if math.isfinite(number):
            return number
    raise argparse.ArgumentTypeError(f"expected a finite number, got {text!r}")


def positive(text: str) -> float:
    """Parse a number above 0."""
    number = finite(text)
    if number <= 0.0:
        raise argparse.ArgumentTypeError(f"expected a number > 0, got {text!r}")
    return number


def whole(text: str) -> int:
    """Parse a whole number, 0 or more."""
    with contextlib.suppress(ValueError):
        number = int(text)
        if number >= 0:
            return number
    raise argparse.ArgumentTypeError(f"expected a whole number >= 0, got {text!r}")


def log_options(parser: argparse.ArgumentParser) -> None:
    """Add the options for reading the file of a trajectory."""
    group = log_form(parser)
    valued(
        group,
        "rate",
        positive,
        "sampling rate of the resampled log (Hz); default: no resampling",
        metavar="HZ",
    )
    noise_options(
        group,
        "standard deviation of the {} of the log (--{}-unit); default: estimated",
        "positions or leg lengths",
        "angles",
    )
    text = "frequency at half amplitude of the smoothing filter (Hz); default: the most likely"
    valued(group, "cutoff", positive, text, metavar="HZ")
    group.add_argument(
        "--no-smoothing",
        dest="smoothing",
        action="store_false",
        help="interpolate the samples without smoothing",
    )


def noise_options(parser: argparse._ActionsContainer, text: str, position: str, angle: str) -> None:
    """Add ``--position-std`` and ``--angle-std``.

    ``text`` is a help template with placeholders for the quantity and its unit.
    """
    for name, kind, what in (("position", "length", position), ("angle", "angle", angle)):
        valued(parser, f"{name}-std", positive, text.format(what, kind), metavar="STD")


def log_form(parser: argparse.ArgumentParser) -> argparse._ArgumentGroup:
    """Add the options for columns, units, and delimiters of a trajectory file, and for the initial pose
    guess.
    """
    group = parser.add_argument_group("trajectory file")
    group.add_argument(
        "--pose-guess",
        nargs=6,
        type=finite,
        metavar=("t_x", "t_y", "t_z", "theta_x", "theta_y", "theta_z"),
        help="pose near the first leg lengths (m and rad); default: above the base, nearly parallel to it",
    )
    group.add_argument(
        "--columns",
        type=column_names,
        default={},
        metavar="NAME=HEADER,...",
        help="names of the columns in the header, as in time=ms,t_x=X; all other columns are ignored",
    )
    for name, choices in (
        ("length", ("m", "cm", "mm", "in")),
        ("angle", ("rad", "deg")),
        ("time", ("s", "ms", "us")),
    ):
        text = f"unit of {name}; default: the unit row below the header, otherwise {choices[0]}"
        group.add_argument(f"--{name}-unit", choices=choices, help=text)
    group.add_argument(
        "--delimiter", choices=("comma", "semicolon", "tab"), help="delimiter; default: detected"
    )
    group.add_argument("--decimal", choices=("point", "comma"), help="decimal mark; default: detected")
    group.add_argument(
        "--euler-order",
        choices=("xyz", "xzy", "yxz", "yzx", "zxy", "zyx"),
        help="order of the rotation product; default: from the robot file, otherwise zyx (R = Rz Ry Rx)",
    )
    group.add_argument(
        "--length-mode",
        choices=("absolute", "relative"),
        help="zero of the leg lengths, absolute or the home pose; default: from the robot file or absolute",
    )
    return group


def column_names(text: str) -> dict[str, str]:
    """Parse pairs NAME=HEADER, separated by commas."""
    pairs = [pair.partition("=") for pair in text.split(",")]
    names = {name.strip(): given.strip() for name, _, given in pairs}
    if not all(sign and name.strip() and given.strip() for name, sign, given in pairs) or len(names) < len(
        pairs
    ):
        raise argparse.ArgumentTypeError(f"expected NAME=HEADER,NAME=HEADER,..., got {text!r}")
    return names


def formulation(parser: argparse.ArgumentParser) -> None:
    """Add ``--formulation``."""
    chosen(parser, "formulation", ("exact", "paper"), "equations: exact (corrected), or paper (as printed)")
