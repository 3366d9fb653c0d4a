"""The kit of a robot: it builds silently, proves itself, repeats to the byte and spares what is there."""

import ctypes
import dataclasses
import hashlib
import itertools
import json
import os
import random
import re
from collections.abc import Iterator
from contextlib import suppress
from functools import cache
from pathlib import Path

import builds
import machines
import numpy as np
import pytest
from kits import COMPILERS, STRICT, build, c_of, few_vectors, kit_of, machine, proves_itself, renamed, run

from stewart_sym import inverse_kinematics
from stewart_sym.backend import c_kernel, fidelity, kernel, native
from stewart_sym.derive.mechanics import quantities
from stewart_sym.derive.package.robot import Machine, robot_files
from stewart_sym.derive.package.text_format import robot_symbol
from stewart_sym.dynamics.sample_poses import sample
from stewart_sym.kit import FUNCTIONS, Choice, kit, kit_names, put, write_kit
from stewart_sym.kit.kit_options import check
from stewart_sym.kit.parts import parts

FORMULATIONS = ("exact", "paper")
SOLVE = "stewart_solve.h"
NAMES = {
    *("stewart.h", "stewart_arithmetic.h", "stewart_robot.h", "stewart_robot.c", "stewart.hpp"),
    *("stewart_rotation.h", "stewart_rotation.c", "test/selftest.c", "example/main.c", "README.md"),
    *("manifest.json", "Makefile", "robot.toml", "LICENSE", "CMakeLists.txt", "Config.cmake.in"),
}


# ---------------------------------------------------------------- what a kit does


@dataclasses.dataclass(frozen=True)
class Wish:
    """A choice and the machine that it is for."""

    which: str
    choice: Choice

    @property
    def pairs(self) -> set[tuple[tuple[str, object], ...]]:
        """Every two values, also of joint and drive; of levels those of one kind are one."""
        choice = {field.name: getattr(self.choice, field.name) for field in dataclasses.fields(Choice)}
        functions, level = choice.pop("functions"), choice.pop("fidelity")
        if "forces" in functions:
            choice["level"] = "reflected" if "reflected" in (level or "") else level in (None, "general")
        choice["joint"], _, choice["drive"] = self.which.partition(" ")
        return set(itertools.combinations([*choice.items(), *((name, True) for name in functions)], 2))

    @property
    def cost(self) -> float:
        """About how long its kit takes: what is not in ``generated/`` has to be derived."""
        choice, general = self.choice, self.choice.level in (None, "general")
        parted = ("motion" in choice.functions) != ("derivatives" in choice.functions)
        derived = (1 + 2 * general) * (choice.bake or choice.scalar) + 9 * parted
        whole = ("reactions" in choice.functions) + 3 * ("motion" in choice.functions and not parted)
        return 3 + derived + whole + choice.fmu / 2


MACHINES = ("random", "spherical", "random drive", "random rotors", "spherical rotors")


def wishes(rng: random.Random) -> Iterator[Wish]:
    while True:
        functions = tuple(name for name in FUNCTIONS if rng.random() < 0.5)
        which = rng.choice(MACHINES)
        level, formulation = rng.choice([None, *fidelity.available(machine(which))]), rng.choice(FORMULATIONS)
        plain = "forces" not in functions
        bake, scalar = (not plain and rng.random() < 0.5 for _ in range(2))
        precision = rng.choice(("double", "float"))
        fmu = not plain and rng.random() < 0.5
        made = Choice(functions, formulation, None if plain else level, bake, scalar, precision, fmu)
        with suppress(ValueError):
            check(made, machine(which))
            if not plain:
                fidelity.resolved(machine(which), formulation, made.level)
            yield Wish(which, made)


@cache
def covering() -> list[Wish]:
    """Few wishes in which every two values of two options that go together come together."""
    drawn = list(itertools.islice(wishes(random.Random(7)), 6000))
    # Sets of pairs as the bits of a number: there are thousands.
    bit: dict[tuple[tuple[str, object], ...], int] = {}
    masks = [sum(1 << bit.setdefault(pair, len(bit)) for pair in wish.pairs) for wish in drawn]
    left = (1 << len(bit)) - 1
    chosen = []
    while left:
        best = max(
            range(len(drawn)), key=lambda number: (masks[number] & left).bit_count() / drawn[number].cost
        )
        chosen.append(drawn[best])
        left &= ~masks[best]
    return chosen


KITS = 13
"""How many wishes cover the pairs."""


@pytest.mark.slow
@pytest.mark.parametrize("number", range(KITS))
def test_every_two_options_together_give_a_kit_that_proves_itself(tmp_path: Path, number: int) -> None:
    wish = covering()[number]
    with few_vectors():
        made, _ = write_kit(machine(wish.which), tmp_path / "kit", wish.choice)
    assert list(made.files) == kit_names(machine(wish.which), wish.choice)
    proves_itself(tmp_path / "kit", list(COMPILERS)[number % len(COMPILERS)], "-O0")


