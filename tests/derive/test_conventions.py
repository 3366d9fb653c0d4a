"""The page of conventions names what users give and get."""

import dataclasses
from pathlib import Path

import stewart_sym as ss

REPOSITORY = Path(__file__).parents[2]
PAGE = REPOSITORY / ".docs" / "conventions.md"


def test_the_page_names_every_part_of_a_motion_and_every_reaction() -> None:
    page = PAGE.read_text(encoding="utf-8")
    fields = [
        field.name for of in (ss.Motion, ss.results.JointReactionsResult) for field in dataclasses.fields(of)
    ]
    assert not [name for name in fields if f"`{name}`" not in page and name not in ("status", "F_c")]
