"""Logs as other programs write them: names, units, marks, Euler orders; doubtful units are warned of."""

import dataclasses
import re
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command_line import Run, rejects
from log_files import LENGTHS, NAMES, poses, write
from machines import Array, dasgupta, home_position, machine_size, random_robot
from robot_files import PAPERS

import stewart_sym as ss
from stewart_sym.kinematics.trajectory_checks import angle_doubt, length_doubt, side_doubt
from stewart_sym.motion.log_reader import FORCES, PLAIN, read_csv, read_leg_columns
from stewart_sym.motion.logs import EULER_ORDERS, LENGTH_UNITS, TrajectoryFormat
from stewart_sym.motion.rotation import quaternion_from_rotation, rotation_from_rpy
from stewart_sym.motion.trajectory import PoseLog, Trajectory


def same(one: Trajectory, other: Trajectory, tolerance: float = 1e-6) -> None:
    np.testing.assert_allclose(one.time, other.time, rtol=1e-13)
    for name in ("R", "t", "omega", "v", "alpha", "a"):
        np.testing.assert_allclose(getattr(one.motion, name), getattr(other.motion, name), atol=tolerance)


@pytest.mark.parametrize(("delimiter", "decimal"), [",.", ";.", ";,", "\t,", "\t."])
def test_delimiter_and_decimal_comma_are_detected(tmp_path: Path, delimiter: str, decimal: str) -> None:
    plain = read_csv(write(tmp_path / "plain.csv", NAMES, poses()))
    odd = write(tmp_path / "odd.csv", NAMES, poses(), delimiter, decimal)
    same(read_csv(odd), plain, 0.0)
    marks = {",": "comma", ";": "semicolon", "\t": "tab"}[delimiter], {".": "point", ",": "comma"}[decimal]
    same(read_csv(odd, TrajectoryFormat(delimiter=marks[0], decimal=marks[1])), plain, 0.0)


def test_names_are_mapped_and_other_columns_skipped(tmp_path: Path) -> None:
    plain = read_csv(write(tmp_path / "plain.csv", NAMES, poses()))
    given = ["Time [ms]", "X", "Y", "Z", "roll", "pitch", "yaw"]
    lines = write(tmp_path / "own.csv", given, poses()).read_text().splitlines()
    path = tmp_path / "more.csv"
    path.write_text("\n".join([lines[0] + ",mode", *(f"{line},auto" for line in lines[1:])]))
    form = TrajectoryFormat(dict(zip(NAMES, given, strict=True)))
    same(read_csv(path, form), plain, 0.0)
    with pytest.raises(
        ValueError, match=r"more.csv: expected a column 'Roll' for theta_x, got Time \[ms\], X"
    ):
        read_csv(path, TrajectoryFormat({**form.columns, "theta_x": "Roll"}))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"yaw": "yaw"}, "unknown column 'yaw', expected time and either .* M_ext_[*]$"),
        ({"theta_y": "yaw"}, "header 'yaw' is given for theta_y and theta_z$"),
        ({"F_ext_x": "F"}, "missing column F_ext_y$"),
    ],
)
def test_mistakes_among_given_names_are_theirs(tmp_path: Path, change: dict[str, Any], words: str) -> None:
    given = ["Time [ms]", "X", "Y", "Z", "roll", "pitch", "yaw"]
    path = write(tmp_path / "own.csv", given, poses())
    columns = dict(zip(NAMES, given, strict=True)) | change
    rejects(f"^columns: {words}", lambda: read_csv(path, TrajectoryFormat(columns)))


def test_units_are_converted(tmp_path: Path) -> None:
    table = poses()
    plain = read_csv(write(tmp_path / "plain.csv", NAMES, table))
    scaled = table / np.array([1e-3, 1e-3, 1e-3, 1e-3, *[np.pi / 180.0] * 3])
    form = TrajectoryFormat(length_unit="mm", angle_unit="deg", time_unit="ms")
    same(read_csv(write(tmp_path / "mm.csv", NAMES, scaled), form), plain)


@pytest.mark.parametrize("order", EULER_ORDERS)
def test_euler_orders_multiply_the_turns_in_that_order(tmp_path: Path, order: str) -> None:
    table = poses()
    single = [rotation_from_rpy(table[:, 4 + i, None] * np.eye(3)[i]) for i in range(3)]
    a, b, c = (single["xyz".index(axis)] for axis in order)
    found = read_csv(write(tmp_path / "e.csv", NAMES, table), TrajectoryFormat(euler_order=order))
    np.testing.assert_allclose(found.motion.R, a @ b @ c, atol=1e-14)


