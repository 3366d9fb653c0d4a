"""Files that are no robot, scene or trajectory: rejected in one line, in bounded time and memory.

The fuzzer of fuzz_files.py starts from sound files; what it can't reach by changing bytes stands here.
"""

import copy
import functools
import importlib.util
import itertools
import os
import resource
import socket
import subprocess
import sys
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import attack_build
import numpy as np
import pytest
from command_line import Run, rejects
from hypothesis import given, settings
from hypothesis import strategies as st
from robot_files import PAPERS, PRESS
from sweeps import share

import stewart_sym as ss
from stewart_sym.motion.log_reader import FORCES as FORCE_NAMES
from stewart_sym.motion.log_reader import PLAIN, read_csv, read_leg_columns, read_log
from stewart_sym.simulation.scene import read_scene

ROBOT = PAPERS.read_bytes()
SCENE = b"""schema = 1
robot = "robot.toml"
duration = 2.0
[state]
t = [0.2, 0.0, 0.5]
theta = [0.0, 0.0, 0.0]
[actuation]
type = "spring"
stiffness = 2e5
"""
POSES = b"time,t_x,t_y,t_z,theta_x,theta_y,theta_z\n" + b"".join(
    b"%d,0.2,0,0.5,0,0,0\n" % i for i in range(6)
)
read_forces = functools.partial(read_leg_columns, form=PLAIN, groups=(FORCE_NAMES,))
FORCES = b"time,F_1,F_2,F_3,F_4,F_5,F_6\n0,1,2,3,4,5,6\n"

READERS: dict[str, tuple[Callable[[Any], Any], bytes]] = {
    "robot": (ss.Robot.from_toml, ROBOT),
    "scene": (read_scene, SCENE),
    "poses": (read_csv, POSES),
    "motion": (read_log, POSES),
    "forces": (read_forces, FORCES),
    "robot of schema 2": (ss.Robot.from_toml, ss.robots.text("rubin_camera").encode()),
}
TOML = ("robot", "scene", "robot of schema 2")
NAME = b'name = "x"\n'
MASS = b"mass = 40.0"
MILLIONS = 5_000_000

pytestmark = pytest.mark.filterwarnings("ignore::stewart_sym.robot.robot.RobotWarning")


def rejected(read: Callable[[Any], Any], path: Path) -> str:
    """The line in which a file is rejected, without its name."""
    with pytest.raises(ValueError) as caught:  # noqa: PT011 # the line is what is looked at
        read(path)
    text = str(caught.value)
    assert text.isprintable()
    assert text.startswith(f"{path}: ")
    rest = text.removeprefix(f"{path}: ")
    assert len(rest) < 600
    return rest


def written(folder: Path, data: bytes) -> Path:
    (folder / "robot.toml").write_bytes(ROBOT)
    path = folder / "file"
    path.write_bytes(data)
    return path


@pytest.mark.parametrize("name", READERS)
def test_the_sound_files_are_read(name: str, tmp_path: Path) -> None:
    read, sound = READERS[name]
    path = written(tmp_path, sound)
    assert read(path) is not None
    assert read(os.fsencode(path)) is not None
    assert read(written(tmp_path, b"\xef\xbb\xbf" + sound.replace(b"\n", b"\r\n"))) is not None


