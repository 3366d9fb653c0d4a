"""What subcommands write: nothing of others is replaced, nothing is left half-written, by signals neither."""

import contextlib
import itertools
import json
import os
import shutil
import signal
import subprocess
import sys
import types
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from command_line import Fails, Run, folder_state, rejects
from robot_files import PAPERS
from sweeps import FULL

from stewart_sym.cli.main import main
from stewart_sym.io import atomic_write as publish
from stewart_sym.io import interrupts
from stewart_sym.io.atomic_write import RECORD, replaced_file, result_file, result_folder, staged_folder
from stewart_sym.robot.robot import Robot


@pytest.fixture
def at_robot(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The current folder, with the paper's machine in it as robot.toml."""
    monkeypatch.chdir(tmp_path)
    shutil.copy(PAPERS, "robot.toml")
    return tmp_path


@pytest.mark.parametrize(
    ("command", "name"),
    [
        (["identify", "robot.toml", "-o", "."], "trajectory.csv"),
        (["identify", "robot.toml", "-o", "."], "report.txt"),
        (["singularities", "robot.toml", "I", "-o", ".", "--no-plots"], "path.csv"),
        (["simulate", "swing.toml", "-o", ".", "--no-plots"], "run.csv"),
        (["reproduce", "-o", ".", "--no-plots"], "report.txt"),
        (["stability", "-o", ".", "--no-plots"], "stability.txt"),
    ],
)
def test_a_file_of_others_is_not_replaced_without_force(
    at_robot: Path, command: list[str], name: str, fails: Fails
) -> None:
    (at_robot / "swing.toml").write_text(
        'schema = 1\nrobot = "robot.toml"\nduration = 0.01\n[state]\nt = [0.2, 0.0, 0.5]\n'
        'theta = [0.0, 0.0, 0.0]\n[actuation]\ntype = "spring"\nstiffness = 2e5\n'
    )
    (at_robot / name).write_text("mine")
    before = folder_state(at_robot)
    assert fails(*command).endswith(f"{name}: exists with other content; use --force to overwrite")
    assert folder_state(at_robot) == before


RISING = "time,t_x,t_y,t_z,theta_x,theta_y,theta_z\n" + "".join(
    f"{i / 8},0.2,{i * i / 1024},0.5,0,0,0\n" for i in range(9)
)
TO_ONE_FILE = {
    "mine.csv": ["forces", "robot.toml", "path.csv", "-o", "mine.csv"],
    "mine.json": ["forces", "robot.toml", "path.csv", "-o", "forces.csv", "--json", "mine.json"],
    "figures.json": ["check", "robot.toml", "--json", "figures.json"],
    "advice.json": ["generate", "robot.toml", "-o", "kit", "--list", "--json", "advice.json"],
}


@pytest.mark.parametrize("name", TO_ONE_FILE)
@pytest.mark.parametrize(
    "content", ["mine\n", "time,F_1,F_2,F_3,F_4,F_5,F_6\n0,1,2,3,4,5,6\n", '{"mine": 1}\n']
)
def test_a_single_file_of_others_is_not_replaced_without_force(
    at_robot: Path, name: str, content: str, fails: Fails
) -> None:
    """Measured forces begin with the same columns, and other programs write JSON as well."""
    (at_robot / "path.csv").write_text(RISING)
    (at_robot / name).write_text(content)
    before = folder_state(at_robot)
    said = f"stewart-sym: error: {name}: exists with other content; use --force to overwrite"
    assert fails(*TO_ONE_FILE[name]) == said
    assert folder_state(at_robot) == before
    assert main([*TO_ONE_FILE[name], "--force"]) == 0
    assert (at_robot / name).read_text() != content


@pytest.mark.parametrize("name", TO_ONE_FILE)
def test_a_single_file_of_the_same_subcommand_or_an_empty_one_is_replaced(at_robot: Path, name: str) -> None:
    (at_robot / "path.csv").write_text(RISING)
    (at_robot / name).touch()
    assert main(TO_ONE_FILE[name]) == 0
    first = (at_robot / name).read_text()
    (at_robot / "path.csv").write_text(RISING.replace("0.5", "0.51"))
    (at_robot / "robot.toml").write_text(PAPERS.read_text().replace("mass = 40.0", "mass = 41.0"))
    more = ["--reactions"] if name == "mine.csv" else []
    assert main([*TO_ONE_FILE[name], *more]) == 0
    assert name == "advice.json" or (at_robot / name).read_text() != first
    assert main(TO_ONE_FILE[name]) == 0
    assert not (at_robot / RECORD).exists()


def test_a_run_with_columns_of_its_reader_is_not_replaced(at_robot: Path, fails: Fails) -> None:
    (at_robot / "path.csv").write_text(RISING)
    assert main(TO_ONE_FILE["mine.csv"]) == 0
    head, *rows = (at_robot / "mine.csv").read_text().splitlines()
    (at_robot / "mine.csv").write_text("\n".join([f"{head},note", *(f"{row},mine" for row in rows)]))
    assert "mine.csv: exists with other content" in fails(*TO_ONE_FILE["mine.csv"])


def test_the_json_of_another_subcommand_is_not_replaced(at_robot: Path, fails: Fails) -> None:
    assert main(TO_ONE_FILE["figures.json"]) == 0
    asked = [*TO_ONE_FILE["mine.json"][:-1], "figures.json"]
    (at_robot / "path.csv").write_text(RISING)
    assert "figures.json: exists with other content" in fails(*asked)


@pytest.mark.parametrize("name", ["path.csv", "robot.toml"])
@pytest.mark.parametrize("option", ["-o", "--json"])
def test_an_input_is_no_single_file_to_write_by_force_either(
    at_robot: Path, option: str, name: str, fails: Fails
) -> None:
    (at_robot / "path.csv").write_text(RISING)
    before = folder_state(at_robot)
    output = ["-o", name] if option == "-o" else ["-o", "forces.csv", "--json", name]
    line = fails("forces", "robot.toml", "path.csv", *output, "--force")
    assert line.endswith(f"{option} {name}: the file is an input; name another file")
    assert folder_state(at_robot) == before


def test_a_file_that_appears_while_another_is_written_is_not_replaced(tmp_path: Path) -> None:
    path = tmp_path / "x"
    with pytest.raises(ValueError, match="x: exists"), result_file(path, ["ours,"]) as stream:  # noqa: PT012
        stream.write("ours,1")
        path.write_text("mine")
    assert path.read_text() == "mine"
    assert os.listdir(tmp_path) == ["x"]


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
    with pytest.raises(ValueError, match=r"path.csv: is an input; name another folder"):
        fill_results(tmp_path, {"path.csv": "output"}, force=True, inputs=[tmp_path / "link.csv"])
    assert (tmp_path / "path.csv").read_text() == "input"


@pytest.mark.parametrize(
    ("command", "name"),
    [
        (["singularities", "robot.toml", "path.csv"], "path.csv"),
        (["simulate", "track.toml"], "run.csv"),
        (["chart", "enough.toml"], "chart.txt"),
    ],
)
def test_no_file_that_a_subcommand_read_is_replaced_by_force(
    at_robot: Path, command: list[str], name: str, run: Run
) -> None:
    """Files that a scene names are inputs as well."""
    (at_robot / name).write_text(RISING)
    shared = 'schema = 1\nrobot = "robot.toml"\n'
    (at_robot / "track.toml").write_text(
        f'{shared}duration = 0.01\ninitial_state = "path"\n'
        f'[actuation]\ntype = "computed_torque"\npath = "{name}"\nk_p = 900.0\nk_d = 60.0\n'
    )
    (at_robot / "enough.toml").write_text(f'{shared}motions = ["{name}"]\ntolerance = 0.01\n')
    before = folder_state(at_robot)
    told = run(*command, "-o", ".", "--force", "--no-plots", code=2).err
    assert told.endswith(f"error: {name}: is an input; name another folder\n")
    assert folder_state(at_robot) == before


def test_a_pipe_in_place_of_a_file_is_an_error_and_not_read(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "x")
    rejects(r"x: expected a file or nothing, found a device or a pipe", fill_results, tmp_path, {"x": "1"})


def test_an_empty_output_name_is_an_error(run: Run) -> None:
    told = run("forces", PAPERS, "trajectory.csv", "-o", "", code=2).err
    assert "-o/--output: expected a name, got nothing" in told


def test_a_replaced_file_keeps_its_permissions_and_a_new_one_has_the_usual(tmp_path: Path) -> None:
    (tmp_path / "private").write_text("old")
    (tmp_path / "private").chmod(0o600)
    (tmp_path / "usual").touch()
    write_file(tmp_path / "private", "new")
    write_file(tmp_path / "fresh", "new")
    fill_results(tmp_path / "folder", {"private": "old"})
    (tmp_path / "folder" / "private").chmod(0o600)
    fill_results(tmp_path / "folder", {"private": "new", "fresh": "new"})
    usual = (tmp_path / "usual").stat().st_mode & 0o777
    for folder in (tmp_path, tmp_path / "folder"):
        modes = {name: (folder / name).stat().st_mode & 0o777 for name in ("private", "fresh")}
        assert modes == {"private": 0o600, "fresh": usual}


def test_the_longest_file_name_and_what_a_killed_run_left_behind_are_no_hindrance(tmp_path: Path) -> None:
    (tmp_path / f".c.csv.{os.getpid()}.part").touch()
    for name in ("c.csv", "n" * 251 + ".csv"):
        write_file(tmp_path / name, "whole")
        assert (tmp_path / name).read_text() == "whole"


WRITING = """
import sys, time
from pathlib import Path
from stewart_sym.io.atomic_write import replaced_file, staged_folder
with replaced_file(Path(sys.argv[1]) / "file"), staged_folder(Path(sys.argv[1])) as staged:
    (staged / "x").write_text("x")
    print("writing", flush=True)
    time.sleep(60)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="no locks that end with a process")
def test_what_killed_runs_left_behind_is_removed_and_what_others_write_is_not(tmp_path: Path) -> None:
    def temporary() -> list[Path]:
        found = sorted(tmp_path.glob(".stewart-sym-*"))
        for path in found:
            os.utime(path, (0.0, 0.0))
        return found

    command = [sys.executable, "-c", WRITING, str(tmp_path)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout.readline() == "writing\n"
            made = temporary()
            assert [path.is_dir() for path in sorted(made, key=Path.is_dir)] == [False, True]
            write_file(tmp_path / "own", "1")
            assert temporary() == made
        finally:
            process.kill()
    kept = tmp_path / ".stewart-sym-abcdefgh"
    (kept / "old").mkdir(parents=True)
    (kept / "old" / "0").write_text("the only copy")
    temporary()
    with publish.staged_folder(tmp_path):
        pass
    assert temporary() == [kept]
    assert (kept / "old" / "0").read_text() == "the only copy"


def test_out_of_memory_is_one_line(fails: Fails, monkeypatch: pytest.MonkeyPatch) -> None:
    def exhausted(path: Path) -> Robot:
        raise MemoryError("Unable to allocate 4 GiB")

    monkeypatch.setattr(Robot, "from_toml", exhausted)
    line = fails("check", PAPERS)
    assert line.endswith("error: out of memory: Unable to allocate 4 GiB")


NO_ROOM = """
import resource, sys
import numpy as np
import scipy.interpolate, scipy.linalg, stewart_sym.motion.logs
from stewart_sym.cli.main import main
from stewart_sym.motion.log_rates import _spline

used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + (16 << 20), resource.RLIM_INFINITY))
if sys.argv[1] == "cli":
    sys.exit(main(["check", "robot.toml"]))
