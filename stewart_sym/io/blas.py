"""Early allocation of the work area of BLAS, because OpenBLAS retries endlessly if there is no memory for
it.
"""

import functools
import sys
from importlib import import_module

import numpy as np

# Largest work area of a default build of OpenBLAS (bytes); NumPy's and SciPy's wheels have smaller ones.
_WORK_AREA = 1 << 27
# NumPy and SciPy each include a library, whose LAPACK allocates the work area at its first call.
_FIRST_CALLS = {"numpy.linalg": "inv", "scipy.linalg": "lu_factor"}


def take_work_area() -> None:
    """Allocate the work areas of NumPy and SciPy if they are imported.

    Raises MemoryError if there is not enough memory.
    """
    for module, function in _FIRST_CALLS.items():
        if module in sys.modules:
            _take(module, function)


@functools.cache
def _take(module: str, function: str) -> None:
    np.empty(_WORK_AREA, np.uint8)
    getattr(import_module(module), function)(np.eye(2))
