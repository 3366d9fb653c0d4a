"""Processes side by side: the files that they write are those of one process."""

import pytest

from stewart_sym.derive.generate import UNITS, derived


@pytest.mark.slow
def test_processes_side_by_side_make_what_one_makes() -> None:
    names = list(UNITS)[-2:]
    one, several = ([made for made, _ in derived(names, processes)] for processes in (1, 2))
    assert several == one
    assert all(made.files for made in one)