try:
    _spline(np.arange(2000.0), np.ones((2000, 6)), "log")
except MemoryError:
    print("no room", file=sys.stderr)
    sys.exit(2)
"""


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="needs /proc")
@pytest.mark.parametrize(("where", "line"), [("cli", "out of memory"), ("spline", "no room")])
def test_no_room_for_the_work_area_of_blas_is_an_error_and_no_endless_loop(where: str, line: str) -> None:
    """OpenBLAS tries for ever, where no signal is handled."""
    done = subprocess.run([sys.executable, "-c", NO_ROOM, where], capture_output=True, text=True, timeout=600)
    assert (done.returncode, len(done.stderr.splitlines())) == (2, 1)
    assert line in done.stderr


def test_warnings_turned_into_errors_are_one_line() -> None:
    command = [sys.executable, "-W", "error", "-m", "stewart_sym.cli.main", "check", str(PAPERS)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode in (0, 2)
    assert len(done.stderr.splitlines()) == (done.returncode == 2)


SIGNALLED = """
import json, os, signal, sys
from pathlib import Path
from stewart_sym.cli import main as cli
from stewart_sym.cli.machine import check
from stewart_sym.io import atomic_write as publish

def ended(target, name, ignored, error):
    child = os.fork()
    if child:
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    # A job in the background has some of them ignored, and so would its children.
    default = signal.default_int_handler if name == "SIGINT" else signal.SIG_DFL
    signal.signal(getattr(signal, name), signal.SIG_IGN if ignored else default)

    def run(arguments):
        with publish.staged_folder(Path(target)) as folder:
            (folder / "x").write_text("x")
            try:
                os.kill(os.getpid(), getattr(signal, name))
            except KeyboardInterrupt:
                if error:  # as an extension module that is being imported does
                    raise ImportError(error)
                # as a library does that calls back
        return 0

    check.run = run
    os._exit(cli.main(["check", "none.toml"]))

