"""The regressor's blocks in the working precision."""

import functools

import numpy as np
from mpmath import mp
from numpy.typing import NDArray

from stewart_sym.derive.mechanics.regressor import regressor

Column = mp.matrix
blocks = functools.cache(regressor)


def columns(raw: list[dict[str, mp.mpf]]) -> tuple[list[dict[str, Column]], dict[str, Column]]:
    """Columns by parameter of each leg and of the platform, from the blocks."""

    def found(block, values: dict[str, mp.mpf]) -> dict[str, Column]:
        parts = block.run(values, mp.sqrt)
        names = [name.removeprefix("force_") for name in parts if name.startswith("force_")]
        return {name: mp.matrix([*parts[f"force_{name}"], *parts[f"moment_{name}"]]) for name in names}

    return [found(blocks().leg, values) for values in raw], found(blocks().platform, raw[0])


def whole(raw: list[dict[str, mp.mpf]]) -> NDArray[np.object_]:
    """Y, (6, 148)."""
    legs, platform = columns(raw)
    return np.array([list(column) for part in (*legs, platform) for column in part.values()], dtype=object).T
