"""The command line: every subcommand does its job; what goes wrong is one line and leaves nothing behind."""

import os
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from importlib.resources import as_file, files
from pathlib import Path

import numpy as np
import pytest
from command_line import fails_in_one_line, folder_state, read

import stewart_sym as ss
from stewart_sym.backend import kernel
from stewart_sym.cli import main as cli
from stewart_sym.cli import terminal
from stewart_sym.cli.main import main
from stewart_sym.io.extras import install
from stewart_sym.io.writing import RECORD, replaced_file, staged_folder
from stewart_sym.motion.rotation import rpy_from_rotation
from stewart_sym.motion.trajectory import read_csv
from stewart_sym.studies.common.output import csv_lines
from stewart_sym.studies.reports import track

POSES = ("t_x", "t_y", "t_z", "theta_x", "theta_y", "theta_z")


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    """The paper's robot file."""
    target = tmp_path / "robot.toml"
    with as_file(files("stewart_sym.robots") / "dasgupta1998.toml") as source:
        shutil.copy(source, target)
    return target


@pytest.fixture
def trajectory(tmp_path: Path) -> Path:
    """Poses of Path I without derivatives."""
    target = tmp_path / "trajectory.csv"
    time = np.linspace(0.0, 2.0, 21)
    swing = 0.5 - 0.5 * np.cos(np.pi * time / 2)
    columns = {
        "time": time,
        **dict(zip(POSES, (0.1 + 0.1 * swing, 0 * time, 0.4 + 0.1 * swing, *3 * [0.1 * swing]), strict=True)),
    }
    target.write_text("".join(csv_lines(columns)))
    return target


def run(*arguments: object, **options: object) -> "subprocess.CompletedProcess[str]":
    command = [sys.executable, "-m", "stewart_sym.cli.main", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, **options)  # type: ignore[call-overload, no-any-return]


def results(folder: Path) -> list[str]:
    """Names of the files in a folder but its record of them."""
    return sorted(path.name for path in folder.iterdir() if path.name != RECORD)


# reproduce


