"""Logs as loggers and spreadsheets write them: lines above the numbers, encodings, times, repeated rows."""

import datetime
from pathlib import Path

import numpy as np
import pytest
from command_line import rejects
from log_files import NAMES, RATES, poses

from stewart_sym.motion.log_reader import FORCES, read_csv, read_leg_columns
from stewart_sym.motion.logs import TrajectoryFormat
from stewart_sym.motion.noise_level import TrajectoryWarning
from stewart_sym.motion.trajectory import Trajectory

OWN = ["Zeit [s]", "X [mm]", "Y [mm]", "Z [mm]", "Roll [°]", "Pitch [°]", "Yaw [°]"]
MARKED = TrajectoryFormat(dict(zip(NAMES, OWN, strict=True)))


def lines(names: list[str] = NAMES, delimiter: str = ",", decimal: str = ".", count: int = 41) -> list[str]:
    """A header and rows of numbers."""
    rows = [delimiter.join(f"{x:.9f}".replace(".", decimal) for x in row) for row in poses(count)]
    return [delimiter.join(names), *rows]


def read(folder: Path, text: list[str] | bytes, form: TrajectoryFormat | None = None) -> Trajectory:
    path = folder / "log.csv"
    path.write_bytes(text if isinstance(text, bytes) else ("\n".join(text) + "\n").encode())
    return read_csv(path, form or TrajectoryFormat())


def alike(found: Trajectory, plain: Trajectory) -> None:
    """Times, poses and accelerations are the same to the last bit."""
    assert np.array_equal(found.time, plain.time)
    assert np.array_equal(found.motion.t, plain.motion.t)
    assert np.array_equal(found.motion.a, plain.motion.a)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "cp1252"])
@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_encodings_of_spreadsheets_are_read(tmp_path: Path, encoding: str, end: str) -> None:
    text = end.join([*lines(OWN, ";", ","), ""])
    alike(read(tmp_path, text.encode(encoding), MARKED), read(tmp_path, lines()))


def test_a_code_page_below_the_header_is_no_text(tmp_path: Path) -> None:
    rows = [f"{line};\xfcber" for line in lines(OWN, ";")]
    with pytest.raises(ValueError, match=r"expected UTF-8 text, byte \d+ is not: save it as UTF-8$"):
        read(tmp_path, "\n".join(rows).encode("cp1252"), MARKED)


@pytest.mark.parametrize(
    "above", [["sep=;"], ["sep=;", "", ";;;"], ["# Logger 2.3, A", "% m", ""], ['"sep=;"', "# 1;2;3"]]
)
def test_lines_above_the_header_are_passed_over(tmp_path: Path, above: list[str]) -> None:
    decimal = ","
    plain = read(tmp_path, lines())
    found = read(tmp_path, [*above, *lines(NAMES, ";", decimal)])
    alike(found, plain)
    assert found.rows[0] == len(above) + 2


@pytest.mark.parametrize("mark", ["# ", "%"])
def test_names_in_a_comment_above_bare_numbers_are_the_header(tmp_path: Path, mark: str) -> None:
    header, *rows = lines()
    alike(read(tmp_path, ["# run 7", mark + header, *rows]), read(tmp_path, [header, *rows]))
    own = dict(zip(NAMES, [mark + "time", *NAMES[1:]], strict=True))
    alike(read(tmp_path, [mark + header, *rows], TrajectoryFormat(own)), read(tmp_path, [header, *rows]))


UNITS = TrajectoryFormat(length_unit="mm", angle_unit="deg", time_unit="ms")


@pytest.mark.parametrize(
    "units", ["ms,mm,mm,mm,°,°,°", "[ms],[mm],[mm],[mm],[deg],[deg],[deg]", "(ms),mm,,,,degrees,"]
)
@pytest.mark.parametrize("form", [TrajectoryFormat(), UNITS])
def test_a_row_of_units_is_as_if_they_were_given(tmp_path: Path, units: str, form: TrajectoryFormat) -> None:
    header, *rows = lines()
    plain = read(tmp_path, [header, *rows], UNITS)
    found = read(tmp_path, [header, "", units, *rows], form)
    alike(found, plain)
    assert found.rows[0] == 4


