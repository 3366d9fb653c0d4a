"""Print the folder of the CMake package with stewart_generate().

Example: cmake -S . -B build -Dstewart-sym_DIR=$(stewart-sym cmake-dir)
"""

import argparse
from importlib.resources import files
from pathlib import Path


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add no arguments."""


def run(arguments: argparse.Namespace) -> int:
    print(Path(str(files("stewart_sym"))) / "cmake")
    return 0
