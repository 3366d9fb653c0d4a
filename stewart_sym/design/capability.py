"""Capability at a pose: wrenches and accelerations that the actuators reach within their force limits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from ..dynamics.equations import equations_of_motion
from ..dynamics.inverse import inverse_dynamics
from ..io.arguments import finite_array, instance, option
from ..io.array_types import Array
from ..io.frozen import Frozen
from ..kinematics.inverse import wrench_matrix
from ..motion.motion import Motion
from ..results import OK
from ..robot.robot import Robot, legs_text
from . import polytope

What = Literal["force", "moment", "wrench", "acceleration", "angular_acceleration", "platform_acceleration"]
Others = Literal["zero", "free"]

WHAT: dict[str, tuple[str, slice]] = {
    "force": ("N", slice(0, 3)),
    "moment": ("N m", slice(3, 6)),
    "wrench": ("N, N m", slice(0, 6)),
    "acceleration": ("m/s^2", slice(0, 3)),
    "angular_acceleration": ("rad/s^2", slice(3, 6)),
    "platform_acceleration": ("m/s^2, rad/s^2", slice(0, 6)),
}
"""Unit and components of each, of [force; moment] or [a; alpha]."""


@dataclass(frozen=True, eq=False)
class Capability(Frozen):
    """Vectors x, base frame, within the force limits at poses ``(...)``: a convex polytope for each.

    Attributes
    ----------
    what, unit : str
        What x is, and its unit.
    normals : ndarray
        Unit normals of the polytope's facets, outward, (..., m, d); d is 3, or 6 for both parts together.
    offsets : ndarray
        x is within the limits where normals @ x <= offsets, (..., m); nan at unsolvable poses.
    """

    what: str
    unit: str
    normals: Array
    offsets: Array

    def largest(self, direction: ArrayLike) -> Array:
        """Largest factor >= 0 of a direction within the limits.

        Parameters
        ----------
        direction : array_like
            Not zero, base frame, (..., d); its leading shape broadcasts with that of the poses.

        Returns
        -------
        ndarray
            The factors, (...): for a direction of unit length the size of x. nan where no factor is: where
            the actuators do not hold the pose without x either, and at unsolvable poses.

        Raises
        ------
        ValueError
            For a direction that is zero or of another shape.
        """
        d = self.normals.shape[-1]
        given = finite_array(direction, (d,), "direction")
        if not np.all(np.any(given != 0.0, axis=-1)):
            raise ValueError("direction: expected no zero vector")
        return polytope.farthest(self.normals, self.offsets, given)

    @property
    def guaranteed(self) -> Array:
        """Size of x that is within the limits in whatever direction, (...); below 0 where not even x = 0 is.

        Raises
        ------
        ValueError
            For d = 6, whose parts have different units.
        """
        if self.normals.shape[-1] == 6:
            raise ValueError(f"guaranteed: expected d = 3, {self.what} has parts of different units")
        return np.asarray(self.offsets.min(axis=-1))

    def vertices(self) -> Array:
        """Corners of the polytope of a single pose.

        Returns
        -------
        ndarray
            In ``unit``, base frame, (n, d).

        Raises
        ------
        ValueError
            For a batch of poses and for an unsolvable one.
        """
        if self.offsets.ndim != 1:
            raise ValueError(f"vertices: expected a single pose, got shape {self.offsets.shape[:-1]}")
        if np.isnan(self.offsets).any():
            raise ValueError("vertices: expected a pose whose forces can be solved for")
        return polytope.vertices(self.normals, self.offsets)


def capability(robot: Robot, motion: Motion, what: What = "force", others: Others = "zero") -> Capability:
    """Return which wrenches or accelerations the actuators reach within the robot's force limits.

    Parameters
    ----------
    robot : Robot
        The machine, with a force limit for every leg.
    motion : Motion
        Poses, any leading shape, and what goes on there: rates and load always count, accelerations for
        wrenches.
    what : str, optional
        "force" or "moment" that the platform exerts on its surroundings beside the load, about the reference
        point, or both as "wrench"; "acceleration" of the reference point or "angular_acceleration" of the
        platform, or both as "platform_acceleration"; base frame.
    others : {"zero", "free"}, optional
        Whether the other part, the moment beside a force and so on, has to be zero or may be anything.

    Returns
    -------
    Capability
        A polytope for each pose.

    Raises
    ------
    ValueError
        Naming the argument; for a leg without a force limit, and for a motion without accelerations.
    """
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    option(what, tuple(WHAT), "what")
    option(others, ("zero", "free"), "others")
    unlimited = np.flatnonzero(np.isinf(robot.force_limit)).tolist()
    if unlimited:
        raise ValueError(f"robot: force_limit: expected one for every leg, {legs_text(unlimited)} have none")
    unit, part = WHAT[what]
    accelerates = what.endswith("acceleration")
    if accelerates:
        rest = np.zeros_like(motion.t)
        given = motion.omega, motion.v, rest, rest, motion.F_ext, motion.M_ext
        motion = Motion.unchecked(motion.R, motion.t, *given)
    found = inverse_dynamics(robot, motion, on_singular="nan")
    solved = found.status == OK
    A = np.full((*motion.shape, 6, 6), np.nan)
    H = wrench_matrix(robot, motion[solved])
    gained = equations_of_motion(robot, motion[solved]).M if accelerates else np.eye(6)
    A[solved] = np.linalg.solve(H, np.broadcast_to(gained, H.shape))
    F = np.where(solved[..., None], found.F, np.nan)
    if others == "zero" or part == slice(0, 6):
        return Capability(what, unit, *polytope.cut(A[..., part], F, robot.force_limit))
    B = np.full_like(A, np.nan)
    B[solved] = np.linalg.solve(np.broadcast_to(gained, H.shape), H)
    return Capability(what, unit, *polytope.projected(B[..., part, :], F, robot.force_limit))
