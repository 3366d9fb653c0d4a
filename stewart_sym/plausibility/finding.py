"""Finding about a robot."""

from typing import NamedTuple


class Finding(NamedTuple):
    """Finding about a robot: name, as in ``suppressed_warnings``, and text with the likely cause."""

    name: str
    text: str
