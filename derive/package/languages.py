"""Kits in Python, MATLAB and Rust: a program, a robot's numbers, a self-test, an example, a README."""

import textwrap
from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .. import notation as n
from ..block import Quantity
from ..kernel.constants import INTEGERS, NAMES, PRECISIONS, STATUS, constants
from ..kernel.nodes import Array, Constant, Program, Record, Type, parts_of
from ..kernel.settle import of_one_pose
from ..print.matlab import Matlab
from ..print.python import Python
from ..print.rust import Rust
from .words import in_markdown, template

Numbers = Mapping[str, Any]
Value = Sequence[float] | Mapping[str, Sequence[float]]
"""What a function is given: numbers, or a structure's members."""


@dataclass(frozen=True)
class Test:
    """One call: function, what it is given, answers and their bounds in rounding units.

    given: by argument, without robot and model; answers, bounds: by member, of a structure in a result
    ``pose.R``; all flat. Where status is not 0 there are no answers.
    """

    function: str
    given: Mapping[str, Value]
    answers: Mapping[str, Sequence[float]]
    bounds: Mapping[str, Sequence[float]]
    status: int = 0


@dataclass(frozen=True)
class Contents:
    """What goes into a kit.

    name, symbol: of the robot, the second fit for identifiers; numbers: quantity -> nested lists; outputs:
    public functions of the program; tests: at least one of each that has any, those with status 0 first;
    precision: "double" or "float"; options: of the command line.
    """

    name: str
    symbol: str
    numbers: Numbers
    program: Program
    outputs: tuple[str, ...]
    tests: tuple[Test, ...]
    precision: str
    options: str
    version: str

    @property
    def says(self) -> str:
        """The outputs in words."""
        return ", ".join(each.replace("_", " ") for each in self.outputs)

    @property
    def prepared(self) -> bool:
        """Whether there are constants to prepare."""
        return any(each.name == "prepare" for each in self.program.functions)

    @property
    def shown(self) -> dict[str, Test]:
        """The first test of each function that has one."""
        return {each.function: each for each in reversed(self.tests)}

    @property
    def given(self) -> dict[str, Value]:
        """An example of each argument of the functions, but robot and model."""
        found: dict[str, Value] = {}
        for test in self.shown.values():
            found = {**test.given, **found}
        return found

    def subject(self, function: str) -> str:
        """``robot`` or ``model``, the first argument of a function."""
        return self.program.function(function).arguments[0].name

    @property
    def read(self) -> set[str]:
        """Names of the statuses and limits that the program reads."""
        return {each.name for each in parts_of(self.program.functions) if isinstance(each, Constant)}

    @property
    def whole_numbers(self) -> dict[str, tuple[int, str]]:
        """Value and meaning of each status and limit of the program, by name."""
        return {name: of for name, of in INTEGERS.items() if name in {*STATUS, *self.read}}

    @property
    def returned(self) -> dict[str, tuple[int, str]]:
        """Value and meaning of each status that a function may return, by name."""
        possible = {"OK", *self.read} - {"MAX_STEPS"}
        if not self.prepared:
            possible.discard("POLE")  # kinematics alone needs no joint axes
        return {name: of for name, of in INTEGERS.items() if name in possible}


def compared(program: Program, function: str) -> dict[str, tuple[int, ...]]:
    """Arrays of a function's result by member, those of structures in it as ``pose.R``, with dimensions."""
    result = program.function(function).result
    return {} if result is None else _arrays(program, result, "")


def _arrays(program: Program, kind: Type, path: str) -> dict[str, tuple[int, ...]]:
    if isinstance(kind, Array):
        return {path: kind.dims}
    members = program.structure(kind.name).members if isinstance(kind, Record) else ()
    found: dict[str, tuple[int, ...]] = {}
    for each in members:
        found |= _arrays(program, each.type, f"{path}.{each.name}" if path else each.name)
    return found


