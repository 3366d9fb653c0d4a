"""Constants and limits of one robot as C source, ``stewart_robot.h`` and ``stewart_robot.c``."""

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ..kernel.interface import STRUCTS
from ..mechanics import quantities as n
from .text_format import Numbers, braces, in_comment, literals_of_legs, member, robot_symbol, stored, template

HEADER, SOURCE = "stewart_robot.h", "stewart_robot.c"
"""File names of the constants; robot.h would be too common."""


@dataclass(frozen=True)
class Machine:
    """Numbers of one robot for its kit.

    Attributes
    ----------
    name : str
        Name of the robot.
    numbers : mapping
        Fields of ``stewart_robot``; fields of the legs have six rows, inertias (3, 3).
    limits : mapping
        Members of ``stewart_limits``, six numbers each, infinite without a limit.
    drives : mapping, optional
        Members of ``stewart_drives``; None for a kit without torques.
    version : str
        Version of the generator.
    """

    name: str
    numbers: Numbers
    limits: Mapping[str, Sequence[float]]
    drives: Mapping[str, Sequence[float]] | None
    version: str

    @property
    def symbol(self) -> str:
        """Name of the constants in C."""
        return robot_symbol(self.name)

    @property
    def digest(self) -> str:
        """SHA-256 of name and constants as hexadecimal digits; errors as in ``robot_files``."""
        of_drives = "" if self.drives is None else f"\n{_six(self.drives, 'drives')}"
        return hashlib.sha256(f"{self.name}\n{_initializer(self.numbers)}{of_drives}".encode()).hexdigest()


def robot_files(machine: Machine) -> dict[str, str]:
    """Return ``stewart_robot.h`` and ``stewart_robot.c``, file name -> text.

    Raises
    ------
    ValueError
        If a field is not finite.
    """
    values = {
        "name": in_comment(machine.name),
        "symbol": machine.symbol,
        "guard": f"{machine.symbol.upper()}_H",
        "version": machine.version,
        "digest": machine.digest,
        "robot": _initializer(machine.numbers),
        "arithmetic": template("kit/arithmetic.h"),
        "limits": _six(machine.limits, "limits"),
        "drives": "",
        "declared": "",
        "included": "stewart.h",
    }
    if machine.drives is not None:
        of_drives = {"symbol": machine.symbol, "numbers": _six(machine.drives, "drives")}
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


def _initializer(robot: Numbers) -> str:
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
