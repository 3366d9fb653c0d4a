"""Limits of a pose: leg lengths, joint angles, leg clearance, condition number, and actuator forces."""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from ..dynamics.forces import forces_of
from ..dynamics.home_pose import home_pose
from ..io.arguments import finite_array, instance, number_in, truth
from ..io.array_types import Array, Flags, Frozen
from ..kinematics.clearance import PAIRS, distances_of, joined, neutral_directions
from ..kinematics.conditioning import characteristic_length, scaled_condition_number
from ..kinematics.inverse_kinematics import leg_axes, leg_vectors, length_rows
from ..kinematics.mounting_side import up_direction
from ..kinematics.pose_search import rates_per_twist
from ..motion.motion import Motion
from ..robot.offsets import need_no_offsets
from ..robot.robot import Robot, legs_text

REASONS = (
    *("feasible", "assembly_mode", "leg_length", "joint_angle"),
    *("leg_clearance", "condition_number", "actuator_force"),
)
"""Names of the codes of ``broken_limits``, in their order."""
INSIDE, SIDE, LENGTH, ANGLE, CLEARANCE, CONDITION, FORCE = range(len(REASONS))

BLOCK = 4096
"""Number of poses per block, small enough for the processor cache."""

# Distance of joints, relative to the machine size, below which they coincide.
_SAME = 1e-6


@dataclass(frozen=True, eq=False)
class PoseLimits(Frozen):
    """Limits of a pose. The limits of the robot file apply if they are present there.

    Attributes
    ----------
    lengths, joint_angles, forces : bool, optional
        Flags that apply the robot's limits of leg lengths, joint angles, and actuator forces. Force limits
        are ignored for a robot file without masses.
    max_condition : float, optional
        Largest scaled condition number of H (dimensionless). If it is finite, det H must also have the same
        sign as at the home pose, because other poses can be reached only through a singular pose.
    min_clearance : float, optional
        Smallest distance between the center lines of two legs (m). Legs with a common joint are ignored.
    load : array_like, shape (6,), optional
        External wrench [F_ext; M_ext] on the platform (N, N m) in the platform frame, as in ``Motion``, that
        acts while the platform is at rest.

    Raises
    ------
    ValueError
        If a field is invalid.
    """

    lengths: bool = True
    joint_angles: bool = True
    forces: bool = True
    max_condition: float = math.inf
    min_clearance: float = 0.0
    load: Array = field(default_factory=lambda: np.zeros(6))

    def __post_init__(self) -> None:
        """Check all fields."""
        for name in ("lengths", "joint_angles", "forces"):
            truth(getattr(self, name), name)
        if not (isinstance(self.max_condition, float) and self.max_condition == math.inf):
            number_in(self.max_condition, "max_condition", "a number > 1, or infinity for no limit", low=1.0)
        number_in(self.min_clearance, "min_clearance", "a distance >= 0 m", closed=True)
        self._set({"load": finite_array(self.load, (6,), "load").reshape(6)})


def at_reference(robot: Robot, limits: PoseLimits) -> PoseLimits:
    """Return the limits with the load moved from the robot's tool to the reference point."""
    force, moment = limits.load[:3], limits.load[3:]
    return replace(limits, load=np.concatenate([force, moment + np.cross(robot.tool, force)]))


def applies_forces(robot: Robot, limits: PoseLimits) -> bool:
    """Return True if the force limits apply: they are given, and so are all masses."""
    return limits.forces and bool(np.isfinite(robot.force_limit).any()) and not robot.missing_bodies


def need_clearance(robot: Robot, clearance: float) -> None:
    """Raise ValueError for a clearance (m) that two neighboring joints exclude in every pose."""
    distances = joined(robot)
    tight = np.flatnonzero((distances < clearance) & _apart(robot))
    if tight.size:
        raise ValueError(
            f"min_clearance: expected less than {distances[tight[0]]:.4g} m, the distance of joints of "
            f"{legs_text(PAIRS[tight[0]])}, got {clearance:g} m"
        )


def _apart(robot: Robot) -> Flags:
    """Return True for pairs of legs without a common joint."""
    return np.asarray(joined(robot) > _SAME * characteristic_length(robot))


