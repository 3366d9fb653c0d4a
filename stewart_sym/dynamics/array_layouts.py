"""Array layouts for the C code: consecutive poses, or columns with consecutive values of each component."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..backend.kernel import MOTION
from ..io.arguments import real_array, shown

Array = NDArray[Any]

_OPTIONAL = ("F_ext", "M_ext")


def in_columns(values: Sequence[Any], dtype: Any) -> tuple[list[Array | None], int]:
    """Convert the arrays of a motion to contiguous columns for C, and return the number of poses.

    ``values`` are in the order of ``MOTION``: R has the shape (3, 3, n) or (9, n), the others have (3, n).
    """
    found: list[Array | None] = []
    for name, value in zip(MOTION, values, strict=True):
        if value is None and name in _OPTIONAL:
            found.append(None)
            continue
        array = real_array(value, name)
        if array.shape[:2] == (3, 3) and array.ndim == 3:
            array = array.reshape(9, -1)
        with np.errstate(over="ignore"):
            found.append(np.ascontiguousarray(array, dtype))
    assert found[0] is not None
    return found, found[0].size // 9


def need_layout(
    arrays: Sequence[Array | None], F: Array, status: Any, dtype: Any, columns: bool = False
) -> int:
    """Return the distance between columns in numbers; raise ValueError for an array that C cannot use.

    ``arrays`` are in the order of ``MOTION``. Poses are rows with the shape of the status, or columns of
    equal distance. The outputs must not share memory with another array.
    """
    if len(arrays) != len(MOTION):
        raise ValueError(f"arrays: expected {len(MOTION)}, {', '.join(MOTION)}, got {len(arrays)}")
    given = {name: each for name, each in zip((*MOTION, "F"), (*arrays, F), strict=True) if each is not None}
    R = np.atleast_2d(given.get("R", np.nan))
    shape = R.shape[-1:] if columns else R.shape[:-2]
    stride = max(*shape, R.strides[0] // R.itemsize) if columns else 0
    for name, one in (*MOTION.items(), ("F", (6,))):
        if name in given or name not in _OPTIONAL:
            wanted = (math.prod(one), *shape) if columns else (*shape, *one)
            _need(name, given.get(name), wanted, dtype, stride)
    _need("status", status, shape, np.int32)
    for name, own in (("F", F), ("status", status)):
        if not own.flags.writeable:
            raise ValueError(f"{name}: expected a writeable array")
        for other, array in given.items():
            if array is not own and np.shares_memory(own, array):
                raise ValueError(f"{name}: expected separate memory, got memory of {other}")
    return stride


def _need(name: str, array: Any, shape: tuple[int, ...], dtype: Any, stride: int = 0) -> None:
    """Raise ValueError for another shape, type, or layout: columns with a distance in numbers, or C order."""
    size = np.dtype(dtype).itemsize
    layout = f"rows {stride * size} bytes apart" if stride else "C-contiguous"
    got = shown(array)
    if isinstance(array, np.ndarray):
        got = f"{array.shape} of {array.dtype} with strides {array.strides}, aligned: {array.flags.aligned}"
        along = array.strides[-1] == size or array.shape[-1] < 2
        fits = along and array.strides[0] == stride * size if stride else array.flags.c_contiguous
        if array.shape == shape and array.dtype == dtype and array.flags.aligned and (fits or not array.size):
            return
    raise ValueError(f"{name}: expected an aligned array {shape} of {np.dtype(dtype)}, {layout}, got {got}")
