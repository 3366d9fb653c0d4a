"""How tests are shared among workers: those of a costly fixture in one worker, modules of long tests first.

``--dist loadgroup --no-loadscope-reorder`` hands the tests out in this order, so that what is left for the
end is short and the workers finish together. Each has one BLAS thread, as there is a worker for each core.
"""

import os

import pytest

for library in ("OMP", "OPENBLAS", "MKL"):
    os.environ.setdefault(f"{library}_NUM_THREADS", "1")

COSTLY = {
    "test_bench": ("written",),
    "test_build": ("files", "wrapped"),
    "test_cluster": ("cluster",),
    "test_controller": ("found",),
    "test_economy": ("found",),
    "test_economy_plot": ("picture",),
    "test_generated": ("regenerated",),
    "test_misra": ("name",),
    "test_motion_subsets": ("kernels",),
    "test_noise": ("sweep",),
    "test_passage": ("root",),
    "test_pictures": ("picture",),
    "test_reproduce": ("found",),
}
"""Module -> fixtures that take seconds, made once a worker, or once for each value of a parameter."""
LONG = (
    "test_noise",
    "test_identification_noise",
    "test_generated",
    "test_worst_rounding",
    "test_plausibility",
    "test_bench",
    "test_controller",
    "test_build",
    "test_packaging",
    "test_vectors",
    "test_readme",
    "test_motion_subsets",
    "test_operations",
    "test_cluster",
    "test_kit_use",
    "test_kit",
    "test_misra",
    "test_portability",
    "test_economy",
    "test_regroup",
    "test_closed_form",
    "test_joint_space",
    "test_stacks",
    "test_reproduce",
    "test_simulation",
)
"""Modules with tests of more than two seconds, the longest first."""


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if isinstance(item, pytest.Function):
            for fixture in COSTLY.get(item.path.stem, ()):
                if fixture in item.fixturenames:
                    item.add_marker(pytest.mark.xdist_group(_group(item, fixture)))
    rank = {name: number for number, name in enumerate(LONG)}
    items.sort(key=lambda item: rank.get(item.path.stem, len(LONG)))


def _group(item: pytest.Function, fixture: str) -> str:
    parameters = item.callspec.params if hasattr(item, "callspec") else {}
    return " ".join([item.path.stem, fixture, str(parameters.get(fixture, ""))]).strip()
