"""Where a study ran: processor, system, compiler and versions, for reports of what was measured.

Knows nothing of what was measured.
"""

import contextlib
import os
import platform
from importlib.metadata import version
from pathlib import Path
from typing import Any

from .. import native

_VECTORS = ("avx512f", "avx2", "asimd")
"""Instruction sets that name the widest vectors, widest first."""


def machine() -> dict[str, Any]:
    """Processor, cores, widest vectors, system and its load."""
    sets = set(_cpuinfo("flags").split())
    return {
        "processor": _cpuinfo("model name") or platform.processor() or platform.machine(),
        "instruction_sets": sorted({*_VECTORS, "fma"} & sets),
        "architecture": platform.machine(),
        "vectors": next((name for name in _VECTORS if name in sets), ""),
        "cores": os.cpu_count(),
        "system": platform.platform(),
        "load_average": os.getloadavg() if hasattr(os, "getloadavg") else None,
    }


def software(*packages: str) -> dict[str, Any]:
    """Compiler, flags, Python, and versions of this package, NumPy and others.

    Raises native.CompilerError without a compiler.
    """
    compiler = native.find_compiler()
    if compiler is None:
        raise native.CompilerError("no C compiler found")
    return {
        "compiler": compiler.version,
        "command": list(compiler.command),
        "flags": list(native.FLAGS),
        "python": platform.python_version(),
        **{name: version(name) for name in ("stewart-sym", "numpy", *packages)},
    }


def _cpuinfo(line: str) -> str:
    with contextlib.suppress(OSError):
        for text in Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace").splitlines():
            name, _, value = text.partition(":")
            if name.strip() in (line, {"flags": "Features"}.get(line)):
                return value.strip()
    return ""
