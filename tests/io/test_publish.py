"""What subcommands write: nothing of others is replaced, and no file is left half-written."""

import contextlib
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from command_line import Fails, Run, folder_state, rejects
from robot_files import PAPERS
from sweeps import FULL

from stewart_sym.cli.main import main
from stewart_sym.io.output import RECORD, ResultFolder, write_file

EXAMPLES = Path(__file__).parents[2] / ".docs" / "examples"
OTHERS = "exists with other content; use --force to overwrite"


@pytest.fixture
def at_robot(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The current folder, with the paper's machine in it as robot.toml, and a path."""
    monkeypatch.chdir(tmp_path)
    shutil.copy(PAPERS, "robot.toml")
    (tmp_path / "path.csv").write_text(RISING)
    return tmp_path


HEADER = "time,t_x,t_y,t_z,theta_x,theta_y,theta_z\n"
RISING = HEADER + "".join(f"{i / 8},0.2,{i * i / 1024},0.5,0,0,0\n" for i in range(9))
FORCES = ["forces", "robot.toml", "path.csv"]
TO_ONE_FILE = {
    "mine.csv": [*FORCES, "-o", "mine.csv"],
    "mine.json": [*FORCES, "-o", "forces.csv", "--json", "mine.json"],
    "report.json": ["singularities", "robot.toml", "I", "-o", ".", "--no-plots"],
}


@pytest.mark.parametrize("name", TO_ONE_FILE)
def test_a_file_of_others_is_not_replaced_without_force(at_robot: Path, name: str, fails: Fails) -> None:
    """Measured forces begin with the same columns as ours."""
    (at_robot / name).write_text("time,F_1,F_2,F_3,F_4,F_5,F_6\n0,1,2,3,4,5,6\n")
    before = folder_state(at_robot)
    assert fails(*TO_ONE_FILE[name]) == f"stewart-sym: error: {name}: {OTHERS}"
    assert folder_state(at_robot) == before
    assert main([*TO_ONE_FILE[name], "--force"]) == 0
    assert folder_state(at_robot)[name] != before[name]


@pytest.mark.parametrize("name", ["mine.csv", "mine.json"])
def test_a_single_file_of_the_same_subcommand_or_an_empty_one_is_replaced(
    at_robot: Path, name: str, fails: Fails
) -> None:
    (at_robot / name).touch()
    assert main(TO_ONE_FILE[name]) == 0
    (at_robot / "path.csv").write_text(RISING.replace("0.5", "0.51"))
    more = ["--reactions"] if name == "mine.csv" else []
    assert main([*TO_ONE_FILE[name], *more]) == 0
    assert main(TO_ONE_FILE[name]) == 0
    assert not (at_robot / RECORD).exists()
    assert main(["check", "robot.toml", "--json", "check.json"]) == 0
    told = fails("generate", "robot.toml", "-o", "kit", "--list", "--json", "check.json")
    assert told.endswith(f"check.json: {OTHERS}")


@pytest.mark.parametrize(
    ("command", "name"),
    [
        ([*FORCES, "-o", "path.csv"], "path.csv"),
        ([*FORCES, "-o", "robot.toml"], "robot.toml"),
        ([*FORCES, "-o", "forces.csv", "--json", "robot.toml"], "robot.toml"),
        (["simulate", "track.toml", "-o", "."], "run.csv"),
    ],
)
def test_an_input_is_not_replaced_by_force_either(
    at_robot: Path, command: list[str], name: str, run: Run
) -> None:
    """Files that a scene names are inputs as well."""
    shutil.copy("path.csv", "run.csv")
    (at_robot / "track.toml").write_text(
        f'schema = 1\nrobot = "robot.toml"\nduration = 0.01\ninitial_state = "path"\n'
        f'[actuation]\ntype = "computed_torque"\npath = "{name}"\nk_p = 900.0\nk_d = 60.0\n'
    )
    before = folder_state(at_robot)
    assert f"{name}: " in run(*command, "--force", code=2).err
    assert folder_state(at_robot) == before


def fill(path: Path, texts: dict[str, str], **options: object) -> None:
    folder = ResultFolder(path, **options)  # type: ignore[arg-type]
    for name, text in texts.items():
        folder.write(name, text)


def test_own_results_are_replaced_until_somebody_edits_them(tmp_path: Path) -> None:
    fill(tmp_path, {"x": "1", "y": "1"})
    fill(tmp_path, {"x": "2"})
    fill(tmp_path, {"y": "2"})
    (tmp_path / "x").write_text("edited")
    before = folder_state(tmp_path)
    rejects(f"x: {OTHERS}", fill, tmp_path, {"x": "3", "y": "3"})
    rejects(f"x: {OTHERS}", fill, tmp_path, {"y": "3"}, names=["x"])
    assert folder_state(tmp_path) == before
    fill(tmp_path, {"x": "edited"})
    fill(tmp_path, {"x": "3"})
    assert (tmp_path / "x").read_text() == "3"


def test_a_link_to_an_input_is_an_input(tmp_path: Path) -> None:
    (tmp_path / "path.csv").write_text("input")
    os.link(tmp_path / "path.csv", tmp_path / "link.csv")
    options = {"force": True, "inputs": [tmp_path / "link.csv"]}
    rejects("path.csv: is an input", fill, tmp_path, {"path.csv": "output"}, **options)


def test_a_file_is_replaced_only_by_a_whole_one(tmp_path: Path) -> None:
    def half() -> object:
        yield "half"
        raise RuntimeError

    (tmp_path / "f.csv").write_text("old")
    with pytest.raises(RuntimeError):
        write_file(tmp_path / "f.csv", half())  # type: ignore[arg-type]
    assert folder_state(tmp_path) == {"f.csv": b"old"}
    with pytest.raises(IsADirectoryError) as caught:
        write_file(tmp_path, "x")
    assert caught.value.filename == str(tmp_path)


def test_writing_keeps_links_and_devices(tmp_path: Path) -> None:
    (tmp_path / "real").write_text("old")
    (tmp_path / "link").symlink_to("real")
    write_file(tmp_path / "link", ["ne", "w"])
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "real").read_text() == "new"
    write_file(Path(os.devnull), "gone")
    assert not Path(os.devnull).is_file()


