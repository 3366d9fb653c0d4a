"""The FMI unit of a kit as one file: compiled, put together and packed so that it repeats to the byte.

FMI 2.0 and co-simulation, as nearly every tool imports just that, Simulink with an FMU block among them.
"""

import io
import platform
import sys
import tempfile
import zipfile
from collections.abc import Mapping
from pathlib import Path

from ..backend import native
from ..derive.package.fmu import model_identifier

# The earliest that an archive can hold.
_DATE = (1980, 1, 1, 0, 0, 0)
_SYSTEMS = {"linux": "linux", "win32": "win", "darwin": "darwin"}
_SUFFIX = {"win32": ".dll", "darwin": ".dylib"}.get(sys.platform, ".so")


def packed(symbol: str, texts: Mapping[str, str]) -> bytes:
    """The bytes of ``<symbol>.fmu``: the unit's texts and, where it can be compiled here, a binary.

    symbol: of the robot's constants, an identifier. texts: path in the archive -> text, as
    ``derive.package.fmu.unit`` makes them.

    The same arguments and compiler give the same bytes. Without a compiler, or on a machine for which FMI 2.0
    has no name, the unit holds its C alone (see ``binary_folder``).

    Raises native.CompilerError if the compiler fails.
    """
    files = {path: text.encode() for path, text in texts.items()}
    folder = binary_folder()
    if folder is not None:
        identifier = model_identifier(symbol)
        code = {
            path.removeprefix("sources/"): text for path, text in texts.items() if path.startswith("sources/")
        }
        with tempfile.TemporaryDirectory(prefix="stewart-sym-", ignore_cleanup_errors=True) as place:
            made = native.compiled(Path(place), identifier, code, base=native.PORTABLE_FLAGS)
            files[f"{folder}/{identifier}{_SUFFIX}"] = made.read_bytes()
    return _archive(files)


def binary_folder() -> str | None:
    """Where a unit made here has its binary, as ``binaries/linux64``; None: it has its C alone.

    Raises native.CompilerError where $CC is set and does not work.
    """
    system, machine = _SYSTEMS.get(sys.platform), platform.machine().lower()
    intel = machine in ("x86_64", "amd64", "i386", "i686", "x86")
    # Importers look there for Apple's own processors as well.
    if system is None or not (intel or system == "darwin") or native.find_compiler() is None:
        return None
    return f"binaries/{system}{64 if sys.maxsize > 2**32 else 32}"


def _archive(files: Mapping[str, bytes]) -> bytes:
    """A zip of the files by path; stored, as compressors differ from one machine to the next."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_STORED) as archive:
        for path, content in sorted(files.items()):
            entry = zipfile.ZipInfo(path, _DATE)
            entry.create_system = 3
            entry.external_attr = (0o100755 if path.startswith("binaries/") else 0o100644) << 16
            archive.writestr(entry, content)
    return stream.getvalue()
