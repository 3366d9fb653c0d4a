"""Atomic writing of one file, or of all files of a folder.

A file in a folder is replaced only if a record in the folder shows that this program wrote it and that it is
unchanged. A single file has no record; its first lines identify its generator.
"""

import contextlib
import hashlib
import json
import os
import re
import shutil
import stat
import sys
import tempfile
import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from errno import EISDIR, ENOTDIR
from importlib.metadata import version
from pathlib import Path
from typing import TextIO

from . import interrupts
from .json_text import json_text

RECORD = ".stewart-sym.json"
"""Record of the names and SHA-256 digests of the files that this program wrote into a folder."""

_PREFIX = ".stewart-sym-"
_TEMPORARY = re.compile(re.escape(_PREFIX) + "[a-z0-9_]{8}")
_OTHERS = "exists with other content; use --force to overwrite"
# The process that creates a temporary file locks it within this time.
_UNLOCKED_SECONDS = 60.0


@contextlib.contextmanager
def replaced_file(path: Path) -> Iterator[TextIO]:
    """Open a text file that replaces ``path`` only if the block ends without an error; ``-`` is standard
    output.

    A device or a pipe is written directly at the end of the block. Raises OSError with the name ``path``:
    before the block if the file cannot be written, and for errors during writing.
    """
    if str(path) == "-":
        with named("standard output"), _spooled(sys.stdout) as stream:
            yield stream
        return
    if path.is_dir():
        raise IsADirectoryError(EISDIR, "is a folder, expected a file to write", str(path))
    # The path is not resolved, because /dev/stdout and a shell's >(...) refer to pipes without another name.
    if path.exists() and not path.is_file():
        with named(path), open(path, "w", encoding="utf-8") as out, _spooled(out) as stream:
            yield stream
        return
    target = path.resolve()
    with interrupts.deferred():
        _remove_left_behind(target.parent)
        with _blamed_on(path):
            descriptor, name = tempfile.mkstemp(prefix=_PREFIX, dir=target.parent)
        temporary = Path(name)
        try:
            with _locked(temporary):
                with (
                    interrupts.deferred(False),
                    named(path),
                    open(descriptor, "w", encoding="utf-8", newline="\n") as stream,
                ):
                    yield stream
                interrupts.check()
                with _blamed_on(path):
                    temporary.chmod(_mode(target))
                    os.replace(temporary, target)
        except BaseException:
            temporary.unlink(missing_ok=True)
            raise


@contextlib.contextmanager
def result_file(path: Path, beginnings: Sequence[str], force: bool = False) -> Iterator[TextIO]:
    """Open a text file as ``replaced_file`` does, without replacing files of other programs.

    An existing file belongs to this program if it is empty or begins with one of ``beginnings``. For other
    files ValueError is raised before and after the block, unless ``force`` is True.
    """

    def check() -> None:
        if force or str(path) == "-" or not path.is_file():
            return
        with open(path, "rb") as found:
            start = found.read(max(map(len, beginnings)))
        if start and not start.startswith(tuple(text.encode() for text in beginnings)):
            raise ValueError(f"{path}: {_OTHERS}")

    check()
    with replaced_file(path) as stream:
        yield stream
        check()


@contextlib.contextmanager
def _spooled(out: TextIO) -> Iterator[TextIO]:
    """Open a temporary file, whose text is copied to ``out`` if the block ends without an error."""
    with tempfile.TemporaryFile("w+", encoding="utf-8", newline="\n") as stream:
        yield stream
        stream.seek(0)
        shutil.copyfileobj(stream, out)
        out.flush()


def _mode(target: Path) -> int:
    """Return the permissions of ``target``, or the permissions of a new file if it does not exist."""
    with contextlib.suppress(FileNotFoundError):
        return target.stat().st_mode & 0o777
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask


