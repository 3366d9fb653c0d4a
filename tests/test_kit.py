"""The kit of a robot: it builds silently, proves itself, repeats to the byte and spares what is there."""

import ctypes
import dataclasses
import errno
import os
import re
import subprocess
import sys
from pathlib import Path

import machines
import numpy as np
import pytest
from numpy.typing import NDArray

from stewart_sym import fidelity, inverse_dynamics, inverse_kinematics, kernel, native
from stewart_sym.derive import notation
from stewart_sym.derive.emit import kit as texts
from stewart_sym.derive.emit.kit import Sample, Target, robot_symbol
from stewart_sym.kit import Choice, kit, sample, write_kit
from stewart_sym.robot import Robot

Array = NDArray[np.float64]

STRICT = ("-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Werror")
COMPILERS = {
    "gcc": ("gcc", "-std=c99"),
    "clang": ("clang", "-std=c99"),
    "g++": ("g++", "-x", "c++", "-std=c++11"),
    "clang++": ("clang++", "-x", "c++", "-std=c++11"),
}
ARITHMETIC = {"double": (), "float": ("-DSTEWART_FLOAT",)}
FORMULATIONS = ("exact", "paper")


def machine(which: str) -> Robot:
    rng = np.random.default_rng(20)
    if which == "dasgupta":
        return machines.dasgupta()
    return machines.random_robot(rng, "spherical" if which == "spherical" else "universal")


def build(folder: Path, compiler: str, arithmetic: str = "double") -> Path:
    """Compile the kit with all warnings as errors and not a word printed; return the program."""
    program = folder.parent / f"{compiler}-{arithmetic}"
    sources = sorted(folder.glob("*.c"))
    flags = (*COMPILERS[compiler], *STRICT, "-O1", *ARITHMETIC[arithmetic])
    command = [*flags, *map(str, sources), "-o", str(program), "-lm"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout + done.stderr) == (0, "")
    return program


