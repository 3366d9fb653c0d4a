"""Encoding of tables of numbers: UTF-8, UTF-16, or a header in a Windows code page."""

import codecs
import contextlib
import itertools
import re
import shutil
import tempfile
from collections.abc import Iterator
from typing import BinaryIO

_CHUNK = 1 << 24
# Number of bytes at the beginning of a table that determine the encoding of its header, and the start of a
# row of numbers.
_HEAD = 1 << 16
_NUMBER = re.compile(rb"[\s\"]*[-+.\d]")


@contextlib.contextmanager
def as_utf8(stream: BinaryIO, source: str) -> Iterator[None]:
    """Convert a decoding error of the stream to ValueError with the position of the first invalid byte."""
    try:
        yield
    except UnicodeDecodeError:
        stream.seek(0)
        decoder, start = codecs.getincrementaldecoder("utf-8")(), 0
        while True:
            chunk = stream.read(_CHUNK)
            pending = len(decoder.getstate()[0])
            try:
                decoder.decode(chunk, final=not chunk)
            except UnicodeDecodeError as error:
                place = start - pending + error.start
                raise ValueError(
                    f"{source}: expected UTF-8 text, byte {place} is not: save it as UTF-8"
                ) from None
            start += len(chunk)


@contextlib.contextmanager
def table_as_utf8(stream: BinaryIO, source: str) -> Iterator[BinaryIO]:
    """Return the stream of a table, or a copy in UTF-8.

    A table in UTF-16, which has a byte order mark, and a table with a header in Windows code page 1252 are
    converted. The code page is assumed if bytes above the numbers are not UTF-8. Raises the errors of
    ``as_utf8``, also for errors of reading in the block.
    """
    with as_utf8(stream, source), contextlib.ExitStack() as stack:
        head = stream.read(_HEAD)
        stream.seek(0)
        lines = head.splitlines(keepends=True)
        above = b"".join(itertools.takewhile(lambda line: not _NUMBER.match(line), lines))
        utf_16 = head.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)) and head[2:4] != b"\0\0"
        told = _is_utf8(above) or len(above) == len(head) or head.startswith(codecs.BOM_UTF8) or b"\0" in head
        if told and not utf_16:
            yield stream
            return
        copy: BinaryIO = stack.enter_context(tempfile.TemporaryFile())
        if utf_16:
            decoder = codecs.getincrementaldecoder("utf-16")()
            while chunk := stream.read(_CHUNK):
                copy.write(decoder.decode(chunk).encode())
            decoder.decode(b"", final=True)
        else:
            copy.write(above.decode("cp1252").encode())
            stream.seek(len(above))
            shutil.copyfileobj(stream, copy)
        copy.seek(0)
        yield copy


def _is_utf8(data: bytes) -> bool:
    try:
        data.decode()
    except UnicodeDecodeError:
        return False
    return True
