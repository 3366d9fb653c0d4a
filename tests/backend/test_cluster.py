"""The batch call on a real cluster: two worker processes, the same bits, the C compiled at most once each."""

import collections
import os
import pickle
import shlex
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from logged_compiler import LoggedCompiler
from machines import dasgupta, random_motion, random_robot

import stewart_sym as ss

WAIT = 300
"""Seconds after which a cluster that does not answer is given up; a busy machine may be slow."""
CHUNK = 12_500
AXES = (np.linspace(-0.2, 0.2, 25), np.linspace(-0.2, 0.2, 40), np.linspace(0.4, 0.8, 50))


@pytest.fixture
def compiler(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> LoggedCompiler:
    """A compiler that notes which process ran it."""
    logged = LoggedCompiler(tmp_path, note="$PPID")
    monkeypatch.setenv("CC", shlex.quote(str(logged.path)))
    return logged


@pytest.fixture
def client(tmp_path: Path, cache: Path, compiler: LoggedCompiler) -> Iterator[Any]:
    """A client of two workers."""
    import dask
    from distributed import Client, LocalCluster

    timeouts = {"distributed.comm.timeouts.connect": f"{WAIT}s"}
    with (
        dask.config.set({**timeouts, "temporary-directory": str(tmp_path)}),
        LocalCluster(
            n_workers=2,
            threads_per_worker=2,
            processes=True,
            host="127.0.0.1",
            dashboard_address=None,
            # The scheduler serves HTTP all the same: on a free port, for test processes side by side.
            scheduler_kwargs={"dashboard_address": "127.0.0.1:0"},
            memory_limit=0,
        ) as local,
        Client(local, timeout=WAIT) as client,
    ):
        client.wait_for_workers(2, timeout=WAIT)
        yield client


@pytest.mark.full
@pytest.mark.slow
def test_a_cold_cluster_maps_a_workspace_to_the_same_bits_and_compiles_at_most_once_a_worker(
    client: Any, compiler: LoggedCompiler
) -> None:
    import dask.array as da

    kernel, still = ss.ForceKernel, np.zeros(3)

    def at_rest(t: np.ndarray, robot: ss.Robot) -> np.ndarray:
        motion = ss.Motion.from_rpy(t, still, still, still, still, still)
        return kernel(robot).forces(motion)

    robot, points = dasgupta(), np.stack(np.meshgrid(*AXES), axis=-1).reshape(-1, 3)
    blocks = da.from_array(points, chunks=(CHUNK, 3))
    mapped = blocks.map_blocks(at_rest, robot, chunks=(blocks.chunks[0], (6,)), meta=np.empty((0, 6)))
    pids = set(client.run(os.getpid).values())
    assert len(pids - {os.getpid()}) == 2
    far = client.compute(mapped).result(timeout=WAIT)
    compilations = collections.Counter(map(int, compiler.calls))
    assert set(compilations) <= pids
    assert set(compilations.values()) == {1}
    assert same_bits(far, at_rest(points, robot))
    assert np.isfinite(far).all()


def test_a_pickled_kernel_comes_back_the_same() -> None:
    rng = np.random.default_rng(31)
    robot = random_robot(rng)
    kernel, motion = ss.ForceKernel(robot, "paper"), random_motion(rng, robot, (20,))
    back = pickle.loads(pickle.dumps(kernel))
    assert (back.formulation, back.precision) == ("paper", "double")
    assert same_bits(back.forces(motion), kernel.forces(motion))


def test_a_scheduler_without_a_compiler_may_unpickle_a_kernel(tmp_path: Path) -> None:
    """Dask unpickles the graph on the scheduler, which never runs a block."""
    code = "import pickle, sys; print(pickle.load(sys.stdin.buffer).formulation)"
    env = {**os.environ, "CC": str(tmp_path / "none"), "STEWART_SYM_CACHE": str(tmp_path / "cache")}
    kernel = pickle.dumps(ss.ForceKernel(dasgupta()))
    run = [sys.executable, "-c", code]
    done = subprocess.run(run, input=kernel, env=env, check=True, capture_output=True, timeout=WAIT)
    assert done.stdout.split() == [b"exact"]


def same_bits(one: np.ndarray, other: np.ndarray) -> bool:
    return one.dtype == other.dtype and one.shape == other.shape and one.tobytes() == other.tobytes()
