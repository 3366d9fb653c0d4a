"""Print the folder of the CMake package with stewart_generate().

Example: cmake -S . -B build -Dstewart-sym_DIR=$(stewart-sym cmake-dir)
"""

from importlib.resources import files
from pathlib import Path

from ..command import Arguments, Parser


def add_arguments(parser: Parser) -> None:
    """Add no arguments."""


def run(arguments: Arguments) -> None:
    print(Path(str(files("stewart_sym"))) / "cmake")
