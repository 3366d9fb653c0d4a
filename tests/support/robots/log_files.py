"""Logs as files: names of columns, and tables under them."""

from collections.abc import Sequence
from pathlib import Path

from numpy.typing import NDArray

POSE = [f"{name}_{axis}" for name in ("t", "theta") for axis in "xyz"]
RATES = [f"{name}_{axis}" for name in ("v", "theta_dot", "a", "theta_ddot") for axis in "xyz"]
LENGTHS = [f"L_{leg}" for leg in range(1, 7)]
NAMES = ["time", *POSE]
"""Columns of a log of poses."""


def write(path: Path, names: Sequence[str], table: NDArray, delimiter: str = ",", decimal: str = ".") -> Path:
    """Write numbers, (n, columns), with all their digits."""
    rows = [delimiter.join(f"{x:.17g}".replace(".", decimal) for x in row) for row in table]
    path.write_text("\n".join([delimiter.join(names), *rows]) + "\n", encoding="utf-8")
    return path
