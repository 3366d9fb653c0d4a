"""Texts of the generated kernels: installed, or derived at first use and stored in the cache folder.

``stewart_sym.generated`` contains only digests of the rarely used kernels. Their Python modules are imported
under the same names as the installed ones.
"""

import contextlib
import hashlib
import importlib.abc
import importlib.util
import sys
from functools import cache
from importlib.machinery import ModuleSpec
from importlib.resources import files
from pathlib import Path, PurePosixPath
from threading import Lock
from typing import Any

from ..io.atomic_write import write_file
from .native import cache_folder, create_once

PACKAGE = "stewart_sym.generated"
"""Package of the generated kernels."""
_ONE_DERIVATION = Lock()


@cache
def digests() -> dict[str, str]:
    """Return the SHA-256 digests of the files that are derived at first use, by path in ``generated/``."""
    table = (files(PACKAGE) / "on_demand.sha256").read_text(encoding="utf-8")
    rows = (line.split() for line in table.splitlines())
    return {path: digest for digest, path in rows}


def generated_text(path: str) -> str:
    """Return the text of a file of ``generated/``, and derive it if it is neither installed nor cached.

    Raises ImportError if SymPy is missing or derives another text than the digest requires.
    """
    if path not in digests():
        return (files(PACKAGE) / path).read_text(encoding="utf-8")
    kernel = PurePosixPath(path).stem

    def store() -> None:
        for each, text in _derived(kernel).items():
            write_file(_place(each), text)

    with contextlib.suppress(OSError):
        create_once(_place(path), store)
        return _place(path).read_text(encoding="utf-8")
    # The cache folder cannot be written.
    return _derived(kernel)[path]


def _place(path: str) -> Path:
    """Return the file in the cache folder that stores a derived file."""
    name = PurePosixPath(path)
    return cache_folder() / f"{name.stem}-{digests()[path][:32]}{name.suffix}"


@cache
def _derived(kernel: str) -> dict[str, str]:
    """Derive the files of a kernel, text by path, and compare them with their digests."""
    from ..derive.on_demand import kernel_files

    with _ONE_DERIVATION:
        texts: dict[str, str] = kernel_files(kernel)
    for path, text in texts.items():
        if hashlib.sha256(text.encode()).hexdigest() != digests()[path]:
            remedy = "install the version of SymPy in its requirements, or run `stewart-sym derive`"
            raise ImportError(f"kernel {kernel}: {path} differs from its digest in {PACKAGE}; {remedy}")
    return texts


class _Importer(importlib.abc.InspectLoader):
    """Import of the Python modules that are derived at first use."""

    def find_spec(self, fullname: str, path: Any, target: Any = None) -> ModuleSpec | None:
        package, _, name = fullname.rpartition(".")
        is_derived = package == PACKAGE and f"{name}.py" in digests()
        return importlib.util.spec_from_loader(fullname, self) if is_derived else None

    def get_source(self, fullname: str) -> str:
        return generated_text(f"{fullname.rpartition('.')[2]}.py")


sys.meta_path.append(_Importer())
