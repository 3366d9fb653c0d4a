"""The stack that kits quote is what the cross compiler tells today.

``PYTHONPATH=tests/support:tests/support/packages python tests/generated/test_stacks.py`` measures every
function anew and rewrites ``stewart_sym/kit/stack.json``.
"""

import json
from pathlib import Path

import machines
import numpy as np
import pytest
from cortex_stacks import every_choice, stacks
from kits import kit_of

from stewart_sym.backend import fidelity
from stewart_sym.io.json_text import json_text
from stewart_sym.kit import Choice
from stewart_sym.kit.files import stack_key
from stewart_sym.kit.parts import parts
from stewart_sym.robot.robot import Robot
from stewart_sym.studies.microcontroller import toolchain

TABLE = Path(__file__).parents[2] / "stewart_sym" / "kit" / "stack.json"
REWRITE = "run `PYTHONPATH=tests/support:tests/support/packages python tests/generated/test_stacks.py`"


def robots() -> list[Robot]:
    rng = np.random.default_rng(1)
    plain = [machines.random_robot(rng, joint) for joint in ("universal", "spherical")]
    return [*plain, *(machines.with_random_drives(rng, robot) for robot in plain)]


@pytest.mark.slow
@pytest.mark.skipif(bool(toolchain.missing()), reason=toolchain.missing() or "all tools are there")
def test_the_table_is_what_the_compiler_tells() -> None:
    committed = json.loads(TABLE.read_text(encoding="utf-8"))
    robot = robots()[0]
    level = {"fidelity": "massless_static"}
    today = stacks(
        [
            (robot, Choice(("motion", "derivatives", "kinematics"), precision="float")),
            (robot, Choice(("forces",), **level)),
            (robot, Choice(("forces",), **level, scalar=True, precision="float")),
        ]
    )
    assert set(committed["bytes"]) >= set(today["bytes"]), REWRITE
    if committed["by"] == today["by"]:
        assert committed["bytes"] | today["bytes"] == committed["bytes"], REWRITE


@pytest.mark.parametrize("every", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_every_function_of_a_kit_has_a_stack_in_the_table(every: bool) -> None:
    table = json.loads(TABLE.read_text(encoding="utf-8"))["bytes"]
    for robot in robots()[:: 1 if every else 3]:
        closed = ("motion", "derivatives") if robot.base_joint == "universal" else ()
        # Levels and constants folded in are of the forces alone.
        torque = () if robot.drive is None else ("torque",)
        choices = [Choice((*closed, "reactions", "kinematics", *torque))]
        choices += [
            Choice(("forces",), "exact", level) for level in fidelity.available(robot)[: None if every else 1]
        ]
        choices.append(Choice(bake=True))
        for choice in choices:
            for function in parts(robot, choice).functions:
                assert stack_key(function, choice) in table


def test_readme_of_a_kit_quotes_it() -> None:
    table = json.loads(TABLE.read_text(encoding="utf-8"))
    made = kit_of(choice=Choice(scalar=True))
    text = made.files["README.md"].decode()
    size = table["bytes"]["stewart_exact_pose_forces double"]
    assert f"| `stewart_exact_pose_forces` | {made.operations:,} | {size:,} |" in text
    assert table["by"] in " ".join(text.split())


if __name__ == "__main__":
    TABLE.write_text(json_text(stacks(every_choice(robots()), print)), encoding="utf-8")
