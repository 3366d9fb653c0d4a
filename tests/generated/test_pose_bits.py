"""Bits of force kernels: one pose, a batch, its parts, and columns agree for every kernel and compiler."""

import re
import shutil
from concurrent.futures import ThreadPoolExecutor
from os import cpu_count
from pathlib import Path

import numpy as np
import pose_bits
import pytest
from sweeps import FULL

# Of kernels whose text differs most; gcc 12 once fused products of the second and third.
SOME = ("exact", "exact_slender", "exact_drive_reflected_slender", "exact_massless_static", "exact_offset")
WAYS = {
    f"{compiler}-{precision}-{name}": (compiler, precision, flags, every)
    for name, flags in (("native", pose_bits.NATIVE), ("kit", pose_bits.PORTABLE))
    for compiler in ("gcc", "clang")
    for precision in (("double", "float") if name == "native" or FULL else ("double",))
    for every in [(compiler, precision, name) == ("gcc", "double", "native")]
}


def test_products_that_all_legs_share_are_fused_into_sums() -> None:
    for kernel in pose_bits.KERNELS:
        text = (pose_bits.GENERATED / f"stewart_{kernel}_forces.c").read_text()
        (body,) = re.findall(r"^static void shared_of_pose\(.*?^\}", text, re.DOTALL | re.MULTILINE)
        for product in re.findall(r"stewart_real (\w+) = \w+\*\w+;", body):
            assert not re.search(rf"[+-]\s{product}\b|\b{product}\s[+-]", body), (kernel, product)


@pytest.mark.slow
@pytest.mark.parametrize("way", WAYS)
def test_one_pose_has_the_bits_of_its_batch(way: str, tmp_path: Path) -> None:
    compiler, precision, flags, every = WAYS[way]
    if shutil.which(compiler) is None:
        pytest.fail(f"{compiler} is not installed")
    kernels = pose_bits.KERNELS if FULL or every else SOME

    def compared(kernel: str) -> tuple[str, list[int], int, int]:
        counts, statuses = pose_bits.differing(tmp_path, kernel, compiler, flags, precision)
        return kernel, counts.tolist(), int(statuses[0]), int(np.count_nonzero(statuses))

    with ThreadPoolExecutor(cpu_count() or 1) as pool:
        found = list(pool.map(compared, kernels))
    assert [each for each in found if any(each[1])] == []
    assert min(solved for _, _, solved, _ in found) > 5000
    assert max(kinds for *_, kinds in found) == 5
