"""The C kit of one robot: its constants as C source, an example that checks itself, and a README.

Takes plain numbers and hands back text; the kernel's own files are put beside it by whoever writes them.
Knows the layout of stewart.h from the notation, and nothing of files or of how the sample was computed.
"""

import hashlib
import math
import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .. import notation as n
from ..block import Quantity
from .c import FORCES, REACTIONS, STATUS

Numbers = Mapping[str, Any]
"""Quantity name -> number or nested lists of numbers."""


@dataclass(frozen=True)
class Sample:
    """One motion and the forces it takes, against which the example checks the compiled kernel.

    motion: fields of ``stewart_motion``, R as (3, 3), the rest (3,). F: actuator forces, N, six.
    tolerance: how far a force may be off for each rounding unit of the arithmetic, N.
    """

    motion: Numbers
    F: Sequence[float]
    tolerance: float


@dataclass(frozen=True)
class Target:
    """Which kernel a kit is built around.

    kernel: as in ``stewart_<kernel>.h``, or ``stewart_<kernel>_forces.h`` where forces_alone, or
    ``stewart_<kernel>_pose.h`` where scalar: one pose, its legs one after the other, with functions and types
    ``stewart_<kernel>_pose_...``. baked: the robot's numbers are in the kernel. precision: "double" or
    "float". says: lines of the README about it.
    """

    kernel: str
    forces_alone: bool = False
    baked: bool = False
    scalar: bool = False
    precision: str = "double"
    says: str = ""

    @property
    def file(self) -> str:
        """Name of the kernel's files, without the ending."""
        suffix = "_pose" if self.scalar else "_forces" if self.forces_alone else ""
        return f"stewart_{self.kernel}{suffix}"

    @property
    def sources(self) -> str:
        """What is compiled beside the example."""
        return f"{self.file}.c" if self.baked else f"robot.c {self.file}.c"


def kit(name: str, target: Target, robot: Numbers, sample: Sample, version: str) -> dict[str, str]:
    """``robot.h``, ``robot.c``, unless baked, ``example.c`` and ``README.md``: file name -> text.

    name: the robot's. robot: fields of ``stewart_robot``, those of the legs with six rows, inertias (3, 3).
    version: of the generator.

    Raises ValueError naming the field that is missing, has another shape or is not finite.
    """
    symbol = robot_symbol(name)
    constants = _robot_initialiser(robot)
    values = {
        **_target_texts(target, symbol),
        "name": _in_comment(name),
        "title": re.sub(r"([\\`*_{}\[\]<>#|&])", r"\\\1", name),
        "kernel": target.kernel,
        "symbol": symbol,
        "guard": f"{symbol.upper()}_H",
        "version": version,
        "digest": hashlib.sha256(f"{name}\n{constants}".encode()).hexdigest(),
        "robot": constants,
        "motion": "\n".join(_member(q, _stored(sample.motion, q, "motion"), "    ") for q in n.MOTION),
        "expected": _braces([_literal(F, "F") for F in sample.F], "    "),
        "tolerance": _literal(sample.tolerance, "tolerance"),
        "inputs": _table((q.name, _shape(q), q.unit, q.meaning) for q in n.MOTION),
        "forces": _table((q.name, dims, q.unit, q.meaning) for q, dims in FORCES),
        "reactions": _table((q.name, f"[6]{_shape(q)}", q.unit, q.meaning) for q in REACTIONS),
        "robot_says": _ROBOT_SAYS[target.baked],
        "status": _table((f"STEWART_{code_name}", str(code), text) for code_name, code, text in STATUS),
    }
    for nested in ("files", "outputs", "robot_says", "says"):
        values[nested] = _fill(values[nested], values)
    own = {} if target.baked else {"robot.h": _ROBOT_H, "robot.c": _ROBOT_C}
    templates = own | {"example.c": _EXAMPLE, "README.md": _README}
    return {file: _fill(text, values) for file, text in templates.items()}


def float_by_default(stewart_h: str) -> str:
    """``stewart.h`` of a kit in float: without another choice, STEWART_FLOAT is defined."""
    mark = "#if defined(STEWART_REAL)\ntypedef"
    assert mark in stewart_h
    return stewart_h.replace(mark, f"{_FLOAT_BY_DEFAULT}{mark}")


