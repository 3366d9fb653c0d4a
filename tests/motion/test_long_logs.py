"""Logs of a million rows: memory grows with the numbers that are kept, not with what is on its way."""

import dataclasses
import os
import threading
from collections.abc import Callable
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
import whole_track
from command_line import Run
from log_files import POSE, RATES
from robot_files import PAPERS

import stewart_sym as ss
from stewart_sym.motion.log_reader import read_csv
from stewart_sym.motion.logs import TrajectoryFormat, read_columns
from stewart_sym.motion.trajectory import Trajectory
from stewart_sym.robots import dasgupta1998
from stewart_sym.studies.common.output import csv_lines
from stewart_sym.studies.reports import track


def trajectory(count: int) -> Trajectory:
    path = ss.PAPER_PATHS["I"].path
    time = np.linspace(0.0, path.tau_f, count)
    return Trajectory(time, path.sample(time), "path", range(2, count + 2))


@pytest.mark.parametrize("count", [0, 4096, 4097])
def test_lines_hold_every_row_with_all_its_digits(count: int) -> None:
    columns = {"a": np.random.default_rng(1).normal(size=count), "n": np.arange(count)}
    head, *rows = "".join(csv_lines(columns)).splitlines(keepends=True)
    assert head == "a,n\n"
    cells = [row.removesuffix("\n").split(",") for row in rows]
    assert [(float(a), n) for a, n in cells] == [(a, f"{n}") for n, a in enumerate(columns["a"].tolist())]


def test_every_number_is_read_back_as_it_was() -> None:
    """Those that are none, the largest, the smallest, negative zero and any bits."""
    bits = np.random.default_rng(5).integers(0, 2**64, 20_000, dtype=np.uint64, endpoint=False)
    special = [np.nan, np.inf, -np.inf, -0.0, 5e-324, 1.7976931348623157e308, 1e16, 1e-5, 0.1]
    given = np.concatenate([special, bits.view(np.float64)])
    _, *rows = "".join(csv_lines({"a": given, "n": np.arange(len(given))})).splitlines()
    assert rows[:3] == ["nan,0", "inf,1", "-inf,2"]
    found = np.array([float(row.partition(",")[0]) for row in rows])
    known = ~np.isnan(given)
    assert (np.isnan(found) == ~known).all()
    assert (found[known].view(np.int64) == given[known].view(np.int64)).all()


def full_log(path: Path, count: int) -> Path:
    """A log with rates and accelerations."""
    time = np.linspace(0.0, 6.0, count)
    rate = 0.4 * np.arange(1.0, 7.0)
    angle = np.outer(time, rate)
    q = [0.2, 0.0, 0.5, 0.0, 0.0, 0.0] + 0.02 * np.sin(angle)
    table = np.hstack([q, 0.02 * rate * np.cos(angle), -0.02 * rate**2 * np.sin(angle)])
    path.write_text("".join(csv_lines({"time": time} | dict(zip([*POSE, *RATES], table.T, strict=True)))))
    return path


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (
            lambda lines: [*lines[:9000], lines[9000].replace(b",", b",x", 1), *lines[9001:]],
            "line 9001: t_x: ",
        ),
        (lambda lines: [*lines[:9000], lines[8000]], "line 9001: time: expected increasing times"),
    ],
)
def test_what_is_wrong_deep_in_a_log_is_named_and_nothing_is_written(
    tmp_path: Path, run: Run, spoil: Callable[[list[bytes]], list[bytes]], words: str
) -> None:
    log = full_log(tmp_path / "log.csv", 10_000)
    log.write_bytes(b"".join(spoil(log.read_bytes().splitlines(keepends=True))))
    told = run("forces", PAPERS, log, "-o", "-", code=2)
    assert told.out == ""
    assert words in told.err
    assert len(told.err.splitlines()) == 1


def test_blank_lines_and_quoted_cells_deep_in_a_log_keep_numbers_and_rows(tmp_path: Path) -> None:
    log = full_log(tmp_path / "log.csv", 10_000)
    plain = read_columns(BytesIO(log.read_bytes()), "log", lambda *_: None, TrajectoryFormat())
    lines = log.read_text().splitlines()
    lines[9000] = ",".join(f'"{cell}"' for cell in lines[9000].split(","))
    lines.insert(9500, "")
    odd, rows, *_ = read_columns(
        BytesIO("\n".join([*lines, "", ""]).encode()), "log", lambda *_: None, TrajectoryFormat()
    )
    for name, column in plain[0].items():
        assert np.array_equal(column, odd[name]), name
    assert list(rows) == [*range(2, 9501), *range(9502, 10_003)]


def test_a_log_from_a_pipe_is_read_as_from_a_file(tmp_path: Path) -> None:
    log = full_log(tmp_path / "log.csv", 5000)
    pipe = tmp_path / "pipe.csv"
    os.mkfifo(pipe)
    writer = threading.Thread(target=lambda: pipe.write_bytes(log.read_bytes()))
    writer.start()
    found, plain = read_csv(pipe), read_csv(log)
    writer.join()
    assert np.array_equal(found.motion.R, plain.motion.R)


def test_columns_limits_and_peaks_of_parts_are_those_of_the_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    robot, given = dasgupta1998(), trajectory(250)
    F = ss.inverse_dynamics(robot, given.motion).F
    tight = dataclasses.replace(
        robot,
        force_limit=np.full(6, 0.5 * np.abs(F).max()),
        speed_limit=np.full(6, 0.02),
        length_limits=np.tile([0.5, 0.6], (6, 1)),
    )
    whole = whole_track.track(tight, given)
    monkeypatch.setattr(track, "_PART", 7)
    parts = whole_track.track(tight, given)
    assert (parts.summary, parts.doubts) == (whole.summary, whole.doubts)
    for name, column in whole.columns.items():
        assert np.array_equal(column, parts.columns[name]), name
    assert {line.split()[0] for line in whole.doubts} == {"force_limit", "speed_limit", "length_limits"}
