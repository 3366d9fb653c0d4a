"""Robot files: the paper's, which comes with the package, and one of any robot."""

import dataclasses
import shutil
from pathlib import Path

import numpy as np

import stewart_sym as ss
from stewart_sym.io.toml_text import toml_text

PAPERS = Path(ss.robots.__file__).parent / "dasgupta1998.toml"


def written(robot: ss.Robot, path: Path) -> Path:
    """The robot as a file that can be read."""
    path.write_text(toml_text(robot.to_dict(), inline=False), encoding="utf-8")
    return path


def same(one: ss.Robot, other: ss.Robot) -> bool:
    """Whether two robots agree to the last bit."""
    return all(
        np.array_equal(getattr(one, each.name), getattr(other, each.name)) for each in dataclasses.fields(one)
    )


def scene_of(text: str, folder: Path) -> Path:
    """A scene or budget as a file, the paper's robot in a folder beside it."""
    (folder / "robots").mkdir()
    shutil.copy(PAPERS, folder / "robots" / "robot.toml")
    path = folder / "scene.toml"
    path.write_text(text, encoding="utf-8")
    return path
