"""JSON text of results, in one format for all files of this program."""

import json
import math
from collections.abc import Mapping
from typing import Any

import numpy as np


def json_text(data: Any) -> str:
    """Format data as indented JSON with a final newline; arrays become lists, and non-finite numbers null."""
    return json.dumps(plain(data), indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def plain(value: Any) -> Any:
    """Convert arrays, NumPy scalars, mappings, and tuples to numbers, lists, and dictionaries of Python."""
    if isinstance(value, np.ndarray | np.generic):
        value = value.tolist()
    if isinstance(value, Mapping):
        return {str(key): plain(each) for key, each in value.items()}
    if isinstance(value, list | tuple):
        return [plain(each) for each in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
