"""Working memory of BLAS, taken while there is room: where there is none, OpenBLAS tries again for ever."""

import functools
import sys
from importlib import import_module

import numpy as np

# Largest work area of an OpenBLAS as it is built by default; those of NumPy's and SciPy's wheels are smaller.
_WORK_AREA = 1 << 27
# NumPy and SciPy each bring a library, whose LAPACK takes the area at its first call and keeps it.
_FIRST_CALLS = {"numpy.linalg": "inv", "scipy.linalg": "lu_factor"}


def take_work_area() -> None:
    """Let the libraries of those of NumPy and SciPy that are imported take their work area.

    Raises MemoryError where there is no room for it.
    """
    for module, function in _FIRST_CALLS.items():
        if module in sys.modules:
            _take(module, function)


@functools.cache
def _take(module: str, function: str) -> None:
    np.empty(_WORK_AREA, np.uint8)
    getattr(import_module(module), function)(np.eye(2))
