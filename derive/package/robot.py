"""``stewart_robot.h`` and ``.c``, the constants and limits of one machine as C source.

Takes the numbers of ``stewart_robot`` by name.
"""

import hashlib
from collections.abc import Mapping, Sequence

from ..kernel.interface import STRUCTS
from ..mechanics import quantities as n
from .words import Numbers, braces, in_comment, literals_of_legs, member, robot_symbol, stored, template

HEADER, SOURCE = "stewart_robot.h", "stewart_robot.c"
"""File names of the constants: not the commonplace robot.h."""


def robot_files(
    name: str,
    robot: Numbers,
    limits: Mapping[str, Sequence[float]],
    version: str,
    drives: Mapping[str, Sequence[float]] | None = None,
) -> dict[str, str]:
    """``stewart_robot.h`` and ``stewart_robot.c``: file name -> text.

    robot: fields of ``stewart_robot``, those of the legs with six rows, inertias (3, 3). limits: members of
    ``stewart_limits``, six numbers each, infinite where there is none. drives: those of ``stewart_drives``,
    None for a kit without torques. Raises ValueError naming the field that is missing, has another shape or
    is not finite.
    """
    symbol = robot_symbol(name)
    values = {
        "name": in_comment(name),
        "symbol": symbol,
        "guard": f"{symbol.upper()}_H",
        "version": version,
        "digest": robot_digest(name, robot, drives),
        "robot": _initialiser(robot),
        "arithmetic": template("kit/arithmetic.h"),
        "limits": _six(limits, "limits"),
        "drives": "",
        "declared": "",
        "included": "stewart.h",
    }
    if drives is not None:
        of_drives = {"symbol": symbol, "numbers": _six(drives, "drives")}
        values["drives"] = template("kit/stewart_drives.c", of_drives)
        values["declared"] = template("kit/stewart_drives.h", of_drives)
        values["included"] = "stewart_torque.h"
    return {name: template(f"kit/{name}", values) for name in (HEADER, SOURCE)}


def _six(numbers: Mapping[str, Sequence[float]], struct: str) -> str:
    units = {each.name: each.unit for each in STRUCTS[struct]}
    return "\n".join(
        f"    /* {name}, {units[name]} */\n    {braces(literals, '    ')},"
        for name, literals in literals_of_legs(numbers, struct).items()
    )


def robot_digest(name: str, robot: Numbers, drives: Mapping[str, Sequence[float]] | None = None) -> str:
    """SHA-256 of name and constants, as hexadecimal digits; arguments and errors as of ``robot_files``."""
    of_drives = "" if drives is None else f"\n{_six(drives, 'drives')}"
    return hashlib.sha256(f"{name}\n{_initialiser(robot)}{of_drives}".encode()).hexdigest()


def _initialiser(robot: Numbers) -> str:
    legs = [
        "\n".join(
            [
                f"        {{ /* leg {i + 1} */",
                *(member(q, stored(robot, q, "robot", i), " " * 12) for q in n.of_leg(robot)),
                "        },",
            ]
        )
        for i in range(6)
    ]
    platform = [member(q, stored(robot, q, "robot"), "    ") for q in n.PLATFORM]
    return "\n".join(["    {", *legs, "    },", *platform])
