"""Positions of the joints of legs with offsets, from the axes and the platform points.

``(...)`` is a leading shape of poses; vectors of the legs have the shape (..., 6, 3), scalars (..., 6, 1).
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..io.array_types import Array
from ..motion.rotation import cross as vector_product
from .offsets import JointOffsets

_MOST_STEPS, _MOST_HALVINGS = 60, 12
_LONGEST_STEP = 0.5
_TURNS = 0.25 * np.pi * np.array([0, 1, -1, 2, -2, 3, -3, 4])
# Errors of the right angle relative to the leg: at the end of Newton's method, and at most.
_SETTLED, _CLOSED = (share * np.finfo(np.float64).eps for share in (4, 256))


@dataclass(frozen=True, eq=False)
class _End:
    """End of the leg on the circle of the wrist: its chain, n, y_w, and s y_w."""

    at: "Chains"
    n: Array
    y_w: Array
    miss: Array


@dataclass(frozen=True, eq=False)
class Chains:
    """Positions of the joints relative to the base points (m), base frame, and directions of the axes.

    Vectors have the shape (..., 6, 3), lengths (m) have (..., 6, 1). y, s, z, o: axes of the lower part and
    outward normal. A: intersection of o and the moving axis. T: end of the sliding axis. P: platform point.
    q: P relative to the reference point. spin: angle from y to the axis on the upper part. of_tip: distance
    of T along o. U: frame of the upper part. y_w, k_w: both axes of a universal platform joint, None for
    spherical platform joints.
    """

    q: Array
    P: Array
    T: Array
    A: Array
    y: Array
    s: Array
    z: Array
    o: Array
    L: Array
    of_tip: Array
    spin: Array
    U: Array
    y_w: Array | None = None
    k_w: Array | None = None


def chains_to(offsets: JointOffsets, k: Array, k_w: Array, q: Array, P: Array) -> Chains:
    """Compute the joint positions from the axes k and k_w on base and platform, from q, and from P.

    All arguments are in the base frame; k_w (..., 6, 3) is zero for spherical platform joints. The result is
    NaN if there is no solution.
    """
    if not offsets.has_spinning_parts:
        return _lower(k, offsets, q, P, P)
    at, y_w = _to_wrist(offsets, k, k_w, q, P)
    spin = np.arctan2(dot(at.z, y_w), dot(at.y, y_w))
    U = np.stack([at.s, y_w, vector_product(at.s, y_w)], axis=-1)
    return Chains(**{**vars(at), "spin": spin, "U": U, "y_w": y_w, "k_w": k_w})


def _to_wrist(offsets: JointOffsets, k: Array, k_w: Array, q: Array, P: Array) -> tuple[Chains, Array]:
    """Solve for the lower part and the axis y_w of a universal platform joint; NaN without a solution.

    The end of the leg is on the circle T = P - wrist n, with n perpendicular to k_w and y_w = k_w x n.
    Newton's method solves s y_w = 0 for the angle of n.
    """
    w = offsets.wrist_offset[:, None]
    n_0 = P - dot(k_w, P) * k_w
    n_0 = n_0 / np.sqrt(dot(n_0, n_0))
    y_0 = vector_product(k_w, n_0)

    def end(angle: Array) -> _End:
        n = np.cos(angle) * n_0 + np.sin(angle) * y_0
        y_w = vector_product(k_w, n)
        at = _lower(k, offsets, q, P, P - w * n)
        return _End(at, n, y_w, dot(at.s, y_w))

    # The first start is the direction of the leg without the wrist; others follow by distance on the circle.
    s = _lower(k, offsets, q, P, P).s
    start = np.nan_to_num(np.arctan2(dot(s, y_0), dot(s, n_0)))
    reach = np.abs(P).max(axis=-1, keepdims=True)
    found, lost = start, np.isfinite(n_0[..., :1])
    for turn in _TURNS:
        found = np.where(lost, _right_angle(end, k, w, reach, start + turn), found)
        best = end(found)
        lost &= ~((np.abs(best.miss) * best.at.L <= _CLOSED * reach) & (dot(best.at.s, best.n) > 0.0))
        if not lost.any():
            break
    return _lower(k, offsets, q, P, np.where(lost, np.nan, best.at.T)), best.y_w


def _right_angle(end: Callable[[Array], _End], k: Array, w: Array, reach: Array, angle: Array) -> Array:
    """Find the angle of n at which s is perpendicular to y_w, by Newton's method with shortened steps."""
    now = end(angle)
    for _ in range(_MOST_STEPS):
        slope = dot(_rate_of_s(k, now.at, -w * now.y_w), now.y_w) - dot(now.at.s, now.n)
        step = np.clip(-now.miss / slope, -_LONGEST_STEP, _LONGEST_STEP)
        step = np.where(np.isfinite(step) & (np.abs(now.miss) * now.at.L > _SETTLED * reach), step, 0.0)
        for _ in range(_MOST_HALVINGS):
            worse = (step != 0.0) & ~(np.abs(end(angle + step).miss) < np.abs(now.miss))
            if not worse.any():
                break
            step = np.where(worse, 0.5 * step, step)
        else:
            step = np.where(worse, 0.0, step)
        if not step.any():
            break
        angle = angle + step
        now = end(angle)
    return angle


def _rate_of_s(k: Array, at: Chains, T_dot: Array) -> Array:
    """Return the rate of s if the end of the leg has the velocity T_dot (m/s)."""
    phi_dot = dot(at.y, T_dot) / at.of_tip
    theta_dot = -dot(at.z, T_dot - phi_dot * vector_product(np.broadcast_to(k, at.T.shape), at.T)) / at.L
    return phi_dot * vector_product(np.broadcast_to(k, at.s.shape), at.s) - theta_dot * at.z


def lengths_at_home(offsets: JointOffsets, k: Array, S: Array) -> Array:
    """Return lengths along the sliding axes (m), (6,), for vectors S from base to platform points."""
    axes = k / np.linalg.norm(k, axis=-1, keepdims=True)
    with np.errstate(all="ignore"):
        return np.asarray(chains_to(offsets, axes, offsets.platform_axis, S, S).L[..., 0])


def _lower(k: Array, offsets: JointOffsets, q: Array, P: Array, T: Array) -> Chains:
    """Solve for the lower part from the end T of the sliding axis, with o toward T and s outward."""
    k = np.broadcast_to(k, T.shape)
    a, d, e = (x[:, None] for x in (offsets.axis_offset, offsets.slide_offset_z, offsets.slide_offset_y))
    zeta, normal = dot(k, T), vector_product(k, T)
    rho2 = dot(normal, normal)
    of_tip = np.sqrt(rho2 - e * e)
    y = (of_tip * normal + e * (T - zeta * k)) / rho2
    o = vector_product(y, k)
    out = of_tip - a
    L = np.sqrt(out * out + zeta * zeta - d * d)
    beside = T - a * o - e * y
    s = (L * beside - d * vector_product(beside, y)) / (L * L + d * d)
    z = vector_product(s, y)
    U = np.stack([s, y, z], axis=-1)
    return Chains(q, P, T, a * o, y, s, z, o, L, of_tip, np.zeros_like(L), U)


def dot(a: Array, b: Array) -> Array:
    """Return scalar products of vectors (..., 3) with the shape (..., 1)."""
    return np.asarray(np.sum(a * b, axis=-1, keepdims=True))
