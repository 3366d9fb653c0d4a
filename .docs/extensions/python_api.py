"""``{public} FOLDER ...``: the public names that modules in these folders define, by autodoc."""

import inspect
from importlib import import_module
from typing import ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.application import Sphinx
from sphinx.pycode import ModuleAnalyzer
from sphinx.util.docutils import SphinxDirective

import stewart_sym as ss


def public_names(folder: str) -> list[str]:
    """Public names of one folder: functions first, then classes, then data."""
    places = {name: place.lstrip(".") for name, place in ss._public().items()}
    found = [name for name, place in places.items() if place.split(".")[0] == folder]
    return sorted(found, key=lambda name: (inspect.isclass(getattr(ss, name)), name.lower()))


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
        text = "".join(self._entry(name) for name in names)
        for name in self.options.get("also", "").split():
            text += f".. autoclass:: stewart_sym.{name}\n   :members:\n\n"
        return self.parse_text_to_nodes(f"```{{eval-rst}}\n{text}```\n")

    @staticmethod
    def _entry(name: str) -> str:
        value = getattr(ss, name)
        if inspect.ismodule(value):
            return f".. automodule:: stewart_sym.{name}\n   :members:\n\n"
        if inspect.isclass(value):
            return f".. autoclass:: stewart_sym.{name}\n   :members:\n\n"
        if callable(value):
            return f".. autofunction:: stewart_sym.{name}\n\n"
        module = import_module(ss._public()[name], "stewart_sym").__name__
        lines = ModuleAnalyzer.for_module(module).find_attr_docs()["", name]
        text = "".join(f"   {line}\n" for line in lines)
        return f".. py:data:: {name}\n   :module: stewart_sym\n\n{text}\n"


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directive."""
    app.add_directive("public", Public)
    return {"parallel_read_safe": True}
