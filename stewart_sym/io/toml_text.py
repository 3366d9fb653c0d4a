"""Formatting of tables as TOML text."""

import json
from collections.abc import Iterator, Mapping
from typing import Any


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
