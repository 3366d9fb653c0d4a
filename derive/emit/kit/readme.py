"""``README.md`` of a kit: what every function takes, hands out, costs and how far it may be off.

One of the kit's texts. Takes the parts of a kit with figures that others found; knows no equation.
"""

import math
import re
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ... import notation as n
from ..c import STATUS
from . import licence
from .functions import MODEL, Function, Part
from .words import filled, in_markdown, shape, table


@dataclass(frozen=True)
class Figures:
    """What a README says of one function.

    error, worst: bounds of its ordinary test vectors over the largest answer of the same array, the largest
    of each vector: their median and largest, nan without vectors.
    stack, batch_stack: bytes, None where nobody measured them or there is no batch.
    """

    error: float
    worst: float
    stack: int | None
    batch_stack: int | None


@dataclass(frozen=True)
class Kit:
    """What a README is about.

    name, symbol: the robot's. digest: of its constants. figures: by the functions' stems. options: as the
    command line takes them. precision: "double" or "float". stack_by: with what the stack was measured.
    has_robot: whether stewart_robot.h is among the files. deviations: rule, what it is about, why it is not
    kept.
    unit: file name of an FMI unit, "" without one. changed: the share of itself by which a wrong constant is
    taken to be wrong; hidden: the constants whose change by it no test vector shows, by name; None where
    there are no forces.
    """

    name: str
    symbol: str
    digest: str
    parts: Sequence[Part]
    figures: Mapping[str, Figures]
    options: str
    precision: str
    stack_by: str
    has_robot: bool
    deviations: Sequence[tuple[str, str, str]]
    unit: str
    version: str
    changed: float
    hidden: Sequence[str] | None


def readme(kit: Kit) -> str:
    """The text."""
    functions = [function for part in kit.parts for function in part.functions]
    robot_says = "" if kit.has_robot else "The numbers are in the kernel. "
    values = {
        "title": in_markdown(kit.name),
        "symbol": kit.symbol,
        "options": kit.options,
        "licence": licence.SAYS,
        "version": kit.version,
        "arithmetic": _ARITHMETIC[kit.precision],
        "parts": "\n".join(f"- {part.says}" for part in kit.parts),
        "files": table(_files(kit)),
        "summary": "\n".join(_summary(function, kit.figures[function.stem]) for function in functions),
        "stack_by": kit.stack_by,
        "stack_baked": _STACK_BAKED if any(function.plain for function in functions) else "",
        "functions": "\n".join(
            _function(function, part.files[part.header]) for part in kit.parts for function in part.functions
        ),
        "batches": _BATCHES if any(function.batch for function in functions) else "",
        "prepared": _PREPARED if any(function.subject == MODEL for function in functions) else "",
        "inputs": table((q.name, shape(q), q.unit, q.meaning) for q in n.MOTION),
        "status": table((f"STEWART_{name}", str(code), text) for name, code, text in STATUS),
        "deviations": table(kit.deviations),
        "digest": f"{robot_says}SHA-256 of name and constants: `{kit.digest}`",
        "hidden": _hidden(kit),
        "unit": filled(_UNIT, {"unit": kit.unit}) if kit.unit else "",
    }
    return filled(_README, values)


def _files(kit: Kit) -> list[tuple[str, str]]:
    robot = (
        [
            (
                "stewart_robot.h`, `stewart_robot.c",
                f"this robot's constants, `{kit.symbol}`, and limits, `{kit.symbol}_limits`",
            )
        ]
        if kit.has_robot
        else []
    )
    unit = [(kit.unit, "co-simulation unit, FMI 2.0")] if kit.unit else []
    return [
        ("stewart.h", "types and status codes"),
        *((f"{part.header}`, `{part.source}", _stems(part) or part.says) for part in kit.parts),
        *robot,
        ("test/selftest.c", "calls every function with inputs whose answers were computed at 50 digits"),
        ("example/main.c", "an example: every function once"),
        ("stewart.hpp", "the same functions for C++17"),
        ("CMakeLists.txt`, `Config.cmake.in`, `Makefile", "builds library, self-test and example"),
        ("robot.toml", "the robot file, all defaults and units written out"),
        ("LICENSE", "terms of use: none"),
        ("manifest.json", "options, digests of robot and files, version"),
        *unit,
    ]


def _stems(part: Part) -> str:
    return ", ".join(f"`{function.stem}`" for function in part.functions)


def _summary(function: Function, figures: Figures) -> str:
    stack = "" if figures.stack is None else f"{figures.stack:,}"
    stack += "" if figures.batch_stack is None else f", batch {figures.batch_stack:,}"
    error = (
        "not tested: no pose settles it |"
        if math.isnan(figures.error)
        else f"{figures.error:.0e} | {figures.worst:.0e}"
    )
    return f"| `{function.symbol}` | {function.operations} | {stack} | {error} |"


def _function(function: Function, header: str) -> str:
    signature = function.signature
    return filled(
        _FUNCTION,
        {
            "symbol": function.symbol,
            "prototype": _prototypes(function, header),
            "says": signature.says,
            "reads": "Reads `stewart_motion`, below.\n\n" if signature.motion else "",
            "rows": table(
                (each.name, way, each.dims, each.unit, each.meaning)
                for way, fields in (("in", signature.inputs), ("out", signature.outputs))
                for each in fields
            ),
        },
    )


