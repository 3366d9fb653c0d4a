"""Compilation of C sources into a shared library, which is cached and loaded with ctypes.

A library is compiled in a temporary folder and published by one rename, so that no process loads an
unfinished file. The lock only prevents simultaneous compilation of the same library.
"""

import contextlib
import ctypes
import functools
import hashlib
import importlib.util
import json
import os
import platform
import shlex
import shutil
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

COMPILE_TIMEOUT = 300.0
"""Longest duration of one compiler run (s)."""

_NATIVE = "-march=native"
# Code on Windows is always position independent, and clang rejects the flag there.
_POSITION = () if sys.platform == "win32" else ("-fPIC",)
FLAGS = ("-O3", "-std=c99", *_POSITION, "-shared", "-fno-math-errno", "-ffp-contract=off", _NATIVE)
"""Compiler flags of libraries for this machine."""

PORTABLE_FLAGS = (
    *("-O2", "-std=c99", *_POSITION, "-shared", "-fvisibility=hidden"),
    *("-fno-math-errno", "-ffp-contract=off"),
)
"""Compiler flags of libraries that are distributed: any processor of the same architecture, exported symbols
only.
"""
# A library linked with one of these switches the whole process to flush-to-zero.
_REJECTED = frozenset({"-Ofast", "-ffast-math", "-funsafe-math-optimizations"})
_SUFFIX = {"win32": ".dll", "darwin": ".dylib"}.get(sys.platform, ".so")

# Names of the lines of /proc/cpuinfo with the model and its instruction sets (x86, Arm, RISC-V, POWER).
_PROCESSOR_LINES = ("model", "flags", "Features", "CPU", "isa", "uarch", "cpu\t")

_loaded: dict[str, ctypes.CDLL] = {}


class CompilerError(RuntimeError):
    """Error of building or loading a library, in one line; ``log`` is the output of the compiler, or
    empty.
    """

    def __init__(self, message: str, log: str = "") -> None:
        """Join the lines of ``message``."""
        super().__init__(" ".join(message.split()))
        self.log = log


@dataclass(frozen=True)
class Compiler:
    """Working C compiler: ``command`` begins with the program, ``version`` is the first line of its
    version.
    """

    command: tuple[str, ...]
    version: str


@dataclass(frozen=True)
class _Recipe:
    """All inputs that determine a library."""

    name: str
    sources: dict[str, str]
    compiler: Compiler
    flags: tuple[str, ...]

    @property
    def key(self) -> str:
        compiler = (self.compiler.command, self.compiler.version)
        # Native code runs only on processors of the same kind.
        parts = [self.name, sorted(self.sources.items()), compiler, self.flags, _processor()]
        return hashlib.sha256(json.dumps(parts).encode()).hexdigest()[:32]


def find_compiler() -> Compiler | None:
    """Return the first working compiler of ``$CC``, cc, gcc, clang, and the ``ziglang`` wheel, or None.

    ``$CC`` may contain arguments. If it is set and does not work, CompilerError is raised.
    """
    requested = os.environ.get("CC", "").strip()
    if requested:
        return _requested_compiler(requested)
    for command in _candidates():
        with contextlib.suppress(CompilerError):
            return Compiler(command, _version(command))
    return None


def load(
    name: str,
    sources: Mapping[str, str],
    flags: Sequence[str] = (),
    defines: Mapping[str, str | int] | None = None,
) -> ctypes.CDLL:
    """Load the shared library of ``sources``, compiled only if the cache does not contain it.

    The cache is ``$STEWART_SYM_CACHE``, otherwise the cache folder of the user. If it cannot be written, a
    temporary folder replaces it with a RuntimeWarning. Calls into the library release the interpreter lock. A
    repeated call returns the same object.

    Parameters
    ----------
    name : str
        Letters, digits, and underscores; start of the file name of the library, and its name in errors.
    sources : mapping of str to str
        Text by file name; ``.c`` files are compiled, ``.h`` files are in the same folder.
    flags : sequence of str
        Compiler flags after the default flags.
    defines : mapping of str to str or int, optional
        Values of macros.

    Returns
    -------
    ctypes.CDLL
        Loaded library.

    Raises
    ------
    CompilerError
        If there is no compiler, or it fails.
    ValueError
        If a flag changes the floating-point arithmetic of the process.
    """
    macros = [f"-D{macro}={value}" for macro, value in sorted((defines or {}).items())]
    recipe = _recipe(name, sources, (*FLAGS, *macros, *flags))
    key = recipe.key
    if key not in _loaded:
        # Threads that load the same library at the same time receive the same object.
        _loaded.setdefault(key, _open(recipe, f"{name}-{key}{_SUFFIX}"))
    return _loaded[key]


def compiled(
    folder: Path,
    name: str,
    sources: Mapping[str, str],
    flags: Sequence[str] = (),
    base: Sequence[str] = FLAGS,
) -> Path:
    """Compile into ``folder`` without the cache; return the path of the library, which is not loaded.

    ``base`` contains the flags before ``flags``, FLAGS or PORTABLE_FLAGS. Raises the errors of ``load``.
    """
    return _compile(folder, _recipe(name, sources, (*base, *flags)))


