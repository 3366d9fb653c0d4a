"""Map of a workspace: condition number and peak actuator force at rest under gravity, on one machine or many.

``.docs/howto/cluster.md`` shows how (extra ``cluster``). Every process of every worker compiles the kernel at
most once, and not at all if its cache folder holds it.
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
"""Poses in one block: a fraction of a second of work, some 200 MB while it lasts."""


def grid(x: ArrayLike, y: ArrayLike, z: ArrayLike, chunks: int = CHUNK) -> Any:
    """Points of a regular grid, m, (n, 3), z running fastest, as a Dask array that is made block by block."""
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
    """Condition number of H and peak actuator force at every pose, at rest under gravity.

    t: positions of the reference point, m, (n, 3). theta: roll-pitch-yaw angles, rad, (n, 3) or (3,), (38).
    Either may be a Dask array. chunks: poses in one block.

    Returns two Dask arrays (n,), which nothing has computed yet; see ``map_block``. Raises ValueError for any
    other shape.
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
    """Points, (n, 3), of the grid with these numbers, (n,)."""
    places = np.unravel_index(index, [axis.size for axis in axes])
    return np.stack([axis[place] for axis, place in zip(axes, places, strict=True)], axis=-1)


def map_block(
    t: Array, theta: Array, robot: Robot, formulation: Formulation = "exact"
) -> tuple[Array, Array]:
    """Condition number of H (paper's, units mixed) and largest |F_i|, N, at rest, both (...).

    t, theta: (..., 3), m and rad. nan where the pose is unsolvable: no force at a singular pose, neither at
    a leg of length zero. The condition number of a singular pose is very large or inf.
    """
    rest = np.zeros(3)
    motion = Motion.from_rpy(t, theta, rest, rest, rest, rest)
    # Prepared here, in a fraction of a millisecond, so that only the robot travels.
    kernel = ForceKernel(robot, formulation)
    F, status = kernel.forces_and_status(motion)
    return _condition(robot, motion, status), np.abs(F).max(axis=-1)


def _condition(robot: Robot, motion: Motion, status: Codes) -> Array:
    """Condition number of H of (36), wherever the legs have directions."""
    condition = np.full(motion.shape, np.nan)
    sound = ~np.isin(status, (ZERO_LENGTH, NOT_FINITE))
    if sound.any():
        there = motion[sound]
        condition[sound] = condition_number(wrench_matrix(robot, there))
    return condition