@contextlib.contextmanager
def result_folder(
    directory: Path, force: bool = False, inputs: Iterable[Path] = (), names: Iterable[str] = ()
) -> Iterator[Path]:
    """Return an empty folder as ``staged_folder`` does, without replacing files of other programs.

    Parameters
    ----------
    directory : Path
        Folder of the files and of their record.
    force : bool
        True also replaces edited files and files of other programs, except inputs.
    inputs : iterable of Path
        Files that are never replaced.
    names : iterable of str
        Names of files that the block writes, also checked before the block.

    Yields
    ------
    Path
        Empty folder.

    Raises
    ------
    ValueError
        If a file is an input, or was written or changed by another program.
    OSError
        As for ``staged_folder``.
    """
    ours = recorded(directory, RECORD)
    for name in names:
        must_replace(directory, name, None, ours, force, inputs)
    with staged_folder(directory) as folder:
        yield folder
        found = {
            path.relative_to(folder).as_posix(): path.read_bytes()
            for path in sorted(folder.rglob("*"))
            if path.is_file()
        }
        for name, content in found.items():
            must_replace(directory, name, content, ours, force, inputs)
        kept = {name: digest for name, digest in ours.items() if (directory / name).is_file()}
        files = kept | {name: hashlib.sha256(content).hexdigest() for name, content in found.items()}
        (folder / RECORD).write_text(record(files), encoding="utf-8", newline="\n")


def record(files: Mapping[str, str]) -> str:
    """Format a record of names and digests of files."""
    generator = f"stewart-sym {version('stewart-sym')}"
    return json_text({"generator": generator, "files": dict(sorted(files.items()))})


def recorded(directory: Path, name: str) -> Mapping[str, str]:
    """Read the digests of files that this program wrote into a folder from a record; return {} without a
    record.
    """
    path = directory / name
    if not path.is_file():
        return {}
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
        own = str(found["generator"]).startswith("stewart-sym ")
        files = {str(file): str(digest) for file, digest in found["files"].items()}
    except (ValueError, KeyError, TypeError, AttributeError):
        return {}
    inside = all(not Path(file).is_absolute() and ".." not in Path(file).parts for file in files)
    return files if own and inside else {}


def digest(path: Path) -> str | None:
    """Compute the SHA-256 digest of a file; return None if there is no file."""
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else None


def must_replace(
    directory: Path,
    name: str,
    content: bytes | None,
    ours: Mapping[str, str],
    force: bool,
    inputs: Iterable[Path] = (),
) -> bool:
    """Return True if a file of a folder must be written.

    ``content`` is None if the content is not known yet, and ``ours`` contains the recorded digests. Raises
    ValueError for an input, for anything other than a file, and without ``force`` for a file of another
    program.
    """
    path = directory / name
    if not os.path.lexists(path):
        return True
    if path.exists() and not path.is_file():
        found = "a folder" if path.is_dir() else "a device or a pipe"
        raise ValueError(f"{path}: expected a file or nothing, found {found}")
    if content is not None and path.exists() and path.read_bytes() == content:
        return False
    if any(path.exists() and each.exists() and path.samefile(each) for each in inputs):
        raise ValueError(f"{path}: is an input; name another folder")
    if not force and digest(path) != ours.get(name, ""):
        raise ValueError(f"{path}: {_OTHERS}")
    return True


