"""Puts a kit into a folder: all files or none, and none that somebody changed by hand."""

from collections.abc import Iterable
from pathlib import Path

from ..io.atomic_write import digest, must_replace, recorded, staged_folder
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
    """Write the C kit of ``robot`` into ``directory``, made if missing, and return it and its files.

    The same robot, choice and version give the same bytes. Raises ValueError of one line: an unknown option,
    a robot without a pose for the self-test, and as ``put``.
    """
    made = kit(robot, choice, progress)
    return made, put(made, directory, force, inputs)


def put(made: Kit, directory: Path, force: bool = False, inputs: Iterable[Path] = ()) -> list[Path]:
    """Put the files of a kit into ``directory``, made if missing, and return them.

    Files that are there already and equal stay as they are. Files of an older kit there, by its
    manifest, are replaced, and removed where the new kit has none of their name, unless somebody changed them
    since: then, as for files of other origin, only ``force`` replaces or removes them, for a header or a
    source of an older kit beside this one would be compiled with it. Further files are left alone, and
    ``inputs`` are never replaced. When anything fails the folder is as it was before.

    Raises ValueError of one line: a file that would be overwritten, a folder that cannot be written.
    """
    try:
        ours = dict(recorded(directory, MANIFEST))
        if ours:
            ours[MANIFEST] = str(digest(directory / MANIFEST))
        changed = [
            name
            for name, content in made.files.items()
            if must_replace(directory, name, content, ours, force, inputs)
        ]
        gone = [name for name in ours if name not in made.files and (directory / name).is_file()]
        for name in gone:
            path = directory / name
            if any(each.exists() and path.samefile(each) for each in inputs):
                raise ValueError(f"{path}: is an input, name another folder")
            if not force and digest(path) != ours[name]:
                raise ValueError(
                    f"{path}: was edited and is not part of this kit; use --force to remove it, or rename it"
                )
        if changed or gone:
            with staged_folder(directory, [Path(name) for name in gone]) as folder:
                for name in changed:
                    (folder / name).parent.mkdir(exist_ok=True)
                    (folder / name).write_bytes(made.files[name])
    except OSError as error:
        reason = error.strerror or str(error)
        raise ValueError(f"{error.filename or directory}: {reason}") from error
    return [directory / name for name in made.files]
