"""Line breaks of names and options in code: after _ / . = and commas, and nowhere in short words."""

import html
import re
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

_SHORT = 12
"""Largest number of characters of a name that is never broken."""
_OPTION = 20
"""Largest number of characters of an option that is never broken, nor a name outside the tables of phones."""
_CODE = re.compile(r'<code class="[^"]*">.*?</code>', re.DOTALL)
_WORD = re.compile(r'<span class="pre">([^<]+)</span>')
_BREAK = re.compile(r"(?<=[_/.=,])(?=\w)")


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the change of the written pages."""
    app.connect("html-page-context", _wrap_code)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _wrap_code(
    app: Sphinx, pagename: str, templatename: str, context: dict[str, Any], doctree: nodes.document | None
) -> None:
    if "body" in context:
        context["body"] = _CODE.sub(lambda code: _WORD.sub(_breakable, code[0]), context["body"])


def _breakable(word: re.Match[str]) -> str:
    text = html.unescape(word[1])
    if len(text) <= (_OPTION if text.startswith("-") else _SHORT):
        return f'<span class="pre short">{word[1]}</span>'
    kind = "pre name" if len(text) <= _OPTION else "pre"
    return f'<span class="{kind}">{_BREAK.sub("<wbr>", word[1])}</span>'