def statuses(line: str, numbers: Mapping[str, tuple[int, str]] = STATUS) -> str:
    """A line for each status, with its ``{name}``, ``{code}`` and ``{meaning}``."""
    return "\n".join(
        line.format(name=name, code=code, meaning=says) for name, (code, says) in numbers.items()
    )


def numbers_of(precision: str, line: str) -> str:
    """A line for each constant, with its ``{name}`` and ``{value}``."""
    return "\n".join(
        line.format(name=name, value=repr(value)) for name, value in constants(precision).items()
    )


def stored(numbers: Numbers, quantity: Quantity, leg: int | None = None) -> list[float]:
    """Components of a quantity in storage order."""
    value = numbers[quantity.name] if leg is None else numbers[quantity.name][leg]
    return [float(_at(value, key)) for key in quantity.keys]


def _at(value: Any, key: Iterable[int]) -> Any:
    for i in key:
        value = value[i]
    return value


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

    @abstractmethod
    def files(self, kit: Contents) -> dict[str, str]:
        """File name -> text, without README."""

    @abstractmethod
    def call(self, function: str, arguments: Sequence[str]) -> str:
        """Statement that calls a function and names its result ``found``."""

    def calls(self, kit: Contents) -> dict[str, str]:
        """The call of each output that has a test."""
        names = {each: each for each in kit.given} | {"model": "model", "robot": self.robot}
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
                "robot": in_markdown(kit.name),
                "title": textwrap.fill(f"{self.title}; functions: {kit.says}.", 110),
                "version": kit.version,
                "options": kit.options,
                "language": self.name,
                "run": self.run,
                "example": self.example,
                "program": textwrap.indent(program.strip(), "    "),
                "statuses": statuses("| {code} | `{name}` | {meaning} |", kit.returned),
                "guess": _GUESS if "forward_kinematics" in kit.outputs else "",
                "notes": self.notes,
            },
        )

    def values(self, kit: Contents, **more: str) -> dict[str, str]:
        """What every template takes."""
        return {
            "robot": kit.name,
            "outputs": kit.says,
            "version": kit.version,
            "crate": kit.symbol,
            **more,
        }

    def assignments(self, kit: Contents, made: str, leg: str, indent: str, one: str) -> str:
        """Statements that fill a robot, one line a quantity."""
        lines = [_assigned(indent, made, q, stored(kit.numbers, q), one) for q in n.PLATFORM]
        for i in range(6):
            owner = leg.format(i, i + 1)
            lines += [_assigned(indent, f"{made}.{owner}", q, stored(kit.numbers, q, i), one) for q in n.LEG]
        return "\n".join(lines)


_GUESS = """
`forward_kinematics` finds the pose beside its guess, whose R must be near a rotation; from afar another one
may come out, or none."""
_READ = ("R", "t")
"""Members of a structure that every function reads."""


def _spoilt(test: Test) -> list[tuple[str, str]]:
    """Argument and member, "" for none, of the arrays that every function reads."""
    return [
        (name, member)
        for name, value in test.given.items()
        for member in (_READ if isinstance(value, Mapping) else ("",))
    ]


def _assigned(indent: str, owner: str, quantity: Quantity, values: Sequence[float], one: str) -> str:
    text = one.format(", ".join(map(repr, values))) if quantity.shape else repr(values[0])
    return f"{indent}{owner}.{quantity.name} = {text}{';' if one.endswith('.') else ''}".replace("].;", "];")


def python_arithmetic(numbers: Mapping[str, tuple[int, str]] = STATUS) -> str:
    """Status codes, constants and the class ``Arithmetic`` of modules on arrays."""
    found = {name: constants(name) for name in PRECISIONS}
    return template(
        "python_arithmetic.py",
        {
            "statuses": statuses("{name} = {code}  # {meaning}", numbers),
            "constants": "\n".join(f"    {name!r}: {values!r}," for name, values in found.items()),
            "declared": "\n".join(f"    {name}: float" for name in NAMES),
        },
    )


