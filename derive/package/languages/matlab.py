"""Kit in MATLAB: a package of functions."""

from collections.abc import Mapping, Sequence

from ...print.matlab import Matlab
from ...trace.constants import constants
from ...trace.decided_selections import of_one_pose
from ..functions import Vector
from ..text_format import template
from .contents import Contents, Value
from .language import Language, array, spoilt


class MatlabKit(Language):
    """Kit that is a package of functions."""

    name, title = "matlab", "MATLAB and Octave"
    run = 'octave-cli --eval "assert(self_test() == 0)" && octave-cli one_pose.m'
    example = "one_pose.m"
    prepare = "model = stewart.prepare(stewart.robot());"
    robot = "stewart.robot()"
    legs = tuple(f"leg({i})" for i in range(1, 7))
    notes = template("matlab_notes.md").strip()

    def files(self, kit: Contents) -> dict[str, str]:
        tests = "\n".join(line for test in kit.tests for line in self._test(kit, test))
        calls = "\n".join(self.calls(kit).values())
        fill = self.statements(kit, "    {} = {};", "made")
        same = self.statements(kit, "    failed = failed + ~isequal({}, {});", "robot")
        made = {f"+stewart/{name}": text for name, text in Matlab(of_one_pose(kit.program)).files().items()}
        statuses = [f"    made.{name} = {code}; % {says}" for name, (code, says) in kit.whole_numbers.items()]
        numbers = [f"    made.{name} = {value!r};" for name, value in constants("double").items()]
        words = {"statuses": "\n".join(statuses), "constants": "\n".join(numbers)}
        helpers = ["where", "larger", "constants", "numbers", "motion_of"]
        helpers += ["pose_at"] if any(each.name == "Pose" for each in kit.program.structures) else []
        for name in helpers:
            made[f"+stewart/{name}.m"] = self.filled(f"matlab_{name}.m", kit, **words)
        prepare = self.prepare if kit.prepared else ""
        return {
            **made,
            "+stewart/robot.m": self.filled("matlab_robot.m", kit, numbers=fill),
            "self_test.m": self.filled("matlab_test.m", kit, same=same, prepare=prepare, tests=tests),
            self.example: self.filled(
                "matlab_example.m",
                kit,
                prepare=prepare,
                given="\n".join(_matlab_given(kit.examples, "")),
                calls=calls,
            ),
        }

    def _test(self, kit: Contents, test: Vector) -> list[str]:
        given = kit.given(test)
        subject = {"robot": "stewart.robot()"}.get(kit.subject(test.function), "model")
        lines = [
            *_matlab_given(given, "    "),
            f"    {self.call(test.function, [subject, *given])};",
            f"    failed = failed + (found.status ~= {test.status});",
        ]
        for name, (answer, bound) in kit.compared(test).items():
            lines.append(f"    failed = failed + close(found.{name}, {array(answer)}, {array(bound)});")
        for name, place, arguments in spoilt(kit, test, given):
            lines += [
                f"    wrong = {name};",
                f"    {place}(1) = NaN;",
                f"    {self.call(test.function, [subject, *arguments])};",
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
            lines += [f"{indent}{name}.{key} = {array(numbers)};" for key, numbers in value.items()]
        else:
            lines.append(f"{indent}{name} = {array(value)};")
    return lines
