"""The kit of a robot: it builds silently, proves itself, repeats to the byte and spares what is there."""

import ctypes
import dataclasses
import errno
import hashlib
import itertools
import json
import os
import random
import re
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import machines
import numpy as np
import pytest
from numpy.typing import NDArray

from stewart_sym import inverse_kinematics
from stewart_sym.backend import fidelity, kernel, native
from stewart_sym.derive.mechanics import quantities
from stewart_sym.derive.package.robot import robot_files
from stewart_sym.derive.package.words import robot_symbol
from stewart_sym.generated.interface import HEADERS
from stewart_sym.kit import FUNCTIONS, Choice, Kit, kit, kit_names, put, write_kit
from stewart_sym.kit.choice import DEFAULT, check
from stewart_sym.kit.poses import sample
from stewart_sym.robot.robot import Robot

Array = NDArray[np.float64]

STRICT = ("-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Wshadow", "-Werror")
COMPILERS = {
    "gcc": ("gcc", "-std=c99"),
    "clang": ("clang", "-std=c99"),
    "g++": ("g++", "-x", "c++", "-std=c++11"),
    "clang++": ("clang++", "-x", "c++", "-std=c++11"),
}
FORMULATIONS = ("exact", "paper")
SOLVE = "stewart_solve.h"
NAMES = {
    *("stewart.h", "stewart_arithmetic.h", "stewart_robot.h", "stewart_robot.c", "stewart.hpp"),
    *("stewart_rotation.h", "stewart_rotation.c", "test/selftest.c", "example/main.c", "README.md"),
    *("manifest.json", "Makefile", "robot.toml", "LICENSE", "CMakeLists.txt", "Config.cmake.in"),
}


@cache
def machine(which: str) -> Robot:
    rng = np.random.default_rng(20)
    if which == "dasgupta":
        return machines.dasgupta()
    return machines.random_robot(rng, "spherical" if which == "spherical" else "universal")


@cache
def renamed(name: str) -> Robot:
    return dataclasses.replace(machines.dasgupta(), name=name)


@cache
def kit_of(name: str = "Dasgupta & Mruthyunjaya 1998", choice: Choice = DEFAULT) -> Kit:
    return kit(renamed(name), choice)


def build(folder: Path, compiler: str, level: str = "-O1") -> dict[str, Path]:
    """Compile the kit with all warnings as errors and not a word printed; return its programs."""
    flags = (*COMPILERS[compiler], *STRICT, level, "-ffp-contract=off")
    objects = {}
    for source in sorted(folder.rglob("*.c")):
        objects[source.stem] = folder.parent / f"{compiler}-{source.stem}.o"
        silently([*flags, f"-I{folder}", "-c", str(source), "-o", str(objects[source.stem])])
    programs = ("selftest", "main")
    library = [str(path) for name, path in objects.items() if name not in programs]
    made = {}
    for name in programs:
        made[name] = folder.parent / f"{compiler}-{name}"
        silently([COMPILERS[compiler][0], str(objects[name]), *library, "-o", str(made[name]), "-lm"])
    return made


def silently(command: list[str]) -> None:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout + done.stderr) == (0, "")


