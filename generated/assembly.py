"""What every NumPy kernel shares: stacking components, assembling H x = c, solving it, status.

Written by stewart-sym 0.1.0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]

OK, NOT_FINITE, SHORT_LEG, POLE, SINGULAR = range(5)

# A length or sine below this many rounding units of its terms is rounding error and nothing else.
ROUNDING = 16 * np.finfo(np.float64).eps
# Sine of the angle between a leg and the fixed axis below which rounding decides where the leg's second axis
# points: the pole of the universal joint.
POLE_SINE = 4096 * np.finfo(np.float64).eps
# Pivot below which H, its moments over a length, may be singular to rounding.
SUSPECT = np.sqrt(np.sqrt(np.finfo(np.float64).eps))
# Below this share of the vectors that it is the sum of, a leg may make H singular while the pivots are large.
SHORT_SHARE = 64 * np.sqrt(np.finfo(np.float64).eps)
# A leg shorter than this has a square that is not held to all its digits.
SHORTEST = np.sqrt(1 / np.finfo(np.float64).max / np.finfo(np.float64).eps)


def stack(shape: tuple[int, ...], *components: Any) -> Array:
    """Components side by side in a new last axis."""
    return np.stack([np.broadcast_to(component, shape) for component in components], axis=-1)


def solve(robot: Any, motion: Any, leg: dict[str, Array], platform: dict[str, Array]) -> dict[str, Array]:
    """H x = c and F = D - x, (35)-(37); poses with a status other than 0 are NaN."""
    H = np.concatenate([leg["H_force"], leg["H_moment"]], axis=-1).swapaxes(-1, -2)
    c = np.concatenate([platform["c_force"], platform["c_moment"]], axis=-1)
    of_legs = np.concatenate([leg["c_force"], leg["c_moment"]], axis=-1)
    for i in range(6):
        c = c + of_legs[..., i, :]
    q = leg["q"]
    x, suspect = eliminate(*over_length(np.abs(q).max(axis=(-1, -2)), H, c))
    F = leg["D"] - x
    reach = np.abs(np.broadcast_arrays(q, motion.t[..., None, :], robot.b)).max(axis=(0, -1))
    status = singular_status(H, suspect, leg["L"], reach, q)
    status = np.where(np.isfinite(F).all(axis=-1) | (status != OK), status, NOT_FINITE)
    fault = leg_status(robot, motion, leg)
    status = np.where(fault == OK, status, fault).astype(np.int32)
    found = {"F": F, "D": leg["D"], "x": x, "K": leg["K"], "H": H, "c": c}
    return {**{name: only_good(value, status) for name, value in found.items()}, "status": status}


def only_good(values: Array, status: Array) -> Array:
    """``values`` (..., more axes) with NaN where ``status`` (...) is not 0."""
    return np.where((status == OK)[(..., *(None,) * (values.ndim - status.ndim))], values, np.nan)


def eliminate(H: Array, c: Array) -> tuple[Array, Array]:
    """x (..., 6) of H x = c by elimination with partial pivoting, and whether a pivot is small (...)."""
    A = np.concatenate([H, c[..., None]], axis=-1)
    suspect = np.zeros(H.shape[:-2], dtype=bool)
    for k in range(6):
        pivot = k + np.argmax(np.abs(A[..., k:, k]), axis=-1)[..., None]
        order = np.broadcast_to(np.arange(6), (*suspect.shape, 6)).copy()
        np.put_along_axis(order, pivot, k, axis=-1)
        order[..., k] = pivot[..., 0]
        A = np.take_along_axis(A, order[..., None], axis=-2)
        suspect |= ~(np.abs(A[..., k, k]) > SUSPECT)
        factor = A[..., k + 1 :, k] * (1 / A[..., k, k])[..., None]
        A[..., k + 1 :, k + 1 :] -= factor[..., None] * A[..., k, None, k + 1 :]
    x = np.empty_like(c)
    for i in range(5, -1, -1):
        total = A[..., i, 6]
        for j in range(i + 1, 6):
            total = total - A[..., i, j] * x[..., j]
        x[..., i] = total * (1 / A[..., i, i])
    return x, suspect


def per_length(size: Any) -> Any:
    """What moments are multiplied by in the solve, 1/m; ``size``: m, largest coordinate of their arms.

    1 for sizes of about a metre, else one over the least power of two, 2^-100 to 2^100, that is as large.
    """
    fraction, exponent = np.frexp(size)
    power = np.ldexp(1.0, np.clip((fraction == 0.5) - exponent, -100, 100))
    return np.where((size >= 0.0625) & (size <= 16.0) | (size == 0.0), 1.0, power)


def over_length(size: Any, H: Array, right: Array) -> tuple[Array, Array]:
    """H (..., 6, 6) and right (..., 6) or (..., 6, n), moments over a length that suits ``size``: pivots are
    chosen among forces and moments.
    """
    factor = np.where(np.arange(6) < 3, 1.0, np.asarray(per_length(size))[..., None])
    return H * factor[..., None], right * (factor if right.ndim < H.ndim else factor[..., None])


def eliminate_many(H: Array, right: Array) -> tuple[Array, Array]:
    """X (..., 6, n) of H X = right, column by column, and whether a pivot is small (...)."""
    solved = [eliminate(H, right[..., j]) for j in range(right.shape[-1])]
    return np.stack([x for x, _ in solved], axis=-1), solved[0][1]


def singular_status(H: Array, suspect: Array, L: Array, reach: Array, arm: Array) -> Array:
    """OK, SINGULAR or NOT_FINITE of every pose: whether H (..., 6, 6) is singular to rounding.

    suspect: whether a pivot is small (...). L, reach (..., 6): length of each leg, size of the vectors that
    it is the sum of; arm (..., 6, 3): of its moment. As ``singular_status`` of the C, where the bound is
    explained.
    """
    size = np.abs(arm).max(axis=(-1, -2))
    close = suspect | (L <= SHORT_SHARE * reach).any(axis=-1)
    status = np.zeros(suspect.shape, dtype=np.int32)
    if close.any():
        status[close] = _status_of_close(H[close], L[close], reach[close], arm[close], size[close, None])
    return status


def _status_of_close(H: Array, L: Array, reach: Array, arm: Array, size: Array) -> Array:
    scaled = H / np.where(np.arange(6) < 3, 1.0, size)[..., None]
    Y, _ = eliminate_many(scaled, np.broadcast_to(np.eye(6), H.shape))
    turned = Y[..., None, :3] + np.cross(Y[..., None, 3:], (arm / size[..., None])[..., None, :, :])
    G = np.abs(turned).sum(axis=-1) * (reach / L + 2)[..., None, :]
    G = (G + 2 * np.abs(Y[..., 3:]).sum(axis=-1)[..., None]) * 4 * np.finfo(np.float64).eps
    v, worst = np.ones(L.shape), np.full(L.shape[:-1], np.inf)
    for _ in range(4):
        grown = (G * v[..., None, :]).sum(axis=-1)
        worst = np.minimum(worst, (grown / v).max(axis=-1))
        v = np.maximum(grown / grown.max(axis=-1, keepdims=True), np.finfo(np.float64).eps)
    status = np.where(worst <= 0.5, OK, SINGULAR)
    return np.where(np.isfinite(H).all(axis=(-1, -2)), status, NOT_FINITE)


def leg_status(robot: Any, motion: Any, leg: dict[str, Array]) -> Array:
    """The first leg's fault of each pose: not finite, too short, along its universal axis.

    S = q + t - b is known to within rounding of its largest term.
    """
    terms = np.broadcast_arrays(leg["q"], motion.t[..., None, :], robot.b)
    L, reach = leg["L"], np.abs(terms).max(axis=(0, -1))
    clear = leg["k3"] > POLE_SINE if "k3" in leg else np.full(L.shape, True)
    fault = np.where(clear, 0, POLE)
    fault = np.where(L > np.maximum(ROUNDING * reach, SHORTEST), fault, SHORT_LEG)
    fault = np.where(np.isfinite(L), fault, NOT_FINITE)
    first = np.argmax(fault != OK, axis=-1)
    return np.take_along_axis(fault, first[..., None], axis=-1)[..., 0]
