"""FMI unit of a kit as one file, compiled and packed reproducibly to the byte.

The unit supports FMI 2.0 co-simulation, because nearly every tool imports this kind, including the FMU block
of Simulink.
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

# Earliest date that a zip archive supports.
_DATE = (1980, 1, 1, 0, 0, 0)
_SYSTEMS = {"linux": "linux", "win32": "win", "darwin": "darwin"}


def packed(symbol: str, texts: Mapping[str, str]) -> bytes:
    """Return ``<symbol>.fmu``: the texts by path in the archive, and a binary if this machine can build it.

    Equal texts and an equal compiler give identical bytes. Raises native.CompilerError if the compiler fails.
    """
    files = {path: text.encode() for path, text in texts.items()}
    folder = binary_folder()
    if folder is not None:
        identifier = model_identifier(symbol)
        sources = [path for path in texts if path.startswith("sources/")]
        code = {path.removeprefix("sources/"): texts[path] for path in sources}
        with tempfile.TemporaryDirectory(prefix="stewart-sym-", ignore_cleanup_errors=True) as place:
            made = native.compile_library(Path(place), identifier, code, native.PORTABLE_FLAGS)
            files[f"{folder}/{made.name}"] = made.read_bytes()
    return _archive(files)


def binary_folder() -> str | None:
    """Return the folder of the binary in a unit built on this machine, such as ``binaries/linux64``.

    Return None if the unit contains only C sources. Raises native.CompilerError if $CC is set and does not
    work.
    """
    system, machine = _SYSTEMS.get(sys.platform), platform.machine().lower()
    intel = machine in ("x86_64", "amd64", "i386", "i686", "x86")
    # Importers use the same folder for Apple's own processors.
    if system is None or not (intel or system == "darwin") or native.find_compiler() is None:
        return None
    return f"binaries/{system}{64 if sys.maxsize > 2**32 else 32}"


def _archive(files: Mapping[str, bytes]) -> bytes:
    """Write a zip archive without compression, because the output of compressors depends on the platform."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_STORED) as archive:
        for path, content in sorted(files.items()):
            entry = zipfile.ZipInfo(path, _DATE)
            entry.create_system = 3
            entry.external_attr = (0o100755 if path.startswith("binaries/") else 0o100644) << 16
            archive.writestr(entry, content)
    return stream.getvalue()
