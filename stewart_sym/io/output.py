"""Output files: JSON and TOML text, atomic writing, and checks that protect inputs and other files."""

import contextlib
import hashlib
import json
import math
import os
import sys
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

RECORD = ".stewart-sym.json"
"""Record of the names and SHA-256 digests of the files that this program wrote into a folder."""


def write_file(path: Path, content: str | bytes | Iterable[str]) -> None:
    """Write a file atomically; ``-`` writes text to standard output.

    The content is written to a file ``.stewart-sym-*`` in the same folder, which then replaces ``path``.
    Missing folders are created. A device or a pipe is written directly. Raises OSError that names ``path``.
    """
    chunks: Iterable[str | bytes] = [content] if isinstance(content, str | bytes) else content
    if str(path) == "-":
        sys.stdout.writelines(map(str, chunks))
        return
    data = (each.encode() if isinstance(each, str) else each for each in chunks)
    target = path.resolve()
    place = target.with_name(f".stewart-sym-{os.urandom(4).hex()}")
    try:
        if path.exists() and not path.is_file():
            path.write_bytes(b"".join(data))
            return
        target.parent.mkdir(parents=True, exist_ok=True)
        with open(place, "xb") as stream:
            stream.writelines(data)
        os.replace(place, target)
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from None
    finally:
        place.unlink(missing_ok=True)


def must_be_replaceable(path: Path, is_ours: bool, force: bool = False, inputs: Iterable[Path] = ()) -> None:
    """Raise ValueError if a file cannot be written, is an input, or is not ours and ``force`` is False."""
    folder = next(each for each in path.absolute().parents if each.exists())
    if path.is_dir() or not folder.is_dir() or not os.access(folder, os.W_OK):
        raise ValueError(f"{path if folder.is_dir() else folder}: cannot write a file here; use another name")
    if any(each.exists() and path.exists() and path.samefile(each) for each in inputs):
        raise ValueError(f"{path}: is an input; use another name")
    if path.exists() and not (is_ours or force):
        raise ValueError(f"{path}: exists with other content; use --force to overwrite")


def digest(path: Path) -> str | None:
    """Compute the SHA-256 digest of a file; return None if there is no file."""
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else None


def recorded(record: Path) -> dict[str, str]:
    """Read digests of files that this program wrote into a folder, by name; return {} without a record."""
    with contextlib.suppress(OSError, ValueError, KeyError, TypeError):
        return dict(json.loads(record.read_text(encoding="utf-8"))["files"])
    return {}


class ResultFolder:
    """Folder whose files are written one by one, with a record of the files that this program wrote.

    Inputs are never replaced. Edited files, and files of other programs, are replaced only with ``force``.
    ``names`` are the files written so far.
    """

    def __init__(
        self, directory: Path, force: bool = False, inputs: Iterable[Path] = (), names: Iterable[str] = ()
    ) -> None:
        """Raise ValueError now if the folder or one of the files ``names`` cannot be written."""
        self.names: list[str] = []
        self._directory, self._force, self._inputs = directory, force, [*inputs]
        self._digests = recorded(directory / RECORD)
        must_be_replaceable(directory / RECORD, is_ours=True)
        for name in names:
            self._check(name, "")

    def _check(self, name: str, new: str) -> None:
        path = self._directory / name
        is_ours = digest(path) in (self._digests.get(name, ""), new)
        must_be_replaceable(path, is_ours, self._force, self._inputs)

    def write(self, name: str, content: str | bytes | Iterable[str]) -> None:
        """Write one file and record it."""
        data = content if isinstance(content, bytes) else "".join(content).encode()
        new = hashlib.sha256(data).hexdigest()
        self._check(name, new)
        write_file(self._directory / name, data)
        self._digests[name] = new
        self.names.append(name)
        write_file(self._directory / RECORD, json_text({"files": self._digests}))


def json_text(data: Any) -> str:
    """Format data as indented JSON with a final newline; arrays become lists, and non-finite numbers null."""
    return json.dumps(plain(data), indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def plain(value: Any) -> Any:
    """Convert arrays, NumPy scalars, mappings, and tuples to numbers, lists, and dictionaries of Python."""
    if isinstance(value, np.ndarray | np.generic):
        value = value.tolist()
    if isinstance(value, Mapping):
        return {str(key): plain(each) for key, each in value.items()}
    if isinstance(value, list | tuple):
        return [plain(each) for each in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def toml_text(tables: Mapping[str, Any]) -> str:
    """Format tables of strings, numbers, lists, and tables as TOML.

    A table without nested tables is written in one line, except for the top-level tables of the file.
    """
    return "\n".join(_lines(tables, "")) + "\n"


def _lines(table: Mapping[str, Any], path: str) -> Iterator[str]:
    sections = {key: value for key, value in table.items() if isinstance(value, Mapping)}
    if path:
        sections = {k: v for k, v in sections.items() if any(isinstance(x, Mapping) for x in v.values())}
    yield from (f"{key} = {_value(value)}" for key, value in table.items() if key not in sections)
    for key, value in sections.items():
        yield from ("", f"[{path}{key}]")
        yield from _lines(value, f"{path}{key}.")


def _value(value: Any) -> str:
    if isinstance(value, Mapping):
        inside = ", ".join(f"{key} = {_value(each)}" for key, each in value.items())
        return f"{{ {inside} }}" if inside else "{}"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(_value, value))}]"
    # Strings, Booleans, and numbers have the same format as in JSON.
    return json.dumps(value, ensure_ascii=False)