def python_module(program: Program, arithmetic: str, version: str) -> str:
    """A program as a module on arrays; ``arithmetic`` defines or imports the names of that text."""
    has_pose = any(each.name == "Pose" for each in program.structures)
    return template(
        "python_arrays.py",
        {
            "arithmetic": arithmetic,
            "program": Python(program).source(),
            "version": version,
            "poses": template("python_pose.py") if has_pose else "",
        },
    )


class PythonKit(Language):
    """One module on arrays."""

    name, title = "python", "Python, on arrays of NumPy, JAX, PyTorch and others"
    run = "python self_test.py && python example.py"
    example = "example.py"
    prepare = "model = stewart_arrays.prepare(on, machine)"
    robot = "machine"
    notes = template("python_notes.md").strip()

    def files(self, kit: Contents) -> dict[str, str]:
        tests = "".join(
            f"    [\n        {test.function!r},\n        {kit.subject(test.function)!r},\n"
            f"        {_plain(test.given)!r},\n        {test.status},\n"
            f"        {_plain(test.answers)!r},\n        {_plain(test.bounds)!r},\n    ],\n"
            for test in kit.tests
        )
        fill = self.assignments(kit, "made", "leg[{0}]", "    ", "[{}]")
        made = {
            "robot": kit.name.replace("\\", "\\\\").replace('"', '\\"'),
            "prepare": self.prepare if kit.prepared else "model = None",
        }
        calls = [
            line
            for output, call in self.calls(kit).items()
            for line in (
                call,
                f'print("{output}")',
                *(f'print("{path}", np.array(found.{path}))' for path in compared(kit.program, output)),
            )
        ]
        return {
            "stewart_arrays.py": python_module(
                kit.program, python_arithmetic(kit.whole_numbers), kit.version
            ),
            "robot.py": template("python_robot.py", self.values(kit, **made, numbers=fill)),
            "self_test.py": template("python_test.py", self.values(kit, **made, tests=tests)),
            "example.py": template(
                "python_example.py",
                self.values(kit, **made, given=_python_given(kit.given), calls="\n".join(calls)),
            ),
        }

    def call(self, function: str, arguments: Sequence[str]) -> str:
        return f"found = stewart_arrays.{function}({', '.join(['on', *arguments])})"


def _plain(values: Mapping[str, Value]) -> dict[str, Any]:
    return {
        name: {key: list(each) for key, each in value.items()} if isinstance(value, Mapping) else list(value)
        for name, value in values.items()
    }


def _python_given(given: Mapping[str, Value]) -> str:
    lines = []
    for name, value in given.items():
        if isinstance(value, Mapping):
            maker = "motion_of" if name == "motion" else "pose_at"
            fields = [f"    {key}={list(numbers)!r}," for key, numbers in value.items()]
            lines += [f"{name} = stewart_arrays.{maker}(", "    on,", *fields, ")"]
        else:
            lines.append(f"{name} = {list(value)!r}")
    return "\n".join(lines)


