"""Environment of a study: processor, system, compiler, versions, and the load of other processes."""

import contextlib
import os
import platform
import time
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from typing import Any

from ...backend import native

_VECTORS = ("avx512f", "avx2", "asimd")
"""Instruction sets that indicate the widest vector registers, widest first."""

DISTURBED = 0.03
"""Fraction of the core time of other processes above which times are reported as disturbed."""


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


def taken_by_others() -> Callable[[], float | None]:
    """Return a function of the fraction of core time that other processes use from now on, or of None."""
    start, before = time.perf_counter(), _work_of_others()

    def share() -> float | None:
        seconds, after = time.perf_counter() - start, _work_of_others()
        if before is None or after is None or seconds <= 0:
            return None
        return min(1.0, max(0.0, (after - before) / ((os.cpu_count() or 1) * seconds)))

    return share


def _work_of_others() -> float | None:
    """Return the core seconds since system start, without this process and its children."""
    with contextlib.suppress(OSError, ValueError):
        first, *_ = Path("/proc/stat").read_text(encoding="utf-8").splitlines()
        # user, nice, system, idle, waiting for a disk, two kinds of interrupts, stolen by the hypervisor
        user, nice, system, _, _, hard, soft, stolen = map(int, first.split()[1:9])
        ticks = user + nice + system + hard + soft + stolen
        return ticks / os.sysconf("SC_CLK_TCK") - sum(os.times()[:4])
    return None


def _cpuinfo(line: str) -> str:
    with contextlib.suppress(OSError):
        for text in Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace").splitlines():
            name, _, value = text.partition(":")
            if name.strip() in (line, {"flags": "Features"}.get(line)):
                return value.strip()
    return ""
