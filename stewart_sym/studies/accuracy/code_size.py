"""Code size of a kernel on a controller."""

import functools
import shutil
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from ...backend import c_kernel, native

FLAGS = ("-O2", "-std=c99", "-fno-math-errno", "-ffunction-sections")
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


def code_size(name: str, precision: str = "double") -> int | None:
    """Measure the code size (bytes) of a program that prepares the constants and computes one pose.

    The program is linked without uncalled functions, and the functions of an empty program are subtracted.
    Returns None on systems without ELF, without ``nm``, and with a linker without ``--gc-sections``. Raises
    native.CompilerError without a compiler.
    """
    compiler = native.find_compiler()
    if compiler is None:
        raise native.CompilerError("no C compiler found")
    if sys.platform in ("win32", "darwin"):
        return None
    flags = (*FLAGS, "-DSTEWART_FLOAT") if precision == "float" else FLAGS
    sources = {**c_kernel.c_sources(f"{name}_forces"), "main.c": _PROGRAM.format(name=name)}
    try:
        functions, empty = _functions(compiler, sources, flags), _empty_functions(compiler)
    except (native.CompilerError, FileNotFoundError):
        return None
    return sum(size for name, size in functions.items() if name not in empty)


@functools.cache
def _empty_functions(compiler: native.Compiler) -> dict[str, int]:
    return _functions(compiler, {"main.c": _EMPTY}, FLAGS)


def _functions(compiler: native.Compiler, sources: Mapping[str, str], flags: Sequence[str]) -> dict[str, int]:
    """Return the size of every function (bytes) in the program of the sources."""
    with TemporaryDirectory(prefix="stewart-sym-", ignore_cleanup_errors=True) as name:
        folder = Path(name)
        nm = shutil.which("nm") or shutil.which("llvm-nm")
        if nm is None:
            raise FileNotFoundError("nm")
        for file, text in sources.items():
            (folder / file).write_text(text, encoding="utf-8", newline="\n")
        files = sorted(file for file in sources if file.endswith(".c"))
        native.ran((*compiler.command, *flags, *_LINK_FLAGS, *files, "-o", "program", "-lm"), folder)
        # Lines contain address, size, kind, and name; other lines have no size.
        rows = [line.split() for line in native.ran((nm, "-S", "program"), folder).splitlines()]
        return {row[3]: int(row[1], 16) for row in rows if len(row) == 4 and row[2] in "tTwW"}
