"""`forces` and `singularities` on the command line: what they write, warn of and reject."""

import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from command_files import edit, results
from command_line import Fails, Run, read
from plain_logs import read_log

import stewart_sym as ss
from stewart_sym.cli.main import main
from stewart_sym.drives.limits import trapezoids
from stewart_sym.studies.common.text_tables import csv_lines


def test_forces_writes_what_the_library_computes(robot: Path, trajectory: Path) -> None:
    output = robot.parent / "forces.csv"
    assert main(["forces", str(robot), str(trajectory), "-o", str(output)]) == 0
    rows = read(output)
    log = read_log(trajectory)
    time, motion = log.time, log.motion
    expected = ss.inverse_dynamics(ss.Robot.from_toml(robot), motion)
    for i, row in enumerate(rows):
        assert float(row["time"]) == time[i]
        assert [float(row[f"F_{leg}"]) for leg in range(1, 7)] == expected.F[i].tolist()
        assert row["status"] == "0"
    assert list(rows[0])[7:] == [*(f"L_{leg}" for leg in range(1, 7)), "condition_number", "status"]
    assert len(rows) == len(time)


def test_forces_takes_backend_and_reactions(robot: Path, trajectory: Path, run: Run) -> None:
    written = []
    for backend in ("c", "numpy"):
        out = run("forces", robot, trajectory, "--backend", backend, "--reactions", "-o", "-").out
        written.append(out.splitlines())
    header = written[0][0].split(",")
    assert len(header) == 1 + 12 + 2 + 6 * 16
    values = np.array([[line.split(",") for line in lines[1:]] for lines in written], dtype=np.float64)
    np.testing.assert_allclose(values[1], values[0], rtol=1e-9, atol=1e-9)
    reactions = ss.joint_reactions(ss.Robot.from_toml(robot), read_log(trajectory).motion)
    np.testing.assert_array_equal(values[0][:, header.index("F_u_3_y")], reactions.F_u[:, 2, 1])


def test_forces_warns_of_each_limit_in_one_line_with_its_legs_and_the_worst(
    robot: Path, trajectory: Path, run: Run
) -> None:
    limits = "[legs]\nlength_limits = [0.45, 5]\nforce_limit = 1000\nspeed_limit = 0.01\n"
    edit(robot, "[legs.lower]", f"{limits}\n[legs.lower]")
    told = run("forces", robot, trajectory, "-o", robot.parent / "f.csv").err
    lines = [line for line in told.splitlines() if "exceeded" in line]
    rows = read(robot.parent / "f.csv")
    time = np.array([float(row["time"]) for row in rows])
    F = np.array([[float(row[f"F_{leg}"]) for leg in range(1, 7)] for row in rows])
    over = np.flatnonzero((np.abs(F) > 1000.0).any(axis=0))
    legs = f"leg{'s' if len(over) > 1 else ''} {', '.join(str(leg + 1) for leg in over)}"
    assert [line.split(": warning: ")[1].split(":")[0] for line in lines if "force_limit" in line] == [
        f"force_limit exceeded by {legs}"
    ]
    assert len(lines) == 3
    i, leg = np.unravel_index(np.argmax(np.abs(F)), F.shape)
    held = trapezoids(time)[np.abs(F[:, leg]) > 1000.0].sum()
    worst = f"leg {leg + 1}: {F[i, leg]:.6g} N at {time[i]:g} s, limit 1000 N; beyond it for {held:.3g} s"
    assert any(worst in line for line in lines)
    for name in ("speed_limit", "length_limits"):
        assert any(f"{name} exceeded by " in line for line in lines)


def test_a_pose_without_an_answer_is_rejected_unless_allowed(robot: Path, run: Run, fails: Fails) -> None:
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
    line = fails("forces", robot, trajectory, "-o", output)
    assert line.endswith(f"{trajectory}: line 3: a leg has length zero (leg 1)")
    assert not output.exists()
    told = run("forces", robot, trajectory, "-o", output, "--on-singular", "nan", "--reactions").err
    assert f"{trajectory}: line 3: a leg has length zero (leg 1)" in told
    rows = read(output)
    assert [row["status"] for row in rows] == ["0", "2", "0"]
    assert (rows[1]["F_1"], rows[1]["L_1"], rows[1]["M_u_1"]) == ("nan", "nan", "nan")
    assert np.isfinite(float(rows[2]["L_1"]))


