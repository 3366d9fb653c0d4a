"""Templates: files in the folder ``templates`` of a package, with fixed text and variable words."""

from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from string import Template


@cache
def _template(package: str, name: str) -> Template:
    return Template((files(package) / "templates" / f"{name}.in").read_text(encoding="utf-8"))


def filled_from(package: str, name: str, words: Mapping[str, object]) -> str:
    """Return a file of ``templates`` of a package with each ``$word`` replaced; omit ``.in`` in ``name``."""
    return _template(package, name).substitute({key: str(word) for key, word in words.items()})


def filled(name: str, /, **words: object) -> str:
    """Return a template of this package with each ``$word`` replaced."""
    return filled_from(__package__, name, words)
