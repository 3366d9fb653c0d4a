"""What a pose costs a path: its condition number and how far it breaks limits, with derivatives by the pose.

Derivatives are by twists: the position moves by dt, base frame, and R becomes exp([dphi]x) R.
"""

import math
from dataclasses import dataclass, field

import numpy as np

from ..design.pose_limits import PoseLimits
from ..io.array_types import Array
from ..io.frozen import Frozen
from ..kinematics.clearance import PAIRS, joined, nearest_shares, neutral_directions
from ..kinematics.conditioning import characteristic_length
from ..kinematics.inverse_kinematics import leg_vectors
from ..motion.rotation import cross
from ..robot.robot import Robot

_ONE, _OTHER = np.array(PAIRS).T
# Distance that a path keeps from its limits at the samples, over the characteristic length or as a cosine.
ROOM = 2e-3
_SAME = 1e-6
# Least sine of the angle between a leg and the fixed axis of its universal joint: forces grow as its inverse.
_LEAST_SINE = 0.05


@dataclass(frozen=True, eq=False)
class PoseCosts(Frozen):
    """Costs of poses of one machine.

    side: sign of det H that a path keeps. least: smallest singular value below which the condition number is
    replaced by its tangent, so that it goes on rising through singular poses.
    """

    robot: Robot
    limits: PoseLimits
    tool: Array
    side: float
    least: float
    length: float = field(init=False)

    def __post_init__(self) -> None:
        self._set({"length": characteristic_length(self.robot) or 1.0, "tool": np.array(self.tool)})

    def conditions(self, R: Array, t: Array) -> tuple[Array, Array]:
        """Condition numbers of H about the reference point, (n,), with derivatives, (n, 6)."""
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
        # Turned about the tool, the reference point moves by -dphi x arm.
        rate[:, 3:] -= cross(R @ self.tool, rate[:, :3])
        return largest * inverse, rate

    def plain_conditions(self, R: Array, t: Array) -> tuple[Array, Array, Array]:
        """Condition numbers, signs of det H and smallest singular values, (n,)."""
        H = self._matrices(R, t)[-1]
        values = np.linalg.svd(H, compute_uv=False)
        with np.errstate(divide="ignore"):
            conditions: Array = values[:, 0] / values[:, -1]
        return conditions, np.sign(np.linalg.det(H)), np.asarray(values[:, -1], dtype=np.float64)

    def _matrices(self, R: Array, t: Array) -> tuple[Array, Array, Array, Array]:
        """q, s, L and H, about the reference point, its moments over the characteristic length, (n, 6, 6)."""
        q, S, L = leg_vectors(self.robot, R, t - R @ self.tool)
        s = S / L[..., None]
        return q, s, L, np.swapaxes(np.concatenate([s, cross(q, s) / self.length], axis=-1), -1, -2)

    def _rate(self, q: Array, s: Array, L: Array, u: Array, v: Array) -> Array:
        """Derivative of u^T H v by the twist of the reference point, (n, 6)."""
        force, moment = u[:, None, :3], u[:, None, 3:] / self.length
        along = v[:, :, None] * (force + cross(moment, q))
        g = (along - np.sum(along * s, axis=-1, keepdims=True) * s) / L[..., None]
        turn = cross(q, g + v[:, :, None] * cross(s, moment))
        return np.asarray(np.concatenate([g, turn], axis=-1).sum(axis=1))

    def excesses(
        self, R: Array, t: Array, known: tuple[Array, Array] | None = None
    ) -> list[tuple[str, Array, Array]]:
        """By limit: its name, by how much each pose breaks it, (n, k), and derivatives, (n, k, 6).

        known: what ``conditions`` found of these poses.
        """
        # Points from the tool, about which the pose turns.
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
        if self.limits.clearance > 0.0:
            found.append(("leg clearance", *self._clearances(q, S)))
        if self.limits.condition < math.inf:
            value, rate = self.conditions(R, t) if known is None else known
            most = self.limits.condition
            found.append(("condition number", (value / most - 1.0 + ROOM)[:, None], rate[:, None] / most))
        return found

    def _lengths(self, q: Array, s: Array, L: Array) -> list[tuple[Array, Array]]:
        rate = np.concatenate([s, cross(q, s)], axis=-1) / self.length
        low, high = self.robot.length_limits.T
        parts = []
        if np.isfinite(high).any():
            parts.append(((L - high) / self.length + ROOM, rate))
        if (low > 0.0).any():
            parts.append(((low - L) / self.length + ROOM, -rate))
        return parts

    def _axes(self, q: Array, s: Array, L: Array) -> tuple[Array, Array]:
        """Cosines between legs and the fixed axes of their universal joints, less the largest allowed."""
        cosine = np.sum(s * self.robot.k, axis=-1)
        g = np.sign(cosine)[..., None] * (self.robot.k - cosine[..., None] * s) / L[..., None]
        excess = np.abs(cosine) - math.sqrt(1.0 - _LEAST_SINE**2) + ROOM
        return excess, np.concatenate([g, cross(q, g)], axis=-1)

    def _angles(self, R: Array, q: Array, s: Array, L: Array) -> list[tuple[Array, Array]]:
        """At the base and at the platform: cosine of the limit less that of the angle."""
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
        """Least distances of legs less the clearance, by shares of the two legs at which they are nearest."""
        apart = joined(self.robot) > _SAME * self.length
        i, j = _ONE[apart], _OTHER[apart]
        b, one, other = self.robot.b, S[:, i], S[:, j]
        x, y = nearest_shares(b[i] - b[j], one, other)
        between = b[i] - b[j] + x[..., None] * one - y[..., None] * other
        distance = np.linalg.norm(between, axis=-1)
        n = between / np.where(distance > 0.0, distance, 1.0)[..., None]
        shift = (x - y)[..., None] * n
        turn = x[..., None] * cross(q[:, i], n) - y[..., None] * cross(q[:, j], n)
        excess = (self.limits.clearance - distance) / self.length + ROOM
        return excess, -np.concatenate([shift, turn], axis=-1) / self.length