def test_covering_kits_hold_every_group() -> None:
    assert {wish.which for wish in covering()} == set(MACHINES)
    assert {name for wish in covering() for name in wish.choice.functions} == set(FUNCTIONS)
    assert len(covering()) == KITS


@pytest.mark.parametrize("precision", ["double", "float"])
def test_kit_holds_only_what_was_asked_for(precision: str) -> None:
    kernels = {
        "forces": {"stewart_exact_pose.h", "stewart_exact_pose.c", "stewart_kit.h", SOLVE},
        "reactions": {"stewart_exact.h", "stewart_exact.c", SOLVE, "stewart_outputs.h"},
        "kinematics": {"stewart_kinematics.h", "stewart_kinematics.c"},
    }
    for group, files in kernels.items():
        choice = Choice((group,), precision=precision, scalar=group == "forces")
        assert set(kit_names(machine("random"), choice)) == NAMES | files


@pytest.mark.parametrize("bake", [False, True])
@pytest.mark.parametrize("scalar", [False, True])
def test_operations_of_a_kit_are_those_that_its_header_counts(scalar: bool, bake: bool) -> None:
    made = kit_of(choice=Choice(scalar=scalar, bake=bake))
    (header,) = (
        text.decode() for name, text in made.files.items() if name.endswith(("_forces.h", "_pose.h"))
    )
    total = int(re.findall(r"^ \* total +(\d+) ", header, re.M)[0])
    assert total == (made.baked_operations if bake else made.operations)
    assert not bake or f"a pose took {made.operations} operations" in header
    assert f"| {total:,} |" in made.files["README.md"].decode()


@pytest.mark.parametrize(
    ("good", "bad", "file"),
    [
        ("REAL(-9.81)", "(stewart_real)NAN", "stewart_robot.c"),
        ("{REAL(0.0667)", "{(stewart_real)NAN", "test/selftest.c"),
        ("REAL(0.3)", "REAL(0.3000001)", "test/selftest.c"),
    ],
)
def test_selftest_fails_with_other_constants_or_motions(
    tmp_path: Path, good: str, bad: str, file: str
) -> None:
    put(kit_of(), tmp_path / "kit")
    path = tmp_path / "kit" / file
    text = path.read_text(encoding="utf-8")
    if good not in text:
        pytest.fail(f"{good} is not in {file}")
    path.write_text("#include <math.h>\n" + text.replace(good, bad), encoding="utf-8")
    code, output = run(build(tmp_path / "kit", "gcc", "-O0")["selftest"])
    assert code == 1
    right, checks = map(int, re.findall(r"^selftest +(\d+) of (\d+) right", output, re.M)[0])
    assert right < checks


def test_selftest_without_stdio_prints_nothing_and_needs_no_printf(tmp_path: Path) -> None:
    put(kit_of(choice=Choice(scalar=True)), tmp_path)
    command = ["gcc", "-std=c99", *STRICT, "-DSTEWART_NO_STDIO", "-I.", "-c", "test/selftest.c"]
    builds.run(*command, cwd=tmp_path)
    assert "printf" not in builds.run("nm", "-u", "selftest.o", cwd=tmp_path)


@pytest.mark.parametrize("which", ["dasgupta", "random", "spherical"])
def test_constants_reach_the_compiled_robot_to_the_bit(which: str) -> None:
    robot = machine(which)
    with few_vectors():
        made = kit(robot, Choice(("kinematics",)))
    library = native.load("kit_robot", c_of(made, r"stewart\.h|stewart_robot\.[ch]"))
    numbers = kernel.robot_numbers(robot)
    found = (ctypes.c_double * numbers.size).in_dll(library, robot_symbol(robot.name))
    np.testing.assert_array_equal(np.array(found), numbers)


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_kernel_files_are_the_committed_ones(formulation: str) -> None:
    files = parts(machine("random"), Choice(("forces", "reactions"), formulation)).files
    committed = [c_kernel.c_sources(name) for name in (formulation, f"{formulation}_forces", "rotation")]
    assert files == dict(item for each in committed for item in each.items())


def test_digest_follows_name_and_every_constant() -> None:
    robot = machines.dasgupta()
    variants = [robot, renamed("Other"), dataclasses.replace(robot, M=np.nextafter(robot.M, 41))]
    digests = set()
    for variant in variants:
        with few_vectors():
            files = kit(variant, Choice(("kinematics",))).files
        digest = json.loads(files["manifest.json"])["robot"]["sha256"]
        assert all(digest.encode() in files[name] for name in ("README.md", "stewart_robot.c"))
        digests.add(digest)
    assert len(digests) == 3


