"""Kernels in other processes: pickled kernels return the same bits, and load without a compiler."""

import os
import pickle
import subprocess
import sys
from pathlib import Path

import numpy as np
from machines import dasgupta, random_motion, random_robot

import stewart_sym as ss

WAIT = 300
"""Seconds after which a cluster that does not answer is given up; a busy machine may be slow."""


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
