"""Logs as loggers and spreadsheets write them: lines above the numbers, encodings, times, repeated rows."""

from pathlib import Path

import numpy as np
import pytest
from log_files import NAMES
from numpy.typing import NDArray

from stewart_sym.motion.log_reader import read_csv
from stewart_sym.motion.logs import LogFormat
from stewart_sym.motion.trajectory import Trajectory

OWN = ["Zeit [s]", "X [mm]", "Y [mm]", "Z [mm]", "Roll [°]", "Pitch [°]", "Yaw [°]"]
MARKED = LogFormat(dict(zip(NAMES, OWN, strict=True)))


def poses(count: int = 41) -> NDArray[np.float64]:
    """Times, s, and poses, m and rad, of a smooth motion, (n, 7)."""
    time = np.linspace(0.0, 2.0, count)
    angle = 2.0 * np.pi * np.outer(time, [0.3, 0.4, 0.5, 0.35, 0.45, 0.25]) + np.arange(6)
    return np.column_stack([time, [0.2, 0.0, 0.5, 0, 0, 0] + 0.03 * np.sin(angle)])


def lines(names: list[str] = NAMES, delimiter: str = ",", decimal: str = ".", count: int = 41) -> list[str]:
    """A header and rows of numbers."""
    rows = [delimiter.join(f"{x:.9f}".replace(".", decimal) for x in row) for row in poses(count)]
    return [delimiter.join(names), *rows]


def read(folder: Path, text: list[str] | bytes, form: LogFormat | None = None) -> Trajectory:
    path = folder / "log.csv"
    path.write_bytes(text if isinstance(text, bytes) else ("\n".join(text) + "\n").encode())
    return read_csv(path, form or LogFormat())


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
