"""Figures of the paper's machine in cost and accuracy, and a scene in a folder."""

from pathlib import Path

import pytest
from cost_figures import SCENE, hasty
from machines import dasgupta
from quick_compiler import compile_quickly
from robot_files import scene_of

from stewart_sym.studies.accuracy.budget import papers_motions
from stewart_sym.studies.accuracy.cost import cost
from stewart_sym.studies.common.text_tables import Figures


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    """A scene on Path I, the paper's robot in a folder beside it."""
    return scene_of(SCENE, tmp_path)


@pytest.fixture(scope="session")
def found() -> Figures:
    """Figures of the paper's machine on all paths, and of other implementations."""
    with pytest.MonkeyPatch.context() as patch:
        hasty(patch)
        return cost(dasgupta(), papers_motions(), True, 1)


@pytest.fixture
def on_path_i(found: Figures) -> Figures:
    """The same on Path I alone."""
    entries = [entry | {"errors": {"I": entry["errors"]["I"]}} for entry in found["candidates"]]
    return found | {"motions": {"I": found["motions"]["I"]}, "candidates": entries}


@pytest.fixture
def quickly(monkeypatch: pytest.MonkeyPatch) -> None:
    """Kernels whose speed does not matter."""
    compile_quickly(monkeypatch)
