"""Logs of other programs: files, units, times, and columns; one error for each rule."""

import dataclasses
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command_line import rejects
from log_files import LENGTHS, NAMES, RATES, poses, write
from machines import Array, dasgupta
from motion_fields import motion_of
from plain_logs import read_log, read_poses

import stewart_sym as ss
from stewart_sym.kinematics.inverse_kinematics import leg_lengths
from stewart_sym.kinematics.robot_logs import read_log_of
from stewart_sym.motion.log_samples import components_of, read_samples

pytestmark = pytest.mark.filterwarnings("ignore::stewart_sym.TrajectoryWarning")
TABLE = poses()
Form = ss.TrajectoryFormat
PLAIN = Form()


def text_of(names: list[str], table: Array, delimiter: str = ",", decimal: str = ".", end: str = "\n") -> str:
    """Return the text of a file with six decimals."""
    rows = [delimiter.join(f"{x:.6f}".replace(".", decimal) for x in row) for row in table]
    return end.join([delimiter.join(names), *rows]) + end


def log(folder: Path, content: str | bytes) -> Path:
    path = folder / "log.csv"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


def same_poses(path: Path, form: Form = PLAIN, table: Array = TABLE) -> None:
    """The file must contain the poses and times of a table."""
    found = read_log(path, form)
    np.testing.assert_allclose(found.coordinates[0], table[:, 1:], atol=2e-6)
    np.testing.assert_allclose(found.time - found.time[0], table[:, 0] - table[0, 0], atol=2e-6)


# Files


@pytest.mark.parametrize(
    ("delimiter", "decimal"), [(",", "."), (";", "."), (";", ","), ("\t", "."), ("\t", ",")]
)
def test_delimiters_and_decimal_marks_are_detected(tmp_path: Path, delimiter: str, decimal: str) -> None:
    content = text_of(NAMES, TABLE, delimiter, decimal)
    same_poses(log(tmp_path, content))
    same_poses(log(tmp_path, f"sep={delimiter}\n{content}"))
    same_poses(
        log(tmp_path, content), Form(decimal="point" if decimal == "." and delimiter != "," else "comma")
    )


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16", "cp1252"])
def test_encodings_and_line_ends_of_windows_are_read(tmp_path: Path, encoding: str) -> None:
    content = "# Messung über 2 s\n\n" + text_of(NAMES, TABLE, ";", ",", "\r\n")
    same_poses(log(tmp_path, content.encode(encoding)))


@pytest.mark.parametrize(
    "head",
    [
        "sep=,\n" + ",".join(NAMES),
        "# " + ",".join(NAMES),
        "Time,Surge,Sway,Heave,Roll,Pitch,Yaw",
        "timestamp,X,Y,Z,roll (rad),pitch (rad),yaw (rad)",
        ",".join(f'"{name}"' for name in NAMES),
        "time,t.x,t-y,t z,theta_x,theta_y,theta_z",
        ",".join(NAMES) + "\ns,m,m,m,rad,rad,rad",
    ],
)
def test_headers_of_other_programs_are_read(tmp_path: Path, head: str) -> None:
    rows = text_of(NAMES, TABLE).split("\n", 1)[1]
    same_poses(log(tmp_path, f"{head}\n{rows}"))


def test_columns_in_any_order_with_derivatives_and_loads_are_used_as_they_are(tmp_path: Path) -> None:
    time = np.linspace(0.0, 1.0, 21)
    q = np.array([0.03 * np.sin(time[:, None] * 3 + np.arange(6) + k * np.pi / 2) * 3.0**k for k in range(3)])
    loads = np.random.default_rng(3).normal(size=(21, 6))
    names = [*NAMES, *RATES, *(f"{name}_{axis}" for name in ("F_ext", "M_ext") for axis in "xyz")]
    order = np.random.default_rng(4).permutation(len(names))
    table = np.column_stack([time, *q, loads])
    found = read_log(write(tmp_path / "log.csv", [names[i] for i in order], table[:, order])).motion
    expected = motion_of(q, F_ext=loads[:, :3], M_ext=loads[:, 3:])
    for name in ("R", "t", "omega", "v", "alpha", "a", "F_ext", "M_ext"):
        np.testing.assert_allclose(getattr(found, name), getattr(expected, name), atol=1e-14)


def test_quaternions_are_poses(tmp_path: Path) -> None:
    angle = 0.5 * TABLE[:, 6]
    zero = np.zeros(len(angle))
    table = np.column_stack([TABLE[:, :4], np.cos(angle), zero, zero, np.sin(angle)])
    path = write(tmp_path / "log.csv", [*NAMES[:4], "q_w", "q_x", "q_y", "q_z"], table)
    same_poses(path, table=TABLE * [1, 1, 1, 1, 0, 0, 1])


