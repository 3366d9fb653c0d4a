"""Bounded reading of text files, and validation of TOML tables key by key, with one-line errors.

Every message begins with the given prefix: ``file: key: expected X, got Y``.
"""

import bisect
import contextlib
import difflib
import functools
import io
import math
import os
import re
import stat
import tomllib
import unicodedata
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from .arguments import number_in, safe_text, shown
from .array_types import Array

MOST_BYTES = 1 << 18
"""Largest size of a TOML file (bytes), thirty times the size of a robot file with all numbers of each leg."""


def file_name(path: object) -> str:
    """Return a path as text; raise ValueError for other types."""
    try:
        return os.fsdecode(path)  # type: ignore[arg-type]
    except TypeError:
        raise ValueError(f"path: expected the name of a file, got {type(path).__name__}") from None


@contextlib.contextmanager
def opened(source: str, what: str, most: int) -> Iterator[BinaryIO]:
    """Open a file of at most ``most`` bytes for repeated reading; ``what`` describes the file in messages.

    A pipe is read to its end. A device is rejected, because some devices have no end. Raises ValueError,
    also for errors of reading in the block.
    """
    try:
        mode = os.stat(source).st_mode
        if stat.S_ISBLK(mode) or stat.S_ISCHR(mode):
            raise OSError("it is a device")
        with open(source, "rb") as file:
            stream: BinaryIO = file if stat.S_ISREG(mode) else io.BytesIO(file.read(most + 1))
            if stream.seek(0, os.SEEK_END) > most:
                raise OSError(f"longer than {most:,} bytes")
            stream.seek(0)
            yield stream
    except OSError as error:
        raise ValueError(f"{source}: cannot read the {what}: {error.strerror or error}") from None


def read_text(source: str, what: str, most: int) -> str:
    """Read a UTF-8 file without its byte order mark, with the limits of ``opened``."""
    with opened(source, what, most) as stream:
        data = stream.read()
    try:
        return data.decode().removeprefix("\ufeff")
    except UnicodeDecodeError as error:
        problem = f"expected UTF-8 text, byte {error.start} is not: save it as UTF-8"
        raise ValueError(f"{source}: {problem}") from None


_KINDS = {
    "robot file": ({"platform", "leg"}, {"platform", "base"}),
    "scene of simulate": ({"duration", "actuation"},),
    "scene of choose-fidelity": ({"motions", "tolerance"},),
    "file of via poses": ({"robot", "via"}, {"robot", "via_file"}),
}
"""Sets of keys by kind of file: a file of a kind has one of its sets, and other files have none of them."""


@contextlib.contextmanager
def toml_tables(source: str, what: str) -> Iterator[dict[str, Any]]:
    """Read the tables of a TOML file; ``what`` is one of ``_KINDS``.

    Raises ValueError also for a file of another kind. The line is added to errors of the block about a key of
    the file, ``source: key: expected X, got Y``.
    """
    text = read_text(source, what, MOST_BYTES)
    top = _parsed(text, source, what)
    found = [kind for kind, ways in _KINDS.items() if any(keys <= top.keys() for keys in ways)]
    if found and what not in found:
        raise ValueError(f"{source}: expected a {what}, got a {found[0]}")
    try:
        yield top
    except ValueError as error:
        file, _, message = str(error).partition(f"{source}: ")
        if file or not message:
            raise
        raise ValueError(f"{error} (at line {line_of(message, text)})") from None


def _parsed(text: str, source: str, what: str) -> dict[str, Any]:
    if not text.strip():
        raise ValueError(f"{source}: cannot read the {what}: the file is empty")
    try:
        return tomllib.loads(text)
    except RecursionError:
        raise ValueError(f"{source}: not valid TOML: nested too deeply") from None
    except ValueError as error:
        first = text.lstrip().split("\n", 1)[0]
        if first[0] in "{<" or (first.count(",") > 1 and "=" not in first and first[0] not in "#["):
            raise ValueError(f"{source}: expected a {what}, got {shown(first)}") from None
        raise ValueError(f"{source}: not valid TOML: {' '.join(str(error).split())}") from None


# Line numbers


_STRING = r"""\"{3}(?:[^"\\]|\\(?s:.)|"(?!""))*+"{3,5}+|'{3}(?:[^']|'(?!''))*+'{3,5}+"""
_STRING += r"""|"(?:[^"\\\n]|\\.)*+"|'[^'\n]*+'"""
_TOKEN = re.compile(rf"#[^\n]*+|{_STRING}|[\[\]{{}}\n]")


def key_names(value: Any, name: str = "", mark: str = "") -> Iterator[str]:
    """Yield the names of keys, tables, and array entries in messages: ``leg 3``, ``leg 3: lower.mass``."""
    found: list[tuple[str, str, Any]] = []
    if isinstance(value, dict):
        found = [(f"{name}{mark}{key_text(key)}", ".", each) for key, each in value.items()]
    elif isinstance(value, list):
        found = [(f"{name} {number}", ": ", each) for number, each in enumerate(value, 1)]
    for inner, after, each in found:
        yield inner
        yield from key_names(each, inner, after)


def key_text(key: object) -> str:
    """Format a key for messages."""
    plain = isinstance(key, str) and key.isprintable() and len(key) <= 60
    return str(key) if plain else shown(key)


