"""``stewart-sym cmake-dir``: print the folder of the CMake package with stewart_generate()."""

import argparse
from importlib.resources import files
from pathlib import Path

HELP = "print the folder of the CMake package with stewart_generate()"
EXAMPLE = "cmake -S . -B build -Dstewart-sym_DIR=$(stewart-sym cmake-dir)"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add no arguments."""


def run(arguments: argparse.Namespace) -> int:
    print(Path(str(files("stewart_sym"))) / "cmake")
    return 0
