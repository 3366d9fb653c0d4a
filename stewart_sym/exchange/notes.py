"""Fields of a robot in the file of another program, as JSON."""

import json
from typing import Any


def parsed_notes(text: str | None, where: str) -> dict[str, Any]:
    """Fields by name; empty without a text."""
    if text is None:
        return {}
    try:
        found = json.loads(text)
    except (ValueError, RecursionError):
        raise ValueError(f"{where}: expected JSON") from None
    if not isinstance(found, dict):
        raise ValueError(f"{where}: expected a table")
    return found
