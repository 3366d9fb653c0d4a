"""The generated C under sanitizers and a fuzzer: no undefined behavior, and every output keeps its contract.

Oracles in tests/support/c: status in the known set, outputs untouched on a status other than 0 and finite
on 0, one pose equal to the batch bit for bit, null pointers rejected, no byte beside an array.
"""

import os
from collections.abc import Sequence
from pathlib import Path

import attack_build
import numpy as np
import pytest
from machines import dasgupta
from sweeps import FULL, share, slow_but

from stewart_sym import results
from stewart_sym.backend.kernel import robot_numbers
from stewart_sym.calls.c_kernel import address, library

SANITIZED = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all"]
MEMORY = ["-fsanitize=memory", "-fno-sanitize-recover=all"]
COVERAGE = ["-fsanitize-coverage=inline-8bit-counters,pc-table"]
FLOAT = ["-DSTEWART_FLOAT"]
SOME, SOME_WITH_ROTORS = (None, None) if FULL else (attack_build.SOME, attack_build.SOME_WITH_ROTORS)
OTHERS = SOME and [stem for stem in SOME if stem not in attack_build.FEW]
FUZZED = None if FULL else attack_build.FEW
KERNELS = len(FUZZED or attack_build.oracles())
# To compile optimized takes ten times as long as a twentieth of the runs.
LEVEL = "-O1" if FULL else "-O0"
SEEDS = attack_build.ATTACK / "seeds.txt"


def need(folder: Path, compiler: str, flags: list[str]) -> None:
    reason = attack_build.works(folder, compiler, flags)
    if reason is not None:
        pytest.skip(reason)


# In float the text is that of double, with other types and constants. The fuzzer attacks the others of FEW.
WAYS = {
    "gcc-double": ("gcc", ["-O0", *SANITIZED], 2_000, attack_build.FEW),
    "clang-shipped": ("clang", ["-O3", "-march=native", *FLOAT], share(20_000), SOME and SOME[-2:]),
    "clang-uninitialized": ("clang", [LEVEL, *MEMORY], share(10_000), SOME),
}


@pytest.mark.slow
@pytest.mark.parametrize("way", slow_but(["gcc-double"], WAYS))
def test_random_cases_keep_the_contract(way: str, tmp_path: Path) -> None:
    compiler, flags, cases, chosen = WAYS[way]
    need(tmp_path, compiler, flags)
    program = attack_build.built(tmp_path, compiler, flags, chosen=chosen)
    assert attack_build.ran([str(program), str(cases), "1"], tmp_path).startswith(f"{cases} cases, ")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("flags", "chosen", "rotors"),
    [
        pytest.param([], OTHERS and OTHERS[-2:], False, id="double"),
        pytest.param(
            FLOAT, SOME_WITH_ROTORS and SOME_WITH_ROTORS[2:], True, id="float-rotors", marks=pytest.mark.full
        ),
    ],
)
def test_what_ships_gives_the_bits_of_c_that_is_not_optimized(
    flags: list[str], chosen: Sequence[str] | None, rotors: bool, tmp_path: Path
) -> None:
    """Vector instructions, where one pose and a batch take different ways to the same bits."""
    cases, said = share(20_000), []
    for level in ("-O3", "-O0"):
        folder = tmp_path / level
        folder.mkdir()
        shipped = [level, "-march=native", *flags]
        need(folder, "gcc", shipped)
        program = attack_build.built(folder, "gcc", shipped, chosen=chosen, rotors=rotors)
        said.append(attack_build.ran([str(program), str(cases), "1"], folder))
    assert said[0].startswith(f"{cases} cases, ")
    assert said[0] == said[1]


@pytest.mark.slow
def test_kernels_of_legs_with_rotors_keep_the_contract(tmp_path: Path) -> None:
    cases, flags = share(20_000), ["-O0", *SANITIZED]
    need(tmp_path, "gcc", flags)
    program = attack_build.built(tmp_path, "gcc", flags, chosen=SOME_WITH_ROTORS, rotors=True)
    assert attack_build.ran([str(program), str(cases), "1"], tmp_path).startswith(f"{cases} cases, ")


