"""A plain install of this tree, as users have it: nothing of it is read from the repository."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from stewart_sym.backend.native import create_once

REPOSITORY = Path(__file__).parents[2]
FOLDERS = ("stewart_sym", "derive", "generated")
WHEEL = """
import sys
from setuptools import build_meta
build_meta.build_wheel(sys.argv[1])
"""


def installed(factory: pytest.TempPathFactory) -> Path:
    """Return the folder of an installation and its ``source``, which all workers of a session share."""
    base = factory.getbasetemp()
    folder = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "plain"
    create_once(folder / "done", lambda: _install(folder))
    return folder / "installed"


def _install(folder: Path) -> None:
    """Install a copy of the sources below ``folder``, without what it depends on.

    A wheel of Python alone is unpacked, which is what pip does with it in four times the time.
    """
    source, target = folder / "source", folder / "installed"
    for name in FOLDERS:
        shutil.copytree(REPOSITORY / name, source / name, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("pyproject.toml", "README.md", "LICENSE", "LICENSE.0BSD"):
        shutil.copy(REPOSITORY / name, source)
    run = [sys.executable, "-c", WHEEL, str(folder)]
    subprocess.run(run, check=True, capture_output=True, cwd=source)
    (wheel,) = folder.glob("*-none-any.whl")
    shutil.unpack_archive(wheel, target, "zip")
    (folder / "done").touch()
