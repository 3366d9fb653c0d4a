"""README of a kit: inputs, outputs, operations, stack, and tolerances of each function."""

import math
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ..mechanics import quantities as n
from ..print.c import wrapped
from ..trace.constants import STATUSES
from . import kit_license
from .forces_name import FORCES_HEADER
from .functions import DRIVES, MODEL, Function, Part, reads_robot
from .misra_deviations import deviations
from .robot_source import Machine
from .text_format import in_markdown, table, template


@dataclass(frozen=True)
class Figures:
    """Measured figures of one function for a README.

    Attributes
    ----------
    error, worst : float
        Median and largest relative tolerance of the ordinary test vectors. The tolerance of a vector is
        its largest tolerance divided by the largest answer in the same array; nan without vectors.
    stack, batch_stack : int, optional
        Stack (bytes); None if not measured, or without a batch.
    """

    error: float
    worst: float
    stack: int | None
    batch_stack: int | None


@dataclass(frozen=True)
class Kit:
    """Contents of a README.

    Attributes
    ----------
    machine : Machine
        Robot.
    parts : sequence of Part
        Parts of the kit.
    figures : mapping
        Figures by the stems of the functions.
    options : str
        Command-line options.
    precision : str
        "double" or "float".
    stack_by : str
        Compiler and options of the stack measurement.
    unit : str
        File name of an FMI unit; empty without one.
    """

    machine: Machine
    parts: Sequence[Part]
    figures: Mapping[str, Figures]
    options: str
    precision: str
    stack_by: str
    unit: str

    @property
    def functions(self) -> list[Function]:
        """Functions of all parts."""
        return [function for part in self.parts for function in part.functions]

    @property
    def has_robot(self) -> bool:
        """True if the kit contains stewart_robot.h."""
        return reads_robot(self.functions)


def readme(kit: Kit) -> str:
    """Return the text of the README."""
    functions = kit.functions
    kinds = {kind for part in kit.parts for kind in part.kinds} | ({"robot"} if kit.has_robot else set())
    robot_says = "" if kit.has_robot else "The constants are in the kernel. "
    values = {
        "title": in_markdown(kit.machine.name),
        "symbol": kit.machine.symbol,
        "options": kit.options,
        "license": kit_license.NOTICE,
        "version": kit.machine.version,
        "arithmetic": _ARITHMETIC[kit.precision],
        "parts": "\n".join(f"- {part.says}" for part in kit.parts),
        "files": table(_files(kit)),
        "summary": "\n".join(_summary(function, kit.figures[function.stem]) for function in functions),
        "stack_by": kit.stack_by,
        "stack_baked": _STACK_BAKED if any(function.plain for function in functions) else "",
        "functions": "\n".join(map(_function, functions)),
        "batches": template("kit/readme_batches.md") if any(function.batch for function in functions) else "",
        "one_name": _ONE_NAME if any(each.stem == "forces" for each in functions) else "",
        "prepared": template("kit/readme_prepared.md")
        if any(function.subject == MODEL for function in functions)
        else "",
        "inputs": table((q.name, f"[{len(q.keys)}]", q.unit, q.meaning) for q in n.MOTION),
        "status": table((f"STEWART_{name}", str(code), text) for name, code, text in STATUSES),
        "deviations": table((each.rule, each.what, each.reason) for each in deviations(kinds)),
        "digest": f"{robot_says}SHA-256 of name and constants: `{kit.machine.digest}`",
        "detected": _detected(kit),
        "unit": template("kit/readme_unit.md", {"unit": kit.unit}) if kit.unit else "",
    }
    return template("kit/README.md", values)


def _files(kit: Kit) -> list[tuple[str, str]]:
    symbol = kit.machine.symbol
    robot = (
        [
            (
                "stewart_robot.h`, `stewart_robot.c",
                f"constants `{symbol}` and limits `{symbol}_limits` of this robot{_drives(kit)}",
            )
        ]
        if kit.has_robot
        else []
    )
    shared = dict.fromkeys(name for part in kit.parts for name in part.shared)
    unit = [(kit.unit, "co-simulation unit, FMI 2.0")] if kit.unit else []
    named = "`stewart_kit_forces`: one name for the forces, with and without `--bake`"
    one_name = [(FORCES_HEADER, named)] if any(each.stem == "forces" for each in kit.functions) else []
    return [
        ("stewart.h", "types and status codes"),
        ("`, `".join(shared), "arithmetic and functions that the sources share; do not include them"),
        *((f"{part.header}`, `{part.source}", _stems(part) or part.says) for part in kit.parts),
        *one_name,
        *robot,
        ("test/selftest.c", "compares every function with answers that were computed with 50 digits"),
        ("example/main.c", "example that calls every function once"),
        ("stewart.hpp", "the same functions for C++17"),
        (
            "CMakeLists.txt`, `Config.cmake.in`, `Makefile",
            "build the library, the self-test, and the example",
        ),
        ("robot.toml", "robot file with all defaults and units"),
        ("LICENSE", "license: any use, without conditions (0BSD)"),
        ("manifest.json", "options, version, and digests of the robot and the files"),
        *unit,
    ]


def _drives(kit: Kit) -> str:
    """Describe the constants of the drives in a kit with torques."""
    of_drives = any(function.subject == DRIVES for function in kit.functions)
    return f", and constants `{kit.machine.symbol}_drives` of its drives" if of_drives else ""


def _stems(part: Part) -> str:
    return ", ".join(f"`{function.stem}`" for function in part.functions)


def _summary(function: Function, figures: Figures) -> str:
    stack = "" if figures.stack is None else f"{figures.stack:,}"
    stack += "" if figures.batch_stack is None else f", batch {figures.batch_stack:,}"
    error = (
        "not tested: no pose determines it |"
        if math.isnan(figures.error)
        else f"{figures.error:.0e} | {figures.worst:.0e}"
    )
    return f"| `{function.symbol}` | {function.operations} | {stack} | {error} |"


def _function(function: Function) -> str:
    call = function.call
    return template(
        "kit/readme_function.md",
        {
            "symbol": function.symbol,
            "prototype": "\n".join(line for each in function.prototypes for line in wrapped(each)),
            "says": call.says,
            "reads": "Reads `stewart_motion`, below.\n\n" if call.motion else "",
            "rows": table(
                (each.name, way, each.dims, each.unit, each.meaning)
                for way, fields in (("in", call.inputs), ("out", call.outputs))
                for each in fields
            ),
        },
    )


def _detected(kit: Kit) -> str:
    """Describe the changed constants that the self-test detects."""
    says = []
    if kit.has_robot:
        says.append(
            "The self-test compares every number of `stewart_robot.c`, including limits, with the generated "
            "number, to the bit."
        )
    if any(function.plain for function in kit.functions):
        says.append(
            "The self-test detects a relative change of 0.001 of most baked constants. Rounding errors hide "
            "changes of constants with little effect on the forces."
        )
    return textwrap.fill(" ".join(says), 108, break_long_words=False, break_on_hyphens=False) + "\n"


_ARITHMETIC = {
    "double": "The arithmetic is `double`, and so are the tolerances of the self-test.",
    "float": "The arithmetic is `float`; the object code contains no `double`.",
}

_ONE_NAME = """`stewart_kit.h` gives the forces one name in every kit, with or without `--bake`. A program
that calls `stewart_kit_prepare(&model)` once and `stewart_kit_forces(&model, &motion, F)` for each pose
compiles with both kits. `model` is a `stewart_kit_model`, which is empty in a kit with `--bake`.

"""
_STACK_BAKED = ", the same with and without baked constants"
