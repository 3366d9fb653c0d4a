"""A kit compiles without a warning and checks itself on every compiler, C standard, width and byte order.

32-bit x86 comes with its two ways of computing: SSE2, which rounds like everything else, and x87, which keeps
more digits than the type in registers. s390x has its bytes the other way round and runs in an emulator.
"""

import itertools
import os
import shutil
import subprocess
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import attack_build
import pytest

import stewart_sym as ss
from stewart_sym.kit import Choice, write_kit

WARNINGS = ["-Wall", "-Wextra", "-pedantic", "-Wconversion", "-Wdouble-promotion", "-Wshadow", "-Wundef"]
WARNINGS += ["-Wstrict-prototypes", "-Wold-style-definition", "-Wmissing-prototypes", "-Wvla", "-Werror"]
KITS = {"lanes": Choice(fidelity="general"), "scalar": Choice(fidelity="general", scalar=True)}
MAINS = ("selftest.c", "example.c")
NOT_LINKED = {*MAINS, "main.c"}

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
    big_endian: bool = False
    runner: tuple[str, ...] = ()

    @property
    def compiler(self) -> str:
        """The first of the compilers that is installed; the first of all if none is."""
        return next(filter(shutil.which, self.compilers), self.compilers[0])


SSE = ("-m32", "-msse2", "-mfpmath=sse")
X87 = ("-m32", "-mno-sse")
CROSS = tuple(f"s390x-linux-gnu-gcc{version}" for version in ("", "-14", "-13", "-12"))
TARGETS = {
    "gcc": Target(("gcc",), ()),
    "clang": Target(("clang",), ()),
    "gcc-x87": Target(("gcc",), X87, bits=32, evaluation=2),
    "clang-x87": Target(("clang",), X87, bits=32, evaluation=2),
    "gcc-sse": Target(("gcc",), SSE, bits=32),
    "clang-sse": Target(("clang",), SSE, bits=32),
    # Standard C there computes float in double, so that every comparison promotes.
    "s390x": Target(CROSS, ("-static",), evaluation=1, big_endian=True, runner=("qemu-s390x",)),
}
STANDARDS = ("-std=c99", "-std=c11")
LEVELS = ("-O0", "-O1", "-O2", "-O3")
PRECISIONS = ("", "-DSTEWART_FLOAT")

COVERING = [
    ("gcc", "lanes", "-std=c11", "-O3", ""),
    ("clang", "lanes", "-std=c99", "-O2", "-DSTEWART_FLOAT"),
    ("gcc-x87", "lanes", "-std=c99", "-O1", ""),
    ("clang-x87", "scalar", "-std=c11", "-O2", ""),
    ("gcc-sse", "scalar", "-std=c11", "-O0", "-DSTEWART_FLOAT"),
    ("clang-sse", "scalar", "-std=c99", "-O3", "-DSTEWART_FLOAT"),
    ("s390x", "lanes", "-std=c99", "-O0", ""),
    ("s390x", "scalar", "-std=c11", "-O1", "-DSTEWART_FLOAT"),
]
"""Every target, and every pair of kernel, standard, level and precision."""