def line_of(message: str, text: str) -> int:
    """Return the line, from 1, of the last key of valid TOML whose name begins the message, or 1.

    ``tomllib`` provides no lines, so beginnings of the text are parsed to find the key.
    """
    names = [name for name in key_names(tomllib.loads(text)) if message.startswith(name)]
    name = max((name for name in names if message[len(name) :][:1] in (":", ".", " ")), key=len, default="")
    # The text can be cut after each line that ends outside of strings if its brackets are closed.
    cuts, closing = [(0, "")], ""
    for token in _TOKEN.finditer(text):
        if token[0] in ("[", "{"):
            closing = ("]" if token[0] == "[" else "}") + closing
        elif token[0] in ("]", "}"):
            closing = closing[1:]
        elif token[0] == "\n":
            cuts.append((token.end(), closing))

    def has_key(cut: tuple[int, str]) -> bool:
        return not name or name in key_names(tomllib.loads(text[: cut[0]] + cut[1]))

    first = bisect.bisect_left(cuts, True, key=has_key)
    return text.count("\n", 0, cuts[max(first, 1) - 1][0]) + 1


# Tables


_RENAMED = {
    "accept": "suppress_warnings",
    "friction": "damping",
    "leg_defaults": "legs",
    "stribeck": "stribeck_force",
    "smoothing": "regularization_speed",
    "cross": "axis_offset",
    "along": "slide_offset_y",
    "across": "slide_offset_z",
    "legs": "actuation",
    "law": "type",
    "start": "initial_state",
    "thresholds": "stop_conditions",
    "price": "smoothness_weight",
    "least": "minimize",
    "free": "tolerance",
}
"""Former keys of files with their present names, except names that ``_similar`` finds."""


def checked_table(
    value: object, prefix: str, known: Sequence[str], required: Sequence[str] = ()
) -> dict[str, Any]:
    """Return a table after validation of its known and required keys."""
    if not isinstance(value, Mapping):
        raise ValueError(f"{prefix.rstrip('.: ')}: expected a table, got {shown(value)}")
    for key in value:
        if key not in known:
            near = [_RENAMED[key]] if _RENAMED.get(key) in known else _similar(str(key), known)
            hint = " or ".join(f'"{each}"' for each in near)
            hint = f"did you mean {hint}?" if near else f"expected one of {', '.join(known)}"
            raise ValueError(f"{prefix}{key_text(key)}: unknown key, {hint}")
    require(value, required, prefix, "missing")
    return dict(value)


def _similar(key: str, known: Sequence[str]) -> list[str]:
    """Return known keys that contain an unknown one as a word, or the key with the most similar spelling."""
    word = f"{key[:-3]}y" if key.endswith("ies") else key.removesuffix("s")
    words = [each for each in known if word in each.removesuffix("s").split("_")]
    return [word] if word in known else words or difflib.get_close_matches(key, known, n=1, cutoff=0.65)


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


def one_line(value: object, where: str) -> str:
    """Return a nonblank text of one line, without control characters."""
    text = value if isinstance(value, str) else ""
    if not text.strip() or any(unicodedata.category(each) in ("Cc", "Cs", "Zl", "Zp") for each in text):
        raise ValueError(f"{where}: expected one line of text, got {shown(value)}")
    return text


def title(value: object, where: str) -> str:
    """Return a text of one line with code points in place of nonprintable characters, as in ``safe_text``."""
    return safe_text(one_line(value, where))


def need_schema(value: object, known: Sequence[int], where: str) -> int:
    """Return the number of a supported schema."""
    if isinstance(value, bool) or not isinstance(value, int | float | np.integer) or value not in known:
        raise ValueError(f"{where}: expected {' or '.join(map(str, known))}, got {shown(value)}")
    return int(value)


def number(value: Any, where: str, rule: str = "", allowed: Callable[[float], bool] = math.isfinite) -> float:
    """Return a finite number; reject Booleans, and numbers that are not allowed by the ``rule``."""
    is_open = "limit" in where and isinstance(value, float) and math.isinf(value)
    remedy = " (no limit: omit the key)" if is_open else ""
    found = number_in(value, where, f"a finite number{remedy}", -math.inf)
    if not allowed(found):
        raise ValueError(f"{where}: expected a number {rule}, got {found:g}")
    return found


positive = functools.partial(number, rule="> 0", allowed=lambda x: x > 0.0)
not_negative = functools.partial(number, rule=">= 0", allowed=lambda x: x >= 0.0)


def numbers(value: object, shape: tuple[int, ...], where: str) -> Array:
    """Return nested lists of finite numbers as a new float64 array with exactly this shape."""
    expected = " x ".join(map(str, shape)) + " finite numbers"
    found = np.array(value, dtype=object)
    if found.shape != shape:
        raise ValueError(f"{where}: expected {expected}, got {shown(value)}")
    return np.array([number_in(each, where, expected, -math.inf) for each in found.flat]).reshape(shape)


def vector(value: object, where: str) -> Array:
    """Return three finite numbers, shape (3,)."""
    return numbers(value, (3,), where)


def per_leg(value: object, where: str) -> Array:
    """Return one finite number for all legs or six numbers as shape (6,)."""
    if isinstance(value, list | tuple | np.ndarray):
        return numbers(value, (6,), where)
    return np.full(6, number_in(value, where, "one finite number or six", -math.inf))
