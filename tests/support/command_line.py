"""Errors of one line, running the command line in tests, and what it leaves in a folder."""

import csv
from collections.abc import Callable
from pathlib import Path

import pytest

from stewart_sym.cli.main import main


def error_of(call: Callable[[], object]) -> str:
    """The one line of the ValueError that a call must raise."""
    with pytest.raises(ValueError, match=r".") as caught:
        call()
    message = str(caught.value)
    assert "\n" not in message
    return message


def fails_in_one_line(capsys: pytest.CaptureFixture[str], *arguments: object) -> str:
    """Run a command that must fail; return the only line it prints."""
    try:
        code: object = main([*map(str, arguments)])
    except SystemExit as stop:
        code = stop.code
    captured = capsys.readouterr()
    lines = captured.err.splitlines()
    assert code == 2
    assert captured.out == ""
    assert len(lines) == 1, captured.err
    assert lines[0].startswith("stewart-sym: error: ")
    return lines[0]


def read(path: Path) -> list[dict[str, str]]:
    with open(path, newline="") as stream:
        return list(csv.DictReader(stream))


def folder_state(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()} | {
        str(p.relative_to(folder)): b"folder" for p in folder.rglob("*") if p.is_dir()
    }
