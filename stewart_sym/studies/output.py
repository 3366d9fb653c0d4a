"""Writing results so that a failure leaves nothing behind: CSV text, one file or one folder at a time.

Used by the commands that write; knows nothing of what is written.
"""

import contextlib
import os
import shutil
import sys
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, TextIO

from numpy.typing import NDArray


def csv_lines(columns: Mapping[str, NDArray[Any]]) -> Iterator[str]:
    """Lines of a CSV file, header first; columns (n,) by name, floats with all their digits."""
    yield ",".join(columns) + "\n"
    for row in zip(*(column.tolist() for column in columns.values()), strict=True):
        yield ",".join(map(repr, row)) + "\n"


@contextlib.contextmanager
def replaced_file(path: Path) -> Iterator[TextIO]:
    """Open a text file that takes the place of ``path`` only when the block ends well; ``-`` is stdout.

    A device or a pipe is written as it is. Raises OSError naming ``path`` before the block when it can't be
    written.
    """
    if str(path) == "-":
        yield sys.stdout
        return
    target = path.resolve()
    if target.is_dir():
        raise IsADirectoryError(21, "is a folder, expected a file to write", str(path))
    if target.exists() and not target.is_file():
        with open(target, "w", encoding="utf-8") as stream:
            yield stream
        return
    temporary = target.with_name(f".{target.name}.{os.getpid()}.part")
    with _named(path):
        temporary.touch(exist_ok=False)
    try:
        with open(temporary, "w", encoding="utf-8", newline="\n") as stream:
            yield stream
        os.replace(temporary, target)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise


@contextlib.contextmanager
def staged_folder(directory: Path) -> Iterator[Path]:
    """Give an empty folder whose files move into ``directory``, made if missing, when the block ends well.

    Files of the same names are replaced, others stay. Raises OSError naming ``directory`` before the block
    when it can't be written.
    """
    target = directory.resolve()
    place = target
    while not os.path.lexists(place):
        place = place.parent
    with _named(directory):
        staging = Path(tempfile.mkdtemp(prefix=".stewart-sym-", dir=place))
    try:
        yield staging
        _publish(staging, target)
    finally:
        shutil.rmtree(staging, ignore_errors=True)


def _publish(staging: Path, target: Path) -> None:
    files = [path.relative_to(staging) for path in sorted(staging.rglob("*")) if path.is_file()]
    for file in files:
        if (target / file).is_dir():
            raise IsADirectoryError(21, "is a folder, expected a file to replace", str(target / file))
    for file in files:
        (target / file).parent.mkdir(parents=True, exist_ok=True)
        os.replace(staging / file, target / file)


@contextlib.contextmanager
def _named(path: Path) -> Iterator[None]:
    """Let an OSError name what the user asked for instead of a temporary file beside it."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, f"can't write here: {error.strerror}", str(path)) from None
