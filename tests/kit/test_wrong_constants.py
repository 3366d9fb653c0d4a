"""A kit's self-test fails where one of its constants is wrong, but for folded ones that its README names."""

import ctypes
import dataclasses
import re
from collections.abc import Iterator
from typing import Any

import kits
import machines
import numpy as np
import pytest
from sweeps import slow_but

from stewart_sym.backend import native
from stewart_sym.derive.kernel.interface import STRUCTS
from stewart_sym.derive.package.text_format import robot_symbol
from stewart_sym.kit import Choice, kit
from stewart_sym.kit.kit_options import PRECISIONS
from stewart_sym.kit.parts import folded_kernel
from stewart_sym.kit.running import FORCES_MARGIN
from stewart_sym.kit.selection import SHARE, Numbered, selection
from stewart_sym.kit.sensitivity import Forces, changes
from stewart_sym.robot.robot import Robot

MACHINES = {
    "dasgupta": machines.dasgupta(),
    "six different legs": machines.random_robot(np.random.default_rng(11)),
}
REAL = {"double": ctypes.c_double, "float": ctypes.c_float}


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


SPHERICAL = {"spherical joints": machines.random_robot(np.random.default_rng(12), "spherical")}
KINDS = {"": {}, "scalar": {"scalar": True}, "paper": {"formulation": "paper"}}
CASES = [
    ("six different legs", "", "double"),
    ("six different legs", "", "float"),
    ("dasgupta", "scalar", "double"),
    ("dasgupta", "paper", "double"),
    ("spherical joints", "scalar", "float"),
]


@pytest.mark.parametrize(("which", "kind", "precision"), slow_but(CASES[-1:], CASES))
def test_every_wrong_constant_fails_the_self_test_or_is_named(which: str, kind: str, precision: str) -> None:
    robot = (MACHINES | SPHERICAL)[which]
    choice = Choice(bake=True, precision=precision, **KINDS[kind])
    mutants = Mutants(robot, choice)
    assert mutants.selftest() == 0
    share = SHARE[precision]
    wrong = [name for name in mutants.addresses if mutants.value(name)]
    passed = {name for name in wrong if not mutants.selftest(name, mutants.value(name) * (1.0 + share))}
    hidden = selection(Numbered.of(robot), choice.formulation, "general", precision).hidden
    assert passed <= set(hidden)
    assert len(wrong) - len(passed) > (80 if kind != "paper" and which in MACHINES else 40)


@pytest.mark.slow
def test_the_readme_of_a_kit_names_the_constants_that_rounding_hides() -> None:
    robot = MACHINES["dasgupta"]
    text = " ".join(kit(robot, Choice(bake=True, precision="float")).files["README.md"].decode().split())
    hidden = selection(Numbered.of(robot), "exact", "general", "float").hidden
    assert "a relative error of 0.001" in text
    assert hidden
    assert all(f"`{name.partition(' of leg ')[0]}`" in text for name in hidden)


@pytest.mark.parametrize("precision", ["double", "float"])
def test_the_self_test_sees_the_last_bit_of_every_number_that_is_not_folded_in(precision: str) -> None:
    """Zeros too, which a share of themselves does not change, and limits, which no function reads."""
    robot = dataclasses.replace(
        kits.machine("random drive"), force_limit=[500.0] * 6, length_limits=[[0.1, 0.95]] * 6
    )
    choice = Choice(("torque",), precision=precision)
    mutants = Mutants(robot, choice)
    assert mutants.selftest() == 0
    real = PRECISIONS[precision]
    for name in mutants.addresses:
        assert mutants.selftest(name, float(np.nextafter(real(mutants.value(name)), real(-np.inf)))), name
    text = " ".join(kit(robot, choice).files["README.md"].decode().split())
    assert "compares every number of `stewart_robot.c`, including limits, with the generated" in text
    assert "except in these" not in text


def random_motions(robot: Robot, count: int, seed: int) -> dict[str, np.ndarray]:
    """Motions of all paces about the home pose, none of them from the kit's pool, motions last."""
    rng = np.random.default_rng(seed)
    size = machines.machine_size(robot)
    axes = rng.standard_normal((count, 3)) * 0.3
    found = {
        "R": np.array([machines.rotation(axis) for axis in axes]),
        "t": machines.home_position(robot.b, size) + 0.3 * size * rng.standard_normal((count, 3)),
        "F_ext": np.zeros((count, 3)),
        "M_ext": np.zeros((count, 3)),
    }
    for name, arm in (("omega", 1.0), ("v", size), ("alpha", 1.0), ("a", size)):
        pace = 10.0 ** rng.uniform(-3, 3, (count, 1)) * (rng.random((count, 1)) < 0.5)
        found[name] = arm * pace * rng.standard_normal((count, 3))
    return {name: np.moveaxis(value, 0, -1) for name, value in found.items()}


@pytest.mark.parametrize("which", ["dasgupta", pytest.param("six different legs", marks=pytest.mark.slow)])
def test_no_motion_of_a_sweep_shows_what_is_named(which: str) -> None:
    """Rounding errors of other terms are larger than changes of these constants, wherever the platform is."""
    robot = MACHINES[which]
    hidden = set(selection(Numbered.of(robot), "exact", "general", "float").hidden)
    kernel = folded_kernel(robot, "exact", "general")
    forces = Forces(kernel, random_motions(robot, 2000, 5), near=False)
    tolerance = FORCES_MARGIN * forces.bound * float(np.finfo(np.float32).eps)
    largest = {
        name: float(np.nanmax(moved / tolerance))
        for change in changes(kernel, SHARE["float"])
        if hidden.intersection(change.names)
        for name, moved in zip(change.names, forces.moved(change), strict=True)
        if name in hidden
    }
    assert largest.keys() == hidden
    assert max(largest.values()) < 1.0