def run(program: Path) -> tuple[int, str]:
    done = subprocess.run([str(program)], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout


def proves_itself(folder: Path, compiler: str = "gcc", level: str = "-O1") -> None:
    """Build and run self-test and example."""
    programs = build(folder, compiler, level)
    code, output = run(programs["selftest"])
    assert code == 0, output
    assert re.search(r"^selftest +(\d+) of +\1 right, worst error \S+ of its bound$", output, re.M), output
    assert run(programs["main"])[0] == 0


def contents(folder: Path) -> dict[str, bytes]:
    return {
        path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()
    }


# ---------------------------------------------------------------- what a kit does


@pytest.mark.parametrize(
    ("which", "formulation", "compiler"),
    [
        *(("random", "exact", compiler) for compiler in COMPILERS),
        *(("dasgupta", "paper", "clang"), ("spherical", "exact", "g++")),
    ],
)
def test_kit_builds_silently_and_proves_itself(
    tmp_path: Path, which: str, formulation: str, compiler: str
) -> None:
    write_kit(machine(which), tmp_path / "kit", Choice(("forces", "reactions"), formulation))
    proves_itself(tmp_path / "kit", compiler)


@dataclasses.dataclass(frozen=True)
class Wish:
    """A choice and the machine that it is for."""

    which: str
    choice: Choice

    @property
    def values(self) -> tuple[tuple[str, object], ...]:
        choice = {field.name: getattr(self.choice, field.name) for field in dataclasses.fields(Choice)}
        functions = choice.pop("functions")
        groups = {name: name in functions for name in FUNCTIONS}
        return (("which", self.which), *choice.items(), *groups.items())

    @property
    def pairs(self) -> set[tuple[tuple[str, object], ...]]:
        return set(itertools.combinations(self.values, 2))

    @property
    def possible(self) -> bool:
        try:
            check(self.choice, machine(self.which))
            if "forces" in self.choice.functions:
                fidelity.resolved(machine(self.which), self.choice.formulation, self.choice.level)
        except ValueError:
            return False
        return True


def wishes(rng: random.Random) -> Iterator[Wish]:
    while True:
        functions = tuple(name for name in FUNCTIONS if rng.random() < 0.5)
        level = rng.choice([None, *fidelity.FIDELITIES])
        plain = not any(name in functions for name in ("forces",))
        made = Choice(
            functions,
            rng.choice(FORMULATIONS),
            None if plain else level,
            not plain and rng.random() < 0.5,
            not plain and rng.random() < 0.5,
            rng.choice(("double", "float")),
            not plain and rng.random() < 0.5,
        )
        wish = Wish(rng.choice(("random", "spherical")), made)
        if wish.possible:
            yield wish


def covering() -> list[Wish]:
    """Few wishes in which every two values of two options that go together come together."""
    drawn = list(itertools.islice(wishes(random.Random(7)), 6000))
    # Sets of pairs as the bits of a number, since every test process chooses.
    bit: dict[tuple[tuple[str, object], ...], int] = {}
    masks = [sum(1 << bit.setdefault(pair, len(bit)) for pair in wish.pairs) for wish in drawn]
    left = (1 << len(bit)) - 1
    chosen = []
    while left:
        best = max(range(len(drawn)), key=lambda number: (masks[number] & left).bit_count())
        chosen.append(drawn[best])
        left &= ~masks[best]
    return chosen


COVERING = covering()


@pytest.mark.slow
@pytest.mark.parametrize("number", range(len(COVERING)))
def test_every_two_options_together_give_a_kit_that_proves_itself(tmp_path: Path, number: int) -> None:
    wish = COVERING[number]
    made, _ = write_kit(machine(wish.which), tmp_path / "kit", wish.choice)
    assert list(made.files) == kit_names(machine(wish.which), wish.choice)
    proves_itself(tmp_path / "kit", "g++" if number % 2 else "gcc", "-O0")


def test_covering_kits_hold_every_level_and_every_group() -> None:
    choices = [wish.choice for wish in COVERING]
    assert {choice.fidelity for choice in choices} == {None, *fidelity.FIDELITIES}
    assert {name for choice in choices for name in choice.functions} == set(FUNCTIONS)
    assert len(COVERING) < 60


@pytest.mark.parametrize("precision", ["double", "float"])
def test_kit_holds_only_what_was_asked_for(precision: str) -> None:
    kernels = {
        "forces": {"stewart_exact_pose.h", "stewart_exact_pose.c", SOLVE},
        "reactions": {"stewart_exact.h", "stewart_exact.c", SOLVE, "stewart_outputs.h"},
        "kinematics": {"stewart_kinematics.h", "stewart_kinematics.c"},
    }
    for group, files in kernels.items():
        choice = Choice((group,), precision=precision, scalar=group == "forces")
        assert set(kit_names(machine("random"), choice)) == NAMES | files


@pytest.mark.parametrize(
    ("good", "bad", "file"),
    [
        ("REAL(40.0)", "REAL(40.1)", "stewart_robot.c"),
        ("REAL(-9.81)", "REAL(9.81)", "stewart_robot.c"),
        ("REAL(-9.81)", "(stewart_real)NAN", "stewart_robot.c"),
        ("{REAL(0.0696)", "{(stewart_real)NAN", "test/selftest.c"),
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
    code, output = run(build(tmp_path / "kit", "gcc")["selftest"])
    assert code == 1
    right, checks = map(int, re.findall(r"^selftest +(\d+) of (\d+) right", output, re.M)[0])
    assert right < checks


def test_selftest_without_stdio_prints_nothing_and_needs_no_printf(tmp_path: Path) -> None:
    put(kit_of(choice=Choice(scalar=True)), tmp_path)
    command = ["gcc", "-std=c99", *STRICT, "-DSTEWART_NO_STDIO", "-I.", "-c", "test/selftest.c"]
    subprocess.run(command, cwd=tmp_path, check=True)
    names = subprocess.run(
        ["nm", "-u", "selftest.o"], cwd=tmp_path, check=True, capture_output=True, text=True
    ).stdout
    assert "printf" not in names


@pytest.mark.parametrize("which", ["dasgupta", "random", "spherical"])
def test_constants_reach_the_compiled_robot_to_the_bit(which: str) -> None:
    robot = machine(which)
    files = {name: text.decode() for name, text in kit(robot).files.items() if name.endswith((".h", ".c"))}
    library = native.load(
        "kit_robot", {name: files[name] for name in ("stewart.h", "stewart_robot.h", "stewart_robot.c")}
    )
    numbers = kernel.robot_numbers(robot)
    found = (ctypes.c_double * numbers.size).in_dll(library, robot_symbol(robot.name))
    np.testing.assert_array_equal(np.array(found), numbers)


def test_kernel_files_are_the_committed_ones() -> None:
    for formulation in FORMULATIONS:
        files = kit_of(choice=Choice(("forces", "reactions"), formulation)).files
        committed = kernel.c_sources(formulation) | kernel.c_sources(f"{formulation}_forces")
        assert {name: files[name].decode() for name in committed} == committed
        assert set(files) - set(committed) == NAMES - set(HEADERS)


# ---------------------------------------------------------------- the same bytes


def test_same_robot_gives_the_same_bytes_in_any_folder_and_under_any_hash_seed(tmp_path: Path) -> None:
    """All files of the kit, a unit of FMI with a compiled library among them."""
    first = put(kit_of(choice=Choice(fmu=True)), tmp_path / "a")
    program = f"""
import warnings
from pathlib import Path
from stewart_sym import robots
from stewart_sym.kit import Choice, write_kit
warnings.simplefilter("ignore")
write_kit(robots.dasgupta1998(), Path({str(tmp_path / "b")!r}), Choice(fmu=True))
"""
    env = {**os.environ, "PYTHONHASHSEED": "12345", "TMPDIR": str(tmp_path)}
    subprocess.run([sys.executable, "-c", program], env=env, check=True)
    assert contents(tmp_path / "a") == contents(tmp_path / "b")
    assert any(path.suffix == ".fmu" for path in first)
    assert sorted(path.relative_to(tmp_path / "a").as_posix() for path in first) == sorted(
        contents(tmp_path / "a")
    )


def test_digest_follows_name_and_every_constant() -> None:
    robot = machines.dasgupta()
    variants = [robot, renamed("Other"), dataclasses.replace(robot, M=np.nextafter(robot.M, 41))]
    digests = set()
    for variant in variants:
        files = kit(variant).files
        digest = json.loads(files["manifest.json"])["robot"]["sha256"]
        assert all(digest.encode() in files[name] for name in ("README.md", "stewart_robot.c"))
        digests.add(digest)
    assert len(digests) == 3


def test_manifest_tells_options_version_and_every_file() -> None:
    made = kit_of(choice=Choice(("kinematics", "forces"), bake=True, precision="float"))
    manifest = json.loads(made.files["manifest.json"])
    assert manifest["generator"].startswith("stewart-sym ")
    assert manifest["options"] == {
        "functions": ["forces", "kinematics"],
        "formulation": "exact",
        "fidelity": None,
        "bake": True,
        "scalar": False,
        "precision": "float",
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


def test_a_kit_of_a_robot_with_a_long_name_builds_and_passes_its_self_test(tmp_path: Path) -> None:
    robot = dataclasses.replace(machines.random_robot(np.random.default_rng(3)), name="n" * 237)
    _, paths = write_kit(robot, tmp_path, Choice(bake=True, fmu=True))
    # With what a build system or a copy adds to a name it stays within the 255 bytes of most systems.
    assert max(len(path.name) for path in paths) < 128
    subprocess.run(["make", "-s", "-C", str(tmp_path)], check=True, capture_output=True)


@pytest.mark.parametrize("target", ["check", "test"])
def test_make_runs_the_self_test_beside_the_folder_of_tests(target: str, tmp_path: Path) -> None:
    write_kit(machines.dasgupta(), tmp_path, Choice())
    done = subprocess.run(
        ["make", "-s", "-C", str(tmp_path), target], check=True, capture_output=True, text=True
    )
    assert "selftest" in done.stdout


def test_names_without_ascii_letters_get_symbols_of_their_own() -> None:
    symbols = {robot_symbol(name) for name in ("并联机器人", "平台", "***")}
    assert len(symbols) == 3
    assert all(re.fullmatch(r"stewart_robot_[0-9a-f]{12}", symbol) for symbol in symbols)


@pytest.mark.parametrize("compiler", COMPILERS)
def test_any_name_compiles(tmp_path: Path, compiler: str) -> None:
    name = '*/ int x; /* "a" \\n %s @kernel@ //* ??/ ünï 机器人 {0} | `b` \\'
    put(kit_of(name, Choice(scalar=True)), tmp_path / "kit")
    proves_itself(tmp_path / "kit", compiler)


# ---------------------------------------------------------------- what is there already


def test_edited_file_is_rejected_without_force_and_replaced_with_it(tmp_path: Path) -> None:
    put(kit_of(), tmp_path)
    fresh = contents(tmp_path)
    (tmp_path / "stewart_robot.c").write_text("mine", encoding="utf-8")
    (tmp_path / "README.md").unlink()
    (tmp_path / "notes.txt").write_text("mine too", encoding="utf-8")
    edited = contents(tmp_path)
    with pytest.raises(
        ValueError, match=r"^\S+robot\.c: exists with other content; use --force to overwrite$"
    ):
        put(kit_of(), tmp_path)
    assert contents(tmp_path) == edited
    put(kit_of(), tmp_path, force=True)
    assert contents(tmp_path) == {**fresh, "notes.txt": b"mine too"}


def test_kit_of_a_changed_robot_replaces_what_nobody_edited(tmp_path: Path) -> None:
    put(kit_of("Old"), tmp_path)
    put(kit_of("New"), tmp_path)
    assert contents(tmp_path) == kit_of("New").files


def test_files_that_the_new_kit_has_not_are_removed_unless_edited(tmp_path: Path) -> None:
    put(kit_of(), tmp_path)
    (tmp_path / "stewart_robot.h").write_text("mine", encoding="utf-8")
    baked = kit_of(choice=Choice(bake=True, scalar=True))
    put(baked, tmp_path)
    assert contents(tmp_path) == {**baked.files, "stewart_robot.h": b"mine"}


@pytest.mark.parametrize(
    "manifest", ["", "[]", '{"generator": "stewart-sym 0"}', '{"generator": "other", "files": {}}']
)
def test_manifest_that_is_none_of_ours_protects_every_file(tmp_path: Path, manifest: str) -> None:
    put(kit_of("Old"), tmp_path)
    (tmp_path / "manifest.json").write_text(manifest, encoding="utf-8")
    old = contents(tmp_path)
    with pytest.raises(ValueError, match=r"exists with other content; use --force to overwrite$"):
        put(kit_of("New"), tmp_path)
    assert contents(tmp_path) == old


def test_manifest_that_names_files_elsewhere_removes_none(tmp_path: Path) -> None:
    folder = tmp_path / "kit"
    put(kit_of("Old"), folder)
    (tmp_path / "precious").write_text("mine", encoding="utf-8")
    manifest = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
    manifest["files"]["../precious"] = hashlib.sha256(b"mine").hexdigest()
    (folder / "manifest.json").write_text(json.dumps(manifest), encoding="utf-8")
    put(kit_of("New"), folder, force=True)
    assert (tmp_path / "precious").read_text(encoding="utf-8") == "mine"


def test_second_run_leaves_equal_files_untouched(tmp_path: Path) -> None:
    files = put(kit_of(), tmp_path / "kit")

    def stamps() -> list[tuple[int, int]]:
        return [(path.stat().st_ino, path.stat().st_mtime_ns) for path in files]

    before = stamps()
    assert put(kit_of(), tmp_path / "kit") == files
    assert stamps() == before


def test_new_folder_has_the_users_mode_and_nothing_lies_beside_it(tmp_path: Path) -> None:
    (tmp_path / "plain").mkdir()
    put(kit_of(), tmp_path / "deep" / "kit")
    assert (tmp_path / "deep" / "kit").stat().st_mode == (tmp_path / "plain").stat().st_mode
    assert os.listdir(tmp_path / "deep") == ["kit"]


# ---------------------------------------------------------------- failures


@pytest.mark.parametrize("fault", [OSError(errno.ENOSPC, "No space left on device"), KeyboardInterrupt()])
def test_failure_while_writing_leaves_no_trace(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, fault: BaseException
) -> None:
    made = kit_of()
    fail_at_call(monkeypatch, "write_bytes", 4, fault)
    with pytest.raises((ValueError, KeyboardInterrupt)) as caught:
        put(made, tmp_path / "kit")
    assert os.listdir(tmp_path) == []
    if isinstance(fault, OSError):
        assert str(caught.value) == f"{tmp_path / 'kit'}: No space left on device"


@pytest.mark.parametrize("fault", [OSError(errno.EIO, "Input/output error"), KeyboardInterrupt()])
@pytest.mark.parametrize("call", range(1, 26))
def test_failure_while_replacing_leaves_the_old_kit_whole(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, call: int, fault: BaseException
) -> None:
    """Two moves for each of the files that both have, one for each that only one of them has."""
    old, new = kit_of("Old"), kit_of("New", Choice(bake=True, scalar=True))
    put(old, tmp_path)
    calls = fail_at_call(monkeypatch, "rename", call, fault)
    try:
        put(new, tmp_path)
    except (ValueError, KeyboardInterrupt):
        assert contents(tmp_path) == old.files
    else:
        assert calls[0] < call
        assert contents(tmp_path) == new.files


def fail_at_call(monkeypatch: pytest.MonkeyPatch, method: str, call: int, fault: BaseException) -> list[int]:
    real, calls = getattr(Path, method), [0]

    def failing(self: Path, argument: object) -> object:
        calls[0] += 1
        if calls[0] == call:
            raise fault
        return real(self, argument)

    monkeypatch.setattr(Path, method, failing)
    return calls


def test_folder_that_cannot_be_written_is_one_line(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("x", encoding="utf-8")
    # The kernel's own file system takes no files, not even root's.
    unwritable = dict.fromkeys((Path("/proc/kit"), Path("/proc/self")), "can't write here")
    blocked = dict.fromkeys((tmp_path / "file", tmp_path / "file" / "kit"), "expected a folder")
    for folder, message in (unwritable | blocked).items():
        with pytest.raises(ValueError, match=rf"\A\S+: {message}.*\Z"):
            put(kit_of(), folder)
    assert os.listdir(tmp_path) == ["file"]


def test_folder_in_the_place_of_a_file_is_rejected_even_with_force(tmp_path: Path) -> None:
    (tmp_path / "stewart_robot.h").mkdir()
    with pytest.raises(ValueError, match=r"robot\.h: expected a file or nothing, found a folder"):
        put(kit_of(), tmp_path, force=True)
    assert os.listdir(tmp_path) == ["stewart_robot.h"]


@pytest.mark.parametrize(
    ("choice", "which", "message"),
    [
        (Choice(formulation="fast"), "random", r'formulation: expected "exact" or "paper", got \'fast\''),
        (Choice(precision="half"), "random", r'precision: expected "double" or "float", got \'half\''),
        (Choice(()), "random", "functions: expected some of forces, .*, got none"),
        (Choice(("force",)), "random", "functions: expected some of forces, .*, got 'force'"),
        (Choice(("motion",), "paper"), "random", "functions: motion: expected exact with universal .*"),
        (Choice(("derivatives",)), "spherical", "functions: derivatives: expected exact with universal .*"),
        (Choice(("reactions",), bake=True), "random", "bake: applies to the function forces, got reactions"),
        (Choice(("motion",), fidelity="slender"), "random", "fidelity: applies to the function forces, .*"),
        (Choice(("kinematics",), fmu=True), "random", "fmu: applies to the function forces, .*"),
        (Choice(fidelity="rigid"), "random", "fidelity: expected one of general, .*"),
    ],
)
def test_wishes_that_do_not_go_together_are_rejected_in_one_line(
    tmp_path: Path, choice: Choice, which: str, message: str
) -> None:
    with pytest.raises(ValueError, match=rf"\A{message}\Z"):
        write_kit(machine(which), tmp_path / "kit", choice)
    with pytest.raises(ValueError, match=rf"\A{message}\Z"):
        kit_names(machine(which), choice)
    assert os.listdir(tmp_path) == []


# ---------------------------------------------------------------- poses


def turned(robot: Robot, base: Array, platform: Array) -> Robot:
    """The same machine told in another base frame and with another frame on its platform."""
    return dataclasses.replace(
        robot,
        b=robot.b @ base.T,
        k=robot.k @ base.T,
        g=base @ robot.g,
        p=robot.p @ platform.T,
        R_0=platform @ robot.R_0,
        I_p=platform @ robot.I_p @ platform.T,
    )


def test_machines_that_hang_or_stand_on_a_wall_have_a_good_pose() -> None:
    hang = np.diag([1.0, -1.0, -1.0])
    wall = np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]])
    for base in (hang, wall):
        for platform in (np.eye(3), base):
            robot = turned(machine("random"), base, platform)
            motion, forces, condition = sample(robot, "exact")
            assert int(forces.status) == 0
            assert condition < 50
            sines = np.linalg.norm(np.cross(robot.k, inverse_kinematics(robot, motion).s), axis=-1)
            assert sines.min() >= 0.3


def test_pose_keeps_within_length_limits_that_exist() -> None:
    robot = machine("random")
    usual = inverse_kinematics(robot, sample(robot, "exact")[0]).L
    longer = np.column_stack([usual * 1.2, usual * 2.2])
    limited = dataclasses.replace(robot, length_limits=longer)
    L = inverse_kinematics(limited, sample(limited, "exact")[0]).L
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


@pytest.mark.parametrize(
    ("field", "value", "message"),
    [
        ("M", float("nan"), "robot: M: expected finite numbers, got nan"),
        ("b", [[0.0, 0.0, 0.0]], "robot: b: expected an entry"),
        ("g", None, "robot: g: expected an entry"),
        ("C_u", ["1"] * 6, "robot: C_u: expected finite numbers, got '1'"),
    ],
)
def test_emitter_names_the_field_it_cannot_print(field: str, value: object, message: str) -> None:
    robot = machines.dasgupta()
    names = [quantity.name for quantity in (*quantities.LEG, *quantities.PLATFORM)]
    numbers = {name: np.asarray(getattr(robot, name)).tolist() for name in names}
    limits = dict.fromkeys(("shortest", "longest", "force", "speed"), [1.0] * 6)
    with pytest.raises(ValueError, match=re.escape(message)):
        robot_files("x", {**numbers, field: value}, limits, "0")
    del numbers[field]
    with pytest.raises(ValueError, match=f"^robot: {field}: missing$"):
        robot_files("x", numbers, limits, "0")
