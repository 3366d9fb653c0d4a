"""A kit compiles without a warning and checks itself on every compiler, C standard, width and byte order.

32-bit x86 comes with its two ways of computing: SSE2, which rounds like everything else, and x87, which
keeps more digits than the type in registers. s390x has its bytes the other way round, AArch64 has vectors of
two doubles and fuses; both run in an emulator.
"""

import shutil
import subprocess
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import attack_build
import pytest
from kits import few_vectors
from sweeps import slow_but

import stewart_sym as ss
from stewart_sym.kit import Choice, Kit, kit, put
from stewart_sym.kit.kit_options import FUNCTIONS, TORQUE

WARNINGS = ["-Wall", "-Wextra", "-pedantic", "-Wconversion", "-Wdouble-promotion", "-Wshadow", "-Wundef"]
WARNINGS += ["-Wstrict-prototypes", "-Wold-style-definition", "-Wmissing-prototypes", "-Wvla", "-Werror"]

pytestmark = pytest.mark.filterwarnings("ignore:.*physically impossible")


@dataclass(frozen=True)
class Target:
    """A compiler and the flags that make it compile for one machine.

    bits: of a pointer. evaluation: FLT_EVAL_METHOD. runner: what runs a program of that machine here.
    """

    compilers: tuple[str, ...]
    flags: tuple[str, ...]
    bits: int = 64
    evaluation: int = 0
    runner: tuple[str, ...] = ()

    @property
    def compiler(self) -> str:
        """The first of the compilers that is installed; the first of all if none is."""
        return next(filter(shutil.which, self.compilers), self.compilers[0])


SSE = ("-m32", "-msse2", "-mfpmath=sse")
X87 = ("-m32", "-mno-sse")
VERSIONS = ("", "-14", "-13", "-12")
CROSS = tuple(f"s390x-linux-gnu-gcc{version}" for version in VERSIONS)
ARM = tuple(f"aarch64-linux-gnu-gcc{version}" for version in VERSIONS)
TARGETS = {
    "gcc": Target(("gcc",), ()),
    "clang": Target(("clang",), ()),
    "gcc-x87": Target(("gcc",), X87, bits=32, evaluation=2),
    "clang-x87": Target(("clang",), X87, bits=32, evaluation=2),
    "gcc-sse": Target(("gcc",), SSE, bits=32),
    "clang-sse": Target(("clang",), SSE, bits=32),
    # Standard C there computes float in double, so that every comparison promotes.
    "s390x": Target(CROSS, ("-static",), evaluation=1, runner=("qemu-s390x",)),
    "aarch64": Target(ARM, ("-static",), runner=("qemu-aarch64",)),
}

COVERING = [
    ("gcc", "lanes", "-std=c11", "-O3", "double"),
    ("clang", "lanes", "-std=c99", "-O1", "float"),
    ("gcc-x87", "scalar", "-std=c99", "-O3", "float"),
    ("clang-x87", "scalar", "-std=c11", "-O2", "double"),
    ("gcc-sse", "scalar", "-std=c99", "-O2", "double"),
    ("clang-sse", "scalar", "-std=c99", "-O3", "float"),
    ("s390x", "lanes", "-std=c99", "-O0", "double"),
    ("s390x", "scalar", "-std=c11", "-O1", "float"),
    ("aarch64", "lanes", "-std=c11", "-O3", "float"),
    ("aarch64", "scalar", "-std=c99", "-O1", "double"),
]
"""Every target and layout, low and high levels, both precisions."""
QUICK = (("clang", "lanes"), ("s390x", "scalar"))
"""Those of the fast tests: both kernels and compilers, and another byte order."""


@cache
def made(layout: str, precision: str) -> Kit:
    """A kit of the forces in lanes or scalar; "all" holds every function."""
    robot = ss.robots.dasgupta1998()
    functions = tuple(name for name in FUNCTIONS if name != TORQUE) if layout == "all" else ("forces",)
    with few_vectors():
        return kit(robot, Choice(functions, scalar=layout == "scalar", precision=precision))


def need(target: Target, folder: Path) -> None:
    """Skips, saying why, where the target's compiler or emulator can't make and run a program."""
    for tool in (target.compiler, *target.runner[:1]):
        if shutil.which(tool) is None:
            pytest.skip(f"{tool} is not installed")
    (folder / "hosted.c").write_text("#include <math.h>\n#include <stdio.h>\nint main(void) { return 0; }\n")
    command = [target.compiler, *target.flags, "hosted.c", "-o", "hosted", "-lm"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        reason = next(iter(done.stderr.splitlines()), "double")
        pytest.skip(f"{target.compiler} {' '.join(target.flags)} has no C library: {reason[:200]}")


def checked(kit: Path, target: Target, flags: Iterable[str], folder: Path) -> None:
    """Builds the kit's self-test without a warning and runs it: it returns 0 if all answers are in bounds."""
    sources = [f"-I{kit}", *(str(path) for path in sorted(kit.glob("*.c"))), str(kit / "test" / "selftest.c")]
    chosen = [flag for flag in flags if flag]
    program = folder / "_".join([kit.name, target.compiler, *target.flags, *chosen]).replace("=", "double")
    promoted = ["-Wno-double-promotion"] if target.evaluation == 1 else []
    command = [target.compiler, *target.flags, *chosen, *WARNINGS, *promoted, *sources]
    attack_build.ran([*command, "-o", str(program), "-lm"], folder)
    attack_build.ran([*target.runner, str(program)], folder)
    program.unlink()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "layout", "standard", "level", "precision"),
    slow_but(QUICK, COVERING, lambda each: each[:2]),
)
def test_a_kit_checks_itself(
    tmp_path: Path, name: str, layout: str, standard: str, level: str, precision: str
) -> None:
    need(TARGETS[name], tmp_path)
    put(made(layout, precision), tmp_path / "kit")
    checked(tmp_path / "kit", TARGETS[name], (standard, level), tmp_path)
