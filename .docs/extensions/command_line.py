"""``{subcommands}``: a section for each subcommand, from its argparse parser."""

import argparse

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from stewart_sym.cli import main


def parsers() -> dict[str, argparse.ArgumentParser]:
    """Parser of each subcommand."""
    (found,) = (each for each in main._parser()._actions if isinstance(each, argparse._SubParsersAction))
    return dict(found.choices)


class Subcommands(SphinxDirective):
    """Usage, description, options and example of every subcommand."""

    def run(self) -> list[nodes.Node]:
        """One section a subcommand."""
        return [self._section(name, parser) for name, parser in parsers().items()]

    def _section(self, name: str, parser: argparse.ArgumentParser) -> nodes.section:
        section = nodes.section("", nodes.title(text=name), ids=[nodes.make_id(f"stewart-sym-{name}")])
        section += nodes.paragraph(text=parser.description)
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
        found += nodes.definition_list_item("", term, nodes.definition("", nodes.paragraph(text=text)))
    return found


def _code(text: str) -> nodes.literal_block:
    return nodes.literal_block(text.strip(), text.strip(), language="text")


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directive."""
    app.add_directive("subcommands", Subcommands)
    return {"parallel_read_safe": True}
