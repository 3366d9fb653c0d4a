"""Former names of subcommands, options, and values are errors that name the present ones."""

import argparse

import pytest
from command_line import Fails, Run

from stewart_sym.cli import main as cli
from stewart_sym.cli import renamed

(ACTION,) = (each for each in cli._parser()._actions if isinstance(each, argparse._SubParsersAction))
PARSERS: dict[str, argparse.ArgumentParser] = dict(ACTION.choices)


def subcommands_with(option: str) -> list[str]:
    return [name for name, parser in PARSERS.items() if option in parser._option_string_actions]


@pytest.mark.parametrize(("old", "new"), renamed.SUBCOMMANDS.items())
def test_a_former_subcommand_is_one_line_with_the_present_one(old: str, new: str, fails: Fails) -> None:
    assert new in PARSERS
    assert old not in PARSERS
    expected = f"stewart-sym: error: {old}: renamed; use {new} (see stewart-sym --help)"
    assert fails(old, "robot.toml") == expected


@pytest.mark.parametrize(("old", "new"), renamed.OPTIONS.items())
def test_a_former_option_is_one_line_with_the_present_one(old: str, new: str, fails: Fails) -> None:
    assert not subcommands_with(old)
    names = subcommands_with(new.partition(" ")[0])
    assert names
    for name in names:
        for words in ([old, "1"], [f"{old}=1"]):
            expected = f"stewart-sym: error: {old}: renamed; use {new} (see stewart-sym {name} --help)"
            assert fails(name, *words, "robot.toml") == expected


@pytest.mark.parametrize(("old", "new"), renamed.VALUES.items())
def test_a_former_value_is_one_line_with_the_present_one(old: str, new: str, fails: Fails) -> None:
    found = [
        (name, option)
        for name, parser in PARSERS.items()
        for option, action in parser._option_string_actions.items()
        if action.choices and new in action.choices
    ]
    assert found
    for name, option in found:
        expected = f"stewart-sym: error: {option} {old}: renamed; use {new} (see stewart-sym {name} --help)"
        assert fails(name, "file.toml", option, old) == expected


def test_an_option_of_another_subcommand_is_unknown(fails: Fails) -> None:
    assert "unrecognized arguments: --box" in fails("check", "robot.toml", "--box", "1")


def test_the_help_lists_every_subcommand_once_in_its_group(run: Run) -> None:
    lines = run("--help").out.splitlines()
    for title, names in cli.GROUPS.items():
        assert f"  {title}:" in lines
        for name in names:
            assert len([line for line in lines if line.startswith(f"    {name} ")]) == 1, name


@pytest.mark.parametrize("name", cli.SUBCOMMANDS)
def test_a_description_has_at_most_sixty_words(name: str) -> None:
    description = PARSERS[name].description
    assert description is not None
    first, *_ = description.splitlines()
    assert len(first.split()) <= 20
    assert len(description.split()) <= 60


@pytest.mark.parametrize("name", cli.SUBCOMMANDS)
def test_every_option_has_a_help_without_a_period(name: str) -> None:
    for action in PARSERS[name]._actions:
        assert action.help
        assert not action.help.endswith(".")
