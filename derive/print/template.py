"""Files of ``templates``: C that never varies, and words in it that do."""

from importlib.resources import files
from string import Template


def filled(name: str, /, **words: object) -> str:
    """A file of ``templates``, its name without ``.in``, with each ``$word`` replaced."""
    text = (files(__package__) / "templates" / f"{name}.in").read_text(encoding="utf-8")
    return Template(text).substitute({key: str(word) for key, word in words.items()})
