"""The FMI unit of a kit as one file: compiled, put together and packed so that it repeats to the byte.

Takes a kernel's C and plain numbers; the texts are those of ``derive.package.fmu``. FMI 2.0 and
co-simulation, as every Simulink with an FMU block, and nearly every other tool, imports just that.
"""

import io
import platform
import sys
import tempfile
import zipfile
from collections.abc import Mapping
from pathlib import Path

from ..backend import native
from ..derive.package import fmu as texts
from ..derive.package.fmu import UnitKernel
from ..derive.package.words import Numbers

__all__ = ["UnitKernel", "binary_folder", "fmu_unit"]

# The earliest that an archive can hold.
_DATE = (1980, 1, 1, 0, 0, 0)
_SYSTEMS = {"linux": "linux", "win32": "win", "darwin": "darwin"}
_SUFFIX = {"win32": ".dll", "darwin": ".dylib"}.get(sys.platform, ".so")


def fmu_unit(
    name: str,
    symbol: str,
    sources: Mapping[str, str],
    kernel: UnitKernel,
    pose: Numbers,
    payload: Numbers | None,
    digest: str,
    version: str,
) -> bytes:
    """The bytes of ``<symbol>.fmu``: description, page, C and, where it can be compiled here, a binary.

    name: the robot's. symbol: of its constants in ``robot.h``, an identifier. sources: file name -> text of
    every .h and .c that the kernel needs, ``robot.h`` and ``robot.c`` too unless it is baked. kernel: how it
    is called. pose: R (3, 3) and t (3,), m, that the inputs have at first, a pose with forces, so that the
    unit runs before anything is connected; other fields of a motion are not read, those inputs start at zero.
    payload: M, kg, R_0, m, I_p (3, 3), kg m^2, and g, m/s^2, of the robot, which become tunable parameters;
    None for a baked kernel. digest: of name and constants. version: of the generator.

    The same arguments and compiler give the same bytes. Without a compiler, or on a machine for which FMI 2.0
    has no name, the unit holds its C alone (see ``binary_folder``).

    Raises ValueError for a number or file that is missing, native.CompilerError if the compiler fails.
    """
    texts_by_path = texts.unit(name, symbol, sources, kernel, pose, payload, digest, version)
    files = {path: text.encode() for path, text in texts_by_path.items()}
    folder = binary_folder()
    if folder is not None:
        identifier = texts.model_identifier(symbol)
        code = {
            path.removeprefix("sources/"): text
            for path, text in texts_by_path.items()
            if path.startswith("sources/")
        }
        files[f"{folder}/{identifier}{_SUFFIX}"] = _binary(identifier, code)
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


def _binary(identifier: str, sources: Mapping[str, str]) -> bytes:
    with tempfile.TemporaryDirectory(prefix="stewart-sym-", ignore_cleanup_errors=True) as folder:
        return native.compiled(Path(folder), identifier, sources, base=native.PORTABLE_FLAGS).read_bytes()


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
