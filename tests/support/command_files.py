"""Files of commands in tests: columns of a trajectory, an edit, what a command left."""

from pathlib import Path

from stewart_sym.io.output import RECORD

POSES = ("t_x", "t_y", "t_z", "theta_x", "theta_y", "theta_z")


def results(folder: Path) -> list[str]:
    """Names of the files in a folder but its record of them."""
    return sorted(path.name for path in folder.iterdir() if path.name != RECORD)


def edit(path: Path, old: str, new: str) -> None:
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))
