"""Bounded reading of text files, and validation of TOML tables key by key, with one-line errors.

Every message begins with the given prefix: ``file: key: expected X, got Y``.
"""

import codecs
import contextlib
import difflib
import itertools
import math
import os
import re
import shutil
import stat
import tempfile
import tomllib
import unicodedata
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from .arguments import option, safe_text, shown
from .array_types import Array
from .key_lines import LONG_STRING, STRING, key_text, line_of

MOST_BYTES = 1 << 18
"""Largest size of a TOML file (bytes), thirty times the size of a robot file with all numbers of each leg."""
_CHUNK = 1 << 24
_LINE = 1 << 12
# Number of bytes at the beginning of a table that determine the encoding of its header, and the start of a
# row of numbers.
_HEAD = 1 << 16
_NUMBER = re.compile(rb"[\s\"]*[-+.\d]")
_MOST = float(np.finfo(np.float64).max)

_TWICE = re.compile(r"Cannot overwrite a value \(at line (\d+)")

# Time and memory of tomllib increase with the square of the number of parts of a dotted key: 300,000 parts
# exhaust both.
_PART = rf"(?:{STRING}|[\w-]++)"
_LONG_KEY = rf"(?P<long_key>(?<![\w\\-]){_PART}(?:[ \t]*+\.[ \t]*+{_PART}){{15}})"
# Comments and strings are skipped, because they contain no keys.
_TOKEN = re.compile(rf"#[^\n]*+|{LONG_STRING}|{_LONG_KEY}|{STRING}")


def file_name(path: object) -> str:
    """Return a path as text; raise ValueError for other types."""
    try:
        return os.fsdecode(path)  # type: ignore[arg-type]
    except TypeError:
        raise ValueError(f"path: expected the name of a file, got {type(path).__name__}") from None


@contextlib.contextmanager
def opened(source: str, what: str, most: int) -> Iterator[BinaryIO]:
    """Open a file of at most ``most`` bytes for repeated reading; ``what`` describes the file in messages.

    A pipe is copied to its end. A device is rejected, because some devices have no end. Raises ValueError,
    also for errors of reading in the block.
    """
    cannot = f"{source}: cannot read the {what}"
    with contextlib.ExitStack() as stack:
        try:
            stream = _again(source, most, stack)
        except (OSError, ValueError) as error:
            raise ValueError(f"{cannot}: {getattr(error, 'strerror', None) or error}") from None
        try:
            yield stream
        except OSError as error:
            raise ValueError(f"{cannot}: {error.strerror or error}") from None


def _again(source: str, most: int, stack: contextlib.ExitStack) -> BinaryIO:
    """Open a file as a seekable stream that the stack closes."""
    mode = os.stat(source).st_mode
    if stat.S_ISBLK(mode) or stat.S_ISCHR(mode):
        raise ValueError("it is a device")
    stream: BinaryIO = stack.enter_context(open(source, "rb"))  # noqa: SIM115 # the stack closes it
    if not stat.S_ISREG(mode):
        pipe, stream = stream, stack.enter_context(tempfile.TemporaryFile())  # noqa: SIM115
        while stream.tell() <= most and (chunk := pipe.read(_CHUNK)):
            stream.write(chunk)
    if stream.seek(0, os.SEEK_END) > most:
        raise ValueError(f"longer than {most:,} bytes")
    stream.seek(0)
    return stream


def read_text(source: str, what: str, most: int) -> str:
    """Read a UTF-8 file without its byte order mark, with the limits of ``opened``."""
    with opened(source, what, most) as stream, as_utf8(stream, source):
        return stream.read().decode("utf-8-sig")


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


_KINDS = {
    "robot file": ({"platform", "leg"}, {"platform", "base"}),
    "scene of simulate": ({"duration", "actuation"},),
    "scene of choose-fidelity": ({"motions", "tolerance"},),
    "file of via poses": ({"robot", "via"}, {"robot", "via_file"}),
}
"""Kinds of files with sets of keys: a file of a kind has one of its sets, and other files have none of
them.
"""


@contextlib.contextmanager
def toml_tables(source: str, what: str) -> Iterator[dict[str, Any]]:
    """Read the tables of a TOML file; ``what`` is one of ``_KINDS``.

    Raises ValueError also for a file of another kind. The line is added to errors of the block about a key of
    the file, ``source: key: expected X, got Y``.
    """
    try:
        text = read_text(source, what, MOST_BYTES)
    except ValueError:
        _reject_table(_beginning_of_long(source), source, what)
        raise
    top = _parsed(text, source, what)
    try:
        yield top
    except ValueError as error:
        message, file = str(error), f"{source}: "
        if not message.startswith(file):
            raise
        line = line_of(message.removeprefix(file), text)
        raise ValueError(f"{message} (at line {line})") from None


