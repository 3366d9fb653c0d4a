"""Compilation of C sources into shared libraries, which are stored in a cache folder and loaded with ctypes.

A library is compiled in a temporary folder and published by one rename, so that no process loads an
unfinished file. The lock only prevents simultaneous compilation of the same library.
"""

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
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

# Code on Windows is always position independent, and clang rejects the flag there.
_POSITION = () if sys.platform == "win32" else ("-fPIC",)
_COMMON = ("-std=c99", *_POSITION, "-shared", "-fno-math-errno", "-ffp-contract=off")
_NATIVE = "-march=native"
FLAGS = ("-O3", *_COMMON, _NATIVE)
"""Compiler flags of libraries for this machine."""
PORTABLE_FLAGS = ("-O2", *_COMMON, "-fvisibility=hidden")
"""Compiler flags of distributed libraries: any processor of the same architecture, exported symbols only."""
# A library linked with one of these switches the whole process to flush-to-zero.
_REJECTED = frozenset({"-Ofast", "-ffast-math", "-funsafe-math-optimizations"})
_SUFFIX = {"win32": ".dll", "darwin": ".dylib"}.get(sys.platform, ".so")
# Names of the lines of /proc/cpuinfo with the model and its instruction sets (x86, Arm, RISC-V, POWER).
_PROCESSOR_LINES = ("model", "flags", "Features", "CPU", "isa", "uarch", "cpu\t")

_loaded: dict[str, ctypes.CDLL] = {}


class CompilerError(RuntimeError):
    """Error of building or loading a library, in one line; ``log`` is the output of the compiler."""

    def __init__(self, message: str, log: str = "") -> None:
        """Join the lines of ``message``."""
        super().__init__(" ".join(message.split()))
        self.log = log


class Compiler(NamedTuple):
    """Working C compiler: command with arguments, and the first line of its version."""

    command: tuple[str, ...]
    version: str


def find_compiler() -> Compiler | None:
    """Return the first working compiler of ``$CC``, cc, gcc, clang, and the ``ziglang`` wheel, or None.

    ``$CC`` may contain arguments. If it is set and does not work, CompilerError is raised.
    """
    requested = os.environ.get("CC", "").strip()
    if requested:
        try:
            return _working(shlex.split(requested, posix=sys.platform != "win32"))
        except (ValueError, CompilerError) as error:
            raise CompilerError(f"CC={requested!r} is not a working C compiler: {error}") from error
    commands = [["cc"], ["gcc"], ["clang"]]
    if importlib.util.find_spec("ziglang") is not None:
        commands.append([sys.executable, "-m", "ziglang", "cc"])
    for command in commands:
        with contextlib.suppress(CompilerError):
            return _working(command)
    return None


def load(
    name: str,
    sources: Mapping[str, str],
    flags: Sequence[str] = (),
    defines: Mapping[str, str | int] | None = None,
) -> ctypes.CDLL:
    """Load the shared library of C files, text by file name, and compile it if it is not in the cache.

    ``flags`` follow FLAGS, and ``defines`` are values of macros. A repeated call returns the same object.
    Raises CompilerError without a compiler or if it fails, and ValueError for a flag of fast arithmetic.
    """
    macros = [f"-D{macro}={value}" for macro, value in sorted((defines or {}).items())]
    compiler = _needed_compiler()
    command = (*compiler.command, *FLAGS, *macros, *flags)
    inputs = (name, sorted(sources.items()), command, compiler.version, _processor())
    file = f"{name}-{hashlib.sha256(repr(inputs).encode()).hexdigest()[:32]}{_SUFFIX}"
    if file not in _loaded:
        # Threads that load the same library at the same time receive the same object.
        _loaded.setdefault(file, _open(file, lambda folder: _compile(folder, name, sources, command)))
    return _loaded[file]


def compiled(folder: Path, name: str, sources: Mapping[str, str], flags: Sequence[str] = FLAGS) -> Path:
    """Compile a library into ``folder`` with ``flags`` alone and return its path; raises as ``load``."""
    return _compile(folder, name, sources, (*_needed_compiler().command, *flags))


def ran(command: Sequence[str], folder: Path) -> str:
    """Run a compiler in ``folder``, and return its output; raise CompilerError if it fails."""
    # Errors are recognized in English, and the default folders of Zig may be read-only.
    zig = {f"ZIG_{kind}_CACHE_DIR": str(folder) for kind in ("LOCAL", "GLOBAL")}
    try:
        done = subprocess.run(
            command,
            cwd=folder,
            env={**zig, **os.environ, "LC_ALL": "C"},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
            errors="replace",
            check=False,
        )
    except OSError as error:
        raise CompilerError(f"{command[0]} does not run: {error}") from error
    if done.returncode != 0:
        lines = [line.strip() for line in done.stdout.splitlines() if line.strip()]
        errors = [line for line in lines if "error:" in line]
        first = (errors or lines or ["it printed nothing"])[0]
        raise CompilerError(f"{command[0]} fails: {first}", done.stdout)
    return done.stdout


