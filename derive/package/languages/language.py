"""What the kits of all languages share: the README, the calls of the example, tables of constants."""

import textwrap
from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Mapping, Sequence

from ...mechanics import quantities as n
from ..functions import Vector
from ..text_format import in_markdown, stored, template
from .contents import Contents, Value


class Language(ABC):
    """The files of a kit in one language."""

    name: str
    title: str
    precisions: tuple[str, ...] = ("double",)
    run: str
    """Command that runs the self-test, then the example."""
    example: str
    """File name of the example."""

    prepare: str
    """The call that prepares the constants."""
    robot: str
    """The robot as an argument."""
    notes: str
    """What is peculiar to the language, for the README."""
    legs: Sequence[str] = tuple(f"leg[{i}]" for i in range(6))
    """The legs of a robot."""

    @abstractmethod
    def files(self, kit: Contents) -> dict[str, str]:
        """File name -> text, without README."""

    @abstractmethod
    def call(self, function: str, arguments: Sequence[str]) -> str:
        """Statement that calls a function and names its result ``found``."""

    def calls(self, kit: Contents) -> dict[str, str]:
        """The call of each output that has a test."""
        names = {each: each for each in kit.examples} | {"model": "model", "robot": self.robot}
        return {
            output: self.call(
                output, [names.get(each.name, each.name) for each in kit.program.function(output).arguments]
            )
            for output in kit.outputs
            if output in kit.shown
        }

    def readme(self, kit: Contents, program: str) -> str:
        """The README of a kit; ``program``: text of the example."""
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
        """A template with the words that all take and with more of its own."""
        words = {
            "robot": kit.machine.name,
            "outputs": kit.says,
            "version": kit.machine.version,
            "crate": kit.machine.symbol,
        }
        return template(name, words | more)

    def statements(self, kit: Contents, statement: str, robot: str) -> str:
        """One for each quantity of a robot; statement: with its name and its numbers as {}."""
        made = [(q, f"{robot}.{q.name}", stored(kit.machine.numbers, q, "robot")) for q in n.PLATFORM] + [
            (q, f"{robot}.{leg}.{q.name}", stored(kit.machine.numbers, q, "robot", i))
            for i, leg in enumerate(self.legs)
            for q in n.of_leg(kit.machine.numbers)
        ]
        return "\n".join(
            statement.format(name, array(values) if q.shape else repr(values[0])) for q, name, values in made
        )


_GUESS = """
`forward_kinematics` returns the nearest to its guess of the poses found by up to three searches. The guess's
R must be near a rotation. From a guess farther than 0.05 (m and rad) compare the result with the guess."""


def spoilt(kit: Contents, test: Vector, given: Mapping[str, Value]) -> Iterator[tuple[str, str, list[str]]]:
    """Arrays, read by every function, in which the first test of each puts NaN, in a copy called ``wrong``.

    given: by argument. Argument that is copied, place of the array in the copy, arguments of the call.
    """
    for name, value in given.items() if test is kit.shown[test.function] else ():
        arguments = ["wrong" if each == name else each for each in given]
        for place in ("wrong.R", "wrong.t") if isinstance(value, Mapping) else ("wrong",):
            yield name, place, arguments


def array(values: Iterable[float]) -> str:
    """Numbers as a list in brackets."""
    return f"[{', '.join(map(repr, values))}]"
