"""The command line: every subcommand does its job; what goes wrong is one line and leaves nothing behind."""

import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from command_files import edit, results
from command_line import Fails, Run, folder_state, read
from kits import few_vectors

from stewart_sym.cli import main as cli

EXAMPLES = Path(__file__).parents[2] / ".docs/examples"

# reproduce


def test_reproduce_writes_tables_and_curves_without_matplotlib(
    tmp_path: Path, run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    target = tmp_path / "deep" / "out"
    captured = run("reproduce", "--no-plots", "-o", target)
    assert captured.err == ""
    names = [f"path_{p}_{f}.csv" for p in ("I", "II", "III") for f in ("exact", "paper")]
    assert results(target) == sorted([*names, "report.json", "report.txt"])
    assert (target / "report.txt").read_text() in captured.out
    rows = read(target / "path_I_paper.csv")
    assert len(rows) == 61
    assert float(rows[0]["F_3"]) == pytest.approx(1419.36, abs=0.005)


def test_without_matplotlib_a_study_says_how_to_get_it_and_writes_nothing(
    tmp_path: Path, fails: Fails, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    line = fails("reproduce", "-o", tmp_path / "out")
    assert line.endswith('pip install "stewart-sym[plot]", or use --no-plots')
    assert not list(tmp_path.iterdir())


def test_check_describes_the_papers_machine_and_warns_in_one_line_each(robot: Path, run: Run) -> None:
    assert run("check", robot).err == ""
    accepted = 'suppress_warnings = ["platform-inertia", "lower-inertia", "upper-inertia"]\n'
    text = robot.read_text(encoding="utf-8")
    assert accepted in text
    robot.write_text(text.replace(accepted, ""), encoding="utf-8")
    captured = run("check", robot)
    assert "universal at the base, spherical at the platform" in captured.out
    warnings = captured.err.splitlines()
    assert len(warnings) == 3
    assert all(line.startswith(f"stewart-sym: warning: {robot}: ") for line in warnings)


@pytest.mark.parametrize(
    "words", [("generate", "-o", "kit"), ("singularities", "III"), ("workspace", "--min-clearance", "0.01")]
)
def test_a_subcommand_without_offset_joints_says_so_with_a_remedy(
    words: tuple[str, ...], fails: Fails, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    robot = tmp_path / "robot.toml"
    robot.write_text((EXAMPLES / "offset-joints.toml").read_text())
    line = fails(words[0], robot, *words[1:])
    assert line.startswith(
        f"stewart-sym: error: {robot}: offsets: expected none, because {words[0]} does not"
    )
    assert line.endswith("; delete offsets and cross of the legs to neglect them")


@pytest.mark.parametrize(
    ("subcommand", "name", "words"),
    [
        ("simulate", "via.toml", "expected a scene of simulate, got a file of via poses"),
        ("simulate", "enough.toml", "expected a scene of simulate, got a scene of choose-fidelity"),
        ("plan", "swing.toml", "expected a file of via poses, got a scene of simulate"),
        ("choose-fidelity", "hexapod.toml", "expected a scene of choose-fidelity, got a robot file"),
    ],
)
def test_a_file_for_another_subcommand_is_named(subcommand: str, name: str, words: str, fails: Fails) -> None:
    output = () if subcommand == "choose-fidelity" else ("-o", "out")
    assert fails(subcommand, EXAMPLES / name, *output).endswith(f"{name}: {words}")


def test_a_closed_pipe_ends_quietly_with_the_code_of_its_signal(robot: Path) -> None:
    command = [sys.executable, "-u", "-m", "stewart_sym", "check", str(robot)]
    reading, writing = os.pipe()
    os.close(reading)
    with open(writing, "w") as pipe:
        done = subprocess.run(command, stdout=pipe, stderr=subprocess.PIPE, text=True)
    assert done.returncode == 141
    assert "error" not in done.stderr


def test_a_full_device_is_named(trajectory: Path, fails: Fails) -> None:
    assert fails("convert", trajectory, "-o", "/dev/full").endswith(": /dev/full: No space left on device")


def test_view_reads_the_folder_of_a_plan_and_names_what_it_expects(
    robot: Path, trajectory: Path, run: Run, fails: Fails, tmp_path: Path
) -> None:
    folder = tmp_path / "plan"
    folder.mkdir()
    line = fails("view", robot, folder, "-o", tmp_path / "page.html")
    assert line.endswith("plan: expected I, II, III, a CSV file, or the folder of simulate or plan")
    trajectory.rename(folder / "trajectory.csv")
    run("view", robot, folder, "-o", tmp_path / "page.html")
    assert (tmp_path / "page.html").exists()


def test_bad_robot_files_are_rejected_by_all_subcommands(robot: Path, trajectory: Path, fails: Fails) -> None:
    edit(robot, "mass = 40.0", "mass = -40.0")
    before = folder_state(robot.parent)
    for subcommand in (
        ["check", robot],
        ["forces", robot, trajectory, "-o", robot.parent / "f.csv"],
        ["generate", robot, "-o", robot.parent / "kit"],
    ):
        assert f"{robot}: platform.body.mass: " in fails(*subcommand)
    assert folder_state(robot.parent) == before


def test_derive_check_tells_what_differs(tmp_path: Path, run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("stewart_sym.derive.generated_files.generated_files", _three_files)
    target = tmp_path / "generated"
    out = run("derive", "-o", target).out
    assert "exact" in out
    assert "operations per pose: 10\n" in out
    assert "all 3 files are as derived" in run("derive", "--check", "-o", target).out
    assert results(target) == ["c", "exact.py", "on_demand.sha256"]
    assert results(target / "c") == ["stewart_exact.c"]
    (target / "c" / "stewart_exact.c").write_text("int y;\n")
    (target / "on_demand.sha256").write_text(f"{'0' * 64}  c/stewart_exact_bounds.h\n")
    (target / "stray.py").write_text("")
    (target / "exact.py").unlink()
    before = folder_state(target)
    lines = run("derive", "--check", "-o", target, code=1).out.splitlines()
    changed = ["differs: c/stewart_exact.c", "differs: c/stewart_exact_bounds.h"]
    assert lines[-4:] == [*changed, "missing: exact.py", "not generated: stray.py"]
    assert folder_state(target) == before


def _three_files(progress: Callable[[str, float, float], None], _processes: int) -> dict[str, str]:
    progress("exact", 1.0, 1.0)
    counts = {"friction": {"total": (4, 3, 2, 1)}}
    return {
        "exact.py": f"OPERATIONS: dict = {counts}\n",
        "c/stewart_exact.c": "int x;\n",
        "c/stewart_exact_bounds.h": "int y;\n",
    }


def test_derive_writes_one_kernel_for_reading(tmp_path: Path, run: Run, fails: Fails) -> None:
    name = "stewart_exact_massless_static_forces"
    run("derive", "--kernel", name, "-o", tmp_path / "out")
    assert results(tmp_path / "out" / "c") == [f"{name}.c", f"{name}.h"]
    assert "did you mean stewart_exact_bounds?" in fails("derive", "--kernel", "exact_bounds", "-o", tmp_path)
    assert "--kernel: must be given with --output" in fails("derive", "--kernel", name)


def test_generate_names_the_option_that_is_wrong(robot: Path, fails: Fails) -> None:
    asked = ("generate", robot, "-o", robot.parent / "kit")
    error = fails(*asked, "--fidelity", "rigid")
    assert 'error: fidelity: expected "general", ' in error
    assert not (robot.parent / "kit").exists()


@pytest.mark.slow
@few_vectors()
def test_generate_lists_the_files_and_writes_none(robot: Path, run: Run) -> None:
    target = robot.parent / "kit"
    asked = ["generate", str(robot), "-o", str(target), "--functions", "kinematics, reactions"]
    listed = run(*asked, "--list").out.splitlines()
    assert not target.exists()
    assert run(*asked).out.splitlines() == listed


# the command as a whole


@pytest.mark.parametrize("arguments", [[], ["chek"], ["check"], ["forces", "a", "b"]])
def test_a_wrong_command_is_one_line_that_names_the_help(arguments: list[str], fails: Fails) -> None:
    assert "--help" in fails(*arguments)


def test_numbers_with_a_sign_and_an_exponent_are_no_options(fails: Fails) -> None:
    load = ["--load", "-1e2", "-.5", "-3.", "-2E-3", "-1.5e+1", "0"]
    assert "no.toml" in fails("workspace", "no.toml", *load, "-o", "none")


def test_the_help_lists_every_subcommand_once_in_its_group(run: Run) -> None:
    lines = run("--help").out.splitlines()
    for title, names in cli.GROUPS.items():
        assert f"  {title}:" in lines
        for name in names:
            assert len([line for line in lines if line.startswith(f"    {name} ")]) == 1, name


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (
            ["benchmark", "--quik"],
            "unrecognized arguments: --quik, did you mean --quick? (see {} benchmark --help)",
        ),
        (["check", "a.toml", "b.toml"], "unrecognized arguments: b.toml (see {} check --help)"),
        (
            ["plann", "--minimize"],
            "argument SUBCOMMAND: expected a subcommand, got 'plann', did you mean plan? (see {} --help)",
        ),
    ],
)
def test_an_unknown_option_or_choice_names_what_there_is_and_its_subcommands_help(
    arguments: list[str], text: str, fails: Fails
) -> None:
    assert fails(*arguments) == f"stewart-sym: error: {text.format('stewart-sym')}"


def test_every_subcommand_has_an_example_and_no_folder_is_called_like_standard_output(
    run: Run, fails: Fails
) -> None:
    for name in cli.SUBCOMMANDS:
        text = run(name, "--help").out
        assert "cmake-dir" in name or f"Example: stewart-sym {name}" in " ".join(text.split())
        for option in re.findall(r"^  (?:-o.*, )?(--\w+) DIR", text, re.MULTILINE):
            error = fails(name, option, "-")
            assert error.endswith(f"got - for standard output (see stewart-sym {name} --help)")


@pytest.mark.slow
def test_checking_a_robot_loads_nothing_heavy(robot: Path) -> None:
    code = "import sys; from stewart_sym.cli.main import main; main(sys.argv[1:]); print(*sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", code, "check", str(robot)], capture_output=True, text=True, check=True
    )
    loaded = set(done.stdout.split())
    assert not loaded & {"sympy", "matplotlib"}
