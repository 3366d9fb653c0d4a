"""Markdown that studies write for the documentation: paragraphs and tables."""

import textwrap
from collections.abc import Sequence
from typing import Any

Figures = dict[str, Any]
"""What a study wrote as JSON."""


def paragraph(line: str) -> str:
    """Lines of at most 110 columns and an empty one."""
    return textwrap.fill(line, 110, break_on_hyphens=False, break_long_words=False) + "\n\n"


def table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Header, rows and an empty line."""
    lines = [header, ["---"] * len(header), *rows]
    return (
        "".join(f"|{'|'.join(f' {cell} ' if cell else ' ' for cell in cells)}|\n" for cells in lines) + "\n"
    )
