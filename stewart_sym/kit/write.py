"""Writing of a kit into a folder, file by file, without replacing edited files."""

import contextlib
from collections.abc import Iterable
from pathlib import Path

from ..io.output import digest, must_be_replaceable, recorded, write_file
from ..io.progress import Progress, silent
from ..robot.robot import Robot
from .files import MANIFEST, Kit, kit
from .kit_options import DEFAULT, Choice


def write_kit(
    robot: Robot,
    directory: Path,
    choice: Choice = DEFAULT,
    force: bool = False,
    inputs: Iterable[Path] = (),
    progress: Progress = silent,
) -> tuple[Kit, list[Path]]:
    """Write the kit of ``robot`` into ``directory``, which is created if missing; return the kit and its
    paths.

    Equal robots, options, and versions give identical bytes. Raises ValueError for an unknown option, for a
    robot without a pose for the self-test, and the errors of ``put``.
    """
    made = kit(robot, choice, progress)
    return made, put(made, directory, force, inputs)


def put(made: Kit, directory: Path, force: bool = False, inputs: Iterable[Path] = ()) -> list[Path]:
    """Write the files of a kit into ``directory``, which is created if missing; return their paths.

    Existing files with equal content are not touched. Files of an older kit, recognized by its manifest, are
    replaced, or removed if the new kit has no file of that name. Edited files and files of other origin are
    replaced or removed only with ``force``. Otherwise they are errors, because a header or source of an older
    kit would be compiled with the new kit. Other files remain, and ``inputs`` are never replaced. All files
    are checked before the first one is written.

    Raises ValueError if a file would be overwritten, and OSError if the folder cannot be written.
    """
    ours = recorded(directory / MANIFEST)
    if ours:
        ours[MANIFEST] = str(digest(directory / MANIFEST))
    changed = {name: content for name, content in made.files.items() if not _is(directory / name, content)}
    inside = directory.resolve()
    old = [directory / name for name in ours.keys() - made.files]
    gone = [path for path in old if path.is_file() and path.resolve().is_relative_to(inside)]
    for path in [*(directory / name for name in changed), *gone]:
        is_ours = digest(path) == ours.get(path.relative_to(directory).as_posix(), "")
        must_be_replaceable(path, is_ours, force, inputs)
    # The manifest is the last file, so that it lists no file of an unfinished kit.
    for name in sorted(changed, key=MANIFEST.__eq__):
        write_file(directory / name, changed[name])
    for path in gone:
        path.unlink()
        with contextlib.suppress(OSError):
            path.parent.rmdir()
    return [directory / name for name in made.files]


def _is(path: Path, content: bytes) -> bool:
    """Return True if a file has this content."""
    return path.is_file() and path.read_bytes() == content
