"""Common parts of the kits in all languages: README, calls of the example, tables of constants."""

import textwrap
from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Mapping, Sequence

from ...mechanics import quantities as n
from ..functions import Vector
from ..text_format import in_markdown, stored, template
from .contents import Contents, Value


class Language(ABC):
    """Generator of the files of a kit in one language."""

    name: str
    title: str
    precisions: tuple[str, ...] = ("double",)
    run: str
    """Command that runs the self-test, then the example."""
    example: str
    """File name of the example."""

    prepare: str
    """Statement that prepares the constants."""
    robot: str
    """Robot as an argument."""
    notes: str
    """Language-specific notes for the README."""
    legs: Sequence[str] = tuple(f"leg[{i}]" for i in range(6))
    """Legs of a robot as expressions."""

    @abstractmethod
    def files(self, kit: Contents) -> dict[str, str]:
        """Return file name -> text, without README."""

    @abstractmethod
    def call(self, function: str, arguments: Sequence[str]) -> str:
        """Return a statement that calls a function and assigns the result to ``found``."""

    def calls(self, kit: Contents) -> dict[str, str]:
        """Return the call of each output that has a test."""
        names = {each: each for each in kit.examples} | {"model": "model", "robot": self.robot}
        return {
            output: self.call(
                output, [names.get(each.name, each.name) for each in kit.program.function(output).arguments]
            )
            for output in kit.outputs
            if output in kit.shown
        }

    def readme(self, kit: Contents, program: str) -> str:
        """Return the README of a kit; ``program`` is the text of the example."""
        return template(
            "readme.md",
            {
                "robot": in_markdown(kit.machine.name),
                "title": textwrap.fill(f"{self.title}; functions: {kit.says}.", 110),
                "version": kit.machine.version,
                "options": kit.options,
                "language": self.name,
                "run": self.run,
                "example": self.example,
                "program": textwrap.indent(program.strip(), "    "),
                "statuses": "\n".join(
                    f"| {code} | `{name}` | {says} |" for name, (code, says) in kit.returned.items()
                ),
                "guess": _GUESS if "forward_kinematics" in kit.outputs else "",
                "notes": self.notes,
            },
        )

    def filled(self, name: str, kit: Contents, **more: str) -> str:
        """Fill a template with the common words and with additional ones."""
        words = {
            "robot": kit.machine.name,
            "outputs": kit.says,
            "version": kit.machine.version,
            "crate": kit.machine.symbol,
        }
        return template(name, words | more)

    def statements(self, kit: Contents, statement: str, robot: str) -> str:
        """Return one statement for each quantity of a robot; {} in ``statement`` are its name and numbers."""
        made = [(q, f"{robot}.{q.name}", stored(kit.machine.numbers, q, "robot")) for q in n.PLATFORM] + [
            (q, f"{robot}.{leg}.{q.name}", stored(kit.machine.numbers, q, "robot", i))
            for i, leg in enumerate(self.legs)
            for q in n.of_leg(kit.machine.numbers)
        ]
        return "\n".join(
            statement.format(name, array(values) if q.shape else repr(values[0])) for q, name, values in made
        )


_GUESS = """
`forward_kinematics` performs up to three searches and returns the pose nearest to the guess. R of the guess
must be close to a rotation. If the guess is off by more than 0.05 (m, rad), compare the result with it."""


def spoilt(kit: Contents, test: Vector, given: Mapping[str, Value]) -> Iterator[tuple[str, str, list[str]]]:
    """Yield tests with NaN in one array that the function reads, in a copy named ``wrong``.

    Each item contains the copied argument, the array within the copy, and the arguments of the call. Only the
    first test of each function is used. ``given`` are the inputs by argument.
    """
    for name, value in given.items() if test is kit.shown[test.function] else ():
        arguments = ["wrong" if each == name else each for each in given]
        for place in ("wrong.R", "wrong.t") if isinstance(value, Mapping) else ("wrong",):
            yield name, place, arguments


def array(values: Iterable[float]) -> str:
    """Return numbers as a list in brackets."""
    return f"[{', '.join(map(repr, values))}]"
