"""How tests are shared among workers: a module with a costly fixture in one worker, long modules first.

``--dist loadgroup --no-loadscope-reorder`` hands the tests out in this order, so that what remains for the
end is short and the workers finish together. Modules and not marks of ``xdist_group`` make the groups,
since pytest-xdist 3.8 writes a mark into a node id that pytest 9.2 no longer reads.
"""

import gc
import os
from collections.abc import Iterator
from pathlib import PurePosixPath
from typing import Any

import pytest

from stewart_sym.backend import c_kernel, native
from stewart_sym.dynamics import closed_form

# Derivations make much that stays: collecting garbage as often as usual takes a tenth of the time.
gc.set_threshold(100_000, 50, 50)

# A process for each core: BLAS threads would wait for each other.
for library in ("OMP", "OPENBLAS", "MKL"):
    os.environ.setdefault(f"{library}_NUM_THREADS", "1")

SHARING = (
    ("test_bench_figures",),
    ("test_build",),
    ("test_cluster",),
    ("test_controller",),
    ("test_cpp",),
    ("test_cost_accuracy", "test_advice"),
    ("test_cost_plot", "test_pictures"),
    ("test_fmu", "test_fmu_files"),
    # What is derived for the first is there for the others.
    (
        *("test_generated", "test_motion_subsets", "test_operations", "test_regroup", "test_blocks"),
        *("test_kernel_tree", "test_kinematics_tree", "test_closed_form", "test_motion_equations"),
        *("test_symbols", "test_casadi_functions"),
        *("test_kit", "test_kit_folder", "test_kit_use", "test_vectors", "test_language_kits", "test_stacks"),
    ),
    ("test_wrong_constants", "test_bake"),
    # The library of the sweep.
    ("test_degenerate_families", "test_proportions", "test_stability"),
    ("test_noise",),
    ("test_along_path",),
    ("test_reproduce",),
    # One browser.
    ("test_controls", "test_reports", "test_pixels"),
)
"""Modules in which tests share what takes seconds and is made once a worker."""
GROUPS = {module: group[0] for group in SHARING for module in group}
LONG = (
    "test_generated",
    "test_kit",
    "test_kit_folder",
    "test_vectors",
    "test_language_kits",
    "test_kit_use",
    "test_stacks",
    "test_controller",
    "test_build",
    "test_bench_figures",
    "test_cost_accuracy",
    "test_advice",
    "test_fmu",
    "test_fmu_files",
    "test_cost_plot",
    "test_cluster",
    "test_bench_without_baselines",
    "test_degenerate_families",
    "test_bench",
    "test_bounds",
    "test_cpp",
    "test_attack_c",
    "test_plausibility",
    "test_pictures",
    "test_noise",
    "test_worst_rounding",
    "test_least_time",
    "test_plan_command",
    "test_wrong_constants",
    "test_rotor",
    "test_misra",
    "test_packaging",
    "test_long_logs",
    "test_portability",
    "test_bake",
    "test_float",
    "test_simulation",
    "test_closed_form",
    "test_reproduce",
)
"""Modules with tests of more than two seconds, the longest first."""


_LOADED = (c_kernel.library, c_kernel.function, closed_form.library)


@pytest.fixture
def rounded_twice() -> Iterator[None]:
    """The C without fused multiply-add, whose bits are NumPy's; at -O0, which takes a fifth of the time."""
    with pytest.MonkeyPatch.context() as changed:
        load = native.load
        changed.setattr(
            native,
            "load",
            lambda name, sources, flags=(), defines=None: load(
                name, sources, (*flags, "-O0"), {**(defines or {}), "STEWART_NO_FMA": 1}
            ),
        )
        for each in _LOADED:
            each.cache_clear()
        yield
    for each in _LOADED:
        each.cache_clear()


@pytest.fixture(scope="session")
def sweep_library() -> Iterator[None]:
    """The sweep's C, at -O0: to compile it takes longer than all cases of the tests."""
    from stewart_sym.studies.robustness.sweep import oracle

    with pytest.MonkeyPatch.context() as changed:
        changed.setattr(oracle, "_FLAGS", (*oracle._FLAGS, "-O0"))
        try:
            oracle._library()
        except native.CompilerError:
            pytest.skip("needs a compiler with __float128")
        yield


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    rank = {name: number for number, name in enumerate(LONG)}
    items.sort(key=lambda item: rank.get(item.path.stem, len(LONG)))


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    if config.getvalue("dist") != "loadgroup":
        return None
    from xdist.scheduler import LoadScopeScheduling

    class Modules(LoadScopeScheduling):
        def _split_scope(self, nodeid: str) -> str:
            return GROUPS.get(PurePosixPath(nodeid.split("::")[0]).stem, nodeid)

    return Modules(config, log)