def test_quaternions_are_poses(tmp_path: Path) -> None:
    table = poses()
    plain = read_csv(write(tmp_path / "plain.csv", NAMES, table))
    e = quaternion_from_rotation(rotation_from_rpy(table[:, 4:]))
    names = [*NAMES[:4], "q_w", "q_x", "q_y", "q_z"]
    path = write(tmp_path / "q.csv", names, np.hstack([table[:, :4], -2.0 * e]))
    same(read_csv(path), plain)
    write(path, names, np.hstack([table[:, :4], 0.0 * e]))
    rejects(r"q.csv: line 2: q: expected a quaternion, got length 0", read_csv, path)


@pytest.mark.parametrize(
    ("factors", "unit"),
    [((1e3, 1.0, 1.0), "ms"), ((1e6, 1.0, 1.0), "us")],
)
def test_a_log_in_another_unit_of_time_is_rejected_unless_the_unit_is_stated(
    tmp_path: Path, factors: tuple[float, float, float], unit: str
) -> None:
    odd = write(tmp_path / "odd.csv", NAMES, poses() * np.repeat(factors, [1, 3, 3]))
    off = ss.SmoothingOptions(enabled=False)
    rejects(
        rf"time_unit={unit}, or time_unit=s",
        read_csv,
        odd,
        smoothing=off,
    )
    with pytest.warns(ss.TrajectoryWarning, match="is time in another unit"):
        read_csv(odd, TrajectoryFormat(time_unit="s"), off)
    with warnings.catch_warnings(record=True, action="always") as caught:
        read_csv(odd, TrajectoryFormat(time_unit=unit), off)
    assert not any("time" in str(each.message) for each in caught)


@pytest.mark.parametrize(
    ("factors", "words"),
    [
        ((1.0, 1.0, 50 * 180.0 / np.pi), "angle_unit=deg"),
        ((1e-6, 1.0, 1.0), "time_unit"),
        ((60.0, 1.0, 1.0), "is time in another unit .time_unit=ms"),
    ],
)
def test_units_that_no_machine_has_are_warned_of(
    tmp_path: Path, factors: tuple[float, float, float], words: str
) -> None:
    odd = write(tmp_path / "odd.csv", NAMES, poses() * np.repeat(factors, [1, 3, 3]))
    with pytest.warns(ss.TrajectoryWarning, match=words):
        read_csv(odd, smoothing=ss.SmoothingOptions(enabled=False))
    with warnings.catch_warnings(action="error"):
        read_csv(write(tmp_path / "good.csv", NAMES, poses()))


def legs_of(robot: ss.Robot, table: Array) -> Array:
    motion = ss.Motion.from_rpy(table[:, 1:4], table[:, 4:], *[0.0 * table[:, 1:4]] * 4)
    return ss.inverse_kinematics(robot, motion).L


@pytest.mark.parametrize("limits", [False, True], ids=["free", "limited"])
def test_the_unit_of_lengths_is_told_by_the_machines_size(limits: bool) -> None:
    robot, L = dasgupta(), legs_of(dasgupta(), poses())
    if limits:
        robot = dataclasses.replace(robot, length_limits=np.tile([0.5 * L.min(), 1.5 * L.max()], (6, 1)))
    assert length_doubt(robot, L) is None
    for unit in ("mm", "cm", "in"):
        told = str(length_doubt(robot, L / LENGTH_UNITS[unit]))
        assert re.search(rf"another unit \(.*length_unit={unit}", told), told
    assert "another unit (length_unit=m" in str(length_doubt(robot, 1e-3 * L, "mm"))
    beyond = 25.4 if limits else 100.0
    assert "another unit (length_unit=mm)" in str(length_doubt(robot, beyond * L, "in"))
    assert "the robot file's lengths in meters" in str(length_doubt(robot, 1e-3 * L))
    assert "the log of another machine" in str(length_doubt(robot, 1e5 * L))


def test_lengths_that_no_machine_has_are_named_with_their_unit(tmp_path: Path, run: Run) -> None:
    table = poses() * [1.0, *[1e2] * 3, *[1.0] * 3]
    lengths = np.column_stack([table[:, 0], 1e2 * legs_of(dasgupta(), poses())])
    for names, numbers, code in ((NAMES, table, 0), (["time", *LENGTHS], lengths, 2)):
        log = write(tmp_path / "log.csv", names, numbers)
        command = ("forces", PAPERS, log, "-o", tmp_path / "f.csv")
        assert "give length_unit=cm" in run(*command, code=2).err
        told = run(*command, "--length-unit", "m", code=code).err
        assert "are they in another unit (length_unit=cm" in told