@pytest.mark.parametrize("name", READERS)
@pytest.mark.parametrize(
    ("spoil", "told"),
    [
        (lambda sound: sound.decode().encode("utf-16")[:-1], "UTF-8"),
        (lambda sound: sound + "# Größe".encode("latin-1"), "UTF-8"),
        (lambda sound: sound.decode().encode("utf-16-le"), ""),
        (lambda sound: sound + b"\0", ""),
        (lambda sound: sound[: len(sound) // 4], ""),
        (lambda sound: b"\x7fELF" + bytes(range(128)) * 10, ""),
        (lambda sound: b'"' * 100_001, ""),
        (lambda sound: "\u202e\u2028\u2029\u0085".encode() + sound, ""),
        (lambda sound: b"", ""),
    ],
)
def test_odd_bytes_are_no_file(name: str, spoil: Callable[[bytes], bytes], told: str, tmp_path: Path) -> None:
    read, sound = READERS[name]
    assert told in rejected(read, written(tmp_path, spoil(sound)))


@pytest.mark.parametrize("name", READERS)
def test_the_first_byte_that_is_no_utf_8_is_named(name: str, tmp_path: Path) -> None:
    read, sound = READERS[name]
    told = rejected(read, written(tmp_path, sound + b"# \xb5"))
    assert told == f"expected UTF-8 text, byte {len(sound) + 2} is not: save it as UTF-8"


@pytest.mark.parametrize(
    "value",
    [
        b"0x" + b"F" * 5000,
        b"9" * 5000,
        b"1e400",
        b"-inf",
        b"nan",
        b"true",
        b"1979-05-27T07:32:00Z",
        b'"\\u0000\\n"',
        b"[" * 50_000 + b"]" * 50_000,
        b"{a=" * 20_000 + b"1" + b"}" * 20_000,
        b'"' + b"x" * 100_000 + b'"',
        b"40.0\nmass = 41.0",
    ],
    ids=lambda value: value[:12].decode(),
)
def test_values_that_are_no_mass_are_rejected(value: bytes, tmp_path: Path) -> None:
    told = rejected(ss.Robot.from_toml, written(tmp_path, ROBOT.replace(MASS, b"mass = " + value)))
    assert told.startswith(("platform.body.mass: ", "not valid TOML: "))


def repeated(line: bytes) -> bytes:
    return line * (10_000_000 // len(line))


HUGE = {
    "tables": repeated(b"[[leg]]\n"),
    "blank": POSES + repeated(b" " * 9 + b"\n"),
    "digits": POSES + b"9," + b"1" * MILLIONS + b",0,0,0,0,0\n",
    "copies": POSES + repeated(b"9,0,0,0,0,0,0\n"),
    "quote": b'"' + b"x" * 2 * MILLIONS,
}


@pytest.mark.parametrize(
    "name",
    [name if name in ("tables", "digits") else pytest.param(name, marks=pytest.mark.slow) for name in HUGE],
)
def test_ten_megabytes_are_read_or_rejected_in_seconds_and_little_memory(name: str, tmp_path: Path) -> None:
    """Each reader in a process of its own with a gigabyte and 20 s of processor time."""
    path = written(tmp_path, HUGE[name])
    code = (
        "import sys, warnings\nwarnings.simplefilter('ignore')\n"
        "from stewart_sym.robot.robot import Robot\nfrom stewart_sym.simulation.scene import read_scene\n"
        "from stewart_sym.motion.log_reader import FORCES, PLAIN, read_leg_columns, read_log\n"
        "read_forces = lambda path: read_leg_columns(path, PLAIN, (FORCES,))\n"
        "for read in (Robot.from_toml, read_scene, read_log, read_forces):\n"
        "    try:\n        read(sys.argv[1])\n    except ValueError as error:\n        print(error)\n"
    )

    def bounded() -> None:
        resource.setrlimit(resource.RLIMIT_CPU, (20, 20))
        resource.setrlimit(resource.RLIMIT_DATA, (1 << 30, 1 << 30))

    done = subprocess.run(
        [sys.executable, "-c", code, str(path)], capture_output=True, text=True, preexec_fn=bounded
    )
    assert (done.returncode, done.stderr) == (0, "")
    lines = done.stdout.splitlines()
    # A trajectory followed by blank lines, or by copies of one row, is sound.
    assert len(lines) == (3 if name in ("blank", "copies") else 4)
    assert all(line.startswith(f"{path}: ") and len(line) < 900 for line in lines)


# What is no file


@pytest.mark.parametrize("name", READERS)
@pytest.mark.parametrize(
    "place", ["/dev/zero", "/dev/null", "/dev/urandom", "/", "no/such/file", "", "x" * 5000]
)
def test_what_is_no_file_is_rejected(
    name: str, place: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    rejects("cannot read the ", READERS[name][0], place)


@pytest.mark.parametrize("name", READERS)
def test_links_in_circles_sockets_and_closed_files_are_rejected(name: str, tmp_path: Path) -> None:
    read, sound = READERS[name]
    circle = tmp_path / "circle"
    circle.symlink_to(circle)
    assert "cannot read" in rejected(read, circle)
    with socket.socket(socket.AF_UNIX) as ear:
        ear.bind(str(tmp_path / "ear"))
        assert "cannot read" in rejected(read, tmp_path / "ear")
    closed = written(tmp_path, sound)
    closed.chmod(0)
    if not os.access(closed, os.R_OK):
        assert "cannot read" in rejected(read, closed)


def test_a_pipe_is_read_to_its_end_and_no_further_than_a_file(tmp_path: Path) -> None:
    script = "from stewart_sym.robot.robot import Robot; print(Robot.from_toml('/dev/stdin').M)"
    command = [sys.executable, "-W", "ignore", "-c", script]
    assert subprocess.run(command, input=ROBOT, capture_output=True).stdout == b"40.0\n"
    done = subprocess.run(command, input=b"#" * 3 * MILLIONS, capture_output=True)
    assert done.stderr.splitlines()[-1].endswith(b"longer than 262,144 bytes")


# Tables with something else in one place

# What UTF-8 can encode, without encoding every character to see whether it can.
CHARACTERS = st.characters(exclude_categories=["Cs"])
ODD = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.floats(),
    st.text(CHARACTERS, max_size=5),
    st.binary(max_size=3),
    st.sampled_from([10**400, 1e308, -1e308, 5e-324, 0.0, -0.0, 0, 1]),
    st.lists(st.floats(), max_size=4),
    st.dictionaries(st.text(CHARACTERS, max_size=3), st.integers(), max_size=2),
    st.sampled_from([np.float32(2.0), np.int64(3), np.zeros(3), np.eye(3), object(), range(3), 1j]),
)


@functools.cache
def sound_tables(schema: int) -> dict[str, Any]:
    if schema == 1:
        return ss.robots.dasgupta1998().to_dict()
    tables = tomllib.loads(PRESS + "damping = { prismatic = 3.0 }\nstroke = [-150, 150]\n")
    tables["leg"] = {"3": {"lower": {"mass": 2.0, "center_of_mass": [300, 0, 0], "inertia": [0.1, 0.2, 0.2]}}}
    plate = {**tables["platform"]["body"], "inner_radius": 10.0, "axis": [1, 0, 0]}
    box = {"shape": "box", "size": [100.0, 100.0, 50.0], "density": 2700.0, "center": [0.0, 0.0, 30.0]}
    tables["platform"]["body"] = [plate, box]
    tables["base"]["z"] = -100.0
    return tables


@st.composite
def spoilt_tables(draw: st.DrawFn) -> dict[str, Any]:
    top = copy.deepcopy(sound_tables(draw(st.sampled_from([1, 2]))))
    for _ in range(draw(st.integers(1, 3))):
        place: Any = top
        while True:
            keys = list(place) if isinstance(place, dict) else list(range(len(place)))
            key = draw(st.sampled_from(keys))
            if not isinstance(place[key], dict | list) or not place[key] or draw(st.booleans()):
                break
            place = place[key]
        deed = draw(st.sampled_from(["replace", "remove", "add"]))
        if deed == "remove":
            del place[key]
        elif deed == "add" and isinstance(place, dict):
            place[draw(st.text(CHARACTERS, max_size=4))] = draw(ODD)
        else:
            place[key] = draw(ODD)
        if not top:
            break
    return top


@settings(derandomize=True, deadline=None, max_examples=share(240, 6))
@given(spoilt_tables())
def test_spoilt_tables_are_rejected_in_one_line_or_make_a_sound_robot(tables: dict[str, Any]) -> None:
    told = "robot: "
    try:
        robot = ss.Robot.from_dict(tables)
    except ValueError as error:
        robot, told = None, str(error)
    assert told.startswith("robot: ")
    assert told.isprintable()
    if robot is None:
        return
    limits = ("length_limits", "force_limit", "speed_limit", "joint_angle_limit")
    numbers = [value for name, value in vars(robot).items() if name not in limits]
    assert all(np.isfinite(value).all() for value in numbers if isinstance(value, np.ndarray))
    assert ss.Robot.from_dict(robot.to_dict()).to_dict() == robot.to_dict()


@pytest.mark.slow
def test_fuzzing_the_readers_finds_nothing(tmp_path: Path) -> None:
    if importlib.util.find_spec("atheris") is None:
        pytest.skip("atheris is not installed: it has wheels for Linux on x86-64 alone")
    for number, (name, (_, sound)) in enumerate(READERS.items()):
        if name != "motion":
            (tmp_path / name).write_bytes(bytes([max(number - 1, 0) if number > 1 else number]) + sound)
    script = str(Path(__file__).parents[1] / "support" / "fuzz_files.py")
    runs = share(50_000, 50)
    # A process begins with the largest size that the one which started it ever had.
    most = 2048 + resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
    limits = [f"-runs={runs}", "-seed=1", "-max_len=4096", f"-rss_limit_mb={most}"]
    limits += [f"-artifact_prefix={tmp_path}{os.sep}"]
    told = attack_build.ran([sys.executable, script, *limits, str(tmp_path)], tmp_path)
    assert f"Done {runs} runs" in told


KINDS = {
    "robot file": (ROBOT.decode(), ["check"]),
    "scene of simulate": (
        'schema = 1\nrobot = "robot.toml"\nduration = 1.0\n[actuation]\ntype = "constant_force"\n',
        ["simulate", "-o", "out"],
    ),
    "scene of choose-fidelity": (
        'schema = 1\nrobot = "robot.toml"\nmotions = ["I"]\ntolerance = 0.01\n',
        ["choose-fidelity"],
    ),
}


@pytest.mark.parametrize("kind", KINDS)
def test_a_mistake_is_placed_at_its_line(kind: str, tmp_path: Path, run: Run) -> None:
    (tmp_path / "robot.toml").write_bytes(ROBOT)
    text, (command, *options) = KINDS[kind]
    schema = next(line for line in text.splitlines() if line.startswith("schema = "))
    (tmp_path / "file.toml").write_text(text.replace(schema, f"{schema}\n\nmistake = 1", 1))
    line = text.splitlines().index(schema) + 3
    told = run(command, tmp_path / "file.toml", *options, code=2).err
    assert "file.toml: mistake: unknown key, " in told
    assert told.endswith(f" (at line {line})\n")


@pytest.mark.parametrize(("expected", "got"), list(itertools.permutations(KINDS, 2)))
def test_a_file_of_another_kind_is_called_that(tmp_path: Path, expected: str, got: str, run: Run) -> None:
    (tmp_path / "file.toml").write_text(KINDS[got][0])
    command, *options = KINDS[expected][1]
    told = run(command, tmp_path / "file.toml", *options, code=2).err
    assert told.endswith(f"file.toml: expected a {expected}, got a {got}\n")
