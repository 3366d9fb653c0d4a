"""``workspace`` and ``size`` from the command line: what they write, and bad input that leaves nothing."""

import json
import re
from pathlib import Path

import numpy as np
import pytest
from command_files import edit, results
from command_line import Fails, Run, folder_state, read
from log_files import NAMES, write

import stewart_sym as ss
from stewart_sym.motion.log_reader import read_csv
from stewart_sym.robot.robot import legs_text

HANGING = """\
schema = 2
name = "hanging"
length_unit = "mm"
angle_unit = "deg"
gravity = [0.0, 0.0, 9.81]
home_position = [0.0, 0.0, 700.0]
base = { radius = 500.0, angles = [-10.0, 10.0, 110.0, 130.0, 230.0, 250.0] }

[platform]
radius = 250.0
angles = [-50.0, 50.0, 70.0, 170.0, 190.0, 290.0]
body = { shape = "plate", radius = 300.0, thickness = 20.0, density = 2700.0 }

[legs]
universal_axis = "tangential"
lower = { shape = "tube", radius = 30.0, inner_radius = 25.0, length = 400.0, density = 7800.0 }
upper = { shape = "rod", radius = 20.0, length = 400.0, density = 7800.0 }
stroke = [-150.0, 150.0]
force_limit = 300.0
joint_angle_limit = [30.0, 22.0]
"""
FEW = ("--samples", 4000)
FREE = (
    "--ignore",
    "lengths",
    "--ignore",
    "joint_angles",
    "--position-bounds",
    -0.1,
    0.1,
    -0.1,
    0.1,
    0.6,
    0.8,
)


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
    assert "leg lengths, joint angles, leg clearance 0.07 m, scaled condition number 20, actuator" in report
    data = json.loads((folder / "workspace" / "report.json").read_text())
    assert data["volume"] > data["error"] > 0.0
    assert data["extent"][2][0] > 0.0
    rows = read(folder / "workspace" / "slices.csv")
    assert {row["axes"] for row in rows} >= {"t_x-t_y", "theta_y-theta_z"}
    assert {row["first_limit"] for row in rows} >= {"feasible", "leg_length", "joint_angle"}


def test_the_table_of_an_empty_workspace_has_no_nan(folder: Path, run: Run) -> None:
    ranges = (
        "--position-bounds",
        0.5,
        0.6,
        0.5,
        0.6,
        0.5,
        0.6,
        "--rpy-bounds",
        -0.1,
        0.1,
        -0.1,
        0.1,
        -0.1,
        0.1,
    )
    run("workspace", "hexapod.toml", "--kind", "six_dof", *ranges, "--samples", 200, "--no-plots")
    report = (folder / "workspace" / "report.txt").read_text()
    assert "nan" not in report
    assert len(re.findall(r"-  +-  ", report)) == 6


def test_a_middle_beyond_the_limits_and_meters_read_as_millimeters_are_doubted(run: Run) -> None:
    few = ("--samples", 500, "--no-plots")
    for position, doubted in ((0.7, False), (700.0, True)):
        told = run("workspace", "hanging.toml", *few, "--position", 0, 0, position).err
        assert ("center pose: violates a limit" in told) == doubted
    for unit, doubted in (("m", False), ("mm", True)):
        units = ("--length-unit", unit, "-o", "f.csv")
        told = run("forces", "hexapod.toml", "trajectory.csv", *units).err
        assert ("1000 times as much does not: is the unit of" in told) == doubted


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--position", 0, 0, 700), "its legs are 700 to 700 m long: change --position"),
        (("--max-condition", 1.5), "condition number: expected at most 1.5, "),
        (
            (*FREE, "--max-condition", 20, "--rpy", 0, 0, 2.5),
            "condition number: det H has another sign than at the home pose",
        ),
        ((*FREE, "--min-clearance", 0.08, "--rpy", 0, 0, 2.5), "leg clearance"),
        (("--load", 0, 0, 9000, 0, 0, 0), "actuator force"),
        (("--position", 0, 0, -0.7), "assembly mode"),
        (("--rpy", 0, 0, 0.6), "joint angle"),
    ],
)
def test_the_limit_that_the_middle_breaks_is_named(options: tuple, words: str, run: Run) -> None:
    errors = run("workspace", "hanging.toml", "--samples", 100, "--no-plots", *options).err
    assert f"center pose: violates a limit, {words}" in errors
    assert ("--position" in errors) == (words.startswith("its legs"))


