"""What subcommands write: nothing of others is replaced, nothing is left half-written, by signals neither."""

import os
import shutil
import signal
import subprocess
import sys
from importlib.resources import files
from pathlib import Path
from typing import Any

import pytest

from stewart_sym.cli import main
from stewart_sym.publish import replaced_file, result_folder
from stewart_sym.robot import Robot

PAPER = Path(str(files("stewart_sym.robots") / "dasgupta1998.toml"))


def error(capsys: pytest.CaptureFixture[str], *arguments: object) -> str:
    """The one line of a command that fails."""
    assert main(list(map(str, arguments))) == 2
    (line,) = capsys.readouterr().err.splitlines()
    return line


def folder_state(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def write_file(path: Path, text: str) -> None:
    with replaced_file(path) as stream:
        stream.write(text)


@pytest.mark.parametrize(
    ("command", "name"),
    [
        (["identify", "robot.toml", "-o", "."], "trajectory.csv"),
        (["identify", "robot.toml", "-o", "."], "report.txt"),
        (["singularities", "robot.toml", "I", "-o", ".", "--no-pictures"], "path.csv"),
        (["simulate", "swing.toml", "-o", ".", "--no-pictures"], "run.csv"),
        (["reproduce", "-o", ".", "--no-pictures"], "report.txt"),
        (["control", "-o", ".", "--no-pictures"], "control.csv"),
        (["stability", "-o", ".", "--no-pictures"], "stability.txt"),
    ],
)
def test_a_file_of_others_is_not_replaced_without_force(
    tmp_path: Path,
    command: list[str],
    name: str,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    shutil.copy(PAPER, "robot.toml")
    (tmp_path / "swing.toml").write_text(
        'schema = 1\nrobot = "robot.toml"\nduration = 0.01\n[state]\nt = [0.2, 0.0, 0.5]\n'
        'theta = [0.0, 0.0, 0.0]\n[legs]\nlaw = "springs"\nstiffness = 2e5\n'
    )
    (tmp_path / name).write_text("mine")
    before = folder_state(tmp_path)
    assert error(capsys, *command).endswith(f"{name}: exists with other content; use --force to overwrite")
    assert folder_state(tmp_path) == before


def fill_results(path: Path, texts: dict[str, str], **options: Any) -> None:
    with result_folder(path, **options) as folder:
        for name, text in texts.items():
            (folder / name).write_text(text)


def test_own_results_are_replaced_until_somebody_edits_them(tmp_path: Path) -> None:
    fill_results(tmp_path, {"x": "1", "y": "1"})
    fill_results(tmp_path, {"x": "2"})
    fill_results(tmp_path, {"y": "2"})
    (tmp_path / "x").write_text("edited")
    before = folder_state(tmp_path)
    with pytest.raises(ValueError, match=r"x: exists with other content; use --force to overwrite"):
        fill_results(tmp_path, {"x": "3", "y": "3"})
    assert folder_state(tmp_path) == before
    fill_results(tmp_path, {"x": "3", "y": "3"}, force=True)
    assert (tmp_path / "x").read_text() == "3"


def test_an_input_is_never_replaced(tmp_path: Path) -> None:
    (tmp_path / "path.csv").write_text("input")
    os.link(tmp_path / "path.csv", tmp_path / "link.csv")
    with pytest.raises(ValueError, match=r"path.csv: is an input, name another folder"):
        fill_results(tmp_path, {"path.csv": "output"}, force=True, inputs=[tmp_path / "link.csv"])
    assert (tmp_path / "path.csv").read_text() == "input"


def test_a_pipe_in_place_of_a_file_is_an_error_and_not_read(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "x")
    with pytest.raises(ValueError, match=r"x: expected a file or nothing, found a device or a pipe"):
        fill_results(tmp_path, {"x": "1"})


def test_an_empty_output_name_is_an_error(
    capsys: pytest.CaptureFixture[str],
) -> None:
    with pytest.raises(SystemExit, match="2"):
        main(["forces", str(PAPER), "trajectory.csv", "-o", ""])
    assert "-o/--output: expected a name, got nothing" in capsys.readouterr().err


def test_a_replaced_file_keeps_its_permissions_and_a_new_one_has_the_usual(tmp_path: Path) -> None:
    (tmp_path / "private").write_text("old")
    (tmp_path / "private").chmod(0o600)
    (tmp_path / "usual").touch()
    write_file(tmp_path / "private", "new")
    write_file(tmp_path / "fresh", "new")
    modes = {path.name: path.stat().st_mode & 0o777 for path in tmp_path.iterdir()}
    assert modes == {"private": 0o600, "usual": modes["usual"], "fresh": modes["usual"]}


def test_the_longest_file_name_and_what_a_killed_run_left_behind_are_no_hindrance(tmp_path: Path) -> None:
    (tmp_path / f".c.csv.{os.getpid()}.part").touch()
    for name in ("c.csv", "n" * 251 + ".csv"):
        write_file(tmp_path / name, "whole")
        assert (tmp_path / name).read_text() == "whole"


def test_out_of_memory_is_one_line(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def exhausted(path: Path) -> Robot:
        raise MemoryError("Unable to allocate 4 GiB")

    monkeypatch.setattr(Robot, "from_toml", exhausted)
    line = error(capsys, "check", PAPER)
    assert line.endswith("error: out of memory: Unable to allocate 4 GiB")


def test_warnings_turned_into_errors_are_one_line() -> None:
    command = [sys.executable, "-W", "error", "-m", "stewart_sym.cli", "check", str(PAPER)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode in (0, 2)
    assert len(done.stderr.splitlines()) == (done.returncode == 2)


SIGNALLED = """
import os, signal, sys, warnings
from pathlib import Path
from stewart_sym import cli, publish

def run(arguments):
    with publish.staged_folder(Path(sys.argv[1])) as folder:
        (folder / "x").write_text("x")
        try:
            os.kill(os.getpid(), getattr(signal, sys.argv[2]))
        except KeyboardInterrupt:
            pass  # as a library does that calls back
    return 0

cli._check = run
sys.exit(cli.main(["check", "none.toml"]))
"""


@pytest.mark.parametrize("name", ["SIGTERM", "SIGHUP", "SIGINT"])
@pytest.mark.parametrize("ignored", [False, True])
def test_a_signal_ends_a_run_even_where_a_library_swallows_it_and_an_ignored_one_does_not(
    tmp_path: Path, name: str, ignored: bool
) -> None:
    def ignore() -> None:
        if ignored:
            signal.signal(getattr(signal, name), signal.SIG_IGN)

    target = tmp_path / "out"
    command = [sys.executable, "-c", SIGNALLED, str(target), name]
    done = subprocess.run(command, preexec_fn=ignore, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == ((0, "") if ignored else (130, ""))
    assert target.exists() == ignored