def test_a_delimiter_at_the_end_of_every_line_makes_no_column(tmp_path: Path) -> None:
    alike(read(tmp_path, [line + "," for line in lines()], UNITS), read(tmp_path, lines(), UNITS))


def test_columns_between_blanks_are_named(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="expected commas, semicolons or tabs between columns"):
        read(tmp_path, [line.replace(",", "  ") for line in lines()])


def test_rates_and_loads_have_units_too(tmp_path: Path) -> None:
    names = [*NAMES, *RATES, "F_ext_x", "F_ext_y", "F_ext_z"]
    units = "s,m,m,m,rad,rad,rad,m/s,m/s,m/s,rad/s,rad/s,rad/s,m/s²,m/s^2,m/s2,rad/s²,,,N,N,[N]"
    rows = [",".join([f"0.{i}", *["0"] * 21]) for i in range(1, 6)]
    assert len(read(tmp_path, [",".join(names), units, *rows]).time) == 5
    for right, wrong, told in (
        ("[N]", "kN", "line 2: F_ext_z: .* in a row of units N, got 'kN'"),
        ("m/s2", "m/s", "line 2: a_z: .* in a row of units m/s2 or cm/s2 or mm/s2 or in/s2, got 'm/s'"),
    ):
        rejects(told, read, tmp_path, [",".join(names), units.replace(right, wrong), *rows])


@pytest.mark.parametrize(
    ("units", "told"),
    [
        ("min,m,m,m,rad,rad,rad", "time: .* row of units s or ms or us, got 'min': convert the"),
        ("s,m,m,m,gon,gon,gon", "theta_x: .* row of units rad or deg, got 'gon': convert"),
        ("s,m,mm,m,rad,rad,rad", "t_y: expected one length_unit in the row of units, got mm and m$"),
    ],
)
def test_units_that_are_none_or_others_are_named(tmp_path: Path, units: str, told: str) -> None:
    header, *rows = lines()
    rejects(f"line 2: {told}", read, tmp_path, [header, units, *rows], TrajectoryFormat(length_unit="m"))


def test_an_option_has_priority_over_the_row_of_units_with_a_warning(tmp_path: Path) -> None:
    header, *rows = lines()
    form = TrajectoryFormat(length_unit="cm")
    told = r"line 2: the row of units \(mm\) contradicts TrajectoryFormat\(length_unit='cm'\), which is used"
    with pytest.warns(TrajectoryWarning, match=told):
        found = read(tmp_path, [header, "s,mm,mm,mm,rad,rad,rad", *rows], form)
    np.testing.assert_allclose(found.motion.t, read(tmp_path, [header, *rows], form).motion.t)


def test_rows_written_twice_are_taken_once_and_counted(tmp_path: Path) -> None:
    header, *rows = lines()
    plain = read(tmp_path, [header, *rows])
    with pytest.warns(
        TrajectoryWarning, match=r": 3 rows have the time and .* the first is line 7: taken once$"
    ) as told:
        found = read(tmp_path, [header, *rows[:5], rows[4], *rows[5:9], *rows[8:], rows[-1]])
    alike(found, plain)
    assert [found.rows[i] for i in (4, 5, 40)] == [6, 8, 44]
    assert {each.filename for each in told} == {__file__}
    other = rows[5].rpartition(",")[0] + ",0.5"
    with pytest.raises(ValueError, match=r"line 8: time: expected increasing times, got 0.25 after"):
        read(tmp_path, [header, *rows[:6], other, *rows[6:]])


