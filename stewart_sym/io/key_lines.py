"""Lines at which the keys of a TOML file stand, which ``tomllib`` does not keep: for messages about values.

Only of texts that ``tomllib`` has accepted: it reads beginnings of the text, to see which has the key.
"""

import bisect
import re
import tomllib
from collections.abc import Iterator
from typing import Any

from .arguments import shown

Path = tuple[str | int, ...]
"""Keys and, in arrays, places counted from 0."""

STRING = r"""(?:"(?:[^"\\\n]|\\.)*+"|'[^'\n]*+')"""
LONG_STRING = r"""\"{3}(?:[^"\\]|\\(?s:.)|"(?!""))*+"{3,5}+|'{3}(?:[^']|'(?!''))*+'{3,5}+"""
"""Texts of one line and of several, as regular expressions."""
_TOKEN = re.compile(rf"#[^\n]*+|{LONG_STRING}|{STRING}|[\[\]{{}}\n]")


def paths(value: Any, path: Path = ()) -> Iterator[Path]:
    """Path of each key, table and entry of an array in tables as ``tomllib`` reads them."""
    if isinstance(value, dict | list):
        for key, each in value.items() if isinstance(value, dict) else enumerate(value):
            yield (*path, key)
            yield from paths(each, (*path, key))


def key_text(key: object) -> str:
    """A key as messages show it."""
    plain = isinstance(key, str) and key.isprintable() and len(key) <= 60
    return str(key) if plain else shown(key)


def spelled(path: Path) -> str:
    """A path as messages name it: ``platform.mass``, and ``leg 3: lower.mass`` for the third of an array."""
    found = ""
    for part in path:
        if isinstance(part, int):
            found += f" {part + 1}: "
        else:
            found += ("" if not found or found.endswith(": ") else ".") + key_text(part)
    return found.removesuffix(": ")


def key_line(path: Path, text: str) -> int:
    """Line, counted from 1, at which a key, a table or an entry of an array begins."""
    # The text may be cut after each line that ends outside of strings, once its brackets are closed.
    cuts, closing = [(0, "")], ""
    for token in _TOKEN.finditer(text):
        if token[0] in ("[", "{"):
            closing = ("]" if token[0] == "[" else "}") + closing
        elif token[0] in ("]", "}"):
            closing = closing[1:]
        elif token[0] == "\n":
            cuts.append((token.end(), closing))
    first = bisect.bisect_left(cuts, True, key=lambda cut: _holds(text[: cut[0]] + cut[1], path))
    return text.count("\n", 0, cuts[first - 1][0]) + 1


def line_of(message: str, text: str) -> int:
    """Line of the last key on the path with whose name a message begins; the first where none has one."""
    found: Path = ()
    name = ""
    try:
        for path in paths(tomllib.loads(text)):
            each = spelled(path)
            if len(name) < len(each) and message.startswith((f"{each}:", f"{each}.", f"{each} ")):
                name, found = each, path
        return key_line(found, text) if found else 1
    except RecursionError:
        return 1


def _holds(text: str, path: Path) -> bool:
    """Whether a text has a key."""
    value: Any = tomllib.loads(text)
    try:
        for part in path:
            value = value[part]
    except (KeyError, IndexError):
        return False
    return True