def _target_texts(target: Target, symbol: str) -> dict[str, str]:
    """What differs between kits of whole kernels, of forces alone and of baked ones."""
    kernel = f"{target.kernel}_pose" if target.scalar else target.kernel
    call = f"stewart_{kernel}"
    if target.baked:
        declared, made = "stewart_real F[6];", ""
        called = f"{call}_forces(&motion, F)"
    elif target.forces_alone:
        declared = f"static {call}_model model;\n    stewart_real F[6];"
        made = f"{call}_prepare(&{symbol}, &model)"
        called = f"{call}_forces(&model, &motion, F)"
    else:
        declared, made = "stewart_forces forces;\n    const stewart_real *const F = forces.F;", ""
        called = f"{call}_inverse_dynamics(&{symbol}, &motion, &forces)"
    if made:
        called = f"{made};\n    if (status == STEWART_OK) {{\n        status = {called};\n    }}"
    else:
        called += ";"
    rows = _FUNCTIONS["baked" if target.baked else "forces" if target.forces_alone else "whole"]
    if target.scalar:
        rows = tuple(row for row in rows if not row[0].endswith("_batch"))
    return {
        "file": target.file,
        "sources": target.sources,
        "include": "" if target.baked else '#include "robot.h"\n',
        "declared": declared,
        "called": called,
        "says": target.says,
        "files": _table([row for row in _FILES if not (target.baked and row[0].startswith("robot"))]),
        "functions": _fill(_table(rows), {"kernel": kernel}),
        "outputs": "" if target.forces_alone else _OUTPUTS,
        "arithmetic": _ARITHMETIC[target.precision],
    }


def robot_symbol(name: str) -> str:
    """C identifier of a robot: ``stewart_robot_`` and the ASCII letters and digits of its name.

    Accents are dropped; a name without any such letter or digit gives way to its digest.
    """
    plain = unicodedata.normalize("NFKD", name.casefold())
    letters = "".join(char for char in plain if not unicodedata.combining(char))
    words = re.findall(r"[a-z0-9]+", letters)
    return f"stewart_robot_{'_'.join(words) or hashlib.sha256(name.encode()).hexdigest()[:12]}"


def _fill(template: str, values: Mapping[str, str]) -> str:
    # One pass, so that an @ in a robot's name stays what it is.
    return re.sub(r"@(\w+)@", lambda match: values[match[1]], template)


def _in_comment(name: str) -> str:
    return name.replace("*/", "* /").replace("/*", "/ *")


def _robot_initialiser(robot: Numbers) -> str:
    legs = [
        "\n".join(
            [
                f"        {{ /* leg {i + 1} */",
                *(_member(q, _stored(robot, q, "robot", i), " " * 12) for q in n.LEG),
                "        },",
            ]
        )
        for i in range(6)
    ]
    platform = [_member(q, _stored(robot, q, "robot"), "    ") for q in n.PLATFORM]
    return "\n".join(["    {", *legs, "    },", *platform])


def _stored(numbers: Numbers, quantity: Quantity, owner: str, leg: int | None = None) -> list[str]:
    """Literals of the components that stewart.h stores, in its order."""
    where = f"{owner}: {quantity.name}"
    if quantity.name not in numbers:
        raise ValueError(f"{where}: missing")
    prefix = () if leg is None else (leg,)
    return [
        _literal(_component(numbers[quantity.name], (*prefix, *key), where), where) for key in quantity.keys
    ]


def _component(value: Any, key: Sequence[int], where: str) -> Any:
    try:
        for i in key:
            value = value[i]
    except (IndexError, TypeError):
        raise ValueError(f"{where}: expected an entry {list(key)}") from None
    return value


def _literal(number: Any, where: str) -> str:
    """A number to all its digits, in the arithmetic of the kernel: no double is left in a float build."""
    if isinstance(number, bool) or not isinstance(number, int | float) or not math.isfinite(number):
        raise ValueError(f"{where}: expected finite numbers, got {number!r}")
    return f"REAL({float(number)!r})"


def _member(quantity: Quantity, literals: Sequence[str], indent: str) -> str:
    order = ", order xx xy xz yy yz zz" if quantity.symmetric else ""
    value = _braces(literals, indent) if quantity.shape else literals[0]
    return f"{indent}/* {quantity.name}, {quantity.unit}: {quantity.meaning}{order} */\n{indent}{value},"


def _braces(literals: Sequence[str], indent: str) -> str:
    """A braced list, three numbers on a line."""
    rows = [", ".join(literals[i : i + 3]) for i in range(0, len(literals), 3)]
    return "{" + f",\n{indent} ".join(rows) + "}"


def _shape(quantity: Quantity) -> str:
    return f"[{len(quantity.keys)}]" if quantity.shape else ""


def _table(rows: Iterable[Sequence[str]]) -> str:
    """Rows of a Markdown table; the first cell is code."""
    return "\n".join(f"| `{first}` | {' | '.join(rest)} |" for first, *rest in rows)


_ROBOT_H = """\
/* robot.h: the constants of "@name@".
 *
 * Written by stewart-sym @version@; do not edit.
 */
#ifndef @guard@
#define @guard@

#include "stewart.h"

#ifdef __cplusplus
extern "C" {
#endif

/* To be handed to the functions of @file@.h. */
extern const stewart_robot @symbol@;

#ifdef __cplusplus
}
#endif

#endif
"""

_ROBOT_C = """\
/* robot.c: the constants of "@name@".
 *
 * Written by stewart-sym @version@; do not edit.
 *
 * SHA-256 of name and constants:
 * @digest@
 */
#include "robot.h"

#define REAL(value) ((stewart_real)(value))

const stewart_robot @symbol@ = {
@robot@
};
"""

