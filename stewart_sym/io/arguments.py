"""What an argument must be, checked in one place so that every rejection is one line that names it."""

import contextlib
import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray


def shown(value: object) -> str:
    """Return a value as it may stand in a one-line message."""
    try:
        text = " ".join(repr(value).split())
    except (ValueError, RecursionError):
        # Python shows no integer of thousands of digits and nothing nested a thousand deep.
        return f"{type(value).__name__} too long to show"
    return text if len(text) <= 60 else text[:57] + "..."


def safe_text(text: str) -> str:
    """A text in one line, with its number for each character that does not show as itself.

    Such are marks of direction, of no width and of control.
    """
    return "".join(each if each.isprintable() else f"[U+{ord(each):04X}]" for each in text)


def real_array(value: object, name: str, expected: str = "real numbers") -> NDArray[np.float64]:
    """Return a float64 copy; ValueError that says what was ``expected`` if these are no real numbers."""
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
    """Return standard deviations spread over a shape; rule: "> 0" or ">= 0", a unit, and over what."""
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
    """Return one finite number between two others, or one of these if ``closed``; ValueError otherwise."""
    with contextlib.suppress(ValueError):
        given = real_array(value, name)
        number = float(given) if given.shape == () else math.nan
        if math.isfinite(number) and (low < number < high or (closed and number in (low, high))):
            return number
    raise ValueError(f"{name}: expected {expected}, got {shown(value)}")


def whole_number(value: object, name: str, least: int, expected: str, most: float = math.inf) -> int:
    """Return a whole number from ``least`` to ``most``; ValueError otherwise."""
    whole = isinstance(value, int | np.integer) and not isinstance(value, bool)
    if not whole or not least <= value <= most:  # type: ignore[operator]
        raise ValueError(f"{name}: expected {expected}, got {shown(value)}")
    return int(value)  # type: ignore[call-overload, no-any-return]


def shaped_array(value: object, core: tuple[int, ...], name: str, batch: bool = True) -> NDArray[np.float64]:
    """Return a float64 copy of shape (..., *core); ValueError for anything else.

    batch: whether there may be leading axes.
    """
    expected = f"(..., {', '.join(str(n) for n in core)})" if batch else str(core)
    array = real_array(value, name, f"real numbers of shape {expected}")
    if (array.shape[-len(core) :] if batch else array.shape) != core:
        raise ValueError(f"{name}: expected shape {expected}, got {array.shape}")
    return array


def finite_array(value: object, core: tuple[int, ...], name: str, batch: bool = True) -> NDArray[np.float64]:
    """Return what ``shaped_array`` does, with finite entries; ValueError for anything else."""
    array = shaped_array(value, core, name, batch)
    finite = np.isfinite(array)
    if not np.all(finite):
        where = tuple(int(i) for i in np.argwhere(~finite)[0])
        raise ValueError(f"{name}: expected finite numbers, entry {where} is {array[where]}")
    return array


def leading_shape(leading: Mapping[str, tuple[int, ...]]) -> tuple[int, ...]:
    """Return the shape to which the named shapes broadcast; ValueError names the first that does not."""
    shape: tuple[int, ...] = ()
    for name, lead in leading.items():
        try:
            shape = np.broadcast_shapes(shape, lead)
        except ValueError:
            raise ValueError(
                f"{name}: expected a leading shape that broadcasts with {shape}, got {lead}"
            ) from None
    return shape


def instance(value: object, kind: type, name: str) -> None:
    """Reject, by ValueError, what is no ``kind``."""
    if not isinstance(value, kind):
        raise ValueError(f"{name}: expected a {kind.__name__}, got {type(value).__name__}")


def truth(value: object, name: str) -> None:
    """Reject, by ValueError, what is no truth value."""
    if not isinstance(value, bool | np.bool_):
        raise ValueError(f"{name}: expected True or False, got {shown(value)}")


def option(value: object, options: Sequence[str], name: str) -> None:
    """Reject, by ValueError, what is none of the options."""
    if not isinstance(value, str) or value not in options:
        raise ValueError(f"{name}: {no_option(value, options)}")


def no_option(value: object, options: Sequence[str]) -> str:
    """What an error says of a value that is none of the options."""
    *others, last = (f'"{text}"' for text in options)
    return f"expected {', '.join(others)}{' or ' if others else ''}{last}, got {shown(value)}"


def status_text(name: str) -> str:
    """Return the name of a status or limit as text reports write it, with blanks."""
    return name.replace("_", " ")
