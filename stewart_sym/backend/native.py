"""Compilation of C sources into shared libraries in the cache folder of the user, and their loading."""

import contextlib
import ctypes
import functools
import hashlib
import importlib.util
import os
import platform
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import platformdirs

# Code on Windows is always position independent, and clang rejects the flag there.
_POSITION = () if sys.platform == "win32" else ("-fPIC",)
_COMMON = ("-std=c99", *_POSITION, "-shared", "-fno-math-errno", "-ffp-contract=off")
_NATIVE = "-march=native"
FLAGS = ("-O3", *_COMMON, _NATIVE)
"""Compiler flags of libraries for this machine."""
PORTABLE_FLAGS = ("-O2", *_COMMON, "-fvisibility=hidden")
"""Compiler flags of distributed libraries: any processor of the same architecture, exported symbols only."""
_SUFFIX = {"win32": ".dll", "darwin": ".dylib"}.get(sys.platform, ".so")
# Names of the lines of /proc/cpuinfo with the model and its instruction sets (x86, Arm, RISC-V, POWER).
_PROCESSOR_LINES = ("model", "flags", "Features", "CPU", "isa", "uarch", "cpu\t")


class CompilerError(RuntimeError):
    """Error of building or loading a library, in one line."""


class Compiler(NamedTuple):
    """Working C compiler: command with arguments, and the first line of its version."""

    command: tuple[str, ...]
    version: str


def cache_folder() -> Path:
    """Return ``$STEWART_SYM_CACHE``, by default the cache folder of the user."""
    named = os.environ.get("STEWART_SYM_CACHE")
    return Path(named or platformdirs.user_cache_dir("stewart-sym", appauthor=False)).absolute()


def create_once(path: Path, create: Callable[[], None]) -> None:
    """Call ``create`` unless a path exists; other processes and threads wait for it at a lock file."""
    if path.exists():
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.with_suffix(".lock").open("w") as stream:
        # On Windows, two processes may create the same file.
        if sys.platform != "win32":
            import fcntl

            fcntl.flock(stream, fcntl.LOCK_EX)
        if not path.exists():
            create()


def find_compiler() -> Compiler | None:
    """Return the first working compiler of ``$CC``, cc, gcc, clang, and the ``ziglang`` wheel, or None.

    ``$CC`` may contain arguments. If it is set and does not work, CompilerError is raised.
    """
    requested = os.environ.get("CC", "").strip()
    if requested:
        try:
            return _check_compiler(*shlex.split(requested, posix=sys.platform != "win32"))
        except (ValueError, CompilerError) as error:
            raise CompilerError(f"CC={requested!r} is not a working C compiler: {error}") from error
    zig = [[sys.executable, "-m", "ziglang", "cc"]] if importlib.util.find_spec("ziglang") else []
    for command in (["cc"], ["gcc"], ["clang"], *zig):
        with contextlib.suppress(CompilerError):
            return _check_compiler(*command)
    return None


def load(name: str, sources: Mapping[str, str], flags: Sequence[str] = ()) -> ctypes.CDLL:
    """Load the shared library of C files, text by file name, and compile it if it is not in the cache.

    ``flags`` follow FLAGS. Raises CompilerError if there is no compiler, if it fails, or if the cache folder
    cannot be written.
    """
    flags = (*FLAGS, *flags)
    inputs = (name, sorted(sources.items()), require_compiler(), flags, _processor())
    digest = hashlib.sha256(repr(inputs).encode()).hexdigest()[:32]
    library = cache_folder() / f"{name}-{digest}{_SUFFIX}"

    def publish() -> None:
        with tempfile.TemporaryDirectory(dir=library.parent) as place:
            os.replace(compile_library(Path(place), name, sources, flags), library)

    try:
        create_once(library, publish)
        return ctypes.CDLL(str(library))
    except OSError as error:
        remedy = "set STEWART_SYM_CACHE to a writable folder"
        raise CompilerError(f"cannot load {library}: {error}; {remedy}") from error


def compile_library(folder: Path, name: str, sources: Mapping[str, str], flags: Sequence[str]) -> Path:
    """Compile a library into ``folder`` with ``flags`` alone and return its path; raises as ``load``."""
    for file, text in sources.items():
        (folder / file).write_text(text, encoding="utf-8", newline="\n")
    library = folder / f"{name}{_SUFFIX}"
    # Relative file names avoid blanks and non-ASCII characters of the home folder.
    files = sorted(file for file in sources if file.endswith(".c"))
    libraries = () if sys.platform == "win32" else ("-lm",)
    try:
        command = (*require_compiler().command, *flags, *files, "-o", library.name, *libraries)
        run_compiler(command, folder)
    except CompilerError as error:
        if _NATIVE not in flags:
            raise CompilerError(f"can't compile {name}: {error}") from error
        # Some compilers do not support the flag, or the assembler does not support the instructions.
        return compile_library(folder, name, sources, [flag for flag in flags if flag != _NATIVE])
    return library


def run_compiler(command: Sequence[str], folder: Path) -> str:
    """Run a compiler in ``folder``, and return its output; raise CompilerError if it fails."""
    # Errors are recognized in English.
    environment = {**os.environ, "LC_ALL": "C"}
    try:
        return subprocess.check_output(
            command, cwd=folder, env=environment, stderr=subprocess.STDOUT, text=True, errors="replace"
        )
    except OSError as error:
        raise CompilerError(f"{command[0]} does not run: {error}") from error
    except subprocess.CalledProcessError as error:
        lines = error.output.splitlines() or [""]
        first = next((line for line in lines if "error:" in line), lines[0])
        raise CompilerError(f"{command[0]} fails: {first}") from error


@functools.cache
def _check_compiler(*words: str) -> Compiler:
    """Return the compiler of a command line; a failure raises CompilerError and is not cached."""
    program = shutil.which(words[0].strip('"'))
    if program is None:
        raise CompilerError(f"{words[0]} not found")
    command = (os.path.abspath(program), *words[1:])
    return Compiler(command, run_compiler((*command, "--version"), Path()).strip().partition("\n")[0])


def require_compiler() -> Compiler:
    """Return the compiler of ``find_compiler``; raise CompilerError if there is none."""
    compiler = find_compiler()
    if compiler is None:
        raise CompilerError("no C compiler found; install gcc or clang, set CC, or run `pip install ziglang`")
    return compiler


@functools.cache
def _processor() -> str:
    """Describe the model and the instruction sets, because native code runs only on similar processors."""
    lines = {platform.machine(), platform.processor()}
    with contextlib.suppress(OSError):
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace")
        lines.update(line for line in text.splitlines() if line.startswith(_PROCESSOR_LINES))
    return "\n".join(sorted(lines))