def run(program: Path) -> tuple[int, str]:
    done = subprocess.run([str(program)], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout


def contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def renamed(name: str) -> Robot:
    return dataclasses.replace(machines.dasgupta(), name=name)


@pytest.mark.parametrize("arithmetic", ARITHMETIC)
@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("which", ["dasgupta", "random", "spherical"])
def test_kit_builds_silently_and_its_example_agrees(
    tmp_path: Path, which: str, formulation: str, compiler: str, arithmetic: str
) -> None:
    write_kit(machine(which), tmp_path / "kit", Choice(formulation))
    code, output = run(build(tmp_path / "kit", compiler, arithmetic))
    assert code == 0, output
    assert "6 of 6 forces agree" in output


@pytest.mark.parametrize(
    ("bake", "scalar", "precision"),
    [(False, False, "double"), (True, False, "float"), (False, True, "float"), (True, True, "double")],
)
@pytest.mark.parametrize("level", fidelity.FIDELITIES)
def test_kit_of_every_level_builds_silently_and_its_example_agrees(
    tmp_path: Path, level: str, bake: bool, scalar: bool, precision: str
) -> None:
    choice = Choice(fidelity=level, bake=bake, precision=precision, scalar=scalar)
    write_kit(machine("dasgupta" if bake else "random"), tmp_path / "kit", choice)
    # Valid C++ where the language makes a difference: in what the printers print of general legs.
    code, output = run(build(tmp_path / "kit", "g++" if level == "general" else "gcc"))
    assert code == 0, output
    assert "6 of 6 forces agree" in output


def test_build_line_of_the_example_and_of_the_readme_works_as_printed(tmp_path: Path) -> None:
    write_kit(machines.dasgupta(), tmp_path)
    for file in ("example.c", "README.md"):
        line = re.search(r"gcc .*", (tmp_path / file).read_text(encoding="utf-8"))
        assert line is not None
        done = subprocess.run(line[0], shell=True, cwd=tmp_path, capture_output=True, text=True, check=False)
        assert (done.returncode, done.stderr) == (0, "")
        (tmp_path / "example").unlink()


@pytest.mark.parametrize("arithmetic", ARITHMETIC)
@pytest.mark.parametrize(
    ("good", "bad"),
    [("REAL(40.0)", "REAL(40.1)"), ("REAL(-9.81)", "REAL(9.81)"), ("{REAL(0.0696)", "{(stewart_real)NAN")],
)
def test_example_fails_with_other_constants_or_pose(
    tmp_path: Path, arithmetic: str, good: str, bad: str
) -> None:
    write_kit(machines.dasgupta(), tmp_path / "kit")
    changed = 0
    for file in ("robot.c", "example.c"):
        path = tmp_path / "kit" / file
        text = path.read_text(encoding="utf-8")
        changed += good in text
        path.write_text("#include <math.h>\n" + text.replace(good, bad), encoding="utf-8")
    assert changed
    code, _ = run(build(tmp_path / "kit", "gcc", arithmetic))
    assert code == 1


@pytest.mark.parametrize("which", ["dasgupta", "random", "spherical"])
def test_constants_reach_the_compiled_robot_to_the_bit(which: str) -> None:
    robot = machine(which)
    files = kit(robot).files
    library = native.load("kit_robot", {name: files[name] for name in ("stewart.h", "robot.h", "robot.c")})
    numbers = kernel.robot_numbers(robot)
    found = (ctypes.c_double * numbers.size).in_dll(library, robot_symbol(robot.name))
    np.testing.assert_array_equal(np.array(found), numbers)


def test_expected_forces_are_those_of_the_c_kernel_and_of_the_reference() -> None:
    robot = machine("random")
    for formulation in ("exact", "paper"):
        motion, forces, _ = sample(robot, formulation)
        for backend in ("c", "reference"):
            F = inverse_dynamics(robot, motion, formulation, backend).F
            np.testing.assert_allclose(forces.F, F, rtol=0, atol=1e-12 * np.abs(F).max())


def test_kernel_files_are_the_committed_ones() -> None:
    for formulation in FORMULATIONS:
        files = kit(machines.dasgupta(), Choice(formulation)).files
        committed = kernel.c_sources(formulation)
        assert {name: files[name] for name in committed} == committed
        assert set(files) - set(committed) == {"robot.h", "robot.c", "example.c", "README.md"}


def test_same_robot_gives_the_same_bytes_in_any_folder_and_under_any_hash_seed(tmp_path: Path) -> None:
    _, first = write_kit(machines.dasgupta(), tmp_path / "a")
    program = f"""
import warnings
from pathlib import Path
from stewart_sym import robots
from stewart_sym.kit import write_kit
warnings.simplefilter("ignore")
write_kit(robots.dasgupta1998(), Path({str(tmp_path / "b")!r}))
"""
    env = {**os.environ, "PYTHONHASHSEED": "12345"}
    subprocess.run([sys.executable, "-c", program], env=env, check=True)
    assert contents(tmp_path / "a") == contents(tmp_path / "b")
    assert sorted(path.name for path in first) == sorted(contents(tmp_path / "a"))


def test_digest_follows_name_and_every_constant() -> None:
    robot = machines.dasgupta()
    variants = [robot, renamed("Other"), dataclasses.replace(robot, M=np.nextafter(robot.M, 41))]
    digests = {re.findall(r"[0-9a-f]{64}", kit(variant).files["README.md"])[0] for variant in variants}
    assert len(digests) == 3
    assert re.findall(r"[0-9a-f]{64}", kit(robot).files["robot.c"])[0] in digests


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


def test_names_without_ascii_letters_get_symbols_of_their_own() -> None:
    symbols = {robot_symbol(name) for name in ("并联机器人", "平台", "***")}
    assert len(symbols) == 3
    assert all(re.fullmatch(r"stewart_robot_[0-9a-f]{12}", symbol) for symbol in symbols)


@pytest.mark.parametrize("compiler", COMPILERS)
def test_any_name_compiles(tmp_path: Path, compiler: str) -> None:
    name = '*/ int x; /* "a" \\n %s @kernel@ //* ??/ ünï 机器人 {0} | `b` \\'
    write_kit(renamed(name), tmp_path / "kit")
    assert run(build(tmp_path / "kit", compiler))[0] == 0


def test_edited_file_is_refused_without_force_and_replaced_with_it(tmp_path: Path) -> None:
    write_kit(machines.dasgupta(), tmp_path)
    fresh = contents(tmp_path)
    (tmp_path / "robot.c").write_text("mine", encoding="utf-8")
    (tmp_path / "README.md").unlink()
    (tmp_path / "notes.txt").write_text("mine too", encoding="utf-8")
    edited = contents(tmp_path)
    with pytest.raises(
        ValueError, match=r"^\S+robot\.c: exists with other content; use --force to overwrite$"
    ):
        write_kit(machines.dasgupta(), tmp_path)
    assert contents(tmp_path) == edited
    write_kit(machines.dasgupta(), tmp_path, force=True)
    assert contents(tmp_path) == {**fresh, "notes.txt": b"mine too"}


def test_second_run_leaves_equal_files_untouched(tmp_path: Path) -> None:
    _, files = write_kit(machines.dasgupta(), tmp_path / "kit")

    def stamps() -> list[tuple[int, int]]:
        return [(path.stat().st_ino, path.stat().st_mtime_ns) for path in files]

    before = stamps()
    assert write_kit(machines.dasgupta(), tmp_path / "kit")[1] == files
    assert stamps() == before


def test_new_folder_has_the_users_mode_and_nothing_lies_beside_it(tmp_path: Path) -> None:
    (tmp_path / "plain").mkdir()
    write_kit(machines.dasgupta(), tmp_path / "deep" / "kit")
    assert (tmp_path / "deep" / "kit").stat().st_mode == (tmp_path / "plain").stat().st_mode
    assert os.listdir(tmp_path / "deep") == ["kit"]


@pytest.mark.parametrize("fault", [OSError(errno.ENOSPC, "No space left on device"), KeyboardInterrupt()])
def test_failure_while_writing_leaves_no_trace(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, fault: BaseException
) -> None:
    fail_at_call(monkeypatch, "write_bytes", 4, fault)
    with pytest.raises((ValueError, KeyboardInterrupt)) as caught:
        write_kit(machines.dasgupta(), tmp_path / "kit")
    assert os.listdir(tmp_path) == []
    if isinstance(fault, OSError):
        assert str(caught.value) == f"{tmp_path / 'kit'}: No space left on device"


@pytest.mark.parametrize("fault", [OSError(errno.EIO, "Input/output error"), KeyboardInterrupt()])
@pytest.mark.parametrize("call", range(1, 10))
def test_failure_while_replacing_leaves_the_old_kit_whole(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, call: int, fault: BaseException
) -> None:
    write_kit(renamed("Old"), tmp_path)
    (tmp_path / "stewart.h").unlink()
    old = contents(tmp_path)
    fail_at_call(monkeypatch, "rename", call, fault)
    with pytest.raises((ValueError, KeyboardInterrupt)):
        write_kit(renamed("New"), tmp_path, force=True)
    assert contents(tmp_path) == old


def fail_at_call(monkeypatch: pytest.MonkeyPatch, method: str, call: int, fault: BaseException) -> None:
    real, calls = getattr(Path, method), [0]

    def failing(self: Path, argument: object) -> object:
        calls[0] += 1
        if calls[0] == call:
            raise fault
        return real(self, argument)

    monkeypatch.setattr(Path, method, failing)


def test_folder_that_cannot_be_written_is_one_line(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("x", encoding="utf-8")
    # The kernel's own file system takes no files, not even root's.
    unwritable = dict.fromkeys((Path("/proc/kit"), Path("/proc/self")), "can't write here")
    blocked = dict.fromkeys((tmp_path / "file", tmp_path / "file" / "kit"), "expected a folder")
    for folder, message in (unwritable | blocked).items():
        with pytest.raises(ValueError, match=rf"\A\S+: {message}.*\Z"):
            write_kit(machines.dasgupta(), folder)
    assert os.listdir(tmp_path) == ["file"]


def test_folder_in_the_place_of_a_file_is_refused_even_with_force(tmp_path: Path) -> None:
    (tmp_path / "robot.h").mkdir()
    with pytest.raises(ValueError, match=r"robot\.h: expected a file or nothing, found a folder"):
        write_kit(machines.dasgupta(), tmp_path, force=True)
    assert os.listdir(tmp_path) == ["robot.h"]


def test_unknown_formulation_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r'^formulation: expected "exact" or "paper", got \'fast\'$'):
        write_kit(machines.dasgupta(), tmp_path / "kit", Choice("fast"))
    assert os.listdir(tmp_path) == []


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
def test_robot_without_a_good_pose_is_refused(tmp_path: Path, case: str) -> None:
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
    names = [quantity.name for quantity in (*notation.LEG, *notation.PLATFORM)]
    numbers = {name: np.asarray(getattr(robot, name)).tolist() for name in names}
    with pytest.raises(ValueError, match=re.escape(message)):
        texts.kit("x", Target("exact"), {**numbers, field: value}, Sample({}, [0.0] * 6, 1.0), "0")
    del numbers[field]
    with pytest.raises(ValueError, match=f"^robot: {field}: missing$"):
        texts.kit("x", Target("exact"), numbers, Sample({}, [0.0] * 6, 1.0), "0")