def ran(command: Sequence[str], folder: Path) -> str:
    """Run a compiler or one of its tools in ``folder``; return its output.

    Raises CompilerError if it fails, exceeds COMPILE_TIMEOUT, or does not start.
    """
    # The first error is recognized only in English messages.
    env = {"PATH": os.defpath, **os.environ, "LC_ALL": "C"}
    env |= dict.fromkeys(("TMPDIR", "TMP", "TEMP", "ZIG_LOCAL_CACHE_DIR"), str(folder))
    # Zig's default is below the home folder, and Zig does not run if that folder is read-only.
    env.setdefault("ZIG_GLOBAL_CACHE_DIR", str(folder))
    try:
        done = subprocess.run(
            command,
            cwd=folder,
            env=env,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
            errors="replace",
            timeout=COMPILE_TIMEOUT,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise CompilerError(f"{command[0]} does not run: {error}") from error
    if done.returncode != 0:
        lines = [line.strip() for line in done.stdout.splitlines() if line.strip()]
        errors = [line for line in lines if "error:" in line]
        first = (errors or lines or ["it printed nothing"])[0]
        raise CompilerError(f"{command[0]} fails: {first}", done.stdout)
    return done.stdout


def _recipe(name: str, sources: Mapping[str, str], flags: tuple[str, ...]) -> _Recipe:
    compiler = find_compiler()
    if compiler is None:
        raise CompilerError("no C compiler found; install gcc or clang, set CC, or run `pip install ziglang`")
    for where, words in (("CC", compiler.command), ("flags", flags)):
        for flag in _REJECTED.intersection(words):
            raise ValueError(f"{where}: {flag} changes the arithmetic of the whole process; remove the flag")
    return _Recipe(name, dict(sources), compiler, flags)


def _requested_compiler(requested: str) -> Compiler:
    try:
        words = shlex.split(requested, posix=sys.platform != "win32")
        program = shutil.which(words[0].strip('"'))
        if program is None:
            raise CompilerError(f"{words[0]} not found")
        command = (os.path.abspath(program), *words[1:])
        return Compiler(command, _version(command))
    except (ValueError, CompilerError) as error:
        raise CompilerError(f"CC={requested!r} is not a working C compiler: {error}") from error


def _candidates() -> Iterator[tuple[str, ...]]:
    for program in ("cc", "gcc", "clang"):
        path = shutil.which(program)
        if path is not None:
            yield (os.path.abspath(path),)
    if importlib.util.find_spec("ziglang") is not None:
        yield (sys.executable, "-m", "ziglang", "cc")


@functools.cache
def _version(command: tuple[str, ...]) -> str:
    """Return the first line of ``--version``; a failure raises CompilerError and is not cached."""
    with tempfile.TemporaryDirectory(prefix="stewart-sym-", ignore_cleanup_errors=True) as folder:
        return ran((*command, "--version"), Path(folder)).strip().partition("\n")[0]


@functools.cache
def _processor() -> str:
    """Describe the model and the instruction sets of the processors of this machine."""
    machine = f"{sys.platform} {platform.machine()} {platform.processor()} {sys.maxsize}"
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError:
        return machine
    return "\n".join([machine, *sorted({line for line in lines if line.startswith(_PROCESSOR_LINES)})])


def _open(recipe: _Recipe, file: str) -> ctypes.CDLL:
    try:
        return _open_in(_cache_folder(), recipe, file)
    except OSError as error:
        fault = error
    try:
        # A loaded library requires no file, except on Windows, where the folder remains.
        with tempfile.TemporaryDirectory(prefix="stewart-sym-", ignore_cleanup_errors=True) as folder:
            library = _open_in(Path(folder), recipe, file)
    except OSError as error:
        raise CompilerError(
            f"the compiled library {recipe.name} can't be stored or loaded: {error}"
        ) from error
    warnings.warn(
        f"compiled libraries are kept for this process alone ({fault}); set STEWART_SYM_CACHE to a folder "
        "that you may write",
        RuntimeWarning,
        stacklevel=3,
    )
    return library


def _open_in(folder: Path, recipe: _Recipe, file: str) -> ctypes.CDLL:
    library = folder / file
    if not library.exists():
        with _locked(folder / f"{file}.lock"):
            if not library.exists():
                with tempfile.TemporaryDirectory(dir=folder, ignore_cleanup_errors=True) as place:
                    os.replace(_compile(Path(place), recipe), library)
    return ctypes.CDLL(str(library))


@contextlib.contextmanager
def _locked(path: Path) -> Iterator[None]:
    """Hold the lock file of a library, if the system and the folder support locks.

    The lock of a killed process ends with the process. Two processes may rarely hold it together, which only
    repeats a compilation.
    """
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
    own = os.environ.get("STEWART_SYM_CACHE")
    if not own:
        import platformdirs

        own = platformdirs.user_cache_dir("stewart-sym", appauthor=False)
    folder = Path(own).absolute()
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def _compile(folder: Path, recipe: _Recipe) -> Path:
    for file, text in recipe.sources.items():
        (folder / file).write_text(text, encoding="utf-8", newline="\n")
    library = folder / f"{recipe.name}{_SUFFIX}"
    # Relative file names avoid blanks and non-ASCII characters of the home folder.
    files = sorted(file for file in recipe.sources if file.endswith(".c"))
    libraries = () if sys.platform == "win32" else ("-lm",)
    # Some compilers do not support the flag, or the assembler does not support the instructions.
    portable = tuple(flag for flag in recipe.flags if flag != _NATIVE)
    for flags in dict.fromkeys((recipe.flags, portable)):
        try:
            ran((*recipe.compiler.command, *flags, *files, "-o", library.name, *libraries), folder)
            break
        except CompilerError as error:
            fault = error
    else:
        raise CompilerError(f"can't compile {recipe.name}: {fault}", fault.log)
    if not library.is_file():
        raise CompilerError(f"{recipe.compiler.command[0]} compiled {recipe.name} but wrote no library")
    return library
