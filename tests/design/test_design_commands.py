"""``workspace`` and ``size-actuators`` as commands: what they write, and bad input that leaves nothing."""

import json
from pathlib import Path

import numpy as np
import pytest
from command_files import edit, results
from command_line import Fails, Run, folder_state, read
from robot_files import HANGING

import stewart_sym as ss

FEW = ("--samples", 4000)


@pytest.fixture(autouse=True)
def hanging(folder: Path) -> None:
    (folder / "hanging.toml").write_text(HANGING)


@pytest.mark.slow
def test_a_workspace_is_written_as_text_table_and_picture(folder: Path, run: Run) -> None:
    ranges = (
        "--rpy-bounds",
        -0.3,
        0.3,
        -0.3,
        0.3,
        -0.3,
        0.3,
        "--position-bounds",
        -0.2,
        0.2,
        -0.2,
        0.2,
        0.55,
        0.85,
    )
    options = ("--kind", "six_dof", *ranges, "--min-clearance", 0.07)
    run("workspace", "hanging.toml", *options, "--max-condition", 20, *FEW)
    assert results(folder / "workspace") == ["report.json", "report.txt", "slices.csv", "slices.png"]
    report = (folder / "workspace" / "report.txt").read_text()
    assert "leg lengths, joint angles, leg clearance 70 mm, scaled condition number 20, actuator" in report
    data = json.loads((folder / "workspace" / "report.json").read_text())
    assert data["volume"] > data["error"] > 0.0
    assert data["extent"][2][0] > 0.0
    rows = read(folder / "workspace" / "slices.csv")
    assert {row["axes"] for row in rows} >= {"t_x-t_y", "theta_y-theta_z"}
    assert {row["first_limit"] for row in rows} >= {"feasible", "leg_length", "joint_angle"}


@pytest.mark.slow
def test_a_middle_beyond_the_limits_and_meters_read_as_millimeters_are_doubted(run: Run) -> None:
    few = ("--samples", 500, "--no-plots")
    for position, doubted in ((0.7, False), (700.0, True)):
        told = run("workspace", "hanging.toml", *few, "--position", 0, 0, position).err
        assert ("center pose: violates a limit" in told) == doubted
    for unit, doubted in (("m", False), ("mm", True)):
        units = ("--length-unit", unit, "-o", "f.csv")
        told = run("forces", "hexapod.toml", "trajectory.csv", *units).err
        assert ("state --length-unit " in told) == doubted


@pytest.mark.slow
def test_sizes_are_written_and_limits_that_do_not_suffice_are_named(folder: Path, run: Run) -> None:
    edit(folder / "hexapod.toml", "force_limit = 500.0", "force_limit = 150.0")
    captured = run("size-actuators", "hexapod.toml", "trajectory.csv", "trajectory.csv", "--quantile", 1)
    assert results(folder / "size") == ["needs.csv", "report.json", "report.txt", "size.png"]
    (line,) = captured.err.splitlines()
    counts = "limits exceeded: 0, limits without the margin: 2"
    assert line.startswith(f"stewart-sym: warning: hexapod.toml: {counts}; force_limit of leg 1: ")
    assert captured.out.startswith(f"verdict {counts}\n")
    data = json.loads((folder / "size" / "report.json").read_text())
    assert data["exceeded"] == []
    assert data["margin_missing"][0].startswith("force_limit of leg 1: 150 N, needed 129")
    assert captured.out.count(f"Margin missing: {data['margin_missing'][0]}") == 1
    force = {row["need"]: row for row in read(folder / "size" / "needs.csv")}["force, peak"]
    robot = ss.Robot.from_toml("hexapod.toml")
    assert float(force["leg1"]) == data["force"][0][0] > robot.force_limit[0] / 1.25
    assert np.shape(data["length"]) == (6, 2)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("workspace", "none.toml"), "none.toml"),
        (
            ("workspace", "hexapod.toml", "--position-bounds", 1, 0, 0, 1, 0, 1),
            "position_bounds: expected least < greatest",
        ),
        (("size-actuators", "hexapod.toml"), "TRAJECTORY.csv"),
        (("size-actuators", "hexapod.toml", "trajectory.csv", "--quantile", 2), "quantiles: expected"),
    ],
)
def test_bad_input_is_one_line_and_leaves_nothing(
    folder: Path, fails: Fails, arguments: tuple[object, ...], message: str
) -> None:
    before = folder_state(folder)
    assert message in fails(*arguments)
    assert folder_state(folder) == before
