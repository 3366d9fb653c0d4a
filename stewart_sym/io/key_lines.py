"""Lines at which the keys of a TOML file stand, which ``tomllib`` does not keep: for messages about values.

Only of texts that ``tomllib`` has accepted, so that brackets match and every key has its value.
"""

import re
import tomllib
from collections.abc import Iterator
from typing import NamedTuple

from .arguments import shown

Path = tuple[str | int, ...]
"""Keys and, in arrays, places counted from 0."""

_TOKEN = re.compile(
    r"(?P<skipped>[ \t\r]+|\#[^\n]*)|(?P<newline>\n)"
    r"|(?P<text>\"{3}(?:[^\"\\]|\\(?s:.)|\"(?!\"\"))*+\"{3,5}|'{3}(?:[^']|'(?!''))*+'{3,5}"
    r"|\"(?:[^\"\\\n]|\\.)*\"|'[^'\n]*')"
    r"|(?P<mark>[\[\]{},=.])|(?P<bare>[^\s\[\]{},=.\"'#]+)"
)


class _Token(NamedTuple):
    kind: str
    text: str
    line: int


def key_lines(text: str) -> dict[Path, int]:
    """Line, counted from 1, of each key, table and entry of an array by its path."""
    try:
        return _Reader(text).lines
    except RecursionError:
        return {}


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


def line_of(message: str, text: str) -> int:
    """Line of the last key on the path with whose name a message begins; the first where none has one."""
    best, found = 0, 1
    for path, line in key_lines(text).items():
        name = spelled(path)
        if best < len(name) < len(message) and message.startswith(name) and message[len(name)] in ":. ":
            best, found = len(name), line
    return found


class _Reader:
    """Goes through a text once."""

    def __init__(self, text: str) -> None:
        self.lines: dict[Path, int] = {}
        self._counts: dict[Path, int] = {}
        self._tokens = _tokens(text)
        self._next()
        table: Path = ()
        while self._token.kind != "end":
            if self._token.kind == "newline":
                self._next()
            elif self._token.text == "[" and self._token.kind == "mark":
                table = self._header()
            else:
                self._pair(table)

    def _next(self) -> _Token:
        """Take a token."""
        taken = getattr(self, "_token", None)
        self._token = next(self._tokens)
        return taken or self._token

    def _is(self, mark: str) -> bool:
        return self._token.kind == "mark" and self._token.text == mark

    def _header(self) -> Path:
        """A line ``[table]`` or ``[[array]]``; returns the path of what it begins."""
        line = self._next().line
        array = self._is("[")
        if array:
            self._next()
        path: Path = ()
        parts = self._key()
        for i, part in enumerate(parts, 1):
            path = (*path, part)
            if array and i == len(parts):
                self._counts[path] = self._counts.get(path, 0) + 1
            self.lines.setdefault(path, line)
            if path in self._counts:
                path = (*path, self._counts[path] - 1)
        self.lines[path] = line
        while self._token.kind not in ("newline", "end"):
            self._next()
        return path

    def _key(self) -> list[str]:
        """Parts of a dotted key, which ends before ``=`` or ``]``."""
        parts = []
        while not (self._is("=") or self._is("]")):
            token = self._next()
            if token.kind == "text":
                parts.append(next(iter(tomllib.loads(f"{token.text} = 0"))))
            elif token.kind == "bare":
                parts.append(token.text)
        return parts

    def _pair(self, table: Path) -> None:
        """A key, ``=`` and a value."""
        line, path = self._token.line, table
        for part in self._key():
            path = (*path, part)
            self.lines.setdefault(path, line)
        self._next()
        self._value(path)

    def _value(self, path: Path) -> None:
        if self._is("["):
            self._next()
            self._entries(path)
        elif self._is("{"):
            self._next()
            while not self._is("}"):
                if self._is(",") or self._token.kind == "newline":
                    self._next()
                else:
                    self._pair(path)
            self._next()
        else:
            while self._token.kind not in ("newline", "end") and not any(map(self._is, ",]}")):
                self._next()

    def _entries(self, path: Path) -> None:
        """The rest of an array."""
        count = 0
        while not self._is("]"):
            if self._is(",") or self._token.kind == "newline":
                self._next()
            else:
                self.lines[*path, count] = self._token.line
                self._value((*path, count))
                count += 1
        self._next()


def _tokens(text: str) -> Iterator[_Token]:
    line = 1
    for match in _TOKEN.finditer(text):
        kind = str(match.lastgroup)
        if kind != "skipped":
            yield _Token(kind, match[0], line)
        line += match[0].count("\n")
    while True:
        yield _Token("end", "", line)
