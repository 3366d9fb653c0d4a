"""Logs as files: names of columns, and tables under them; a smooth motion to write."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

POSE = [f"{name}_{axis}" for name in ("t", "theta") for axis in "xyz"]
RATES = [f"{name}_{axis}" for name in ("v", "theta_dot", "a", "theta_ddot") for axis in "xyz"]
LENGTHS = [f"L_{leg}" for leg in range(1, 7)]
NAMES = ["time", *POSE]
"""Columns of a log of poses."""


def poses(count: int = 41) -> NDArray[np.float64]:
    """Times, s, and poses, m and rad, of a smooth motion of the paper's machine, (n, 7)."""
    time = np.linspace(0.0, 2.0, count)
    angle = 2.0 * np.pi * np.outer(time, [0.3, 0.4, 0.5, 0.35, 0.45, 0.25]) + np.arange(6)
    return np.column_stack([time, [0.2, 0.0, 0.5, 0, 0, 0] + 0.03 * np.sin(angle)])


def write(path: Path, names: Sequence[str], table: NDArray, delimiter: str = ",", decimal: str = ".") -> Path:
    """Write numbers, (n, columns), with all their digits."""
    rows = [delimiter.join(f"{x:.17g}".replace(".", decimal) for x in row) for row in table]
    path.write_text("\n".join([delimiter.join(names), *rows]) + "\n", encoding="utf-8")
    return path
