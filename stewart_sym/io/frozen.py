"""Records whose arrays stay read-only, in copies and after a pickle as well.

A frozen dataclass with arrays derives from ``Frozen``.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray


def read_only(array: NDArray[Any]) -> NDArray[Any]:
    """Return a read-only view of an array that nobody else holds; the array itself is closed too.

    ``setflags(write=True)`` raises ValueError for the view: NumPy reopens the owner of memory alone.
    """
    owner = array if array.flags.owndata else array.copy()
    owner.setflags(write=False)
    return owner.view()


class Frozen:
    """Base of frozen dataclasses: array fields are set read-only, and come so out of copies and pickles."""

    def _set(self, values: Mapping[str, Any]) -> None:
        """Set fields; arrays become read-only and must be held by nobody else."""
        for name, value in values.items():
            object.__setattr__(self, name, read_only(value) if isinstance(value, np.ndarray) else value)

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Take the state of a copy or a pickle.

        Arrays that arrive writeable, as all do from a deep copy or a pickle, are replaced by read-only
        copies: they may belong to somebody else, as those of a shallow copy of ``Motion.unchecked`` do.
        """
        self._set({name: _own(value) for name, value in state.items()})


def _own(value: Any) -> Any:
    return value.copy() if isinstance(value, np.ndarray) and value.flags.writeable else value
