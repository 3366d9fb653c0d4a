"""Texts of the generated kernels: installed, or derived at first use and stored in the cache folder.

``stewart_sym.generated`` contains only digests of the rarely used kernels. Their Python modules are imported
under the same names as the installed ones.
"""

import contextlib
import hashlib
import importlib.abc
import importlib.util
import sys
from collections.abc import Sequence
from functools import cache
from importlib.machinery import ModuleSpec
from importlib.resources import files
from pathlib import Path, PurePosixPath
from threading import Lock
from types import ModuleType

from ..io.atomic_write import write_file
from .cache import cache_folder, locked

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
    text = _cached(path)
    return _derived(path) if text is None else text


def _cached(path: str) -> str | None:
    """Read a derived file from the cache folder; return None if it is missing or damaged."""
    with contextlib.suppress(OSError):
        content = _place(path).read_bytes()
        if hashlib.sha256(content).hexdigest() == digests()[path]:
            return content.decode()
    return None


def _place(path: str) -> Path:
    """Return the file in the cache folder that stores a derived file."""
    name = PurePosixPath(path)
    return cache_folder() / f"{name.stem}-{digests()[path][:32]}{name.suffix}"


def _derived(path: str) -> str:
    """Derive a file and store it, once for all processes if the cache folder can be written."""
    kernel = PurePosixPath(path).stem
    with _ONE_DERIVATION, contextlib.ExitStack() as stack:
        with contextlib.suppress(OSError):
            stack.enter_context(locked(cache_folder() / f"{kernel}.lock"))
        text = _cached(path)
        if text is None:
            texts = _kernel_files(kernel)
            text = texts[path]
            for each, content in texts.items():
                with contextlib.suppress(OSError):
                    write_file(_place(each), content)
        return text


@cache
def _kernel_files(kernel: str) -> dict[str, str]:
    """Derive the files of one kernel, text by path in ``generated/``, and compare them with their digests."""
    try:
        from ..derive.on_demand import kernel_files
    except ModuleNotFoundError as error:
        missing = error.name or ""
        remedy = f"install it with `pip install {missing}`"
        raise ImportError(f"kernel {kernel}: the derivation needs {missing}; {remedy}") from error
    texts: dict[str, str] = kernel_files(kernel)
    for path, text in texts.items():
        if hashlib.sha256(text.encode()).hexdigest() != digests()[path]:
            remedy = "install the version of SymPy in its requirements, or run `stewart-sym derive`"
            raise ImportError(f"kernel {kernel}: {path} differs from its digest in {PACKAGE}; {remedy}")
    return texts


class _Importer(importlib.abc.MetaPathFinder, importlib.abc.ExecutionLoader):
    """Import of the Python modules that are derived at first use."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        package, _, name = fullname.rpartition(".")
        if package != PACKAGE or f"{name}.py" not in digests():
            return None
        return importlib.util.spec_from_loader(fullname, self)

    def is_package(self, fullname: str) -> bool:
        return False

    def get_filename(self, fullname: str) -> str:
        return str(_place(f"{fullname.rpartition('.')[2]}.py"))

    def get_source(self, fullname: str) -> str:
        return generated_text(f"{fullname.rpartition('.')[2]}.py")


sys.meta_path.append(_Importer())
