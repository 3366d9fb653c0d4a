"""``{machine} PATH``: the paper's machine on one of its paths, as ``stewart-sym view`` shows it."""

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

import stewart_sym as ss
from stewart_sym.viewer.view import frame

_HEIGHT = 780


class Machine(SphinxDirective):
    """A frame with the viewer."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """HTML that other writers leave out."""
        view = ss.view(ss.robots.dasgupta1998(), self.arguments[0])
        return [nodes.raw("", frame(view, _HEIGHT), format="html")]


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directive."""
    app.add_directive("machine", Machine)
    return {"parallel_read_safe": True}
