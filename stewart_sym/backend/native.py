"""Compiles C source text into a shared library once, keeps it in a cache and loads it with ctypes.

A library is published by one rename, and its file name holds the digest of its bytes, which is checked before
the loader maps it: the cache is sound without a lock between processes, which only keeps them from compiling
the same at once.
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
"""Seconds that one run of the compiler may take."""

_VERSION_TIMEOUT = 60.0
_STALE_SECONDS = 24 * 3600.0

_NATIVE = "-march=native"
# Code on Windows is position independent anyway, and clang rejects the flag there.
_POSITION = () if sys.platform == "win32" else ("-fPIC",)
FLAGS = ("-O3", "-std=c99", *_POSITION, "-shared", "-fno-math-errno", "-ffp-contract=off", _NATIVE)
"""Of the compiler, for every library of this machine."""

PORTABLE_FLAGS = (
    *("-O2", "-std=c99", *_POSITION, "-shared", "-fvisibility=hidden"),
    *("-fno-math-errno", "-ffp-contract=off"),
)
"""For a library that is given away: it runs on any processor of this kind, and shows only what it exports."""
# A library linked with one of these switches the whole process to flush-to-zero.
_REJECTED = frozenset({"-Ofast", "-ffast-math", "-funsafe-math-optimizations"})
_SUFFIX = {"win32": ".dll", "darwin": ".dylib"}.get(sys.platform, ".so")

# The lines of /proc/cpuinfo that name the model and its instruction sets (x86; Arm; RISC-V; POWER).
_PROCESSOR_LINES = frozenset(
    {"vendor_id", "cpu family", "model", "model name", "stepping", "flags"}
    | {"Features", "CPU implementer", "CPU architecture", "CPU variant", "CPU part"}
    | {"isa", "uarch", "mvendorid", "marchid", "cpu"}
)

_loaded: dict[str, ctypes.CDLL] = {}
_turns: dict[str, threading.Lock] = {}
_lock = threading.Lock()
# A child forked while a compiler starts would hold its pipes open, and their end is waited for.
_starting = threading.RLock()


def _renew_locks() -> None:
    """Give a forked child locks of its own: the threads that owned them are not in it."""
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
    """No library could be built or loaded; one line. ``log`` is all that the compiler printed, or empty."""

    def __init__(self, message: str, log: str = "") -> None:
        """Fold ``message`` into one line."""
        super().__init__(" ".join(message.split()))
        self.log = log


@dataclass(frozen=True)
class Compiler:
    """A C compiler that answered: ``command`` as run, program first, and the first line of its version."""

    command: tuple[str, ...]
    version: str


def find_compiler() -> Compiler | None:
    """Return the first that works of ``$CC``, cc, gcc, clang and the ``ziglang`` wheel, or None.

    ``$CC`` may hold arguments. If it is set and does not work, nothing else is tried: CompilerError.
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
    """Return the shared library made of ``sources``, compiled only if no cache holds it.

    name: letters, digits and underscores; begins the library's file name and stands in errors.
    sources: file name -> text; ``.c`` files are compiled, ``.h`` files lie beside them.
    flags: added after the default flags. defines: macro -> value.

    The cache is ``$STEWART_SYM_CACHE``, else the user's cache folder; one that can't be written, or that
    others may write, is replaced by a temporary folder, with a RuntimeWarning. Calls into the library
    release the interpreter lock. Loading the same thing again returns the same object.

    Raises CompilerError if there is no compiler, or it fails; ValueError for a flag that is rejected.
    """
    recipe = _recipe(name, sources, flags, defines)
    key = recipe.key()
    with _lock:
        # One compiler for each library, so that threads can have several compiled side by side.
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
    """Compile as ``load`` does, but anew, into ``folder``, past the cache; returns the library, not loaded.

    base: the flags before ``flags``, FLAGS or PORTABLE_FLAGS. Raises as ``load`` does.
    """
    return _compile(folder, _recipe(name, sources, flags, None, base))


def ran(command: Sequence[str], folder: Path) -> str:
    """Run a compiler or one of its tools in ``folder``; returns what it printed.

    Raises CompilerError if it fails, takes longer than COMPILE_TIMEOUT or does not start.
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
        raise CompilerError("no C compiler found: install gcc or clang, set CC, or `pip install ziglang`")
    macros = tuple(f"-D{macro}={value}" for macro, value in sorted((defines or {}).items()))
    return _Recipe(name, dict(sources), compiler, (*base, *macros, *flags))


@dataclass(frozen=True)
class _Recipe:
    """All that decides what the library will be."""

    name: str
    sources: dict[str, str]
    compiler: Compiler
    flags: tuple[str, ...]

    def __post_init__(self) -> None:
        for where, words in (("CC", self.compiler.command), ("flags", self.flags)):
            for flag in _REJECTED.intersection(words):
                raise ValueError(
                    f"{where}: {flag} is rejected, it changes the arithmetic of the whole process"
                )

    def key(self) -> str:
        # Native code runs only on processors like this one, hence the processor.
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
    """First line of ``--version``; CompilerError, which is not remembered, if the command does not run."""
    try:
        with tempfile.TemporaryDirectory(prefix="stewart-sym-", ignore_cleanup_errors=True) as folder:
            code, output = _run((*command, "--version"), _VERSION_TIMEOUT, Path(folder))
    except (OSError, subprocess.TimeoutExpired) as error:
        raise CompilerError(f"{command[0]} does not run: {error}") from error
    if code != 0:
        raise CompilerError(f"{command[0]} --version fails: {_first_error(output)}", output)
    return output.strip().partition("\n")[0]


def _run(command: Sequence[str], timeout: float, folder: Path) -> tuple[int, str]:
    """Exit code and output; runs in ``folder``, which also takes the compiler's own temporary files."""
    # Messages in English, so that the first error can be found in them.
    env = {"PATH": os.defpath, **os.environ, "LC_ALL": "C"}
    env |= dict.fromkeys(("TMPDIR", "TMP", "TEMP", "ZIG_LOCAL_CACHE_DIR"), str(folder))
    # Zig's own choice is below the home folder, and it does not run at all where that can't be written.
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
    # The driver's own children (cc1, ld) must go as well: they are of its process group.
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
    """Model and instruction sets of this machine's processors."""
    machine = f"{sys.platform} {platform.machine()} {sys.maxsize}"
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace")
    except OSError:
        return f"{machine} {platform.processor()} {_mac_processor()}"
    lines = {line for line in text.splitlines() if line.partition(":")[0].strip() in _PROCESSOR_LINES}
    return "\n".join([machine, *sorted(lines)])


