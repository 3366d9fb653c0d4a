"""Errors of one line, running the command line in tests, and what it leaves in a folder."""

import csv
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from stewart_sym.cli.main import main


class Told(NamedTuple):
    """What a subcommand printed."""

    out: str
    err: str


Run = Callable[..., Told]
Fails = Callable[..., str]
"""Fixtures of ``conftest.py``: ``told`` and ``fails_in_one_line`` with what pytest captures."""


def told(capsys: pytest.CaptureFixture[str], *arguments: object, code: int = 0) -> Told:
    """Run a command that must end with the code; return what it prints."""
    capsys.readouterr()
    try:
        found: object = main([*map(str, arguments)])
    except SystemExit as stop:
        found = stop.code
    printed = Told(*capsys.readouterr())
    assert found == code, printed.err
    return printed


def error_of(call: Callable[[], object]) -> str:
    """The one line of the ValueError that a call must raise."""
    with pytest.raises(ValueError, match=r".") as caught:
        call()
    message = str(caught.value)
    assert "\n" not in message
    return message


def rejects(words: str, call: Callable[..., object], *arguments: Any, **options: Any) -> None:
    """A call must raise a ValueError of one line, in which the words, a regular expression, are found."""
    with pytest.raises(ValueError, match=words) as caught:
        call(*arguments, **options)
    assert "\n" not in str(caught.value)


def fails_in_one_line(capsys: pytest.CaptureFixture[str], *arguments: object) -> str:
    """Run a command that must fail; return the only line it prints."""
    out, err = told(capsys, *arguments, code=2)
    lines = err.splitlines()
    assert out == ""
    assert len(lines) == 1, err
    assert lines[0].startswith("stewart-sym: error: ")
    return lines[0]


def read(path: Path) -> list[dict[str, str]]:
    with open(path, newline="") as stream:
        return list(csv.DictReader(stream))


def folder_state(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()} | {
        str(p.relative_to(folder)): b"folder" for p in folder.rglob("*") if p.is_dir()
    }
