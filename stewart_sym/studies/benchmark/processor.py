"""Performance limits of the processor: clock, vector throughput, and the vector width of compiled code."""

import ctypes
import functools
import re
import shutil
import subprocess
from dataclasses import dataclass

from ...backend import native
from ..common.loops import own_source
from ..common.timing import Task

Flags = tuple[str, ...]

FUSED: Flags = ("-ffp-contract=fast",)
"""Flag that permits the compiler to fuse products and sums."""

_NO_AVX_512: Flags = ("-mno-avx512f",)


@dataclass(frozen=True)
class Target:
    """Instructions for which C is compiled: name, and flags after the common ones."""

    name: str
    flags: Flags = ()


@dataclass(frozen=True, eq=False)
class MultiplyAdd(Task):
    """Independent fused multiply-adds of single numbers at full vector width on one core.

    ``set`` is the name of the vector instructions, and ``lanes`` the count of numbers in a vector.
    """

    lanes: int
    set: str


def targets() -> tuple[Target, ...]:
    """Return all instructions of this processor, and, with AVX-512, also a target without it; raise
    CompilerError.
    """
    first = Target(multiply_add().set)
    if first.name != "AVX-512":
        return (first,)
    return first, Target(multiply_add(_NO_AVX_512).set, _NO_AVX_512)


def multiply_add(flags: Flags = ()) -> MultiplyAdd:
    """Compile the loop, with a product and a sum if the instruction is missing; raise CompilerError."""
    sources = {"multiply_add.c": own_source("multiply_add.c")}
    library = native.load("bench_multiply_add", sources, flags=(*FUSED, *flags))
    library.multiply_add.restype = ctypes.c_double
    library.multiply_add_set.restype = ctypes.c_char_p
    steps, lanes = 1_000, int(library.multiply_add_lanes())
    by, plus = ctypes.c_double(0.999), ctypes.c_double(1e-3)

    def run(repeats: int) -> None:
        library.multiply_add(ctypes.c_size_t(repeats * steps), by, plus)

    count = steps * lanes * int(library.multiply_add_chains())
    return MultiplyAdd(run, count, lanes, library.multiply_add_set().decode())


def additions() -> Task:
    """Compile a chain of dependent additions, one per cycle; raise CompilerError."""
    library = native.load("bench_additions", {"additions.c": own_source("additions.c")})
    steps, by = 1_000, ctypes.c_size_t(3)

    def run(repeats: int) -> None:
        library.additions(ctypes.c_size_t(repeats * steps), by)

    return Task(run, steps * int(library.additions_chain()))


# --- the width of compiled code ---------------------------------------------------------------

_FUNCTION = re.compile(r"^[0-9a-f]+ <([^>]+)>:$", re.MULTILINE)
_CALL = re.compile(r"\t(?:call|jmp)q?\s.*<([^>+]+?)(?:@plt)?>$", re.MULTILINE)
_PACKED = re.compile(r"\tv?(?:fn?m)?(?:add|sub|mul|div|sqrt)\w*p[sd]\s.*%([xyz])mm")
_BITS = {"x": 128, "y": 256, "z": 512}


def widest(library: ctypes.CDLL, function: str) -> int | None:
    """Return the width of the widest vectors (bits) of a function and its callees; 64 without vectors.

    Returns None if ``objdump`` is missing or does not list the function, or if the processor is not x86.
    """
    tool = shutil.which("objdump")
    bodies = _disassembled(tool, library._name) if tool else {}
    if function not in bodies:
        return None
    waiting, seen = [function], {function}
    width = 64
    while waiting:
        body = bodies.get(waiting.pop(), "")
        width = max((width, *(_BITS[letter] for letter in _PACKED.findall(body))))
        calls = set(_CALL.findall(body)) - seen
        seen |= calls
        waiting.extend(calls)
    return width


@functools.lru_cache(maxsize=4)
def _disassembled(tool: str, library: str) -> dict[str, str]:
    """Return the instructions of every function of a library; none if the tool fails or without x86."""
    command = [tool, "-d", "--no-show-raw-insn", library]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode or "x86-64" not in done.stdout:
        return {}
    _, *parts = _FUNCTION.split(done.stdout)
    bodies: dict[str, str] = {}
    for name, body in zip(parts[::2], parts[1::2], strict=True):
        bodies[name] = bodies.get(name, "") + body
    return bodies
