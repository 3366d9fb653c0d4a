"""Puts a kit into a folder: all files or none, and none that somebody changed by hand.

Stands above ``files``; what a manifest says of the files there tells ours from edited ones.
"""

import hashlib
import json
import os
from collections.abc import Mapping
from pathlib import Path

from ..publish import staged_folder
from ..robot import Robot
from .choice import DEFAULT, Choice
from .files import MANIFEST, Kit, kit


def write_kit(
    robot: Robot, directory: Path, choice: Choice = DEFAULT, force: bool = False
) -> tuple[Kit, list[Path]]:
    """Write the C kit of ``robot`` into ``directory``, made if missing, and return it and its files.

    The same robot, choice and version give the same bytes. Raises ValueError of one line: an unknown option,
    a robot without a pose for the self-test, and as ``put``.
    """
    made = kit(robot, choice)
    return made, put(made, directory, force)


def put(made: Kit, directory: Path, force: bool = False) -> list[Path]:
    """Put the files of a kit into ``directory``, made if missing, and return them.

    Files that are there already and equal stay as they are. Files of an older kit there, as its manifest
    tells, are replaced, and removed where the new kit has none of their name, unless somebody changed them
    since: then, as for files of other origin, only ``force`` replaces them. Further files are left alone.
    When anything fails the folder is as it was before.

    Raises ValueError of one line: a file that would be overwritten, a folder that cannot be written.
    """
    try:
        ours = _manifest(directory)
        changed = [
            name for name, content in made.files.items() if _differs(directory / name, content, ours, force)
        ]
        gone = [
            name
            for name, digest in ours.items()
            if name not in made.files and _digest(directory / name) == digest
        ]
        if changed or gone:
            with staged_folder(directory, [Path(name) for name in gone]) as folder:
                for name in changed:
                    (folder / name).write_bytes(made.files[name])
    except OSError as error:
        reason = error.strerror or str(error)
        raise ValueError(f"{error.filename or directory}: {reason}") from error
    return [directory / name for name in made.files]


def _manifest(directory: Path) -> Mapping[str, str]:
    """Digests of the files of the kit in a folder, as its manifest tells, its own included; empty without."""
    path = directory / MANIFEST
    if not path.is_file():
        return {}
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
        own = str(found["generator"]).startswith("stewart-sym ")
        files = {str(name): str(digest) for name, digest in found["files"].items()}
    except (ValueError, KeyError, TypeError, AttributeError):
        return {}
    inside = all(Path(name).name == name for name in files)
    return files | {MANIFEST: str(_digest(path))} if own and inside else {}


def _digest(path: Path) -> str | None:
    """SHA-256 of a file's content, None of what is no file."""
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else None


def _differs(path: Path, content: bytes, ours: Mapping[str, str], force: bool) -> bool:
    """Whether the file has to be written. ValueError if that takes ``force`` or is out of the question."""
    if not os.path.lexists(path):
        return True
    if path.is_dir():
        raise ValueError(f"{path}: expected a file or nothing, found a folder")
    if path.exists() and path.read_bytes() == content:
        return False
    if not force and _digest(path) != ours.get(path.name, ""):
        raise ValueError(f"{path}: exists with other content; use --force to overwrite")
    return True
