"""A compiler that writes down its calls, and a library that children load."""

import ctypes
import os
import shlex
import subprocess
import sys
from collections.abc import Callable, Mapping
from pathlib import Path

from stewart_sym.backend import native

ADD = {
    "adder.c": '#include "adder.h"\nint add(int a, int b) { return a + b; }\n',
    "adder.h": "int add(int a, int b);\n",
}

CHILD = f"""
from stewart_sym.backend import native
library = native.load("adder", {ADD!r})
assert library.add(2, 3) == 5
print(library._name)
"""

# Found before any test changes the environment.
COMPILER = native.find_compiler()

# Drops what lets root ignore permissions; for others there is nothing to drop.
CAP_DAC_OVERRIDE = 1
PR_CAPBSET_DROP = 24


def script(path: Path, text: str) -> Path:
    """A program of the shell."""
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)
    return path


class LoggedCompiler:
    """The machine's compiler behind a script that writes down each compilation: its arguments, or a note."""

    def __init__(self, folder: Path, before: str = "", name: str = "logged-cc", note: str = "$*") -> None:
        assert COMPILER is not None
        self._log = folder / f"{name}.log"
        log = f'case "$*" in *--version*) ;; *) echo "{note}" >> {shlex.quote(str(self._log))} ;; esac'
        self.path = script(folder / name, f'{before}\n{log}\nexec {shlex.join(COMPILER.command)} "$@"')

    @property
    def calls(self) -> list[str]:
        return self._log.read_text().splitlines() if self._log.exists() else []


def run_child(code: str = CHILD, setup: Callable[[], None] | None = None) -> Path:
    """Load the adder in a new process; the file that it was loaded from."""
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=600,
        preexec_fn=setup,
    )
    assert done.returncode == 0, done.stderr
    return Path(done.stdout.strip())


def obey_permissions() -> None:
    if os.geteuid() == 0:
        ctypes.CDLL(None).prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0)


def load_adder(flags: tuple[str, ...] = (), sources: Mapping[str, str] = ADD) -> ctypes.CDLL:
    library = native.load("adder", sources, flags)
    assert library.add(2, 3) == 5
    return library
