"""Tables of results as CSV text.

Used by the commands that write; knows nothing of files or of what the columns mean.
"""

from collections.abc import Iterator, Mapping
from typing import Any

from numpy.typing import NDArray


def csv_lines(columns: Mapping[str, NDArray[Any]]) -> Iterator[str]:
    """Lines of a CSV file, header first; columns (n,) by name, floats with all their digits."""
    yield ",".join(columns) + "\n"
    for row in zip(*(column.tolist() for column in columns.values()), strict=True):
        yield ",".join(map(repr, row)) + "\n"