# Units


@pytest.mark.parametrize("place", ["option", "header", "suffix", "row"])
def test_units_come_from_options_headers_suffixes_or_a_row(tmp_path: Path, place: str) -> None:
    table = TABLE * [1e3, *[1e3] * 3, *[180.0 / np.pi] * 3]
    units, form = ["ms", *["mm"] * 3, *["deg"] * 3], Form()
    names, row = NAMES, ""
    if place == "option":
        form = Form(length_unit="mm", angle_unit="deg", time_unit="ms")
    elif place == "header":
        names = [f"{name} [{unit}]" for name, unit in zip(NAMES, units, strict=True)]
    elif place == "suffix":
        names = [f"{name}_{unit}" for name, unit in zip(NAMES, units, strict=True)]
    else:
        row = ",".join(units) + "\n"
    head, rows = text_of(names, table).split("\n", 1)
    same_poses(log(tmp_path, f"{head}\n{row}{rows}"), form)


def test_an_option_outranks_the_header_with_a_warning(tmp_path: Path) -> None:
    names = ["time", "t_x [m]", *NAMES[2:]]
    path = log(tmp_path, text_of(names, TABLE * [1, *[1e3] * 3, 1, 1, 1]))
    with pytest.warns(ss.TrajectoryWarning, match="unit m contradicts length_unit=mm, which is used"):
        same_poses(path, Form(length_unit="mm"))


# Times


