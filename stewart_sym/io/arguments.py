"""Validation of arguments, with one-line errors that name the argument."""

import contextlib
import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray


def shown(value: object) -> str:
    """Return a value as text for a one-line message."""
    try:
        text = " ".join(repr(value).split())
    except (ValueError, RecursionError):
        # Python raises an error for integers of thousands of digits and for nesting a thousand levels deep.
        return f"{type(value).__name__} too long to show"
    return text if len(text) <= 60 else f"{text[:57]}..."


def safe_text(text: str) -> str:
    """Replace direction marks and other nonprintable characters of a one-line text by their code points."""
    return "".join(each if each.isprintable() else f"[U+{ord(each):04X}]" for each in text)


def real_array(value: object, name: str, expected: str = "real numbers") -> NDArray[np.float64]:
    """Return a float64 copy; raise ValueError unless all entries are real numbers."""
    try:
        given: NDArray[Any] = np.asarray(value)
    except ValueError:
        raise ValueError(f"{name}: expected {expected}, got a ragged sequence") from None
    if np.ma.is_masked(value):
        raise ValueError(f"{name}: expected {expected}, got a masked array with entries masked")
    if given.dtype.kind not in "iuf":
        raise ValueError(f"{name}: expected {expected}, got {given.dtype} entries")
    return np.array(given, dtype=np.float64)


def deviations(sigma: object, name: str, shape: tuple[int, ...], rule: str) -> NDArray[np.float64]:
    """Return standard deviations of a shape; ``rule`` begins with "> 0" or ">= 0" and names the unit."""
    expected = f"standard deviations {rule}"
    values = real_array(sigma, name, expected)
    bad = ~(np.isfinite(values) & (values >= 0.0 if rule.startswith(">=") else values > 0.0))
    if bad.any():
        raise ValueError(f"{name}: expected {expected}, got {values[bad][0]}")
    try:
        return np.broadcast_to(values, shape)
    except ValueError:
        raise ValueError(f"{name}: expected {expected}, got shape {values.shape}") from None


def number_in(
    value: object, name: str, expected: str, low: float = 0.0, high: float = math.inf, closed: bool = False
) -> float:
    """Return one finite number between two bounds, which ``closed`` includes."""
    with contextlib.suppress(ValueError):
        given = real_array(value, name)
        number = float(given) if given.shape == () else math.nan
        if math.isfinite(number) and (low < number < high or (closed and number in (low, high))):
            return number
    raise ValueError(f"{name}: expected {expected}, got {shown(value)}")


def whole_number(value: object, name: str, least: int, expected: str, most: float = math.inf) -> int:
    """Return a whole number from ``least`` to ``most``; raise ValueError otherwise."""
    if isinstance(value, int | np.integer) and not isinstance(value, bool) and least <= value <= most:
        return int(value)
    raise ValueError(f"{name}: expected {expected}, got {shown(value)}")


def shaped_array(value: object, core: tuple[int, ...], name: str, batch: bool = True) -> NDArray[np.float64]:
    """Return a float64 copy of shape ``core``, with leading axes if ``batch`` is True."""
    expected = f"(..., {', '.join(str(n) for n in core)})" if batch else str(core)
    array = real_array(value, name, f"real numbers of shape {expected}")
    if (array.shape[-len(core) :] if batch else array.shape) != core:
        raise ValueError(f"{name}: expected shape {expected}, got {array.shape}")
    return array


def finite_array(value: object, core: tuple[int, ...], name: str, batch: bool = True) -> NDArray[np.float64]:
    """Return the array of ``shaped_array`` with finite entries; raise ValueError otherwise."""
    array = shaped_array(value, core, name, batch)
    finite = np.isfinite(array)
    if not np.all(finite):
        where = tuple(int(i) for i in np.argwhere(~finite)[0])
        raise ValueError(f"{name}: expected finite numbers, entry {where} is {array[where]}")
    return array


def leading_shape(leading: Mapping[str, tuple[int, ...]]) -> tuple[int, ...]:
    """Broadcast the named shapes; raise ValueError for the first shape that does not broadcast."""
    shape: tuple[int, ...] = ()
    for name, lead in leading.items():
        try:
            shape = np.broadcast_shapes(shape, lead)
        except ValueError:
            raise ValueError(
                f"{name}: expected a leading shape that broadcasts with {shape}, got {lead}"
            ) from None
    return shape


def of_six(value: object, name: str) -> NDArray[np.float64]:
    """Return one finite number for each of six legs, from one or six; raise ValueError otherwise."""
    expected = "one finite number or six"
    values = real_array(value, name, expected)
    if values.shape not in ((), (6,)) or not np.isfinite(values).all():
        raise ValueError(f"{name}: expected {expected}, got {shown(value)}")
    return np.broadcast_to(values, (6,))


def instance(value: object, kind: type, name: str) -> None:
    """Raise ValueError unless a value is an instance of ``kind``."""
    if not isinstance(value, kind):
        raise ValueError(f"{name}: expected a {kind.__name__}, got {type(value).__name__}")


def truth(value: object, name: str) -> None:
    """Raise ValueError unless a value is True or False."""
    if not isinstance(value, bool | np.bool_):
        raise ValueError(f"{name}: expected True or False, got {shown(value)}")


def option(value: object, options: Sequence[str], name: str) -> str:
    """Return a value that is one of the options; raise ValueError otherwise."""
    if isinstance(value, str) and value in options:
        return value
    *others, last = (f'"{text}"' for text in options)
    expected = f"{', '.join(others)}{' or ' if others else ''}{last}"
    raise ValueError(f"{name}: expected {expected}, got {shown(value)}")


def status_text(name: str) -> str:
    """Format the name of a status or limit for text reports, with blanks."""
    return name.replace("_", " ")
