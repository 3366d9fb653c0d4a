"""Workspace map of condition number and peak actuator force at rest under gravity, on one machine or a
cluster.

``.docs/howto/cluster.md`` describes the use (extra ``cluster``). Every process of every worker compiles the
kernel at most once, and only if its cache folder does not contain the kernel.
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...dynamics.forces import ForceKernel
from ...dynamics.inverse_dynamics import Formulation
from ...io.array_types import Array, Codes
from ...io.extras import needed_for
from ...kinematics.conditioning import condition_number
from ...kinematics.inverse_kinematics import wrench_matrix
from ...motion.motion import Motion
from ...results import NOT_FINITE, ZERO_LENGTH
from ...robot.robot import Robot

with needed_for("a map of the workspace"):
    import dask.array as da


CHUNK = 100_000
"""Number of poses in one block, which requires a fraction of a second and about 200 MB."""


def grid(x: ArrayLike, y: ArrayLike, z: ArrayLike, chunks: int = CHUNK) -> Any:
    """Create the points of a regular grid (m), z fastest, as a Dask array, shape (n, 3), block by block."""
    axes = [np.asarray(axis, dtype=np.float64) for axis in (x, y, z)]
    index = da.arange(int(np.prod([axis.size for axis in axes])), chunks=chunks)
    return da.map_blocks(
        grid_block, index, axes=axes, new_axis=1, chunks=(index.chunks[0], (3,)), meta=np.empty((0, 3))
    )


def workspace_map(
    robot: Robot,
    t: Any,
    theta: Any = (0.0, 0.0, 0.0),
    formulation: Formulation = "exact",
    chunks: int = CHUNK,
) -> tuple[Any, Any]:
    """Compute condition number of H and peak actuator force at every pose, at rest under gravity.

    ``t`` are positions of the reference point (m), shape (n, 3), ``theta`` roll, pitch, and yaw (rad), shape
    (n, 3) or (3,), as arrays of NumPy or Dask, and ``chunks`` poses form a block. Returns uncomputed Dask
    arrays of shape (n,); see ``map_block``. Raises ValueError for other shapes.
    """
    t, theta = da.asarray(t), da.asarray(theta)
    if t.ndim != 2 or t.shape[1] != 3:
        raise ValueError(f"t: expected points of shape (n, 3), got {t.shape}")
    if theta.shape not in ((3,), t.shape):
        raise ValueError(f"theta: expected angles of shape (3,) or {t.shape}, got {theta.shape}")
    blocks = (chunks, 3)
    condition, peak = da.apply_gufunc(
        map_block,
        "(i),(i)->(),()",
        t.rechunk(blocks),
        theta.rechunk(blocks[-theta.ndim :]),
        output_dtypes=(np.float64, np.float64),
        robot=robot,
        formulation=formulation,
    )
    return condition, peak


def grid_block(index: NDArray[np.int64], axes: list[Array]) -> Array:
    """Return the points of the grid, shape (n, 3), with the given indices, shape (n,)."""
    places = np.unravel_index(index, [axis.size for axis in axes])
    return np.stack([axis[place] for axis, place in zip(axes, places, strict=True)], axis=-1)


def map_block(
    t: Array, theta: Array, robot: Robot, formulation: Formulation = "exact"
) -> tuple[Array, Array]:
    """Compute the condition number of H (mixed units, as in the paper) and the largest |F_i| (N) at rest.

    The arrays have shape (..., 3), positions in m and angles in rad. Forces are nan at unsolvable poses. The
    condition number of a singular pose is very large or inf.
    """
    rest = np.zeros(3)
    motion = Motion.from_rpy(t, theta, rest, rest, rest, rest)
    # The kernel is prepared here in a fraction of a millisecond, so that only the robot is transmitted.
    kernel = ForceKernel(robot, formulation)
    F, status = kernel.forces_and_status(motion)
    return _condition(robot, motion, status), np.abs(F).max(axis=-1)


def _condition(robot: Robot, motion: Motion, status: Codes) -> Array:
    """Compute the condition number of H, (36), if the directions of the legs are defined."""
    condition = np.full(motion.shape, np.nan)
    sound = ~np.isin(status, (ZERO_LENGTH, NOT_FINITE))
    if sound.any():
        there = motion[sound]
        condition[sound] = condition_number(wrench_matrix(robot, there))
    return condition
