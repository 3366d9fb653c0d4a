"""Pages in narrow windows: line breaks in code after _ / . = and commas, and pictures as links."""

import html
import re
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

_SHORT = 12
"""Largest number of characters of a name that is never broken."""
_OPTION, _NAME = 20, 32
"""Largest number of characters of unbroken options, and of names that are broken only in narrow tables."""
_CODE = re.compile(r'<code class="[^"]*">.*?</code>', re.DOTALL)
_WORD = re.compile(r'<span class="pre">([^<]+)</span>')
_BREAK = re.compile(r"(?<=[_/.=,])(?=\w)")
# A phone shows a wide picture too small; a touch opens the file.
_PICTURE = re.compile(r'(?<=<p>)<img [^>]*?src="(?!data:)([^"]+)"[^>]*>(?=</p>)')


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the change of the written pages."""
    app.connect("html-page-context", _change_body)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _change_body(
    app: Sphinx, pagename: str, templatename: str, context: dict[str, Any], doctree: nodes.document | None
) -> None:
    if "body" in context:
        body = _CODE.sub(lambda code: _WORD.sub(_breakable, code[0]), context["body"])
        context["body"] = _PICTURE.sub(r'<a href="\1">\g<0></a>', body)


def _breakable(word: re.Match[str]) -> str:
    text = html.unescape(word[1])
    if len(text) <= (_OPTION if text.startswith("-") else _SHORT):
        return f'<span class="pre short">{word[1]}</span>'
    kind = "pre name" if len(text) <= _NAME and "/" not in text else "pre"
    return f'<span class="{kind}">{_BREAK.sub("<wbr>", word[1])}</span>'
