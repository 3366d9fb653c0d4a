"""Compilers vectorize every loop that computes the poses of a block, as their reports say."""

import re
from pathlib import Path

import pytest
from attack_build import sources
from builds import needed, run, written

FLAGS = ["-O3", "-march=x86-64-v3", "-std=c99", "-fno-math-errno", "-ffp-contract=off", "-c"]
REPORTS = {
    "gcc": ("-fopt-info-vec-optimized", "optimized: (?:loop|basic block part) vectorized"),
    "clang": ("-Rpass=loop-vectorize|slp-vectorizer", "remark: (?:vectorized loop|Stores SLP vectorized)"),
}
LOOP = re.compile(r" *for \(l = 0; l < POSES; \+\+l\) \{")
FUNCTION = re.compile(r"^[\w ]*void (compute_\w+_block)\(", re.MULTILINE)


def loops(text: str) -> list[tuple[str, range]]:
    """Return the functions of a block with the lines of each of their loops that compute."""
    found: list[tuple[str, range]] = []
    for function in FUNCTION.finditer(text):
        body = text[function.start() : text.index("\n}\n", function.start())].split("\n")
        first = text.count("\n", 0, function.start()) + 1
        begins = [i for i, line in enumerate(body) if LOOP.match(line)]
        ends = [*begins[1:], len(body)]
        computing = ((i, end) for i, end in zip(begins, ends, strict=True) if "*" in "".join(body[i:end]))
        found += [(function[1], range(first + i, first + end)) for i, end in computing]
    return found


@pytest.mark.slow
@pytest.mark.parametrize("compiler", REPORTS)
@pytest.mark.parametrize("kernel", ["exact_forces", "exact_massless_static_forces"])
def test_every_loop_over_poses_is_vectorized(kernel: str, compiler: str, tmp_path: Path) -> None:
    needed(compiler)
    texts = sources(f"stewart_{kernel}")
    written(texts, tmp_path)
    option, says = REPORTS[compiler]
    report = run(compiler, *FLAGS, option, f"stewart_{kernel}.c", "-o", "kernel.o", cwd=tmp_path)
    for file in (f"stewart_{kernel}.c", "stewart_lanes.h"):
        vectorized = {int(line) for line in re.findall(rf"{file}:(\d+):\d+: {says}", report)}
        scalar = [(name, lines) for name, lines in loops(texts[file]) if not vectorized.intersection(lines)]
        assert loops(texts[file])
        assert not scalar
