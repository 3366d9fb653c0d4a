"""Kit in Rust: a crate without dependencies."""

from collections.abc import Iterable, Mapping, Sequence

from ...mechanics import quantities as n
from ...print.rust import Rust
from ...program.block import Quantity
from ...trace.constants import constants
from ...trace.decided_selections import of_one_pose
from ..functions import Vector
from ..text_format import Numbers, stored, template
from .contents import Contents, Value, compared
from .language import Language, array, spoilt


class RustKit(Language):
    """Kit that is a crate without dependencies."""

    name, title = "rust", "Rust, without its standard library if need be"
    precisions = ("double", "float")
    run = "cargo test && cargo run --example example"
    example = "examples/example.rs"
    prepare = "let model = prepare(&ROBOT);"
    robot = "&ROBOT"
    notes = template("rust_notes.md").strip()

    def files(self, kit: Contents) -> dict[str, str]:
        real, root = ("f64", "sqrt") if kit.precision == "double" else ("f32", "sqrtf")
        tests = "".join(self._test(kit, i, test) for i, test in enumerate(kit.tests, 1))
        same = self.statements(kit, "    assert_eq!({}, {});", "ROBOT")
        tests += template("rust_test_model.rs") if kit.prepared else ""
        calls = "\n".join(
            f'    {call}\n    println!("{output} {{:?}}", found);' for output, call in self.calls(kit).items()
        )
        numbers = [f"const {name}: Real = {value!r};" for name, value in constants(kit.precision).items()]
        return {
            "Cargo.toml": self.filled("rust_cargo.toml", kit),
            "src/lib.rs": self.filled(
                "rust_lib.rs",
                kit,
                program=Rust(of_one_pose(kit.program)).source(),
                real=real,
                root=root,
                statuses="\n".join(self._numbers(kit)),
                constants="\n".join(numbers),
            ),
            "src/robot.rs": self.filled("rust_robot.rs", kit, numbers=_rust_robot(kit.machine.numbers)),
            "tests/self_test.rs": self.filled("rust_test.rs", kit, same=same, tests=tests),
            self.example: self.filled(
                "rust_example.rs",
                kit,
                prepare=self.prepare if kit.prepared else "",
                given="\n".join(_rust_given(kit.examples)),
                calls=calls,
            ),
        }

    def _numbers(self, kit: Contents) -> Iterable[str]:
        """Yield the constants of statuses and limits."""
        for name, (code, says) in kit.whole_numbers.items():
            yield f"/// {says if name in ('MAX_STEPS', 'MAX_SEARCHES') else f'Status: {says}'}."
            yield f"pub const {name}: usize = {code};"

    def _test(self, kit: Contents, number: int, test: Vector) -> str:
        given, dims = kit.given(test), compared(kit.program, test.function)
        subject = {"robot": "&ROBOT"}.get(kit.subject(test.function), "&prepare(&ROBOT)")
        lines = [
            "",
            "#[test]",
            f"fn {test.function}_{number}() {{",
            *_rust_given(given),
            f"    {self.call(test.function, [subject, *given])}",
            f"    assert_eq!(found.status, {test.status});",
        ]
        for name, (answers, bounds) in kit.compared(test).items():
            *rows, width = dims[name]
            for i in range(*rows or (1,)):
                part, of_row = f"{name}[{i}]" if rows else name, slice(i * width, (i + 1) * width)
                answer, bound = array(answers[of_row]), array(bounds[of_row])
                lines += [f'    close("{part}", &found.{part}, &{answer}, &{bound});']
        for name, place, arguments in spoilt(kit, test, given):
            lines += [
                f"    let mut wrong = {name};",
                f"    {place}[0] = Real::NAN;",
                f"    {self.call(test.function, [subject, *arguments])}",
                "    assert_eq!(found.status, NOT_FINITE);",
            ]
        return "\n".join([*lines, "}", ""])

    def call(self, function: str, arguments: Sequence[str]) -> str:
        passed = [each if each.startswith("&") else f"&{each}" for each in arguments]
        return f"let found = {function}({', '.join(passed)});"


def _rust_members(
    numbers: Numbers, quantities: Iterable[Quantity], indent: str, leg: int | None = None
) -> list[str]:
    lines = []
    for q in quantities:
        values = stored(numbers, q, "robot", leg)
        lines.append(f"{indent}{q.name}: {array(values) if q.shape else repr(values[0])},")
    return lines


def _rust_given(given: Mapping[str, Value]) -> list[str]:
    lines = []
    for name, value in given.items():
        if isinstance(value, Mapping):
            members = [f"        {key}: {array(numbers)}," for key, numbers in value.items()]
            lines += [f"    let {name} = {'Motion' if name == 'motion' else 'Pose'} {{", *members, "    };"]
        else:
            lines.append(f"    let {name}: [Real; {len(value)}] = {array(value)};")
    return lines


def _rust_robot(numbers: Numbers) -> str:
    lines = ["Robot {", *_rust_members(numbers, n.PLATFORM, "    "), "    leg: ["]
    for i in range(6):
        lines += ["        Leg {", *_rust_members(numbers, n.of_leg(numbers), " " * 12, i), "        },"]
    return "\n".join([*lines, "    ],", "}"])
