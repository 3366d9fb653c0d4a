"""Former names of subcommands and options are errors that name the present ones."""

from command_line import Fails, Run

from stewart_sym.cli import main as cli
from stewart_sym.cli import renamed

PARSERS = {name: cli.subcommand_parser(name) for name in cli.SUBCOMMANDS}


def test_a_former_subcommand_is_one_line_with_the_present_one(fails: Fails) -> None:
    for old, new in renamed.SUBCOMMANDS.items():
        assert new in PARSERS
        assert f" {old}: renamed; use {new} (see stewart-sym --help)" in fails(old, "robot.toml")


def test_a_former_option_is_one_line_with_the_present_one(fails: Fails) -> None:
    for old, new in renamed.OPTIONS.items():
        options = {name: parser._option_string_actions for name, parser in PARSERS.items()}
        assert not [name for name in options if old in options[name]]
        names = [name for name in options if new.partition(" ")[0] in options[name]]
        assert names
        for name in names:
            expected = f"stewart-sym: error: {old}: renamed; use {new} (see stewart-sym {name} --help)"
            assert fails(name, f"{old}=1", "robot.toml") == expected
    assert "unrecognized arguments: --box" in fails("check", "robot.toml", "--box", "1")


def test_the_help_lists_every_subcommand_once_in_its_group(run: Run) -> None:
    lines = run("--help").out.splitlines()
    for title, names in cli.GROUPS.items():
        assert f"  {title}:" in lines
        for name in names:
            assert len([line for line in lines if line.startswith(f"    {name} ")]) == 1, name
