"""Libraries compiled in a quarter of the time, for tests in which their speed does not matter."""

import pytest

from stewart_sym.backend import native


def compile_quickly(patch: pytest.MonkeyPatch) -> None:
    """Libraries that are not loaded yet are compiled at -O0: the same bits."""
    load = native.load
    if load.__module__ == __name__:
        return
    patch.setattr(
        native,
        "load",
        lambda name, sources, flags=(), defines=None: load(name, sources, (*flags, "-O0"), defines),
    )
