"""The command ``stewart-sym``: one subcommand for each job.

Reads arguments, calls the library, prints, and turns errors into one line and an exit code: 0 success,
1 ``derive --check`` found differences, 2 anything that could not be done, 128 + n ended by signal n: 130 by
Ctrl-C, 143 by SIGTERM, 129 by SIGHUP. What one needs is imported when it runs, so that none pays for SymPy,
SciPy or Matplotlib but those that use them.
"""

import argparse
import difflib
import itertools
import re
import sys
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
from .terminal import PROGRAM, give_up_stdout, one_line, warnings_in_lines

SUBCOMMANDS = {
    "reproduce": "studies.reproduce",
    "new": "machine.new",
    "robots": "machine.robots",
    "check": "machine.check",
    "export": "machine.export",
    "import": "machine.import_model",
    "forces": "machine.forces",
    "singularities": "machine.singularities",
    "workspace": "machine.workspace",
    "size-actuators": "machine.size_actuators",
    "plan": "machine.plan",
    "simulate": "machine.simulate",
    "view": "machine.view",
    "control": "studies.control",
    "controller": "studies.controller",
    "choose-fidelity": "studies.choose_fidelity",
    "chart": "studies.chart",
    "derive": "code.derive",
    "generate": "code.generate",
    "cmake-dir": "code.cmake_dir",
    "identify": "machine.identify",
    "benchmark": "studies.benchmark",
    "stability": "studies.stability",
}
"""Module of each subcommand, in the order of the help.

``HELP``, ``EXAMPLE`` and perhaps ``MORE`` are texts of its help; ``add_arguments`` tells a parser of its
arguments, ``run`` takes them and returns the exit code.
"""


def main(argv: Sequence[str] | None = None) -> int:
    """Run one subcommand; ``argv``: without the program's name, None for this process's. Returns the code."""
    words = sys.argv[1:] if argv is None else argv
    arguments = argparse.Namespace()
    # That of the subcommand alone where there is one: the others take longer than many a subcommand runs.
    parser = _parser(SUBCOMMANDS.keys() & words[:1] or SUBCOMMANDS)
    try:
        parser.parse_args(words, arguments)
        take_work_area()
        # An error of the system that names no file is one of printing: all that write files name theirs.
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
    """An error in one line, with the robot's file or an option where the library has its argument."""
    options = getattr(arguments, "options", ())
    line = one_line(error, options or None)
    name, mark, rest = line.partition(":")
    if name == "robot" and getattr(arguments, "robot", None) is not None:
        name = str(arguments.robot)
    option = f"--{name.replace('_', '-')}"
    return f"{option if option in options else name}{mark}{rest}"


_NEGATIVE = re.compile(r"-(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$")


class _Parser(argparse.ArgumentParser):
    """Reports a wrong command in one line that names the help of the subcommand in question."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Take numbers such as -1e-3 for numbers, not for options."""
        super().__init__(*args, **kwargs)
        self._negative_number_matcher = _NEGATIVE

    @property
    def actions(self) -> dict[str, argparse.Action]:
        """Options by their full names."""
        return {name: each for name, each in self._option_string_actions.items() if name.startswith("--")}

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> tuple[Any, list[str]]:
        """Reject unknown arguments here: a subparser would hand them on to the main one.

        Options come first: what is missing may be one of them, misspelled.
        """
        words = list(itertools.takewhile("--".__ne__, args or ()))
        if self._subparsers:
            # What follows a subcommand is for its own parser.
            words = list(itertools.takewhile(lambda word: word.startswith("-"), words))
        self._need_none([word for word in words if not self._known(word)])
        found, unknown = super().parse_known_args(args, namespace)
        self._need_none(unknown)
        return found, unknown

    def _known(self, word: str) -> bool:
        """Whether a word is an option, an abbreviated one, or none at all."""
        name, known = word.partition("=")[0], self._option_string_actions
        no_option = not name.startswith("-") or " " in word or _NEGATIVE.match(word)
        return bool(no_option) or word[:2] in known or any(each.startswith(name) for each in known)

    def _need_none(self, unknown: list[str]) -> None:
        if unknown:
            near = _near(unknown[0].partition("=")[0], self.actions)
            self.error(f"unrecognized arguments: {' '.join(unknown)}{near}")

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        if action.choices is not None and value not in action.choices:
            near = _near(value, action.choices) if action.nargs == argparse.PARSER else ""
            text = f"expected a subcommand, got {shown(value)}{near}"
            raise argparse.ArgumentError(action, text if near else no_option(value, tuple(action.choices)))

    def error(self, message: str) -> NoReturn:
        """Exit with code 2."""
        self.exit(2, f"{PROGRAM}: error: {one_line(message)} (see {self.prog} --help)\n")


def _near(text: str, names: Iterable[str]) -> str:
    """A name much like an unknown one, as a hint."""
    plain = {name.lstrip("-"): name for name in names}
    near = difflib.get_close_matches(text.lstrip("-"), list(plain), n=1)
    return f", did you mean {plain[near[0]]}?" if near else ""


def _parser(names: Iterable[str] = SUBCOMMANDS) -> argparse.ArgumentParser:
    """The parser of some subcommands."""
    parser = _Parser(
        prog=PROGRAM,
        description="Dynamics of the Stewart platform: derived by SymPy, emitted as C and NumPy, checked.",
        epilog="Example: stewart-sym reproduce -o reproduce",
    )
    parser.add_argument("--version", action="version", version=f"{PROGRAM} {version('stewart-sym')}")
    subparsers = parser.add_subparsers(title="subcommands", metavar="SUBCOMMAND", required=True)
    for name in names:
        module = import_module(f".{SUBCOMMANDS[name]}", __package__)
        more = getattr(module, "MORE", "")
        text = f"{module.HELP[0].upper()}{module.HELP[1:]}. {more}".strip()
        added = subparsers.add_parser(
            name, help=module.HELP, description=text, epilog=f"Example: {module.EXAMPLE}"
        )
        module.add_arguments(added)
        added.set_defaults(run=module.run, subcommand=name, options=[*added.actions])
    return parser


if __name__ == "__main__":
    sys.exit(main())
