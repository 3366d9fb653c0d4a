"""Checks of given rates: their integral must be the change of the positions."""

import math

import numpy as np

from ..io.array_types import Array
from .sample_times import elapsed

# Distance (decades) from a power of 1000 of the ratio of changes to rates if a unit is wrong.
_NEAR_UNIT = 0.2
# Largest difference of changes and integrals, relative to the path.
_CONTRADICTS = 0.05


def rate_error(time: Array, found: Array) -> tuple[str, str | None]:
    """Compare the integral of rates with the changes of positions.

    Parameters
    ----------
    time : ndarray, shape (n,)
        Increasing times (s).
    found : ndarray, shape (3, n, c)
        Positions, rates, and second rates.

    Returns
    -------
    text : str
        Contradiction, or an empty text.
    time_unit : str or None
        Unit of time in which there is no contradiction.
    """
    if len(time) < 2 or not found[1].any():
        return "", None
    steps = np.diff(elapsed(time))[:, None]
    change = np.diff(found[0], axis=0)
    # The trapezoidal rule with the derivatives at both ends has an error of fifth order.
    by_rates = 0.5 * steps * (found[1, 1:] + found[1, :-1]) - steps**2 / 12.0 * np.diff(found[2], axis=0)
    path, expected = float(np.abs(change).sum()), float(np.abs(by_rates).sum())
    decades = math.log10(path / expected) if path and expected else 0.0
    nearest = 3 * round(decades / 3)
    if nearest and abs(decades - nearest) < _NEAR_UNIT:
        unit = {-3: "ms", -6: "us"}.get(nearest)
        return f"positions change by {path / expected:.2g} times the integral of the rates", unit
    off = float(np.abs(change - by_rates).sum())
    if off > _CONTRADICTS * path + 1e-9 * float(np.abs(found[0]).max()):
        share = off / path if path else math.inf
        return f"the integral of the rates differs from the positions by {share:.0%} of the path", None
    return "", None
