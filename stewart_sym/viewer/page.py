"""Assembly of one HTML file, which makes no request, from the files of the folder ``page`` and data."""

import base64
import hashlib
import html
import re
from collections.abc import Iterable, Mapping
from functools import cache
from importlib import resources
from importlib.metadata import version

_MARK = re.compile(r"@(\w+)@")
_IMPORT = re.compile(r'^import \{([^}]*)\} from "\./(\w+)\.js";\n', re.MULTILINE)
_EXPORT = re.compile(r"^export (?:const|function|class) (\w+)", re.MULTILINE)


BEGINNING = "<!DOCTYPE html>\n<!-- A page of stewart-sym:"
"""Beginning of every page, by which pages of this program are recognized."""


@cache
def text_of(name: str) -> str:
    """Return the text of a file of the page."""
    return (resources.files(__package__) / "page" / name).read_text(encoding="utf-8")


def filled(name: str, values: Mapping[str, str]) -> str:
    """Return a file of the page with its marks, ``@name@``, replaced by HTML values."""
    return _MARK.sub(lambda found: values[found[1]], text_of(name))


@cache
def script(name: str) -> str:
    """Join a module of the page and its imports into one script; every module becomes a function body."""
    order: list[str] = []

    def visit(module: str) -> None:
        for _, needed in _IMPORT.findall(text_of(f"{module}.js")):
            visit(needed)
        if module not in order:
            order.append(module)

    visit(name)
    return "\n".join(map(_wrapped, order))


def _wrapped(module: str) -> str:
    text = text_of(f"{module}.js")
    names = ", ".join(_EXPORT.findall(text))
    body = _EXPORT.sub(lambda found: found[0].removeprefix("export "), text)
    body = _IMPORT.sub(lambda found: f"const {{{found[1]}}} = {found[2]}Module;\n", body)
    return f"const {module}Module = (() => {{\n{body}return {{ {names} }};\n}})();"


def document(
    title: str, body: str, main: str, styles: Iterable[str] = ("style.css",), inner: Iterable[str] = ()
) -> str:
    """Return a complete HTML file.

    Its content security policy allows only its own scripts and styles, and no requests. ``title`` is the text
    of the browser tab, ``body`` is HTML, ``main`` names the module that runs, and ``styles`` names the style
    sheets. ``inner`` names the modules of embedded documents, which inherit the policy.
    """
    code, style = script(main), "".join(map(text_of, styles))
    inside = [*inner]
    return filled(
        "document.html",
        {
            "title": html.escape(title),
            "generator": generator(),
            "scripts": " ".join(map(_digest, [code, *map(script, inside)])),
            "styles": " ".join(map(_digest, [style, *(text_of("style.css") for _ in inside[:1])])),
            "style": style,
            "script": code,
            "body": body,
        },
    )


def generator() -> str:
    """Return the name and version of this program."""
    return f"stewart-sym {version('stewart-sym')}"


def _digest(text: str) -> str:
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"
