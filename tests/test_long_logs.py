"""Logs of a million rows: memory grows with the numbers that are kept, not with what is on its way."""

import tracemalloc

import numpy as np
import pytest

import stewart_sym as ss
from stewart_sym.interpolation import between
from stewart_sym.logs import LogFormat, read_columns
from stewart_sym.robots import dasgupta1998
from stewart_sym.studies import track
from stewart_sym.studies.output import csv_lines
from stewart_sym.trajectory import Trajectory


def peak(action: object) -> tuple[object, int]:
    """What a function returns, and the most bytes that it had beside those it began with."""
    tracemalloc.start()
    try:
        found = action()  # type: ignore[operator]
        return found, tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


def trajectory(count: int) -> Trajectory:
    path = ss.PATHS["I"].path
    time = np.linspace(0.0, path.tau_f, count)
    return Trajectory(time, path.sample(time), "path", range(2, count + 2))


def test_lines_of_many_rows_take_a_part_of_the_room_of_their_columns() -> None:
    columns = {name: np.random.default_rng(0).normal(size=100_000) for name in "abcdefgh"}
    _, most = peak(lambda: sum(len(line) for line in csv_lines(columns)))
    assert most < 0.5 * sum(column.nbytes for column in columns.values())


@pytest.mark.parametrize("count", [0, 1, 4095, 4096, 4097, 10_000])
def test_lines_hold_every_row_with_all_its_digits(count: int) -> None:
    columns = {"a": np.random.default_rng(1).normal(size=count), "n": np.arange(count)}
    head, *rows = csv_lines(columns)
    assert head == "a,n\n"
    assert rows == [f"{a!r},{n}\n" for a, n in zip(columns["a"].tolist(), range(count), strict=True)]


def test_columns_are_read_in_little_more_than_three_times_the_text() -> None:
    rng = np.random.default_rng(2)
    numbers = {name: rng.normal(size=50_000) for name in "abcd"}
    text = "".join(csv_lines({"time": np.arange(50_000.0), **numbers}))
    (columns, rows), most = peak(lambda: read_columns(text, "log", lambda *_: None, LogFormat()))  # type: ignore[misc]
    assert (len(columns["time"]), rows[0], rows[-1]) == (50_000, 2, 50_001)
    assert most < 3.5 * len(text)


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_line_ends_of_all_systems_are_read(end: str) -> None:
    text = end.join(["time,a", "0.0,1.5", "1.0,2.5", ""])
    columns, rows = read_columns(text, "log", lambda *_: None, LogFormat())
    assert columns["a"].tolist() == [1.5, 2.5]
    assert list(rows) == [2, 3]


def test_a_track_in_parts_is_that_of_the_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    robot, given = dasgupta1998(), trajectory(100)
    whole = track.track(robot, given)
    monkeypatch.setattr(track, "_PART", 16)
    parts = track.track(robot, given)
    assert parts.summary == whole.summary
    for name, column in whole.columns.items():
        assert np.array_equal(column, parts.columns[name]), name


def test_a_track_takes_a_part_of_the_room_of_all_outputs(monkeypatch: pytest.MonkeyPatch) -> None:
    robot, given = dasgupta1998(), trajectory(20_000)
    monkeypatch.setattr(track, "_PART", 1024)
    track.track(robot, trajectory(100))
    _, most = peak(lambda: track.track(robot, given))
    assert most < 20_000 * 8 * 60


def test_a_path_between_many_instants_takes_no_room_of_its_own() -> None:
    given = trajectory(50_000)
    path, most = peak(lambda: between(given))
    assert most < given.time.nbytes
    assert path(given.time[7:9]).t == pytest.approx(given.motion.t[7:9], abs=1e-12)  # type: ignore[operator]
