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
    sections = {key: value for key, value in table.items() if _is_section(value, path)}
    yield from (f"{key} = {_value(value)}" for key, value in table.items() if key not in sections)
    for key, value in sections.items():
        name, entries = f"{path}{key}", isinstance(value, list)
        for each in value if entries else [value]:
            # A table of sections only needs no header.
            nested = bool(each) and all(_is_section(one, name) for one in each.values())
            if entries or not nested:
                yield from ("", f"[[{name}]]" if entries else f"[{name}]")
            yield from _lines(each, f"{name}.")


def _is_section(value: object, path: str) -> bool:
    if isinstance(value, list):
        return bool(value) and isinstance(value[0], Mapping)
    nested = isinstance(value, Mapping) and any(isinstance(each, Mapping) for each in value.values())
    return isinstance(value, Mapping) and (not path or nested)


def _value(value: Any) -> str:
    if isinstance(value, Mapping):
        inside = ", ".join(f"{key} = {_value(each)}" for key, each in value.items())
        return f"{{ {inside} }}" if inside else "{}"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(_value, value))}]"
    # Strings, Booleans, and numbers have the same format as in JSON.
    return json.dumps(value, ensure_ascii=False)
