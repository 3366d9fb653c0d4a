"""Files of a package's folder ``templates``: text that never varies, and words in it that do."""

from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from string import Template


@cache
def _template(package: str, name: str) -> Template:
    return Template((files(package) / "templates" / f"{name}.in").read_text(encoding="utf-8"))


def filled_from(package: str, name: str, words: Mapping[str, object]) -> str:
    """A file of ``templates`` of a package, its name without ``.in``, with each ``$word`` replaced."""
    return _template(package, name).substitute({key: str(word) for key, word in words.items()})


def filled(name: str, /, **words: object) -> str:
    """The same of this package."""
    return filled_from(__package__, name, words)
