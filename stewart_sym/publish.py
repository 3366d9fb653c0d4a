"""Writing so that a failure leaves things as they were: one file, or a folder's files all together.

The one publisher of every command that writes. Stands at the bottom; knows nothing of what is written.
"""

import contextlib
import os
import shutil
import sys
import tempfile
from collections.abc import Iterable, Iterator
from errno import EISDIR, ENOTDIR
from pathlib import Path
from typing import TextIO


@contextlib.contextmanager
def replaced_file(path: Path) -> Iterator[TextIO]:
    """Open a text file that takes the place of ``path`` only when the block ends well; ``-`` is stdout.

    A device or a pipe is written as it is. Raises OSError naming ``path``: before the block when it can't be
    written, and for what goes wrong in writing.
    """
    if str(path) == "-":
        with named("standard output"):
            yield sys.stdout
            sys.stdout.flush()
        return
    target = path.resolve()
    if target.is_dir():
        raise IsADirectoryError(EISDIR, "is a folder, expected a file to write", str(path))
    if target.exists() and not target.is_file():
        with named(path), open(target, "w", encoding="utf-8") as stream:
            yield stream
        return
    temporary = target.with_name(f".{target.name}.{os.getpid()}.part")
    with _blamed_on(path):
        temporary.touch(exist_ok=False)
    try:
        with named(path), open(temporary, "w", encoding="utf-8", newline="\n") as stream:
            yield stream
        with _blamed_on(path):
            os.replace(temporary, target)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise


@contextlib.contextmanager
def staged_folder(directory: Path, gone: Iterable[Path] = ()) -> Iterator[Path]:
    """Give an empty folder whose files move into ``directory``, made if missing, when the block ends well.

    Files of the same names are replaced, those of the names ``gone`` are removed, others stay. All that
    happens or, whatever goes wrong, nothing: if a file can't be moved, or on an interrupt, those that were
    are put back. Raises OSError naming ``directory`` before the block when it can't be written, and the file
    or folder that is in the way.
    """
    target = directory.resolve()
    place = target
    while not os.path.lexists(place):
        place = place.parent
    if not place.is_dir():
        raise NotADirectoryError(ENOTDIR, f"expected a folder, but {place} is none", str(directory))
    with _blamed_on(directory):
        # Inside, as a folder may be a mount point or stand in one that is closed to us.
        temporary = Path(tempfile.mkdtemp(prefix=".stewart-sym-", dir=place))
    try:
        staged, replaced = temporary / "new", temporary / "old"
        staged.mkdir()
        replaced.mkdir()
        with named(directory):
            yield staged
        _move_all(staged, target, replaced, gone)
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


def _move_all(staged: Path, target: Path, replaced: Path, gone: Iterable[Path]) -> None:
    """Move the staged files to ``target``, those in their places and ``gone`` to ``replaced``, or none."""
    files = [path.relative_to(staged) for path in sorted(staged.rglob("*")) if path.is_file()]
    with contextlib.ExitStack() as undo:
        for folder in sorted({target, *((target / file).parent for file in files)}):
            _make_folder(folder, undo)
        for number, file in enumerate(files):
            _move(staged / file, target / file, replaced / str(number), undo)
        for number, file in enumerate(gone, len(files)):
            _take_away(target / file, replaced / str(number), undo)
        undo.pop_all()


# What undoes a step is registered before the step, since an interrupt can come between any two.


def _make_folder(folder: Path, undo: contextlib.ExitStack) -> None:
    missing = []
    while not os.path.lexists(folder):
        missing.append(folder)
        folder = folder.parent
    if not folder.is_dir():
        raise NotADirectoryError(ENOTDIR, "is in the way, expected a folder", str(folder))
    for path in reversed(missing):
        undo.callback(_remove_empty, path)
        path.mkdir(exist_ok=True)


def _remove_empty(folder: Path) -> None:
    with contextlib.suppress(OSError):
        folder.rmdir()


def _move(new: Path, path: Path, old: Path, undo: contextlib.ExitStack) -> None:
    if path.is_dir():
        raise IsADirectoryError(EISDIR, "is a folder, expected a file to replace", str(path))
    undo.callback(_put_back, path, old, new)
    with _blamed_on(path):
        if os.path.lexists(path):
            path.rename(old)
        new.rename(path)


def _take_away(path: Path, old: Path, undo: contextlib.ExitStack) -> None:
    undo.callback(_put_back, path, old, path)
    with _blamed_on(path):
        path.rename(old)


def _put_back(path: Path, old: Path, new: Path) -> None:
    if os.path.lexists(old):
        old.replace(path)
    elif not os.path.lexists(new):
        path.unlink()


@contextlib.contextmanager
def named(path: Path | str) -> Iterator[None]:
    """Let an OSError that names no file, as of a full disk, name ``path``."""
    try:
        yield
    except OSError as error:
        if error.filename is not None or error.errno is None:
            raise
        raise OSError(error.errno, error.strerror, str(path)) from error


@contextlib.contextmanager
def _blamed_on(path: Path) -> Iterator[None]:
    """Let an OSError name what the user asked for instead of a temporary file beside it."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, f"can't write here: {error.strerror}", str(path)) from None
