"""Arrays whose numbers lie in columns: those of each component of a vector one after the other."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..backend.kernel import MOTION
from ..io.arguments import shown

Array = NDArray[Any]

NAMES = (*MOTION, "F")
_WIDTHS = (*(math.prod(shape) for shape in MOTION.values()), 6)
_OPTIONAL = ("F_ext", "M_ext")


def as_columns(values: Sequence[Any], dtype: Any) -> list[Array | None]:
    """Arrays of a motion as the C takes them: (9, n) and (3, n), None for no load; copied only where needed.

    values: in the order of ``MOTION``; R (3, 3, n) or (9, n), the others (3, n).
    Raises ValueError naming the array of another shape.
    """
    count: int | None = None
    found: list[Array | None] = []
    for name, width, value in zip(MOTION, _WIDTHS, values, strict=False):
        if value is None and name in _OPTIONAL:
            found.append(None)
            continue
        array = _numbers(name, value, dtype)
        shapes = ((width,), (3, 3)) if name == "R" else ((width,),)
        if array.ndim < 2 or array.shape[:-1] not in shapes or count not in (None, array.shape[-1]):
            wanted = " or ".join(f"({', '.join(map(str, shape))}, {_named(count)})" for shape in shapes)
            raise ValueError(f"{name}: expected an array {wanted}, got {array.shape}")
        count = array.shape[-1]
        found.append(array.reshape((width, count)))
    if _stride([array for array in found if array is not None]) is None:
        return [None if array is None else np.ascontiguousarray(array) for array in found]
    return found


def stride_of(arrays: Sequence[Array | None], F: Array, count: int, dtype: Any) -> int:
    """Numbers from one column to the next, the same in all arrays, at least ``count``.

    arrays: as ``as_columns`` returns them; F (6, count).
    Raises ValueError naming the array whose shape, type or layout is another.
    """
    if len(arrays) != len(MOTION):
        raise ValueError(f"arrays: expected {len(MOTION)}, {', '.join(MOTION)}, got {len(arrays)}")
    given: list[Array] = []
    for name, width, array in zip(NAMES, _WIDTHS, (*arrays, F), strict=True):
        if array is None and name in _OPTIONAL:
            continue
        if not (isinstance(array, np.ndarray) and array.dtype == np.dtype(dtype)):
            raise ValueError(f"{name}: expected an array of {np.dtype(dtype)}")
        if array.shape != (width, count):
            raise ValueError(f"{name}: expected an array ({width}, {count}), got {array.shape}")
        given.append(array)
        if _stride(given) is None:
            raise ValueError(
                f"{name}: expected rows of numbers one after the other, as far apart as those of R, "
                f"got strides of {array.strides} bytes"
            )
    if not F.flags.writeable:
        raise ValueError("F: expected a writeable array")
    return _stride(given) or count


def _stride(arrays: Sequence[Array]) -> int | None:
    """Numbers from one column to the next, None where not all arrays are columns so far apart."""
    size, count = arrays[0].itemsize, arrays[0].shape[-1]
    stride = arrays[0].strides[0]
    for array in arrays:
        plain = array.flags.aligned and (count < 2 or array.strides[1] == size)
        if array.size and not (plain and array.strides[0] == stride >= count * size):
            return None
    return None if stride % size else max(stride // size, count)


def _numbers(name: str, value: Any, dtype: Any) -> Array:
    try:
        with np.errstate(over="ignore"):
            return np.asarray(value, dtype=dtype)
    except (TypeError, ValueError):
        raise ValueError(f"{name}: expected an array of numbers, got {shown(value)}") from None


def _named(count: int | None) -> str:
    return "n" if count is None else str(count)
