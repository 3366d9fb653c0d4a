"""The README and the pages of the documentation: their text, tables, links, pictures and blocks of code."""

import ast
import contextlib
import io
import os
import re
import shlex
import subprocess
import sys
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import matplotlib.image
import numpy as np
from quick_compiler import quick_path

import stewart_sym as ss
from stewart_sym.cli.main import main

TOP = Path(__file__).parents[2]
DOCS = TOP / ".docs"
NOT_PAGES = {"_build", "tables"}
PAGES = (
    "README.md",
    *sorted(
        path.relative_to(TOP).as_posix()
        for path in DOCS.rglob("*.md")
        if not NOT_PAGES & set(path.relative_to(DOCS).parts)
    ),
)

LINK = re.compile(r"(!?)\[[^\]]*\]\(([^)\s]+)\)")
BLOCK = re.compile(r"^```(\S*)[^\n]*\n(.*?)^```$", re.MULTILINE | re.DOTALL)
FILE_NAME = re.compile(r"(?:#|//|/\*|%) ([\w.-]+\.(?:toml|c|cpp|txt|rs|m|py))\b")
SHAPE = re.compile(r"\((\d+(?:, \d+)*),?\)")
NUMBER = re.compile(r"-?\d+(?:\.(\d+))?")
SHELL_ONLY = re.compile(r"[$|<>;()]")
"""In commands that only a shell can run."""
SAME = 0.002
"""Mean difference of two drawings of the same figure, of 0 to 1: fonts differ from system to system."""
LEFT_OUT = "..."
"""Stands for lines of an output that a page leaves out."""
ROUNDING = 1e-9
"""Largest of what a comment calls 0 up to rounding, N and m/s^2."""


def text_of(page: str) -> str:
    """A page as it is, with the tables that it includes."""
    text = (TOP / page).read_text(encoding="utf-8")
    folder = (TOP / page).parent
    return re.sub(
        r"^```\{include\} (\S+)\n```$",
        lambda found: (folder / found[1]).read_text(encoding="utf-8"),
        text,
        flags=re.MULTILINE,
    )


def prose_of(page: str) -> str:
    """A page's text with one space between words."""
    return " ".join(text_of(page).split())


def table_row(page: str, label: str) -> list[str]:
    """Cells of the table row that begins with ``label``."""
    found = re.search(rf"^\| {re.escape(label)} \|(.*)\|$", text_of(page), re.MULTILINE)
    assert found, (page, label)
    return [cell.strip() for cell in found[1].split("|")]


def links(page: str) -> list[str]:
    """Targets of links, pictures left out."""
    return [target for mark, target in LINK.findall(without_code(page)) if not mark]


def pictures(page: str) -> list[Path]:
    """Files of the pictures that a page shows."""
    shown = [target for mark, target in LINK.findall(without_code(page)) if mark]
    return [((TOP / page).parent / target).resolve() for target in shown]


def without_code(page: str) -> str:
    """A page's text but for its blocks."""
    return BLOCK.sub("", text_of(page))


