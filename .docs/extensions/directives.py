"""What the pages of reference ask for by directives.

``{statuses}`` and ``{structs}``: tables of the C interface, from the table that writes the headers.
``{derived} PATH``: a file of ``generated/`` that is derived at first use.
``{subcommands}``: a section for each subcommand, from its argparse parser.
``{public} FOLDER ...``: the public names that modules in these folders define, by autodoc.
``{machine} PATH``: the paper's machine on one of its paths, as ``stewart-sym view`` shows it.
"""

import argparse
import inspect
import re
from pathlib import Path
from typing import ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from markdown_text import table
from sphinx.application import Sphinx
from sphinx.pycode import ModuleAnalyzer
from sphinx.util.docutils import SphinxDirective

import stewart_sym as ss
from stewart_sym.backend.kernel import generated_text
from stewart_sym.cli import main
from stewart_sym.derive.kernel.interface import STRUCTS
from stewart_sym.derive.trace.constants import STATUSES
from stewart_sym.viewer.view import frame

_HEIGHT = 780
"""Of the viewer."""


class Statuses(SphinxDirective):
    """Status codes."""

    def run(self) -> list[nodes.Node]:
        """One table."""
        rows = [(str(code), f"`STEWART_{name}`", meaning) for name, code, meaning in STATUSES]
        return self.parse_text_to_nodes(table(("status", "name", "meaning"), rows))


class Structs(SphinxDirective):
    """Members of every struct."""

    def run(self) -> list[nodes.Node]:
        """One table a struct, under its name."""
        parts = []
        for name, members in STRUCTS.items():
            rows = [(f"`{each.name}{each.dims}`", each.unit, each.meaning) for each in members]
            parts.append(f"**`stewart_{name}`**\n\n{table(('member', 'unit', 'meaning'), rows)}")
        return self.parse_text_to_nodes("".join(parts))


class Derived(SphinxDirective):
    """File that ``generated/`` does not contain."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Return one block of code."""
        text = generated_text(self.arguments[0])
        return [nodes.literal_block(text, text, language="c")]


def parsers() -> dict[str, argparse.ArgumentParser]:
    """Parser of each subcommand."""
    return {name: main.subcommand_parser(name) for name in main.SUBCOMMANDS}


class Subcommands(SphinxDirective):
    """Usage, description, options and example of every subcommand."""

    def run(self) -> list[nodes.Node]:
        """One section a subcommand."""
        return [self._section(name, parser) for name, parser in parsers().items()]

    def _section(self, name: str, parser: argparse.ArgumentParser) -> nodes.section:
        section = nodes.section("", nodes.title(text=name), ids=[nodes.make_id(f"stewart-sym-{name}")])
        section += [_paragraph(line) for line in parser.description.splitlines()]
        section += _code(parser.format_usage().removeprefix("usage: "))
        for group in parser._action_groups:
            shown = [each for each in group._group_actions if each.dest != "help"]
            if shown:
                section += nodes.paragraph(
                    "", "", nodes.strong(text=f"{group.title[0].upper()}{group.title[1:]}")
                )
                section += _options(parser, shown)
        if parser.epilog:
            section += _code(parser.epilog.removeprefix("Example: "))
        return section


def _options(parser: argparse.ArgumentParser, actions: list[argparse.Action]) -> nodes.definition_list:
    formatter = parser._get_formatter()
    found = nodes.definition_list()
    for action in actions:
        term = nodes.term("", "", nodes.literal(text=formatter._format_action_invocation(action)))
        text = formatter._expand_help(action) if action.help else ""
        found += nodes.definition_list_item("", term, nodes.definition("", _paragraph(text)))
    return found


def _paragraph(text: str) -> nodes.paragraph:
    """Return a paragraph with the words between backticks as code."""
    parts = enumerate(text.split("`"))
    return nodes.paragraph(
        "", "", *(nodes.literal(text=part) if i % 2 else nodes.Text(part) for i, part in parts)
    )


def _code(text: str) -> nodes.literal_block:
    return nodes.literal_block(text.strip(), text.strip(), language="text")