def test_small_angles_in_degrees_are_told_by_what_the_legs_allow() -> None:
    robot, time = dasgupta(), poses()[:, 0]
    table = poses()
    table[:, 4:] *= 0.3
    L = legs_of(robot, table)
    limited_ = dataclasses.replace(robot, length_limits=np.tile([0.95 * L.min(), 1.05 * L.max()], (6, 1)))
    degrees = table * [*[1.0] * 4, *[180.0 / np.pi] * 3]

    def told(machine: ss.Robot, rows: Array) -> str | None:
        coordinates = np.zeros((3, len(rows), 6))
        coordinates[0] = rows[:, 1:]
        log = PoseLog(time, coordinates, None, None, "log", range(len(rows)), None, True)
        return angle_doubt(machine, log, np.arange(len(rows)))

    assert "leads legs beyond length_limits, in degrees it does not" in str(told(limited_, degrees))
    assert told(limited_, table) is None
    through = degrees * [*[1.0] * 4, 2.5, 2.5, 2.5]
    assert "leads through a singular pose, in degrees it does not" in str(told(robot, through))
    assert told(robot, table) is None


def test_quaternions_with_their_scalar_last_under_other_names_are_warned_of(tmp_path: Path) -> None:
    table = poses()
    e = quaternion_from_rotation(rotation_from_rpy(table[:, 4:]))
    names = [*NAMES[:4], "q_w", "q_x", "q_y", "q_z"]
    with pytest.warns(ss.TrajectoryWarning, match="quaternions with the scalar last"):
        read_csv(write(tmp_path / "q.csv", names, np.hstack([table[:, :4], np.roll(e, -1, axis=1)])))


@pytest.mark.parametrize(
    ("mark", "words"),
    [
        ("", "expected 7 columns, got 14: are commas its decimal marks too"),
        ('"', "decimal=comma"),
    ],
)
def test_decimal_commas_between_commas_are_named(tmp_path: Path, mark: str, words: str) -> None:
    rows = [",".join(mark + f"{x:.6f}".replace(".", ",") + mark for x in row) for row in poses()]
    path = tmp_path / "comma.csv"
    path.write_text("\n".join([",".join(NAMES), *rows]) + "\n")
    rejects(f"comma.csv: line 2: .*{words}", read_csv, path)


@pytest.mark.parametrize(("gravity", "where"), [(-9.81, "below the base"), (9.81, "than at home in every")])
def test_poses_on_the_other_side_of_the_base_are_doubted(gravity: float, where: str) -> None:
    rng = np.random.default_rng(8)
    for _ in range(5):
        robot = random_robot(rng, scale=float(rng.choice([0.2, 1.0, 3.0])))
        above = home_position(robot.b, machine_size(robot)) - robot.p.mean(axis=0)
        home = above if gravity > 0.0 else None
        robot = dataclasses.replace(robot, g=[0.0, 0.0, gravity], home_position=home)
        t = above + 0.01 * machine_size(robot) * rng.normal(size=(9, 3))
        below = t - [0.0, 0.0, 2.2 * machine_size(robot)]
        still = np.zeros((9, 3))
        up, down = (ss.Motion.from_rpy(place, still, still, still) for place in (t, below))
        assert side_doubt(robot, up) is None
        doubt = str(side_doubt(robot, down))
        assert where in doubt
        assert "does z of the log point the other way" in doubt


def limited(folder: Path, limit: float) -> Path:
    """The paper's robot file with a limit of its forces."""
    text = PAPERS.read_text(encoding="utf-8")
    limits = f"[legs]\nforce_limit = {limit!r}\n[legs.lower]"
    path = folder / "robot.toml"
    path.write_text(text.replace("[legs.lower]", limits), encoding="utf-8")
    return path


def test_forces_reads_a_foreign_log_and_sums_up(tmp_path: Path, run: Run) -> None:
    robot = limited(tmp_path, 1e5)
    table = np.round(poses(400) / [1e-3, 1e-3, 1e-3, 1e-3, *[np.pi / 180.0] * 3], 2)
    log = write(tmp_path / "log.csv", ["t", "X", "Y", "Z", "A", "B", "C"], table, ";", ",")
    columns = "time=t,t_x=X,t_y=Y,t_z=Z,theta_x=A,theta_y=B,theta_z=C"
    units = ["--length-unit", "mm", "--angle-unit", "deg", "--time-unit", "ms", "--rate", "50"]
    out = tmp_path / "f.csv"
    told = run("forces", robot, log, "-o", out, "--columns", columns, *units)
    assert "smoothed" in told.err
    assert "101 samples, 0 to 2 s" in told.out
    assert "100000 within limit" in told.out
    header = out.read_text().splitlines()[0].split(",")
    assert header[7:13] == [f"F_{leg}_std" for leg in range(1, 7)]


def test_a_rate_that_leaves_few_instants_is_warned_of(tmp_path: Path, run: Run) -> None:
    log = write(tmp_path / "log.csv", NAMES, poses())
    for rate, words in (("0.1", "1 sample of"), ("2", "5 samples of"), ("5", "")):
        told = run("forces", PAPERS, log, "-o", tmp_path / "f.csv", "--rate", rate).err
        expected = f"log.csv: {words} 41 rows in 2 s at {rate} Hz; the motion between"
        assert expected in told if words else "raise --rate" not in told


