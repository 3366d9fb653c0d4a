"""Environment of a study: processor, system, compiler, and versions."""

import contextlib
import os
import platform
from importlib.metadata import version
from pathlib import Path
from typing import Any

from ...backend import native

_VECTORS = ("avx512f", "avx2", "asimd")
"""Instruction sets that indicate the widest vector registers, widest first."""


def machine() -> dict[str, Any]:
    """Describe the processor, its cores and widest vectors, the system, and its load."""
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
    """List the compiler, if any, its flags, and versions; raises native.CompilerError without a compiler."""
    compiler = native.require_compiler()
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
