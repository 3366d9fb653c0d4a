"""Pages made of notebooks: text, code that can be unfolded, and the committed outputs.

The mark ``<!-- notebook: derive/NAME.ipynb -->`` of a page is replaced by the cells after the title.
"""

import json
import re
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

MARK = re.compile(r"<!-- notebook: (derive/\w+\.ipynb) -->")
_TOP = Path(__file__).parents[2]
_CODE = "<details>\n<summary>Code</summary>\n\n```python\n{}\n```\n\n</details>\n"


def markdown_of(notebook: Path) -> str:
    """Convert a notebook to Markdown without its title, with links as seen from a page."""
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    parts = [part for cell in cells for part in _parts(cell)]
    return re.sub(r"\A# .*\n", "", "\n\n".join(parts))


def _parts(cell: dict[str, Any]) -> list[str]:
    """Return the parts of a cell as Markdown."""
    text = "".join(cell["source"])
    if cell["cell_type"] == "markdown":
        return [text.replace("(attachment:", "(../drawings/").replace("(../.docs/", "(../")]
    return [_CODE.format(text), *map(_output, cell["outputs"])]


def _output(output: dict[str, Any]) -> str:
    """Return an output as Markdown: a picture, an equation, a table, or printed lines."""
    data, text = output.get("data", {}), "".join(output.get("text", ()))
    if "image/png" in data:
        alt = output["metadata"]["image/png"]["alt"]
        return f"![{alt}](data:image/png;base64,{''.join(data['image/png'].split())})"
    for kind in ("text/latex", "text/markdown"):
        if kind in data:
            return "".join(data[kind])
    return f"```text\n{text.rstrip()}\n```"


def _insert(_app: Sphinx, _page: str, source: list[str]) -> None:
    """Replace the mark of a page by the notebook."""
    source[0] = MARK.sub(lambda mark: markdown_of(_TOP / mark[1]), source[0])


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the conversion."""
    app.connect("source-read", _insert)
    return {"parallel_read_safe": True}
