"""How far sweeps of random cases go: part of their size, or what counting needs; all with STEWART_FULL=1."""

import os
from collections.abc import Callable, Container, Iterable
from typing import Any

import pytest

FULL = os.environ.get("STEWART_FULL") == "1"

sweep = pytest.mark.slow if FULL else pytest.mark.sweep
"""Mark of a test that is quick with its share of cases, and slow with all."""


def slow_but(
    fast: Container[Any], cases: Iterable[Any], key: Callable[[Any], Any] = lambda case: case
) -> list[Any]:
    """Cases as parameters, slow but for those whose key is among the fast; of a tuple each is one."""
    marks = {True: (), False: pytest.mark.slow}
    listed = [(case, case if isinstance(case, tuple) else (case,)) for case in cases]
    return [pytest.param(*values, marks=marks[key(case) in fast]) for case, values in listed]


def share(count: int, part: int = 20) -> int:
    """How many of ``count`` cases are run: all of them, or one in ``part``."""
    return count if FULL else count // part