def places() -> dict[str, str]:
    """Module of each public name, below the package, as its stub states."""
    stub = Path(ss.__file__).with_suffix(".pyi").read_text(encoding="utf-8")
    named = re.findall(r"^from \.(\S*) import (\w+) as", stub, re.MULTILINE)
    return {name: module or name for module, name in named}


def public_names(folder: str) -> list[str]:
    """Public names of one folder: functions first, then classes, then data."""
    found = [name for name, place in places().items() if place.split(".")[0] == folder]
    return sorted(found, key=lambda name: (inspect.isclass(getattr(ss, name)), name.lower()))


def _first_line(value: object) -> str:
    """Return the first line of a docstring as a cell of a Markdown table."""
    return (inspect.getdoc(value) or "").split("\n", 1)[0].replace("``", "`").replace("|", "\\|")


class Public(SphinxDirective):
    """Documents names by autodoc; of data, the text that follows them.

    also: records that functions return, by their modules.
    """

    required_arguments = 1
    final_argument_whitespace = True
    option_spec: ClassVar = {"also": directives.unchanged}

    def run(self) -> list[nodes.Node]:
        """One entry a name."""
        names = [name for folder in self.arguments[0].split() for name in public_names(folder)]
        listed = [name for name in names if callable(getattr(ss, name))]
        rows = [
            (f"{{py:obj}}`{name} <stewart_sym.{name}>`", _first_line(getattr(ss, name))) for name in listed
        ]
        text = "".join(self._entry(name) for name in names)
        for name in self.options.get("also", "").split():
            text += f".. autoclass:: stewart_sym.{name}\n   :members:\n\n"
        summary = table(("name", "summary"), rows) if rows else ""
        return self.parse_text_to_nodes(f"{summary}```{{eval-rst}}\n{text}```\n")

    @staticmethod
    def _entry(name: str) -> str:
        value = getattr(ss, name)
        if inspect.ismodule(value):
            # Members with entries of their own would appear twice.
            own = [each for each in vars(value) if each in ss.__all__]
            excluded = f"   :exclude-members: {', '.join(own)}\n" if own else ""
            return f".. automodule:: stewart_sym.{name}\n   :members:\n{excluded}\n"
        if inspect.isclass(value):
            return f".. autoclass:: stewart_sym.{name}\n   :members:\n\n"
        if callable(value):
            return f".. autofunction:: stewart_sym.{name}\n\n"
        lines = ModuleAnalyzer.for_module(f"stewart_sym.{places()[name]}").find_attr_docs()["", name]
        text = "".join(f"   {line}\n" for line in lines)
        return f".. py:data:: {name}\n   :module: stewart_sym\n\n{text}\n"


class Machine(SphinxDirective):
    """A frame with the viewer."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """HTML that other writers leave out."""
        view = ss.view(ss.robots.dasgupta1998(), self.arguments[0])
        return [nodes.raw("", frame(view, _HEIGHT), format="html")]


def _is_alias(app: Sphinx, what: str, name: str, obj: object, skip: bool, options: object) -> bool | None:
    """Skip the fields of a named tuple, which the section Attributes describes."""
    return True if str(getattr(obj, "__doc__", "")).startswith("Alias for field number") else None


def _named_defaults(
    app: Sphinx,
    what: str,
    name: str,
    obj: object,
    options: object,
    signature: str | None,
    returned: str | None,
) -> tuple[str, str | None] | None:
    """Write functions among the defaults with their names, other objects as dots; omit private parameters."""
    if signature is None:
        return None
    named = re.sub(r"<function (\w+)>", r"\1", signature)
    return re.sub(r", _\w+(?=[,)])", "", named.replace("<factory>", "...")), returned


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives and the corrections of autodoc."""
    app.connect("autodoc-skip-member", _is_alias)
    app.connect("autodoc-process-signature", _named_defaults)
    for directive in (Statuses, Structs, Derived, Subcommands, Public, Machine):
        app.add_directive(directive.__name__.lower(), directive)
    return {"parallel_read_safe": True}