@pytest.mark.slow
def test_a_full_standard_output_is_one_line(robot: Path) -> None:
    command = [sys.executable, "-W", "ignore", "-m", "stewart_sym", "check", str(robot)]
    with open("/dev/full", "w") as full:
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True)
    lines = [line for line in done.stderr.splitlines() if "warning" not in line]
    assert done.returncode == 2
    assert lines == ["stewart-sym: error: standard output: No space left on device"]


def test_exchanged_files_are_named_and_remedies_are_options(
    robot: Path, trajectory: Path, fails: Fails
) -> None:
    line = fails("forces", trajectory, robot, "-o", "-")
    assert line.endswith(f"{trajectory}: expected a robot file (TOML); give the robot before the log")
    trajectory.write_text(trajectory.read_text().replace("theta_z", "turn", 1))
    line = fails("forces", robot, trajectory, "-o", "-")
    assert line.endswith("no column theta_z; name it with --columns theta_z=HEADER; other columns: turn")


def test_units_that_contradict_the_header_are_named_as_options(
    robot: Path, trajectory: Path, run: Run
) -> None:
    trajectory.write_text(trajectory.read_text().replace("t_x", "t_x [cm]", 1))
    told = run("forces", robot, trajectory, "-o", robot.parent / "f.csv", "--length-unit", "m").err
    assert "the header unit cm contradicts --length-unit m, which is used; correct one of them" in told


def test_forces_warns_of_crossings_between(robot: Path, crossing: Path, trajectory: Path, run: Run) -> None:
    output, data = robot.parent / "f.csv", robot.parent / "f.json"
    told = run("forces", robot, crossing, "-o", output, "--json", data)
    (line,) = [line for line in told.err.splitlines() if "singular" in line]
    assert told.out.startswith("no force is sufficient: the path crosses a singular pose\n")
    assert any("crosses a singular pose" in each for each in json.loads(data.read_text())["warnings"])
    found = re.search(r"crosses a singular pose at (\d\.\d{9}) s, between lines 14 and 15: .* - to \+", line)
    assert found is not None, line
    assert float(found[1]) == pytest.approx(3.6705, abs=1e-3)
    assert re.search(
        r"condition number \S+, .* v = \(0\.73\d+, .*\) m/s, omega = \(-0\.75\d+, .*rad/s$", line
    )
    assert len(read(output)) == 21
    assert {row["status"] for row in read(output)} == {"0"}
    assert "singular" not in run("forces", robot, trajectory, "-o", output).err


@pytest.mark.slow
def test_singularities_reports_time_twist_and_signs(robot: Path, run: Run) -> None:
    folder = robot.parent / "found"
    told = run("singularities", robot, "III", "-o", folder).out
    names = ["crossing_1.png", "path.csv", "path.png", "report.json", "report.txt"]
    assert results(folder) == names
    text = (folder / "report.txt").read_text()
    assert told.startswith(text)
    assert text.startswith("verdict    1 crossing of a singular pose\n")
    assert "Crossing 1 at 3.670504110" in text
    (crossing,) = json.loads((folder / "report.json").read_text())["crossings"]
    assert (crossing["sign_before"], crossing["sign_after"]) == (-1, 1)
    assert crossing["residue_N_s"][0] == pytest.approx(-27554.33, rel=1e-6)
    sides = [
        float(row["F_2"]) for row in read(folder / "path.csv") if abs(float(row["time"]) - 3.6705) < 0.05
    ]
    assert min(sides) < -1e6
    assert max(sides) > 1e6


def test_singularities_fails_in_one_line(robot: Path, trajectory: Path, crossing: Path, fails: Fails) -> None:
    folder = robot.parent / "found"
    line = fails("singularities", robot, "IV", "-o", folder)
    assert line.endswith("IV: expected I, II, III, or a CSV file; the file does not exist")
    start = ["--pose-guess", *"000000"]
    line = fails("singularities", robot, trajectory, "-o", folder, *start)
    assert "contains poses; omit the guess" in line
    crossing.write_text("".join(crossing.read_text().splitlines(keepends=True)[:2]))
    line = fails("singularities", robot, crossing, "-o", folder)
    assert line.endswith("expected at least 2 samples, got 1")
    assert not folder.exists()
