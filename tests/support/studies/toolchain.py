"""The cross compiler, the emulator, and what can be read in object code."""

import re
import shutil
import subprocess
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from stewart_sym.backend.native import CompilerError

GCC, SIZE, NM, OBJDUMP = (f"arm-none-eabi-{tool}" for tool in ("gcc", "size", "nm", "objdump"))
QEMU = "qemu-system-arm"
PACKAGES: Mapping[str, str] = {
    GCC: "gcc-arm-none-eabi",
    **dict.fromkeys((SIZE, NM, OBJDUMP), "binutils-arm-none-eabi"),
    QEMU: "qemu-system-arm",
}
LIBRARY = "libnewlib-arm-none-eabi"
FLAGS = ("-std=c99", "-O2", "-fno-math-errno", "-mthumb", "-mfloat-abi=hard")
"""``-fno-math-errno``: a square root is one instruction, with no branch to a library for negative numbers."""
WARNINGS = ("-Wall", "-Wextra", "-pedantic", "-Wconversion", "-Wdouble-promotion", "-Werror")
SECONDS = 120
"""A run that takes longer hangs."""

HARMLESS = frozenset(
    {"sqrt", "sqrtf", "fabs", "fabsf", "memcpy", "memset", "memmove"}
    | {
        f"__aeabi_mem{subcommand}{width}"
        for subcommand in ("cpy", "set", "move", "clr")
        for width in ("", "4", "8")
    }
)
"""What a kernel may ask of a library."""
_SECTIONS = {"flash": (".text", ".rodata", ".vectors", ".data", ".ARM"), "ram": (".data", ".bss")}
_DOUBLE_HELPER = re.compile(r"__aeabi_(c?d|f2d|[iul]{1,2}2d)\w*|__\w+df\d?")


@dataclass(frozen=True)
class Core:
    """A processor: its name, the flags of the compiler, QEMU's board with it.

    With ``-ffp-contract=fast``, which is gcc's habit but for -std=c99, the compiler fuses products into sums.
    On the M4F that saves a fifth of the instructions; on the M7 in double it costs some, as gcc has to copy
    the sums first.
    """

    name: str
    flags: tuple[str, ...]
    board: str


CORES: Mapping[str, Core] = {
    "double": Core("Cortex-M7", ("-mcpu=cortex-m7", "-mfpu=fpv5-d16", "-ffp-contract=off"), "mps2-an500"),
    "float": Core("Cortex-M4F", ("-mcpu=cortex-m4", "-mfpu=fpv4-sp-d16", "-ffp-contract=fast"), "mps2-an386"),
}
"""By the arithmetic of their floating-point units."""


def missing() -> str:
    """The first tool that is not there with the Debian package that has it, one line; empty if none is."""
    for tool, package in PACKAGES.items():
        if shutil.which(tool) is None:
            return f"{tool} not found: install it, on Debian `apt-get install {package}`"
    found = subprocess.run(
        [GCC, "-E", "-x", "c", "-"], input="#include <math.h>\n", capture_output=True, text=True, check=False
    )
    if found.returncode:
        return f"{GCC} finds no math.h: install newlib, on Debian `apt-get install {LIBRARY}`"
    return ""


def versions() -> dict[str, str]:
    """First line of what the compiler and the emulator say of themselves."""
    return {tool: _run([tool, "--version"]).splitlines()[0] for tool in (GCC, QEMU)}


def compiled(core: Core, source: Path, flags: Sequence[str] = ()) -> Path:
    """The object file of one source, beside it, with its frames in ``.su``; CompilerError on a warning."""
    target = source.with_suffix(".o")
    command = [GCC, *core.flags, *FLAGS, *WARNINGS, "-fstack-usage", "-ffunction-sections", "-fdata-sections"]
    _run([*command, *flags, "-c", source.name, "-o", target.name], source.parent)
    return target


