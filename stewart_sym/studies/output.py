"""Tables of results as CSV text.

Used by the commands that write; does not depend on files or on what the columns mean.
"""

import csv
import ctypes
import functools
import io
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from importlib.resources import files
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import native

_ROWS = 4096
# Shorter tables are not worth a compiler's time.
_LONG = 8192
# Characters of the longest number and the comma.
_WIDTH = 25
_FIRST_POWER, _LAST_POWER = -292, 324

Rows = Callable[[Sequence[NDArray[Any]]], str]


def csv_lines(columns: Mapping[str, NDArray[Any]], header: bool = True) -> Iterator[str]:
    """Text of a CSV file in parts of whole lines, header first; columns (n,) by name.

    Floats have all their digits, as Python's ``repr`` writes them; long tables are written by C where there
    is a compiler.
    """
    if header:
        yield ",".join(columns) + "\n"
    count = max(map(len, columns.values()), default=0)
    plain = all(column.dtype.kind in "fi" and column.itemsize <= 8 for column in columns.values())
    written = _compiled() if plain and count >= _LONG else None
    # A part of the rows at a time: as text or as Python's numbers they take several times the room.
    for start in range(0, count, _ROWS):
        part = [column[start : start + _ROWS] for column in columns.values()]
        yield _interpreted(part) if written is None else written(part)


def _interpreted(columns: Sequence[NDArray[Any]]) -> str:
    rows = zip(*(column.tolist() for column in columns), strict=True)
    return "".join(",".join(map(repr, row)) + "\n" for row in rows)


@functools.cache
def _compiled() -> Rows | None:
    """The function of ``output.c`` on a part of the rows; None without a compiler."""
    source = (files(__package__) / "output.c").read_text(encoding="utf-8")
    try:
        csv_rows = native.load("csv_rows", {"output.c": source}).csv_rows
    except native.CompilerError:
        return None
    csv_rows.restype = ctypes.c_size_t
    powers = np.array([_power(k) for k in range(_FIRST_POWER, _LAST_POWER + 1)], dtype=np.uint64)

    def rows(columns: Sequence[NDArray[Any]]) -> str:
        whole = np.array([column.dtype.kind == "i" for column in columns], dtype=np.uint8)
        held = [
            np.ascontiguousarray(column, dtype=np.int64 if is_whole else np.float64)
            for column, is_whole in zip(columns, whole, strict=True)
        ]
        count = {len(column) for column in held}
        if len(count) != 1:
            raise ValueError(f"columns: expected one length, got {sorted(count)}")
        out = np.empty(len(held) * len(held[0]) * _WIDTH, dtype=np.uint8)
        length = csv_rows(
            ctypes.c_size_t(len(held[0])),
            ctypes.c_size_t(len(held)),
            (ctypes.c_void_p * len(held))(*(column.ctypes.data for column in held)),
            ctypes.c_void_p(whole.ctypes.data),
            ctypes.c_void_p(powers.ctypes.data),
            ctypes.c_void_p(out.ctypes.data),
        )
        return out[:length].tobytes().decode("ascii")

    return rows


def _power(k: int) -> tuple[int, int]:
    """10^k as an integer of 128 bits, of which the first is set, rounded up: high and low half."""
    numerator, denominator = (10**k, 1) if k >= 0 else (1, 10**-k)
    shift = 127 - (k * 1741647 >> 19)
    if shift >= 0:
        numerator <<= shift
    else:
        denominator <<= -shift
    return divmod(-(-numerator // denominator), 1 << 64)


def csv_text(rows: Iterable[Sequence[object]]) -> str:
    """Rows as CSV, floats with all their digits."""
    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows(rows)
    return stream.getvalue()
