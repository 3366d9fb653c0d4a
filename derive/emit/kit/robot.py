"""``robot.h`` and ``robot.c``: the constants of one machine as C source.

One of the kit's texts; takes the numbers of ``stewart_robot`` by name. Knows no kernel.
"""

import hashlib

from ... import notation as n
from .words import Numbers, filled, in_comment, member, robot_symbol, stored


def robot_files(name: str, robot: Numbers, version: str) -> dict[str, str]:
    """``robot.h`` and ``robot.c``: file name -> text.

    robot: fields of ``stewart_robot``, those of the legs with six rows, inertias (3, 3). Raises ValueError
    naming the field that is missing, has another shape or is not finite.
    """
    symbol = robot_symbol(name)
    values = {
        "name": in_comment(name),
        "symbol": symbol,
        "guard": f"{symbol.upper()}_H",
        "version": version,
        "digest": robot_digest(name, robot),
        "robot": _initialiser(robot),
    }
    return {"robot.h": filled(_HEADER, values), "robot.c": filled(_SOURCE, values)}


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

/* To be handed to the functions of the kit. */
extern const stewart_robot @symbol@;

#ifdef __cplusplus
}
#endif

#endif
"""

_SOURCE = """\
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