@pytest.mark.parametrize(("form", "row"), [(TrajectoryFormat(), 2), (TrajectoryFormat(decimal="comma"), 5)])
def test_thousands_separators_are_named_in_their_own_cell(
    tmp_path: Path, form: TrajectoryFormat, row: int
) -> None:
    text = lines(NAMES, ";", ",")
    cells = text[row - 1].split(";")
    cells[3] = "3.400,00"
    text[row - 1] = ";".join(cells)
    rejects(rf"line {row}: t_z: .* got '3.400,00': thousands separators are not", read, tmp_path, text, form)


def test_a_point_beside_decimal_commas_is_no_decimal_mark(tmp_path: Path) -> None:
    header, *rows = lines(NAMES, ";", ",")
    rows[3] = rows[3].replace(",", ".", 2)
    with pytest.raises(ValueError, match=r"line 5: time: .*: decimals have a comma .*, thousands"):
        read(tmp_path, [header, *rows], TrajectoryFormat(decimal="comma"))


START = datetime.datetime(2026, 11, 26, 23, 59, 30, 125_000)


@pytest.mark.parametrize(
    ("stamp", "start"),
    [
        ("%Y-%m-%d %H:%M:%S.%f", START),
        ("%Y-%m-%dT%H:%M:%S.%fZ", START.replace(second=59)),
        ("%Y-%m-%d %H:%M:%S.%f+01:00", START),
        ("%H:%M:%S.%f", START),
        ("%-H:%M:%S.%f", START.replace(hour=9)),
    ],
)
def test_dates_and_times_of_day_are_seconds_since_the_first_row(
    tmp_path: Path, stamp: str, start: datetime.datetime
) -> None:
    decimal = ","
    plain = read(tmp_path, lines())
    header, *rows = lines(NAMES, ";", decimal)
    stamped = [
        f"{(start + datetime.timedelta(seconds=t)).strftime(stamp)};{row.partition(';')[2]}"
        for t, row in zip(plain.time.tolist(), rows, strict=True)
    ]
    alike(read(tmp_path, [header, *stamped]), plain)


@pytest.mark.parametrize(
    ("times", "told"),
    [
        (
            ["23:59:59.9", "00:00:00.1"],
            "line 3: time: expected increasing times, got 00:00:00.1 after 23:59:59.9: past midnight dates",
        ),
        (["31.03.2024 01:59:40,0"], "line 2: time: .* '31.03.2024 01:59:40,0': dates as"),
        (["10:00:00", "0.5"], "line 3: time: expected a time of day as in the first row, got"),
        (["0.5", "10:00:00"], "line 3: time: expected a finite number, got '10:00:00': dates as"),
        (["2026-11-26 10:00", "10:01"], "line 3: time: expected a date and time as in the first"),
        (["2026-13-26 10:00"], "line 2: time: expected a finite number, got '2026-13-26 10:00'"),
        (["10:00:00"], "line 2: time: expected ms .time_unit=ms"),
    ],
)
def test_times_that_are_not_read_are_named(tmp_path: Path, times: list[str], told: str) -> None:
    rows = [f"{time};0.2;0;0.5;0;0;0" for time in times]
    form = TrajectoryFormat(time_unit="ms" if "ms" in told else "s")
    rejects(told, read, tmp_path, [";".join(NAMES), *rows], form)


@pytest.mark.parametrize(("row", "step"), [("", 1e-3), ("s,N,N,N,N,N,N\n", 1.0), ("us,,,,,,\n", 1e-6)])
def test_forces_are_of_the_unit_of_time_of_their_own_row_of_units_or_else_of_the_given_one(
    tmp_path: Path, row: str, step: float
) -> None:
    path = tmp_path / "forces.csv"
    path.write_text(f"time,F_1,F_2,F_3,F_4,F_5,F_6\n{row}0,1,2,3,4,5,6\n1,1,2,3,4,5,7\n")
    assert read_leg_columns(path, TrajectoryFormat(time_unit="ms"), (FORCES,))[0].tolist() == [0.0, step]
