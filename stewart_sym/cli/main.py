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
import textwrap
from collections.abc import Iterable, Sequence
from importlib import import_module
from importlib.metadata import version
from typing import Any, NoReturn

from ..backend.native import CompilerError
from ..io.arguments import no_option, shown
from ..io.atomic_write import named
from ..io.blas import take_work_area
from ..io.extras import needed_for
from ..io.interrupts import as_interrupts, exit_code
from . import renamed
from .terminal import PROGRAM, give_up_stdout, one_line, warnings_in_lines

GROUPS = {
    "machine": {
        "new": "machine.new",
        "robots": "machine.robots",
        "check": "machine.check",
        "view": "machine.view",
        "import": "machine.import_model",
        "export": "machine.export",
    },
    "computation": {
        "forces": "machine.forces",
        "size-actuators": "machine.size_actuators",
        "workspace": "machine.workspace",
        "singularities": "machine.singularities",
        "plan": "machine.plan",
        "simulate": "machine.simulate",
        "identify": "machine.identify",
    },
    "code": {
        "generate": "code.generate",
        "choose-fidelity": "studies.choose_fidelity",
        "cmake-dir": "code.cmake_dir",
        "derive": "code.derive",
    },
    "studies": {
        "reproduce": "studies.reproduce",
        "chart": "studies.chart",
        "stability": "studies.stability",
        "benchmark": "studies.benchmark",
    },
}
"""Module of each subcommand by group, in the order of the help.

A module has the constants ``HELP``, ``EXAMPLE``, and optionally ``MORE`` for its help, a function
``add_arguments`` that defines its options, and a function ``run`` that returns the exit code.
"""

SUBCOMMANDS = {name: module for group in GROUPS.values() for name, module in group.items()}
"""Module of each subcommand."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run one subcommand with the arguments of the process or ``argv``, and return the exit code."""
    words = sys.argv[1:] if argv is None else argv
    arguments = argparse.Namespace()
    # One parser only, because building all of them takes longer than many subcommands.
    parser = _parser(SUBCOMMANDS.keys() & words[:1] or SUBCOMMANDS)
    try:
        parser.parse_args(words, arguments)
        take_work_area()
        # A system error without a file name is an error of printing, because errors of files have names.
        with named("standard output"):
            given = (getattr(arguments, name, None) for name in ("robot", "trajectory"))
            sources = [path for path in given if path is not None]
            lines = warnings_in_lines(*sources, options=arguments.options)
            with lines, as_interrupts(), needed_for(arguments.subcommand):
                code: int = arguments.run(arguments)
            sys.stdout.flush()
        return code
    except BrokenPipeError:
        give_up_stdout()
        return 2
    except KeyboardInterrupt:
        return exit_code()
    except (ValueError, OSError, ImportError, CompilerError, MemoryError, Warning) as error:
        print(f"{PROGRAM}: error: {_error_line(error, arguments)}", file=sys.stderr)
        try:
            sys.stdout.flush()
        except OSError:
            give_up_stdout()
        return 2


def _error_line(error: BaseException, arguments: argparse.Namespace) -> str:
    """Format an error as one line that names the robot file or option in place of the library argument."""
    options = getattr(arguments, "options", ())
    line = one_line(error, options or None)
    name, mark, rest = line.partition(":")
    if name == "robot" and getattr(arguments, "robot", None) is not None:
        name = str(arguments.robot)
    option = f"--{name.replace('_', '-')}"
    return f"{option if option in options else name}{mark}{rest}"


_NEGATIVE = re.compile(r"-(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$")


class _Formatter(argparse.HelpFormatter):
    """Help with the line breaks of descriptions, and with subcommands in groups."""

    def _fill_text(self, text: str, width: int, indent: str) -> str:
        lines = (textwrap.fill(line, width, subsequent_indent="  ") for line in text.splitlines())
        return textwrap.indent("\n".join(lines), indent)

    def _format_action(self, action: argparse.Action) -> str:
        if not isinstance(action, argparse._SubParsersAction):
            return super()._format_action(action)
        lines = {each.dest: super(_Formatter, self)._format_action(each) for each in action._choices_actions}
        parts = [
            "".join(
                [f"  {title}:\n", *(textwrap.indent(lines[name], "  ") for name in group if name in lines)]
            )
            for title, group in GROUPS.items()
        ]
        return "\n".join(parts)


