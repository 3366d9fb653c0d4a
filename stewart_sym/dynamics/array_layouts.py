"""Array layouts for the C code: consecutive poses, or columns with consecutive values of each component."""

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..backend.kernel import MOTION
from ..io.arguments import shown

Array = NDArray[Any]

NAMES = (*MOTION, "F")
WIDTHS = (*(math.prod(shape) for shape in MOTION.values()), 6)
"""Number of components of each array in ``NAMES``."""
_OPTIONAL = ("F_ext", "M_ext")
_EXACTLY: Any = 100_000
"""Effort limit of ``np.may_share_memory``, after which two interleaved arrays count as overlapping."""


def as_columns(values: Sequence[Any], dtype: Any) -> list[Array | None]:
    """Convert the arrays of a motion for C: (9, n) and (3, n), or None without a load; copy only if required.

    ``values`` are in the order of ``MOTION``: R has the shape (3, 3, n) or (9, n), the others have (3, n).
    Raises ValueError that names the array with another shape.
    """
    count: int | None = None
    found: list[Array | None] = []
    for name, width, value in zip(MOTION, WIDTHS, values, strict=False):
        if value is None and name in _OPTIONAL:
            found.append(None)
            continue
        array = _numbers(name, value, dtype)
        shapes = ((width,), (3, 3)) if name == "R" else ((width,),)
        if array.ndim < 2 or array.shape[:-1] not in shapes or count not in (None, array.shape[-1]):
            poses = "n" if count is None else count
            wanted = " or ".join(f"({', '.join(map(str, shape))}, {poses})" for shape in shapes)
            raise ValueError(f"{name}: expected an array {wanted}, got {array.shape}")
        count = array.shape[-1]
        found.append(array.reshape((width, count)))
    given = [array for array in found if array is not None]
    if _stride(given) is None or not all(array.flags.aligned for array in given):
        return [None if array is None else np.ascontiguousarray(array) for array in found]
    return found


def need_rows(arrays: Sequence[Array | None], F: Array, status: Any, dtype: Any) -> None:
    """Raise ValueError that names an array that is not C-contiguous with all numbers of a pose together."""
    need_status(status)
    for name, width, array in _typed(arrays, F, dtype):
        if not array.flags.c_contiguous:
            raise ValueError(f"{name}: expected a C-contiguous array, got strides of {array.strides} bytes")
        if array.size != status.size * width or (status.size and array.shape[-1] not in (3, width)):
            wanted = f"expected {width} numbers for each of {status.size} poses"
            raise ValueError(f"{name}: {wanted}, got {array.size}")
    _need_writeable(F)


def stride_of(arrays: Sequence[Array | None], F: Array, count: int, dtype: Any) -> int:
    """Return the distance between columns in numbers, equal for all arrays and at least ``count``.

    ``arrays`` are results of ``as_columns``, and F has the shape (6, count). Raises ValueError that names the
    array with another shape, type, or layout.
    """
    given: list[Array] = []
    for name, width, array in _typed(arrays, F, dtype):
        if array.shape != (width, count):
            raise ValueError(f"{name}: expected an array ({width}, {count}), got {array.shape}")
        given.append(array)
        if _stride(given) is None:
            apart = "at least their length apart" if name == "R" else "as far apart as those of R"
            raise ValueError(
                f"{name}: expected rows of numbers one after the other, {apart}, "
                f"got strides of {array.strides} bytes"
            )
    _need_writeable(F)
    return _stride(given) or count


def _typed(arrays: Sequence[Array | None], F: Array, dtype: Any) -> Iterator[tuple[str, int, Array]]:
    """Yield name, number of components, and array of each given array; ValueError for another type."""
    if len(arrays) != len(MOTION):
        raise ValueError(f"arrays: expected {len(MOTION)}, {', '.join(MOTION)}, got {len(arrays)}")
    for name, width, array in zip(NAMES, WIDTHS, (*arrays, F), strict=True):
        if array is not None or name not in _OPTIONAL:
            yield name, width, need_type(name, array, dtype)


def _need_writeable(F: Array) -> None:
    if not F.flags.writeable:
        raise ValueError("F: expected a writeable array")


def need_status(status: Any) -> None:
    """Raise ValueError if C cannot write statuses to the array."""
    need_type("status", status, np.int32)
    if not status.flags.carray:
        raise ValueError("status: expected a writeable C-contiguous array, got another")


def need_type(name: str, array: Any, dtype: Any) -> Array:
    """Return the array; raise ValueError if it does not have this type or C cannot read it."""
    if isinstance(array, np.ndarray) and array.dtype == dtype and array.flags.aligned:
        return array
    wanted = np.dtype(dtype)
    if not isinstance(array, np.ndarray):
        raise ValueError(f"{name}: expected an array of {wanted}, got {shown(array)}")
    if array.dtype != wanted:
        raise ValueError(f"{name}: expected an array of {wanted}, got one of {array.dtype}")
    raise ValueError(f"{name}: expected an array at a multiple of {wanted.alignment} bytes, got another")


def need_apart(arrays: Sequence[Array | None], F: Array, status: Array) -> None:
    """Raise ValueError if an output shares memory with another array.

    ``arrays`` are in the order of ``MOTION``.
    """
    inputs = [array for array in arrays if array is not None]
    for name, own, others in (("F", F, inputs), ("status", status, [*inputs, F])):
        for array in others:
            if np.may_share_memory(own, array, _EXACTLY):
                other = next(key for key, given in zip(NAMES, (*arrays, F), strict=True) if given is array)
                raise ValueError(f"{name}: expected separate memory, got memory of {other}")


def _stride(arrays: Sequence[Array]) -> int | None:
    """Return the distance between columns in numbers, or None if the arrays have no common distance."""
    size, count = arrays[0].itemsize, arrays[0].shape[-1]
    stride = arrays[0].strides[0]
    for array in arrays:
        plain = count < 2 or array.strides[1] == size
        if array.size and not (plain and array.strides[0] == stride >= count * size):
            return None
    return None if stride % size else max(stride // size, count)


def _numbers(name: str, value: Any, dtype: Any) -> Array:
    try:
        given = np.asarray(value)
        if given.dtype.kind != "c":
            with np.errstate(over="ignore"):
                return given.astype(dtype, copy=False)
    except (TypeError, ValueError):
        raise ValueError(f"{name}: expected an array of numbers, got {shown(value)}") from None
    raise ValueError(f"{name}: expected an array of real numbers, got one of {given.dtype}")
