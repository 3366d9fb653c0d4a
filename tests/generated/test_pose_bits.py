"""Bits of force kernels: one pose, a batch, its parts, and columns agree for every kernel and compiler."""

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
    f"{compiler}-{precision}-{name}": (compiler, precision, flags)
    for name, flags in (("native", pose_bits.NATIVE), ("kit", pose_bits.PORTABLE))
    for compiler, precision in (("gcc", "double"), ("clang", "float"), ("clang", "double"), ("gcc", "float"))
    if FULL or (precision, name) in (("double", "native"), ("float", "kit"))
}


@pytest.mark.slow
@pytest.mark.parametrize("way", WAYS)
def test_one_pose_has_the_bits_of_its_batch(way: str, tmp_path: Path) -> None:
    compiler, precision, flags = WAYS[way]
    if shutil.which(compiler) is None:
        pytest.fail(f"{compiler} is not installed")
    kernels = pose_bits.KERNELS if FULL else SOME

    def compared(kernel: str) -> tuple[str, list[int], int, int]:
        counts, statuses = pose_bits.differing(tmp_path, kernel, compiler, flags, precision)
        return kernel, counts.tolist(), int(statuses[0]), int(np.count_nonzero(statuses))

    with ThreadPoolExecutor(cpu_count() or 1) as pool:
        found = list(pool.map(compared, kernels))
    assert [each for each in found if any(each[1])] == []
    assert min(solved for _, _, solved, _ in found) > 5000
    assert max(kinds for *_, kinds in found) == 5