def test_ignored_limits_do_not_count(folder: Path, run: Run) -> None:
    volumes = []
    for ignored in ((), ("--ignore", "joint_angles")):
        told = run("workspace", "hanging.toml", *FEW, *ignored, "--no-plots", "--json", "-").out
        volumes.append(json.loads(told)["volume"])
    assert volumes[0] < 0.9 * volumes[1]


def test_sizes_are_written_and_limits_that_do_not_suffice_are_named(folder: Path, run: Run) -> None:
    edit(folder / "hexapod.toml", "force_limit = 500.0", "force_limit = 150.0")
    captured = run("size-actuators", "hexapod.toml", "trajectory.csv", "trajectory.csv", "--quantile", 1)
    assert results(folder / "size") == ["needs.csv", "report.json", "report.txt", "size.png"]
    (line,) = captured.err.splitlines()
    assert line.startswith(
        "stewart-sym: warning: hexapod.toml: limits exceeded: 0, limits without the margin: 2; "
        "force_limit of leg 1: "
    )
    data = json.loads((folder / "size" / "report.json").read_text())
    assert data["exceeded"] == []
    assert data["margin_missing"][0].startswith("force_limit of leg 1: 150 N, needed 129")
    assert captured.out.count(f"Margin missing: {data['margin_missing'][0]}") == 1
    force = {row["need"]: row for row in read(folder / "size" / "needs.csv")}["force, peak"]
    robot = ss.Robot.from_toml("hexapod.toml")
    assert float(force["leg1"]) == data["force"][0][0] > robot.force_limit[0] / 1.25
    assert np.shape(data["length"]) == (6, 2)


def test_noise_that_hides_the_forces_exceeds_no_limit_and_is_told(folder: Path, run: Run) -> None:
    """A trapezoid of speed up to 0.125 m/s, whose smoothing leaves most of the noise."""
    time = np.arange(200) / 50.0
    ramps = np.maximum(time[:, None] - [1.01, 1.26, 1.66, 1.91], 0.0)
    rows = 3e-4 * np.random.default_rng(0).normal(size=(200, 6))
    rows[:, 2] += 0.65 + 0.25 * ramps**2 @ [1.0, -1.0, -1.0, 1.0]
    write(folder / "noisy.csv", NAMES, np.column_stack([time, rows]))
    text = (folder / "hexapod.toml").read_text()
    (folder / "hexapod.toml").write_text(text + DRIVE)
    captured = run("size-actuators", "hexapod.toml", "noisy.csv", "--cutoff", 20, "--no-plots")
    assert "at the noise of the log, the forces of all legs are unknown: " in captured.err
    data = json.loads((folder / "size" / "report.json").read_text())
    assert data["exceeded"] == []
    assert f"limits exceeded: 0, limits without the margin: 0, inconclusive: {len(data['inconclusive'])}" in (
        captured.err
    )
    limits = {line.split(": ")[1].partition(" of leg")[0] for line in data["inconclusive"]}
    assert limits == {"force_limit", "speed_limit", *(f"drive.{name}_limit" for name in ("torque", "speed"))}
    assert all(line.startswith("inconclusive noise: ") for line in data["inconclusive"])
    assert all(f"I{line[1:]}" in captured.out for line in data["inconclusive"])
    assert re.search(r"^force, peak, N .*\n  \+-( +\S+){6}$", captured.out, re.MULTILINE)
    assert {"force", "speed", "torque", "rms_torque", "length", "base_angle"} < set(data["std"])
    row = next(row for row in read(folder / "size" / "needs.csv") if row["need"] == "force, peak")
    assert float(row["leg1_std"]) == data["std"]["force"][-1][0] > float(row["leg1"]) / 3.0

    output = ("-o", "F.csv", "--json", "F.json")
    told = run("forces", "hexapod.toml", "noisy.csv", "--cutoff", 20, *output).err
    assert "exceeded by" not in told
    assert "unknown: " in told
    for name in limits:
        assert f"{name} inconclusive noise by " in told
    found = json.loads((folder / "F.json").read_text())["legs"]
    assert {leg["motor_torque_limit"] for leg in found} == {"inconclusive_noise"}
    assert all(leg["motor_peak_torque_std_N_m"] > 0.0 and leg["motor_energy_std_J"] > 0.0 for leg in found)
    header = (folder / "F.csv").read_text().splitlines()[0].split(",")
    assert {"F_1_std", "torque_1_std", "motor_speed_6_std", "power_3_std"} < set(header)


DRIVE = """
[legs.drive]
lead = 0.01
screw_coulomb = 5.0
torque_limit = 0.8
speed_limit = 120.0
"""


