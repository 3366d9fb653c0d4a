"""Robot files: the paper's, which comes with the package, and one of any robot."""

import shutil
from pathlib import Path

import stewart_sym as ss
from stewart_sym.derive.package.robot import robot_toml

PAPERS = Path(ss.robots.__file__).parent / "dasgupta1998.toml"


def written(robot: ss.Robot, path: Path) -> Path:
    """The robot as a file that can be read."""
    path.write_text(robot_toml(robot.to_dict(), ""), encoding="utf-8")
    return path


def scene_of(text: str, folder: Path) -> Path:
    """A scene or budget as a file, the paper's robot in a folder beside it."""
    (folder / "robots").mkdir()
    shutil.copy(PAPERS, folder / "robots" / "robot.toml")
    path = folder / "scene.toml"
    path.write_text(text, encoding="utf-8")
    return path
