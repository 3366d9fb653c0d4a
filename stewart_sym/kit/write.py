"""Writing of a kit into a folder: all files or none, without replacing edited files."""

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
    kit would be compiled with the new kit. Other files remain, and ``inputs`` are never replaced. After an
    error the folder is unchanged.

    Raises ValueError if a file would be overwritten or the folder cannot be written.
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
                raise ValueError(f"{path}: is an input; name another folder")
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
