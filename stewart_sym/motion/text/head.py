"""Lines above a log's numbers: blank ones, comments, a line that states the delimiter, the header."""

import codecs
import csv
import itertools
from collections.abc import Collection, Iterable, Iterator
from typing import BinaryIO, NamedTuple

from ...io.arguments import shown

MARKS = (",", ";", "\t")
"""Delimiters."""


class Head(NamedTuple):
    """Lines above the numbers: names as written, the first row below them, and where that is.

    above: lines above the row. begin, end: bytes above it and its last.
    """

    names: list[str]
    delimiter: str
    first: list[str]
    above: int
    begin: int
    end: int


class _Lines:
    """Lines of a stream as text: how many were taken, how many bytes, and how many of these by the last."""

    def __init__(self, stream: BinaryIO, size: int = 0, count: int = 0) -> None:
        stream.seek(size)
        self.count, self.size, self.last = count, size, 0
        # A file whose lines all end in a carriage return is one line to the stream.
        self._lines = (part for line in stream for part in line.splitlines(keepends=True))

    def __iter__(self) -> Iterator[str]:
        for line in self._lines:
            self.count, self.size, self.last = self.count + 1, self.size + len(line), len(line)
            yield (line.removeprefix(codecs.BOM_UTF8) if self.count == 1 else line).decode()


def read_head(stream: BinaryIO, source: str, given: Collection[str], delimiter: str | None) -> Head:
    """The header: below blank lines, comments and one of ``sep=``, or the last comment above bare numbers.

    given: names in it that are known, where they are no comment. delimiter: None for that which is found.
    """
    lines = _Lines(stream)
    comment, stated = "", delimiter
    try:
        for line in lines:
            text = line.strip().strip('"')
            if text.lower().startswith("sep="):
                stated = stated or _separator(line, f"{source}: line {lines.count}")
            elif text.startswith(("#", "%")) and not text.startswith((*given,)):
                comment = text.lstrip("#% ")
            elif text.strip(' \t,;"'):
                break
        else:
            raise ValueError(f"{source}: the file is empty, expected a header line that names the columns")
        if comment:
            delimiter = stated or _delimiter(comment)
            names, numbers = (_cells([each], delimiter) for each in (comment, line))
            if len(names) == len(numbers) and all(map(is_value, numbers)):
                above, begin = lines.count - 1, lines.size - lines.last
                return Head(names, delimiter, numbers, above, begin, lines.size)
        delimiter = stated or _delimiter(line)
        names = _cells(itertools.chain([line], lines), delimiter)
        if names[0].startswith(("{", "[", "<")):
            raise ValueError(f"{source}: expected a CSV file with a header line, got {shown(names[0])}")
        return _first_row(lines, names, delimiter)
    except csv.Error as error:
        raise ValueError(f"{source}: line {lines.count}: not valid CSV: {error}") from None


def without_row(stream: BinaryIO, head: Head) -> Head:
    """The head with its first row, which is one of units, among the lines above the numbers."""
    return _first_row(_Lines(stream, head.end, head.above + 1), head.names, head.delimiter)


def _first_row(lines: _Lines, names: list[str], delimiter: str) -> Head:
    above, begin = lines.count, lines.size
    for line in lines:
        if line.strip():
            return Head(names, delimiter, _cells([line], delimiter), lines.count - 1, begin, lines.size)
        begin = lines.size
    return Head(names, delimiter, [], above, begin, lines.size)


def _separator(line: str, where: str) -> str:
    """The delimiter that a line ``sep=;`` states."""
    mark = line.strip('"\r\n')[4:]
    if mark not in MARKS:
        raise ValueError(f"{where}: sep=: expected a comma, a semicolon or a tab, got {shown(mark)}")
    return mark


def _delimiter(header: str) -> str:
    """That which cuts the header into most names."""
    return max(MARKS, key=header.count)


def _cells(lines: Iterable[str], delimiter: str) -> list[str]:
    return [cell.strip() for cell in next(csv.reader(lines, delimiter=delimiter, skipinitialspace=True))]


def is_value(cell: str) -> bool:
    """Whether a cell holds a number, with either decimal mark."""
    try:
        float(cell.replace(",", "."))
    except ValueError:
        return False
    return True
