"""Rust printer for ``no_std``: structures that are copied, functions that borrow."""

from functools import reduce

from ..trace import nodes as t
from .spelling import SUM, WIDTH, Printer, remark


class Rust(Printer):
    """Printer of one program; ``Real`` is ``f64``, or ``f32`` in kits of single precision."""

    comment = "// ", ""

    def __init__(self, program: t.Program) -> None:
        self.program = program
        super().__init__(program.functions)

    def source(self) -> str:
        """Print structures and functions, without the constants that they read."""
        parts = [*map(self.structure, self.program.structures), *map(self.function, self.program.functions)]
        return "\n".join([*(line for part in parts for line in ("", *part)), ""])

    # ------------------------------------------------------------ types

    def type(self, kind: t.Type) -> str:
        """Print the name of a type."""
        match kind:
            case t.Array(item, dims):
                return _nested(self.type(item), dims)
            case t.Record(name):
                return name
        return {t.Real: "Real", t.Integer: "usize", t.Count: "usize", t.Truth: "bool"}[type(kind)]

    def zero(self, kind: t.Type) -> str:
        """Print zeros of a type."""
        match kind:
            case t.Array(item, dims):
                return _nested(self.zero(item), dims)
            case t.Record(name):
                return f"{name}::ZERO"
        return {t.Real: "0.0", t.Integer: "0", t.Count: "0", t.Truth: "false"}[type(kind)]

    def structure(self, structure: t.Structure) -> list[str]:
        """Print a structure and its zero."""
        name = structure.name
        members = [
            line
            for each in structure.members
            for line in (
                *([f"    /// {each.meaning}"] if each.meaning else []),
                f"    pub {each.name}: {self.type(each.type)},",
            )
        ]
        zeros = [f"        {each.name}: {self.zero(each.type)}," for each in structure.members]
        return [
            f"/// {structure.meaning}",
            "#[derive(Clone, Copy, Debug, PartialEq)]",
            f"pub struct {name} {{",
            *members,
            "}",
            "",
            f"impl {name} {{",
            "    /// Every number zero.",
            f"    pub const ZERO: {name} = {name} {{",
            *zeros,
            "    };",
            "}",
        ]

    # ------------------------------------------------------------ expressions

    def number(self, value: int | float) -> str:
        return repr(value)

    def constant(self, name: str) -> str:
        return name

    select_level = SUM

    def select(self, node: t.Select) -> str:
        return f"if {self.text(node.test)} {{ {self.text(node.yes)} }} else {{ {self.text(node.no)} }}"

    def call(self, node: t.Call) -> str:
        if node.function == "anywhere":
            return self.text(node.arguments[0])
        function = self.functions_by_name.get(node.function)
        if function is None:
            return f"{node.function}({', '.join(map(self.text, node.arguments))})"
        passed = [
            f"{'' if _by_value(each.type) else '&mut ' if each.changed else '&'}{self.text(value)}"
            if not (isinstance(value, t.Name) and value.name in self.borrowed)
            else self.text(value)
            for each, value in zip(function.arguments, node.arguments, strict=True)
        ]
        return f"{node.function}({', '.join(passed)})"

    # ------------------------------------------------------------ statements

    borrowed: frozenset[str] = frozenset()

    def let(self, node: t.Let) -> str:
        return f"let {node.name} = {self.text(node.value)};"

    def variable(self, node: t.Variable) -> str:
        value = self.zero(node.type) if node.value is None else self.text(node.value)
        return f"let mut {node.name}: {self.type(node.type)} = {value};"

    def loop(self, node: t.For) -> str:
        index = node.index
        if not any(each.name == index for part in t.statements(node.body) for each in t.names_in(part)):
            index = "_"
        if node.down:
            return f"for {index} in (0..{self.text(node.first)} + 1).rev()"
        return f"for {index} in {self.text(node.first)}..{self.text(node.last)}"

    def function(self, function: t.Function) -> list[str]:
        self.borrowed = frozenset(each.name for each in function.arguments if not _by_value(each.type))
        reading = {n.name for each in t.statements(function.body) for n in t.names_in(each)}
        arguments = ", ".join(
            f"{'' if each.name in reading else '_'}{each.name}: {self._passed(each.type, each.changed)}"
            for each in function.arguments
        )
        result = "" if function.result is None else f" -> {self.type(function.result)}"
        visible = "pub " if function.public else ""
        return [
            *(f"/// {line}".rstrip() for line in remark(function.meaning, WIDTH - 4)),
            *self.lines("", f"{visible}fn {function.name}({arguments}){result} {{"),
            *self.body(function.body),
            "}",
        ]

    def _passed(self, kind: t.Type, changed: bool) -> str:
        if _by_value(kind):
            return self.type(kind)
        return f"&{'mut ' if changed else ''}{self.type(kind)}"


def _by_value(kind: t.Type) -> bool:
    return not isinstance(kind, t.Array | t.Record)


def _nested(text: str, dims: tuple[int, ...]) -> str:
    """Print an array type or value with nested dimensions."""
    return reduce(lambda inner, count: f"[{inner}; {count}]", reversed(dims), text)
