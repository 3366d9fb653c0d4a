"""Figures as JSON text, in one way wherever this program writes JSON."""

import json
import math
from collections.abc import Mapping
from typing import Any

import numpy as np


def json_text(data: Any) -> str:
    """Indented text with a newline at its end; arrays as lists, null for a number that is not finite."""
    return json.dumps(plain(data), indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def plain(value: Any) -> Any:
    """The same in Python's own numbers, lists and dictionaries."""
    if isinstance(value, np.ndarray | np.generic):
        value = value.tolist()
    if isinstance(value, Mapping):
        return {str(key): plain(each) for key, each in value.items()}
    if isinstance(value, list | tuple):
        return [plain(each) for each in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
