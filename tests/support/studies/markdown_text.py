"""Paragraphs and tables of the documentation in Markdown."""

import textwrap
from collections.abc import Sequence


def paragraph(line: str) -> str:
    """Format a Markdown paragraph with lines of at most 110 characters and an empty line."""
    return textwrap.fill(line, 110, break_on_hyphens=False, break_long_words=False) + "\n\n"


def table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Format a Markdown table with header, rows, and an empty line."""
    lines = [header, ["---"] * len(header), *rows]
    return (
        "".join(f"|{'|'.join(f' {cell} ' if cell else ' ' for cell in cells)}|\n" for cells in lines) + "\n"
    )
