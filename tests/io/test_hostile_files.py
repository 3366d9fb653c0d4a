"""Files that are no robot, scene or trajectory: rejected in one line, in bounded time and memory.

The fuzzer of fuzz_files.py starts from sound files; what it can't reach by changing bytes stands here.
"""

import os
import socket
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from command_line import Run, rejects
from plain_logs import read_log
from robot_files import PAPERS

import stewart_sym as ss
from stewart_sym.motion.log_samples import read_samples
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
FORCES = b"time,F_1,F_2,F_3,F_4,F_5,F_6\n0,1,2,3,4,5,6\n"

READERS: dict[str, tuple[Callable[[Any], Any], bytes]] = {
    "robot": (ss.Robot.from_toml, ROBOT),
    "scene": (read_scene, SCENE),
    "motion": (read_log, POSES),
    "forces": (lambda path: read_samples(os.fsdecode(path), forces=True), FORCES),
}
MASS = b"mass = 40.0"

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


ODD_BYTES: dict[str, Callable[[bytes], bytes]] = {
    "zero": lambda sound: sound + b"\0",
    "cut off": lambda sound: sound[: len(sound) // 4],
    "program": lambda sound: b"\x7fELF" + bytes(range(128)) * 10,
    "quotes": lambda sound: b'"' * 100_001,
    "marks": lambda sound: "\u202e\u2028\u2029\u0085".encode() + sound,
    "empty": lambda sound: b"",
}


# A table leaves out rows without numbers.
LEFT_OUT = {"zero"}


@pytest.mark.parametrize("name", READERS)
def test_odd_bytes_are_rejected(name: str, tmp_path: Path) -> None:
    read, sound = READERS[name]
    is_table = name in ("motion", "forces")
    for odd in ODD_BYTES.keys() - (LEFT_OUT if is_table else set()):
        rejected(read, written(tmp_path, ODD_BYTES[odd](sound)))
    if not is_table:
        told = rejected(read, written(tmp_path, sound + b"# \xb5"))
        assert told == f"expected UTF-8 text, byte {len(sound) + 2} is not: save it as UTF-8"


@pytest.mark.parametrize(
    "value",
    [
        b"1e400",
        b"true",
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


# What is no file


@pytest.mark.parametrize("name", READERS)
def test_what_is_no_file_is_rejected(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("circle").symlink_to("circle")
    with socket.socket(socket.AF_UNIX) as ear:
        ear.bind("ear")
        for place in ("/", "no/such/file", "", "x" * 5000, "circle", "ear"):
            rejects("cannot read the ", READERS[name][0], place)


@pytest.mark.slow
def test_a_pipe_is_read_to_its_end() -> None:
    script = "from stewart_sym.robot.robot import Robot; print(Robot.from_toml('/dev/stdin').M)"
    command = [sys.executable, "-W", "ignore", "-c", script]
    assert subprocess.run(command, input=ROBOT, capture_output=True).stdout == b"40.0\n"


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
