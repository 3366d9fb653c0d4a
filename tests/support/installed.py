"""A plain install of this tree, as users have it: nothing of it is read from the repository."""

import shutil
import subprocess
import sys
from pathlib import Path

REPOSITORY = Path(__file__).parents[2]
FOLDERS = ("stewart_sym", "derive", "generated")


def install(folder: Path) -> Path:
    """Install a copy of the sources below ``folder``, without what it depends on; returns where it is."""
    source, target = folder / "source", folder / "installed"
    for name in FOLDERS:
        shutil.copytree(REPOSITORY / name, source / name, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(REPOSITORY / name, source)
    options = ["--quiet", "--no-deps", "--no-index", "--no-build-isolation", "--target", str(target)]
    subprocess.run([sys.executable, "-m", "pip", "install", *options, str(source)], check=True, cwd=folder)
    return target
