"""Stack of every function that a kit may hold, by the cross compiler: the table that kits quote.

Kernels with a machine's numbers folded in are not among them:
they take no more than the same kernels without.
"""

import dataclasses
import re
import tempfile
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from stewart_sym.backend import fidelity, native
from stewart_sym.backend.native import CompilerError
from stewart_sym.io.progress import Progress, silent
from stewart_sym.kit import Choice
from stewart_sym.kit.choice import check
from stewart_sym.kit.files import stack_key
from stewart_sym.kit.parts import Parts, parts
from stewart_sym.robot.robot import Robot
from stewart_sym.studies.microcontroller import toolchain
from stewart_sym.studies.microcontroller.toolchain import CORES, Core


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
            for level in fidelity.available(robot, formulation):
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
    native.ran((toolchain.GCC, *flags, *names, "-lm", "-o", target.name), target.parent)
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