def test_manifest_tells_options_version_and_every_file() -> None:
    made = kit_of(choice=Choice(("kinematics", "forces"), scalar=True))
    manifest = json.loads(made.files["manifest.json"])
    assert manifest["generator"].startswith("stewart-sym ")
    assert manifest["options"] == {
        "functions": ["forces", "kinematics"],
        "formulation": "exact",
        "fidelity": None,
        "bake": False,
        "scalar": True,
        "precision": "double",
        "fmu": False,
        "language": "c",
    }
    others = {name: hashlib.sha256(text).hexdigest() for name, text in made.files.items()}
    del others["manifest.json"]
    assert manifest["files"] == others


# ---------------------------------------------------------------- names


@pytest.mark.parametrize(
    ("name", "symbol"),
    [
        ("Dasgupta & Mruthyunjaya 1998", "stewart_robot_dasgupta_mruthyunjaya_1998"),
        ("Prüfstand Süd, Größe 2", "stewart_robot_prufstand_sud_grosse_2"),
        ("6-SPS", "stewart_robot_6_sps"),
        ("  __x__  ", "stewart_robot_x"),
        ("double", "stewart_robot_double"),
    ],
)
def test_symbol_is_an_identifier_made_of_the_name(name: str, symbol: str) -> None:
    assert robot_symbol(name) == symbol


@pytest.mark.parametrize("length", [48, 49, 237, 5000])
def test_symbols_of_long_names_are_short_and_remain_different(length: int) -> None:
    one, other = robot_symbol("n" * length), robot_symbol("n" * (length - 1) + "m")
    assert one != other
    assert max(len(one), len(other)) <= len("stewart_robot_") + 48
    assert (one == f"stewart_robot_{'n' * length}") == (length == 48)
    assert re.fullmatch(r"[a-z][a-z0-9_]*[a-z0-9]", robot_symbol("a b " * length))


@pytest.mark.slow
def test_a_kit_of_a_robot_with_a_long_name_builds_and_passes_its_self_test(tmp_path: Path) -> None:
    robot = dataclasses.replace(machines.random_robot(np.random.default_rng(3)), name="n" * 237)
    choice = Choice(fidelity="massless_static", bake=True, fmu=True)
    _, paths = write_kit(robot, tmp_path, choice)
    # With what a build system or a copy adds to a name it stays within the 255 bytes of most systems.
    assert max(len(path.name) for path in paths) < 128
    builds.run("make", "-s", "CFLAGS=-O0", cwd=tmp_path)


def test_names_without_ascii_letters_get_symbols_of_their_own() -> None:
    symbols = {robot_symbol(name) for name in ("并联机器人", "平台", "***")}
    assert len(symbols) == 3
    assert all(re.fullmatch(r"stewart_robot_[0-9a-f]{12}", symbol) for symbol in symbols)


@pytest.mark.parametrize("compiler", ["gcc", "clang++"])
def test_any_name_compiles(tmp_path: Path, compiler: str) -> None:
    name = '*/ int x; /* "a" \\n %s @kernel@ //* ??/ ünï 机器人 {0} | `b` \\'
    put(kit_of(name, Choice(scalar=True)), tmp_path / "kit")
    proves_itself(tmp_path / "kit", compiler)


# ---------------------------------------------------------------- poses


def test_pose_keeps_within_length_limits_that_exist() -> None:
    robot = machine("random")
    usual = inverse_kinematics(robot, sample(robot, "exact")).L
    longer = np.column_stack([usual * 1.2, usual * 2.2])
    limited = dataclasses.replace(robot, length_limits=longer)
    L = inverse_kinematics(limited, sample(limited, "exact")).L
    assert ((longer[:, 0] <= L) & (longer[:, 1] >= L)).all()


@pytest.mark.parametrize("case", ["similar circles", "one platform point", "all points at the origin"])
def test_robot_without_a_good_pose_is_rejected(tmp_path: Path, case: str) -> None:
    robot = machines.dasgupta()
    angle = np.array([0.1, 1.0, 2.3, 3.1, 4.4, 5.0])
    circle = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(6)])
    b, p = {
        "similar circles": (circle, 0.5 * circle),
        "one platform point": (robot.b, np.tile([0.1, 0.2, 0.0], (6, 1))),
        "all points at the origin": (np.zeros((6, 3)), np.zeros((6, 3))),
    }[case]
    with pytest.raises(ValueError, match=r"\Arobot 'Dasgupta .*': no good pose for the example: .*\Z"):
        write_kit(dataclasses.replace(robot, b=b, p=p), tmp_path / "kit")
    assert os.listdir(tmp_path) == []


def test_emitter_names_the_field_it_cannot_print() -> None:
    robot = machines.dasgupta()
    names = [quantity.name for quantity in (*quantities.LEG, *quantities.PLATFORM)]
    numbers = {name: np.asarray(getattr(robot, name)).tolist() for name in names}
    limits = dict.fromkeys(("shortest", "longest", "force", "speed"), [1.0] * 6)
    with pytest.raises(ValueError, match=r"^robot: M: expected finite numbers, got nan$"):
        robot_files(Machine("x", {**numbers, "M": float("nan")}, limits, None, "0"))
