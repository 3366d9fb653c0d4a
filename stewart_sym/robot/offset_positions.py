"""Where the joints of legs with offsets are, from the axes and the platform points.

Shapes: ``(...)`` is a leading shape of poses; a quantity of the legs is (..., 6, 3) as a vector and
(..., 6, 1) as a scalar.
"""

from dataclasses import dataclass

import numpy as np

from ..io.array_types import Array
from ..motion.rotation import cross as vector_product
from .offsets import JointOffsets

_MOST_STEPS = 60
# Share of the leg by which the end still moves when it is found.
_SETTLED = 8 * np.finfo(np.float64).eps


@dataclass(frozen=True, eq=False)
class Chains:
    """Where the joints of the legs are, base frame, from the base points, (..., 6, 3); lengths (..., 6, 1).

    y, s, z, o: axes of the lower part and outward normal; A: where o meets the moving axis; T: end of the
    sliding line; P: platform point; q: P from the reference point. spin: from y to the axis on the upper
    part. of_tip: distance of T along o. U: frame of the upper part. y_w, k_w: both axes of a universal
    platform joint, None with spherical ones.
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
    """Where the joints are, from their axes k and k_w on base and platform, q and P; NaN without a solution.

    All are in the base frame, k_w (..., 6, 3) zeros with spherical platform joints.
    """
    if not offsets.has_spinning_parts:
        return _lower(k, offsets, q, P, P)
    w = offsets.wrist_offset[:, None]
    T = P
    # Each step brings the end of the leg nearer by the wrist's share of the leg's length.
    for _ in range(_MOST_STEPS):
        at = _lower(k, offsets, q, P, T)
        y_w = vector_product(k_w, at.s)
        y_w = y_w / np.sqrt(dot(y_w, y_w))
        end = P - w * vector_product(y_w, k_w)
        step = np.abs(end - T).max(axis=-1, keepdims=True)
        moved = step > _SETTLED * np.abs(P).max(axis=-1, keepdims=True)
        if not moved.any():
            break
        T = end
    else:
        at = _lower(k, offsets, q, P, np.where(moved, np.nan, T))
    spin = np.arctan2(dot(at.z, y_w), dot(at.y, y_w))
    U = np.stack([at.s, y_w, vector_product(at.s, y_w)], axis=-1)
    return Chains(**{**vars(at), "spin": spin, "U": U, "y_w": y_w, "k_w": k_w})


def lengths_at_home(offsets: JointOffsets, k: Array, S: Array) -> Array:
    """Lengths along the line of sliding, m, (6,), from base to platform points by S, both frames parallel."""
    axes = k / np.linalg.norm(k, axis=-1, keepdims=True)
    with np.errstate(all="ignore"):
        return np.asarray(chains_to(offsets, axes, offsets.platform_axis, S, S).L[..., 0])


def _lower(k: Array, offsets: JointOffsets, q: Array, P: Array, T: Array) -> Chains:
    """The lower part from the end T of the line of sliding: of the solutions, o toward T and s outward."""
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
    """Scalar products of vectors (..., 3), kept as (..., 1)."""
    return np.asarray(np.sum(a * b, axis=-1, keepdims=True))
