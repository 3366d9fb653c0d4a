"""Line numbers of the keys of a TOML file, for error messages; ``tomllib`` does not provide them.

The text must be valid TOML: beginnings of the text are parsed to find the line of a key.
"""

import bisect
import re
import tomllib
from collections.abc import Iterator
from typing import Any

from .arguments import shown

Path = tuple[str | int, ...]
"""Keys and, in arrays, indices from 0."""

_STRING = r"""\"{3}(?:[^"\\]|\\(?s:.)|"(?!""))*+"{3,5}+|'{3}(?:[^']|'(?!''))*+'{3,5}+"""
_STRING += r"""|"(?:[^"\\\n]|\\.)*+"|'[^'\n]*+'"""
_TOKEN = re.compile(rf"#[^\n]*+|{_STRING}|[\[\]{{}}\n]")


def paths(value: Any, path: Path = ()) -> Iterator[Path]:
    """Yield the path of each key, table, and array entry in the tables of ``tomllib``."""
    if isinstance(value, dict | list):
        for key, each in value.items() if isinstance(value, dict) else enumerate(value):
            yield (*path, key)
            yield from paths(each, (*path, key))


def key_text(key: object) -> str:
    """Format a key for messages."""
    plain = isinstance(key, str) and key.isprintable() and len(key) <= 60
    return str(key) if plain else shown(key)


def spelled(path: Path) -> str:
    """Format a path for messages: ``platform.mass``, or ``leg 3: lower.mass`` for a table of an array."""
    found = "".join(f" {part + 1}: " if isinstance(part, int) else f".{key_text(part)}" for part in path)
    return found.replace(": .", ": ").removeprefix(".").removesuffix(": ")


def key_line(path: Path, text: str) -> int:
    """Return the line, from 1, at which a key, a table, or an entry of an array begins."""
    # The text can be cut after each line that ends outside of strings if its brackets are closed.
    cuts, closing = [(0, "")], ""
    for token in _TOKEN.finditer(text):
        if token[0] in ("[", "{"):
            closing = ("]" if token[0] == "[" else "}") + closing
        elif token[0] in ("]", "}"):
            closing = closing[1:]
        elif token[0] == "\n":
            cuts.append((token.end(), closing))
    first = bisect.bisect_left(
        cuts, True, key=lambda cut: path in paths(tomllib.loads(text[: cut[0]] + cut[1]))
    )
    return text.count("\n", 0, cuts[first - 1][0]) + 1


def line_of(message: str, text: str) -> int:
    """Return the line of the last key whose path is the beginning of a message, or 1 without such a key."""
    names = {spelled(path): path for path in paths(tomllib.loads(text))}
    found = [name for name in names if message.startswith((f"{name}:", f"{name}.", f"{name} "))]
    return key_line(names[max(found, key=len)], text) if found else 1
