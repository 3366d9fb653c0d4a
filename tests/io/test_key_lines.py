"""The line of every key is found, in all the ways in which TOML writes keys."""

import tomllib

import pytest

from stewart_sym.io.toml_reader import key_names, line_of

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
    found = {name: line_of(f"{name}:", text) for name in key_names(tomllib.loads(text))}
    assert {name: found[name] for name in WHERE} == {name: line(start) for name, start in WHERE.items()}
    assert found["leg 1"] == line("base") - 1


def test_a_message_is_placed_by_the_longest_key_that_it_begins_with() -> None:
    assert line_of("leg 2: upper.mass: expected more", TEXT) == line("mass = 3")
    assert line_of("leg 2: upper.inertia: missing", TEXT) == line("[leg .")
    assert line_of("leg 2: base: missing", TEXT) == line("[[leg]]")
    assert line_of("platform.points 3: expected 3 numbers", TEXT) == line("  [5, 6]")
    assert line_of("schema: missing", TEXT) == 1
    assert line_of("topmost: unknown key", TEXT) == 1
