"""C99 printer: structures by pointer, arrays with dimensions, names with the prefix ``STEWART_``."""

import textwrap
from collections.abc import Collection, Iterable, Iterator, Mapping
from itertools import groupby

from ..trace import nodes as t
from ..trace.fused import fused
from .spelling import ATOM, COMPARE, LEVELS, OR, PRODUCT, SELECT, SIGN, SUM, WIDTH, Printer, remark

_BUILT_IN = {
    "sqrt": "STEWART_SQRT",
    "size": "STEWART_FABS",
    "larger": "STEWART_LARGER",
    "fma": "STEWART_FMA",
    "fma_of": "STEWART_FMA_OF",
}
_PLAIN = {name: name for name in ("NULL", "LANES", "POSES")}
_NAMES = {t.Real: "stewart_real", t.Integer: "int", t.Count: "size_t", t.Truth: "int"}
PREPARATION = ("prepare_leg", "prepare_platform")
"""Functions that run once, and compute the constants that Python bakes into a kernel for one robot."""
_ALIGNED = {False: "", True: "STEWART_ALIGNED "}


class C(Printer):
    """Printer of functions, structures, and tables.

    Attributes
    ----------
    functions_by_name : dict
        Functions that are called; they determine how arguments are passed.
    sizes : dict
        Names of dimensions, such as ``{8: "LANES"}``.
    brackets : bool
        True for parentheses around each operand that is another kind of operation, as MISRA C recommends.
    records : dict
        Names of structures in C, if they differ.
    structures : dict
        Structures of variables by name.
    static : str
        Prefix of functions that are not in the interface.
    fused : bool
        True to print products that feed sums as ``STEWART_FMA``.
    apart : collection of str
        Functions without ``STEWART_FMA``.
    """

    def __init__(
        self,
        functions: Iterable[t.Function] = (),
        sizes: Mapping[int, str] | None = None,
        brackets: bool = False,
        records: Mapping[str, str] | None = None,
        structures: Iterable[t.Structure] = (),
        static: str = "static ",
        fused: bool = True,
        apart: Collection[str] = PREPARATION,
    ) -> None:
        super().__init__(functions)
        self.sizes, self.brackets = dict(sizes or {}), brackets
        self.static = static
        self.fused, self.apart = fused, apart
        self.records = dict(records or {})
        self.structures = {each.name: each for each in structures}
        self.empty: set[str] = set()
        self.pointers: set[str] = set()
        self.numbers: set[str] = set()

    def source(self, *parts: str | t.Structure | t.Table | t.Function) -> str:
        """Print texts, structures, tables, and functions, separated by empty lines."""
        functions = (each for each in parts if isinstance(each, t.Function))
        self.functions_by_name |= {each.name: each for each in functions}
        self.empty |= {each.name for each in parts if isinstance(each, t.Structure) and not each.members}
        return "\n".join(each if isinstance(each, str) else self._part(each) for each in parts)

    def _part(self, part: t.Structure | t.Table | t.Function) -> str:
        spelled = {t.Structure: self.structure, t.Table: self.table, t.Function: self.function}
        return "\n".join([*spelled[type(part)](part), ""])  # type: ignore[operator]

    # ------------------------------------------------------------ comments

    def remark(self, text: str, before: str = "") -> list[str]:
        """Print a comment; an empty line in the text begins a new paragraph."""
        if not text:
            return []
        first, *others = remark(text, WIDTH - len(before) - 6)
        *lines, last = [f"{before}/* {first}", *(f"{before} * {each}".rstrip() for each in others)]
        return [*lines, f"{last} */"]

    # ------------------------------------------------------------ types

    def declared(self, kind: t.Type, name: str) -> str:
        """Print a type with a name."""
        match kind:
            case t.Array(item, dims):
                return self.declared(item, name + self._dims(dims))
            case t.Pointer(item):
                return self.declared(item, f"*{name}")
            case t.Record(record):
                return f"{self.records.get(record, record)} {name}"
        return f"{_NAMES[type(kind)]} {name}"

    def _dims(self, dims: tuple[int, ...]) -> str:
        return "".join(f"[{self.sizes.get(count, count)}]" for count in dims)

    def structure(self, structure: t.Structure) -> list[str]:
        """Print a structure as a type."""
        members = [line for each in structure.members for line in self._member(each)]
        members = members or ["    int none; /* C has no structure without members */"]
        name = _ALIGNED[structure.aligned] + self.records.get(structure.name, structure.name)
        return [*self.remark(structure.meaning), "typedef struct {", *members, f"}} {name};"]

    def _member(self, field: t.Field) -> list[str]:
        declared = f"    {self.declared(field.type, field.name)};"
        line = f"{declared} /* {field.meaning} */" if field.meaning else declared
        return [line] if len(line) <= WIDTH + 40 else [*self.remark(field.meaning, "    "), declared]

    def table(self, table: t.Table) -> list[str]:
        """Print constant structures with their type."""
        many = len(table.rows) > 1
        rows = [line for row in table.rows for line in self._row(table.structure, row, many)]
        return [
            *self.structure(table.structure),
            "",
            *self.remark(table.meaning),
            f"static const {table.structure.name} {table.name}{f'[{len(table.rows)}]' if many else ''} = {{",
            *rows,
            "};",
        ]

    def _row(self, structure: t.Structure, row: tuple[float, ...], braces: bool) -> list[str]:
        numbers, members = list(row), []
        for field in structure.members:
            if isinstance(field.type, t.Array):
                parts = [f"REAL({numbers.pop(0)!r})" for _ in range(field.type.dims[0])]
                members.append(f"{{{', '.join(parts)}}}")
            else:
                members.append(f"REAL({numbers.pop(0)!r})")
        if braces:
            return self.lines("    ", f"{{{', '.join(members)}}},")
        return [line for each in members for line in self.lines("    ", f"{each},")]

    # ------------------------------------------------------------ expressions

    def number(self, value: int | float) -> str:
        if isinstance(value, int):
            return str(value)
        if value == 0.5:
            return "STEWART_HALF"
        return f"REAL({int(value) if value.is_integer() and abs(value) < 1e9 else repr(value)})"

    def constant(self, name: str) -> str:
        return _PLAIN.get(name, f"STEWART_{name}")

    def _text(self, node: t.Expression) -> tuple[str, int]:
        match node:
            case t.Name(name) if name in self.numbers:
                return f"*{name}", SIGN
            case t.Call("anywhere", (test,)):
                return self._text(test)
            case t.Member(t.Name(owner), name) if owner in self.pointers:
                return f"{owner}->{name}", ATOM
            case t.From(array, index):
                return f"&{self.text(array, ATOM)}[{self.text(index)}]", SIGN
            case t.As(t.Count(), t.Number(number)):
                return f"{number}U", ATOM
            case t.As(t.Pointer() as kind, value):
                return f"(const {self.declared(kind, '').strip()}){self._address(value)}", SIGN
            case t.As(kind, value):
                return f"({self.declared(kind, '').strip()}){self.text(value, ATOM)}", SIGN
            case t.Binary(operator, left, right):
                level, _, _ = LEVELS[operator]
                sign = operator if level == PRODUCT else f" {self.sign(operator)} "
                more = int(level > COMPARE)
                return f"{self._operand(left, operator)}{sign}{self._operand(right, operator, more)}", level
        return super()._text(node)

    def _operand(self, value: t.Expression, operator: str, more: int = 0) -> str:
        inner = value.operator if isinstance(value, t.Binary) else ""
        level, _, _ = LEVELS[operator]
        if level > COMPARE:
            # A signed factor needs parentheses.
            signed = level + more >= PRODUCT and isinstance(value, t.Negative)
            level, apart = (ATOM if signed else level + more), inner not in ("", operator)
        elif level == COMPARE:
            level, apart = SUM, bool(inner)
        else:
            level, apart = (OR if inner == operator else COMPARE), inner != operator
        return self.text(value, SIGN if self.brackets and apart else level)

    def select(self, node: t.Select) -> str:
        test = self.text(node.test, ATOM if self.brackets else COMPARE)
        return f"{test} ? {self.text(node.yes, SELECT + 1)} : {self.text(node.no)}"

    def call(self, node: t.Call) -> str:
        function = self.functions_by_name.get(node.function)
        if function is None:
            name = _BUILT_IN.get(node.function, node.function)
            return f"{name}({', '.join(map(self.text, node.arguments))})"
        pairs = zip(function.arguments, node.arguments, strict=True)
        passed = (self._passed(argument, value) for argument, value in pairs)
        return f"{node.function}({', '.join(passed)})"

    def _passed(self, argument: t.Argument, value: t.Expression) -> str:
        number = isinstance(argument.type, t.Real | t.Integer | t.Count)
        if isinstance(value, t.Name) and value.name in self.numbers and argument.changed:
            return value.name
        if isinstance(argument.type, t.Record) or (number and argument.changed):
            return self._address(value)
        return self.text(value)

    def _address(self, value: t.Expression) -> str:
        if isinstance(value, t.Select):
            return f"{self.text(value.test)} ? {self._address(value.yes)} : {self._address(value.no)}"
        is_address = isinstance(value, t.From) or (isinstance(value, t.Name) and value.name in self.pointers)
        return self.text(value) if is_address else f"&{self.text(value, ATOM)}"

    # ------------------------------------------------------------ statements

    def body(self, statements: Iterable[t.Statement], depth: int = 1) -> list[str]:
        """Print statements as lines; constants from one array are declared together."""
        lines: list[str] = []
        statements = _called_apart(statements) if self.brackets else statements
        for owner, run in groupby(statements, _loaded_from):
            found = list(run)
            if owner is None or len(found) == 1:
                lines += super().body(found, depth)
            else:
                loads = ", ".join(f"{each.name} = {self.text(each.value)}" for each in found)  # type: ignore[attr-defined]
                const = "const " if isinstance(found[0], t.Let) else ""
                lines += self.lines(self.indent * depth, f"{const}stewart_real {loads};")
        return lines

    def let(self, node: t.Let) -> str:
        if isinstance(node.type, t.Pointer) and isinstance(node.type.item, t.Real):
            const = "const " if isinstance(node.value, t.As) else ""
            return f"{const}{self.declared(node.type, f'const {node.name}')} = {self.text(node.value)};"
        if isinstance(node.type, t.Pointer):
            self.pointers.add(node.name)
            value = self._address(node.value)
            return f"const {self.declared(node.type, f'const {node.name}')} = {value};"
        return f"const {self.declared(node.type, node.name)} = {self.text(node.value)};"

    def variable(self, node: t.Variable) -> str:
        declared = _ALIGNED[node.aligned] + self.declared(node.type, node.name)
        if node.value is not None:
            return f"{declared} = {self.text(node.value)};"
        if node.blank:
            # Compilers warn if a function receives an uninitialized structure, even if it does not read it.
            empty = isinstance(node.type, t.Record) and node.type.name in self.empty
            return f"{declared}{' = {0}' if empty else ''};"
        return f"{declared} = {'REAL(0)' if node.type == t.Real() else self.zero(node.type)};"

    def zero(self, kind: t.Type) -> str:
        """Print zeros of a type, one for each member, because C++ compilers warn of missing initializers."""
        match kind:
            case t.Array(item, (count, *others)):
                inner = t.Array(item, tuple(others)) if others else item
                return f"{{{', '.join([self.zero(inner)] * count)}}}"
            case t.Record(name) if name in self.structures:
                return f"{{{', '.join(self.zero(each.type) for each in self.structures[name].members)}}}"
            case t.Record():
                return "{0}"
        return "0"

    def assign(self, before: str, target: t.Expression, value: t.Expression) -> list[str]:
        left, right = (
            f"*{each.name}" if isinstance(each, t.Name) and each.name in self.pointers else self.text(each)
            for each in (target, value)
        )
        return self.lines(before, f"{left} = {right};")

    def do(self, call: t.Call) -> str:
        function = self.functions_by_name.get(call.function)
        unread = "" if function is None or function.result is None else "(void)"
        return unread + self.call(call)

    def loop(self, node: t.For) -> str:
        index = node.index
        first, last = self.text(node.first), self.text(node.last)
        if node.down:
            end = f">= {node.last.value + 1}" if isinstance(node.last, t.Number) else f"> {last}"
            return f"for ({index} = {first}; {index} {end}; --{index})"
        step = f"++{index}" if node.step == t.Number(1) else f"{index} += {self.text(node.step)}"
        kept = "STEWART_LOOP " if node.kept else ""
        return f"{kept}for ({index} = {first}; {index} < {last}; {step})"

    def condition(self, test: str) -> str:
        return f"if ({test})"

    # ------------------------------------------------------------ functions

    def function(self, function: t.Function) -> list[str]:
        """Print a definition; functions of the interface have their comments at the declaration."""
        self._enter(function)
        if self.fused and function.name not in self.apart:
            function = fused(function)
        apart = "STEWART_APART " if function.apart else ""
        inlined = "STEWART_INLINE " if function.inlined else ""
        static = "" if function.public else f"{apart}{self.static}{inlined}"
        used = {each.name for each in t.names_in(function.body)}
        return [
            *([] if function.public else self.remark(function.meaning)),
            *self.head(static, function, ""),
            "{",
            *self._indices(function),
            *(f"    (void){each.name};" for each in function.arguments if each.name not in used),
            *self.body(function.body),
            "}",
        ]

    def interface(self, *parts: t.Structure | t.Function) -> str:
        """Print structures and declarations of public functions for a header."""
        found = [self.structure(each) for each in parts if isinstance(each, t.Structure)]
        found += [self.declaration(each) for each in parts if isinstance(each, t.Function) and each.public]
        return "\n".join("\n".join([*lines, ""]) for lines in found)

    def declaration(self, function: t.Function) -> list[str]:
        """Print the declaration of a public function with its comment for a header."""
        checked = "" if function.result is None else "STEWART_NODISCARD "
        return [*self.remark(function.meaning), *self.head(checked, function, ";")]

    def _enter(self, function: t.Function) -> None:
        """Record the names that are addresses in a function."""
        self.functions_by_name[function.name] = function
        arguments = function.arguments
        self.pointers = {each.name for each in arguments if isinstance(each.type, t.Record)}
        self.numbers = {
            each.name
            for each in arguments
            if each.changed and isinstance(each.type, t.Real | t.Integer | t.Count)
        }

    def head(self, before: str, function: t.Function, end: str) -> list[str]:
        """Print name, arguments, and result of a function between two texts."""
        result = "void" if function.result is None else self.declared(function.result, "").strip()
        arguments = ", ".join(map(self.argument, function.arguments)) or "void"
        return wrapped(f"{before}{result} {function.name}({arguments}){end}")

    def argument(self, argument: t.Argument) -> str:
        """Print the declaration of an argument."""
        name, kind = argument.name, argument.type
        const = "" if argument.changed else "const "
        alone = "STEWART_RESTRICT " if argument.alone else ""
        match kind:
            case t.Array(item, (_, *others)) if alone:
                pointer = f"*{alone}{name}"
                text = self.declared(item, f"({pointer}){self._dims(tuple(others))}" if others else pointer)
                return text if others else const + text
            case t.Array(item, dims):
                plain = len(dims) == 1 and not isinstance(item, t.Pointer)
                return (const if plain else "") + self.declared(kind, name)
            case t.Pointer() | t.Record():
                item = kind.item if isinstance(kind, t.Pointer) else kind
                return const + self.declared(item, f"*{alone}{name}")
        return self.declared(kind, f"*{name}" if argument.changed else name)

    def _indices(self, function: t.Function) -> list[str]:
        loops = [each for each in t.statements(function.body) if isinstance(each, t.For)]
        by_type = [
            (kind, sorted({each.index for each in loops if each.type == kind}))
            for kind in (t.Count(), t.Integer())
        ]
        return [
            f"    {_NAMES[type(kind)]} {names};"
            for kind, found in by_type
            for names in (found if self.brackets else filter(None, [", ".join(found)]))
        ]


