"""Kit in Python: one module on arrays."""

from collections.abc import Mapping, Sequence

from ...emit.arrays import arithmetic, module
from ..text_format import template
from .contents import Contents, Value, compared
from .language import Language


class PythonKit(Language):
    """Kit that is one module on arrays."""

    name, title = "python", "Python, on arrays of NumPy, JAX, PyTorch and others"
    run = "python self_test.py && python example.py"
    example = "example.py"
    prepare = "model = stewart_arrays.prepare(on, machine)"
    robot = "machine"
    notes = template("python_notes.md").strip()

    def files(self, kit: Contents) -> dict[str, str]:
        tests = []
        for test in kit.tests:
            answers, bounds = ({path: of[i] for path, of in kit.compared(test).items()} for i in (0, 1))
            row = [test.function, kit.subject(test.function), kit.given(test), test.status, answers, bounds]
            tests += ["    [\n", *(f"        {each!r},\n" for each in row), "    ],\n"]
        fill = self.statements(kit, "    {} = {}", "made")
        same = self.statements(kit, "    failed += {} != {}", "machine")
        made = {
            "robot": kit.machine.name.replace("\\", "\\\\").replace('"', '\\"'),
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
            "stewart_arrays.py": module(kit.program, arithmetic(kit.whole_numbers), kit.machine.version),
            "robot.py": self.filled("python_robot.py", kit, **made, numbers=fill),
            "self_test.py": self.filled("python_test.py", kit, **made, same=same, tests="".join(tests)),
            "example.py": self.filled(
                "python_example.py", kit, **made, given=_python_given(kit.examples), calls="\n".join(calls)
            ),
        }

    def call(self, function: str, arguments: Sequence[str]) -> str:
        return f"found = stewart_arrays.{function}({', '.join(['on', *arguments])})"


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
