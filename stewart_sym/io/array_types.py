"""Array types for annotations, and the base class of frozen dataclasses with arrays."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
Codes = NDArray[np.int32]
Indices = NDArray[np.intp]


def read_only(array: NDArray[Any]) -> NDArray[Any]:
    """Return a view of an array that cannot be made writable, because the owner of its data is read-only."""
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
        """Set the state of a copy or a pickle; copy arrays, which may have other references."""
        arrays = {name: value.copy() for name, value in state.items() if isinstance(value, np.ndarray)}
        self._set({**state, **arrays})