_EXAMPLE = """\
/* example.c: inverse dynamics of "@name@" at one pose, checked.
 *
 *     gcc -std=c99 -O2 -o example example.c @sources@ -lm && ./example
 *
 * Prints the six actuator forces beside those computed when the kit was generated. Returns 0 if they agree
 * to rounding.
 *
 * Written by stewart-sym @version@; do not edit.
 */
#include <float.h>
#include <stdio.h>

@include@#include "@file@.h"

#define REAL(value) ((stewart_real)(value))

#if !defined(STEWART_REAL)
#if defined(STEWART_FLOAT)
#define STEWART_EPSILON FLT_EPSILON
#else
#define STEWART_EPSILON DBL_EPSILON
#endif
#endif

static const stewart_motion motion = {
@motion@
};

/* N */
static const stewart_real expected[6] =
    @expected@;

/* N: grows with the condition number of H and with the forces within the legs */
static const stewart_real tolerance = @tolerance@ * STEWART_EPSILON;

int main(void)
{
    @declared@
    int leg, wrong = 0;
    int status = @called@
    if (status != STEWART_OK) {
        printf("status %d, see stewart.h\\n", status);
        return 1;
    }
    for (leg = 0; leg < 6; ++leg) {
        const stewart_real error = F[leg] - expected[leg];
        /* This way round a NaN is wrong. */
        const int good = error <= tolerance && -error <= tolerance;
        printf("leg %d: %.9g N, expected %.9g N%s\\n", leg + 1, (double)F[leg], (double)expected[leg],
            good ? "" : ": WRONG");
        wrong += !good;
    }
    printf("%d of 6 forces agree to %.1e N\\n", 6 - wrong, (double)tolerance);
    return wrong ? 1 : 0;
}
"""

_FLOAT_BY_DEFAULT = """\
/* This kit is for float; define STEWART_DOUBLE for double. */
#if !defined(STEWART_DOUBLE) && !defined(STEWART_FLOAT)
#define STEWART_FLOAT
#endif
"""

_ARITHMETIC = {
    "double": "Arithmetic is `double`; with `-DSTEWART_FLOAT`, given to every file, it is `float`.",
    "float": "Arithmetic is `float`; with `-DSTEWART_DOUBLE`, given to every file, it is `double`.",
}

_FILES = (
    ("stewart.h", "types and status codes"),
    ("@file@.h`, `@file@.c", "the kernel; operation counts"),
    ("robot.h`, `robot.c", "this robot's constants, `@symbol@`"),
    ("example.c", "one pose, checked against the forces computed at generation"),
)

_FUNCTIONS = {
    "whole": (
        ("stewart_@kernel@_inverse_dynamics", "robot, motion", "forces"),
        ("stewart_@kernel@_joint_reactions", "robot, motion, bearing (m, may be null)", "forces, reactions"),
        ("stewart_@kernel@_inverse_dynamics_batch", "robot, count, motions", "forces, status of each pose"),
        (
            "stewart_@kernel@_joint_reactions_batch",
            "robot, count, motions, bearing",
            "reactions, status of each pose",
        ),
    ),
    "forces": (
        ("stewart_@kernel@_prepare", "robot", "model: its constants, prepared once"),
        ("stewart_@kernel@_forces", "model, motion", "forces F[6], N"),
        ("stewart_@kernel@_forces_batch", "model, count, motions", "forces and status of each pose"),
    ),
    "baked": (
        ("stewart_@kernel@_forces", "motion", "forces F[6], N"),
        ("stewart_@kernel@_forces_batch", "count, motions", "forces and status of each pose"),
    ),
}

_OUTPUTS = """\
`stewart_forces`, output:

| field | shape | unit | meaning |
|---|---|---|---|
@forces@

`stewart_reactions`, output:

| field | shape | unit | meaning |
|---|---|---|---|
@reactions@

"""

_ROBOT_SAYS = {
    False: "SHA-256 of name and constants: `@digest@`",
    True: "The numbers are in the kernel. SHA-256 of name and constants: `@digest@`",
}

_README = """\
# @title@: C kernel

@says@

C99, also valid C++; no heap, no global state, no I/O; needs only `sqrt` and `fabs`. Written by stewart-sym
@version@; regenerate with `stewart-sym generate`, do not edit.

| file | what it is |
|---|---|
@files@

## Build

    gcc -std=c99 -O2 -o example example.c @sources@ -lm && ./example

The example returns 0 if the six forces are right. @arithmetic@

## Functions

| function | input | output |
|---|---|---|
@functions@

All return a status. Any number of threads may call them at once. The batches take and fill arrays whose first
axis is the pose.

`stewart_motion`, input:

| field | shape | unit | meaning |
|---|---|---|---|
@inputs@

@outputs@Status; other than 0, the outputs of that pose are left as they were:

| name | value | meaning |
|---|---|---|
@status@

Limits of stroke, force and speed are not checked here. Equation numbers are those of Dasgupta and
Mruthyunjaya, Mechanism and Machine Theory 33 (1998) 1135-1152.

## Robot

@robot_says@
"""