@contextlib.contextmanager
def staged_folder(directory: Path, gone: Iterable[Path] = ()) -> Iterator[Path]:
    """Return an empty folder whose files move into ``directory`` if the block ends without an error.

    The directory is created if missing. Files of the same names are replaced. Files of the names ``gone`` are
    removed, and folders that become empty too; other files remain. Either all changes are made or none: after
    an error or an interrupt, moved files are restored.

    Raises OSError that names ``directory`` if it cannot be written, before the block, or the file or folder
    that prevents a move.
    """
    target = directory.resolve()
    place = target
    while not os.path.lexists(place):
        place = place.parent
    if not place.is_dir():
        raise NotADirectoryError(ENOTDIR, f"expected a folder, but {place} is none", str(directory))
    with interrupts.deferred():
        _remove_left_behind(place)
        with _blamed_on(directory):
            # The temporary folder is inside, because the directory may be a mount point, or its parent may be
            # read-only.
            temporary = Path(tempfile.mkdtemp(prefix=_PREFIX, dir=place))
        try:
            staged, replaced = temporary / "new", temporary / "old"
            with _locked(temporary):
                staged.mkdir()
                replaced.mkdir()
                with interrupts.deferred(False), named(directory):
                    yield staged
                _move_all(staged, target, replaced, gone)
                for folder in {parent for name in gone for parent in name.parents[:-1]}:
                    _remove_empty(target / folder)
        finally:
            shutil.rmtree(temporary, ignore_errors=True)


@contextlib.contextmanager
def _locked(path: Path) -> Iterator[bool]:
    """Lock a file or folder during the block, and yield True if it was locked.

    The lock also ends with the process. Systems without such locks yield False.
    """
    if sys.platform == "win32":
        yield False
        return
    import fcntl

    descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    ours = False
    try:
        with contextlib.suppress(OSError):
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
            ours = True
        yield ours
    finally:
        os.close(descriptor)


def _remove_left_behind(folder: Path) -> None:
    """Remove temporary files and folders of killed processes, except files moved out of their place."""
    with contextlib.suppress(OSError):
        for name in filter(_TEMPORARY.fullmatch, os.listdir(folder)):
            with contextlib.suppress(OSError):
                _remove_if_left(folder / name)


def _remove_if_left(path: Path) -> None:
    status = path.lstat()
    if time.time() - status.st_mtime < _UNLOCKED_SECONDS:
        return
    if stat.S_ISREG(status.st_mode):
        with _locked(path) as ours:
            if ours:
                path.unlink()
    elif stat.S_ISDIR(status.st_mode):
        with _locked(path) as ours:
            if ours and not any((path / "old").glob("*")):
                shutil.rmtree(path)


def _move_all(staged: Path, target: Path, replaced: Path, gone: Iterable[Path]) -> None:
    """Move staged files to ``target``, and existing files and ``gone`` to ``replaced``, or none."""
    new = {path.relative_to(staged): path for path in sorted(staged.rglob("*")) if path.is_file()}
    with contextlib.ExitStack() as undo:
        for folder in sorted({target, *((target / file).parent for file in new)}):
            _make_folder(folder, undo)
        for number, file in enumerate((*new, *gone)):
            interrupts.check()
            _move(new.get(file), target / file, replaced / str(number), undo)
        interrupts.check()
        undo.pop_all()


# The undo operation is registered before each step, because an interrupt can occur between any two steps.


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


def _move(new: Path | None, path: Path, old: Path, undo: contextlib.ExitStack) -> None:
    """Move an existing file to ``old``, and the new file, if any, to its place."""
    if path.is_dir():
        raise IsADirectoryError(EISDIR, "is a folder, expected a file to replace", str(path))
    undo.callback(_put_back, path, old, new or path)
    with _blamed_on(path):
        if new is not None and path.is_file():
            new.chmod(_mode(path))
        if os.path.lexists(path):
            path.rename(old)
        if new is not None:
            new.rename(path)


def _put_back(path: Path, old: Path, new: Path) -> None:
    if os.path.lexists(old):
        old.replace(path)
    elif not os.path.lexists(new):
        path.unlink()


@contextlib.contextmanager
def named(path: Path | str) -> Iterator[None]:
    """Add the name ``path`` to an OSError without a file name, such as the error of a full disk."""
    try:
        yield
    except OSError as error:
        if error.filename is not None or error.errno is None:
            raise
        raise OSError(error.errno, error.strerror, str(path)) from error


@contextlib.contextmanager
def _blamed_on(path: Path) -> Iterator[None]:
    """Replace the temporary file in an OSError by the path of the user."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, f"can't write here: {error.strerror}", str(path)) from None