def _mac_processor() -> str:
    # platform.processor() says only "arm" or "i386" there.
    if sys.platform == "darwin":
        question = ("/usr/sbin/sysctl", "-n", "machdep.cpu.brand_string")
        with contextlib.suppress(OSError, subprocess.TimeoutExpired):
            return _run(question, _VERSION_TIMEOUT, Path("/"))[1]
    return ""


# --- the cache --------------------------------------------------------------------------------


def _open(recipe: _Recipe, key: str) -> ctypes.CDLL:
    # Also a library that is sound but does not load (a folder mounted noexec) ends in the temporary folder.
    try:
        return _open_in(_cache_directory(), recipe, key)
    except OSError as error:
        fault = error
    try:
        # A library needs no file once it is loaded; where it does (Windows), the folder stays behind.
        with tempfile.TemporaryDirectory(prefix="stewart-sym-", ignore_cleanup_errors=True) as folder:
            library = _open_in(Path(folder), recipe, key)
    except OSError as error:
        raise CompilerError(
            f"the compiled library {recipe.name} can't be stored or loaded: {error}"
        ) from error
    warnings.warn(
        "compiled libraries are kept for this process alone, expected $STEWART_SYM_CACHE to name a folder "
        f"that you alone may write: {fault}",
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
    """Wait until no other process builds the same, where the system and the folder have such locks."""
    with contextlib.ExitStack() as held:
        with contextlib.suppress(ImportError, OSError):
            import fcntl

            path = directory / f"build-{key}.lock"
            # Of the process, so that a forked child does not wait for itself, and gone when it dies.
            fcntl.lockf(held.enter_context(path.open("w")), fcntl.LOCK_EX)
            held.callback(path.unlink, missing_ok=True)
            # Of processes that were killed while they held it.
            for left in directory.glob(f"build-{key}-*"):
                shutil.rmtree(left, ignore_errors=True)
        yield


def _cache_directory() -> Path:
    """The cache folder, made if missing; OSError if it can't be used or is not this user's alone."""
    try:
        directory = _cache_location()
    except RuntimeError as error:  # pathlib found no home
        raise FileNotFoundError(str(error)) from error
    directory.mkdir(mode=0o700, parents=True, exist_ok=True)
    directory = directory.resolve()
    if not _is_ours(directory.stat()):
        raise PermissionError(f"{directory} belongs to, or may be written by, somebody else")
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
    """Whether this user owns it and nobody else may write it."""
    if sys.platform == "win32":
        return True
    return status.st_uid == os.geteuid() and not status.st_mode & (stat.S_IWGRP | stat.S_IWOTH)


def _find(directory: Path, stem: str) -> Path | None:
    """The cached library whose bytes agree with its name: mapping a truncated one could kill the process."""
    for path in sorted(directory.glob(f"{stem}-*{_SUFFIX}")):
        with contextlib.suppress(OSError):
            status = path.lstat()
            if stat.S_ISREG(status.st_mode) and _is_ours(status) and path.stem == f"{stem}-{_digest(path)}":
                return path
    return None


def _digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()[:32]


def _build(directory: Path, recipe: _Recipe, key: str) -> Path:
    """Compile in a folder of its own and publish by one rename, over a damaged file if there is one."""
    # What killed processes left behind goes.
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
        # Some compilers do not know the flag, or the assembler not the instructions.
        portable = tuple(flag for flag in recipe.flags if flag != _NATIVE)
        code, log = _run_compiler(folder, recipe, portable, library.name)
    if code != 0:
        raise CompilerError(f"{_program(recipe)} can't compile {recipe.name}: {_first_error(log)}", log)
    if not library.is_file():
        raise CompilerError(f"{_program(recipe)} compiled {recipe.name} but wrote no library", log)
    return library


def _run_compiler(folder: Path, recipe: _Recipe, flags: Sequence[str], output: str) -> tuple[int, str]:
    # Bare file names: no compiler gets to see spaces or foreign letters of the home folder.
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
