"""Fixtures of all tests, and their distribution to workers by modules that share results.

Modules and not marks of ``xdist_group`` make the groups, since pytest-xdist 3.8 writes a mark into a node id
that pytest 9.2 no longer reads.
"""

import functools
import gc
import os
import shutil
from collections.abc import Iterator
from pathlib import Path, PurePosixPath
from typing import Any

import pytest

# A process for each core: BLAS threads would wait for each other. Read when NumPy is loaded.
os.environ.update({f"{library}_NUM_THREADS": "1" for library in ("OMP", "OPENBLAS", "MKL")})

from command_line import Fails, Run, fails_in_one_line, told
from sweeps import FULL

from stewart_sym.backend import native
from stewart_sym.calls import c_kernel

# Derivations make much that stays: collecting garbage as often as usual takes a tenth of the time.
gc.set_threshold(100_000, 50, 50)

SHARING = (
    ("test_cost_accuracy", "test_advice"),
    ("test_cost_plot", "test_pictures"),
    ("test_fmu", "test_fmu_files"),
    # What is derived for the first is there for the others.
    (
        *("test_generated", "test_operations", "test_fifty_digits", "test_kernel_tree"),
        *("test_symbols", "test_casadi_functions"),
        *("test_kit", "test_kit_folder", "test_kit_use", "test_vectors", "test_language_kits", "test_stacks"),
    ),
    ("test_wrong_constants", "test_bake"),
    # The library of the sweep.
    ("test_degenerate_families", "test_stability"),
    # One browser.
    ("test_controls", "test_reports", "test_pixels"),
)
"""Modules that share what takes seconds and is made once a worker."""
GROUPS = {module: group[0] for group in SHARING for module in group}


_USUAL = ("stewart_exact", "stewart_exact_forces")


@pytest.fixture(autouse=True, scope="session")
def rare_kernels() -> Iterator[None]:
    """All kernels but the usual one at -O0, which gives the bits of what ships: ``test_attack_c``."""
    load = native.load

    def quickly(name: str, sources: Any, flags: Any = ()) -> Any:
        rare = name.startswith("stewart_") and name not in _USUAL
        # Not twice: a library of other flags is compiled anew.
        return load(name, sources, (*flags, "-O0") if rare and "-O0" not in flags else flags)

    with pytest.MonkeyPatch.context() as changed:
        if not FULL:
            changed.setattr(native, "load", quickly)
        yield


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The working folder, with the documentation's robot, log and scene."""
    for name in ("hexapod.toml", "trajectory.csv", "swing.toml"):
        shutil.copy(Path(__file__).parents[1] / ".docs" / "examples" / name, tmp_path)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Run:
    """Runs a subcommand that must end with 0, or ``code``."""
    return functools.partial(told, capsys)


@pytest.fixture
def fails(capsys: pytest.CaptureFixture[str]) -> Fails:
    """Runs a subcommand that must fail, for its only line."""
    return functools.partial(fails_in_one_line, capsys)


_LOADED = (c_kernel.library, c_kernel.function)


@pytest.fixture
def rounded_twice() -> Iterator[None]:
    """The C without fused multiply-add, whose bits are NumPy's; at -O0, which takes a fifth of the time."""
    with pytest.MonkeyPatch.context() as changed:
        load = native.load
        changed.setattr(
            native,
            "load",
            lambda name, sources, flags=(): load(name, sources, (*flags, "-O0", "-DSTEWART_NO_FMA")),
        )
        for each in _LOADED:
            each.cache_clear()
        yield
    for each in _LOADED:
        each.cache_clear()


@pytest.fixture(scope="session")
def sweep_library() -> Iterator[None]:
    """The kernels of the study, at -O0: to compile them takes longer than all cases of the tests."""
    from stewart_sym.studies.robustness import oracle

    with pytest.MonkeyPatch.context() as changed:
        quick = {name: (*flags, "-O0") for name, flags in oracle._FLAGS.items()}
        changed.setattr(oracle, "_FLAGS", quick)
        try:
            oracle.library("wide")
        except native.CompilerError:
            pytest.skip("needs a compiler with a long double of 64 bits")
        yield


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    if not FULL:
        items[:] = [item for item in items if item.get_closest_marker("full") is None]


def pytest_unconfigure() -> None:
    # What SymPy keeps takes pytest's last collection of garbage seconds.
    gc.freeze()


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    if config.getvalue("dist") != "loadgroup":
        return None
    from xdist.scheduler import LoadScopeScheduling

    class Modules(LoadScopeScheduling):
        def _split_scope(self, nodeid: str) -> str:
            module = PurePosixPath(nodeid.split("::")[0])
            return GROUPS.get(module.stem, str(module))

    return Modules(config, log)