def anchors(page: Path) -> set[str]:
    """Anchors of a page's headings, as MyST and GitHub name them."""
    headings = re.findall(r"^#+ (.*)$", BLOCK.sub("", page.read_text(encoding="utf-8")), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def same_picture(one: Path, other: Path) -> bool:
    """Whether two files show the same, but for how fonts are drawn."""
    images = [matplotlib.image.imread(path)[..., :3] for path in (one, other)]
    return images[0].shape == images[1].shape and float(np.abs(images[0] - images[1]).mean()) < SAME


@dataclass(frozen=True)
class Block:
    """Code of a page, and its language."""

    language: str
    text: str

    @property
    def file_name(self) -> str:
        """Name of the file that it is, from a comment in its first line; "" for none."""
        found = FILE_NAME.match(self.text)
        return found[1] if found else ""


def blocks(page: str) -> Iterator[Block]:
    """Code of a page in order, directives left out."""
    for language, text in BLOCK.findall((TOP / page).read_text(encoding="utf-8")):
        if not language.startswith("{"):
            yield Block(language, text)


def prepared(page: str, folder: Path) -> Path:
    """A folder as the page's reader has it: the source's top folder, or that of the examples."""
    for name in ("stewart_sym", ".docs"):
        (folder / name).symlink_to(TOP / name)
    if page != "README.md":
        for path in (DOCS / "examples").iterdir():
            (folder / path.name).write_bytes(path.read_bytes())
    return folder


def run_page(page: str, folder: Path) -> int:
    """Run a page's Python, shell and files in order, in this working directory.

    Values are compared with comments, output with the block of text that follows a command; returns how many
    were compared. A motion's name keeps its shape: an array of another batch meets it by broadcasting,
    without an error.
    """
    names: dict[str, Any] = {}
    shapes: dict[str, tuple[int, ...]] = {}
    count, printed = 0, None
    for block in blocks(page):
        if block.file_name:
            (folder / block.file_name).write_text(block.text, encoding="utf-8")
        elif block.language == "python":
            count += run_and_compare(block.text, names)
            for name, value in names.items():
                if isinstance(value, ss.Motion):
                    assert shapes.setdefault(name, value.shape) == value.shape, name
        elif block.language == "sh":
            printed = output(block.text, folder)
        elif block.language == "text" and printed is not None:
            lines = [*filter(None, map(str.strip, block.text.splitlines()))]
            assert is_excerpt(lines, printed), (
                f"{block.text}\nis not, with ... where lines are left out, of\n{printed}"
            )
            count += len(lines) - lines.count(LEFT_OUT)
    return count


def is_excerpt(lines: list[str], printed: str) -> bool:
    """Whether lines are those of an output in order, with ``LEFT_OUT`` wherever it has others, ends too."""
    rest = [*filter(None, map(str.strip, printed.splitlines()))]
    skips = False
    for line in lines:
        if line == LEFT_OUT:
            skips = True
            continue
        at = next((i for i, found in enumerate(rest) if line == found), None)
        if at is None or (at > 0 and not skips):
            return False
        rest, skips = rest[at + 1 :], False
    return skips or not rest


def output(commands: str, folder: Path) -> str:
    """What commands print: those of the program by a call of it, which keeps what the last one derived and
    compiled; others by a shell.
    """
    printed = io.StringIO()
    shell: list[str] = []
    for line in _lines(commands):
        words = shlex.split(line) if not SHELL_ONLY.search(line) else []
        if words[:1] == ["stewart-sym"]:
            printed.write(shell_output("\n".join(shell), folder))
            shell = []
            with contextlib.redirect_stdout(printed), warnings.catch_warnings(action="default"):
                assert main(words[1:]) == 0, line
        else:
            shell.append(line)
    printed.write(shell_output("\n".join(shell), folder))
    return printed.getvalue()


def _lines(commands: str) -> list[str]:
    """Commands of a block; the whole where one of them has its input in the block."""
    if "<<" in commands:
        return [commands]
    lines = commands.replace("\\\n", " ").splitlines()
    return [part for line in lines for part in ([line] if "(" in line else line.split(" && "))]


def shell_output(commands: str, folder: Path) -> str:
    """What a shell prints of commands; they are found where this interpreter is, C is compiled quickly."""
    if not commands:
        return ""
    places = os.pathsep.join([str(Path(sys.executable).parent), quick_path(folder / ".compilers")])
    done = subprocess.run(
        ["bash", "-e", "-c", commands],
        cwd=folder,
        env=os.environ | {"PATH": places},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, f"{commands}{done.stdout}{done.stderr}"
    return done.stdout


def compared(value: object, comment: str) -> int:
    """Check a value against the shape, the number or both that its comment begins with; returns how many."""
    text, count = comment, 0
    if shape := SHAPE.match(text):
        assert np.shape(value) == tuple(int(length) for length in shape[1].split(", ")), comment
        text, count = text[shape.end() :].lstrip(":, "), 1
    if number := NUMBER.match(text):
        within = ROUNDING if "up to rounding" in text else 0.5 * 10.0 ** -len(number[1] or "")
        assert np.abs(np.asarray(value) - float(number[0])).max() <= within, comment
        count += 1
    return count


def run_and_compare(text: str, names: dict[str, Any]) -> int:
    """Run statements in order, each compared with the comment at its end; returns how many were compared."""
    lines, count = text.splitlines(), 0
    for statement in ast.parse(text).body:
        assert statement.end_lineno is not None
        comment = lines[statement.end_lineno - 1].encode()[statement.end_col_offset :].decode()
        comment = comment.strip().removeprefix("#").strip()
        if isinstance(statement, ast.Expr):
            value = eval(compile(ast.Expression(statement.value), "page", "eval"), names)
        else:
            exec(compile(ast.Module([statement], []), "page", "exec"), names)
            target = statement.targets[0] if isinstance(statement, ast.Assign) else None
            value = names[target.id] if isinstance(target, ast.Name) else None
        count += compared(value, comment)
    return count