class _Parser(argparse.ArgumentParser):
    """Parser whose errors are one line that names the help of the subcommand."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Read -1e-3 as a number, not as an option."""
        kwargs.setdefault("formatter_class", _Formatter)
        super().__init__(*args, **kwargs)
        self._negative_number_matcher = _NEGATIVE

    @property
    def actions(self) -> dict[str, argparse.Action]:
        """Options by their full names."""
        return {name: each for name, each in self._option_string_actions.items() if name.startswith("--")}

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> tuple[Any, list[str]]:
        """Reject unknown arguments here, because a subparser would pass them on to the main parser.

        Options are checked first, because a missing argument may be a misspelled option.
        """
        words = list(itertools.takewhile("--".__ne__, args or ()))
        if self._subparsers:
            # The words after a subcommand belong to its own parser.
            words = list(itertools.takewhile(lambda word: word.startswith("-"), words))
        self._need_present(words)
        self._need_none([word for word in words if not self._known(word)])
        found, unknown = super().parse_known_args(args, namespace)
        self._need_none(unknown)
        return found, unknown

    def _need_present(self, words: list[str]) -> None:
        """Reject former names of options, which may also be abbreviations of present ones."""
        for name in (word.partition("=")[0] for word in words):
            new = renamed.OPTIONS.get(name, "")
            if name not in self.actions and new.partition(" ")[0] in self.actions:
                self.error(f"{name}: renamed; use {new}")

    def _known(self, word: str) -> bool:
        """Return True if a word is an option, an abbreviation of one, or not an option at all."""
        name, known = word.partition("=")[0], self._option_string_actions
        no_option = not name.startswith("-") or " " in word or _NEGATIVE.match(word)
        return bool(no_option) or word[:2] in known or any(each.startswith(name) for each in known)

    def _need_none(self, unknown: list[str]) -> None:
        if unknown:
            near = _near(unknown[0].partition("=")[0], self.actions)
            self.error(f"unrecognized arguments: {' '.join(unknown)}{near}")

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        if action.choices is not None and value not in action.choices:
            new = renamed.VALUES.get(value) or renamed.SUBCOMMANDS.get(value)
            if new in action.choices:
                raise argparse.ArgumentError(None, f"{_place(action)}{value}: renamed; use {new}")
            near = _near(value, action.choices) if action.nargs == argparse.PARSER else ""
            text = f"expected a subcommand, got {shown(value)}{near}"
            raise argparse.ArgumentError(action, text if near else no_option(value, tuple(action.choices)))

    def error(self, message: str) -> NoReturn:
        """Exit with code 2."""
        self.exit(2, f"{PROGRAM}: error: {one_line(message)} (see {self.prog} --help)\n")


def _place(action: argparse.Action) -> str:
    """Return the option of a value, for an error message; no text for a subcommand."""
    return f"{action.option_strings[-1]} " if action.option_strings else ""


def _near(text: str, names: Iterable[str]) -> str:
    """Return a hint with the name closest to an unknown one."""
    plain = {name.lstrip("-"): name for name in names}
    near = difflib.get_close_matches(text.lstrip("-"), list(plain), n=1)
    return f", did you mean {plain[near[0]]}?" if near else ""


def _parser(names: Iterable[str] = SUBCOMMANDS) -> argparse.ArgumentParser:
    """Return the parser of some subcommands."""
    parser = _Parser(
        prog=PROGRAM,
        description="Closed-form dynamics of Gough-Stewart platforms as C and Python code.",
        epilog="Example: stewart-sym reproduce -o reproduce",
    )
    parser.add_argument("--version", action="version", version=f"{PROGRAM} {version('stewart-sym')}")
    subparsers = parser.add_subparsers(title="subcommands", metavar="SUBCOMMAND", required=True)
    for name in names:
        module = import_module(f".{SUBCOMMANDS[name]}", __package__)
        more = getattr(module, "MORE", "")
        text = f"{module.HELP[0].upper()}{module.HELP[1:]}.\n{more}".strip()
        added = subparsers.add_parser(
            name, help=module.HELP, description=text, epilog=f"Example: {module.EXAMPLE}"
        )
        module.add_arguments(added)
        added.set_defaults(run=module.run, subcommand=name, options=[*added.actions])
    return parser


if __name__ == "__main__":
    sys.exit(main())
