"""The generated C in a folder of its own."""

from importlib.resources import files
from pathlib import Path


def c_folder() -> Path:
    return Path(str(files("stewart_sym.generated") / "c"))
