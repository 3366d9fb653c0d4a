"""Compiled kits whose constants can be changed, and the rate at which their self-tests detect a change."""

import ctypes
import re
from collections.abc import Iterator
from functools import cache
from typing import Any

import kits
import machines
import numpy as np

from stewart_sym import robots
from stewart_sym.backend import native
from stewart_sym.derive.kernel.interface import STRUCTS
from stewart_sym.derive.package.text_format import robot_symbol
from stewart_sym.kit import Choice, kit
from stewart_sym.robot.robot import Robot

CHANGE = 1e-3
"""Relative change of a constant."""
REAL = {"double": ctypes.c_double, "float": ctypes.c_float}


@cache
def five_robots() -> dict[str, Robot]:
    """Three robots from publications, and two with six different legs."""
    shipped = {name: robots.load(name) for name in ("dasgupta1998", "mathworks2002", "dehaeze_nano")}
    return shipped | {
        "universal": machines.random_robot(np.random.default_rng(11)),
        "spherical": machines.random_robot(np.random.default_rng(12), "spherical"),
    }


class Mutants:
    """A compiled kit whose constants can be written; selftest: failed checks with one of them changed."""

    def __init__(self, robot: Robot, choice: Choice) -> None:
        files = kits.c_of(kit(robot, choice))
        sources = {name: text for name, text in files.items() if "/" not in name}
        sources["selftest.c"] = files["test/selftest.c"]
        self.addresses = dict(
            _baked(sources) if choice.bake else _of_robot(sources, robot_symbol(robot.name))
        )
        flags = ("-DSTEWART_NO_MAIN", "-DSTEWART_NO_STDIO", "-O0")
        self._library = native.load("wrong_constants", sources, flags)
        self._real = REAL[choice.precision]

    def selftest(self, name: str = "", wrong: float = 0.0) -> int:
        """Failed checks, with the constant of that name set to another number."""
        if not name:
            return self._library.stewart_selftest(None, None)
        right = self.value(name)
        self._constant(name)[0] = wrong
        try:
            return self._library.stewart_selftest(None, None)
        finally:
            self._constant(name)[0] = right

    def value(self, name: str) -> float:
        return self._constant(name)[0]

    def undetected(self, change: float = CHANGE) -> tuple[list[str], int]:
        """Names of the constants whose relative change passes, and the number of constants that are not 0."""
        known = [name for name in self.addresses if self.value(name)]
        return [name for name in known if not self.selftest(name, self.value(name) * (1.0 + change))], len(
            known
        )

    def _constant(self, name: str) -> Any:
        where = ctypes.c_void_p.in_dll(self._library, "wrong_constants").value
        return ctypes.cast(where, ctypes.POINTER(ctypes.POINTER(self._real)))[self.addresses[name]]


def _baked(sources: dict[str, str]) -> Iterator[tuple[str, int]]:
    """Makes the constants of the kernel's source writable; their names and places in the list of them."""
    (name,) = (name for name in sources if re.search(r"_(forces|pose)\.c$", name))
    text = sources[name]
    shared = re.findall(r"^#define BAKED_(\w+) REAL\(.*?\) /\*", text, re.M)
    text = re.sub(
        r"^#define BAKED_(\w+) (REAL\(.*?\)) .*$",
        r"static stewart_real baked_\1 = \2;\n#define BAKED_\1 baked_\1",
        text,
        flags=re.M,
    )
    table = re.search(r"static const (\w+) (numbers|legs\[6\]) = \{", text)
    assert table
    members = re.findall(r"stewart_real (\w+)(?:\[LANES\])?;", _struct(text, table[1]))
    text = text.replace(table[0], table[0].replace("const ", ""))
    lanes = table[2] == "numbers"
    of_legs = [(f"{member} of leg {i + 1}", f"&numbers.{member}[{i}]" if lanes else f"&legs[{i}].{member}")
               for member in members for i in range(6)]  # fmt: skip
    named = [*((each, f"&baked_{each}") for each in shared), *of_legs]
    sources[name] = f"{text}\n{_pointers(address for _, address in named)}"
    yield from ((label, i) for i, (label, _) in enumerate(named))


def _of_robot(sources: dict[str, str], symbol: str) -> Iterator[tuple[str, int]]:
    """The same of the constants of a robot without rotors, its limits and drives, by where they are."""
    for name in ("stewart_robot.h", "stewart_robot.c"):
        sources[name] = sources[name].replace("const stewart_", "stewart_")
    owners = [(f"{symbol}.leg[{i}]", "leg") for i in range(6)]
    owners += [(symbol, "platform"), (f"{symbol}_limits", "limits"), (f"{symbol}_drives", "drives")]
    named = [
        f"{owner}.{member.name}" + (f"[{i}]" if member.stored else "")
        for owner, struct in owners
        for member in STRUCTS[struct]
        for i in range(member.count)
    ]
    sources["stewart_robot.c"] += _pointers(f"&{each}" for each in named)
    yield from ((each, i) for i, each in enumerate(named))


def _struct(text: str, name: str) -> str:
    """Members of a struct of robots without rotors."""
    text = re.sub(r"^#if defined\(STEWART_ROTORS\).*?^#endif$", "", text, flags=re.M | re.S)
    end = re.search(rf"^\}} {name};", text, re.M)
    assert end
    return text[text.rindex("typedef struct {", 0, end.start()) : end.start()]


def _pointers(addresses: Iterator[str]) -> str:
    listed = ",\n    ".join(addresses)
    return (
        f"static stewart_real *const constants[] = {{\n    {listed}}};\n"
        "extern stewart_real *const *const wrong_constants;\n"
        "stewart_real *const *const wrong_constants = constants;\n"
    )
