"""Proof, by Kantorovich's theorem, that a pose near a computed pose has exactly the given leg lengths.

Let z = (dt, l dphi), R = exp([dphi]x) R_0, and g_i(z) = (|S_i|^2 - L_i^2) / 2. Let A be an approximate
inverse of the derivative of g at the pose. The map z - A g(z) takes the ball |z| <= r into itself and
contracts it if

    Y + Z r + Z_2 r^2 / 2 <= r,    Z + Z_2 r < 1,

with Y >= |A g(0)|, Z >= |E - A g'(0)|, and |A g''(z) d d| <= Z_2 |d|^2 in the ball. Then exactly one pose in
the ball has these lengths. The first derivative |d/dtau exp([phi + tau d]x) q| is at most |d| |q|, and the
second derivative is at most |d|^2 |q|. They bound the second derivative of g:
|g_i''| <= 1 + (|q_i|/l)^2 + |S_i| |q_i|/l^2.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..io.arguments import instance, leading_shape
from ..io.array_types import Array, Flags
from ..motion.motion import pose_of
from ..robot.robot import Robot
from .conditioning import characteristic_length
from .forward_kinematics import checked_lengths
from .inverse_kinematics import leg_vectors
from .pose_search import rates_per_twist

Rationals = NDArray[np.object_]
"""Arrays of ``Fraction`` objects, with which NumPy computes exactly."""


@dataclass(frozen=True, eq=False)
class PoseCertificate:
    """Proven bounds of poses.

    The leading shape ``(...)`` is the common shape of the poses and lengths. All bounds are NaN without a
    proof.

    Attributes
    ----------
    proven : ndarray of bool, shape (...)
        True if a pose with exactly these lengths exists within the bounds.
    position_bound : ndarray, shape (...)
        Upper bound of the distance of this pose from the given t (m).
    angle_bound : ndarray, shape (...)
        Upper bound of the rotation angle of this pose from the given R (rad), in addition to the deviation of
        R from a rotation matrix.
    uniqueness_radius : ndarray, shape (...)
        Radius within which no other pose has these lengths. The distance is the root of the sum of squares of
        the position difference, divided by ``characteristic_length``, and the angle (rad).
    """

    proven: Flags
    position_bound: Array
    angle_bound: Array
    uniqueness_radius: Array


def certify_pose(robot: Robot, L: ArrayLike, pose: tuple[ArrayLike, ArrayLike]) -> PoseCertificate:
    """Prove, if possible, that a pose with exactly the given leg lengths exists near a computed pose.

    Parameters
    ----------
    robot : Robot
        Robot geometry without joint offsets.
    L : array_like, shape (..., 6)
        Leg lengths (m).
    pose : tuple of array_like
        Computed pose (R, t) with shapes (..., 3, 3) and (..., 3), for example from ``forward_kinematics``. A
        pose of NaN gives no proof.

    Returns
    -------
    PoseCertificate
        Result of the proof and bounds of position (m) and angle (rad).

    Raises
    ------
    ValueError
        If lengths are not finite and positive, or if ``pose`` is not a pose.

    See Also
    --------
    forward_kinematics : Compute poses from leg lengths.

    Notes
    -----
    The proof uses Kantorovich's theorem and exact rational arithmetic. Without a proof, the existence of the
    pose is open. Near a singular pose, at which two poses meet, no proof is possible.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> L = [1.109, 1.005, 1.034, 1.122, 1.031, 0.973]
    >>> pose = ss.forward_kinematics(robot, L)
    >>> certificate = ss.certify_pose(robot, L, pose=(pose.R, pose.t))
    >>> bool(certificate.proven), bool(certificate.position_bound < 1e-12)
    (True, True)
    """
    instance(robot, Robot, "robot")
    lengths = checked_lengths(L)
    R, t = _pose(pose)
    shape = leading_shape({"L": lengths.shape[:-1], "pose": t.shape[:-1]})
    results = np.full((4, *shape), np.nan)
    lengths = np.broadcast_to(lengths, (*shape, 6))
    R, t = np.broadcast_to(R, (*shape, 3, 3)), np.broadcast_to(t, (*shape, 3))
    for where in np.ndindex(shape):
        found = None if np.isnan(t[where]).any() else _prove(robot, lengths[where], R[where], t[where])
        results[(0, *where)] = found is not None
        if found is not None:
            results[(slice(1, None), *where)] = found
    return PoseCertificate(results[0] == 1.0, results[1], results[2], results[3])


def _pose(pose: object) -> tuple[Array, Array]:
    if not isinstance(pose, tuple | list) or len(pose) != 2:
        raise ValueError(f"pose: expected a pose (R, t), got {type(pose).__name__}")
    R, t = (np.array(part, dtype=np.float64) for part in pose)
    if R.shape[-2:] != (3, 3) or t.shape[-1:] != (3,):
        raise ValueError(f"pose: expected shapes (..., 3, 3) and (..., 3), got {R.shape} and {t.shape}")
    shape = leading_shape({"R": R.shape[:-2], "t": t.shape[:-1]})
    R, t = np.broadcast_to(R, (*shape, 3, 3)), np.broadcast_to(t, (*shape, 3))
    none = np.asarray(np.isnan(t).any(axis=-1) | np.isnan(R).any(axis=(-2, -1)))[..., None]
    pose_of((np.where(none[..., None], np.eye(3), R), np.where(none, 0.0, t)), "pose", "a pose (R, t)")
    return R, np.where(none, np.nan, t)


def _prove(robot: Robot, L: Array, R: Array, t: Array) -> tuple[float, float, float] | None:
    """Return the bounds of position and angle and the uniqueness radius of one pose; None without a proof."""
    length = Fraction(characteristic_length(robot) or 1.0)
    A = _about_inverse(robot, R, t, float(length))
    if A is None:
        return None
    legs = _Legs.of(robot, L, R, t, length)
    # The proof is valid for any A for which the inequalities below are satisfied.
    Y = _norm(A @ legs.g) + _largest(A, legs.g_off)
    Z = _norm((_rationals(np.eye(6)) - A @ legs.rows).ravel()) + _largest(A, legs.rows_off)
    if Z >= 1:
        return None

    def holds(radius: Fraction, within: Fraction) -> bool:
        """Return True if the theorem applies for a radius; derivatives are bounded in ball ``within``."""
        arm = legs.q / length
        # |S| grows by at most sqrt(1 + (|q|/l)^2) r <= (1 + |q|/l) r.
        second = 1 + arm * arm + (legs.S + (1 + arm) * within) * legs.q / length**2
        bound = _largest(A, second)
        return bool(Y + Z * radius + bound * radius * radius / 2 <= radius and Z + bound * radius < 1)

    # Second derivatives are bounded in the smallest ball for which the proof can succeed.
    ball = max(4 * Y / (1 - Z), length * Fraction(1, 2**60))
    if not holds(ball, ball):
        return None
    r = max(Fraction(_above(float(2 * Y / (1 - Z)))), Fraction(1, 2**1000))
    proven = r if r <= ball and holds(r, ball) else ball
    # The largest of proven, 2 proven, 4 proven, ... whose ball contains only one pose.
    alone = proven
    while alone < length and holds(2 * alone, 2 * alone):
        alone = 2 * alone
    return (
        _above(float(proven)),
        _above(float(proven / length)),
        max(0.0, math.nextafter(float(alone / length), 0.0)),
    )


class _Legs(NamedTuple):
    """Legs at the pose; exact except for the deviation of R from a rotation, which ``_off`` bounds contain.

    g: (|S|^2 - L^2) / 2, shape (6,). rows: derivative of g by (dt, l dphi), shape (6, 6). q, S: bounds of
    their lengths, shape (6,).
    """

    g: Rationals
    g_off: Rationals
    rows: Rationals
    rows_off: Rationals
    q: Rationals
    S: Rationals

    @classmethod
    def of(cls, robot: Robot, L: Array, R: Array, t: Array, length: Fraction) -> _Legs:
        turn, p = _rationals(R), _rationals(robot.p)
        q = p @ turn.T
        S = q + _rationals(t) - _rationals(robot.b)
        # A rotation exists within |R^T R - E| of R (Frobenius), so the error of q is at most this times |p|.
        off = _norm((turn.T @ turn - _rationals(np.eye(3))).ravel()) * _norms(p)
        size_q, size_S = _norms(q) + off, _norms(S) + off
        return cls(
            g=((S * S).sum(axis=-1) - _rationals(L) ** 2) / 2,
            g_off=off * size_S + off * off / 2,
            rows=np.hstack([S, np.cross(q, S) / length]),
            rows_off=off * (1 + (size_q + size_S) / length),
            q=size_q,
            S=size_S,
        )


def _about_inverse(robot: Robot, R: Array, t: Array, length: float) -> Rationals | None:
    """Return an approximate inverse of g' at the pose; None if g' is singular."""
    with np.errstate(all="ignore"):
        L = leg_vectors(robot, R, t)[2]
        G = rates_per_twist(robot, R, t) * L[:, None] / np.repeat([1.0, length], 3)
        try:
            A = np.linalg.inv(G)
        except np.linalg.LinAlgError:
            return None
    return _rationals(A) if np.isfinite(A).all() else None


def _rationals(values: Array) -> Rationals:
    found: Rationals = np.vectorize(Fraction, otypes=[object])(values)
    return found


def _largest(A: Rationals, off: Rationals) -> Fraction:
    """Return an upper bound of |A x| for all x with components of at most ``off``."""
    return _norm(abs(A) @ off)


def _norms(vectors: Rationals) -> Rationals:
    return np.array([_norm(vector) for vector in vectors], dtype=object)


def _norm(values: Rationals) -> Fraction:
    """Return an upper bound of the Euclidean norm, at most 2^-100 above it."""
    square: Fraction = values @ values
    return Fraction(math.isqrt(math.ceil(square * 4**100)) + (square > 0), 2**100)


def _above(value: float) -> float:
    return math.nextafter(value, math.inf)
