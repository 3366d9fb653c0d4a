"""Unclear constructions in texts do not become more frequent, by the rates of ``LIMITS``."""

from collections.abc import Callable, Iterable, Iterator
from itertools import chain
from pathlib import Path

import pytest
from pages import PAGES, TOP
from prose import code_passages, count_findings, module_texts, page_passages, rates

from stewart_sym.cli import main

ALWAYS = {
    "headless clause": 0.1,
    "that of": 0.1,
    "opening with of": 0.05,
    "beside": 0.05,
    "unclear word": 0.2,
    "where for if": 0.2,
    "British spelling": 0.0,
}
LIMITS: dict[str, dict[str, float]] = {
    "pages": ALWAYS | {"that of": 0.2, "long sentence": 1.0},
    "docstrings and comments": ALWAYS | {"long sentence": 1.0},
    "messages": ALWAYS | {"long sentence": 0.5},
    "help": ALWAYS | {"long sentence": 1.1},
}
"""Largest number of findings per 1000 words. Lower a limit when a text improves; never raise one."""

UNREVISED = (*("derive/kernel", "stewart_sym/motion"),)
"""Folders whose docstrings and comments are not revised yet. Remove a folder when its text is."""


def modules() -> list[Path]:
    """Return the modules of the library and of the derivation."""
    return [*TOP.glob("stewart_sym/**/*.py"), *TOP.glob("derive/**/*.py")]


def revised() -> list[Path]:
    """Return the modules without the folders of ``UNREVISED``."""
    folders = [TOP / folder for folder in UNREVISED]
    return [module for module in modules() if not any(module.is_relative_to(each) for each in folders)]


def help_texts() -> Iterator[str]:
    """Yield descriptions and option texts of all subcommands."""
    for parser in map(main.subcommand_parser, main.SUBCOMMANDS):
        yield parser.description or ""
        yield from (action.help or "" for action in parser._actions)


TEXTS: dict[str, Callable[[], Iterable[str]]] = {
    "pages": lambda: chain.from_iterable(page_passages(TOP / page) for page in PAGES),
    "docstrings and comments": lambda: chain.from_iterable(map(code_passages, revised())),
    "messages": lambda: chain.from_iterable(module_texts(module).messages for module in modules()),
    "help": help_texts,
}


def excess(pieces: Iterable[str], limits: dict[str, float]) -> list[str]:
    """Return a line for each rate above its limit."""
    found = rates(count_findings(pieces))
    assert found.keys() == limits.keys()
    return [f"{rule}: {found[rule]:.2f} > {limit}" for rule, limit in limits.items() if found[rule] > limit]


@pytest.mark.parametrize("kind", TEXTS)
def test_rates_are_within_their_limits(kind: str) -> None:
    assert excess(TEXTS[kind](), LIMITS[kind]) == []


@pytest.mark.parametrize(
    ("rule", "sentence"),
    {
        "headless clause": "The report lists what a motion takes.",
        "that of": "The first mass is that of a leg.",
        "opening with of": "Of the legs only one moves.",
        "beside": "The file has a table beside the text.",
        "unclear word": "The file says the unit.",
        "where for if": "It returns NaN where not known.",
        "British spelling": "The colour of the centre is grey.",
        "long sentence": "word " * 31 + "end.",
    }.items(),
)
def test_one_bad_sentence_in_a_short_text_exceeds_the_limits(rule: str, sentence: str) -> None:
    good = "The platform has six legs. Each leg has two parts. Compute the forces with one call. " * 5
    for limits in LIMITS.values():
        assert excess([good], limits) == []
        assert [line for line in excess([good, sentence], limits) if line.startswith(rule)]
        assert not [line for line in excess([good, sentence], limits) if not line.startswith(rule)]


def test_code_links_and_questions_are_not_judged() -> None:
    clean = ["Call `what_of(beside)`.", "See [the page](what-it-says.md).", "What is a leg?"]
    assert set(rates(count_findings(clean)).values()) == {0.0}


def test_docstrings_comments_and_messages_of_a_module_are_found(tmp_path: Path) -> None:
    module = tmp_path / "module.py"
    module.write_text(
        '"""One."""\n\nTWO = """\n# text\n"""\n\n\ndef three(value):\n    """Four."""\n'
        '    # Five\n    # six.\n    if value == "# seven":\n        raise ValueError(f"eight: {value}")\n'
        "    return value  # nine  # noqa: E501\n"
    )
    texts = module_texts(module)
    assert texts.docstrings == ["One.", "Four."]
    assert texts.comments[0] == "Five six."
    assert len(texts.comments) == 2
    assert texts.messages == ["eight: X"]