@pytest.mark.slow
def test_fuzzing_finds_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    runs = share(1_000_000, 250)
    need(tmp_path, "clang", [*SANITIZED, "-fsanitize=fuzzer"])
    program = attack_build.built(
        tmp_path, "clang", [LEVEL, *SANITIZED, *COVERAGE], None, ["-fsanitize=fuzzer"], FUZZED
    )
    starts = []
    for number, seed in enumerate(seeds()):
        starts.append(tmp_path / f"seed{number:02}")
        starts[-1].write_bytes(seed)
    # Stacks of allocations and a long quarantine are most of the time and of no use here.
    monkeypatch.setenv("ASAN_OPTIONS", "malloc_context_size=0:quarantine_size_mb=1")
    limits = [
        f"-runs={runs}",
        "-seed=1",
        "-max_len=96",
        "-entropic=0",
        # The size it reads is that of the process which started it, too.
        "-rss_limit_mb=0",
        f"-artifact_prefix={tmp_path}{os.sep}",
        # Not as a folder, into which every new case would be written.
        f"-seed_inputs={','.join(map(str, starts))}",
    ]
    assert f"Done {runs} runs" in attack_build.ran([str(program), *limits], tmp_path)


def seeds() -> list[bytes]:
    """Sound cases of every kernel and count, and those of seeds.txt: a line's words up to the first gap."""
    lines = [line for line in SEEDS.read_text().splitlines() if not line.startswith("#")]
    sound = [bytes([kernel, 144 + count, 0]) for kernel in range(KERNELS) for count in range(18)]
    return sound + [bytes.fromhex(line.split("  ")[0]) for line in lines]


PADDED = "if (first + (size_t)POSES <= count) {\n        return block_at"
NULL = "motions->t == NULL) {"
BROKEN = {
    "past the end": (PADDED, PADDED.replace("(size_t)POSES <=", "1U <="), "heap-buffer-overflow"),
    "not finite": ("if (!(STEWART_FABS(forces.F[i]) <= STEWART_MAX)) {", "if (0) {", "attack_finite"),
    "batch": ("if (done.unfinished[l] > REAL(0)) {", "if (done.unfinished[l] > REAL(1)) {", "attack_first"),
    "null": (f"|| motions->R == NULL || {NULL}", f"|| {NULL}", "null pointer"),
    "undefined": ("int code = STEWART_OK;", "int code = 1 << (31 + (count > 8));", "left shift of 1"),
}
"""Text of a kernel, what stands in its place, and what an oracle or a sanitizer says of it."""


@pytest.mark.slow
@pytest.mark.parametrize("broken", slow_but(["past the end"], BROKEN if FULL else ["past the end", "batch"]))
def test_the_oracles_tell_a_broken_kernel(broken: str, tmp_path: Path) -> None:
    old, new, told = BROKEN[broken]
    need(tmp_path, "gcc", SANITIZED)
    stem, kernel = "stewart_exact_massless_static_forces", "exact_massless_static"
    texts = attack_build.sources(stem)
    sound = {name: texts[name] for name in (f"{stem}.c", "stewart_lanes.h")}
    assert sum(text.count(old) for text in sound.values()) == 1
    for name, text in texts.items():
        (tmp_path / name).write_text(text.replace(old, new) if name in sound else text)
    (tmp_path / "attack_kernels.h").write_text(f"ORACLE(attack_{kernel}_forces)\n")
    sources = [str(attack_build.ATTACK / f"attack{part}.c") for part in ("", "_forces", "_driver")]
    named = [f"-DKERNEL={kernel}", f'-DHEADER="{stem}.h"', "-DKERNELS=1"]
    places = [f"-I{place}" for place in (tmp_path, attack_build.ATTACK)]
    command = ["gcc", *attack_build.STRICT, *SANITIZED, *named, *places, f"{stem}.c", *sources, "-lm"]
    attack_build.ran(command, tmp_path)
    with pytest.raises(AssertionError, match=told):
        attack_build.ran(["./a.out", "2000"], tmp_path)


@pytest.mark.parametrize("bearing", [np.nan, 1e308])
def test_reactions_with_status_0_are_finite(bearing: float) -> None:
    numbers = robot_numbers(dasgupta())
    motion = np.zeros(30)
    motion[:9], motion[9:12] = np.eye(3).ravel(), (0.13, 0.04, 0.6)
    forces, reactions = np.zeros(78), np.zeros(96)
    status = library("exact").stewart_exact_joint_reactions(
        *(address(array) for array in (numbers, motion, np.full(6, bearing), forces, reactions))
    )
    assert status == results.NOT_FINITE
