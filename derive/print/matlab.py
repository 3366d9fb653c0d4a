"""MATLAB and Octave printer: a package of functions that return the arguments they change."""

import math
import textwrap

from ..trace import nodes as t
from ..trace.nodes import snake
from .spelling import Printer


class Matlab(Printer):
    """Printer of one program as files of the package ``+stewart``; structures contain double and int32."""

    unequal = "~="
    opening, closing = "", "end"
    alternative, negation = "else", "~"
    comment = "% ", ""
    continued = " ..."

    def __init__(self, program: t.Program) -> None:
        self.program = program
        super().__init__(program.functions)
        self.result = ""

    def files(self) -> dict[str, str]:
        """Return the text of each file by name."""
        of_functions = {each.name: self.function(each) for each in self.program.functions}
        of_structures = {f"zero_{snake(each.name)}": self.structure(each) for each in self.program.structures}
        checks = {f"checked_{snake(each.name)}": self.check(each) for each in self._given()}
        return {
            f"{name}.m": "\n".join([*lines, ""])
            for name, lines in (of_functions | of_structures | checks).items()
        }

    def _given(self) -> list[t.Structure]:
        """Return the structures that callers fill: arguments of public functions without a status."""
        names = [
            each.type.name
            for function in self.program.functions
            for each in function.arguments
            if function.public and isinstance(each.type, t.Record)
        ]
        found: dict[str, t.Structure] = {}
        while names:
            each = self.program.structure(names.pop())
            if not any(member.type == t.Integer() for member in each.members):
                found[each.name] = each
                kinds = (m.type.item if isinstance(m.type, t.Array) else m.type for m in each.members)
                names += [kind.name for kind in kinds if isinstance(kind, t.Record)]
        return list(found.values())

    def check(self, structure: t.Structure) -> list[str]:
        """Print a function that converts all numbers of a structure to double, or raises an error."""
        name = f"checked_{snake(structure.name)}"
        lines = [line for each in structure.members for line in self._checked_member(each)]
        return [
            f"function made = {name}(given)",
            f"%{name.upper()} {structure.meaning} Numbers as double; an error for other shapes.",
            f"    made = stewart.zero_{snake(structure.name)}();",
            *lines,
            "end",
        ]

    def _checked_member(self, member: t.Field) -> list[str]:
        name, kind = member.name, member.type
        if isinstance(kind, t.Array) and isinstance(kind.item, t.Record):
            check = f"stewart.checked_{snake(kind.item.name)}"
            return [
                f"    if numel(given.{name}) ~= {kind.dims[0]}",
                f"        error('{name}: expected {kind.dims[0]}, got %d', numel(given.{name}));",
                "    end",
                f"    for i = 1:{kind.dims[0]}",
                f"        made.{name}(i) = {check}(given.{name}(i));",
                "    end",
            ]
        return [f"    made.{name} = {self._checked(f'given.{name}', name, kind)};"]

    def _checked(self, value: str, name: str, kind: t.Type) -> str:
        if isinstance(kind, t.Record):
            return f"stewart.checked_{snake(kind.name)}({value})"
        count = math.prod(kind.dims) if isinstance(kind, t.Array) else 1
        return f"stewart.numbers({value}, {count}, '{name}')"

    def structure(self, structure: t.Structure) -> list[str]:
        """Print a function that returns a structure of zeros."""
        members = [
            f"    made.{each.name} = {self.zero(each.type)};{f' % {each.meaning}' if each.meaning else ''}"
            for each in structure.members
        ]
        name = f"zero_{snake(structure.name)}"
        return [
            f"function made = {name}()",
            f"%{name.upper()} {structure.meaning} Every number zero.",
            *members,
            "end",
        ]

    def zero(self, kind: t.Type) -> str:
        """Print zeros of a type."""
        match kind:
            case t.Array(t.Record(name), dims):
                return f"repmat(stewart.zero_{snake(name)}(), {dims[0]}, 1)"
            case t.Array(_, dims):
                rows, columns = dims if len(dims) == 2 else (dims[0], 1)
                return f"zeros({rows}, {columns})"
            case t.Record(name):
                return f"stewart.zero_{snake(name)}()"
            case t.Integer():
                return "int32(0)"
        return "0"

    # ------------------------------------------------------------ expressions

    def number(self, value: int | float) -> str:
        return repr(int(value)) if value == int(value) and abs(value) < 1e9 else repr(value)

    def constant(self, name: str) -> str:
        return f"constants.{name}"

    def element(self, array: str, index: list[str]) -> str:
        return f"{array}({', '.join(_plus(each, 1) for each in index)})"

    def select(self, node: t.Select) -> str:
        values = ", ".join(self.text(each) for each in (node.test, node.yes, node.no))
        return f"stewart.where({values})"

    def call(self, node: t.Call) -> str:
        if node.function == "anywhere":
            return self.text(node.arguments[0])
        spelled = {"sqrt": "sqrt", "size": "abs", "larger": "stewart.larger"}
        name = spelled.get(node.function, f"stewart.{node.function}")
        return f"{name}({', '.join(map(self.text, node.arguments))})"

    # ------------------------------------------------------------ statements

    def _results(self, value: t.Expression, first: list[str]) -> str:
        """Print the left-hand side of an assignment for the results and the changed arguments of a call."""
        if not isinstance(value, t.Call) or value.function not in self.functions_by_name:
            return first[0]
        function = self.functions_by_name[value.function]
        changed = [
            self.text(argument)
            for argument, each in zip(value.arguments, function.arguments, strict=True)
            if each.changed
        ]
        return _together([*first, *changed])

    def let(self, node: t.Let) -> str:
        return f"{self._results(node.value, [node.name])} = {self.text(node.value)};"

    def variable(self, node: t.Variable) -> str:
        if node.value is None:
            return f"{node.name} = {self.zero(node.type)};"
        return f"{self._results(node.value, [node.name])} = {self.text(node.value)};"

    def assign(self, before: str, target: t.Expression, value: t.Expression) -> list[str]:
        left = self._results(value, [self.text(target)])
        return self.lines(before, f"{left} = {self.text(value)};")

    def do(self, call: t.Call) -> str:
        function = self.functions_by_name.get(call.function)
        unused = ["~"] if function is not None and function.result is not None else []
        return f"{self._results(call, unused)} = {self.call(call)}"

    def loop(self, node: t.For) -> str:
        first, last = self.text(node.first), self.text(node.last)
        if node.down:
            return f"for {node.index} = {first}:-1:{_plus(last, 1)}"
        return f"for {node.index} = {first}:{_plus(last, -1)}"

    def returned(self, value: t.Expression | None) -> str:
        if value is None:
            return "return;"
        return "" if value == t.Name(self.result) else f"result = {self.text(value)};"

    def function(self, function: t.Function) -> list[str]:
        match function.body[-1]:
            case t.Return(t.Name(name)):
                self.result = name
            case _:
                self.result = ""
        result = [] if function.result is None else [self.result or "result"]
        left = _together([*result, *(each.name for each in function.arguments if each.changed)])
        arguments = ", ".join(each.name for each in function.arguments)
        body = [line for line in self.body(function.body) if line.strip()]
        if function.public:
            made = {each.name for each in self._given()}
            checked = [
                each
                for each in function.arguments
                if not isinstance(each.type, t.Record) or each.type.name in made
            ]
            body[:0] = [
                f"    {each.name} = {self._checked(each.name, each.name, each.type)};" for each in checked
            ]
        if any("constants." in line for line in body):
            body.insert(0, "    constants = stewart.constants();")
        return [
            *self.lines("", f"function {left} = {function.name}({arguments})"),
            *textwrap.wrap(
                f"%{function.name.upper()} {' '.join(function.meaning.split())}".rstrip(),
                100,
                subsequent_indent="% ",
                break_long_words=False,
                break_on_hyphens=False,
            ),
            *body,
            "end",
        ]


def _together(names: list[str]) -> str:
    """Print the left-hand side of an assignment to one or several names."""
    return names[0] if len(names) == 1 else f"[{', '.join(names)}]"


def _plus(text: str, more: int) -> str:
    """Add an integer to ``text`` in the shortest form."""
    if text.removeprefix("-").isdigit():
        return str(int(text) + more)
    before, sign, number = text.rpartition(" + ")
    if sign and number.isdigit():
        total = int(number) + more
        return before if total == 0 else f"{before} + {total}"
    return f"{text} {'+' if more > 0 else '-'} {abs(more)}"
