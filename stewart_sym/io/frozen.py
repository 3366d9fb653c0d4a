"""Base class of records with read-only arrays, also in copies and after unpickling.

A frozen dataclass with arrays derives from ``Frozen``.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray


def read_only(array: NDArray[Any]) -> NDArray[Any]:
    """Return a read-only view of an array without other references; the array itself becomes read-only too.

    ``setflags(write=True)`` raises ValueError for the view, because NumPy permits it only for the owner of
    the memory.
    """
    owner = array if array.flags.owndata else array.copy()
    owner.setflags(write=False)
    return owner.view()


class Frozen:
    """Base of frozen dataclasses, whose array fields are read-only, also in copies and after unpickling."""

    def _set(self, values: Mapping[str, Any]) -> None:
        """Set fields; arrays become read-only and must not have other references."""
        for name, value in values.items():
            object.__setattr__(self, name, read_only(value) if isinstance(value, np.ndarray) else value)

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Set the state of a copy or a pickle.

        Writeable arrays, as from a deep copy or a pickle, are replaced by read-only copies. They may have
        other references, as in a shallow copy of ``Motion._unchecked``.
        """
        self._set({name: _own(value) for name, value in state.items()})


def _own(value: Any) -> Any:
    return value.copy() if isinstance(value, np.ndarray) and value.flags.writeable else value
