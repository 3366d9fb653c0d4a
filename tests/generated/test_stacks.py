"""The stack that kits quote is what the cross compiler tells today.

``python tests/generated/test_stacks.py`` measures every function anew and rewrites
``stewart_sym/kit/stack.json``. Its ``PYTHONPATH`` lists ``tests/support``, ``packages``, and ``studies``.
"""

import dataclasses
import json
import re
import tempfile
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import machines
import numpy as np
import pytest
import toolchain
from sweeps import FULL
from toolchain import CORES, Core

from stewart_sym.backend import native
from stewart_sym.backend.kernel import levels
from stewart_sym.backend.native import CompilerError
from stewart_sym.io.output import json_text
from stewart_sym.io.progress import Progress, silent
from stewart_sym.kit import Choice
from stewart_sym.kit.files import stack_key
from stewart_sym.kit.kit_options import check
from stewart_sym.kit.required_kernels import Parts, parts
from stewart_sym.robot.robot import Robot

TABLE = Path(__file__).parents[2] / "stewart_sym" / "kit" / "stack.json"
REWRITE = "run `python tests/generated/test_stacks.py`"


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
            (robot, Choice((*(("motion", "derivatives") if FULL else ()), "kinematics"), precision="float")),
            (robot, Choice(("forces",), **level)),
            (robot, Choice(("forces",), **level, scalar=True, precision="float")),
        ]
    )
    assert set(committed["bytes"]) >= set(today["bytes"]), REWRITE
    if committed["by"] == today["by"]:
        assert committed["bytes"] | today["bytes"] == committed["bytes"], REWRITE


@pytest.mark.slow
def test_every_function_of_a_kit_has_a_stack_in_the_table() -> None:
    table = json.loads(TABLE.read_text(encoding="utf-8"))["bytes"]
    for robot in robots()[:: 1 if FULL else 3]:
        closed = ("motion", "derivatives") if robot.base_joint == "universal" else ()
        # Levels and constants folded in are of the forces alone.
        torque = () if robot.drive is None else ("torque",)
        choices = [Choice((*closed, "reactions", "kinematics", *torque))]
        choices += [
            Choice(("forces",), "exact", level) for level in list(levels(robot))[: None if FULL else 1]
        ]
        choices.append(Choice(bake=True))
        for choice in choices:
            for function in parts(robot, choice).functions:
                assert stack_key(function, choice) in table


def stacks(wishes: Iterable[tuple[Robot, Choice]], progress: Progress = silent) -> dict[str, Any]:
    """Bytes by function and precision, and the compiler that they are of.

    wishes: robots, whose numbers do not count, and what their kits hold. Raises CompilerError where a tool is
    missing or fails.
    """
    if said := toolchain.missing():
        raise CompilerError(said)
    found: dict[str, int] = {}
    for robot, choice in wishes:
        check(choice, robot)
        for name, size in _measured(CORES[choice.precision], parts(robot, choice), choice, found).items():
            progress(name)
            found[name] = size
    compiler = _compiler()
    cores = " and ".join(f"{core.name} ({precision})" for precision, core in CORES.items())
    flags = " ".join(flag for flag in toolchain.FLAGS if flag.startswith(("-O", "-f")))
    return {"by": f"{compiler}, {flags}, {cores}", "bytes": dict(sorted(found.items()))}


def every_choice(robots: Iterable[Robot]) -> Iterator[tuple[Robot, Choice]]:
    """Choices that together hold every function for machines of each kind."""
    for robot in robots:
        for formulation in ("exact",) if robot.has_rotors else ("exact", "paper"):
            functions = ["reactions", "kinematics", *([] if robot.drive is None else ["torque"])]
            if (robot.base_joint, formulation) == ("universal", "exact"):
                functions += ["motion", "derivatives"]
            asked = [Choice(tuple(functions), formulation)]
            for level in levels(robot, formulation):
                asked += [Choice(("forces",), formulation, level, scalar=scalar) for scalar in (False, True)]
            for choice in asked:
                for precision in CORES:
                    yield robot, dataclasses.replace(choice, precision=precision)


def _compiler() -> str:
    """Name and version of the compiler."""
    said = toolchain.versions()[toolchain.GCC]
    found = re.search(r"\b\d+\.\d+\.\d+\b", said)
    return f"{toolchain.GCC} {found[0]}" if found else said


def _joined(core: Core, objects: Iterable[Path], target: Path) -> Path:
    """All of some objects with their calls of each other resolved; not to be run."""
    flags = (*core.flags, *toolchain.FLAGS, "-nostartfiles", "--specs=nosys.specs", "-Wl,-e,0")
    names = (path.name for path in objects)
    native.run_compiler((toolchain.GCC, *flags, *names, "-lm", "-o", target.name), target.parent)
    return target


def _measured(core: Core, made: Parts, choice: Choice, known: dict[str, int]) -> dict[str, int]:
    names = {function: stack_key(function, choice) for function in made.functions}
    if set(names.values()) <= set(known):
        return {}
    found = {}
    with tempfile.TemporaryDirectory(prefix="stewart-sym-") as folder:
        for name, text in made.files.items():
            (Path(folder) / name).write_text(text, encoding="utf-8")
        define = ["-DSTEWART_FLOAT"] if choice.precision == "float" else []
        objects = [toolchain.compiled(core, Path(folder) / part.source, define) for part in made.parts]
        image = _joined(core, objects, Path(folder) / "kit.elf")
        usage = [path.with_suffix(".su") for path in objects]
        for function in made.functions:
            for suffix in ("", "_batch") if function.batch else ("",):
                symbol = f"{function.symbol}{suffix}"
                size = toolchain.deepest_stack(image, usage, symbol)
                found[names[function].replace(function.symbol, symbol)] = size
    return found


if __name__ == "__main__":
    TABLE.write_text(json_text(stacks(every_choice(robots()), print)), encoding="utf-8")