def _beginning_of_long(source: str) -> str:
    """Return the first line of a file that exceeds the size of TOML files, otherwise ""."""
    if not os.path.isfile(source) or os.path.getsize(source) <= MOST_BYTES:
        return ""
    with open(source, "rb") as stream:
        return stream.readline(_LINE).decode("utf-8-sig", "replace")


def _reject_table(first: str, source: str, what: str) -> None:
    """Raise ValueError if the first line of a file is a row of a CSV table."""
    if first.count(",") > 1 and "=" not in first and first[0] not in "#[":
        raise ValueError(f"{source}: expected a {what}, got a table of values, as of a CSV file") from None


def _parsed(text: str, source: str, what: str) -> dict[str, Any]:
    if not text.strip():
        raise ValueError(f"{source}: cannot read the {what}: the file is empty")
    if any(token["long_key"] for token in _TOKEN.finditer(text)):
        raise ValueError(f"{source}: not valid TOML: nested too deeply")
    try:
        top = tomllib.loads(text)
    except RecursionError:
        raise ValueError(f"{source}: not valid TOML: nested too deeply") from None
    except ValueError as error:
        first = text.lstrip().split("\n", 1)[0]
        _reject_table(first, source, what)
        if first.startswith(("{", "<")):
            raise ValueError(f"{source}: expected a {what}, got {shown(first)}") from None
        said = _key_twice(str(error), text) + " ".join(str(error).split())
        raise ValueError(f"{source}: not valid TOML: {said}") from None
    found = [kind for kind, ways in _KINDS.items() if any(keys <= top.keys() for keys in ways)]
    if found and what not in found:
        raise ValueError(f"{source}: expected a {what}, got a {found[0]}")
    return top


def _key_twice(error: str, text: str) -> str:
    """Return text about a repeated key if the parser error contains only its line, otherwise ""."""
    place = _TWICE.match(error)
    key, equals, _ = text.split("\n")[int(place[1]) - 1].partition("=") if place else ("", "", "")
    return f"{safe_text(key.strip())}: given twice: " if equals else ""


_RENAMED = {
    "accept": "suppress_warnings",
    "home": "home_position",
    "friction": "damping",
    "lengths": "length_mode",
    "leg_defaults": "legs",
    "gear": "gear_ratio",
    "stribeck": "stribeck_force",
    "smoothing": "regularization_speed",
    "back_efficiency": "backdrive_efficiency",
    "cross": "axis_offset",
    "along": "slide_offset_y",
    "across": "slide_offset_z",
    "wrist": "wrist_offset",
    "legs": "actuation",
    "law": "type",
    "model": "model_formulation",
    "start": "initial_state",
    "thresholds": "stop_conditions",
    "price": "smoothness_weight",
    "least": "minimize",
    "free": "tolerance",
    "condition": "max_condition",
    "clearance": "min_clearance",
}
"""Former keys of files with their present names."""


def checked_table(
    value: object, prefix: str, known: Sequence[str], required: Sequence[str] = ()
) -> dict[str, Any]:
    """Return a table after validation of its known and required keys."""
    if not isinstance(value, Mapping):
        raise ValueError(f"{prefix.rstrip('.: ')}: expected a table, got {shown(value)}")
    for key in value:
        if key not in known:
            near = _meant(str(key), known)
            hint = f"did you mean {near}?" if near else f"expected one of {', '.join(known)}"
            raise ValueError(f"{prefix}{key_text(key)}: unknown key, {hint}")
    require(value, required, prefix, "missing")
    return dict(value)


def _meant(key: str, known: Sequence[str]) -> str:
    """Return the keys that an unknown key may mean, or nothing.

    Candidates are its present name, its singular, keys that contain it as a word, or the key with the most
    similar spelling.
    """
    if _RENAMED.get(key) in known:
        return f'"{_RENAMED[key]}"'
    word = f"{key[:-3]}y" if key.endswith("ies") else key.removesuffix("s")
    near = [word] if word in known else [each for each in known if word in each.removesuffix("s").split("_")]
    near = near or difflib.get_close_matches(key, known, n=1, cutoff=0.65)
    return " or ".join(f'"{each}"' for each in near)


def require(table: Mapping[str, Any], keys: Sequence[str], prefix: str, reason: str) -> None:
    """Raise ValueError with ``reason`` if a key is missing."""
    for key in keys:
        if key not in table:
            raise ValueError(f"{prefix}{key}: {reason}")


