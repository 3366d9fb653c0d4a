"""Times as text that tells one instant from the next, seconds since 1970 too."""

import math

import numpy as np

from .array_types import Array

# A double has 15 to 17 digits; with 16 a time of few decimals is printed with these alone.
_FEWEST, _MOST = 6, 16


def least_step(times: Array) -> float:
    """The shortest step of times, s, (n,); 0 of a single one."""
    return float(np.diff(times).min()) if len(times) > 1 else 0.0


def time_text(time: float, step: float = 0.0) -> str:
    """A time, s, with full seconds and the decimals of a step, s; with all that it has without a step."""
    digits = _MOST
    if step > 0.0 and time != 0.0:
        digits = math.floor(math.log10(abs(time))) - math.floor(math.log10(min(step, 1.0))) + 1
    return f"{time:.{min(max(digits, _FEWEST), _MOST)}g}"
