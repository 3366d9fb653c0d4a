"""The line of every key is found, in all the ways in which TOML writes keys."""

import tomllib
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from stewart_sym.io.key_lines import key_line, line_of, paths, spelled

TEXT = '''# comment = 1
top = 1
"quoted key".'and this' = """text
with = signs [and] {brackets}""" # and a comment

[platform]   # a table
when = 1979-05-27 07:32:00.5
points = [ # [ { "
  [1, 2], [3, 4],
  # ] }
  [5, 6],
]
inline = { mass = 1.5, inner = { z = "}" , a.b = 2 } }
parts = [{ shape = "rod" },
  { shape = 'tube#' }]
[[leg]]
base = 1
[leg.lower]
mass = 2
[[leg]]
empty = []
[leg . "upper"]
mass = 3
[leg.inner.more]
x = "\\"]\\\\"
'''
WHERE = {
    "top": "top = 1",
    "quoted key.and this": '"quoted key"',
    "platform": "[platform]",
    "platform.when": "when",
    "platform.points": "points",
    "platform.points 1": "  [1, 2]",
    "platform.points 2": "  [1, 2]",
    "platform.points 3": "  [5, 6]",
    "platform.inline.inner.a.b": "inline",
    "platform.parts 1: shape": "parts",
    "platform.parts 2: shape": "  { shape = 'tube#'",
    "leg 1: base": "base",
    "leg 1: lower.mass": "mass = 2",
    "leg 2": "[[leg]]",
    "leg 2: upper.mass": "mass = 3",
    "leg 2: inner.more.x": "x = ",
}


def line(start: str) -> int:
    """The last line that begins so."""
    return max(i for i, text in enumerate(TEXT.splitlines(), 1) if text.startswith(start))


@pytest.mark.parametrize("newline", ["\n", "\r\n"])
def test_every_key_is_found_at_its_line(newline: str) -> None:
    text = TEXT.replace("\n", newline)
    found = {spelled(path): key_line(path, text) for path in paths(tomllib.loads(text))}
    assert {name: found[name] for name in WHERE} == {name: line(start) for name, start in WHERE.items()}
    assert found["leg 1"] == line("base") - 1


def test_a_message_is_placed_by_the_longest_key_that_it_begins_with() -> None:
    assert line_of("leg 2: upper.mass: expected more", TEXT) == line("mass = 3")
    assert line_of("leg 2: upper.inertia: missing", TEXT) == line("[leg .")
    assert line_of("leg 2: base: missing", TEXT) == line("[[leg]]")
    assert line_of("platform.points 3: expected 3 numbers", TEXT) == line("  [5, 6]")
    assert line_of("schema: missing", TEXT) == 1
    assert line_of("topmost: unknown key", TEXT) == 1


KEYS = st.text(st.sampled_from("ab_-1. \"'#[]={},\\\té"), min_size=1, max_size=4)
VALUES = st.recursive(
    st.one_of(st.integers(-9, 9), st.text(st.sampled_from("a\"'#[]{},=\\\n"), max_size=5), st.booleans()),
    lambda inner: st.one_of(st.lists(inner, max_size=3), st.dictionaries(KEYS, inner, max_size=3)),
    max_leaves=8,
)


def quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n").replace("\t", "\\t")
    return f'"{escaped}"'


def written(value: Any) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{quoted(key)} = {written(each)}" for key, each in value.items()) + "}"
    if isinstance(value, list):
        return "[" + "".join(f"\n {written(each)}," for each in value) + "\n]"
    return quoted(value) if isinstance(value, str) else str(value).lower()


@settings(derandomize=True, deadline=None, max_examples=150)
@given(st.dictionaries(KEYS, VALUES, max_size=4))
def test_keys_written_in_any_way_are_found_where_they_begin(top: dict[str, Any]) -> None:
    text = "".join(f"{quoted(key)} = {written(value)}\n" for key, value in top.items())
    assert tomllib.loads(text) == top
    lines = text.splitlines()
    for key in top:
        assert lines[key_line((key,), text) - 1].startswith(quoted(key))
