"""The pages of help agree with the program: statuses, messages, extras, and terms."""

import ast
import re
from collections.abc import Iterator

import pytest
from pages import DOCS, TOP

from stewart_sym.derive.kernel.tree.constants import STATUSES
from stewart_sym.results import STATUS_TEXT

TROUBLES = (DOCS / "troubleshooting.md").read_text(encoding="utf-8")
ROW = re.compile(r"^\| `([^`]+)` \|", re.MULTILINE)


def section(title: str) -> str:
    """Return the text below a heading of the page."""
    (text,) = re.findall(rf"^## {title}\n(.*?)(?=^## |\Z)", TROUBLES, re.MULTILINE | re.DOTALL)
    return str(text)


def texts() -> Iterator[str]:
    """Yield every text of the program, adjacent pieces joined."""
    for path in (TOP / "stewart_sym").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.JoinedStr):
                yield "".join(str(part.value) for part in node.values if isinstance(part, ast.Constant))
            elif isinstance(node, ast.Constant) and isinstance(node.value, str):
                yield node.value


def test_every_status_is_explained() -> None:
    rows = re.findall(r"^\| (\d) \| (\S+)", section("Status of a pose"), re.MULTILINE)
    assert [int(code) for code, _ in rows] == sorted(STATUS_TEXT)
    names = dict(rows)
    assert all(names[str(code)].strip("`").endswith(name) for name, code, _ in STATUSES)


@pytest.mark.parametrize(
    ("title", "count"),
    [
        ("Installation messages", 4),
        ("Robot file messages", 7),
        ("Trajectory messages", 7),
        ("Messages of computations", 5),
    ],
)
def test_messages_are_those_of_the_program(title: str, count: int) -> None:
    program = "\n".join(texts())
    found = ROW.findall(section(title))
    assert len(found) == count
    pieces = [piece for message in found for piece in message.split("...") if piece]
    assert [piece for piece in pieces if piece not in program] == []
