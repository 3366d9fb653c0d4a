"""Forward dynamics of single states from compiled forces, for robots without a closed-form kernel.

Forces are F_0 + A [a; alpha]. The columns of A = H^-1 M are the forces of six unit accelerations at rest,
without gravity and friction. F_0 are the forces of the state without acceleration.
"""

import numpy as np

from ..io.array_types import Array
from ..kinematics.conditioning import characteristic_length
from ..motion.motion import Motion
from ..reference.equations_of_motion import bare_robot
from ..robot.robot import Robot
from .forces import ForceKernel

_MOST_CONDITION = 1e5
"""Largest condition number of A, scaled by the characteristic length, for an accurate inverse."""


class ForwardFromInverse:
    """Robot prepared for computing its accelerations, with buffers: each thread needs its own object."""

    def __init__(self, robot: Robot) -> None:
        """Raise ValueError for a robot without a force kernel, ``CompilerError`` without a compiler."""
        self._moving, self._still = (ForceKernel(each).single_pose() for each in (robot, bare_robot(robot)))
        self._length = np.repeat([1.0, 1.0 / characteristic_length(robot)], 3)

    def solve(self, motion: Motion, F: Array) -> Array | None:
        """Return [a; alpha], (6,), of a state under F (N), (6,); None near a singular pose."""
        moving, still = self._moving, self._still
        moving.load(motion)
        moving.alpha[:], moving.a[:] = 0.0, 0.0
        still.R[:], still.t[:] = motion.R, motion.t
        status = moving.solve()
        A = np.empty((6, 6))
        for i in range(6):
            part = still.a if i < 3 else still.alpha
            part[i % 3] = 1.0
            status = status or still.solve()
            part[i % 3] = 0.0
            A[:, i] = still.F * self._length[i]
        if status or not np.isfinite(A).all() or not np.linalg.cond(A) < _MOST_CONDITION:
            return None
        return np.asarray(self._length * np.linalg.solve(A, F - moving.F))
