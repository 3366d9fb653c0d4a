"""Unclear constructions in texts do not become more frequent, by the rates of ``LIMITS``."""

import argparse
from collections.abc import Callable, Iterable, Iterator
from itertools import chain
from pathlib import Path

import pytest
from pages import PAGES, TOP
from prose import code_passages, count_findings, module_texts, page_passages, rates

from stewart_sym.cli import main

LIMITS: dict[str, dict[str, float]] = {
    "pages": {
        "headless clause": 2.34,
        "that of": 1.43,
        "opening with of": 0.37,
        "beside": 0.52,
        "unclear word": 2.27,
        "where for if": 1.69,
        "British spelling": 0.04,
        "long sentence": 3.22,
    },
    "docstrings and comments": {
        "headless clause": 9.02,
        "that of": 3.65,
        "opening with of": 0.91,
        "beside": 1.20,
        "unclear word": 3.18,
        "where for if": 3.31,
        "British spelling": 0.00,
        "long sentence": 2.77,
    },
    "messages": {
        "headless clause": 0.54,
        "that of": 0.72,
        "opening with of": 0.00,
        "beside": 0.36,
        "unclear word": 0.72,
        "where for if": 0.00,
        "British spelling": 0.00,
        "long sentence": 0.72,
    },
    "help": {
        "headless clause": 0.00,
        "that of": 0.26,
        "opening with of": 0.00,
        "beside": 0.00,
        "unclear word": 0.00,
        "where for if": 0.00,
        "British spelling": 0.00,
        "long sentence": 1.02,
    },
}
"""Largest number of findings per 1000 words. Lower a limit when a text improves; never raise one."""


def modules() -> list[Path]:
    """Return the modules of the library and of the derivation."""
    return [*TOP.glob("stewart_sym/**/*.py"), *TOP.glob("derive/**/*.py")]


def help_texts() -> Iterator[str]:
    """Yield descriptions and option texts of all subcommands."""
    (subcommands,) = (
        action for action in main._parser()._actions if isinstance(action, argparse._SubParsersAction)
    )
    for parser in subcommands.choices.values():
        yield parser.description or ""
        yield from (action.help or "" for action in parser._actions)


TEXTS: dict[str, Callable[[], Iterable[str]]] = {
    "pages": lambda: chain.from_iterable(page_passages(TOP / page) for page in PAGES),
    "docstrings and comments": lambda: chain.from_iterable(map(code_passages, modules())),
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
