"""Python on arrays of the array API: every number may be an array of one value for each pose."""

from ..kernel.constants import INTEGERS
from ..kernel.nodes import (
    Array,
    Call,
    For,
    Function,
    Integer,
    Let,
    Program,
    Record,
    Select,
    Structure,
    Type,
    Variable,
)
from .spelling import Printer


class Python(Printer):
    """Spells one program; ``on`` is the arithmetic: selections, square roots and constants."""

    end = ""
    both, either = "&", "|"
    opening, closing = ":", ""
    alternative, negation = "else:", "~"
    comment = "# {}"

    def __init__(self, program: Program) -> None:
        self.program = program

    def source(self) -> str:
        """Structures and functions."""
        lines = [line for each in self.program.structures for line in ("", "", *self.structure(each))]
        return "\n".join([*lines, *self.functions(self.program), ""])

    def functions(self, program: Program) -> list[str]:
        return [line for each in program.functions for line in ("", "", *self.function(each))]

    def structure(self, structure: Structure) -> list[str]:
        """A class whose members are zero at first."""
        members = [
            line
            for each in structure.members
            for line in (
                *([f"        # {each.meaning}"] if each.meaning else []),
                f"        self.{each.name}: Any = {self.zero(each.type)}",
            )
        ]
        return [
            f"class {structure.name}:",
            f'    """{structure.meaning}"""',
            "",
            "    def __init__(self) -> None:",
            *members,
        ]

    def zero(self, kind: Type) -> str:
        """Zeros of a type."""
        match kind:
            case Array(Record() as item, (count,)):
                return f"[{self.zero(item)} for _ in range({count})]"
            case Array(item, (count,)):
                return f"[{self.zero(item)}] * {count}"
            case Array(item, (count, *others)):
                return f"[{self.zero(Array(item, tuple(others)))} for _ in range({count})]"
            case Record(name):
                return f"{name}()"
            case Integer():
                return "0"
        return "0.0"

    # ------------------------------------------------------------ expressions

    def number(self, value: int | float) -> str:
        return repr(value)

    def constant(self, name: str) -> str:
        return name if name in INTEGERS else f"on.{name}"

    def element(self, array: str, index: list[str]) -> str:
        return array + "".join(f"[{each}]" for each in index)

    def select(self, node: Select) -> str:
        values = ", ".join(self.text(each) for each in (node.test, node.yes, node.no))
        return f"on.where({values})"

    def call(self, node: Call) -> str:
        arguments = [self.text(each) for each in node.arguments]
        if any(each.name == node.function for each in self.program.functions):
            return f"{node.function}({', '.join(['on', *arguments])})"
        return f"on.{node.function}({', '.join(arguments)})"

    # ------------------------------------------------------------ statements

    def let(self, node: Let) -> str:
        return f"{node.name} = {self.text(node.value)}"

    def variable(self, node: Variable) -> str:
        return f"{node.name} = {self.zero(node.type) if node.value is None else self.text(node.value)}"

    def loop(self, node: For) -> str:
        first, last = self.text(node.first), self.text(node.last)
        if node.down:
            return f"for {node.index} in range({first}, {last}, -1)"
        return f"for {node.index} in range({last if first == '0' else f'{first}, {last}'})"

    def condition(self, test: str) -> str:
        return f"if {test}"

    def function(self, function: Function) -> list[str]:
        arguments = ", ".join(["on: Arithmetic", *(f"{each.name}: Any" for each in function.arguments)])
        result = "None" if function.result is None else "Any"
        given = [
            f"    {each.name} = on.arrays({each.name})" for each in function.arguments if function.public
        ]
        return [
            *self.lines("", f"def {function.name}({arguments}) -> {result}:"),
            f'    """{function.meaning}"""',
            *given,
            *self.body(function.body),
        ]

    def lines(self, before: str, text: str) -> list[str]:
        """In parentheses where an assignment needs more than one line."""
        left, sign, right = text.partition(" = ")
        if len(before) + len(text) <= 108 or not sign or text.startswith("def "):
            return [before + text]
        inner = before + self.indent
        return [f"{before}{left} = (", *super().lines(inner, right), f"{before})"]
