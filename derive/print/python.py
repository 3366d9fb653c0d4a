"""Python printer for the array API: each number may be an array with one value per pose."""

from collections.abc import Collection, Iterable, Mapping
from itertools import groupby
from types import MappingProxyType

from ..trace import nodes as t
from ..trace.constants import INTEGERS
from .spelling import ATOM, WIDTH, Printer, remark


class Python(Printer):
    """Printer of one program; ``on`` is the arithmetic: selections, square roots, and constants."""

    end = ""
    both, either = "&", "|"
    opening, closing = ":", ""
    alternative, negation = "else:", "~"
    comment = "# ", ""

    def __init__(self, program: t.Program) -> None:
        super().__init__(program.functions)
        self.program = program

    def source(self, without: Collection[str] = ()) -> str:
        """Print structures and functions, except the names in ``without``."""
        parts: list[list[str]] = [
            self.structure(each) for each in self.program.structures if each.name not in without
        ]
        parts += [self.function(each) for each in self.program.functions if each.name not in without]
        return "\n".join([*(line for part in parts for line in ("", "", *part)), ""])

    def structure(self, structure: t.Structure) -> list[str]:
        """Print a class whose members are initially zero."""
        members = [line for each in structure.members for line in self._member(each)]
        return [
            f"class {structure.name}:",
            f'    """{structure.meaning}"""',
            "",
            "    def __init__(self) -> None:",
            *members,
        ]

    def _member(self, member: t.Field) -> list[str]:
        line = f"        self.{member.name}: Any = {self.zero(member.type)}"
        said = f"  # {member.meaning}" if member.meaning else ""
        return [line + said] if len(line + said) <= WIDTH else [f"        {said.strip()}", line]

    def zero(self, kind: t.Type) -> str:
        """Print zeros of a type."""
        match kind:
            case t.Array(t.Record() as item, (count,)):
                return f"[{self.zero(item)} for _ in range({count})]"
            case t.Array(item, (count,)):
                return f"[{self.zero(item)}] * {count}"
            case t.Array(item, (count, *others)):
                return f"[{self.zero(t.Array(item, tuple(others)))} for _ in range({count})]"
            case t.Record(name):
                return f"{name}()"
            case t.Integer():
                return "0"
        return "0.0"

    # ------------------------------------------------------------ expressions

    def number(self, value: int | float) -> str:
        return repr(value)

    def constant(self, name: str) -> str:
        return name if name in INTEGERS else f"on.{name}"

    def _text(self, node: t.Expression) -> tuple[str, int]:
        if isinstance(node, t.Element) and self.varies(node):
            return f"on.at({', '.join(map(self.text, (node.array, *node.index)))})", ATOM
        return super()._text(node)

    def varies(self, node: t.Element) -> bool:
        """Return True if poses use different elements: the index is neither a loop index nor an argument."""
        return not all(each.name in self.fixed for each in t.names_in(node.index))

    fixed: frozenset[str] = frozenset()

    def assign(self, before: str, target: t.Expression, value: t.Expression) -> list[str]:
        if isinstance(target, t.Element) and self.varies(target):
            parts = ", ".join(map(self.text, (target.array, value, *target.index)))
            return self.lines(before, f"on.put({parts})")
        return super().assign(before, target, value)

    def select(self, node: t.Select) -> str:
        values = ", ".join(self.text(each) for each in (node.test, node.yes, node.no))
        return f"on.where({values})"

    def call(self, node: t.Call) -> str:
        arguments = [self.text(each) for each in node.arguments]
        if node.function in self.functions_by_name:
            return f"{node.function}({', '.join(['on', *arguments])})"
        return f"on.{node.function}({', '.join(arguments)})"

    # ------------------------------------------------------------ statements

    def body(self, statements: Iterable[t.Statement], depth: int = 1) -> list[str]:
        """Print statements as lines; successive loads or stores of elements of one array share a line."""
        lines: list[str] = []
        for array, run in groupby(statements, _array):
            found = list(run)
            together = self._together(self.indent * depth, array, found) if len(found) > 1 else []
            lines += together or super().body(found, depth)
        return lines

    def _together(self, before: str, array: t.Expression | None, found: list[t.Statement]) -> list[str]:
        """Print loads or stores of elements as one statement; return no lines if this is impossible."""
        whole = array is not None and self._is_whole(array, [_element(each) for each in found])
        values = [each.value for each in found if isinstance(each, t.Let | t.Assign)]
        text = ", ".join(map(self.text, values))
        if all(isinstance(each, t.Let) for each in found):
            names = ", ".join(each.name for each in found if isinstance(each, t.Let))
            line = f"{before}{names} = {self.text(array) if whole and array is not None else text}"
            return [line] if len(line) <= WIDTH else []
        if not whole or array is None or {*t.names_in(array)} & {*t.names_in(tuple(values))}:
            return []
        line = f"{before}{self.text(array)} = [{text}]"
        if len(line) <= WIDTH:
            return [line]
        parts: list[str] = []
        for each in values:
            parts += super().lines(before + self.indent, f"{self.text(each)},")
        return [f"{before}{self.text(array)} = [", *parts, f"{before}]"]

    def _is_whole(self, array: t.Expression, elements: list[t.Element | None]) -> bool:
        """Return True if the elements are all elements of a structure's member in order."""
        if not isinstance(array, t.Member) or not isinstance(array.owner, t.Name):
            return False
        dims = [
            each.type.dims
            for structure in self.program.structures
            if structure.name == self.records.get(array.owner.name)
            for each in structure.members
            if each.name == array.name and isinstance(each.type, t.Array)
        ]
        found = [each.index for each in elements if each is not None]
        return dims == [(len(found),)] and found == [(t.Number(i),) for i in range(len(found))]

    records: Mapping[str, str] = MappingProxyType({})

    def let(self, node: t.Let) -> str:
        return f"{node.name} = {self.text(node.value)}"

    def variable(self, node: t.Variable) -> str:
        return f"{node.name} = {self.zero(node.type) if node.value is None else self.text(node.value)}"

    def loop(self, node: t.For) -> str:
        first, last = self.text(node.first), self.text(node.last)
        if node.down:
            return f"for {node.index} in range({first}, {last}, -1)"
        return f"for {node.index} in range({last if first == '0' else f'{first}, {last}'})"

    def function(self, function: t.Function) -> list[str]:
        loops = {each.index for each in t.statements(function.body) if isinstance(each, t.For)}
        made = [each for each in function.body if isinstance(each, t.Variable)]
        known: list[t.Argument | t.Variable] = [*function.arguments, *made]
        self.records = {each.name: each.type.name for each in known if isinstance(each.type, t.Record)}
        self.fixed = frozenset(loops | {each.name for each in function.arguments if each.type == t.Integer()})
        arguments = ", ".join(["on: Arithmetic", *(f"{each.name}: Any" for each in function.arguments)])
        result = "None" if function.result is None else "Any"
        given = [
            f'    {each.name} = on.arrays(on.checked({self.zero(each.type)}, "{each.name}", {each.name}))'
            for each in function.arguments
            if function.public
        ]
        if taken := [f"{each.name}={each.name}" for each in function.arguments[1:] if function.public]:
            given.append(f"    on.agree({', '.join(taken)})")
        return [
            *self.lines("", f"def {function.name}({arguments}) -> {result}:"),
            *_docstring(function.meaning),
            *given,
            *self.body(function.body),
        ]

    def lines(self, before: str, text: str) -> list[str]:
        """Add parentheses to an assignment that needs more than one line."""
        left, sign, right = text.partition(" = ")
        if len(before) + len(text) <= WIDTH or not sign or text.startswith("def "):
            return [before + text]
        return super().lines(before, f"{left} = ({right})")


def _docstring(meaning: str) -> list[str]:
    first, *others = remark(meaning, WIDTH - 10)
    lines = [f'    """{first}', *(f"    {line}".rstrip() for line in others)]
    return [*lines, '    """'] if others else [f'{lines[0]}"""']


def _element(node: t.Statement) -> t.Element | None:
    """Return the element that a constant loads or an assignment stores."""
    value = node.value if isinstance(node, t.Let) else node.target if isinstance(node, t.Assign) else None
    return value if isinstance(value, t.Element) else None


def _array(node: t.Statement) -> t.Expression | None:
    element = _element(node)
    return None if element is None else element.array
