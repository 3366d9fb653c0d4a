"""Tables of results as CSV text.

Used by the commands that write; knows nothing of files or of what the columns mean.
"""

import csv
import io
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from numpy.typing import NDArray


def csv_lines(columns: Mapping[str, NDArray[Any]]) -> Iterator[str]:
    """Lines of a CSV file, header first; columns (n,) by name, floats with all their digits."""
    yield ",".join(columns) + "\n"
    for row in zip(*(column.tolist() for column in columns.values()), strict=True):
        yield ",".join(map(repr, row)) + "\n"


def csv_text(rows: Iterable[Sequence[object]]) -> str:
    """Rows as CSV, floats with all their digits."""
    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows(rows)
    return stream.getvalue()
