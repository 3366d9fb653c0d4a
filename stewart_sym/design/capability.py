"""Capability at a pose: wrenches and accelerations that the actuators reach within their force limits.

The actuator forces form a box, which a regular matrix maps to a parallelepiped with twelve facets. If the
complementary components are zero, the parallelepiped is cut. If they are free, it is projected onto a
zonotope, whose facets are spanned by pairs of its six generators.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from ..dynamics.equations import equations_of_motion
from ..dynamics.inverse_dynamics import inverse_dynamics
from ..io.arguments import finite_array, instance, option
from ..io.array_types import Array, Frozen
from ..kinematics.inverse_kinematics import wrench_matrix
from ..motion.motion import Motion
from ..results import OK
from ..robot.robot import Robot, about_point, legs_text

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
"""Unit and components of each quantity within [force; moment] or [a; alpha]."""

_PAIRS = np.array(list(itertools.combinations(range(6), 2))).T
# Length of a facet normal, relative to the product of its generators, below which they are parallel.
_PARALLEL = 1e-12
# Tolerance of a vertex, relative to the largest offset; vertices within ten times this value are equal.
_SAME = 1e-9


@dataclass(frozen=True, eq=False)
class Polytope(Frozen):
    """Convex polytope of the vectors x in the base frame that are within the force limits, for each pose.

    The leading shape ``(...)`` is the shape of the poses.

    Attributes
    ----------
    quantity, unit : str
        Name and unit of x.
    normals : ndarray, shape (..., m, d)
        Outward unit normals of the facets; d is 3, or 6 for both parts together.
    offsets : ndarray, shape (..., m)
        Offsets of the facets in ``unit``: x is within the limits if normals @ x <= offsets. NaN at unsolvable
        poses.
    """

    quantity: str
    unit: str
    normals: Array
    offsets: Array

    def max_along(self, direction: ArrayLike) -> Array:
        """Compute the largest nonnegative multiple of a direction that is within the limits.

        Parameters
        ----------
        direction : array_like, shape (..., d)
            Nonzero direction in the base frame; its leading shape broadcasts with the shape of the poses.

        Returns
        -------
        ndarray, shape (...)
            Factors; for a unit vector, the magnitude of x in ``unit``. NaN if no factor exists, because the
            force limits are exceeded even without x, and at unsolvable poses.

        Raises
        ------
        ValueError
            If the direction is zero or has another shape.
        """
        d = self.normals.shape[-1]
        given = finite_array(direction, (d,), "direction")
        if not np.all(np.any(given != 0.0, axis=-1)):
            raise ValueError("direction: expected no zero vector")
        return _farthest(self.normals, self.offsets, given)

    @property
    def inscribed_radius(self) -> Array:
        """Magnitude of x in ``unit`` that is within the limits in every direction, shape (...).

        Negative if x = 0 violates a limit.

        Raises
        ------
        ValueError
            If d = 6, because the parts have different units.
        """
        if self.normals.shape[-1] == 6:
            raise ValueError(
                f"inscribed_radius: expected d = 3, {self.quantity} has parts with different units"
            )
        return np.asarray(self.offsets.min(axis=-1))

    def vertices(self) -> Array:
        """Compute the vertices of the polytope of a single pose.

        Returns
        -------
        ndarray, shape (n, d)
            Vertices in the base frame, in ``unit``.

        Raises
        ------
        ValueError
            If the result contains a batch of poses or an unsolvable pose.
        """
        if self.offsets.ndim != 1:
            raise ValueError(f"vertices: expected a single pose, got shape {self.offsets.shape[:-1]}")
        if np.isnan(self.offsets).any():
            raise ValueError("vertices: expected a solvable pose")
        return _vertices(self.normals, self.offsets)


def capability_polytope(
    robot: Robot, motion: Motion, quantity: What = "force", complement: Others = "zero"
) -> Polytope:
    """Compute the wrenches or accelerations that the actuators can produce within the robot's force limits.

    Parameters
    ----------
    robot : Robot
        Robot with a force limit for every leg.
    motion : Motion
        Motion of the reference point with any leading shape. Rates and loads are always included;
        accelerations are included and required for wrenches.
    quantity : str, optional
        "force" or "moment" that the platform exerts on its surroundings at the robot's tool, in addition to
        the load, or both as "wrench". Or "acceleration" of the tool or "angular_acceleration" of the
        platform, or both as "platform_acceleration". All in the base frame.
    complement : {"zero", "free"}, optional
        Complementary components, for example the moment if ``quantity`` is "force": zero or unrestricted.

    Returns
    -------
    Polytope
        One convex polytope per pose.

    Raises
    ------
    ValueError
        If an argument is invalid, a leg has no force limit, or accelerations are required and missing.

    See Also
    --------
    inverse_dynamics : Compute the actuator forces of a motion.
    workspace : Compute the poses within the limits of a robot.

    Notes
    -----
    The tool is the reference point if the robot file specifies no tool.

    Examples
    --------
    >>> import dataclasses
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = dataclasses.replace(ss.robots.load("unal"), force_limit=np.full(6, 500.0))
    >>> zero = np.zeros(3)
    >>> motion = ss.Motion(R=np.eye(3), t=[0, 0, 0.7], omega=zero, v=zero, alpha=zero, a=zero)
    >>> polytope = ss.capability_polytope(robot, motion)
    >>> round(float(polytope.max_along([0.0, 0.0, 1.0])))
    2931
    >>> round(float(polytope.inscribed_radius))
    212
    """
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    option(quantity, tuple(WHAT), "quantity")
    option(complement, ("zero", "free"), "complement")
    unlimited = np.flatnonzero(np.isinf(robot.force_limit)).tolist()
    if unlimited:
        raise ValueError(f"robot: force_limit: expected one for every leg, {legs_text(unlimited)} have none")
    if robot.tool.any():
        robot, motion = about_point(robot, robot.tool), motion.at_point(robot.tool)
    unit, part = WHAT[quantity]
    accelerates = quantity.endswith("acceleration")
    if accelerates:
        rest = np.zeros_like(motion.t)
        given = motion.omega, motion.v, rest, rest, motion.F_ext, motion.M_ext
        motion = Motion._unchecked(motion.R, motion.t, *given)
    found = inverse_dynamics(robot, motion, on_singular="nan")
    solved = found.status == OK
    A = np.full((*motion.shape, 6, 6), np.nan)
    H = wrench_matrix(robot, motion[solved])
    gained = equations_of_motion(robot, motion[solved]).M if accelerates else np.eye(6)
    A[solved] = np.linalg.solve(H, np.broadcast_to(gained, H.shape))
    F = np.where(solved[..., None], found.F, np.nan)
    if complement == "zero" or part == slice(0, 6):
        return Polytope(quantity, unit, *_cut(A[..., part], F, robot.force_limit))
    B = np.full_like(A, np.nan)
    B[solved] = np.linalg.solve(np.broadcast_to(gained, H.shape), H)
    return Polytope(quantity, unit, *_projected(B[..., part, :], F, robot.force_limit))


# Polytopes by half-spaces


def _cut(A: Array, forces: Array, limits: Array) -> tuple[Array, Array]:
    """Return half-spaces n . x <= o of |A x + forces| <= limits: unit n (..., 12, d), o (..., 12)."""
    normals = np.concatenate([A, -A], axis=-2)
    offsets = np.concatenate([limits - forces, limits + forces], axis=-1)
    return _unit_normals(normals, offsets)


def _projected(B: Array, forces: Array, limits: Array) -> tuple[Array, Array]:
    """Return half-spaces n . x <= o of {B (f - forces): |f| <= limits}: n (..., 30, 3), o (..., 30)."""
    generators = np.swapaxes(B * limits, -1, -2)
    one, other = generators[..., _PAIRS[0], :], generators[..., _PAIRS[1], :]
    normals = np.cross(one, other)
    largest = np.max(np.linalg.norm(generators, axis=-1), axis=-1)[..., None, None]
    parallel = np.linalg.norm(normals, axis=-1, keepdims=True) <= _PARALLEL * largest**2
    normals = np.where(parallel, 0.0, normals)
    reach = np.abs(normals @ np.swapaxes(generators, -1, -2)).sum(axis=-1)
    center = -(normals @ (B @ forces[..., None]))[..., 0]
    return _unit_normals(
        np.concatenate([normals, -normals], axis=-2),
        np.concatenate([reach + center, reach - center], axis=-1),
    )


def _unit_normals(normals: Array, offsets: Array) -> tuple[Array, Array]:
    """Scale half-spaces to unit normals; a half-space without a normal becomes all of space."""
    size = np.linalg.norm(normals, axis=-1)
    none = size == 0.0
    safe = np.where(none, 1.0, size)
    return normals / safe[..., None], np.where(none, np.inf, offsets / safe)


def _farthest(normals: Array, offsets: Array, directions: Array) -> Array:
    """Return the largest lambda >= 0 with lambda * direction in the polytope, shape (...); else NaN."""
    along = np.einsum("...mk,...k->...m", normals, directions)
    with np.errstate(divide="ignore", invalid="ignore"):
        ends = offsets / along
    most = np.min(np.where(along > 0.0, ends, np.inf), axis=-1)
    least = np.max(np.where(along < 0.0, ends, 0.0), axis=-1)
    missed = np.any((along == 0.0) & (offsets < 0.0), axis=-1) | np.isnan(offsets).any(axis=-1)
    return np.asarray(np.where(missed | (most < least), np.nan, most))


def _vertices(normals: Array, offsets: Array) -> Array:
    """Return the vertices, shape (n, d), of a polytope: intersections of d planes that satisfy all others."""
    d = normals.shape[-1]
    some = np.isfinite(offsets)
    normals, offsets = normals[some], offsets[some]
    sets = np.array(list(itertools.combinations(range(len(offsets)), d)))
    planes = normals[sets]
    regular = np.abs(np.linalg.det(planes)) > _PARALLEL
    met = np.linalg.solve(planes[regular], offsets[sets[regular]][..., None])[..., 0]
    slack = _SAME * np.abs(offsets).max()
    met = met[np.all(met @ normals.T <= offsets + slack, axis=-1)]
    found: list[Array] = []
    for point in met:
        if all(np.abs(point - other).max() > 10.0 * slack for other in found):
            found.append(point)
    return np.array(found).reshape(-1, d)
