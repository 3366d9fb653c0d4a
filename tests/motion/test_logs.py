"""Logs as other programs write them: names, units, marks, Euler orders; doubtful units are warned of."""

import dataclasses
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command_line import Run, rejects
from log_files import NAMES, poses, write
from machines import Array, home_position, machine_size, random_robot
from robot_files import PAPERS

import stewart_sym as ss
from stewart_sym.kinematics.trajectory_checks import side_doubt
from stewart_sym.motion.log_reader import FORCES, PLAIN, read_csv, read_leg_columns
from stewart_sym.motion.logs import EULER_ORDERS, TrajectoryFormat
from stewart_sym.motion.rotation import quaternion_from_rotation, rotation_from_rpy
from stewart_sym.motion.trajectory import Trajectory


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


def test_poses_on_the_other_side_of_the_base_are_doubted() -> None:
    gravity, where = -9.81, "below the base"
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