def stamp(seconds: float, form: str) -> str:
    """Return an instant after 14:03:20 UTC on 2023-11-14 as text."""
    ns = 1_699_970_600_000_000_000 + round(seconds * 1e9)
    if form in ("ns", "us", "ms", "s"):
        divisor = {"ns": 1, "us": 1_000, "ms": 1_000_000, "s": 1_000_000_000}[form]
        return str(ns // divisor) if form != "s" else f"{ns / 1e9:.6f}"
    text = str(np.datetime64(ns, "ns"))[:26]
    return {"iso": text, "zulu": f"{text}Z", "blank": text.replace("T", " "), "clock": text[11:]}[form]


@pytest.mark.parametrize("form", ["ns", "us", "ms", "s", "iso", "zulu", "blank", "clock"])
def test_dates_and_times_since_1970_are_times(tmp_path: Path, form: str) -> None:
    rows = text_of(NAMES[1:], TABLE[:, 1:]).splitlines()
    times = ["time", *(stamp(float(x), form) for x in TABLE[:, 0])]
    same_poses(log(tmp_path, "\n".join(f"{a},{b}" for a, b in zip(times, rows, strict=True))))


def test_times_of_day_continue_after_midnight(tmp_path: Path) -> None:
    rows = text_of(NAMES[1:], TABLE[:, 1:]).splitlines()
    times = [str(np.datetime64("2025-12-31T23:59:59.5", "ms") + round(1e3 * x))[11:] for x in TABLE[:, 0]]
    same_poses(
        log(tmp_path, "\n".join(f"{a},{b}" for a, b in zip(["time [hh:mm:ss]", *times], rows, strict=True)))
    )


def test_rows_at_a_rate_have_times_also_behind_a_row_without_numbers(tmp_path: Path) -> None:
    lines = text_of(NAMES[1:], TABLE[:, 1:]).splitlines()
    lines[9], lines[10] = "0.1,0", "0.1,,0.3,0,0,0"
    found = read_log(log(tmp_path, "\n".join(lines)), Form(row_rate=20.0))
    np.testing.assert_allclose(found.time, np.delete(TABLE[:, 0], [8, 9]), atol=1e-12)
    assert list(found.rows[:10]) == [*range(2, 10), 12, 13]


def test_poses_without_times_are_static(tmp_path: Path) -> None:
    path = log(tmp_path, text_of(NAMES[1:], TABLE[:, 1:]))
    found = read_log(path)
    assert not found.coordinates[1:].any()
    R, t = read_poses(path)
    np.testing.assert_allclose(t, TABLE[:, 1:4], atol=1e-6)
    np.testing.assert_allclose(R, found.motion.R)


# Columns


def test_offsets_and_scales_apply_in_units_of_the_column(tmp_path: Path) -> None:
    table = TABLE * [1, 1e3, 1e3, -1e3, 1, 1, 1] - [0, 0, 0, -250.0, 0, 0, 0]
    form = Form(length_unit="mm", scales={"t_z": -1.0}, offsets={"t_z": 250.0})
    same_poses(log(tmp_path, text_of(NAMES, table)), form)


def test_named_columns_are_used_and_others_are_ignored(tmp_path: Path) -> None:
    names = ["time", "t_x", "t_y", "laser 7", "theta_x", "theta_y", "theta_z", "t_z", "note"]
    table = np.column_stack([TABLE, np.ones((len(TABLE), 2))])
    same_poses(log(tmp_path, text_of(names, table)), Form(columns={"t_z": "laser 7"}))


def test_dropped_lines_are_not_used(tmp_path: Path) -> None:
    table = TABLE.copy()
    table[[4, 5], 1] = 9.0
    found = read_log(log(tmp_path, text_of(NAMES, table)), Form(drop_lines=(6, 7)))
    assert list(found.rows) == [*range(2, 6), *range(8, 43)]


def test_rows_without_numbers_are_counted_in_one_warning(tmp_path: Path) -> None:
    lines = text_of(NAMES, TABLE).splitlines()
    for i, bad in ((3, "nan"), (9, "sensor lost"), (10, "-,-"), (20, "")):
        lines[i] = ",".join([lines[i].split(",")[0], bad, *lines[i].split(",")[2:]])
    path = log(tmp_path, "\n".join(lines))
    with pytest.warns(ss.TrajectoryWarning, match=r"rows without numbers \(lines 4, 10-11, 21\); they are"):
        assert len(read_log(path).rows) == len(TABLE) - 4


def test_poses_and_lengths_relative_to_the_home_pose_become_absolute(tmp_path: Path) -> None:
    robot = dataclasses.replace(dasgupta(), home_position=np.array([0.2, 0.0, 0.5]), tool=np.zeros(3))
    home = np.array([0, 0.2, 0.0, 0.5, 0, 0, 0])
    found = read_log_of(robot, log(tmp_path, text_of(NAMES, TABLE - home)), Form(pose_mode="relative"))
    np.testing.assert_allclose(found.coordinates[0], TABLE[:, 1:], atol=1e-6)
    L = leg_lengths(robot, found.motion.R, found.motion.t)
    lengths = np.column_stack([TABLE[:, 0], L - leg_lengths(robot, np.eye(3), robot.home_position)])
    path = log(tmp_path, text_of(["time", *LENGTHS], lengths))
    relative = Form(length_mode="relative")
    np.testing.assert_allclose(read_log_of(robot, path, relative).lengths[0], L, atol=2e-6)
    L[3, 1] = -0.1
    wrong = write(tmp_path / "wrong.csv", ["time", *LENGTHS], np.column_stack([TABLE[:, 0], L]))
    rejects("line 5: L_2: -0.1 m is no length; check length_mode", read_log_of, robot, wrong)
    bare = dataclasses.replace(robot, home_position=None)
    rejects("relative coordinates; add home_position", read_log_of, bare, path, relative)


def test_wrapped_angles_give_smooth_rates(tmp_path: Path) -> None:
    time = np.linspace(0.0, 4.0, 60)
    wrapped = (2.0 * time + np.pi) % (2.0 * np.pi) - np.pi
    table = np.column_stack([time, np.zeros((60, 2)), np.ones(60), np.zeros((60, 2)), wrapped])
    motion = read_log(write(tmp_path / "log.csv", NAMES, table)).motion
    np.testing.assert_allclose(motion.omega, np.tile([0.0, 0.0, 2.0], (60, 1)), atol=1e-7)


@pytest.mark.parametrize(
    ("names", "vector", "factor"),
    [
        (components_of("F"), "F", 1.0),
        ([f"Force{leg} [kN]" for leg in range(1, 7)], "F", 1e3),
        ([f"current_{leg}_mA" for leg in range(1, 7)], "current", 1e-3),
    ],
)
def test_forces_and_currents_are_read_with_units_and_dates(
    names: list[str], vector: str, factor: float, tmp_path: Path
) -> None:
    numbers = np.arange(30.0).reshape(5, 6)
    table = np.column_stack([np.arange(5.0) * 1e3, numbers])
    path = log(tmp_path, text_of(["t_ms", *names], table, ";", ","))
    found = read_samples(str(path), forces=True)
    np.testing.assert_allclose(found.time, np.arange(5.0))
    np.testing.assert_allclose(found.vectors[vector], factor * numbers)
    rows = [f"2025-11-29T23:59:{57 + i}Z,0,1,2,3,4,5" for i in range(3)]
    dated = read_samples(str(log(tmp_path, "\n".join([",".join(["time", *names]), *rows]))), forces=True)
    np.testing.assert_allclose(dated.time, np.arange(3.0))
    assert dated.start == 1_764_460_797.0


# Errors


def lines(**changes: str) -> str:
    """Return the text of a good log with changed lines, such as ``line_3``."""
    found = text_of(NAMES, TABLE[:12]).splitlines()
    for name, line in changes.items():
        found[int(name.removeprefix("line_")) - 1] = line
    return "\n".join(found)


HEAD = ",".join(NAMES)
ERRORS: dict[str, tuple[str, Form, str]] = {
    "empty": ("", Form(), ": the file is empty; write a header line"),
    "no header": ("0,1,2,3\n1,2,3,4\n", Form(), ": line 1: no header line; name the columns"),
    "no rows": (HEAD + "\n", Form(), ": no rows of numbers below the header; add rows"),
    "few rows": (
        "\n".join(lines().splitlines()[:4]),
        Form(),
        ": too few rows for rates, 3; add rows",
    ),
    "other cells": (HEAD + "\n1;2\n3;4\n", Form(), ": line 2: expected 7 cells as in the header; check "),
    "no numbers": (
        HEAD + "\n" + "\n".join(f"{i},0,0,nan,0,0,0" for i in range(9)),
        Form(),
        ": line 2: column t_z: expected a number or a time, got 'nan'; check decimal, name another column",
    ),
    "other dates": (
        HEAD + "\n" + "\n".join(f"31.12.2025 10:00:0{i},0,0,0,0,0,0" for i in range(9)),
        Form(),
        ": line 2: column time: expected a number or a time, got '31.12.2025 10:00:00'; check ",
    ),
    "other name of times": (
        lines(line_1=HEAD.replace("time", "Zeit_ms")),
        Form(),
        ": no column of times; state columns time=Zeit_ms, or remove this column",
    ),
    "missing column": (
        lines(line_1=HEAD.replace("theta_z", "turn")),
        Form(),
        ": no column theta_z; name it with columns theta_z=HEADER; other columns: turn",
    ),
    "two columns": (
        lines(line_1=HEAD.replace("theta_z", "Surge")),
        Form(),
        ": columns 't_x' and 'Surge' are both t_x; rename one of them",
    ),
    "unknown header": (
        lines(),
        Form(columns={"t_x": "left"}),
        ": no column 'left', given for t_x; columns: ",
    ),
    "unknown name": (lines(), Form(columns={"t_u": "t_x"}), "columns: t_u: unknown name; use one of time, "),
    "unknown unit": (
        lines(line_1=HEAD.replace("t_x", "t_x [furlong]")),
        Form(),
        ": column t_x: unknown unit 'furlong'; convert it to one of m, cm, mm, in",
    ),
    "two units": (
        lines(line_1=HEAD.replace("t_x", "t_x [mm]").replace("t_y", "t_y [cm]")),
        Form(),
        ": column t_y: cm and mm in one file; use one length_unit",
    ),
    "two kinds": (
        lines(line_1=HEAD.replace("theta_z", "L_1")),
        Form(),
        ": columns of poses and of leg lengths; select one kind with columns",
    ),
    "decreasing": (
        lines(line_5="0.01,0.1,0,0.5,0,0,0"),
        Form(),
        ": line 5: time: 0.01 follows 0.1; sort the rows or drop the line",
    ),
    "rate and times": (lines(), Form(row_rate=5.0), ": row_rate: the file has times; omit row_rate"),
}


@pytest.mark.parametrize("rule", ERRORS)
def test_a_file_that_cannot_be_read_is_named_with_line_and_remedy(tmp_path: Path, rule: str) -> None:
    content, form, expected = ERRORS[rule]
    path = log(tmp_path, content)
    place = "" if expected.startswith("columns") else f"{path}"
    rejects("^" + re.escape(f"{place}{expected}"), read_log, path, form)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: Form(length_unit="mile"), "length_unit: expected "),
        (lambda: Form(columns={"t_x": 3}), "columns: expected a mapping of names to names"),  # type: ignore[dict-item]
        (lambda: Form(scales={"t_x": np.inf}), "scales: t_x: expected a finite number"),
        (lambda: Form(row_rate=0.0), "row_rate: expected a frequency > 0 Hz"),
        (lambda: Form(pose_mode="home"), "pose_mode: expected "),
        (lambda: ss.SmoothingOptions(position_std=-1.0), "position_std: expected a number > 0, got -1"),
    ],
)
def test_bad_arguments_are_named(call: Callable[[], Any], text: str) -> None:
    rejects(f"^{text}", call)
