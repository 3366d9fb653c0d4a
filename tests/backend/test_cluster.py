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
from command_line import rejects
from logged_compiler import LoggedCompiler
from machines import dasgupta, random_motion, random_robot

import stewart_sym as ss
from stewart_sym.backend import native
from stewart_sym.backend.kernel import MOTION
from stewart_sym.motion.motion import Motion
from stewart_sym.studies.reports.workspace_map import grid, map_block, workspace_map

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
    robot, points = dasgupta(), grid(*AXES, chunks=CHUNK)
    assert points.shape == (100_000, 3)
    first = points[:100].compute(scheduler="sync")
    seen = cluster.on_every_worker(lambda: (os.getpid(), map_block(first, np.zeros(3), robot)))
    pids = {pid for pid, _ in seen}
    assert len(pids - {os.getpid()}) == 2
    far = cluster.compute(*workspace_map(robot, points, chunks=CHUNK))
    assert set(cluster.compilations) <= pids
    assert set(cluster.compilations.values()) == {1}
    assert cluster.on_every_worker(lambda: len(native._loaded)) == [1, 1]
    near = map_block(points.compute(scheduler="sync"), np.zeros(3), robot)
    for name, there, here in zip(("condition", "peak"), far, near, strict=True):
        assert same_bits(there, here), name
        assert np.isfinite(there).all(), name
    for _, block in seen:
        assert all(same_bits(part, whole[:100]) for part, whole in zip(block, near, strict=True))


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


def test_a_block_agrees_with_the_dynamics_and_leaves_poses_without_an_answer_nan() -> None:
    rng = np.random.default_rng(32)
    robot = random_robot(rng)
    t = random_motion(rng, robot, (20,)).t.copy()
    t[7] = robot.b[2] - robot.p[2]
    condition, peak = map_block(t, np.zeros(3), robot)
    assert list(np.flatnonzero(np.isnan(peak))) == list(np.flatnonzero(np.isnan(condition))) == [7]
    rest = np.zeros(3)
    found = ss.inverse_dynamics(
        robot, Motion(R=np.eye(3), t=t, omega=rest, v=rest, alpha=rest, a=rest), on_singular="nan"
    )
    good = np.arange(20) != 7
    np.testing.assert_allclose(peak[good], np.abs(found.F[good]).max(axis=-1), rtol=1e-9)
    np.testing.assert_allclose(condition[good], ss.condition_number(found.H)[good], rtol=1e-9)


def test_the_grid_runs_through_z_first() -> None:
    x, y, z = [0.0, 1.0], [2.0, 3.0, 4.0], [5.0, 6.0]
    expected = np.stack(np.meshgrid(x, y, z, indexing="ij"), axis=-1).reshape(-1, 3)
    assert same_bits(grid(x, y, z, chunks=5).compute(scheduler="sync"), expected)


@pytest.mark.parametrize(
    ("t", "theta", "name"),
    [(np.zeros((4, 2)), np.zeros(3), "t"), (np.zeros((4, 3)), np.zeros((5, 3)), "theta")],
)
def test_points_of_another_shape_are_rejected(t: np.ndarray, theta: np.ndarray, name: str) -> None:
    rejects(rf"^{name}: expected", workspace_map, dasgupta(), t, theta)


def same_bits(one: np.ndarray, other: np.ndarray) -> bool:
    return one.dtype == other.dtype and one.shape == other.shape and one.tobytes() == other.tobytes()