@pytest.mark.skipif(not Path("/proc/self/fd").is_dir(), reason="no names of open files")
def test_a_pipe_is_written_by_the_name_that_a_shell_gives_it() -> None:
    read, write = os.pipe()
    with open(read, encoding="utf-8") as end:
        write_file(Path(f"/proc/self/fd/{write}"), "through")
        os.close(write)
        assert end.read() == "through"


INTERRUPTED = {
    "export": "hexapod.toml --format urdf -o out/robot.urdf",
    "forces": "hexapod.toml trajectory.csv -o out/f.csv --html out/f.html --json out/f.json",
    "simulate": "swing.toml -o out --no-plots",
    "generate": "hexapod.toml -o out --functions kinematics",
}
SIGNALS = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT)


@pytest.mark.slow
@pytest.mark.parametrize("name", INTERRUPTED if FULL else ["forces"])
def test_a_killed_run_leaves_whole_files(at_robot: Path, name: str) -> None:
    """Real signals at random times, most of them in the second half of a run, where it writes."""
    chance, out = random.Random(name), at_robot / "out"
    for path in (*EXAMPLES.glob("*.toml"), *EXAMPLES.glob("*.csv")):
        shutil.copy(path, at_robot)
    inputs = folder_state(at_robot)
    command = [sys.executable, "-W", "ignore", "-m", "stewart_sym", name, *INTERRUPTED[name].split()]
    began = time.monotonic()
    subprocess.run(command, check=True, capture_output=True)
    seconds, usual = time.monotonic() - began, folder_state(out)
    shutil.rmtree(out)
    for run in range(13 if FULL else 2):
        number = SIGNALS[run % len(SIGNALS)]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(seconds * max(chance.random(), chance.random()))
        process.send_signal(number)
        process.wait()
        for path, content in folder_state(out).items():
            if Path(path).name.startswith(".stewart-sym-"):
                assert number == signal.SIGKILL, path
            elif Path(path).name == RECORD:
                assert json.loads(content)["files"].items() <= json.loads(usual[path])["files"].items()
            else:
                assert content == usual[path], path
        shutil.rmtree(out, ignore_errors=True)
        assert folder_state(at_robot) == inputs
