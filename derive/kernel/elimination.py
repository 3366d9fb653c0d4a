"""Layouts of the elimination: location of the matrix entries, and exchange of rows.

``written.elimination`` is the text of the elimination. A layout consists of the arguments with which
``read.function`` reads this text.
"""

from collections.abc import Callable, Mapping

from ..trace.nodes import Element, Expression, Name
from ..trace.read import Given
from .written import elimination as text


def _entries(name: str) -> Callable[..., Expression]:
    """Return elements of an array."""
    return lambda *index: Element(Name(name), index)


def _one(name: str) -> Callable[..., Expression]:
    """Return one variable for all indices of a loop."""
    return lambda *_: Name(name)


RETURNED: Mapping[str, Given] = {"reject": text.returned, "CARRIED": 0}
"""A fault ends the function."""
CARRIED: Mapping[str, Given] = {"reject": text.carried, "CARRIED": 1}
"""A fault is a status that is carried on."""

_COMMON: Mapping[str, Given] = {
    "elimination": text.elimination,
    "begin": (),
    "exchange": (),
    "bring": (),
    "weigh_pivot": (),
    "invert": text.inverted,
    "update": text.by_entries,
    "substitute": text.one_by_one,
    "ROLLED": 0,
    "IN_ROWS": 0,
    "DIVIDES": 1,
}
_LOOPS: Mapping[str, Given] = {
    **_COMMON,
    "ROLLED": 1,
    "FIRST": 6,
    "a": _entries("A"),
    "upper": _entries("A"),
    "x": _entries("x"),
    "inverse": _entries("inverse"),
    "factor": _one("factor"),
    "total": _one("total"),
}
_EXCHANGED_ONCE: Mapping[str, Given] = {
    **_LOOPS,
    "begin": text.first_pivot,
    "exchange": text.look_below,
    "bring": text.exchange_once,
    "BESIDE": 0,
    "weigh_pivot": text.suspicion,
}

IN_ARRAYS: Mapping[str, Given] = {
    **_LOOPS,
    "inverse": _entries("x"),
    "HAS_INVERSE": 0,
    "exchange": text.exchange_selected,
    "weigh_pivot": text.suspicion,
}
"""Loops over rows and columns, for poses side by side in arrays."""

ONCE: Mapping[str, Given] = {**_EXCHANGED_ONCE, "DIVIDES": 0, "WIDTH": 7, "LONG": 0, "HAS_INVERSE": 1}
"""Loops for one pose, small in code."""

LONG_ROWS: Mapping[str, Given] = {
    **_EXCHANGED_ONCE,
    "update": text.by_long_rows,
    "substitute": text.row_by_row,
}
"""Many right sides."""

DEFINITE: Mapping[str, Given] = {
    **LONG_ROWS,
    "begin": (),
    "exchange": (),
    "bring": (),
    "weigh_pivot": text.definite,
    "scale": _entries("scale"),
}
"""Many right sides of a symmetric definite matrix, L D L^T: no rows change places."""

INVERSE: Mapping[str, Given] = {
    **_EXCHANGED_ONCE,
    "WIDTH": 6,
    "LONG": 0,
    "a": _entries("H"),
    "A": Name("H"),
    "BESIDE": 1,
    "weigh_pivot": text.regular,
    "invert": (),
    "update": text.above_as_well,
    "substitute": (),
}
"""The inverse, each row times its pivot, beside H."""


BY_POINTERS: Mapping[str, Given] = {
    **_COMMON,
    "IN_ROWS": 1,
    "DIVIDES": 0,
    "FIRST": 3,
    "a": _entries("row"),
    "x": _entries("x"),
    "begin": text.largest_of_column,
    "exchange": text.exchange_pointers,
    "weigh_pivot": text.product,
}
"""One pose without vector registers: rows change places by their addresses, an upper one is read once."""

BLOCKS_IN_ARRAYS: Mapping[str, Given] = {
    "two_blocks": text.two_blocks,
    "a": _entries("A"),
    "x": _entries("x"),
    "GUARDED": 1,
}
"""Two blocks of poses side by side in arrays; nothing is divided by zero, for derivatives' sake."""
