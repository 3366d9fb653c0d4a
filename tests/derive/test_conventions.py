"""The page of conventions names what users give and get, and is linked."""

import dataclasses
from pathlib import Path

from command_line import Run

import stewart_sym as ss

REPOSITORY = Path(__file__).parents[2]
PAGE = REPOSITORY / ".docs" / "conventions.md"


def test_the_page_names_every_part_of_a_motion_and_every_reaction() -> None:
    page = PAGE.read_text(encoding="utf-8")
    fields = [
        field.name for of in (ss.Motion, ss.results.JointReactionsResult) for field in dataclasses.fields(of)
    ]
    assert not [name for name in fields if f"`{name}`" not in page and name not in ("status", "F_c")]


def test_the_page_is_linked_where_a_new_user_looks(run: Run) -> None:
    places = [
        (REPOSITORY / "README.md").read_text(encoding="utf-8"),
        (REPOSITORY / "derive" / "derivation.ipynb").read_text(encoding="utf-8"),
        run("check", "--help").out.replace("\n", " "),
    ]
    assert all(".docs/conventions.md" in place for place in places)
