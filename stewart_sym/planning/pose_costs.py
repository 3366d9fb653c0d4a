"""Condition number and violation of limits of a pose, with derivatives with respect to the pose.

Derivatives are with respect to twists: the position moves by dt in the base frame, and R becomes
exp([dphi]x) R.
"""

import math
from dataclasses import dataclass, field

import numpy as np

from ..design.pose_limits import PoseLimits
from ..io.array_types import Array, Frozen
from ..kinematics.clearance import PAIRS, joined, nearest_shares, neutral_directions
from ..kinematics.conditioning import characteristic_length
from ..kinematics.inverse_kinematics import leg_vectors
from ..motion.rotation import cross
from ..robot.robot import Robot

_ONE, _OTHER = np.array(PAIRS).T
# Margin of a path from its limits at the samples, relative to the characteristic length or as a cosine.
ROOM = 2e-3
_SAME = 1e-6
# Smallest sine of the angle between a leg and its fixed joint axis, because forces increase with its inverse.
_LEAST_SINE = 0.05


@dataclass(frozen=True, eq=False)
class PoseCosts(Frozen):
    """Costs of poses of one robot.

    Attributes
    ----------
    robot : Robot
        Robot model.
    limits : PoseLimits
        Limits of a pose.
    tool : ndarray, shape (3,)
        Tool point in the platform frame (m).
    side : float
        Sign of det H along the path.
    least : float
        Smallest singular value below which the condition number is replaced by its tangent, so that it
        increases through singular poses.
    length : float
        Characteristic length (m).
    """

    robot: Robot
    limits: PoseLimits
    tool: Array
    side: float
    least: float
    length: float = field(init=False)

    def __post_init__(self) -> None:
        """Compute the characteristic length."""
        self._set({"length": characteristic_length(self.robot) or 1.0, "tool": np.array(self.tool)})

    def conditions(self, R: Array, t: Array) -> tuple[Array, Array]:
        """Compute condition numbers of H about the reference point, (n,), and derivatives, (n, 6)."""
        q, s, L, H = self._matrices(R, t)
        u, values, vh = np.linalg.svd(H)
        sign = np.sign(np.linalg.det(H)) * self.side
        largest, smallest = values[:, 0], sign * values[:, -1]
        d_largest = self._rate(q, s, L, u[:, :, 0], vh[:, 0])
        d_smallest = sign[:, None] * self._rate(q, s, L, u[:, :, -1], vh[:, -1])
        floor = self.least or np.finfo(np.float64).tiny ** 0.25
        inside = smallest >= floor
        safe = np.where(inside, smallest, floor)
        inverse = np.where(inside, 1.0 / safe, (2.0 - smallest / floor) / floor)
        slope = -1.0 / safe**2
        rate = inverse[:, None] * d_largest + (largest * slope)[:, None] * d_smallest
        # A rotation about the tool moves the reference point by -dphi x arm.
        rate[:, 3:] -= cross(R @ self.tool, rate[:, :3])
        return largest * inverse, rate

    def _matrices(self, R: Array, t: Array) -> tuple[Array, Array, Array, Array]:
        """Compute q, s, L, and H with moments divided by the characteristic length, shape (n, 6, 6)."""
        q, S, L = leg_vectors(self.robot, R, t - R @ self.tool)
        s = S / L[..., None]
        return q, s, L, np.swapaxes(np.concatenate([s, cross(q, s) / self.length], axis=-1), -1, -2)

    def _rate(self, q: Array, s: Array, L: Array, u: Array, v: Array) -> Array:
        """Compute the derivative of u^T H v by the twist of the reference point, shape (n, 6)."""
        force, moment = u[:, None, :3], u[:, None, 3:] / self.length
        along = v[:, :, None] * (force + cross(moment, q))
        g = (along - np.sum(along * s, axis=-1, keepdims=True) * s) / L[..., None]
        turn = cross(q, g + v[:, :, None] * cross(s, moment))
        return np.asarray(np.concatenate([g, turn], axis=-1).sum(axis=1))

    def excesses(
        self, R: Array, t: Array, known: tuple[Array, Array] | None = None
    ) -> list[tuple[str, Array, Array]]:
        """Compute the violations of each limit: its name, values (n, k), and derivatives (n, k, 6).

        ``known`` is the result of ``conditions`` for these poses, if available.
        """
        # Points are relative to the tool, the center of the rotations.
        arm = R @ self.tool
        q, S, L = leg_vectors(self.robot, R, t - arm)
        q, s = q - arm[:, None, :], S / L[..., None]
        found: list[tuple[str, Array, Array]] = []
        if self.limits.lengths:
            found += [("leg length", *part) for part in self._lengths(q, s, L)]
        if self.robot.base_joint == "universal":
            found.append(("angle to the fixed axis of its universal joint", *self._axes(q, s, L)))
        if self.limits.joint_angles and self.robot.has_joint_angle_limits:
            found += [("joint angle", *part) for part in self._angles(R, q, s, L)]
        if self.limits.min_clearance > 0.0:
            found.append(("leg clearance", *self._clearances(q, S)))
        if self.limits.max_condition < math.inf:
            value, rate = self.conditions(R, t) if known is None else known
            most = self.limits.max_condition
            found.append(("condition number", (value / most - 1.0 + ROOM)[:, None], rate[:, None] / most))
        return found

    def _lengths(self, q: Array, s: Array, L: Array) -> list[tuple[Array, Array]]:
        """Compute the violations of the length limits."""
        rate = np.concatenate([s, cross(q, s)], axis=-1) / self.length
        low, high = self.robot.length_limits.T
        parts = []
        if np.isfinite(high).any():
            parts.append(((L - high) / self.length + ROOM, rate))
        if (low > 0.0).any():
            parts.append(((low - L) / self.length + ROOM, -rate))
        return parts

    def _axes(self, q: Array, s: Array, L: Array) -> tuple[Array, Array]:
        """Compute the cosines between legs and fixed axes of their universal joints, minus their limit."""
        cosine = np.sum(s * self.robot.k, axis=-1)
        g = np.sign(cosine)[..., None] * (self.robot.k - cosine[..., None] * s) / L[..., None]
        excess = np.abs(cosine) - math.sqrt(1.0 - _LEAST_SINE**2) + ROOM
        return excess, np.concatenate([g, cross(q, g)], axis=-1)

    def _angles(self, R: Array, q: Array, s: Array, L: Array) -> list[tuple[Array, Array]]:
        """Compute cosines of the joint angle limits at base and platform minus cosines of the angles."""
        at_home = neutral_directions(self.robot)
        least = np.cos(np.minimum(self.robot.joint_angle_limit, np.pi))
        parts = []
        for end, neutral in enumerate((np.broadcast_to(at_home, s.shape), at_home @ np.swapaxes(R, -1, -2))):
            cosine = np.sum(s * neutral, axis=-1)
            g = (neutral - cosine[..., None] * s) / L[..., None]
            turn = cross(q, g) + (cross(neutral, s) if end else 0.0)
            parts.append((least[:, end] - cosine + ROOM, -np.concatenate([g, turn], axis=-1)))
        return parts

    def _clearances(self, q: Array, S: Array) -> tuple[Array, Array]:
        """Compute the clearance minus the distances between legs, with derivatives at the nearest points."""
        apart = joined(self.robot) > _SAME * self.length
        i, j = _ONE[apart], _OTHER[apart]
        b, one, other = self.robot.b, S[:, i], S[:, j]
        x, y = nearest_shares(b[i] - b[j], one, other)
        between = b[i] - b[j] + x[..., None] * one - y[..., None] * other
        distance = np.linalg.norm(between, axis=-1)
        n = between / np.where(distance > 0.0, distance, 1.0)[..., None]
        shift = (x - y)[..., None] * n
        turn = x[..., None] * cross(q[:, i], n) - y[..., None] * cross(q[:, j], n)
        excess = (self.limits.min_clearance - distance) / self.length + ROOM
        return excess, -np.concatenate([shift, turn], axis=-1) / self.length
