"""Kits in Python, MATLAB and Rust: a program, a robot's numbers, a self-test, an example, a README."""

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .. import notation as n
from ..block import Quantity
from ..kernel import outputs
from ..kernel.constants import NAMES, PRECISIONS, STATUS, constants
from ..kernel.nodes import Array, Program
from ..print.matlab import Matlab
from ..print.python import Python
from ..print.rust import Rust
from .words import template

Numbers = Mapping[str, Any]


@dataclass(frozen=True)
class Test:
    """One call: function, fields of the motion and of F, answers and their bounds in rounding units; flat."""

    function: str
    motion: Mapping[str, Sequence[float]]
    F: Sequence[float] | None
    answers: Mapping[str, Sequence[float]]
    bounds: Mapping[str, Sequence[float]]


@dataclass(frozen=True)
class Contents:
    """What goes into a kit.

    name, symbol: of the robot, the second fit for identifiers; numbers: quantity -> nested lists; outputs: of
    ``kernel.outputs.OUTPUTS``; precision: "double" or "float"; options: of the command line; says: the
    outputs in words.
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


RESULTS: dict[str, dict[str, tuple[int, ...]]] = {
    output: {each.name: each.type.dims for each in result.members if isinstance(each.type, Array)}
    for output, result in outputs.RESULTS.items()
}
"""Members of each output that are compared."""


def statuses(line: str) -> str:
    """A line for each status, with its ``{name}``, ``{code}`` and ``{meaning}``."""
    return "\n".join(line.format(name=name, code=code, meaning=says) for name, (code, says) in STATUS.items())


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

    prepare: str
    """The call that prepares the constants."""
    notes: str
    """What is peculiar to the language, for the README."""

    @abstractmethod
    def files(self, kit: Contents) -> dict[str, str]:
        """File name -> text, without README."""

    @abstractmethod
    def call(self, kit: Contents, output: str) -> str:
        """One call, as the README shows it."""

    def readme(self, kit: Contents) -> str:
        """The README of a kit."""
        calls = "\n    ".join([self.prepare, *(self.call(kit, output) for output in kit.outputs)])
        return template(
            "readme.md",
            {
                "robot": kit.name,
                "title": self.title,
                "outputs": kit.says,
                "version": kit.version,
                "options": kit.options,
                "language": self.name,
                "run": self.run,
                "calls": calls,
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
            "first": kit.outputs[0],
            "force": self.no_force if kit.outputs[0] in outputs.FORCED else "",
            **more,
        }

    no_force = ""

    def assignments(self, kit: Contents, made: str, leg: str, indent: str, one: str) -> str:
        """Statements that fill a robot, one line a quantity."""
        lines = [_assigned(indent, made, q, stored(kit.numbers, q), one) for q in n.PLATFORM]
        for i in range(6):
            owner = leg.format(i, i + 1)
            lines += [_assigned(indent, f"{made}.{owner}", q, stored(kit.numbers, q, i), one) for q in n.LEG]
        return "\n".join(lines)

    def motion(self, motion: Mapping[str, Sequence[float]], indent: str, one: str) -> str:
        """Statements that fill a motion."""
        return "\n".join(_assigned(indent, "motion", q, list(motion[q.name]), one) for q in n.MOTION)


def _assigned(indent: str, owner: str, quantity: Quantity, values: Sequence[float], one: str) -> str:
    text = one.format(", ".join(map(repr, values))) if quantity.shape else repr(values[0])
    return f"{indent}{owner}.{quantity.name} = {text}{';' if one.endswith('.') else ''}".replace("].;", "];")


def python_arithmetic() -> str:
    """Status codes, constants and the class ``Arithmetic`` of modules on arrays."""
    found = {name: constants(name) for name in PRECISIONS}
    return template(
        "python_arithmetic.py",
        {
            "statuses": statuses("{name} = {code}  # {meaning}"),
            "constants": "\n".join(f"    {name!r}: {values!r}," for name, values in found.items()),
            "declared": "\n".join(f"    {name}: float" for name in NAMES),
        },
    )


def python_module(program: Program, arithmetic: str, version: str) -> str:
    """A program as a module on arrays; ``arithmetic`` defines or imports the names of that text."""
    text = Python(program).source()
    return template("python_arrays.py", {"arithmetic": arithmetic, "program": text, "version": version})


class PythonKit(Language):
    """One module on arrays."""

    name, title = "python", "Python, on arrays of NumPy, JAX, PyTorch and others"
    run = "python self_test.py && python example.py"
    no_force = ", [0.0] * 6"
    prepare = "model = stewart_arrays.prepare(on, robot())"
    notes = (
        "`motion_of(on, R=..., t=..., ...)` makes a motion, R (..., 3, 3). NumPy warns of divisions\n"
        'by zero in poses without a result, unless under `np.errstate(all="ignore")`.'
    )

    def files(self, kit: Contents) -> dict[str, str]:
        tests = "".join(
            f"    [\n        {test.function!r},\n        {dict(test.motion)!r},\n        {_list(test.F)},\n"
            f"        {dict(test.answers)!r},\n        {dict(test.bounds)!r},\n    ],\n"
            for test in kit.tests
        )
        first = kit.tests[0]
        fill = self.assignments(kit, "made", "leg[{0}]", "    ", "[{}]")
        calls = "\n".join(f'print("{output}", vars({self.call(kit, output)}))' for output in kit.outputs)
        return {
            "stewart_arrays.py": python_module(kit.program, python_arithmetic(), kit.version),
            "robot.py": template("python_robot.py", self.values(kit, numbers=fill)),
            "self_test.py": template("python_test.py", self.values(kit, tests=tests)),
            "example.py": template(
                "python_example.py",
                self.values(kit, motion=_fields(first.motion), calls=calls),
            ),
        }

    def call(self, kit: Contents, output: str) -> str:
        F = ", F" if output in outputs.FORCED else ""
        return f"stewart_arrays.{output}(on, model, motion{F})"


class MatlabKit(Language):
    """A package of functions."""

    name, title = "matlab", "MATLAB and Octave"
    run = 'octave-cli --eval "exit(self_test())" && octave-cli one_pose.m'
    no_force = ", zeros(6, 1)"
    prepare = "model = stewart.prepare(stewart.robot())"
    notes = (
        "`stewart.motion_of(R, t, omega, v, alpha, a, F_ext, M_ext)` makes a motion, R 3 x 3;\n"
        "the member `motion.R` by itself is row-major: `reshape(R.', 9, 1)`."
    )

    def files(self, kit: Contents) -> dict[str, str]:
        tests = "\n".join(line for test in kit.tests for line in self._test(test))
        calls = "\n".join(f"found = {self.call(kit, output)}" for output in kit.outputs)
        fill = self.assignments(kit, "made", "leg({1})", "    ", "[{}].")
        made = {f"+stewart/{name}": text for name, text in Matlab(kit.program).files().items()}
        values = self.values(
            kit,
            statuses=statuses("    made.{name} = {code}; % {meaning}"),
            constants=numbers_of("double", "    made.{name} = {value};"),
        )
        for name in ("where", "larger", "constants", "motion_of"):
            made[f"+stewart/{name}.m"] = template(f"matlab_{name}.m", values)
        first = kit.tests[0]
        return {
            **made,
            "+stewart/robot.m": template("matlab_robot.m", self.values(kit, numbers=fill)),
            "self_test.m": template("matlab_test.m", self.values(kit, tests=tests)),
            "one_pose.m": template(
                "matlab_example.m",
                self.values(kit, motion=self.motion(first.motion, "", "[{}]."), calls=calls),
            ),
        }

    def _test(self, test: Test) -> list[str]:
        F = "" if test.F is None else f", [{'; '.join(map(repr, test.F))}]"
        compared = [
            f"    failed = failed + close(found.{name}, [{', '.join(map(repr, test.answers[name]))}], "
            f"[{', '.join(map(repr, test.bounds[name]))}]);"
            for name in RESULTS[test.function]
        ]
        return [
            "    motion = stewart.zero_motion();",
            self.motion(test.motion, "    ", "[{}]."),
            f"    found = stewart.{test.function}(model, motion{F});",
            "    failed = failed + (found.status ~= 0);",
            *compared,
        ]

    def call(self, kit: Contents, output: str) -> str:
        F = ", zeros(6, 1)" if output in outputs.FORCED else ""
        return f"stewart.{output}(model, motion{F})"


class RustKit(Language):
    """A crate without dependencies."""

    name, title = "rust", "Rust, without its standard library if need be"
    precisions = ("double", "float")
    run = "cargo test && cargo run --example example"
    no_force = ", &[0.0; 6]"
    prepare = "let model = prepare(&ROBOT);"
    notes = "`motion.R` is row-major."

    def files(self, kit: Contents) -> dict[str, str]:
        real, root = ("f64", "sqrt") if kit.precision == "double" else ("f32", "sqrtf")
        tests = "".join(self._test(i, test) for i, test in enumerate(kit.tests))
        calls = "\n".join(f'    println!("{{:?}}", {self.call(kit, output)});' for output in kit.outputs)
        program = Rust(kit.program).source()
        return {
            "Cargo.toml": template("rust_cargo.toml", self.values(kit)),
            "src/lib.rs": template(
                "rust_lib.rs",
                self.values(
                    kit,
                    program=program,
                    real=real,
                    root=root,
                    statuses=statuses("/// Status: {meaning}.\npub const {name}: usize = {code};"),
                    constants=numbers_of(kit.precision, "const {name}: Real = {value};"),
                ),
            ),
            "src/robot.rs": template("rust_robot.rs", self.values(kit, numbers=_rust_robot(kit.numbers))),
            "tests/self_test.rs": template("rust_test.rs", self.values(kit, tests=tests)),
            "examples/example.rs": template(
                "rust_example.rs",
                self.values(kit, motion=_rust_motion(kit.tests[0].motion, "    "), calls=calls),
            ),
        }

    def _test(self, number: int, test: Test) -> str:
        F = "" if test.F is None else f", &{_array(test.F)}"
        lines = [
            "",
            "#[test]",
            f"fn {test.function}_{number + 1}() {{",
            f"    let motion = {_rust_motion(test.motion, '    ')};",
            f"    let found = {test.function}(&prepare(&ROBOT), &motion{F});",
            "    assert_eq!(found.status, OK);",
        ]
        for name, dims in RESULTS[test.function].items():
            rows = [(name, 0)] if len(dims) == 1 else [(f"{name}[{i}]", i) for i in range(dims[0])]
            for part, i in rows:
                numbers = [
                    _array(list(values[name])[i * dims[-1] : (i + 1) * dims[-1]])
                    for values in (test.answers, test.bounds)
                ]
                lines += [f'    close("{part}", &found.{part}, &{numbers[0]}, &{numbers[1]});']
        return "\n".join([*lines, "}", ""])

    def call(self, kit: Contents, output: str) -> str:
        F = ", &[0.0; 6]" if output in outputs.FORCED else ""
        return f"{output}(&model, &motion{F})"


def _fields(motion: Mapping[str, Sequence[float]]) -> str:
    return "\n".join(f"    {q.name}={list(motion[q.name])!r}," for q in n.MOTION)


def _array(values: Iterable[float]) -> str:
    return f"[{', '.join(map(repr, values))}]"


def _list(values: Iterable[float] | None) -> str:
    return "None" if values is None else _array(values)


def _rust_members(pairs: Iterable[tuple[Quantity, Sequence[float]]], indent: str) -> list[str]:
    return [f"{indent}{q.name}: {_array(values) if q.shape else repr(values[0])}," for q, values in pairs]


def _rust_motion(motion: Mapping[str, Sequence[float]], indent: str) -> str:
    members = _rust_members(((q, list(motion[q.name])) for q in n.MOTION), f"{indent}    ")
    return "\n".join(["Motion {", *members, f"{indent}}}"])


def _rust_robot(numbers: Numbers) -> str:
    lines = ["Robot {", *_rust_members(((q, stored(numbers, q)) for q in n.PLATFORM), "    "), "    leg: ["]
    for i in range(6):
        legs = _rust_members(((q, stored(numbers, q, i)) for q in n.LEG), " " * 12)
        lines += ["        Leg {", *legs, "        },"]
    return "\n".join([*lines, "    ],", "}"])


LANGUAGES: dict[str, Language] = {each.name: each for each in (PythonKit(), MatlabKit(), RustKit())}
"""Languages of kits besides C, by the name that the command line takes."""
