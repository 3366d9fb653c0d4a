"""An empty cache of libraries, a compiler that is watched, or none."""

import shlex
import sys
from pathlib import Path

import pytest
from logged_compiler import LoggedCompiler

from stewart_sym.backend import native


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "cache"
    monkeypatch.setenv("STEWART_SYM_CACHE", str(folder))
    return folder


@pytest.fixture
def compiler(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> LoggedCompiler:
    logged = LoggedCompiler(tmp_path)
    monkeypatch.setenv("CC", shlex.quote(str(logged.path)))
    return logged


@pytest.fixture
def no_compiler(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    empty = tmp_path / "empty"
    empty.mkdir()
    monkeypatch.setenv("PATH", str(empty))
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setitem(sys.modules, "ziglang", None)
    native._check_compiler.cache_clear()
