"""A kit for build tools: its robot file, its texts, and running the tools."""

import shutil
import subprocess
from pathlib import Path

import pytest

from stewart_sym.kit import Choice, kit
from stewart_sym.robot.robot import Robot

CLIENT = Path(__file__).parents[1] / "client"
ROBOT = CLIENT / "hexapod.toml"
SYMBOL = "stewart_robot_client_hexapod"
QUICK = "-DCMAKE_BUILD_TYPE=Debug"


def run(*command: object, cwd: Path | None = None, code: int = 0) -> str:
    """What a command printed; it must end with the code."""
    done = subprocess.run(
        [str(word) for word in command], cwd=cwd, capture_output=True, text=True, check=False
    )
    assert done.returncode == code, done.stdout + done.stderr
    return done.stdout + done.stderr


def needed(*tools: str) -> None:
    for tool in tools:
        if shutil.which(tool) is None:
            pytest.skip(f"{tool} is not installed")


def texts(robot: Robot, choice: Choice) -> dict[str, str]:
    """A kit, file name -> text."""
    return {name: content.decode() for name, content in kit(robot, choice).files.items()}


def written(files: dict[str, str], folder: Path) -> Path:
    folder.mkdir(exist_ok=True)
    for name, text in files.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return folder
