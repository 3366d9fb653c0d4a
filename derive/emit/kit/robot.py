"""``stewart_robot.h`` and ``.c``, the constants and limits of one machine as C source, and its robot file.

One of the kit's texts; takes the numbers of ``stewart_robot`` by name.
"""

import hashlib
import json
import math
from collections.abc import Mapping, Sequence
from typing import Any

from ... import notation as n
from .words import EPSILON, Numbers, braces, filled, in_comment, literal, member, robot_symbol, stored

HEADER, SOURCE = "stewart_robot.h", "stewart_robot.c"
"""File names of the constants: not the commonplace robot.h."""

_LIMITS = {"shortest": "m", "longest": "m", "force": "N", "speed": "m/s"}
"""Members of ``stewart_limits`` and their units."""


def robot_files(
    name: str, robot: Numbers, limits: Mapping[str, Sequence[float]], version: str
) -> dict[str, str]:
    """``stewart_robot.h`` and ``stewart_robot.c``: file name -> text.

    robot: fields of ``stewart_robot``, those of the legs with six rows, inertias (3, 3). limits: members of
    ``stewart_limits``, six numbers each, infinite where there is none. Raises ValueError naming the field
    that is missing, has another shape or is not finite.
    """
    symbol = robot_symbol(name)
    values = {
        "name": in_comment(name),
        "symbol": symbol,
        "guard": f"{symbol.upper()}_H",
        "version": version,
        "digest": robot_digest(name, robot),
        "robot": _initialiser(robot),
        "epsilon": EPSILON,
        "limits": "\n".join(_limit(member, limits[member]) for member in _LIMITS),
    }
    return {HEADER: filled(_HEADER, values), SOURCE: filled(_SOURCE, values)}


def _limit(member: str, limits: Sequence[float]) -> str:
    numbers = ["STEWART_MAX" if math.isinf(limit) else literal(limit, member) for limit in limits]
    return f"    /* {member}, {_LIMITS[member]} */\n    {braces(numbers, '    ')},"


def robot_digest(name: str, robot: Numbers) -> str:
    """SHA-256 of name and constants, as hexadecimal digits; raises as ``robot_files``."""
    return hashlib.sha256(f"{name}\n{_initialiser(robot)}".encode()).hexdigest()


def _initialiser(robot: Numbers) -> str:
    legs = [
        "\n".join(
            [
                f"        {{ /* leg {i + 1} */",
                *(member(q, stored(robot, q, "robot", i), " " * 12) for q in n.LEG),
                "        },",
            ]
        )
        for i in range(6)
    ]
    platform = [member(q, stored(robot, q, "robot"), "    ") for q in n.PLATFORM]
    return "\n".join(["    {", *legs, "    },", *platform])


_HEADER = """\
/* stewart_robot.h: the constants of "@name@".
 *
 * Written by stewart-sym @version@; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#ifndef @guard@
#define @guard@

#include "stewart.h"

#ifdef __cplusplus
extern "C" {
#endif

/* To be handed to the functions of the kit. */
extern const stewart_robot @symbol@;

/* Limits of the robot file, which no function checks. */
extern const stewart_limits @symbol@_limits;

#ifdef __cplusplus
}
#endif

#endif
"""

_SOURCE = """\
/* stewart_robot.c: the constants of "@name@".
 *
 * Written by stewart-sym @version@; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * SHA-256 of name and constants:
 * @digest@
 */
#include <float.h>

#include "stewart_robot.h"

@epsilon@
const stewart_robot @symbol@ = {
@robot@
};

const stewart_limits @symbol@_limits = {
@limits@
};
"""

_TOML = """\
# robot.toml: the robot file of this kit, SI units, all defaults and units written out.
#
#     stewart-sym generate robot.toml -o . @options@
#
# SPDX-License-Identifier: 0BSD
"""


def robot_toml(tables: Mapping[str, Any], options: str) -> str:
    """The kit's copy of the robot file, of the tables of a robot file: the same robot to the bit."""
    head = filled(_TOML, {"options": options})
    return head + "\n".join(_table(tables, "")) + "\n"


def _table(table: Mapping[str, Any], path: str) -> list[str]:
    """Lines of a table: plain values first, then the tables in it."""
    nested = {key: value for key, value in table.items() if isinstance(value, Mapping)}
    lists = {
        key: value
        for key, value in table.items()
        if isinstance(value, list) and isinstance(value[0], Mapping)
    }
    lines = [
        f"{key} = {json.dumps(value, ensure_ascii=False)}"
        for key, value in table.items()
        if key not in nested and key not in lists
    ]
    for key, value in nested.items():
        lines += ["", f"[{path}{key}]", *_table(value, f"{path}{key}.")]
    for key, values in lists.items():
        for value in values:
            lines += ["", f"[[{path}{key}]]", *_table(value, f"{path}{key}.")]
    return lines
