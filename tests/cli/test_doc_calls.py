"""Calls shown in README, pages, notebook and docstrings: keywords wherever arguments could be swapped."""

import ast
import json
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from pages import PAGES

import stewart_sym as ss

ROOT = Path(__file__).parents[2]
CONSTRUCTORS = ("from_rpy", "from_quaternion", "from_rotation_vector")
# A robot and what is asked of it differ by their types; a third argument is not.
MOST = 2
MODULES = sorted(path.relative_to(ROOT).as_posix() for path in ROOT.glob("stewart_sym/**/*.py"))


def parsed(text: str) -> ast.AST | None:
    """Code of a text, None of what is no Python."""
    try:
        return ast.parse(text)
    except SyntaxError:
        return None


def pieces(text: str) -> Iterator[str]:
    """Code in a page or docstring: its blocks of Python and what stands in backticks."""
    yield from re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    without = re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)
    yield from re.findall(r"``?([^`\n]+)``?", without)


def swappable(code: str) -> list[str]:
    """Calls of this library in a piece of code with more positional arguments than types tell apart."""
    tree = parsed(code) if "(" in code else None
    found = []
    for call in ast.walk(tree) if tree else ():
        if isinstance(call, ast.Call):
            owner, _, name = ast.unparse(call.func).rpartition(".")
            ours = name in CONSTRUCTORS or (name in ss.__all__ and owner in ("", "ss"))
            most = 0 if name in (*CONSTRUCTORS, "Motion") else MOST
            if ours and len(call.args) > most:
                found.append(ast.unparse(call))
    return found


def docstrings(path: Path) -> Iterator[str]:
    """Docstrings of a module; lines of one that are a program count as code."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
            text = ast.get_docstring(node) or ""
            yield text
            yield from (f"`{line.strip()}`" for line in text.splitlines() if "(" in line)


def test_a_call_that_may_be_swapped_is_found() -> None:
    assert swappable("m = ss.Motion(R, t, omega, v)") == ["ss.Motion(R, t, omega, v)"]
    assert swappable("ss.linearise(robot, motion, F)") == ["ss.linearise(robot, motion, F)"]
    assert not swappable(
        "ss.linearise(robot, motion, F=F), ss.Motion(R=R, t=t, omega=w, v=v), print(1, 2, 3)"
    )


@pytest.mark.parametrize("page", PAGES)
def test_pages_name_arguments(page: str) -> None:
    text = (ROOT / page).read_text(encoding="utf-8")
    assert [call for piece in pieces(text) for call in swappable(piece)] == []


def test_the_notebook_names_arguments() -> None:
    cells = json.loads((ROOT / "derive" / "derivation.ipynb").read_text(encoding="utf-8"))["cells"]
    sources = [("".join(cell["source"]), cell["cell_type"]) for cell in cells]
    code = [piece for text, kind in sources for piece in ([text] if kind == "code" else pieces(text))]
    assert len(code) > len(cells)
    assert [call for piece in code for call in swappable(piece)] == []


def test_docstrings_name_arguments() -> None:
    texts = [(path, text) for path in MODULES for text in docstrings(ROOT / path)]
    assert [(path, call) for path, text in texts for piece in pieces(text) for call in swappable(piece)] == []