print([ended(*case) for case in json.loads(sys.argv[1])])
"""


def test_a_signal_ends_a_run_even_where_a_library_swallows_it_and_an_ignored_one_does_not(
    tmp_path: Path,
) -> None:
    kinds = ((False, ""), (False, "initialization failed"), (True, ""))
    signals = itertools.product(("SIGTERM", "SIGHUP", "SIGINT"), kinds)
    cases = [(str(tmp_path / str(i)), name, *kind) for i, (name, kind) in enumerate(signals)]
    command = [sys.executable, "-c", SIGNALLED, json.dumps(cases)]
    done = subprocess.run(command, capture_output=True, text=True)
    codes = [0 if ignored else 128 + getattr(signal, name) for _, name, ignored, _ in cases]
    assert (done.stdout, done.stderr) == (f"{codes}\n", "")
    assert [Path(target).exists() for target, *_ in cases] == [ignored for _, _, ignored, _ in cases]


def write_both(folder: Path) -> None:
    """As a subcommand writes: a folder of two files, of which one is there, and then a file beside it."""
    with interrupts.as_interrupts():
        with result_folder(folder / "results", force=True) as staged:
            (staged / "old").write_text("2")
            (staged / "new").write_text("2")
        write_file(folder / "file", "2")


@contextlib.contextmanager
def signal_at(number: int) -> Iterator[list[int]]:
    """Send SIGTERM before the ``number``-th opcode of writing in this block; yields how many there were."""
    watched = {module.__file__ for module in (publish, interrupts, contextlib)}
    count = [0]

    def trace(frame: types.FrameType, event: str, argument: object) -> Any:
        if frame.f_code.co_filename not in watched:
            return None
        frame.f_trace_opcodes = True
        if event == "opcode" and signal.getsignal(signal.SIGTERM) is not signal.SIG_DFL:
            count[0] += 1
            if count[0] == number:
                os.kill(os.getpid(), signal.SIGTERM)
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        yield count
    finally:
        sys.settrace(before)


@pytest.mark.slow
def test_a_signal_at_any_step_of_writing_leaves_whole_files_and_nothing_else(tmp_path: Path) -> None:
    found = set()
    for number in itertools.count(1, 1 if FULL else 37):
        folder = tmp_path / str(number)
        (folder / "results").mkdir(parents=True)
        (folder / "results" / "old").write_text("1")
        (folder / "file").write_text("1")
        with contextlib.suppress(KeyboardInterrupt), signal_at(number) as count:
            write_both(folder)
            break
        state = {path.relative_to(folder): path.is_dir() or path.read_text()[0] for path in folder.rglob("*")}
        found.add(tuple(sorted((str(name), content) for name, content in state.items())))
    assert 0 < count[0] < number
    results = (("results", True), (f"results/{RECORD}", "{"), ("results/new", "2"), ("results/old", "2"))
    before = (("file", "1"), ("results", True), ("results/old", "1"))
    assert found == {before, (("file", "1"), *results), (("file", "2"), *results)}


def write_file(path: Path, text: str, failure: Exception | None = None) -> None:
    with replaced_file(path) as stream:
        stream.write(text)
        if failure:
            raise failure


def fill_folder(path: Path, names: str, failure: Exception | None = None, gone: str = "") -> None:
    with staged_folder(path, [Path(name) for name in gone]) as folder:
        for name in names:
            (folder / name).write_text(name)
        if failure:
            raise failure


def test_a_file_is_replaced_only_by_a_whole_one(tmp_path: Path) -> None:
    target = tmp_path / "f.csv"
    target.write_text("old")
    with pytest.raises(RuntimeError):
        write_file(target, "half", RuntimeError())
    assert folder_state(tmp_path) == {"f.csv": b"old"}
    write_file(target, "whole")
    assert folder_state(tmp_path) == {"f.csv": b"whole"}


def test_writing_follows_links_and_leaves_devices_alone(tmp_path: Path) -> None:
    (tmp_path / "real").write_text("old")
    (tmp_path / "link").symlink_to("real")
    write_file(tmp_path / "link", "new")
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


def test_a_folder_is_filled_all_or_nothing(tmp_path: Path) -> None:
    target = tmp_path / "a" / "b"
    with pytest.raises(RuntimeError):
        fill_folder(target, "x", RuntimeError())
    assert not list(tmp_path.iterdir())
    fill_folder(target, "xy")
    assert folder_state(target) == {"x": b"x", "y": b"y"}
    (target / "z").mkdir()
    with pytest.raises(IsADirectoryError):
        fill_folder(target, "wz")
    assert folder_state(target) == {"x": b"x", "y": b"y", "z": b"folder"}


@pytest.mark.parametrize("fault", [OSError(5, "Input/output error"), KeyboardInterrupt()])
@pytest.mark.parametrize("call", range(1, 8))
def test_a_folder_whose_filling_fails_is_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, call: int, fault: BaseException
) -> None:
    """Seven moves: an old x aside and a new one in, the same of y, a new z in, and w and v away."""
    target = tmp_path / "a"
    fill_folder(target, "xywv")
    (target / "x").write_text("old")
    before = folder_state(tmp_path)
    real, calls = Path.rename, iter(range(1, 100))

    def failing(self: Path, to: Path) -> Path:
        if next(calls) == call:
            raise fault
        return real(self, to)

    monkeypatch.setattr(Path, "rename", failing)
    with pytest.raises((OSError, KeyboardInterrupt)) as caught:
        fill_folder(target, "xyz", gone="wv")
    assert folder_state(tmp_path) == before
    if isinstance(caught.value, OSError):
        assert caught.value.filename == str(target / "xxyyzwv"[call - 1])
