"""Libraries compiled in a quarter of the time, for tests in which their speed does not matter."""

import os
import shutil
from pathlib import Path

import pytest

from stewart_sym.backend import native


def compile_quickly(patch: pytest.MonkeyPatch) -> None:
    """Libraries that are not loaded yet are compiled at -O0: the same bits."""
    load = native.load
    if load.__module__ == __name__:
        return
    patch.setattr(
        native,
        "load",
        lambda name, sources, flags=(): load(name, sources, (*flags, "-O0")),
    )


def quick_path(folder: Path) -> str:
    """A ``PATH`` on which C is compiled at -O0 by other processes; folder: of the compilers, made once."""
    if not folder.exists():
        folder.mkdir()
        for name in ("cc", "gcc"):
            (folder / name).write_text(f'#!/bin/sh\nexec {shutil.which(name)} "$@" -O0\n')
            (folder / name).chmod(0o755)
    return os.pathsep.join([str(folder), os.environ["PATH"]])
