"""Base class of the printers: operator precedence, line breaks, and indentation."""

import textwrap
from abc import ABC, abstractmethod
from collections.abc import Iterable

from ..trace import nodes as t

WIDTH = 108
SELECT, OR, AND, COMPARE, SUM, PRODUCT, SIGN, ATOM = range(8)
LEVELS = {
    **dict.fromkeys("+-", (SUM, SUM, PRODUCT)),
    **dict.fromkeys("*/", (PRODUCT, PRODUCT, SIGN)),
    **dict.fromkeys(("<", "<=", ">", ">=", "==", "!="), (COMPARE, SUM, SUM)),
    "&": (AND, SIGN, SIGN),
    "|": (OR, SIGN, SIGN),
}
"""Precedence of an operation, and the least precedence of its left and right operand."""


class Printer(ABC):
    """Printer of a program in one language; subclasses define all language-specific text."""

    indent = "    "
    end = ";"
    both, either = "&&", "||"
    unequal = "!="
    opening, closing = " {", "}"
    alternative = "} else {"
    negation = "!"
    comment = "/* ", " */"
    select_level = SELECT

    def __init__(self, functions: Iterable[t.Function]) -> None:
        """Set the functions that are called; they determine how arguments are passed."""
        self.functions_by_name = {each.name: each for each in functions}

    # ------------------------------------------------------------ language-specific

    @abstractmethod
    def number(self, value: int | float) -> str:
        """Print a literal."""

    @abstractmethod
    def constant(self, name: str) -> str:
        """Print a constant of the arithmetic or a status."""

    @abstractmethod
    def select(self, node: t.Select) -> str:
        """Print a selection as an expression."""

    @abstractmethod
    def call(self, node: t.Call) -> str:
        """Print a call as an expression."""

    @abstractmethod
    def let(self, node: t.Let) -> str:
        """Print a constant with its value."""

    @abstractmethod
    def variable(self, node: t.Variable) -> str:
        """Print a variable with its initial value, or zeros."""

    @abstractmethod
    def loop(self, node: t.For) -> str:
        """Print the head of a loop."""

    @abstractmethod
    def function(self, function: t.Function) -> list[str]:
        """Print a function."""

    # ------------------------------------------------------------ expressions

    def text(self, node: t.Expression, least: int = SELECT) -> str:
        """Print an expression, in parentheses if its precedence is below ``least``."""
        text, level = self._text(node)
        return f"({text})" if level < least else text

    def _text(self, node: t.Expression) -> tuple[str, int]:
        match node:
            case t.Number(value):
                return self.number(value), ATOM
            case t.Constant(name):
                return self.constant(name), ATOM
            case t.Name(name):
                return name, ATOM
            case t.Member(owner, name):
                return f"{self.text(owner, ATOM)}.{name}", ATOM
            case t.Element(array, index):
                return self.element(self.text(array, ATOM), [self.text(i) for i in index]), ATOM
            case t.Not(value):
                return f"{self.negation}{self.text(value, ATOM)}", SIGN
            case t.Negative(value):
                return f"-{self.text(value, PRODUCT)}", SIGN if _level(value) > PRODUCT else SUM
            case t.Binary(operator, left, right):
                level, first, second = LEVELS[operator]
                return f"{self.text(left, first)} {self.sign(operator)} {self.text(right, second)}", level
            case t.Select():
                return self.select(node), self.select_level
            case t.Call():
                return self.call(node), ATOM
        raise AssertionError(node)

    def sign(self, operator: str) -> str:
        """Print an operator."""
        return {"&": self.both, "|": self.either, "!=": self.unequal}.get(operator, operator)

    def element(self, array: str, index: list[str]) -> str:
        """Print an element of an array with zero-based index."""
        return array + "".join(f"[{each}]" for each in index)

    # ------------------------------------------------------------ statements

    def body(self, statements: Iterable[t.Statement], depth: int = 1) -> list[str]:
        """Print statements as lines."""
        before = self.indent * depth
        lines: list[str] = []
        for node in statements:
            match node:
                case t.Comment(text):
                    lines.append(text.join([before + self.comment[0], self.comment[1]]))
                case t.Let():
                    lines += self.lines(before, self.let(node))
                case t.Variable():
                    lines += self.lines(before, self.variable(node))
                case t.Assign(target, value):
                    lines += self.assign(before, target, value)
                case t.Do(call):
                    lines += self.lines(before, self.do(call) + self.end)
                case t.Return(value):
                    lines += self.lines(before, self.returned(value))
                case t.Break():
                    lines.append(f"{before}break{self.end}")
                case t.For():
                    lines += self.nested(before, self.loop(node), node.body, depth)
                case t.If():
                    lines += self.conditional(before, node, depth)
                case _:
                    raise AssertionError(node)
        return lines

    def conditional(self, before: str, node: t.If, depth: int) -> list[str]:
        """Print a condition with its alternative."""
        lines = self.nested(before, self.condition(self.text(node.test)), node.body, depth)
        if not node.otherwise:
            return lines
        closing = 1 if self.closing else 0
        others = self.nested(before, "", node.otherwise, depth)[1:]
        return [*lines[: len(lines) - closing], before + self.alternative, *others]

    def condition(self, test: str) -> str:
        """Print the head of a condition."""
        return f"if {test}"

    def nested(self, before: str, head: str, body: Iterable[t.Statement], depth: int) -> list[str]:
        """Print a loop or a condition."""
        closing = [before + self.closing] if self.closing else []
        return [*self.lines(before, head + self.opening), *self.body(body, depth + 1), *closing]

    def assign(self, before: str, target: t.Expression, value: t.Expression) -> list[str]:
        """Print ``target = value``."""
        return self.lines(before, f"{self.text(target)} = {self.text(value)}{self.end}")

    def do(self, call: t.Call) -> str:
        """Print a call as a statement."""
        return self.call(call)

    def returned(self, value: t.Expression | None) -> str:
        """Print the return statement of a function."""
        return f"return{'' if value is None else f' {self.text(value)}'}{self.end}"

    def lines(self, before: str, text: str) -> list[str]:
        """Break a long line before an operator or after a comma."""
        lines, line = [], before
        more = before + self.indent
        for word in text.split(" "):
            if len(line) + 1 + len(word) > WIDTH and _breaks(line, word):
                lines.append(line + self.continued)
                line = more + word
            else:
                line = line + word if line in (before, more) else f"{line} {word}"
        return [*lines, line]

    continued = ""
    """Text at the end of a line that is continued."""


def _level(node: t.Expression) -> int:
    return LEVELS[node.operator][0] if isinstance(node, t.Binary) else ATOM


def _breaks(line: str, word: str) -> bool:
    return word in ("+", "-", "*", "/", "?", ":", "&&", "||") or line.endswith((",", "("))


def remark(meaning: str, width: int) -> list[str]:
    """Wrap the description of a function to lines, with an empty line between paragraphs."""
    paragraphs = [
        textwrap.wrap(each, width, break_long_words=False, break_on_hyphens=False)
        for each in meaning.split("\n\n")
    ]
    return [line for i, each in enumerate(paragraphs) for line in ([""] * bool(i) + each)]