class MatlabKit(Language):
    """A package of functions."""

    name, title = "matlab", "MATLAB and Octave"
    run = 'octave-cli --eval "assert(self_test() == 0)" && octave-cli one_pose.m'
    example = "one_pose.m"
    prepare = "model = stewart.prepare(stewart.robot());"
    robot = "stewart.robot()"
    notes = template("matlab_notes.md").strip()

    def files(self, kit: Contents) -> dict[str, str]:
        shown = set(map(id, kit.shown.values()))
        tests = "\n".join(line for test in kit.tests for line in self._test(kit, test, id(test) in shown))
        calls = "\n".join(self.calls(kit).values())
        fill = self.assignments(kit, "made", "leg({1})", "    ", "[{}].")
        made = {f"+stewart/{name}": text for name, text in Matlab(of_one_pose(kit.program)).files().items()}
        values = self.values(
            kit,
            statuses=statuses("    made.{name} = {code}; % {meaning}", kit.whole_numbers),
            constants=numbers_of("double", "    made.{name} = {value};"),
        )
        helpers = ["where", "larger", "constants", "numbers", "motion_of"]
        helpers += ["pose_at"] if any(each.name == "Pose" for each in kit.program.structures) else []
        for name in helpers:
            made[f"+stewart/{name}.m"] = template(f"matlab_{name}.m", values)
        prepare = self.prepare if kit.prepared else ""
        return {
            **made,
            "+stewart/robot.m": template("matlab_robot.m", self.values(kit, numbers=fill)),
            "self_test.m": template("matlab_test.m", self.values(kit, prepare=prepare, tests=tests)),
            self.example: template(
                "matlab_example.m",
                self.values(kit, prepare=prepare, given="\n".join(_matlab_given(kit.given, "")), calls=calls),
            ),
        }

    def _test(self, kit: Contents, test: Test, wrong: bool) -> list[str]:
        names = [*test.given]
        subject = {"robot": "stewart.robot()"}.get(kit.subject(test.function), "model")
        lines = [
            *_matlab_given(test.given, "    "),
            f"    {self.call(test.function, [subject, *names])};",
            f"    failed = failed + (found.status ~= {test.status});",
        ]
        lines += [
            f"    failed = failed + close(found.{name}, [{', '.join(map(repr, test.answers[name]))}], "
            f"[{', '.join(map(repr, test.bounds[name]))}]);"
            for name in (compared(kit.program, test.function) if test.answers else ())
        ]
        for name, member in _spoilt(test) if wrong else ():
            place = f"wrong.{member}" if member else "wrong"
            wrong_call = self.call(
                test.function, [subject, *("wrong" if each == name else each for each in names)]
            )
            lines += [
                f"    wrong = {name};",
                f"    {place}(1) = NaN;",
                f"    {wrong_call};",
                "    failed = failed + (found.status ~= 1);",
            ]
        return lines

    def call(self, function: str, arguments: Sequence[str]) -> str:
        return f"found = stewart.{function}({', '.join(arguments)})"


def _matlab_given(given: Mapping[str, Value], indent: str) -> list[str]:
    lines = []
    for name, value in given.items():
        if isinstance(value, Mapping):
            lines.append(f"{indent}{name} = stewart.zero_{'motion' if name == 'motion' else 'pose'}();")
            lines += [f"{indent}{name}.{key} = {_array(numbers)};" for key, numbers in value.items()]
        else:
            lines.append(f"{indent}{name} = {_array(value)};")
    return lines


