"""Former names of subcommands, options, and values are errors that name the present ones."""

import pytest
from command_line import Fails, Run

from stewart_sym.cli import main as cli
from stewart_sym.cli import renamed

PARSERS = {name: cli.subcommand_parser(name) for name in cli.SUBCOMMANDS}


def subcommands_with(option: str) -> list[str]:
    return [name for name, parser in PARSERS.items() if option in parser._option_string_actions]


@pytest.mark.parametrize(("old", "new"), renamed.SUBCOMMANDS.items())
def test_a_former_subcommand_is_one_line_with_the_present_one(old: str, new: str, fails: Fails) -> None:
    assert new in PARSERS
    assert old not in PARSERS
    assert f" {old}: renamed; use {new} (see stewart-sym --help)" in fails(old, "robot.toml")


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
        told = fails(name, "file.toml", option, old)
        assert told.endswith(f"{option}: {old}: renamed; use {new} (see stewart-sym {name} --help)")


def test_an_option_of_another_subcommand_is_unknown(fails: Fails) -> None:
    assert "unrecognized arguments: --box" in fails("check", "robot.toml", "--box", "1")


def test_the_help_lists_every_subcommand_once_in_its_group(run: Run) -> None:
    lines = run("--help").out.splitlines()
    for title, names in cli.GROUPS.items():
        assert f"  {title}:" in lines
        for name in names:
            assert len([line for line in lines if line.startswith(f"    {name} ")]) == 1, name
