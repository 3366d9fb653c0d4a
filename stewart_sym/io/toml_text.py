"""Formatting of tables as TOML text."""

import json
from collections.abc import Iterator, Mapping
from typing import Any


def toml_text(tables: Mapping[str, Any], inline: bool = True) -> str:
    """Format tables of strings, numbers, lists, and tables as TOML.

    ``inline`` writes a table without nested tables in one line, except for the top-level tables of the file.
    Otherwise every table is a section.
    """
    return "\n".join(_lines(tables, "", inline)) + "\n"


def _lines(table: Mapping[str, Any], path: str, inline: bool) -> Iterator[str]:
    sections = {key: value for key, value in table.items() if _is_section(value, path, inline)}
    for key, value in table.items():
        if key not in sections:
            yield f"{key} = {_value(value)}"
    for key, value in sections.items():
        for each in value if isinstance(value, list) else [value]:
            name = f"{path}{key}"
            if (
                not inline
                or isinstance(value, list)
                or not each
                or not all(_is_section(one, name, inline) for one in each.values())
            ):
                yield ""
                yield f"[[{name}]]" if isinstance(value, list) else f"[{name}]"
            yield from _lines(each, f"{name}.", inline)


def _is_section(value: object, path: str, inline: bool) -> bool:
    if isinstance(value, list):
        return bool(value) and isinstance(value[0], Mapping)
    return isinstance(value, Mapping) and (
        not path or not inline or any(isinstance(each, Mapping) for each in value.values())
    )


def _value(value: Any) -> str:
    if isinstance(value, Mapping):
        inside = ", ".join(f"{key} = {_value(each)}" for key, each in value.items())
        return f"{{ {inside} }}" if inside else "{}"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(_value, value))}]"
    # Strings, Booleans, and numbers have the same format as in JSON.
    return json.dumps(value, ensure_ascii=False)
