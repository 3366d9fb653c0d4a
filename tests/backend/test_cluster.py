"""The batch call on a real cluster: two worker processes, the same bits, the C compiled at most once each."""

import collections
import dataclasses
import os
import pickle
import shlex
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from logged_compiler import LoggedCompiler
from machines import dasgupta, random_motion, random_robot

import stewart_sym as ss
from stewart_sym.backend.kernel import MOTION
from stewart_sym.motion.motion import Motion

WAIT = 300
"""Seconds after which a cluster that does not answer is given up; a busy machine may be slow."""
CHUNK = 12_500
AXES = (np.linspace(-0.2, 0.2, 50), np.linspace(-0.2, 0.2, 40), np.linspace(0.4, 0.8, 50))


class Cluster:
    """A client of two workers, and a compiler that notes which process ran it."""

    def __init__(self, client: Any, compiler: LoggedCompiler) -> None:
        self.client, self._compiler = client, compiler

    def compute(self, *arrays: Any) -> list[np.ndarray]:
        futures = self.client.compute(list(arrays))
        return [future.result(timeout=WAIT) for future in futures]

    def on_every_worker(self, function: Callable[[], Any]) -> list[Any]:
        return list(self.client.run(function).values())

    @property
    def compilations(self) -> collections.Counter[int]:
        return collections.Counter(map(int, self._compiler.calls))


@pytest.fixture(scope="module")
def cluster(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Cluster]:
    import dask
    from distributed import Client, LocalCluster

    folder = tmp_path_factory.mktemp("cluster")
    compiler = LoggedCompiler(folder, note="$PPID")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("STEWART_SYM_CACHE", str(folder / "cache"))
        patch.setenv("CC", shlex.quote(str(compiler.path)))
        timeouts = {"distributed.comm.timeouts.connect": f"{WAIT}s"}
        with (
            dask.config.set({**timeouts, "temporary-directory": str(folder)}),
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
            yield Cluster(client, compiler)


@pytest.mark.slow
def test_a_cold_cluster_maps_a_workspace_to_the_same_bits_and_compiles_at_most_once_a_worker(
    cluster: Cluster,
) -> None:
    import dask.array as da

    kernel, still = ss.ForceKernel, np.zeros(3)

    def at_rest(t: np.ndarray, robot: ss.Robot) -> np.ndarray:
        motion = ss.Motion.from_rpy(t, still, still, still, still, still)
        return kernel(robot).forces(motion)

    robot, points = dasgupta(), np.stack(np.meshgrid(*AXES), axis=-1).reshape(-1, 3)
    blocks = da.from_array(points, chunks=(CHUNK, 3))
    mapped = blocks.map_blocks(at_rest, robot, chunks=(blocks.chunks[0], (6,)), meta=np.empty((0, 6)))
    pids = set(cluster.on_every_worker(os.getpid))
    assert len(pids - {os.getpid()}) == 2
    (far,) = cluster.compute(mapped)
    assert set(cluster.compilations) <= pids
    assert set(cluster.compilations.values()) == {1}
    assert same_bits(far, at_rest(points, robot))
    assert np.isfinite(far).all()


@pytest.mark.slow
@pytest.mark.parametrize("precision", ["double", "float"])
def test_a_prepared_kernel_runs_unchanged_under_map_blocks_and_apply_gufunc(
    cluster: Cluster, precision: str
) -> None:
    import dask.array as da

    rng = np.random.default_rng(30)
    robot = random_robot(rng)
    kernel = ss.ForceKernel(robot, precision=precision)
    motion = random_motion(rng, robot, (300,))
    expected = kernel.forces(motion)
    arrays = [getattr(motion, field.name) for field in dataclasses.fields(motion)]
    blocks = [da.from_array(array, chunks=(37, *array.shape[1:])) for array in arrays]
    by_gufunc = da.apply_gufunc(
        lambda *block: kernel.forces(Motion(**dict(zip(MOTION, block, strict=True))), threads=2),
        "(i,i)" + 7 * ",(i)" + "->(j)",
        *blocks,
        output_dtypes=kernel.dtype,
        output_sizes={"j": 6},
    )
    rest = np.zeros(3)
    by_blocks = da.map_blocks(
        lambda t: kernel.forces(
            Motion(R=np.eye(3), t=t, omega=rest, v=rest, alpha=rest, a=rest), on_singular="nan"
        ),
        blocks[1],
        chunks=(blocks[1].chunks[0], (6,)),
        meta=np.empty((0, 6), kernel.dtype),
    )
    far = cluster.compute(by_gufunc, by_blocks)
    assert same_bits(far[0], expected)
    still = Motion(R=np.eye(3), t=motion.t, omega=rest, v=rest, alpha=rest, a=rest)
    assert same_bits(far[1], kernel.forces(still, on_singular="nan"))


@pytest.mark.parametrize("formulation", ["exact", "paper"])
def test_a_pickled_kernel_comes_back_the_same(formulation: str) -> None:
    rng = np.random.default_rng(31)
    robot = random_robot(rng)
    kernel = ss.ForceKernel(robot, formulation)
    motion = random_motion(rng, robot, (20,))
    back = pickle.loads(pickle.dumps(kernel))
    assert (back.formulation, back.precision) == (formulation, "double")
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
