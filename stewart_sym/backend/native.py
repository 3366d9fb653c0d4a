"""Compiler of C source text into a shared library, which is cached and loaded with ctypes.

A library is published by one rename. Its file name contains the digest of its bytes, which is verified before
the library is loaded. The cache is therefore consistent without a lock between processes; the lock only
prevents simultaneous compilation of the same library.
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
import signal
import stat
import subprocess
import sys
import tempfile
import threading
import time
import warnings
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

COMPILE_TIMEOUT = 300.0
"""Longest duration of one compiler run (s)."""

_VERSION_TIMEOUT = 60.0
_STALE_SECONDS = 24 * 3600.0

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

# Lines of /proc/cpuinfo with the model and its instruction sets (x86, Arm, RISC-V, POWER).
_PROCESSOR_LINES = frozenset(
    {"vendor_id", "cpu family", "model", "model name", "stepping", "flags"}
    | {"Features", "CPU implementer", "CPU architecture", "CPU variant", "CPU part"}
    | {"isa", "uarch", "mvendorid", "marchid", "cpu"}
)

_loaded: dict[str, ctypes.CDLL] = {}
_turns: dict[str, threading.Lock] = {}
_lock = threading.Lock()
# A child process that is forked while a compiler starts would inherit its pipes, and the parent would wait
# for their end.
_starting = threading.RLock()


def _renew_locks() -> None:
    """Create new locks in a forked child, because the threads that own the old locks do not exist there."""
    global _lock, _starting
    _lock, _starting = threading.Lock(), threading.RLock()
    _turns.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(
        before=lambda: _starting.acquire(),
        after_in_parent=lambda: _starting.release(),
        after_in_child=_renew_locks,
    )


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

    The cache is ``$STEWART_SYM_CACHE``, otherwise the cache folder of the user. A cache that is read-only, or
    that other users may write, is replaced by a temporary folder with a RuntimeWarning. Calls into the
    library release the interpreter lock. A repeated call returns the same object.

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
    recipe = _recipe(name, sources, flags, defines)
    key = recipe.key()
    with _lock:
        # One lock for each library, so that threads can compile several libraries simultaneously.
        turn = _turns.setdefault(key, threading.Lock())
    with turn:
        if key not in _loaded:
            _loaded[key] = _open(recipe, key)
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
    return _compile(folder, _recipe(name, sources, flags, None, base))


def ran(command: Sequence[str], folder: Path) -> str:
    """Run a compiler or one of its tools in ``folder``; return its output.

    Raises CompilerError if it fails, exceeds COMPILE_TIMEOUT, or does not start.
    """
    try:
        code, output = _run(command, COMPILE_TIMEOUT, folder)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise CompilerError(f"{command[0]} does not run: {error}") from error
    if code != 0:
        raise CompilerError(f"{command[0]} fails: {_first_error(output)}", output)
    return output


def _recipe(
    name: str,
    sources: Mapping[str, str],
    flags: Sequence[str],
    defines: Mapping[str, str | int] | None,
    base: Sequence[str] = FLAGS,
) -> "_Recipe":
    compiler = find_compiler()
    if compiler is None:
        raise CompilerError("no C compiler found; install gcc or clang, set CC, or run `pip install ziglang`")
    macros = tuple(f"-D{macro}={value}" for macro, value in sorted((defines or {}).items()))
    return _Recipe(name, dict(sources), compiler, (*base, *macros, *flags))


@dataclass(frozen=True)
class _Recipe:
    """All inputs that determine a library."""

    name: str
    sources: dict[str, str]
    compiler: Compiler
    flags: tuple[str, ...]

    def __post_init__(self) -> None:
        for where, words in (("CC", self.compiler.command), ("flags", self.flags)):
            for flag in _REJECTED.intersection(words):
                raise ValueError(
                    f"{where}: {flag} changes the arithmetic of the whole process; remove the flag"
                )

    def key(self) -> str:
        # Native code runs only on processors of the same kind, so the key includes the processor.
        parts = [
            self.name,
            sorted(self.sources.items()),
            self.compiler.command,
            self.compiler.version,
            self.flags,
            _processor(),
        ]
        return hashlib.sha256(json.dumps(parts).encode()).hexdigest()[:32]


# --- compilers --------------------------------------------------------------------------------


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
    """Return the first line of ``--version``; raise CompilerError, uncached, if the command fails."""
    try:
        with tempfile.TemporaryDirectory(prefix="stewart-sym-", ignore_cleanup_errors=True) as folder:
            code, output = _run((*command, "--version"), _VERSION_TIMEOUT, Path(folder))
    except (OSError, subprocess.TimeoutExpired) as error:
        raise CompilerError(f"{command[0]} does not run: {error}") from error
    if code != 0:
        raise CompilerError(f"{command[0]} --version fails: {_first_error(output)}", output)
    return output.strip().partition("\n")[0]


def _run(command: Sequence[str], timeout: float, folder: Path) -> tuple[int, str]:
    """Run a command in ``folder``, also for temporary files; return the exit code and the output."""
    # The first error is recognized only in English messages.
    env = {"PATH": os.defpath, **os.environ, "LC_ALL": "C"}
    env |= dict.fromkeys(("TMPDIR", "TMP", "TEMP", "ZIG_LOCAL_CACHE_DIR"), str(folder))
    # Zig's default is below the home folder, and Zig does not run if that folder is read-only.
    env.setdefault("ZIG_GLOBAL_CACHE_DIR", str(folder))
    with _starting:
        process = subprocess.Popen(
            command,
            cwd=folder,
            env=env,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
            errors="replace",
            process_group=0,
        )
    with process:
        try:
            output, _ = process.communicate(timeout=timeout)
        except BaseException:
            _kill(process)
            raise
    return process.returncode, output


def _kill(process: subprocess.Popen[str]) -> None:
    # The children of the driver (cc1, ld) are in its process group and must be terminated too.
    if sys.platform == "win32":
        process.kill()
    else:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)


def _first_error(log: str) -> str:
    lines = [line.strip() for line in log.splitlines() if line.strip()]
    errors = [line for line in lines if "error:" in line]
    return (errors or lines or ["it printed nothing"])[0]


@functools.cache
def _processor() -> str:
    """Describe the model and the instruction sets of the processors of this machine."""
    machine = f"{sys.platform} {platform.machine()} {sys.maxsize}"
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace")
    except OSError:
        return f"{machine} {platform.processor()} {_mac_processor()}"
    lines = {line for line in text.splitlines() if line.partition(":")[0].strip() in _PROCESSOR_LINES}
    return "\n".join([machine, *sorted(lines)])


def _mac_processor() -> str:
    # platform.processor() returns only "arm" or "i386" on macOS.
    if sys.platform == "darwin":
        question = ("/usr/sbin/sysctl", "-n", "machdep.cpu.brand_string")
        with contextlib.suppress(OSError, subprocess.TimeoutExpired):
            return _run(question, _VERSION_TIMEOUT, Path("/"))[1]
    return ""


# --- the cache --------------------------------------------------------------------------------


def _open(recipe: _Recipe, key: str) -> ctypes.CDLL:
    # A valid library that does not load (a folder mounted noexec) is also rebuilt in the temporary folder.
    try:
        return _open_in(_cache_directory(), recipe, key)
    except OSError as error:
        fault = error
    try:
        # A loaded library requires no file, except on Windows, where the folder remains.
        with tempfile.TemporaryDirectory(prefix="stewart-sym-", ignore_cleanup_errors=True) as folder:
            library = _open_in(Path(folder), recipe, key)
    except OSError as error:
        raise CompilerError(
            f"the compiled library {recipe.name} can't be stored or loaded: {error}"
        ) from error
    warnings.warn(
        f"compiled libraries are kept for this process alone ({fault}); set STEWART_SYM_CACHE to a folder "
        "that only you may write",
        RuntimeWarning,
        stacklevel=2,
    )
    return library


def _open_in(directory: Path, recipe: _Recipe, key: str) -> ctypes.CDLL:
    stem = f"{recipe.name}-{key}"
    library = _find(directory, stem)
    if library is None:
        with _turn_of_process(directory, key):
            library = _find(directory, stem) or _build(directory, recipe, key)
    return ctypes.CDLL(str(library))


@contextlib.contextmanager
def _turn_of_process(directory: Path, key: str) -> Iterator[None]:
    """Wait until no other process builds the same library, if the system and the folder support locks."""
    with contextlib.ExitStack() as held:
        with contextlib.suppress(ImportError, OSError):
            import fcntl

            path = directory / f"build-{key}.lock"
            # The lock belongs to the process: a forked child does not wait for itself, and the lock ends with
            # the process.
            fcntl.lockf(held.enter_context(path.open("w")), fcntl.LOCK_EX)
            held.callback(path.unlink, missing_ok=True)
            # These folders are from processes that were killed while they had the lock.
            for left in directory.glob(f"build-{key}-*"):
                shutil.rmtree(left, ignore_errors=True)
        yield


def _cache_directory() -> Path:
    """Return the cache folder, created if missing; raise OSError if it is unusable or not exclusive."""
    try:
        directory = _cache_location()
    except RuntimeError as error:  # pathlib found no home
        raise FileNotFoundError(str(error)) from error
    directory.mkdir(mode=0o700, parents=True, exist_ok=True)
    directory = directory.resolve()
    if not _is_ours(directory.stat()):
        raise PermissionError(f"{directory} is owned or writable by another user")
    return directory


def _cache_location() -> Path:
    own = os.environ.get("STEWART_SYM_CACHE")
    if own:
        return Path(own).absolute()
    xdg = os.environ.get("XDG_CACHE_HOME", "")
    if os.path.isabs(xdg):
        return Path(xdg) / "stewart-sym"
    if sys.platform == "win32":
        local = os.environ.get("LOCALAPPDATA")
        return (Path(local) if local else Path.home() / "AppData" / "Local") / "stewart-sym" / "Cache"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "stewart-sym"
    return Path.home().absolute() / ".cache" / "stewart-sym"


def _is_ours(status: os.stat_result) -> bool:
    """Return True if this user owns the file and no other user may write it."""
    if sys.platform == "win32":
        return True
    return status.st_uid == os.geteuid() and not status.st_mode & (stat.S_IWGRP | stat.S_IWOTH)


def _find(directory: Path, stem: str) -> Path | None:
    """Return the cached library whose bytes match its name; a truncated one could kill the process."""
    for path in sorted(directory.glob(f"{stem}-*{_SUFFIX}")):
        with contextlib.suppress(OSError):
            status = path.lstat()
            if stat.S_ISREG(status.st_mode) and _is_ours(status) and path.stem == f"{stem}-{_digest(path)}":
                return path
    return None


def _digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()[:32]


def _build(directory: Path, recipe: _Recipe, key: str) -> Path:
    """Compile in a temporary folder, and publish by one rename, which also replaces a damaged file."""
    # Remove files of killed processes.
    for left in directory.glob("build-*"):
        with contextlib.suppress(OSError):
            if time.time() - left.stat().st_mtime > _STALE_SECONDS:
                if left.is_dir():
                    shutil.rmtree(left)
                else:
                    left.unlink()
    with tempfile.TemporaryDirectory(
        prefix=f"build-{key}-", dir=directory, ignore_cleanup_errors=True
    ) as folder:
        library = _compile(Path(folder), recipe)
        library.chmod(0o700)
        published = directory / f"{recipe.name}-{key}-{_digest(library)}{_SUFFIX}"
        os.replace(library, published)
    return published


def _compile(folder: Path, recipe: _Recipe) -> Path:
    for file, text in recipe.sources.items():
        (folder / file).write_text(text, encoding="utf-8", newline="\n")
    library = folder / f"{recipe.name}{_SUFFIX}"
    code, log = _run_compiler(folder, recipe, recipe.flags, library.name)
    if code != 0 and _NATIVE in recipe.flags:
        # Some compilers do not support the flag, or the assembler does not support the instructions.
        portable = tuple(flag for flag in recipe.flags if flag != _NATIVE)
        code, log = _run_compiler(folder, recipe, portable, library.name)
    if code != 0:
        raise CompilerError(f"{_program(recipe)} can't compile {recipe.name}: {_first_error(log)}", log)
    if not library.is_file():
        raise CompilerError(f"{_program(recipe)} compiled {recipe.name} but wrote no library", log)
    return library


def _run_compiler(folder: Path, recipe: _Recipe, flags: Sequence[str], output: str) -> tuple[int, str]:
    # Relative file names avoid blanks and non-ASCII characters of the home folder.
    files = sorted(file for file in recipe.sources if file.endswith(".c"))
    libraries = () if sys.platform == "win32" else ("-lm",)
    command = (*recipe.compiler.command, *flags, *files, "-o", output, *libraries)
    try:
        return _run(command, COMPILE_TIMEOUT, folder)
    except subprocess.TimeoutExpired as error:
        message = f"{_program(recipe)} took longer than {COMPILE_TIMEOUT:g} s to compile {recipe.name}"
        raise CompilerError(message) from error


def _program(recipe: _Recipe) -> str:
    return shlex.join(recipe.compiler.command)