def _working(words: Sequence[str]) -> Compiler:
    program = shutil.which(words[0].strip('"'))
    if program is None:
        raise CompilerError(f"{words[0]} not found")
    command = (os.path.abspath(program), *words[1:])
    return Compiler(command, _version(command))


@functools.cache
def _version(command: tuple[str, ...]) -> str:
    """Return the first line of ``--version``; a failure raises CompilerError and is not cached."""
    with tempfile.TemporaryDirectory(prefix="stewart-sym-", ignore_cleanup_errors=True) as folder:
        return ran((*command, "--version"), Path(folder)).strip().partition("\n")[0]


def _needed_compiler() -> Compiler:
    compiler = find_compiler()
    if compiler is None:
        raise CompilerError("no C compiler found; install gcc or clang, set CC, or run `pip install ziglang`")
    return compiler


@functools.cache
def _processor() -> str:
    """Describe the model and the instruction sets, because native code runs only on similar processors."""
    lines: set[str] = set()
    with contextlib.suppress(OSError):
        lines.update(Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace").splitlines())
    machine = f"{sys.platform} {platform.machine()} {platform.processor()} {sys.maxsize}"
    return "\n".join([machine, *sorted(line for line in lines if line.startswith(_PROCESSOR_LINES))])


def _open(file: str, build: Callable[[Path], Path]) -> ctypes.CDLL:
    """Load a library from the cache, or from a temporary folder if the cache cannot be used."""
    try:
        return _open_in(_cache_folder(), file, build)
    except OSError as error:
        text = f"compiled libraries are kept for this process alone ({error}); "
        remedy = "set STEWART_SYM_CACHE to a folder that you may write"
        warnings.warn(text + remedy, RuntimeWarning, stacklevel=3)
    # A loaded library requires no file, except on Windows, where the folder remains.
    with tempfile.TemporaryDirectory(prefix="stewart-sym-", ignore_cleanup_errors=True) as folder:
        return _open_in(Path(folder), file, build)


def _open_in(folder: Path, file: str, build: Callable[[Path], Path]) -> ctypes.CDLL:
    library = folder / file
    if not library.exists():
        with _locked(folder / f"{file}.lock"):
            if not library.exists():
                with tempfile.TemporaryDirectory(dir=folder, ignore_cleanup_errors=True) as place:
                    os.replace(build(Path(place)), library)
    return ctypes.CDLL(str(library))


@contextlib.contextmanager
def _locked(path: Path) -> Iterator[None]:
    """Hold a lock file if the system supports locks; a killed process releases it."""
    try:
        with path.open("w") as file, contextlib.ExitStack() as held:
            with contextlib.suppress(ImportError, OSError):
                import fcntl

                fcntl.flock(file, fcntl.LOCK_EX)
                # Closing the file is not enough if a child process was forked in the meantime.
                held.callback(fcntl.flock, file, fcntl.LOCK_UN)
            yield
    finally:
        with contextlib.suppress(OSError):
            path.unlink()


def _cache_folder() -> Path:
    """Return the cache folder, created if missing; raise OSError if that fails."""
    import platformdirs

    own = os.environ.get("STEWART_SYM_CACHE")
    folder = Path(own or platformdirs.user_cache_dir("stewart-sym", appauthor=False)).absolute()
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def _compile(folder: Path, name: str, sources: Mapping[str, str], command: tuple[str, ...]) -> Path:
    for flag in _REJECTED.intersection(command):
        raise ValueError(f"CC: {flag} changes the arithmetic of the whole process; remove the flag")
    for file, text in sources.items():
        (folder / file).write_text(text, encoding="utf-8", newline="\n")
    library = folder / f"{name}{_SUFFIX}"
    # Relative file names avoid blanks and non-ASCII characters of the home folder.
    files = sorted(file for file in sources if file.endswith(".c"))
    libraries = () if sys.platform == "win32" else ("-lm",)
    try:
        ran((*command, *files, "-o", library.name, *libraries), folder)
    except CompilerError as error:
        if _NATIVE not in command:
            raise CompilerError(f"can't compile {name}: {error}", error.log) from error
        # Some compilers do not support the flag, or the assembler does not support the instructions.
        return _compile(folder, name, sources, tuple(word for word in command if word != _NATIVE))
    return library
