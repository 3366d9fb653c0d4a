"""Reading of text files, and validation of TOML tables key by key, with one-line errors."""

import bisect
import contextlib
import difflib
import functools
import io
import math
import os
import tomllib
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from .arguments import number_in, shown
from .array_types import Array


@contextlib.contextmanager
def opened(source: str, what: str) -> Iterator[BinaryIO]:
    """Open a file or pipe for repeated reading; errors, also of the block, name its kind ``what``."""
    try:
        with open(source, "rb") as file:
            yield file if os.path.isfile(source) else io.BytesIO(file.read())
    except OSError as error:
        raise ValueError(f"{source}: cannot read the {what}: {error.strerror or error}") from None


def read_text(source: str, what: str) -> str:
    """Read a UTF-8 file without its byte order mark."""
    with opened(source, what) as stream:
        try:
            return stream.read().decode("utf-8-sig")
        except UnicodeDecodeError as error:
            text = f"expected UTF-8 text, byte {error.start} is not: save it as UTF-8"
            raise ValueError(f"{source}: {text}") from None


_KINDS = {
    "robot file": {"base", "platform"},
    "scene of simulate": {"actuation", "state"},
    "scene of choose-fidelity": {"motions"},
    "file of via poses": {"via", "via_file"},
}
"""Keys that only one kind of file has."""


@contextlib.contextmanager
def toml_tables(source: str, what: str) -> Iterator[dict[str, Any]]:
    """Read the tables of a TOML file; ``what`` is its kind in messages.

    The line is added to errors of the block about a key of the file, ``source: key: expected X, got Y``.
    """
    text = read_text(source, what)
    try:
        top = tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        raise ValueError(f"{source}: not valid TOML: {' '.join(str(error).split())}") from None
    kinds = [kind for kind, keys in _KINDS.items() if not keys.isdisjoint(top)]
    if what != "robot file" and kinds and what not in kinds:
        raise ValueError(f"{source}: expected a {what}, got a {kinds[0]}")
    if what == "robot file" and "robot" in top:
        named = shown(top["robot"])
        raise ValueError(f"{source}: expected a robot file, got a file that names one; use {named}")
    try:
        yield top
    except ValueError as error:
        file, _, message = str(error).partition(f"{source}: ")
        if file or not message:
            raise
        raise ValueError(f"{error} (at line {line_of(message, text)})") from None


def key_names(value: Any, name: str = "", mark: str = "") -> Iterator[str]:
    """Yield the names of keys, tables, and array entries in messages: ``leg 3``, ``leg 3: lower.mass``."""
    found: list[tuple[str, str, Any]] = []
    if isinstance(value, dict):
        found = [(name + mark + shown(key).strip("'"), ".", each) for key, each in value.items()]
    elif isinstance(value, list):
        found = [(f"{name} {number}", ": ", each) for number, each in enumerate(value, 1)]
    for inner, after, each in found:
        yield inner
        yield from key_names(each, inner, after)


def line_of(message: str, text: str) -> int:
    """Return the line, from 1, of the last key of valid TOML whose name begins the message, or 1.

    ``tomllib`` provides no lines, so the shortest beginning of the text with the key is searched.
    """
    lines = text.split("\n")
    names = [name for name in key_names(tomllib.loads(text)) if message.startswith(name)]
    name = max((name for name in names if message[len(name) :][:1] in (":", ".", " ")), key=len, default="")

    def has_key(count: int) -> bool:
        """Return True if the first lines, up to the end of a value or an array entry, contain the key."""
        while True:
            for end in ("\n", "\n]"):
                with contextlib.suppress(ValueError):
                    return not name or name in key_names(tomllib.loads("\n".join(lines[:count]) + end))
            count += 1

    return bisect.bisect_left(range(1, len(lines)), True, key=has_key) + 1


def checked_table(
    value: object, prefix: str, known: Sequence[str], required: Sequence[str] = ()
) -> dict[str, Any]:
    """Return a table after validation of its known and required keys."""
    if not isinstance(value, Mapping):
        raise ValueError(f"{prefix.rstrip('.: ')}: expected a table, got {shown(value)}")
    for key in value:
        if key not in known:
            near = _similar(str(key), known)
            hint = " or ".join(f'"{each}"' for each in near)
            hint = f"did you mean {hint}?" if near else f"expected one of {', '.join(known)}"
            raise ValueError(prefix + shown(key).strip("'") + f": unknown key, {hint}")
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


def file_beside(value: object, source: str, key: str) -> Path:
    """Return the path of a file that a key names, relative to the folder of the file with the key."""
    path = Path(source).parent / one_line(value, f"{source}: {key}")
    if not os.path.exists(path):
        raise ValueError(f"{source}: {key}: expected a file, there is no {path}")
    return path


def one_line(value: object, where: str) -> str:
    """Return a nonblank text of one line."""
    if not isinstance(value, str) or not value.strip() or len(value.splitlines()) > 1:
        raise ValueError(f"{where}: expected one line of text, got {shown(value)}")
    return value


def number(value: Any, where: str, rule: str = "", allowed: Callable[[float], bool] = math.isfinite) -> float:
    """Return a finite number; reject Booleans, and numbers that are not allowed by the ``rule``."""
    found = number_in(value, where, "a finite number", -math.inf)
    if not allowed(found):
        raise ValueError(f"{where}: expected a number {rule}, got {found:g}")
    return found


positive = functools.partial(number, rule="> 0", allowed=lambda x: x > 0.0)
not_negative = functools.partial(number, rule=">= 0", allowed=lambda x: x >= 0.0)


def numbers(value: object, where: str, shape: tuple[int, ...]) -> Array:
    """Return nested lists of finite numbers as a new float64 array with exactly this shape."""
    expected = " x ".join(map(str, shape)) + " finite numbers"
    found = np.array(value, dtype=object)
    if found.shape != shape:
        raise ValueError(f"{where}: expected {expected}, got {shown(value)}")
    return np.array([number_in(each, where, expected, -math.inf) for each in found.flat]).reshape(shape)


vector = functools.partial(numbers, shape=(3,))


def per_leg(value: Any, where: str, check: Callable[..., float] = number, unlimited: bool = False) -> Array:
    """Return six checked numbers from one number for all legs or six; ``unlimited`` accepts infinity."""
    rows = value.tolist() if isinstance(value, np.ndarray) else value
    each = isinstance(rows, list | tuple)
    legs = [(f"{where}: leg {i}", row) for i, row in enumerate(rows, 1)] if each else [(where, rows)] * 6
    if len(legs) != 6:
        raise ValueError(f"{where}: expected one number or six, got {shown(value)}")
    return np.array([row if unlimited and row == math.inf else check(row, place) for place, row in legs])