def wrapped(declaration: str) -> list[str]:
    """Break a long declaration of a function after commas."""
    if len(declaration) <= WIDTH:
        return [declaration]
    name, bracket, rest = declaration.partition("(")
    # Blanks within an argument are hidden from the wrapping.
    hidden = rest.replace(" ", "\0").replace(",\0", ", ")
    lines = textwrap.wrap(hidden, WIDTH - 4, break_long_words=False, break_on_hyphens=False)
    return [name + bracket, *(f"    {line}".replace("\0", " ") for line in lines)]


def _called_apart(statements: Iterable[t.Statement]) -> Iterator[t.Statement]:
    """Assign returned structures instead of initializing with them, because a MISRA C checker mistakes them
    for parts.
    """
    for node in statements:
        match node:
            case t.Let(value=t.Call(), type=t.Record()) | t.Variable(value=t.Call(), type=t.Record()):
                assert node.value is not None
                yield t.Variable(node.name, node.type, blank=True)
                yield t.Assign(t.Name(node.name), node.value)
            case _:
                yield node


def _loaded_from(node: t.Statement) -> tuple[type, t.Expression] | None:
    """Return the array of which a constant, or the initial value of a variable, is an element."""
    if isinstance(node, t.Let | t.Variable) and isinstance(node.value, t.Element):
        return type(node), node.value.array
    return None
