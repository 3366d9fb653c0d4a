"""``{statuses}`` and ``{structs}``: tables of the C interface, from the table that writes the headers."""

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from stewart_sym.derive.kernel.interface import STRUCTS
from stewart_sym.derive.kernel.tree.constants import STATUSES
from stewart_sym.studies.common.output import table


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


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives."""
    app.add_directive("statuses", Statuses)
    app.add_directive("structs", Structs)
    return {"parallel_read_safe": True}
