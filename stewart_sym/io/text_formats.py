"""JSON and TOML text, in one format for all files of this program."""

import json
import math
from collections.abc import Iterator, Mapping
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


def toml_text(tables: Mapping[str, Any]) -> str:
    """Format tables of strings, numbers, lists, and tables as TOML.

    A table without nested tables is written in one line, except for the top-level tables of the file.
    """
    return "\n".join(_lines(tables, "")) + "\n"


def _lines(table: Mapping[str, Any], path: str) -> Iterator[str]:
    sections = {key: value for key, value in table.items() if isinstance(value, Mapping)}
    if path:
        sections = {k: v for k, v in sections.items() if any(isinstance(x, Mapping) for x in v.values())}
    yield from (f"{key} = {_value(value)}" for key, value in table.items() if key not in sections)
    for key, value in sections.items():
        yield from ("", f"[{path}{key}]")
        yield from _lines(value, f"{path}{key}.")


def _value(value: Any) -> str:
    if isinstance(value, Mapping):
        inside = ", ".join(f"{key} = {_value(each)}" for key, each in value.items())
        return f"{{ {inside} }}" if inside else "{}"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(_value, value))}]"
    # Strings, Booleans, and numbers have the same format as in JSON.
    return json.dumps(value, ensure_ascii=False)