@pytest.fixture(scope="module")
def kits(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    made = {}
    for name, choice in KITS.items():
        made[name] = tmp_path_factory.mktemp(name)
        write_kit(ss.robots.dasgupta1998(), made[name], choice)
    return made


def need(target: Target, folder: Path) -> None:
    """Skips, saying why, where the target's compiler or emulator can't make and run a program."""
    for tool in (target.compiler, *target.runner[:1]):
        if shutil.which(tool) is None:
            pytest.skip(f"{tool} is not installed")
    (folder / "hosted.c").write_text("#include <math.h>\n#include <stdio.h>\nint main(void) { return 0; }\n")
    command = [target.compiler, *target.flags, "hosted.c", "-o", "hosted", "-lm"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        reason = next(iter(done.stderr.splitlines()), "")
        pytest.skip(f"{target.compiler} {' '.join(target.flags)} has no C library: {reason[:200]}")


def checked(kit: Path, target: Target, flags: Iterable[str], folder: Path) -> None:
    """Builds the kit's own check without a warning and runs it: it returns 0 if all answers are in bounds."""
    main = next(kit / name for name in MAINS if (kit / name).exists())
    sources = [str(path) for path in sorted(kit.glob("*.c")) if path.name not in NOT_LINKED]
    chosen = [flag for flag in flags if flag]
    program = folder / "_".join([kit.name, target.compiler, *target.flags, *chosen]).replace("=", "")
    promoted = ["-Wno-double-promotion"] if target.evaluation == 1 else []
    command = [target.compiler, *target.flags, *chosen, *WARNINGS, *promoted, str(main), *sources]
    attack_build.ran([*command, "-o", str(program), "-lm"], folder)
    attack_build.ran([*target.runner, str(program)], folder)
    program.unlink()


@pytest.mark.parametrize(("name", "kit", "standard", "level", "precision"), COVERING)
def test_a_kit_checks_itself(
    kits: dict[str, Path], tmp_path: Path, name: str, kit: str, standard: str, level: str, precision: str
) -> None:
    need(TARGETS[name], tmp_path)
    checked(kits[kit], TARGETS[name], (standard, level, precision), tmp_path)


def test_the_selection_has_every_target_and_every_pair() -> None:
    assert {each[0] for each in COVERING} == set(TARGETS)
    choices = (KITS, STANDARDS, LEVELS, PRECISIONS)
    for i, j in itertools.combinations(range(4), 2):
        pairs = {(each[i + 1], each[j + 1]) for each in COVERING}
        assert pairs == set(itertools.product(choices[i], choices[j]))


@pytest.mark.slow
@pytest.mark.parametrize("standard", STANDARDS)
@pytest.mark.parametrize("kit", KITS)
@pytest.mark.parametrize("name", TARGETS)
def test_a_kit_checks_itself_at_every_level_and_precision(
    kits: dict[str, Path], tmp_path: Path, name: str, kit: str, standard: str
) -> None:
    need(TARGETS[name], tmp_path)
    workers = int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1"))
    with ThreadPoolExecutor(max(1, (os.cpu_count() or 1) // workers)) as pool:
        flags = [(standard, *rest) for rest in itertools.product(LEVELS, PRECISIONS)]
        list(pool.map(lambda each: checked(kits[kit], TARGETS[name], each, tmp_path), flags))


@pytest.mark.parametrize("name", TARGETS)
def test_a_target_is_what_it_is_named_for(tmp_path: Path, name: str) -> None:
    target = TARGETS[name]
    need(target, tmp_path)
    (tmp_path / "what.c").write_text(
        "#include <float.h>\n#include <stdio.h>\n"
        "int main(void)\n{\n    const unsigned one = 1;\n"
        '    printf("%d %d %d\\n", 8 * (int)sizeof(void *), (int)FLT_EVAL_METHOD,\n'
        "        *(const unsigned char *)&one == 0);\n    return 0;\n}\n"
    )
    command = [target.compiler, "-std=c99", *target.flags, "what.c", "-o", "what"]
    attack_build.ran(command, tmp_path)
    said = attack_build.ran([*target.runner, "./what"], tmp_path).split()
    assert [int(word) for word in said] == [target.bits, target.evaluation, target.big_endian]


def test_a_wrong_answer_fails_the_check(kits: dict[str, Path], tmp_path: Path) -> None:
    target = TARGETS["gcc"]
    need(target, tmp_path)
    wrong = tmp_path / "wrong"
    shutil.copytree(kits["scalar"], wrong)
    kernel = next(wrong.glob("stewart_*_pose.c"))
    text = kernel.read_text()
    assert "x[i] = known[i] - x[i];" in text
    kernel.write_text(text.replace("x[i] = known[i] - x[i];", "x[i] = known[i] - REAL(1.000001)*x[i];"))
    with pytest.raises(AssertionError):
        checked(wrong, target, ("-std=c99", "-O1"), tmp_path)
