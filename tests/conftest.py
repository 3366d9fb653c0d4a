"""How tests are shared among workers: a module with a costly fixture in one worker, long modules first.

``--dist loadgroup --no-loadscope-reorder`` hands the tests out in this order, so that what is left for the
end is short and the workers finish together. Modules and not marks of ``xdist_group`` make the groups, since
pytest-xdist 3.8 writes a mark into a node id that pytest 9.2 no longer reads.
"""

import os
from pathlib import PurePosixPath
from typing import Any

import pytest

# A process for each core: BLAS threads would wait for each other.
for library in ("OMP", "OPENBLAS", "MKL"):
    os.environ.setdefault(f"{library}_NUM_THREADS", "1")

WHOLE = {
    "test_bench",
    "test_build",
    "test_cluster",
    "test_controller",
    "test_cost_accuracy",
    "test_cost_plot",
    "test_fmu",
    "test_generated",
    "test_kit",
    "test_motion_subsets",
    "test_noise",
    "test_operations",
    "test_along_path",
    "test_pictures",
    "test_reproduce",
}
"""Modules in which tests share what takes seconds and is made once a worker."""
LONG = (
    "test_noise",
    "test_identification_noise",
    "test_generated",
    "test_worst_rounding",
    "test_plausibility",
    "test_kit",
    "test_bench",
    "test_fmu",
    "test_controller",
    "test_build",
    "test_bench_without_baselines",
    "test_cost_plot",
    "test_packaging",
    "test_vectors",
    "test_readme",
    "test_motion_subsets",
    "test_operations",
    "test_cluster",
    "test_kit_use",
    "test_misra",
    "test_portability",
    "test_cost_accuracy",
    "test_attack_c",
    "test_degenerate_families",
    "test_regroup",
    "test_closed_form",
    "test_joint_space",
    "test_stacks",
    "test_reproduce",
    "test_simulation",
)
"""Modules with tests of more than two seconds, the longest first."""


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
            module = nodeid.split("::")[0]
            return module if PurePosixPath(module).stem in WHOLE else nodeid

    return Modules(config, log)