def _prototypes(function: Function, header: str) -> str:
    found = re.findall(rf"^STEWART_NODISCARD (int {function.symbol}(?:_batch)?\([^;]*\);)", header, re.M)
    assert found, function.symbol
    return "\n".join(found)


def _hidden(kit: Kit) -> str:
    """Which wrong constants the self-test finds by the forces, and which it does not."""
    if kit.hidden is None:
        return ""
    says = f"It fails where a constant of the forces is wrong by {kit.changed:g} of itself"
    if kit.hidden:
        says += (
            ", but for those that no motion was found to show, as rounding errors of other terms are larger: "
            f"{_by_leg(kit.hidden)}"
        )
    return textwrap.fill(f"{says}.", 108, break_long_words=False, break_on_hyphens=False) + "\n"


def _by_leg(names: Sequence[str]) -> str:
    """Constants, those of several legs together: ``C_p of legs 1, 2``."""
    legs: dict[str, list[str]] = {}
    for name in names:
        constant, _, leg = name.partition(" of leg ")
        legs.setdefault(constant, []).append(leg)
    parts = (
        f"`{name}`" + (f" of legs {', '.join(which)}" if which[0] else "") for name, which in legs.items()
    )
    return "; ".join(parts)


_ARITHMETIC = {
    "double": "Arithmetic is `double`; the self-test's bounds are those of `double`.",
    "float": "Arithmetic is `float`; no `double` is in the object code.",
}

_STACK_BAKED = ", with the numbers folded in as much as without"

_BATCHES = """\
Batches take and fill arrays whose first axis is the pose; `F_ext` and `M_ext` may be null, `status` too,
which otherwise takes each pose's own; the first that is not `STEWART_OK` is returned.
"""

_PREPARED = """\
`..._prepare(robot, &model)` makes the constants that a function reads; call it once, and again when a
constant of the robot changes. A model that nobody prepared gives a status if it is all zeros, as a static
one is.

"""

_UNIT = """\
## Simulink and other simulators

`@unit@` is a co-simulation unit, FMI 2.0: import it by the FMU block. Inputs are the fields of
`stewart_motion`, outputs `F` and `status`.

"""

_FUNCTION = """\
### `@symbol@`

@says@

```c
@prototype@
```

@reads@| name | | shape | unit | meaning |
|---|---|---|---|---|
@rows@
"""

_README = """\
# @title@: C kit

@parts@

`*.c` of this folder is the library. C99, also valid C++; no heap, no global state, no input or output;
needs only `sqrt` and `fabs`.
@arithmetic@ Written by stewart-sym @version@; regenerate in this
folder with

    stewart-sym generate robot.toml -o . @options@

or with a robot file of your own, and do not edit: a second run replaces what it wrote, and nothing where a
file was changed by hand.

@licence@ Text: `LICENSE`.

| file | what it is |
|---|---|
@files@

## Build and prove

    make

builds the library, the self-test and the example and runs the self-test; `make stack` prints what stack
your compiler takes. With CMake:

```cmake
add_subdirectory(this_folder)                 # or, after `cmake --install`: find_package(@symbol@)
target_link_libraries(controller PRIVATE @symbol@::@symbol@)
```

On a target: link `test/selftest.c` with the sources of this folder, `-DSTEWART_NO_STDIO` where nothing can be
printed; `main` returns 0 only if every answer is within its bound and every wrong call was refused.
@hidden@With `-DSTEWART_NO_MAIN` there is `stewart_selftest()` to call at start-up.
With `-ffp-contract=off` one pose and a batch agree to the last bit; the bounds hold with fused multiply-add
as well, which saves a fifth of the instructions of a `float` pose on a Cortex-M4F. `-fno-math-errno` lets a
square root be one instruction. `-ffast-math` removes the checks of inputs
and is an error, unless `STEWART_ALLOW_FAST_MATH` is defined.

## Functions

| function | operations of a pose | stack, bytes | error, median | worst |
|---|---|---|---|---|
@summary@

Error: bound of the rounding errors, as the self-test takes it, over the largest number of the same array:
median and worst of its ordinary poses; the self-test has others, far from what a machine does.
Stack: by @stack_by@@stack_baked@; your compiler's: `make stack`.

All return a status and write nothing unless it is `STEWART_OK`; any number of threads may call them at
once. That R is a rotation is not checked. Outputs of one pose may overlap the motion and
other inputs, but not one another, robot or model; those of a batch overlap nothing. @batches@One kit to
a program: kits share names, and a `double` and a `float` one must not be linked together.

@prepared@@functions@
`stewart_motion`, input:

| field | shape | unit | meaning |
|---|---|---|---|
@inputs@

Status:

| name | value | meaning |
|---|---|---|
@status@

Limits of stroke, force and speed are not checked here. Equation numbers are those of Dasgupta and
Mruthyunjaya, Mechanism and Machine Theory 33 (1998) 1135-1152.

@unit@## MISRA C:2012

No recursion, no `goto`, no unbounded loop, no dynamic memory, no conversion that is not written. What
cppcheck's MISRA addon still finds in the kernels:

| rule | what | why it stays |
|---|---|---|
@deviations@

## Robot

@digest@
"""