# Single values


def file_beside(value: object, source: str, key: str) -> Path:
    """Return the path of a file that a key names, relative to the folder of the file with the key."""
    path = Path(source).parent / one_line(value, f"{source}: {key}")
    if not os.path.exists(path):
        raise ValueError(f"{source}: {key}: expected a file, there is no {path}")
    return path


_CONTROL = {"Cc", "Cs", "Zl", "Zp"}
"""Categories of characters that a line of text cannot contain: control characters, surrogates, and line
ends.
"""


def one_line(value: object, where: str) -> str:
    """Return a nonblank text of one line."""
    if isinstance(value, str) and not value.strip():
        raise ValueError(f"{where}: expected text that is not blank, got {shown(value)}")
    text = value if isinstance(value, str) else ""
    hidden = next((each for each in text if unicodedata.category(each) in _CONTROL), "")
    if not text or hidden:
        having = f", which has U+{ord(hidden):04X}" if hidden else ""
        raise ValueError(f"{where}: expected one line of text, got {shown(value)}{having}")
    return text


def title(value: object, where: str) -> str:
    """Return a text of one line with code points in place of nonprintable characters, as in ``safe_text``."""
    return safe_text(one_line(value, where))


def need_schema(value: object, known: Sequence[int], where: str) -> int:
    """Return the number of a supported schema."""
    if isinstance(value, bool) or not isinstance(value, int | float | np.integer) or value not in known:
        raise ValueError(f"{where}: expected {' or '.join(map(str, known))}, got {shown(value)}")
    return int(value)


def number(value: object, where: str, expected: str = "a finite number") -> float:
    """Return a finite number; reject Booleans."""
    if type(value) is float and math.isfinite(value):
        return value
    if isinstance(value, int | float | np.integer | np.floating) and not isinstance(value, bool):
        try:
            given = float(value)
        except OverflowError:
            given = math.inf
        if math.isfinite(given):
            return given
        if math.isinf(given):
            text = f"no limit is a key left out, and a double holds up to {_MOST:.2g}"
            raise ValueError(f"{where}: expected {expected}, got {shown(value)} ({text})")
    raise ValueError(f"{where}: expected {expected}, got {shown(value)}")


def numbers(value: object, shape: tuple[int, ...], where: str) -> Array:
    """Return nested lists of finite numbers as a new float64 array with exactly this shape."""
    return np.array(_flat(value, shape, where, shape)).reshape(shape)


def _flat(value: object, shape: tuple[int, ...], where: str, whole: tuple[int, ...]) -> list[float]:
    items = value.tolist() if isinstance(value, np.ndarray) else value
    # The whole rows are more informative in the message than an entry that is not a row.
    if (
        not isinstance(items, list | tuple)
        or len(items) != shape[0]
        or (len(shape) > 1 and not all(isinstance(row, list | tuple | np.ndarray) for row in items))
    ):
        raise ValueError(f"{where}: expected {_finite(whole)}, got {shown(items)}")
    if len(shape) > 1:
        return [entry for item in items for entry in _flat(item, shape[1:], where, whole)]
    # Nearly all entries pass this test, which takes a fifth of the time.
    if all(type(item) is float and math.isfinite(item) for item in items):
        return list(items)
    return [number(item, where, _finite(whole)) for item in items]


def _finite(shape: tuple[int, ...]) -> str:
    return " x ".join(str(n) for n in shape) + " finite numbers"


def vector(value: object, where: str) -> Array:
    """Return three finite numbers, shape (3,)."""
    return numbers(value, (3,), where)


def number_that(allowed: Callable[[float], bool], expected: str) -> Callable[[object, str], float]:
    """Return a validator of finite numbers that are allowed."""

    def checked(value: object, where: str) -> float:
        given = number(value, where)
        if not allowed(given):
            raise ValueError(f"{where}: expected a number {expected}, got {given:g}")
        return given

    return checked


positive = number_that(lambda x: x > 0.0, "> 0")
not_negative = number_that(lambda x: x >= 0.0, ">= 0")


def per_leg(value: object, where: str) -> Array:
    """Return one finite number for all legs or six numbers as shape (6,)."""
    if isinstance(value, list | tuple | np.ndarray):
        return numbers(value, (6,), where)
    return np.full(6, number(value, where, "one finite number or six"))


def choice(value: object, options: Sequence[str], where: str) -> str:
    """Return a value that is one of the options."""
    option(value, options, where)
    return str(value)
