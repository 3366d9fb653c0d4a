"""The command ``stewart-sym`` with its subcommands.

The command reads arguments, calls the library, prints results, and converts errors into one line and an exit
code: 0 success, 1 ``derive --check`` found differences, 2 error, 128 + n for signal n (130 for Ctrl-C, 143
for SIGTERM, 129 for SIGHUP). A subcommand imports SymPy, SciPy, and Matplotlib only if it uses them.
"""

import argparse
import difflib
import itertools
import re
import sys
from collections.abc import Iterable, Sequence
from importlib import import_module
from importlib.metadata import version
from importlib.resources import files
from typing import Any, NoReturn

from ..backend.native import CompilerError
from ..io.arguments import no_option, shown
from ..io.extras import needed_for
from . import renamed
from .terminal import PROGRAM, give_up_stdout, one_line, warnings_in_lines

GROUPS = {
    "machine": ("new", "robots", "check", "view", "import", "export"),
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
defines its options, and a function ``run`` that returns the exit code.
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
    inputs = (getattr(arguments, name, None) for name in ("robot", "trajectory"))
    try:
        with warnings_in_lines(*filter(None, inputs)), needed_for(arguments.subcommand):
            code: int = arguments.run(arguments)
        sys.stdout.flush()
        return code
    except BrokenPipeError:
        give_up_stdout()
        return 2
    except KeyboardInterrupt:
        return 130
    except (ValueError, OSError, ImportError, CompilerError, MemoryError, Warning) as error:
        print(f"{PROGRAM}: error: {one_line(error)}", file=sys.stderr)
        try:
            sys.stdout.flush()
        except OSError:
            give_up_stdout()
        return 2


class Parser(argparse.ArgumentParser):
    """Parser whose errors are one line that names the help, and a similar or the present name of a word."""

    def __init__(self, **options: Any) -> None:
        """Read -1e-3 as a number, not as an option."""
        super().__init__(formatter_class=argparse.RawDescriptionHelpFormatter, **options)
        self._negative_number_matcher = re.compile(r"-(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$")

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> tuple[Any, list[str]]:
        """Reject former and unknown names of options first, because a required one may be misspelled."""
        known = self._option_string_actions
        for word in itertools.takewhile("--".__ne__, args):
            name = word.partition("=")[0]
            new = renamed.OPTIONS.get(name, "")
            if name not in known and new.partition(" ")[0] in known:
                self.error(f"{name}: renamed; use {new}")
            if name.startswith("--") and not any(each.startswith(name) for each in known):
                self.error(f"unrecognized arguments: {name}{_hint(name, known)}")
        return super().parse_known_args(args, namespace)

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        if action.choices is not None and value not in action.choices:
            new = renamed.VALUES.get(value)
            text = f"{value}: renamed; use {new}" if new in action.choices else ""
            raise argparse.ArgumentError(action, text or no_option(value, [*action.choices]))

    def error(self, message: str) -> NoReturn:
        """Exit with code 2."""
        self.exit(2, f"{PROGRAM}: error: {one_line(message)} (see {self.prog} --help)\n")


def _hint(text: str, names: Iterable[str]) -> str:
    """Return a hint with the name closest to an unknown one."""
    near = difflib.get_close_matches(text, names, n=1)
    return f", did you mean {near[0]}?" if near else ""


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
    new = renamed.SUBCOMMANDS.get(name)
    if new is not None:
        raise argparse.ArgumentTypeError(f"{name}: renamed; use {new}")
    raise argparse.ArgumentTypeError(f"expected a subcommand, got {shown(name)}{_hint(name, SUBCOMMANDS)}")


if __name__ == "__main__":
    sys.exit(main())