class RustKit(Language):
    """A crate without dependencies."""

    name, title = "rust", "Rust, without its standard library if need be"
    precisions = ("double", "float")
    run = "cargo test && cargo run --example example"
    example = "examples/example.rs"
    prepare = "let model = prepare(&ROBOT);"
    robot = "&ROBOT"
    notes = template("rust_notes.md").strip()

    def files(self, kit: Contents) -> dict[str, str]:
        real, root = ("f64", "sqrt") if kit.precision == "double" else ("f32", "sqrtf")
        shown = set(map(id, kit.shown.values()))
        tests = "".join(self._test(kit, i, test, id(test) in shown) for i, test in enumerate(kit.tests))
        tests += template("rust_test_model.rs") if kit.prepared else ""
        calls = "\n".join(
            f'    {call}\n    println!("{output} {{:?}}", found);' for output, call in self.calls(kit).items()
        )
        program = Rust(of_one_pose(kit.program)).source()
        return {
            "Cargo.toml": template("rust_cargo.toml", self.values(kit)),
            "src/lib.rs": template(
                "rust_lib.rs",
                self.values(
                    kit,
                    program=program,
                    real=real,
                    root=root,
                    statuses=statuses(
                        "/// {meaning}.\npub const {name}: usize = {code};",
                        {
                            name: (code, says if name == "MAX_STEPS" else f"Status: {says}")
                            for name, (code, says) in kit.whole_numbers.items()
                        },
                    ),
                    constants=numbers_of(kit.precision, "const {name}: Real = {value};"),
                ),
            ),
            "src/robot.rs": template("rust_robot.rs", self.values(kit, numbers=_rust_robot(kit.numbers))),
            "tests/self_test.rs": template("rust_test.rs", self.values(kit, tests=tests)),
            self.example: template(
                "rust_example.rs",
                self.values(
                    kit,
                    prepare=self.prepare if kit.prepared else "",
                    given="\n".join(_rust_given(kit.given)),
                    calls=calls,
                ),
            ),
        }

    def _test(self, kit: Contents, number: int, test: Test, wrong: bool) -> str:
        subject = {"robot": "&ROBOT"}.get(kit.subject(test.function), "&prepare(&ROBOT)")
        lines = [
            "",
            "#[test]",
            f"fn {test.function}_{number + 1}() {{",
            *_rust_given(test.given),
            f"    {self.call(test.function, [subject, *test.given])}",
            f"    assert_eq!(found.status, {test.status});",
        ]
        for name, dims in compared(kit.program, test.function).items() if test.answers else ():
            rows = [(name, 0)] if len(dims) == 1 else [(f"{name}[{i}]", i) for i in range(dims[0])]
            for part, i in rows:
                numbers = [
                    _array(list(values[name])[i * dims[-1] : (i + 1) * dims[-1]])
                    for values in (test.answers, test.bounds)
                ]
                lines += [f'    close("{part}", &found.{part}, &{numbers[0]}, &{numbers[1]});']
        for name, member in _spoilt(test) if wrong else ():
            arguments = ["wrong" if each == name else each for each in test.given]
            lines += [
                f"    let mut wrong = {name};",
                f"    wrong{f'.{member}' if member else ''}[0] = Real::NAN;",
                f"    {self.call(test.function, [subject, *arguments])}",
                "    assert_eq!(found.status, NOT_FINITE);",
            ]
        return "\n".join([*lines, "}", ""])

    def call(self, function: str, arguments: Sequence[str]) -> str:
        passed = [each if each.startswith("&") else f"&{each}" for each in arguments]
        return f"let found = {function}({', '.join(passed)});"


def _array(values: Iterable[float]) -> str:
    return f"[{', '.join(map(repr, values))}]"


def _rust_members(pairs: Iterable[tuple[Quantity, Sequence[float]]], indent: str) -> list[str]:
    return [f"{indent}{q.name}: {_array(values) if q.shape else repr(values[0])}," for q, values in pairs]


def _rust_given(given: Mapping[str, Value]) -> list[str]:
    lines = []
    for name, value in given.items():
        if isinstance(value, Mapping):
            members = [f"        {key}: {_array(numbers)}," for key, numbers in value.items()]
            lines += [f"    let {name} = {'Motion' if name == 'motion' else 'Pose'} {{", *members, "    };"]
        else:
            lines.append(f"    let {name}: [Real; {len(value)}] = {_array(value)};")
    return lines


def _rust_robot(numbers: Numbers) -> str:
    lines = ["Robot {", *_rust_members(((q, stored(numbers, q)) for q in n.PLATFORM), "    "), "    leg: ["]
    for i in range(6):
        legs = _rust_members(((q, stored(numbers, q, i)) for q in n.LEG), " " * 12)
        lines += ["        Leg {", *legs, "        },"]
    return "\n".join([*lines, "    ],", "}"])


LANGUAGES: dict[str, Language] = {each.name: each for each in (PythonKit(), MatlabKit(), RustKit())}
"""Languages of kits besides C, by the name that the command line takes."""
