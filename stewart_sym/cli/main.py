"""The command ``stewart-sym`` with its subcommands.

The command prints errors in one line. Exit codes are 0 for success, 1 for a negative result of ``derive
--check``, ``identify``, ``plan``, or ``stability``, 2 for an error, and 128 + n for signal n, such as 130 for
Ctrl-C or 141 for a closed pipe. A subcommand imports SymPy, SciPy, and Matplotlib only if it uses them.
"""

import argparse
import sys
from collections.abc import Sequence
from importlib import import_module
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path
from typing import NoReturn

from ..backend.native import CompilerError
from ..io.arguments import shown
from .command import Parser, hint
from .terminal import PROGRAM, give_up_stdout, one_line, warnings_in_lines

GROUPS = {
    "machine": ("new", "robots", "check", "view", "convert", "import", "export"),
    "computation": ("forces", "size-actuators", "workspace", "singularities", "plan", "simulate", "identify"),
    "code": ("generate", "choose-fidelity", "cmake-dir", "derive"),
    "studies": ("reproduce", "chart", "stability", "benchmark"),
}
"""Subcommands by group, in the order of the help."""

SUBCOMMANDS = {
    name: (title.replace("computation", "machine"), name.replace("-", "_").replace("import", "import_model"))
    for title, group in GROUPS.items()
    for name in group
}
"""Folder and module of each subcommand.

A module has a docstring, which is its help and ends with an example, a function ``add_arguments`` that
defines its options, and a function ``run`` that returns the exit code or None for 0.
"""


def main(argv: Sequence[str] | None = None) -> int:
    """Run one subcommand with the arguments of the process or ``argv``, and return the exit code."""
    words = [*(sys.argv[1:] if argv is None else argv)]
    # One parser only, because building all of them takes longer than many subcommands.
    name, *rest = words or [""]
    if name in SUBCOMMANDS:
        arguments = subcommand_parser(name).parse_args(rest)
    else:
        arguments = _overview().parse_args(words[:1])
    try:
        with warnings_in_lines():
            code: int = arguments.run(arguments) or 0
        sys.stdout.flush()
        return code
    except KeyboardInterrupt:
        return 130
    except (ValueError, OSError, ImportError, CompilerError, MemoryError, Warning) as error:
        text, file = one_line(error), getattr(arguments, "robot", None)
        if isinstance(file, Path) and text.removeprefix(f"{file}: ").startswith("robot: "):
            text = text.removeprefix(f"{file}: ").replace("robot", str(file), 1)
            text = text.replace("this function", arguments.subcommand)
        if not isinstance(error, BrokenPipeError):
            print(f"{PROGRAM}: error: {text}", file=sys.stderr)
        try:
            sys.stdout.flush()
        except OSError:
            give_up_stdout()
        return 141 if isinstance(error, BrokenPipeError) else 2


def subcommand_parser(name: str) -> argparse.ArgumentParser:
    """Return the parser of one subcommand."""
    module = import_module(".".join(["", *SUBCOMMANDS[name]]), __package__)
    text, _, example = str(module.__doc__).partition("\n\nExample: ")
    parser = Parser(prog=f"{PROGRAM} {name}", description=text, epilog=f"Example: {example.strip()}")
    module.add_arguments(parser)
    parser.set_defaults(run=module.run, subcommand=name)
    return parser


def _overview() -> argparse.ArgumentParser:
    """Return the parser of a command line without a subcommand, whose help lists all subcommands."""
    lines = ["Closed-form dynamics of Gough-Stewart platforms as C and Python code.", "", "subcommands:"]
    for title, group in GROUPS.items():
        lines.append(f"  {title}:")
        lines += [f"    {name:<16} {_summary(name)}" for name in group]
    parser = Parser(
        prog=PROGRAM,
        usage=f"{PROGRAM} [--version] SUBCOMMAND ...",
        description="\n".join(lines),
        epilog="Example: stewart-sym reproduce -o reproduce",
    )
    parser.add_argument("--version", action="version", version=f"{PROGRAM} {version('stewart-sym')}")
    parser.add_argument("subcommand", metavar="SUBCOMMAND", type=_unknown, help="name of a subcommand")
    return parser


def _summary(name: str) -> str:
    """Read the first line of the help of a subcommand, because importing all modules takes a second."""
    folder, module = SUBCOMMANDS[name]
    text = (files(__package__) / folder / f"{module}.py").read_text(encoding="utf-8").split('"""')[1]
    return f"{text[0].lower()}{text[1:]}".partition(".\n")[0]


def _unknown(name: str) -> NoReturn:
    """Raise the error of an unknown subcommand."""
    raise argparse.ArgumentTypeError(f"expected a subcommand, got {shown(name)}{hint(name, SUBCOMMANDS)}")