def linked(core: Core, objects: Iterable[Path], script: Path, target: Path) -> Path:
    """The image of some objects, without what none of them uses."""
    command = [GCC, *core.flags, *FLAGS, "-nostartfiles", "--specs=nosys.specs", "-Wl,--gc-sections"]
    listed = sorted({path.name for path in objects})
    _run([*command, "-T", script.name, *listed, "-lm", "-o", target.name], target.parent)
    return target


def emulated(core: Core, image: Path) -> tuple[int, str]:
    """Exit code and output of an image under QEMU, where an instruction takes a nanosecond of its time."""
    command = [QEMU, "-M", core.board, "-nographic", "-semihosting", "-icount", "shift=0"]
    try:
        done = subprocess.run(
            [*command, "-kernel", str(image)],
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
            timeout=SECONDS,
        )
    except subprocess.TimeoutExpired:
        raise CompilerError(f"{QEMU} {image.name}: no end after {SECONDS} s") from None
    return done.returncode, done.stdout + done.stderr


def sizes(path: Path) -> dict[str, int]:
    """Bytes of an object or image: ``flash`` (code, constants, initial values) and ``ram`` (data)."""
    found = {"flash": 0, "ram": 0}
    for line in _run([SIZE, "-A", str(path)]).splitlines():
        section = re.match(r"(\.\w+)\S*\s+(\d+)", line)
        for where, names in _SECTIONS.items():
            if section and section[1] in names:
                found[where] += int(section[2])
    return found


def asked_for(path: Path) -> set[str]:
    """Symbols that an object leaves to others."""
    return set(_run([NM, "-u", "-j", str(path)]).split())


def defined(path: Path) -> set[str]:
    """Symbols that an object or image has."""
    return set(_run([NM, "--defined-only", "-j", str(path)]).split())


def double_arithmetic(path: Path) -> set[str]:
    """Double-precision instructions in an object, and calls of what computes with doubles in software."""
    found = {name for name in asked_for(path) if _DOUBLE_HELPER.fullmatch(name)}
    for line in _run([OBJDUMP, "-d", "--no-show-raw-insn", str(path)]).splitlines():
        fields = line.split("\t")
        # Moves do not count, as two floats may be moved as one double: arithmetic and conversions do.
        if len(fields) > 1 and ".f64" in fields[1]:
            found.add(fields[1].strip())
    return found


def deepest_stack(image: Path, usage: Iterable[Path], root: str) -> int:
    """Bytes of stack of ``root`` and what it calls, by the frames that the compiler told of.

    Library functions, of which it told nothing, count nothing. CompilerError if a frame has no bound, or if
    functions call each other in a circle.
    """
    frames: dict[str, int] = {}
    for line in "".join(path.read_text(encoding="utf-8") for path in usage).splitlines():
        where, size, kind = line.split("\t")
        if kind == "dynamic":
            raise CompilerError(f"{where}: a frame without a bound")
        frames[where.split(":")[-1]] = int(size)
    calls: dict[str, set[str]] = {}
    inside = ""
    for line in _run([OBJDUMP, "-d", "--no-show-raw-insn", str(image)]).splitlines():
        if begins := re.match(r"[0-9a-f]+ <([^>]+)>:", line):
            inside = begins[1]
            continue
        called = re.search(r"\t(b[a-z.]*)\t.*<([^>+]+)>", line)
        # A plain branch to a function's own beginning is a loop, not a call.
        if called and (called[1].startswith("bl") or called[2] != inside):
            calls.setdefault(inside, set()).add(called[2])

    def depth(name: str, above: tuple[str, ...]) -> int:
        if name in above:
            raise CompilerError(f"{name}: calls itself")
        below = (depth(each, (*above, name)) for each in calls.get(name, ()) if each in frames)
        return frames[name] + max(below, default=0)

    return depth(root, ())


def _run(command: Sequence[str], folder: Path | None = None) -> str:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode:
        log = done.stdout + done.stderr
        first = next((line for line in log.splitlines() if "error" in line), log)
        raise CompilerError(f"{command[0]} failed: {first}", log)
    return done.stdout