def test_joint_angles_are_compared_by_forces_and_view_as_by_size(folder: Path, run: Run) -> None:
    file, home = folder / "hexapod.toml", "home_position = [0.0, 0.0, 0.65]\n"
    edit(file, 'name = "hexapod"\n', f'name = "hexapod"\n{home}')
    log = read_csv(folder / "trajectory.csv")
    needs = ss.actuator_requirements(ss.Robot.from_toml(file), [log])
    peaks = {"base": needs.base_angle, "platform": needs.platform_angle}
    limits = [float(np.median(each)) for each in peaks.values()]
    edit(file, "speed_limit", f"joint_angle_limit = {limits}\nspeed_limit")
    run("size-actuators", "hexapod.toml", "trajectory.csv", "--no-plots")
    exceeded = json.loads((folder / "size" / "report.json").read_text())["exceeded"]
    told, tables = [], []
    for name, output in (("forces", "F.csv"), ("view", "F.html")):
        found = run(name, "hexapod.toml", "trajectory.csv", "-o", output, "--json", f"{name}.json")
        tables.append(found.out)
        told.append([line.split("warning: ")[1] for line in found.err.splitlines() if "joint_ang" in line])
    assert told[0] == told[1]
    for leg in range(6):
        assert f"  {', '.join(f'{np.degrees(peak[leg]):.4g}' for peak in peaks.values())}\n" in tables[0]
    legs = json.loads((folder / "forces.json").read_text())["legs"]
    for (end, peak), limit, line in zip(peaks.items(), limits, told[0], strict=True):
        over = [leg for leg in range(6) if peak[leg] > limit]
        assert 0 < len(over) < 6
        assert line.startswith(f"joint_angle_limit at the {end} exceeded by {legs_text(over)}: worst leg ")
        assert f" {np.degrees(peak.max()):.6g} degrees at " in line
        assert f" s, limit {np.degrees(limit):g} degrees; beyond it for " in line
        size = [each for each in exceeded if each.startswith(f"joint_angle_limit at the {end}")]
        assert [int(each.partition(" of leg ")[2][0]) - 1 for each in size] == over
        for leg, verdict in enumerate(legs):
            assert verdict[f"{end}_angle_limit"] == ("exceeded" if leg in over else "within_limit")
            assert verdict[f"{end}_angle_limit_rad"] == pytest.approx(limit)
            assert verdict[f"peak_{end}_angle_rad"] == pytest.approx(peak[leg])


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("workspace", "none.toml"), "none.toml"),
        (("workspace", "trajectory.csv"), "trajectory.csv"),
        (
            ("workspace", "hexapod.toml", "--position-bounds", 1, 0, 0, 1, 0, 1),
            "position_bounds: expected least < greatest",
        ),
        (("workspace", "hexapod.toml", "--rpy", 1, 2, "nan"), "expected a finite number"),
        (("workspace", "hexapod.toml", "--kind", "every"), "--kind"),
        (("size-actuators", "hexapod.toml"), "TRAJECTORY.csv"),
        (("size-actuators", "hexapod.toml", "none.csv"), "none.csv"),
        (("size-actuators", "hexapod.toml", "trajectory.csv", "--quantile", 2), "quantiles: expected"),
        (("size-actuators", "hexapod.toml", "hexapod.toml"), "hexapod.toml"),
    ],
)
def test_bad_input_is_one_line_and_leaves_nothing(
    folder: Path, fails: Fails, arguments: tuple[object, ...], message: str
) -> None:
    before = folder_state(folder)
    assert message in fails(*arguments)
    assert folder_state(folder) == before


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("[30.0, 22.0]", "[30.0, 0.0]", "legs.joint_angle_limit: expected angles > 0 and <= 180, got [30.0"),
        ("[30.0, 22.0]", "200.0", "legs.joint_angle_limit: expected angles > 0 and <= 180"),
        ("[30.0, 22.0]", '"wide"', "legs.joint_angle_limit: expected"),
        ("home_position = [0.0, 0.0, 700.0]\n", "", "expected a key home"),
    ],
)
def test_a_joint_angle_limit_that_is_none_is_named_with_its_line(
    folder: Path, fails: Fails, old: str, new: str, message: str
) -> None:
    if not new:
        edit(folder / "hanging.toml", "stroke = [-150.0, 150.0]\n", "")
    edit(folder / "hanging.toml", old, new)
    line = fails("workspace", "hanging.toml")
    assert message in line
    assert "(at line " in line