def test_hints_are_the_same_in_python_and_on_the_command_line(tmp_path: Path, run: Run) -> None:
    log = write(tmp_path / "log.csv", ["ms", *NAMES[1:]], poses())
    rejects(r"give columns NAME=HEADER,...$", read_csv, log)
    told = run("forces", PAPERS, log, "-o", tmp_path / "f.csv", code=2).err
    assert told.endswith("give columns NAME=HEADER,...\n")
    late = write(tmp_path / "late.csv", NAMES, poses() * [1e6, *[1.0] * 6])
    told = run("forces", PAPERS, late, "-o", tmp_path / "f.csv", code=2).err
    assert told.endswith("give time_unit=us, or time_unit=s if s is right\n")


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--columns", "time"], "expected NAME=HEADER"),
        (["--cutoff", "1e6"], "cutoff: expected a frequency > 0 and <"),
        (["--rate", "1e9"], "rate: expected > 0 Hz and at most"),
    ],
)
def test_bad_options_are_one_line(tmp_path: Path, run: Run, options: list[str], words: str) -> None:
    log = write(tmp_path / "log.csv", NAMES, poses())
    told = run("forces", PAPERS, log, "-o", tmp_path / "f.csv", *options, code=2).err
    assert words in told.splitlines()[-1]
    assert not (tmp_path / "f.csv").exists()


def fixed(table: Array, decimals: int, ending: str = "") -> str:
    """A log with a fixed number of decimals, without a line ending after its last row."""
    rows = (",".join(f"{x:.{decimals}f}" for x in row) for row in table)
    return "\n".join([",".join(NAMES), *rows]) + ending


def shortest(table: Array) -> str:
    """The same log with as many digits as each number needs."""
    return "\n".join([",".join(NAMES), *(",".join(map(repr, row)) for row in table.tolist())])


def cut_warnings(path: Path) -> list[str]:
    with warnings.catch_warnings(record=True, action="always") as caught:
        read_csv(path, smoothing=ss.SmoothingOptions(enabled=False))
    return [str(each.message) for each in caught if "cut off" in str(each.message)]


@pytest.mark.parametrize("cut", [1, 3, 6])
def test_a_log_that_ends_within_its_last_number_is_warned_of(tmp_path: Path, cut: int) -> None:
    count = 41
    path = tmp_path / "cut.csv"
    path.write_text(fixed(poses(count), 6)[:-cut])
    (line,) = cut_warnings(path)
    assert line.startswith(f"{path}: line {count + 1}: ")


@pytest.mark.parametrize("kind", ["fixed", "shortest", "trimmed", "crlf"])
def test_full_logs_are_not_taken_for_cut_ones(tmp_path: Path, kind: str) -> None:
    table = poses()
    table[-1, -1] = 0.5  # a last number that is short where zeros at its end are left out
    text = {
        "fixed": fixed(table, 6),
        "shortest": shortest(table),
        "seventeen": write(tmp_path / "log.csv", NAMES, table).read_text().rstrip("\n"),
        "trimmed": "\n".join([",".join(NAMES), *(",".join(f"{x:.6g}" for x in row) for row in table)]),
        "at rest": shortest(np.column_stack([table[:, :-1], 0.0 * table[:, -1]])),
        # A line ending says that the number is whole.
        "ended": fixed(table, 6)[:-3] + "\n",
        "crlf": fixed(table, 6, "\n").replace("\n", "\r\n"),
    }[kind]
    path = tmp_path / "whole.csv"
    path.write_bytes(text.encode())
    assert cut_warnings(path) == []


def test_times_rounded_to_milliseconds_are_those_of_their_even_clock(tmp_path: Path) -> None:
    """At 60 rows a second; the forces measured beside such a log have the same times."""
    rows = poses(121)
    plain = read_csv(write(tmp_path / "plain.csv", NAMES, rows))
    rows[:, 0] = np.round(rows[:, 0], 3)
    with pytest.warns(
        ss.TrajectoryWarning, match=r"time: rounded to 1 ms: rows are taken every 16\.66\d* ms$"
    ):
        found = read_csv(write(tmp_path / "log.csv", NAMES, rows))
    np.testing.assert_allclose(found.time, plain.time, rtol=0.0, atol=1e-5)
    np.testing.assert_allclose(found.motion.a, plain.motion.a, atol=1e-3 * np.abs(plain.motion.a).max())
    names = ["time", *(f"F_{leg}" for leg in range(1, 7))]
    time, *_ = read_leg_columns(write(tmp_path / "forces.csv", names, rows), PLAIN, (FORCES,))
    np.testing.assert_array_equal(time, found.time)