@dataclass(frozen=True, eq=False)
class PoseExaminer(Frozen):
    """Robot and limits for the examination of poses.

    up: unit vector from the base to the platform in the base frame, shape (3,). side: sign of det H at the
    home pose.
    """

    robot: Robot
    limits: PoseLimits
    up: Array = field(init=False)
    side: float = field(init=False)

    def __post_init__(self) -> None:
        """Check that the limits are consistent, and compute the data that all poses share."""
        instance(self.robot, Robot, "robot")
        instance(self.limits, PoseLimits, "limits")
        t = home_pose(self.robot).t
        R, t = np.eye(3)[None], t[None]
        H = self._rows(R, t, *leg_axes(self.robot, R, t))[0]
        self._set({"up": up_direction(self.robot).copy(), "side": float(np.sign(np.linalg.det(H)))})
        need_clearance(self.robot, self.limits.min_clearance)

    def broken_limits(self, R: Array, t: Array) -> NDArray[np.int8]:
        """Return the code of the first limit that each pose violates, an index of ``REASONS``, shape (n,).

        R: (n, 3, 3). t: (n, 3) (m).
        """
        found = np.empty(len(t), dtype=np.int8)
        for start in range(0, len(t), BLOCK):
            part = slice(start, start + BLOCK)
            found[part] = self._block(R[part], t[part])
        return found

    def surely_broken(self, R: Array, t: Array, shift: Array, turn: Array, point: Array) -> Flags:
        """Return True, shape (n,), if every pose near R (n, 3, 3) and t (n, 3) violates a limit.

        shift: largest displacement (m), shape (n,), of the platform point ``point``, shape (3,). turn:
        largest rotation about the point (rad), shape (n,). Only leg lengths and the side of the base are
        tested, because both have bounds.
        """
        robot = self.robot
        _, _, L = leg_vectors(robot, R, t)
        middle = robot.p.mean(axis=0)
        over = (R @ middle + t - robot.b.mean(axis=0)) @ self.up
        slack = _SAME * characteristic_length(robot)
        broken = over + shift + turn * np.linalg.norm(middle - point) < -slack
        if self.limits.lengths:
            low, high = robot.length_limits.T
            change = shift[:, None] + turn[:, None] * np.linalg.norm(robot.p - point, axis=-1) + slack
            broken |= np.any((L + change < low) | (L - change > high), axis=-1)
        return np.asarray(broken)

    def conditions(self, R: Array, t: Array) -> Array:
        """Return the scaled condition numbers of H at poses R (n, 3, 3) and t (n, 3), shape (n,)."""
        H = np.swapaxes(self._rows(R, t, *leg_axes(self.robot, R, t)), -1, -2)
        return scaled_condition_number(H, 1.0)

    def _block(self, R: Array, t: Array) -> NDArray[np.int8]:
        robot, limits = self.robot, self.limits
        codes = np.zeros(len(t), dtype=np.int8)
        q, S, L = leg_axes(robot, R, t)
        over = (q.mean(axis=-2) + t - robot.b.mean(axis=0)) @ self.up
        codes[over < 0.0] = SIDE
        left = np.flatnonzero(over >= 0.0)

        def keep(good: Flags, reason: int) -> None:
            nonlocal left
            codes[left[~good]] = reason
            left = left[good]

        if limits.lengths:
            low, high = robot.length_limits.T
            keep(np.all((low <= L[left]) & (L[left] <= high), axis=-1), LENGTH)
        if limits.joint_angles and robot.has_joint_angle_limits:
            keep(self._angles_kept(R[left], S[left], L[left]), ANGLE)
        if limits.min_clearance > 0.0:
            apart = _apart(robot)
            need_no_offsets(robot)
            keep(np.all(distances_of(robot.b, S[left])[:, apart] >= limits.min_clearance, axis=-1), CLEARANCE)
        if limits.max_condition < math.inf:
            keep(self._conditions_kept(R[left], t[left], q[left], S[left], L[left]), CONDITION)
        if applies_forces(robot, limits):
            keep(self._forces_kept(R[left], t[left]), FORCE)
        return codes

    def _angles_kept(self, R: Array, S: Array, L: Array) -> Flags:
        neutral = neutral_directions(self.robot)
        ends = np.stack([S, S @ R], axis=-2) / np.where(L > 0.0, L, 1.0)[..., None, None]
        cosines = np.einsum("nlek,lk->nle", ends, neutral)
        return np.asarray(
            np.all(cosines >= np.cos(np.minimum(self.robot.joint_angle_limit, np.pi)), axis=(-2, -1))
        )

    def _rows(self, R: Array, t: Array, q: Array, S: Array, L: Array) -> Array:
        """Return H^T, shape (n, 6, 6), with moments divided by the characteristic length."""
        robot = self.robot
        rows = length_rows(q, S, L) if robot.offsets is None else rates_per_twist(robot, R, t, screws=True)
        rows[..., 3:] /= characteristic_length(robot) or 1.0
        return rows

    def _conditions_kept(self, R: Array, t: Array, q: Array, S: Array, L: Array) -> Flags:
        rows, most = self._rows(R, t, q, S, L), self.limits.max_condition
        signs = np.sign(np.linalg.det(rows))
        kept = (signs == self.side) & (signs != 0.0)
        rows = rows[kept]
        # The condition number in the Frobenius norm is between one and six times the exact value.
        norms = (np.sqrt(np.einsum("nij,nij->n", one, one)) for one in (rows, np.linalg.inv(rows)))
        near = functools.reduce(np.multiply, norms)
        good = near <= most
        open_ = ~good & (near <= 7.0 * most)
        good[open_] = scaled_condition_number(rows[open_], 1.0) <= most
        kept[kept] = good
        return np.asarray(kept)

    def _forces_kept(self, R: Array, t: Array) -> Flags:
        """Return True for poses with forces within the limits at rest; False for singular poses."""
        robot, load, zero = self.robot, self.limits.load, np.zeros_like(t)
        loads = (np.broadcast_to(part, t.shape) for part in (load[:3], load[3:]))
        motion = Motion._unchecked(R, t, zero, zero, zero, zero, *loads)
        F = forces_of(robot, "exact", "c")(motion)
        return np.asarray(np.all(np.abs(F) <= robot.force_limit, axis=-1))
