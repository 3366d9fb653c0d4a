"""The README's tables."""

import re
from pathlib import Path

README_FOLDER = Path(__file__).parents[2]
README = (README_FOLDER / "README.md").read_text(encoding="utf-8")


def table_row(label: str) -> list[str]:
    """Cells of the table row that begins with ``label``."""
    found = re.search(rf"^\| {re.escape(label)} \|(.*)\|$", README, re.MULTILINE)
    assert found, label
    return [cell.strip() for cell in found[1].split("|")]
