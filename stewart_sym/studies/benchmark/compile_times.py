"""Compilation times of the kernels, and code size on a controller."""

import functools
import shutil
import sys
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from ...backend import c_kernel, native
from ...io.progress import Progress, silent
from ..common.output import Figures
from .figures import NAME, sampled

COMPILED = (NAME, f"{NAME}_forces")
"""Kernels with timed compilation: all outputs, and the forces alone."""

SIZE_FLAGS = ("-O2", "-std=c99", "-fno-math-errno", "-ffunction-sections")
_LINK_FLAGS = ("-Wl,--gc-sections",)

_PROGRAM = """\
#include "stewart_{name}_forces.h"

int main(int count, char **words)
{{
    stewart_{name}_model model;
    stewart_real F[6];
    stewart_{name}_prepare((const stewart_robot *)(const void *)words[0], &model);
    return stewart_{name}_forces(&model, (const stewart_motion *)(const void *)words[count], F);
}}
"""
"""Program with the calls of a control loop, which is linked but never run."""

_EMPTY = "int main(void)\n{\n    return 0;\n}\n"


def compile_times(count: int, progress: Progress = silent) -> list[Figures]:
    """Measure the compilation time of each kernel (s), ``count`` times alternately, with the common compiler
    flags.

    Raises native.CompilerError.
    """
    raw: dict[str, list[float]] = {name: [] for name in COMPILED}
    for number in range(count):
        progress(f"compiling, {number + 1} of {count}", number / count)
        for name in COMPILED:
            raw[name].append(_seconds(name))
    return [sampled(source=f"stewart_{name}.c", raw=times) | {"unit": "s"} for name, times in raw.items()]


def _seconds(name: str) -> float:
    sources = c_kernel.c_sources(name)
    with _folder() as folder:
        start = time.perf_counter()
        native.compiled(Path(folder), f"stewart_{name}", sources)
        return time.perf_counter() - start


def text_size(name: str = NAME, defines: Sequence[str] = ()) -> Figures | None:
    """Measure the code size of the force functions in a program that prepares the constants and computes one
    pose.

    The program is linked without uncalled functions. ``nm`` reports the sizes (bytes), from which the
    functions of an empty program are subtracted. ``name`` is the kernel, and ``defines`` are macros.

    Returns None on systems without ELF, without ``nm``, and with a linker without ``--gc-sections``. Raises
    native.CompilerError without a compiler.
    """
    compiler = native.find_compiler()
    if compiler is None:
        raise native.CompilerError("no C compiler found")
    if sys.platform in ("win32", "darwin"):
        return None
    flags = (*SIZE_FLAGS, *(f"-D{macro}" for macro in defines))
    sources = {**c_kernel.c_sources(f"{name}_forces"), "main.c": _PROGRAM.format(name=name)}
    try:
        left, empty = _functions(compiler, sources, flags), _empty_functions(compiler)
    except (native.CompilerError, FileNotFoundError):
        return None
    functions = {name: size for name, size in left.items() if name not in empty}
    counted = {"source": f"stewart_{name}_forces.c", "flags": flags, "functions": functions}
    return {**counted, "unit": "bytes", "total": sum(functions.values())}


@functools.cache
def _empty_functions(compiler: native.Compiler) -> dict[str, int]:
    return _functions(compiler, {"main.c": _EMPTY}, SIZE_FLAGS)


def _functions(compiler: native.Compiler, sources: Mapping[str, str], flags: Sequence[str]) -> dict[str, int]:
    """Return the size of every function (bytes) in the program of the sources."""
    with _folder() as name:
        folder = Path(name)
        nm = _nm(compiler, folder)
        for file, text in sources.items():
            (folder / file).write_text(text, encoding="utf-8", newline="\n")
        files = sorted(file for file in sources if file.endswith(".c"))
        native.ran((*compiler.command, *flags, *_LINK_FLAGS, *files, "-o", "program", "-lm"), folder)
        # Lines contain address, size, kind, and name; other lines have no size.
        rows = [line.split() for line in native.ran((*nm, "-S", "program"), folder).splitlines()]
        return {row[3]: int(row[1], 16) for row in rows if len(row) == 4 and row[2] in "tTwW"}


def _nm(compiler: native.Compiler, folder: Path) -> Sequence[str]:
    """Find the ``nm`` of the compiler, or else of the system."""
    asked = native.ran((*compiler.command, "-print-prog-name=nm"), folder).strip()
    found = shutil.which(asked) or shutil.which("nm") or shutil.which("llvm-nm")
    if found is None:
        raise FileNotFoundError("nm")
    return (found,)


def _folder() -> "TemporaryDirectory[str]":
    return TemporaryDirectory(prefix="stewart-sym-", ignore_cleanup_errors=True)