def test_reproduce_writes_tables_and_curves_without_matplotlib(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    target = tmp_path / "deep" / "out"
    assert main(["reproduce", "--no-pictures", "-o", str(target)]) == 0
    captured = capsys.readouterr()
    assert captured.err == ""
    names = [f"path_{p}_{f}.csv" for p in ("I", "II", "III") for f in ("exact", "paper")]
    assert results(target) == sorted([*names, "report.txt"])
    assert (target / "report.txt").read_text() in captured.out
    rows = read(target / "path_I_paper.csv")
    assert len(rows) == 61
    assert float(rows[0]["F3"]) == pytest.approx(1419.36, abs=0.005)


def test_reproduce_without_matplotlib_says_how_to_get_it_and_writes_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delitem(sys.modules, "stewart_sym.studies.paper.plots", raising=False)
    monkeypatch.delattr("stewart_sym.studies.paper.plots", raising=False)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    line = fails_in_one_line(capsys, "reproduce", "-o", tmp_path / "out")
    assert f"{install('plot')}, or give --no-pictures" in line
    assert not list(tmp_path.iterdir())


def test_reproduce_rejects_a_folder_it_cannot_write_before_computing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def unreachable(*_: object) -> None:
        raise AssertionError("computed before the folder was tried")

    monkeypatch.setattr("stewart_sym.studies.paper.reproduce.reproduce", unreachable)
    (tmp_path / "file").write_text("x")
    line = fails_in_one_line(capsys, "reproduce", "--no-pictures", "-o", tmp_path / "file" / "out")
    assert str(tmp_path / "file" / "out") in line
    assert folder_state(tmp_path) == {"file": b"x"}


def test_reproduce_interrupted_is_quiet_and_leaves_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("stewart_sym.studies.paper.reproduce.reproduce", interrupted)
    assert main(["reproduce", "--no-pictures", "-o", str(tmp_path / "out")]) == 130
    captured = capsys.readouterr()
    assert (captured.out, captured.err) == ("", "")
    assert not list(tmp_path.iterdir())


# check


def test_check_describes_the_papers_machine_and_warns_in_one_line_each(
    robot: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["check", str(robot)]) == 0
    assert capsys.readouterr().err == ""
    accepted = 'accept = ["platform-inertia", "lower-inertia", "upper-inertia"]\n'
    text = robot.read_text(encoding="utf-8")
    assert accepted in text
    robot.write_text(text.replace(accepted, ""), encoding="utf-8")
    assert main(["check", str(robot)]) == 0
    captured = capsys.readouterr()
    for words in (
        "universal below, spherical above",
        "4 kg each",
        "friction     on",
        "length none",
        "home pose",
    ):
        assert words in captured.out
    warnings = captured.err.splitlines()
    assert len(warnings) == 3
    assert all(line.startswith(f"stewart-sym: warning: {robot}: ") for line in warnings)


def test_check_puts_the_home_pose_in_the_middle_of_the_length_limits(
    robot: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    edit(robot, "[leg_defaults.lower]", "[leg_defaults]\nlength_limits = [0.8, 1.2]\n\n[leg_defaults.lower]")
    assert main(["check", str(robot)]) == 0
    out = capsys.readouterr().out
    assert "length 0.8 to 1.2 m" in out
    lengths = next(line for line in out.splitlines() if line.startswith("leg lengths"))
    values = [float(word) for word in lengths[lengths.index("(") + 1 : lengths.index(")")].split(",")]
    assert np.mean(values) == pytest.approx(1.0, abs=0.01)


def test_check_says_when_friction_is_off(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for coefficient in ("0.0001", "0.001", "0.0002"):
        edit(robot, f"= {coefficient}\n", "= 0.0\n")
    assert main(["check", str(robot)]) == 0
    assert "friction     off" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("mass = 40.0", "mas = 40.0", '"mass"'),
        ("mass = 40.0", "mass = -40.0", "platform.mass"),
        ("mass = 40.0", "mass = nan", "platform.mass"),
        ("mass = 40.0", 'mass = "40"', "platform.mass"),
        ("mass = 40.0", "", "platform.mass"),
        ("[0.050, 0.003, 0.004]", "[0.050, 0.9, 0.004]", "symmetric"),
        ("universal_axis = [1.0000, 0.0000, 0.0000]", "universal_axis = [0, 0, 0]", "leg 4: universal_axis"),
        ("[[leg]]\nbase_point = [0.6", "[[leg]]\n[[leg]]\nbase_point = [0.6", "got 7"),
        ("schema = 1", "schema = ", "TOML"),
    ],
)
def test_bad_robot_files_are_rejected_by_every_subcommand(
    robot: Path, trajectory: Path, capsys: pytest.CaptureFixture[str], old: str, new: str, words: str
) -> None:
    edit(robot, old, new)
    before = folder_state(robot.parent)
    for subcommand in (
        ["check", robot],
        ["forces", robot, trajectory, "-o", robot.parent / "f.csv"],
        ["generate", robot, "-o", robot.parent / "kit"],
    ):
        line = fails_in_one_line(capsys, *subcommand)
        assert str(robot) in line
        assert words in line
    assert folder_state(robot.parent) == before


def test_a_missing_robot_file_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert str(tmp_path / "none.toml") in fails_in_one_line(capsys, "check", tmp_path / "none.toml")


# forces


def test_forces_writes_what_the_library_computes(robot: Path, trajectory: Path) -> None:
    output = robot.parent / "forces.csv"
    assert main(["forces", str(robot), str(trajectory), "-o", str(output)]) == 0
    rows = read(output)
    time, motion, *_ = read_csv(trajectory)
    expected = ss.inverse_dynamics(ss.Robot.from_toml(robot), motion)
    for i, row in enumerate(rows):
        assert float(row["time"]) == time[i]
        assert [float(row[f"F{leg}"]) for leg in range(1, 7)] == expected.F[i].tolist()
        assert row["status"] == "0"
    assert list(rows[0])[7:] == [*(f"L{leg}" for leg in range(1, 7)), "condition_number", "status"]
    assert len(rows) == len(time)


@pytest.mark.parametrize("formulation", ["exact", "paper"])
def test_forces_takes_formulation_backend_and_reactions(
    robot: Path, trajectory: Path, capsys: pytest.CaptureFixture[str], formulation: str
) -> None:
    written = []
    for backend in ("c", "numpy", "reference"):
        arguments = ["--formulation", formulation, "--backend", backend, "--reactions", "-o", "-"]
        assert main(["forces", str(robot), str(trajectory), *arguments]) == 0
        written.append(capsys.readouterr().out.splitlines())
    header = written[0][0].split(",")
    assert len(header) == 1 + 12 + 2 + 6 * 16
    values = np.array([[line.split(",") for line in lines[1:]] for lines in written], dtype=np.float64)
    np.testing.assert_allclose(values[1:], np.broadcast_to(values[0], values[1:].shape), rtol=1e-9, atol=1e-9)
    motion = read_csv(trajectory)[1]
    reactions = ss.joint_reactions(ss.Robot.from_toml(robot), motion, formulation)  # type: ignore[arg-type]
    np.testing.assert_array_equal(values[0][:, header.index("F_u3_y")], reactions.F_u[:, 2, 1])
    np.testing.assert_array_equal(values[0][:, header.index("M_u5")], reactions.M_u[:, 4])


def test_forces_warns_of_each_limit_in_one_line_with_its_legs_and_the_worst(
    robot: Path, trajectory: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    limits = "[leg_defaults]\nlength_limits = [0.45, 5]\nforce_limit = 1000\nspeed_limit = 0.01\n"
    edit(robot, "[leg_defaults.lower]", f"{limits}\n[leg_defaults.lower]")
    assert main(["forces", str(robot), str(trajectory), "-o", str(robot.parent / "f.csv")]) == 0
    lines = [line for line in capsys.readouterr().err.splitlines() if "exceeded" in line]
    rows = read(robot.parent / "f.csv")
    time = np.array([float(row["time"]) for row in rows])
    F = np.array([[float(row[f"F{leg}"]) for leg in range(1, 7)] for row in rows])
    over = np.flatnonzero((np.abs(F) > 1000.0).any(axis=0))
    legs = f"leg{'s' if len(over) > 1 else ''} {', '.join(str(leg + 1) for leg in over)}"
    assert [line.split(": warning: ")[1].split(":")[0] for line in lines if "force_limit" in line] == [
        f"force_limit exceeded by {legs}"
    ]
    assert len(lines) == 3
    i, leg = np.unravel_index(np.argmax(np.abs(F)), F.shape)
    held = np.gradient(time)[np.abs(F[:, leg]) > 1000.0].sum()
    worst = f"leg {leg + 1}: {F[i, leg]:.6g} N at {time[i]:g} s, limit 1000 N; beyond it for {held:.3g} s"
    assert any(worst in line for line in lines)
    for name in ("speed_limit", "length_limits"):
        assert any(f"{name} exceeded by leg" in line for line in lines)


@pytest.mark.parametrize(
    ("edit_rows", "words"),
    [
        (lambda rows: [*rows[:3], rows[5], rows[4], *rows[6:]], "increasing times"),
        (lambda rows: [*rows[:3], rows[3] + ",1.0", *rows[4:]], "expected 7 columns, got 8"),
        (lambda rows: [*rows[:3], rows[3].rpartition(",")[0], *rows[4:]], "expected 7 columns, got 6"),
        (lambda rows: [*rows[:3], rows[3].rpartition(",")[0] + ",nan", *rows[4:]], "finite number"),
        (lambda rows: [*rows[:3], rows[3].rpartition(",")[0] + ",inf", *rows[4:]], "finite number"),
        (lambda rows: [rows[0].replace("theta_x", "tetha_x"), *rows[1:]], "tetha_x"),
        (lambda rows: rows[:1], "rows of numbers"),
        (lambda rows: rows[:3], "at least 4 rows"),
        (lambda rows: [], "empty"),
    ],
)
def test_bad_trajectories_are_rejected(
    robot: Path,
    trajectory: Path,
    capsys: pytest.CaptureFixture[str],
    edit_rows: Callable[[list[str]], list[str]],
    words: str,
) -> None:
    rows = edit_rows(trajectory.read_text().splitlines())
    trajectory.write_text("".join(f"{row}\n" for row in rows))
    before = folder_state(robot.parent)
    line = fails_in_one_line(capsys, "forces", robot, trajectory, "-o", robot.parent / "f.csv")
    assert str(trajectory) in line
    assert words in line
    assert folder_state(robot.parent) == before


def test_a_missing_trajectory_is_named(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    missing = robot.parent / "none.csv"
    line = fails_in_one_line(capsys, "forces", robot, missing, "-o", robot.parent / "f.csv")
    assert str(missing) in line
    assert not (robot.parent / "f.csv").exists()


def test_a_pose_without_an_answer_is_rejected_unless_it_is_allowed(
    robot: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    # Leg 1 has length zero at the second instant: t = b_1 - p_1.
    poses = [[0.1, 0.0, 0.4], [0.3, 0.2, -0.1], [0.1, 0.0, 0.5]]
    names = [
        f"{name}_{axis}" for name in ("t", "theta", "v", "theta_dot", "a", "theta_ddot") for axis in "xyz"
    ]
    columns = {"time": 0.1 * np.arange(3.0)} | {name: np.zeros(3) for name in names}
    columns |= dict(zip(names[:3], np.array(poses).T, strict=True))
    trajectory = robot.parent / "short.csv"
    trajectory.write_text("".join(csv_lines(columns)))
    output = robot.parent / "f.csv"
    line = fails_in_one_line(capsys, "forces", robot, trajectory, "-o", output)
    assert line.endswith(f"{trajectory}: row 3: a leg has length zero (leg 1)")
    assert not output.exists()
    assert (
        main(["forces", str(robot), str(trajectory), "-o", str(output), "--allow-singular", "--reactions"])
        == 0
    )
    assert f"{trajectory}: row 3: a leg has length zero (leg 1)" in capsys.readouterr().err
    rows = read(output)
    assert [row["status"] for row in rows] == ["0", "2", "0"]
    assert (rows[1]["F1"], rows[1]["L1"], rows[1]["M_u1"]) == ("nan", "nan", "nan")
    assert np.isfinite(float(rows[2]["L1"]))


def test_an_output_that_cannot_be_written_is_named_before_the_trajectory_is_read(
    robot: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for output in (robot.parent / "no" / "f.csv", robot / "f.csv", robot.parent):
        line = fails_in_one_line(capsys, "forces", robot, robot.parent / "none.csv", "-o", output)
        assert str(output) in line
    assert list(robot.parent.iterdir()) == [robot]


def test_a_full_disk_is_blamed_on_the_output(robot: Path, trajectory: Path) -> None:
    done = run("forces", robot, trajectory, "-o", "/dev/full")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "stewart-sym: error: /dev/full: No space left on device\n"


@pytest.mark.parametrize("arguments", [["check"], ["forces", "-o", "-"]], ids=["check", "forces"])
def test_a_standard_output_that_takes_nothing_is_one_line(
    robot: Path, trajectory: Path, arguments: list[str]
) -> None:
    subcommand, *options = arguments
    inputs = [robot, trajectory][: 1 if subcommand == "check" else 2]
    command = [
        sys.executable,
        "-W",
        "ignore",
        "-m",
        "stewart_sym.cli.main",
        subcommand,
        *map(str, inputs),
        *options,
    ]
    with open("/dev/full", "w") as full:
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True)
    lines = [line for line in done.stderr.splitlines() if "warning" not in line]
    assert done.returncode == 2
    assert lines == ["stewart-sym: error: standard output: No space left on device"]


def test_warnings_come_before_the_error_that_ends_a_command(
    robot: Path, trajectory: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    # Millimetres as leg lengths in m: the likely cause is a warning, what came of it the error.
    lengths = [f"{time},{','.join(6 * [str(900 + time)])}" for time in range(8)]
    header = ",".join(["time", *(f"L_{leg}" for leg in range(1, 7))])
    trajectory.write_text("\n".join([header, *lengths]) + "\n")
    assert main(["forces", str(robot), str(trajectory), "-o", "-"]) == 2
    captured = capsys.readouterr()
    *warned, error = captured.err.splitlines()
    assert captured.out == ""
    assert error.startswith("stewart-sym: error: ")
    assert all(line.startswith("stewart-sym: warning: ") for line in warned)
    assert len([line for line in warned if "beside a machine" in line and "--length-unit mm" in line]) == 1
    assert "--length-unit mm" not in error


def test_a_rejected_compiler_flag_is_not_blamed_on_the_trajectory(
    robot: Path, trajectory: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    kernel.library.cache_clear()
    monkeypatch.setenv("CC", "gcc -ffast-math")
    line = fails_in_one_line(capsys, "forces", robot, trajectory, "-o", robot.parent / "f.csv")
    assert line.startswith("stewart-sym: error: CC: -ffast-math is rejected")
    assert str(trajectory) not in line


def test_reactions_that_overflow_are_a_pose_without_an_answer(
    robot: Path, trajectory: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = track.joint_reactions

    def far(*arguments: object, **options: object) -> ss.Reactions:
        return real(*arguments, **options, bearing=1e308)  # type: ignore[arg-type]

    monkeypatch.setattr(track, "joint_reactions", far)
    read_back = read_csv(trajectory)
    machine = ss.Robot.from_toml(robot)
    with pytest.raises(ValueError, match=r"csv: row 2: an input is not finite, or a result overflows"):
        track.track(machine, read_back, reactions=True)
    with pytest.warns(ss.SingularPoseWarning, match=r"csv: row 2: "):
        columns = track.track(machine, read_back, reactions=True, allow_singular=True).columns
    assert np.all(columns["status"] == 1)
    assert np.all(np.isnan(columns["M_p1_x"]))


def test_forces_does_not_overwrite_its_inputs(
    robot: Path, trajectory: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = folder_state(robot.parent)
    for output in (robot, trajectory):
        assert "is an input" in fails_in_one_line(capsys, "forces", robot, trajectory, "-o", output)
    assert folder_state(robot.parent) == before


def test_a_failed_run_keeps_the_earlier_output(
    robot: Path, trajectory: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    output = robot.parent / "f.csv"
    output.write_text("earlier")
    trajectory.write_text("time\n")
    fails_in_one_line(capsys, "forces", robot, trajectory, "-o", output)
    assert output.read_text() == "earlier"
    assert sorted(p.name for p in robot.parent.iterdir()) == ["f.csv", "robot.toml", "trajectory.csv"]


def test_a_reader_that_goes_away_is_no_traceback(robot: Path) -> None:
    command = f"'{sys.executable}' -W ignore -m stewart_sym.cli.main check '{robot}' | true"
    done = subprocess.run(["sh", "-c", command], capture_output=True, text=True)
    assert done.stderr == ""


# derive


def test_derive_check_tells_which_files_differ(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("stewart_sym.derive.generate.generated_files", _two_files)
    target = tmp_path / "generated"
    assert main(["derive", "-o", str(target)]) == 0
    out = capsys.readouterr().out
    assert "exact" in out
    assert "operations per pose: 10 with friction, 6 without" in out
    assert main(["derive", "--check", "-o", str(target)]) == 0
    assert "all 2 files are as derived" in capsys.readouterr().out
    (target / "c" / "stewart_exact.c").write_text("int y;\n")
    (target / "stray.py").write_text("")
    (target / "exact.py").unlink()
    before = folder_state(target)
    assert main(["derive", "--check", "-o", str(target)]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert lines[-3:] == ["differs: c/stewart_exact.c", "missing: exact.py", "not generated: stray.py"]
    assert folder_state(target) == before


def test_derive_rejects_a_folder_it_cannot_write_before_deriving(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("stewart_sym.derive.generate.generated_files", None)
    (tmp_path / "file").write_text("x")
    for extra in ([], ["--check"]):
        line = fails_in_one_line(capsys, "derive", "-o", tmp_path / "file", *extra)
        assert str(tmp_path / "file") in line
    assert folder_state(tmp_path) == {"file": b"x"}


def test_derive_with_a_file_in_the_way_of_a_folder_leaves_no_trace(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    files = {"__init__.py": "", "assembly.py": "", "c/stewart.h": "", "exact.py": ""}

    def derived(progress: Callable[[str], None]) -> dict[str, str]:
        progress("deriving exact")
        return files

    monkeypatch.setattr("stewart_sym.derive.generate.generated_files", derived)
    (tmp_path / "dd").mkdir()
    for name in ("c", "exact.py"):
        (tmp_path / "dd" / name).write_text("x")
    before = folder_state(tmp_path)
    assert main(["derive", "-o", str(tmp_path / "dd"), "--force"]) == 2
    assert f"{tmp_path / 'dd' / 'c'}: is in the way, expected a folder" in capsys.readouterr().err
    assert folder_state(tmp_path) == before


def _two_files(progress: Callable[[str], None]) -> dict[str, str]:
    progress("deriving exact")
    counts = {"friction": {"total": (4, 3, 2, 1)}, "frictionless": {"total": (3, 2, 1, 0)}}
    return {"exact.py": f"OPERATIONS: dict = {counts}\n", "c/stewart_exact.c": "int x;\n"}


# generate


def test_generate_says_what_folding_the_numbers_in_saves(
    robot: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = robot.parent / "kit"
    assert main(["generate", str(robot), "-o", str(target), "--bake", "--fidelity", "massless"]) == 0
    count = capsys.readouterr().out.splitlines()[-1]
    found = re.fullmatch(r"operations per pose: (\d+), with the numbers folded in (\d+)", count)
    assert found is not None
    assert int(found[2]) < int(found[1])


def test_generate_rejects_a_level_that_there_is_not(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    error = fails_in_one_line(capsys, "generate", robot, "-o", robot.parent / "kit", "--fidelity", "rigid")
    assert "fidelity: expected one of general, " in error
    assert not (robot.parent / "kit").exists()


def test_generate_writes_a_kit_and_replaces_changed_files_only_by_force(
    robot: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = robot.parent / "kit"
    asked = ["generate", str(robot), "-o", str(target), "--formulation", "paper", "--scalar"]
    assert main(asked) == 0
    *listed, count = capsys.readouterr().out.splitlines()
    assert re.fullmatch(r"operations per pose: \d+", count)
    assert listed == sorted(str(path) for path in target.rglob("*") if path.is_file())
    written = folder_state(target)
    (target / "stewart_robot.c").write_text("mine")
    assert "stewart_robot.c" in fails_in_one_line(capsys, *asked)
    assert (target / "stewart_robot.c").read_text() == "mine"
    assert main([*asked, "--force"]) == 0
    assert folder_state(target) == written


def test_generate_lists_the_files_and_writes_none(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = robot.parent / "kit"
    asked = ["generate", str(robot), "-o", str(target), "--functions", "kinematics, reactions"]
    assert main([*asked, "--list"]) == 0
    listed = capsys.readouterr().out.splitlines()
    assert not target.exists()
    assert main(asked) == 0
    assert capsys.readouterr().out.splitlines() == listed


@pytest.mark.slow
def test_generate_that_is_told_to_end_leaves_the_old_kit_whole(robot: Path) -> None:
    """Whenever the signal comes: every file is of one kit or every file is of the other."""
    target = robot.parent / "kit"
    command = [sys.executable, "-m", "stewart_sym.cli.main", "generate", str(robot), "-o", str(target)]
    states = []
    for options in (["--scalar"], ["--bake"]):
        subprocess.run([*command, *options], check=True, capture_output=True)
        states.append(folder_state(target))
    started = time.monotonic()
    subprocess.run([*command, "--scalar"], check=True, capture_output=True)
    needed = time.monotonic() - started
    for turn in range(4):
        process = subprocess.Popen(
            [*command, "--bake" if turn % 2 else "--scalar"], stdout=subprocess.DEVNULL
        )
        time.sleep(needed * (0.75 + 0.05 * turn))
        process.terminate()
        process.wait()
        assert folder_state(target) in states


# singularities


@pytest.fixture
def crossing(tmp_path: Path) -> Path:
    """Path III with its rates every 0.3 s; H is singular between rows 14 and 15."""
    target = tmp_path / "crossing.csv"
    path = ss.PATHS["III"].path
    time = path.times(0.3)
    motion = path.sample(time)
    theta = rpy_from_rotation(motion.R)
    rates = np.gradient(theta, time, axis=0, edge_order=2)
    vectors = {"t": motion.t, "theta": theta, "v": motion.v, "theta_dot": rates, "a": motion.a}
    vectors["theta_ddot"] = np.zeros_like(theta)
    columns = {"time": time}
    columns |= {f"{name}_{axis}": x[:, j] for name, x in vectors.items() for j, axis in enumerate("xyz")}
    target.write_text("".join(csv_lines(columns)))
    return target


def test_forces_warns_of_a_singular_pose_between_samples(
    robot: Path, crossing: Path, trajectory: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    output = robot.parent / "f.csv"
    assert main(["forces", str(robot), str(crossing), "-o", str(output)]) == 0
    (line,) = [line for line in capsys.readouterr().err.splitlines() if "singular" in line]
    found = re.search(r"crosses a singular pose at (\d\.\d{9}) s, between rows 14 and 15: .* - to \+", line)
    assert found is not None, line
    assert float(found[1]) == pytest.approx(3.6705, abs=1e-3)
    assert re.search(
        r"condition number \S+, .* v = \(0\.73\d+, .*\) m/s, omega = \(-0\.75\d+, .*rad/s$", line
    )
    assert len(read(output)) == 21
    assert {row["status"] for row in read(output)} == {"0"}
    assert main(["forces", str(robot), str(trajectory), "-o", str(output)]) == 0
    assert "singular" not in capsys.readouterr().err


def test_forces_of_a_single_instant_are_no_path(robot: Path, crossing: Path) -> None:
    crossing.write_text("".join(crossing.read_text().splitlines(keepends=True)[:2]))
    assert main(["forces", str(robot), str(crossing), "-o", str(robot.parent / "f.csv")]) == 0


def test_singularities_reports_time_twist_and_signs(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = robot.parent / "found"
    assert main(["singularities", str(robot), "III", "-o", str(folder)]) == 0
    assert results(folder) == [
        "crossing_1.png",
        "events.csv",
        "path.csv",
        "path.png",
        "report.txt",
    ]
    text = (folder / "report.txt").read_text()
    assert capsys.readouterr().out.startswith(text)
    assert "Crossing 1 at 3.670504110" in text
    assert "det H          - before, + after" in text
    assert "most affected  leg 2: -inf before, +inf after" in text
    assert "unconstrained  v = (0.733923, 0.305677, -0.535366) m/s" in text
    (event,) = read(folder / "events.csv")
    assert (event["crossing"], event["side_before"], event["side_after"]) == ("1", "-1", "1")
    assert float(event["A1"]) == pytest.approx(-27554.33, rel=1e-6)
    sides = [float(row["F2"]) for row in read(folder / "path.csv") if abs(float(row["time"]) - 3.6705) < 0.05]
    assert min(sides) < -1e6
    assert max(sides) > 1e6


def test_singularities_of_a_path_that_crosses_none(
    robot: Path, trajectory: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = robot.parent / "found"
    assert main(["singularities", str(robot), str(trajectory), "-o", str(folder), "--no-pictures"]) == 0
    assert results(folder) == ["events.csv", "path.csv", "report.txt"]
    out = capsys.readouterr().out
    assert "crossings  0" in out
    assert "Nearest approach at" in out
    events = read(folder / "events.csv")
    assert {event["crossing"] for event in events} == {"0"}


def test_singularities_rejects_in_one_line(
    robot: Path, trajectory: Path, crossing: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = robot.parent / "found"
    line = fails_in_one_line(capsys, "singularities", robot, "IV", "-o", folder)
    assert line.endswith("IV: expected I, II, III or a CSV file, there is no such file")
    start = ["--start", *"000000"]
    for path in (trajectory, "III"):
        line = fails_in_one_line(capsys, "singularities", robot, path, "-o", folder, *start)
        assert "--start: is for a trajectory of leg lengths" in line
    crossing.write_text("".join(crossing.read_text().splitlines(keepends=True)[:2]))
    line = fails_in_one_line(capsys, "singularities", robot, crossing, "-o", folder)
    assert line.endswith("expected at least 2 instants, got 1")
    assert not folder.exists()


# the command as a whole


@pytest.mark.parametrize(
    "subcommand",
    ["reproduce", "check", "forces", "singularities", "derive", "generate", "control", "controller"],
)
def test_help_shows_an_example(subcommand: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit, match="0"):
        main([subcommand, "--help"])
    assert f"Example: stewart-sym {subcommand}" in " ".join(capsys.readouterr().out.split())


@pytest.mark.parametrize("arguments", [[], ["chek"], ["check"], ["forces", "a", "b"], ["check", "a", "--x"]])
def test_a_wrong_command_is_one_line_that_names_the_help(
    arguments: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert "--help" in fails_in_one_line(capsys, *arguments)


def test_version(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit, match="0"):
        main(["--version"])
    assert capsys.readouterr().out.startswith("stewart-sym 0.")


def test_checking_a_robot_loads_nothing_heavy(robot: Path) -> None:
    code = "import sys; from stewart_sym.cli.main import main; main(sys.argv[1:]); print(*sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", code, "check", str(robot)], capture_output=True, text=True, check=True
    )
    loaded = set(done.stdout.split())
    assert not loaded & {"sympy", "scipy", "matplotlib"}


def test_progress_shows_on_a_terminal_and_leaves_no_line(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    with terminal.progress_line() as progress:
        progress("working")
    assert capsys.readouterr().err == ""
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    with terminal.progress_line() as progress:
        progress("working")
    assert capsys.readouterr().err == "\r\x1b[Kworking ...\r\x1b[K"


# writing


@pytest.mark.parametrize("subcommand", ["reproduce", "control"])
def test_the_default_folder_is_no_part_of_the_repository(subcommand: str) -> None:
    folder = cli._parser().parse_args([subcommand]).output
    ignored = (Path(__file__).parents[2] / ".gitignore").read_text().splitlines()
    assert f"/{folder}/" in ignored


def write_file(path: Path, text: str, failure: Exception | None = None) -> None:
    with replaced_file(path) as stream:
        stream.write(text)
        if failure:
            raise failure


def fill_folder(path: Path, names: str, failure: Exception | None = None) -> None:
    with staged_folder(path) as folder:
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
@pytest.mark.parametrize("call", range(1, 6))
def test_a_folder_whose_filling_fails_is_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, call: int, fault: BaseException
) -> None:
    """Five moves: an old x aside and a new one in, an old y aside and a new one in, a new z in."""
    target = tmp_path / "a"
    fill_folder(target, "xyw")
    (target / "x").write_text("old")
    before = folder_state(tmp_path)
    real, calls = Path.rename, iter(range(1, 100))

    def failing(self: Path, to: Path) -> Path:
        if next(calls) == call:
            raise fault
        return real(self, to)

    monkeypatch.setattr(Path, "rename", failing)
    with pytest.raises((OSError, KeyboardInterrupt)) as caught:
        fill_folder(target, "xyz")
    assert folder_state(tmp_path) == before
    if isinstance(caught.value, OSError):
        assert caught.value.filename == str(target / "xxyyz"[call - 1])


def edit(path: Path, old: str, new: str) -> None:
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))
